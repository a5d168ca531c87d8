//! Random vibrations: values of the file, closed forms, quadratures of the same integrals, bounds, and what is refused.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{Cantilever, assert_close, cantilever, number, oscillator, reference};
use crate::numbers::Random;
use crate::random::frame;
use mstmm::Complex;
use mstmm::frame::{Frame, Section};
use mstmm::motion::{ModalResponse, MotionError, PowerSpectrum, RandomError};
use mstmm::number::ComplexEigenvalue;
use mstmm::prelude::*;
use mstmm::search::ProportionalDamping;
use std::f64::consts::{PI, TAU};

type Damped<const N: usize> = ModalResponse<f64, N, ComplexEigenvalue>;

/// The table of the file, in g²/Hz.
fn rows() -> Vec<(f64, f64)> {
    let part = reference("random_vibration")["base_asd"]["breakpoints_hz_g2"].clone();
    part.as_array().unwrap().iter().map(|row| (number(&row[0]), number(&row[1]))).collect()
}

#[test]
fn vibrations_on_a_shaker_are_those_of_the_file() {
    let part = reference("random_vibration")["base_asd"].clone();
    let (rows, g) = (rows(), number(&part["g"]));
    let shaker = PowerSpectrum::hertz(&rows).unwrap();
    assert_close(shaker.rms(), number(&part["input_rms_g"]), 1e-15);
    let shaker = shaker.times(g * g);
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<8>().unwrap();
    let ground = Load::base_acceleration(Direction::y());
    let of = |entry| {
        let response = cantilever.modal_response::<8, _>(&roots, ground, entry).unwrap();
        response.with_damping_ratio(number(&part["ratio"])).unwrap()
    };
    let tip = Cantilever::conn_tip.deflection();
    for (name, entry) in [("tip relative deflection", tip), ("base moment", Cantilever::beam_1.input().moment())] {
        let known = &part["answers"][name];
        let found = of(entry).random(&shaker).unwrap();
        assert_close(found.rms, number(&known["rms"]), 1e-13);
        assert_close(found.rate_rms.unwrap(), number(&known["rms_rate"]), 1e-13);
        assert_close(found.up_crossings_hertz().unwrap(), number(&known["zero_up_crossings_hz"]), 1e-13);
        assert_close(of(entry).power_at(50.0, &shaker).unwrap(), number(&known["psd_at_50_hz"]), 1e-12);
    }
    let known = &part["answers"]["tip absolute acceleration"];
    let acceleration = of(tip).absolute().unwrap().acceleration().unwrap();
    let found = acceleration.random(&shaker).unwrap();
    assert_close(found.rms, number(&known["rms"]), 1e-13);
    assert_close(found.rms / g, number(&known["rms_g"]), 1e-13);
    // what rides with the ground at once follows white noise at once
    let residual = number(&known["residual_inertance"]);
    match acceleration.random(&PowerSpectrum::white(1.0)) {
        Err(RandomError::Residual { residual: found }) => assert_close(found, residual, 1e-11),
        other => panic!("{other:?}"),
    }
}

#[test]
fn white_noise_is_that_of_the_file() {
    let part = reference("random_vibration")["white_force"].clone();
    let noise = PowerSpectrum::white(4.0 * PI * number(&part["S0_two_sided_per_rad_s"]));
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let (load, entry) = (Cantilever::conn_tip.force(), Cantilever::conn_tip.deflection());
    let whole = cantilever.modal_response::<3, _>(&roots, load, entry).unwrap();
    let response = whole.without_residual().unwrap().with_damping_ratio(number(&part["ratio"])).unwrap();
    let found = response.random(&noise).unwrap();
    assert_close(found.rms * found.rms, number(&part["variance"]), 1e-13);
    let rate = found.rate_rms.unwrap();
    assert_close(rate * rate, number(&part["variance_of_rate"]), 1e-13);
    assert_close(found.up_crossings_hertz().unwrap(), number(&part["zero_up_crossings_hz"]), 1e-13);
    // a band that holds all of it, by series and logarithms in place of residues
    let wide = PowerSpectrum::band(0.0..=1e6, 4.0 * PI).unwrap();
    assert_close(response.random(&wide).unwrap().rms, found.rms, 1e-13);
    // the rate has a tail: the mass that the force feels at once goes with 1/f
    let away = response.acceleration().unwrap().to_step(0.0);
    let tail = 4.0 * PI * away * away / (4.0 * PI * PI * 1e6);
    assert_close(response.random(&wide).unwrap().rate_rms.unwrap(), (rate * rate - tail).sqrt(), 1e-13);
    let refused = whole.with_damping_ratio(0.02).unwrap().random(&noise);
    assert!(matches!(refused, Err(RandomError::Residual { residual }) if residual > 0.0), "{refused:?}");
}

/// Miles' equation: `√(π/2 f Q G (1 + 4ζ²))` in space, `√(G/(8 ζ ω³))` for the deflection, whatever the ratio is.
#[test]
fn one_mass_under_white_noise_is_known() {
    let (frame, [_, mass]) = oscillator(900.0, 4.0);
    let system = frame.build().unwrap();
    let roots = system.first_frequencies::<1>().unwrap();
    let ground = PlaneLoad::base_acceleration(Direction::x());
    let response = system.modal_response::<2, _>(&roots, ground, mass.displacement_x()).unwrap();
    let (omega, level) = (15.0_f64, 0.3_f64);
    for ratio in [1e-9_f64, 1e-4, 0.05, 0.4, 0.8, 0.99] {
        let damped = response.with_damping_ratio(ratio).unwrap();
        let noise = PowerSpectrum::white(level);
        let found = damped.random(&noise).unwrap();
        let tolerance = 1e-15 / (1.0 - ratio);
        assert_close(found.rms, (level / (8.0 * ratio * omega.powi(3))).sqrt(), tolerance);
        assert_close(found.rate_rms.unwrap(), (level / (8.0 * ratio * omega)).sqrt(), tolerance);
        assert_close(found.up_crossings_hertz().unwrap(), omega / TAU, tolerance);
        let shaken = damped.absolute().unwrap().acceleration().unwrap().random(&noise).unwrap();
        let (hertz, quality) = (omega / TAU, 0.5 / ratio);
        let miles = (0.5 * PI * hertz * quality * level * (1.0 + 4.0 * ratio * ratio)).sqrt();
        assert_close(shaken.rms, miles, 10.0 * tolerance);
        // a damper passes jumps on
        assert_eq!(shaken.rate_rms, None);
        assert_eq!(shaken.up_crossings_hertz(), None);
    }
}

/// With damping in proportion what is not in the list follows late, and white noise has a mean square; its rate has none.
#[test]
fn white_noise_with_rayleigh_damping() {
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let (load, entry) = (Cantilever::conn_tip.force(), Cantilever::conn_tip.deflection());
    let whole = cantilever.modal_response::<8, _>(&roots, load, entry).unwrap();
    let lag = 2e-5;
    let damped = whole.with_damping(&ProportionalDamping::new(0.4, lag, 0.0).unwrap()).unwrap();
    let found = damped.random(&PowerSpectrum::white(2.0)).unwrap();
    assert_eq!(found.rate_rms, None);
    // a band, and a tail that goes with the jump of the residual compliance over its lag
    let last = 1e9;
    let band = damped.random(&PowerSpectrum::band(0.0..=last, 2.0).unwrap()).unwrap();
    let jump = whole.to_step(0.0) / lag;
    let tail = 2.0 * (jump / TAU).powi(2) / last;
    assert_close(found.rms, (band.rms * band.rms + tail).sqrt(), 1e-13);
}

/// A damper at the tip: complex modes, of which each has a residue of its own phase.
#[test]
fn dashpots_at_a_tip() {
    system! {
        struct Damped {}
        fixed -> beam 1 { length: 1.2, bending_stiffness: 180.0, mass_per_length: 2.5 } -> point_mass 2 { mass: 0.8, inertia: 0.0 } -> conn tip -> free;
        fixed -> spring 3 { stiffness: 350.0, damping: 3.0 } -> conn tip;
    }
    let system = Damped {}.build().unwrap();
    let roots = system.first_eigenvalues::<5>().unwrap();
    let (load, entry) = (Damped::beam_1.uniform_load(), Damped::beam_1.input().moment());
    let response = system.modal_response::<8, _>(&roots, load, entry).unwrap();
    let rows = [(0.5, 0.2), (3.0, 1.0), (40.0, 0.7), (200.0, 1e-3)];
    let modes: Vec<_> = roots.iter().map(|root| (root.lambda.im, root.lambda.re)).collect();
    let found = response.random(&PowerSpectrum::hertz(&rows).unwrap()).unwrap();
    let expected = by_quadrature(&response, &rows, &modes);
    assert_close(found.rms, expected[0], 1e-12);
    assert_close(found.rate_rms.unwrap(), expected[1], 1e-12);
}

/// Nodes and weights of Gauss and Legendre on [-1, 1], by Newton's method.
pub(crate) fn gauss() -> Vec<(f64, f64)> {
    let count = 20;
    let legendre = |x: f64| {
        (1..count).fold((1.0, x), |(before, last), n| {
            let n = f64::from(n);
            (last, ((2.0 * n + 1.0) * x * last - n * before) / (n + 1.0))
        })
    };
    let node = |k: i32| {
        let (mut x, mut slope) = ((PI * (f64::from(k) + 0.75) / (f64::from(count) + 0.5)).cos(), 1.0);
        for _ in 0..40 {
            let (before, last) = legendre(x);
            slope = f64::from(count) * (before - x * last) / ((1.0 - x) * (1.0 + x));
            x -= last / slope;
        }
        (x, 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope))
    };
    (0..count).map(node).collect()
}

/// Root mean squares of a response and of its rate by quadrature of `at`, in panels that are narrow beside their distance from each mode. A mode is a frequency and a decay [rad/s].
fn by_quadrature<const N: usize>(response: &Damped<N>, rows: &[(f64, f64)], modes: &[(f64, f64)]) -> [f64; 2] {
    let (nodes, mut sums) = (gauss(), [0.0; 2]);
    for pair in rows.windows(2) {
        let ((start, low), (end, high)) = (pair[0], pair[1]);
        let slope = (high / low).ln() / (end / start).ln();
        let mut stack = vec![(start, end)];
        while let Some((from, to)) = stack.pop() {
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let apart = |(omega, decay): &(f64, f64)| (TAU * middle - omega).hypot(*decay) / TAU;
            if half > 0.5 * modes.iter().map(apart).fold(middle / (1.0 + slope.abs()), f64::min) {
                stack.extend([(from, middle), (middle, to)]);
                continue;
            }
            for (node, weight) in &nodes {
                let hertz = middle + half * node;
                let value = response.at(Complex::new(0.0, TAU * hertz)).unwrap().norm_sqr();
                let part = value * low * (hertz / start).powf(slope) * weight * half;
                sums[0] += part;
                sums[1] += part * (TAU * hertz).powi(2);
            }
        }
    }
    sums.map(f64::sqrt)
}

/// A table about the frequencies of a system: level parts, those at whose slope an exponent vanishes, steep ones.
pub(crate) fn table(random: &mut Random, lowest: f64, highest: f64) -> Vec<(f64, f64)> {
    let (mut hertz, mut level) = (0.3 * lowest * (0.2 + random.unit()), 1e-3 + random.unit());
    let mut rows = vec![(hertz, level)];
    while hertz < highest {
        let step = 1.001 + 2.0 * random.unit().powi(3);
        let slope = random.pick([0.0, -1.0, -3.0, 1.0, 2.0, -2.0, -5.0, 12.0, -17.3]);
        (hertz, level) = (hertz * step, level * step.powf(slope));
        rows.push((hertz, level));
    }
    rows
}

/// Random frames with dampings of all kinds, beside quadratures; gives the largest error.
fn largest_error(seeds: core::ops::Range<u64>) -> f64 {
    let (mut worst, mut tried) = (0.0_f64, 0);
    for seed in seeds {
        let own = frame(seed, 0.0, || 0.0);
        let system = own.frame.build().unwrap();
        let mut random = Random(seed + 77);
        let Ok(roots) = system.frequencies(6) else { continue };
        let point = own.points[1 + random.below(own.points.len() - 1)];
        let member = own.members[random.below(own.members.len())];
        let ground = PlaneLoad::base_acceleration(Direction::x());
        let loads = [point.force_y(), ground, own.points[0].motion_x(), member.output().kink()];
        let entries = [point.displacement_x(), member.input().moment()];
        let [low, high] = [roots[0].omega, roots[5].omega];
        for (load, entry) in loads.into_iter().flat_map(|load| entries.map(|entry| (load, entry))) {
            let sum = system.modal_response::<16, _>(&roots, load, entry).unwrap();
            let ratios: Vec<f64> = roots.iter().map(|_| 0.8 * random.unit().powi(4) + 1e-4).collect();
            let by_ratio = sum.with_damping_ratios(&ratios).unwrap();
            let rayleigh = ProportionalDamping::new(0.02 * low, 0.02 / high, 0.0).unwrap();
            let mut cases = vec![by_ratio, sum.with_damping(&rayleigh).unwrap()];
            cases.extend(by_ratio.rate());
            cases.extend(by_ratio.acceleration());
            cases.extend(by_ratio.absolute().and_then(|absolute| absolute.acceleration()));
            for response in cases {
                let rows = table(&mut random, low / TAU, high / TAU);
                let modes = roots.iter().zip(&ratios).flat_map(|(root, ratio)| {
                    let of_rayleigh = 0.01 * low + 0.01 * root.omega * root.omega / high;
                    [(root.omega * (1.0 - ratio * ratio).sqrt(), ratio * root.omega), (root.omega, of_rayleigh)]
                });
                let modes: Vec<_> = modes.collect();
                let found = response.random(&PowerSpectrum::hertz(&rows).unwrap()).unwrap();
                let expected = by_quadrature(&response, &rows, &modes);
                for (found, expected) in [found.rms, found.rate_rms.unwrap()].into_iter().zip(expected) {
                    // what moves across the load does not move
                    let error = if expected == 0.0 { found } else { (found / expected - 1.0).abs() };
                    assert!(error < 1e-10, "{seed} {load:?} {entry:?} {rows:?}: {found:e} {expected:e} {error:e}");
                    worst = worst.max(error);
                }
                tried += 1;
            }
        }
    }
    println!("{tried} responses of random frames: {worst:.1e} at most beside quadratures");
    assert!(tried > 0);
    worst
}

#[test]
fn vibrations_of_random_frames_are_quadratures() {
    assert!(largest_error(0..4) < 1e-11);
}

#[test]
#[ignore = "long: .ci/long"]
fn vibrations_of_three_hundred_random_frames_are_quadratures() {
    assert!(largest_error(0..300) < 1e-10);
}

#[test]
fn spectra_that_are_none_are_refused() {
    let of = |rows: &[(f64, f64)]| PowerSpectrum::hertz(rows).map(|_| ()).unwrap_err();
    assert_eq!(of(&[]), RandomError::Rows { rows: 0 });
    assert_eq!(of(&[(1.0, 2.0)]), RandomError::Rows { rows: 1 });
    for wrong in [1.0, 0.5, -2.0, f64::NAN, f64::INFINITY] {
        assert_eq!(of(&[(1.0, 2.0), (wrong, 2.0)]), RandomError::Order { row: 1 });
    }
    for wrong in [0.0, -1.0, f64::NAN] {
        assert_eq!(of(&[(wrong, 2.0), (2.0, 2.0)]), RandomError::Order { row: 0 });
    }
    for level in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(of(&[(1.0, 2.0), (3.0, level)]), RandomError::Level { level });
        assert_eq!(PowerSpectrum::band(1.0..=2.0, level).map(|_| ()).unwrap_err(), RandomError::Level { level });
    }
    assert!(matches!(of(&[(1.0, f64::NAN), (3.0, 1.0)]), RandomError::Level { level } if level.is_nan()));
    assert_eq!(of(&[(1.0, 1.0), (8.0, 1.0), (8.0 + 1e-14, 1e9)]), RandomError::Steep { row: 2 });
    for (start, end) in [(2.0, 2.0), (3.0, 2.0), (-1.0, 2.0), (1.0, f64::INFINITY)] {
        assert_eq!(PowerSpectrum::band(start..=end, 1.0).map(|_| ()).unwrap_err(), RandomError::Band { start, end });
    }
    assert!(matches!(PowerSpectrum::band(f64::NAN..=2.0, 1.0), Err(RandomError::Band { .. })));
    for error in [of(&[]), of(&[(1.0, 2.0), (1.0, 2.0)]), of(&[(1.0, -2.0), (2.0, 2.0)])] {
        assert!(error.to_string().len() > 30);
    }
}

#[test]
fn what_has_no_mean_square_is_refused() {
    let (model, [_, tip], _) = cantilever();
    let roots = model.first_frequencies::<3>().unwrap();
    let response = model.modal_response::<4, _>(&roots, tip.force_y(), tip.displacement_y()).unwrap();
    let damped = response.with_damping_ratio(0.02).unwrap();
    let [first, second] = [roots[0].omega, roots[1].omega];
    let band = |start: f64, end: f64| PowerSpectrum::band(start / TAU..=end / TAU, 1.0).unwrap();
    // without damping a spectrum may stand between the modes alone
    assert_eq!(response.random(&band(0.5 * first, 1.5 * first)), Err(RandomError::NoDamping { omega: first }));
    let between = response.random(&band(1.5 * first, 0.7 * second)).unwrap();
    let slightly = response.with_damping_ratio(1e-9).unwrap().random(&band(1.5 * first, 0.7 * second)).unwrap();
    assert_close(between.rms, slightly.rms, 1e-13);
    assert!(matches!(response.random(&PowerSpectrum::white(1.0)), Err(RandomError::NoDamping { .. })));
    assert!(matches!(response.power_at(first / TAU, &PowerSpectrum::white(1.0)), Err(RandomError::NoDamping { .. })));
    // levels that nobody has checked before
    for level in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(damped.random(&PowerSpectrum::white(level)), Err(RandomError::Level { level }));
        assert_eq!(damped.random(&band(1.0, 9.0).times(level)), Err(RandomError::Level { level }));
        assert_eq!(damped.power_at(0.5, &band(1.0, 9.0).times(level)), Err(RandomError::Level { level }));
    }
    assert!(matches!(damped.random(&band(1.0, 9.0).times(f64::NAN)), Err(RandomError::Level { .. })));
    for hertz in [-1.0, f64::INFINITY] {
        assert_eq!(damped.power_at(hertz, &band(1.0, 9.0)), Err(RandomError::Frequency { hertz }));
    }
    assert_eq!(damped.power_at(5.0, &band(1.0, 9.0)), Ok(0.0));
    assert_eq!(damped.rate().unwrap().without_residual().unwrap_err(), MotionError::AtOnce);
}

/// A body that nothing holds moves off under a spectrum that reaches down to zero, and has a mean square under any other.
#[test]
fn bodies_that_float() {
    let mut frame = Frame::new();
    let [a, b] = [[0.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    frame.member(a, b, Section::new().axial_stiffness(4e4).bending_stiffness(30.0).mass_per_length(1.5));
    let beam = frame.build().unwrap();
    let roots = beam.first_frequencies::<3>().unwrap();
    let response = beam.modal_response::<8, _>(&roots, a.force_x(), b.displacement_x()).unwrap();
    let damped = response.with_damping_ratio(0.02).unwrap();
    assert_eq!(damped.random(&PowerSpectrum::band(0.0..=5.0, 1.0).unwrap()), Err(RandomError::AtRest));
    assert_eq!(damped.random(&PowerSpectrum::white(1.0)), Err(RandomError::AtRest));
    assert_eq!(damped.power_at(0.0, &PowerSpectrum::white(1.0)), Err(RandomError::AtRest));
    // slowly it is a mass of 3 kg: ∫ (1/(m ω²))² df
    let slow = damped.random(&PowerSpectrum::band(1e-3..=2e-3, 1.0).unwrap()).unwrap();
    let expected = ((1e9_f64 - 1e9 / 8.0) / 3.0).sqrt() / (3.0 * TAU * TAU);
    assert_close(slow.rms, expected, 1e-7);
    // with drag a drift
    let drag = ProportionalDamping::new(0.3, 0.0, 0.0).unwrap();
    let dragged = response.with_damping(&drag).unwrap();
    assert_eq!(dragged.random(&PowerSpectrum::band(0.0..=5.0, 1.0).unwrap()), Err(RandomError::AtRest));
    let rows = [(0.01, 1.0), (2.0, 0.5)];
    let found = dragged.random(&PowerSpectrum::hertz(&rows).unwrap()).unwrap();
    let expected = by_quadrature(&dragged, &rows, &[(0.0, 0.3)]);
    assert_close(found.rms, expected[0], 1e-12);
    assert_close(found.rate_rms.unwrap(), expected[1], 1e-12);
}
