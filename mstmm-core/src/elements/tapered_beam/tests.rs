//! The tapered beam: parts, states inside, derivatives of its work.

use super::inside::Inside;
use super::part::is_short;
use super::walk::Places;
use super::*;
use crate::element::{BackTransfer, Charted, Energies};
use crate::model::{Ends, State};
use crate::number::{DoubleDouble, Oscillation, Scalar, assert_close};
use crate::structure::Chart;
use crate::subspace::{Connecting, WittrickWilliams};
use num_complex::Complex;
use std::vec::Vec;

const BLADE: TaperedBeam<f64> = TaperedBeam {
    length: 1.3,
    bending_stiffness: 2.0,
    mass_per_length: 0.7,
    width_taper: 0.3,
    height_taper: 0.6,
    rotary_inertia: 0.01,
    axial_force: 0.8,
    axial_load: -0.9,
    rotation_speed: 1.7,
    hub_radius: 0.4,
    setting_angle: 0.9,
    foundation_stiffness: 1.1,
};

/// States at both ends of a beam at a frequency, which belong together by its matrix.
fn ends<T: crate::number::Real, S: Oscillation<T>>(built: &BuiltTaperedBeam<T>, x: S) -> Ends<S> {
    let input = [0.7, -0.4, 0.9, 1.3].map(S::from_f64);
    let u = TaperedBeam::transfer_matrix(built, x);
    let [y, theta, m, q] =
        core::array::from_fn(|row| (0..4).fold(S::zero(), |sum, column| sum + u[(row, column)] * input[column]));
    let [a, b, c, d] = input;
    Ends { x, input: State { y: a, theta: b, m: c, q: d }, output: State { y, theta, m, q } }
}

/// Parts fill the beam, sums are exact, and each is short; there are some two or three of them for a half wave.
#[test]
fn parts_fill_the_beam() {
    for square in [0.0, 1.0, 1e4, 1e8] {
        let profile = Profile::of(TaperedBeam { rotary_inertia: 0.0, ..BLADE }, square, false);
        let mut end = 0.0;
        let mut count = 0;
        for place in Places::new(profile, 0.0, 1.0) {
            let [start, width] = place.unwrap();
            assert_eq!(start, end);
            assert!(is_short(&profile, start, width));
            (end, count) = (start + width, count + 1);
        }
        assert_eq!(end, 1.0);
        assert!(f64::from(count) < 4.0 + profile.phase(), "{count} parts of phase {}", profile.phase());
    }
}

/// The frequencies with both ends held are the roots of the minor of clamped ends, and a chart of displacements counts them.
#[test]
fn a_chart_counts_the_frequencies_between_held_ends() {
    for beam in [BLADE, TaperedBeam { height_taper: -2.0, axial_force: -0.5, ..BLADE }] {
        let built = beam.build().unwrap();
        let clamped = |omega: f64| {
            let u = TaperedBeam::transfer_matrix(&built, omega);
            (u[(0, 2)] * u[(1, 3)] - u[(0, 3)] * u[(1, 2)]).is_sign_negative()
        };
        let (mut roots, mut before) = (0.0, clamped(0.0));
        for step in 1..=2_000 {
            let omega = 0.1 * f64::from(step);
            let now = clamped(omega);
            roots += f64::from(u8::from(now != before));
            before = now;
            if step % 97 == 0 {
                let at = FrequencyPowers::new::<f64>(omega, true);
                let mut chart: Chart<f64> = TaperedBeam::chart(&built, &at, beam.length);
                for variable in 0..4 {
                    if chart.is_force(variable) {
                        chart.flip(variable);
                    }
                }
                assert_eq!(chart.below, roots, "{omega}");
            }
        }
        assert!(roots > 3.0, "{roots}");
    }
}

/// Half the length with the section there: parameters of the outer half of a beam, and of the inner.
fn halves(beam: TaperedBeam<f64>) -> [TaperedBeam<f64>; 2] {
    let profile = Profile::of(beam, 0.0, false);
    let [b, h] = [profile.width.at(0.5), profile.height.at(0.5)];
    let length = 0.5 * beam.length;
    let first = TaperedBeam {
        length,
        width_taper: 0.5 * beam.width_taper,
        height_taper: 0.5 * beam.height_taper,
        axial_force: profile.force_at(0.5),
        ..beam
    };
    let second = TaperedBeam {
        length,
        bending_stiffness: profile.stiffness_at(0.5),
        mass_per_length: profile.mass_at(0.5),
        rotary_inertia: profile.rotary_at(0.5),
        width_taper: 0.5 * beam.width_taper / b,
        height_taper: 0.5 * beam.height_taper / h,
        hub_radius: beam.hub_radius + length,
        ..beam
    };
    [first, second]
}

/// The motion inside of a beam in which waves grow by up to e²⁰⁰ is that at the end of its half.
#[test]
fn states_inside_are_those_between_two_halves() {
    let [first, second] = halves(BLADE).map(|half| half.build().unwrap());
    let whole = BLADE.build().unwrap();
    for omega in [0.0, 3.0, 200.0, 4e4] {
        // a motion that is held at both ends, of a load in the middle: it decays towards the ends as fast as waves do
        let at = FrequencyPowers::new(omega, false);
        let input = Subspace::Tip(Support::Fixed, mstmm_plan::Space::Bending);
        let step = |beam: &BuiltTaperedBeam<f64>, input| {
            let beam: Tapered<f64> = TaperedBeam::coefficients(beam, &at);
            beam.through(Subspace::plane(input), &mut crate::subspace::NoCount)
        };
        let middle = step(&first, input);
        let output = step(&second, Subspace::Plane(middle));
        // a state of the plane at the output end, and what covectors of the halves make of it
        let covector = crate::subspace::Covector::Plane([0.3, -0.2, 0.5, 0.1], 0);
        let back = |beam: &BuiltTaperedBeam<f64>, covector| {
            let back: Tapered<f64> = <TaperedBeam<f64> as BackTransfer<f64>>::back_coefficients(beam, &at);
            TaperedBeam::<f64>::back_transfer(&back, &input, covector)
        };
        let between = back(&second, covector);
        let start = back(&first, between);
        let scaled = |covector: crate::subspace::Covector<f64>, plane: &crate::subspace::Plane<f64>, by: i32| {
            covector.pick(&Subspace::Plane(*plane)).shifted(by)
        };
        let end = covector.pick(&Subspace::Plane(output));
        let shift = end.exponent;
        let [after, inside] = [scaled(covector, &output, shift), scaled(between, &middle, shift)];
        let before = scaled(start, &input.plane(), shift);
        let found: State<f64> = <TaperedBeam<f64> as Energies<f64>>::state_at(
            &whole,
            &Ends { x: omega, input: before, output: after },
            0.65,
        );
        let wave = <TaperedBeam<f64> as Energies<f64>>::inside(&whole, omega).unwrap().wave_number.max(1.0);
        let size = |state: &State<f64>| {
            let deflections = state.y.abs() + state.theta.abs() / wave;
            deflections + state.m.abs() / (wave * wave) + state.q.abs() / (wave * wave * wave)
        };
        let difference = found.plus(inside, -1.0);
        let scale = size(&before).max(size(&after)).max(size(&inside));
        assert!(size(&difference) < 1e-11 * scale, "{omega}: {found:?} instead of {inside:?}, beside {scale}");
    }
}

/// Differences of the dynamic work in 32 digits, at held displacements of the ends, of each parameter.
#[test]
fn gradients_are_differences_of_the_work() {
    type D = DoubleDouble;
    let wide = D::from_f64;
    let omega = 5.0;
    let start = ends(&BLADE.build().unwrap(), omega);
    // twice the work of ends that move so: M Θ - Q Y, by the stiffness that the matrix is
    let work = |beam: TaperedBeam<D>| {
        let u = TaperedBeam::transfer_matrix(&beam.build().unwrap(), wide(omega));
        let [y, theta] = [start.input.y, start.input.theta].map(wide);
        let [end_y, end_theta] = [start.output.y, start.output.theta].map(wide);
        let right = [end_y - u[(0, 0)] * y - u[(0, 1)] * theta, end_theta - u[(1, 0)] * y - u[(1, 1)] * theta];
        let det = u[(0, 2)] * u[(1, 3)] - u[(0, 3)] * u[(1, 2)];
        let m = (right[0] * u[(1, 3)] - right[1] * u[(0, 3)]) / det;
        let q = (u[(0, 2)] * right[1] - u[(1, 2)] * right[0]) / det;
        let behind = |row: usize| u[(row, 0)] * y + u[(row, 1)] * theta + u[(row, 2)] * m + u[(row, 3)] * q;
        (behind(2) * end_theta - behind(3) * end_y) - (m * theta - q * y)
    };
    let TaperedBeam { length, bending_stiffness, mass_per_length, .. } = BLADE;
    let values = [
        length,
        bending_stiffness,
        mass_per_length,
        BLADE.width_taper,
        BLADE.height_taper,
        BLADE.rotary_inertia,
        BLADE.axial_force,
        BLADE.axial_load,
        BLADE.rotation_speed,
        BLADE.hub_radius,
        BLADE.setting_angle,
        BLADE.foundation_stiffness,
    ];
    let beam = |values: [D; 12]| {
        let [length, bending_stiffness, mass_per_length, width_taper, height_taper, rotary_inertia, ..] = values;
        let [.., axial_force, axial_load, rotation_speed, hub_radius, setting_angle, foundation_stiffness] = values;
        TaperedBeam {
            length,
            bending_stiffness,
            mass_per_length,
            width_taper,
            height_taper,
            rotary_inertia,
            axial_force,
            axial_load,
            rotation_speed,
            hub_radius,
            setting_angle,
            foundation_stiffness,
        }
    };
    let found: TaperedBeam<f64> = <TaperedBeam<f64> as Energies<f64>>::gradient(&BLADE.build().unwrap(), &start);
    let found = [
        found.length,
        found.bending_stiffness,
        found.mass_per_length,
        found.width_taper,
        found.height_taper,
        found.rotary_inertia,
        found.axial_force,
        found.axial_load,
        found.rotation_speed,
        found.hub_radius,
        found.setting_angle,
        found.foundation_stiffness,
    ];
    let step = 1e-9;
    for (index, found) in found.into_iter().enumerate() {
        let at =
            |by: f64| work(beam(core::array::from_fn(|k| wide(values[k]) + wide(if k == index { by } else { 0.0 }))));
        let expected = 0.5 * ((at(step) - at(-step)) / wide(2.0 * step)).to_f64();
        assert_close(found, expected, expected.abs().max(0.01), 1e4);
        assert!((found / expected - 1.0).abs() < 1e-11, "{index}: {found} {expected}");
    }
}

/// A reversed beam has the gradient of the beam, at the motion seen from its other end.
#[test]
fn gradients_do_not_know_the_end() {
    let built = BLADE.build().unwrap();
    let ends = ends(&built, Complex::new(-0.3, 7.0));
    let turned = Ends { x: ends.x, input: ends.output.backwards(), output: ends.input.backwards() };
    let one: TaperedBeam<Complex<f64>> = <TaperedBeam<f64> as Energies<Complex<f64>>>::gradient(&built, &ends);
    let other: TaperedBeam<Complex<f64>> =
        <TaperedBeam<f64> as Energies<Complex<f64>>>::gradient(&built.reversed(), &turned);
    for pick in [
        |g: &TaperedBeam<Complex<f64>>| g.length,
        |g: &TaperedBeam<Complex<f64>>| g.height_taper,
        |g: &TaperedBeam<Complex<f64>>| g.axial_load,
        |g: &TaperedBeam<Complex<f64>>| g.rotation_speed,
        |g: &TaperedBeam<Complex<f64>>| g.hub_radius,
        |g: &TaperedBeam<Complex<f64>>| g.setting_angle,
    ] {
        assert_close((pick(&one) - pick(&other)).norm(), 0.0, pick(&one).norm(), 1e4);
    }
}

/// Clamped counts of beams of high taper jump by one at each change of the sign of the clamped minor, from zero at rest.
#[test]
fn clamped_counts_are_changes_of_the_sign() {
    for height_taper in [0.9, -9.0, 0.5] {
        let beam = TaperedBeam { height_taper, axial_force: 0.0, rotary_inertia: 0.0, ..BLADE };
        let built = beam.build().unwrap();
        let input = Subspace::Tip(Support::Fixed, mstmm_plan::Space::Bending);
        let mut changes = 0;
        let mut last = false;
        for k in 1..=1500_u32 {
            let omega = f64::from(k) * if height_taper < 0.0 { 1.7 } else { 0.17 };
            let at = FrequencyPowers::new(omega, false);
            let coefficients: Tapered<f64> = TaperedBeam::coefficients(&built, &at);
            let mut counter = WittrickWilliams::<f64>::default();
            let delta = Subspace::Plane(coefficients.through(input.plane(), &mut counter));
            let delta = delta.at_root(Support::Fixed, &mut counter).mantissa();
            changes += u64::from(core::mem::replace(&mut last, delta < 0.0) != (delta < 0.0));
            assert_eq!(counter.below(), changes, "{height_taper} at {omega}");
        }
        assert!(changes >= 4, "{changes}");
    }
}

/// The state that is picked at an end is the one that was given there.
#[test]
fn states_at_ends_are_the_given_ones() {
    let built = BLADE.build().unwrap();
    let ends: Ends<f64> = ends(&built, 11.0);
    let inside = Inside::new::<f64>(&built, &ends);
    let near: Vec<State<f64>> = [0.0, 1.0].into_iter().map(|share| inside.state_at::<f64>(share)).collect();
    for (found, given) in near.iter().zip([ends.input, ends.output]) {
        assert_close(found.plus(given, -1.0).size(), 0.0, ends.input.size() + ends.output.size(), 256.0);
    }
}
