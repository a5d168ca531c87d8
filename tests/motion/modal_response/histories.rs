//! Force histories against steps, convolutions and themselves.

use super::{Alone, assert_close};
use crate::support::models::{DampedOscillator, TipBody, damped_oscillator, light_tip_body};
use mstmm::motion::ModalResponse;
use mstmm::number::{ComplexEigenvalue, RealFrequency};
use mstmm::prelude::*;

/// Points and weights of Gauss' rule on -1..1 that is exact up to the ninth degree.
const GAUSS: [(f64, f64); 5] = [
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// An integral over so many panels.
pub(crate) fn integral(from: f64, to: f64, panels: usize, f: impl Fn(f64) -> f64) -> f64 {
    let half = 0.5 * (to - from) / panels as f64;
    let over = |panel: usize| {
        let centre = from + half * (2 * panel + 1) as f64;
        GAUSS.iter().map(|(point, weight)| weight * f(centre + half * point)).sum::<f64>() * half
    };
    (0..panels).map(over).sum()
}

/// Five modes of section 4.1, the force and the deflection at the end of the beam.
fn undamped() -> ModalResponse<f64, 5, RealFrequency> {
    let system = light_tip_body().build().unwrap();
    let tip = TipBody::beam_1.output();
    system.modal_response(&system.first_frequencies::<5>().unwrap(), tip.force(), tip.deflection()).unwrap()
}

/// Four eigenvalues of section 4.5, the force and the deflection at the oscillator.
fn damped() -> ModalResponse<f64, 4, ComplexEigenvalue> {
    let system = damped_oscillator().build().unwrap();
    let point = DampedOscillator::conn_5;
    system.modal_response(&system.first_eigenvalues::<4>().unwrap(), point.force(), point.deflection()).unwrap()
}

/// The last sample of a history.
fn last<const N: usize, M>(
    response: &ModalResponse<f64, N, M>,
    dt: f64,
    steps: u32,
    force: impl Fn(f64) -> f64,
) -> f64 {
    let mut history = response.history(dt).unwrap();
    (0..=steps).fold(f64::NAN, |_, n| history.next(force(f64::from(n) * dt)))
}

/// Closed form: the step response, whatever the step of time; its static value is the scale.
#[test]
fn a_constant_force_is_a_step() {
    fn check<const N: usize, M>(response: &ModalResponse<f64, N, M>, period: f64) {
        let scale = response.static_value().unwrap();
        for dt in [1e-3, 0.02, 0.7, 13.0].map(|share| share * period) {
            let mut history = response.history(dt).unwrap();
            for n in 0..100 {
                // every step rounds once, and turns by a rounded angle
                let rounding = 2.0 + f64::from(n) * (1.0 + dt / period);
                assert_close(
                    history.next(3.0),
                    3.0 * response.to_step(f64::from(n) * dt),
                    3.0 * scale * rounding,
                    16.0,
                );
            }
        }
    }
    check(&undamped(), 1.0);
    check(&undamped().with_damping_ratio(0.02).unwrap(), 1.0);
    check(&damped(), 0.01);
    let system = Alone { m: 0.3 }.build().unwrap();
    let point = Alone::mass_1.output();
    let roots = system.first_frequencies::<1>().unwrap();
    let response = system.modal_response::<0, _>(&roots, point.force(), point.deflection()).unwrap();
    let mut history = response.history(0.25).unwrap();
    for n in 0..20 {
        let t = 0.25 * f64::from(n);
        assert_close(history.next(3.0), 3.0 * t * t / 0.6, t * t + 1.0, 16.0);
    }
}

/// Oracle: the convolution with the impulse response, by Gauss' rule, of the polygon through the samples.
#[test]
fn a_polygon_is_exact_at_any_step() {
    fn check<const N: usize, M>(response: &ModalResponse<f64, N, M>, end: f64, corners: [f64; 5], panels: usize) {
        let side = end / 4.0;
        let force = |t: f64| {
            let n = ((t / side) as usize).min(3);
            corners[n] + (corners[n + 1] - corners[n]) * (t / side - n as f64)
        };
        let scale = response.static_value().unwrap();
        // what gives way at once takes no part in the convolution
        let at_once = response.to_step(0.0) * force(end);
        let convolution: f64 = at_once
            + (0..4)
                .map(|n| {
                    let n = f64::from(n);
                    integral(n * side, (n + 1.0) * side, panels, |t| force(t) * response.to_impulse(end - t))
                })
                .sum::<f64>();
        let coarse = last(response, side, 4, force);
        assert_close(coarse, convolution, scale, 64.0);
        for parts in [2, 3, 40] {
            let fine = last(response, side / f64::from(parts), 4 * parts, force);
            assert_close(fine, coarse, scale, 16.0 * f64::from(parts));
        }
    }
    check(&undamped(), 1.0, [0.3, 1.0, -2.0, 0.5, 0.25], 1000);
    check(&undamped().with_damping_ratio(0.05).unwrap(), 1.0, [0.3, 1.0, -2.0, 0.5, 0.25], 1000);
    check(&damped(), 0.01, [1.0, 0.0, -2.0, 0.5, 0.25], 1000);
}

/// Closed form of a rigid body under a ramp, `F = a t`: `a t³/(6m)`.
#[test]
fn a_rigid_body_under_a_ramp() {
    let system = Alone { m: 0.3 }.build().unwrap();
    let point = Alone::mass_1.output();
    let roots = system.first_frequencies::<1>().unwrap();
    let response = system.modal_response::<0, _>(&roots, point.force(), point.deflection()).unwrap();
    for steps in [1, 2, 7] {
        let value = last(&response, 2.0 / f64::from(steps), steps, |t| 5.0 * t);
        assert_close(value, 5.0 * 8.0 / 1.8, 5.0 * 8.0 / 1.8, 16.0);
    }
}

/// Oracle: the convolution of a smooth force with the impulse response. The polygon through its samples errs with the square of
/// the step, `dt²/12` of the second derivative; extrapolated from two steps it is right to 1e-10.
#[test]
fn a_smooth_force_is_a_convolution() {
    let (response, end) = (undamped(), 1.3);
    let force = |t: f64| (3.0 * t).sin() * (-t).exp();
    let scale = response.static_value().unwrap();
    let moved = integral(0.0, end, 4000, |t| force(t) * response.to_impulse(end - t));
    let exact = moved + response.to_step(0.0) * force(end);
    let [coarse, fine] = [1000, 2000].map(|steps| last(&response, end / f64::from(steps), steps, force));
    let order = ((coarse - exact) / (fine - exact)).log2();
    assert!((order - 2.0).abs() < 0.01, "order {order}");
    let error = ((4.0 * fine - coarse) / 3.0 - exact).abs() / scale;
    assert!(error < 1e-10, "{error:e}");
}

/// What follows from the mean of `1 - cos`: over whole periods a constant load gives the static response.
#[test]
fn the_mean_of_a_step_is_static() {
    let system = light_tip_body().build().unwrap();
    let tip = TipBody::beam_1.output();
    for root in &system.first_frequencies::<5>().unwrap() {
        let response = system.modal_response::<1, _>([root], tip.force(), tip.deflection()).unwrap();
        let period = std::f64::consts::TAU / root.omega;
        let mean = (0..16).map(|n| response.to_step(f64::from(n) / 16.0 * period)).sum::<f64>() / 16.0;
        let value = response.static_value().unwrap();
        assert_close(mean, value, value.abs(), 16.0);
    }
}
