//! Values that others printed: a benchmark of forced vibration, and a frame of a textbook.

use crate::models::assert_close;
use core::f64::consts::TAU;
use mstmm::Complex;
use mstmm::prelude::*;

system! {
    /// The deep beam of NAFEMS R0016, Selected Benchmarks for Forced Vibration, test 5: 10 m long, 2 m by 2 m, of steel, supported at both ends.
    struct DeepBeam {}
    section steel {
        length: 5.0, bending_stiffness: 2e11 * 4.0 / 3.0, mass_per_length: 8000.0 * 4.0, rotary_inertia: 8000.0 * 4.0 / 3.0,
        shear_stiffness: 2e11 / 2.6 * 4.0 * 5.0 / 6.0
    }
    pinned -> beam 1 { ..steel } -> conn middle -> beam 2 { ..steel } -> pinned;
}

/// The load on both halves [N/m], the half height over the moment of area [1/m³], and the damping of each mode.
const LOAD: f64 = 1e6;
const STRESS: f64 = 0.75;
const RATIO: f64 = 0.02;

/// Tests 5H, 5T and 5R: harmonic, a step, a power spectrum of 1 (MN/m)²/Hz, all with 2 % in 16 modes. The printed values are those of one mode in closed form, so that displacements
/// are less than 1 % from these, and stresses, to which other modes add, some per cent.
#[test]
fn the_deep_beam_answers_as_the_benchmark_says() {
    let beam = DeepBeam {}.build().unwrap();
    let roots = beam.first_frequencies::<16>().unwrap();
    assert_close(roots[0].hertz(), 42.65, 1e-3);
    let of = |entry| {
        [DeepBeam::beam_1.uniform_load(), DeepBeam::beam_2.uniform_load()].map(|load| {
            let response = beam.modal_response::<16, _>(&roots, load, entry).unwrap();
            response.with_damping_ratio(RATIO).unwrap()
        })
    };
    let (deflection, moment) = (of(DeepBeam::conn_middle.deflection()), of(DeepBeam::beam_1.output().moment()));
    // the largest amplitudes near the first frequency
    let hertz = |share: f64| Complex::new(0.0, TAU * 42.0 + TAU * 1.2 * share);
    let peak = |response: &dyn Fn(Complex<f64>) -> Complex<f64>| {
        let amplitudes = (0..2000).map(|k| hertz(f64::from(k) / 2000.0)).map(|x| (response(x).norm(), x));
        let (largest, at) = amplitudes.max_by(|one, other| one.0.total_cmp(&other.0)).unwrap();
        (LOAD * largest, at.im / TAU)
    };
    let (amplitude, at) = peak(&|x| deflection.iter().map(|response| response.at(x).unwrap()).sum());
    let (stress, _) = peak(&|x| moment.iter().map(|response| response.at(x).unwrap()).sum());
    assert_close(amplitude, 13.45e-3, 6e-3);
    assert_close(stress * STRESS, 241.9e6, 0.03);
    assert_close(at, 42.65, 2e-3);
    // the power of the response at its peak, in mm²/Hz and (N/mm²)²/Hz
    assert_close((1e3 * amplitude).powi(2), 180.90, 0.012);
    assert_close((1e-6 * stress * STRESS).powi(2), 58_516.0, 0.06);

    // after a step
    let times = (0..400).map(|k| 5e-5 * f64::from(k));
    let sum = |responses: &[f64]| LOAD * responses.iter().sum::<f64>();
    let after = times.clone().map(|time| (sum(&deflection.map(|response| response.to_step(time))), time));
    let (deflected, time) = after.max_by(|one, other| one.0.total_cmp(&other.0)).unwrap();
    let bent = times.map(|time| sum(&moment.map(|response| response.to_step(time))).abs()).fold(0.0, f64::max);
    let at_rest = LOAD * deflection.iter().map(|response| response.static_value().unwrap()).sum::<f64>();
    assert_close(deflected, 1.043e-3, 0.01);
    assert_close(time, 0.0117, 0.01);
    assert_close(bent * STRESS, 18.76e6, 0.05);
    assert_close(at_rest, 0.538e-3, 3e-3);
}

system! {
    /// The two storeys of Chopra, Dynamics of Structures, example 10.4: masses 2m and m, storeys of the stiffnesses 2k and k.
    struct Chopra { m: f64, k: f64 }
    fixed -> spring 1 { stiffness: 2.0 * k } -> mass 2 { mass: 2.0 * m } -> spring 3 { stiffness: k } -> mass 4 { mass: m } -> free;
}

/// `ω² = k/2m` and `2k/m`; effective masses 8m/3 and m/3.
#[test]
fn two_storeys_are_those_of_the_textbook() {
    let (m, k) = (1.5, 800.0);
    let house = Chopra { m, k }.build().unwrap();
    let roots = house.first_frequencies::<2>().unwrap();
    let participation = house.participation::<2, _>(&roots, Direction::y()).unwrap();
    for (mode, (square, mass)) in [(k / (2.0 * m), 8.0 * m / 3.0), (2.0 * k / m, m / 3.0)].into_iter().enumerate() {
        assert_close(roots[mode].omega, square.sqrt(), 1e-15);
        assert_close(participation.effective_mass(mode), mass, 1e-14);
    }
}
