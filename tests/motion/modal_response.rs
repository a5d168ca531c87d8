//! Responses in time by superposition of modes, against closed forms, independent series and quadrature.
#![expect(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(missing_docs)]

pub mod beams;
mod drifts;
mod histories;
mod residuals;
mod transforms;

use crate::support::models;
use mstmm::motion::MotionError;
use mstmm::number::{DoubleDouble, Parameter, Real, Scalar};
use mstmm::prelude::*;

system! {
    #[derive(Clone, Copy, Debug)]
    pub struct Oscillator { k: f64, m: f64 }
    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
}

system! {
    #[derive(Clone, Copy, Debug)]
    pub struct Damped { k: f64, c: f64, m: f64 }
    fixed -> spring 1 { stiffness: k, damping: c } -> mass 2 { mass: m } -> free;
}

system! {
    #[derive(Clone, Copy, Debug)]
    pub struct Alone { m: f64 }
    free -> mass 1 { mass: m } -> free;
}

system! {
    /// Two masses that nothing holds.
    #[derive(Clone, Copy, Debug)]
    pub struct Pair { m: f64, n: f64, k: f64, c: f64 }
    free -> mass 1 { mass: m } -> spring 2 { stiffness: k, damping: c } -> mass 3 { mass: n } -> free;
}

system! {
    /// Two masses on a spring, held by dampers alone: one eigenvalue at zero, which is no rigid body.
    #[derive(Clone, Copy, Debug)]
    pub struct Drifting { m: f64, k: f64, c: f64 }
    free -> mass 1 { mass: m } -> conn 2 -> spring 3 { stiffness: k } -> conn 4 -> mass 5 { mass: m } -> free;
    conn 2 <- damper 6 { damping: c } <- fixed;
    conn 4 <- damper 7 { damping: c } <- fixed;
}

system! {
    #[derive(Clone, Copy, Debug)]
    pub struct Sliding { m: f64, c: f64 }
    fixed -> damper 1 { damping: c } -> mass 2 { mass: m } -> free;
}

system! {
    /// Three equal oscillators on one spring.
    #[derive(Clone, Copy, Debug)]
    pub struct Star { k: f64, m: f64, ground: f64 }
    free -> mass 1 { mass: m } -> spring 2 { stiffness: k } -> conn 3 -> spring 4 { stiffness: ground } -> fixed;
    conn 3 <- spring 5 { stiffness: k } <- mass 6 { mass: m } <- free;
    conn 3 <- spring 7 { stiffness: k } <- mass 8 { mass: m } <- free;
}

/// `|actual - expected| <= factor · eps · scale` in the arithmetic of the values.
#[track_caller]
pub fn assert_close<T: Real>(actual: T, expected: T, scale: f64, factor: f64) {
    let (error, unit) = ((actual - expected).size(), T::EPSILON * scale);
    assert!(error <= factor * unit, "{actual:?} is not {expected:?}: {} units", error / unit);
}

/// A number of the arithmetic `T`.
fn number<T: Real>(value: f64) -> T {
    T::from_f64(value)
}

/// Closed form: `sin(ωt)/(mω)` and `(1 - cos ωt)/k`; the phase takes on the rounding of ω, times ωt.
macro_rules! oscillator_in {
    ($test:ident, $scalar:ty) => {
        #[test]
        fn $test() {
            let (k, m) = (5.0, 0.75);
            let system = Oscillator { k, m }.build_as::<$scalar>().unwrap();
            let tip = Oscillator::mass_2.output();
            let roots = system.first_frequencies::<1>().unwrap();
            let response = system.modal_response::<1, _>(&roots, tip.force(), tip.deflection()).unwrap();
            let [k, m, one] = [k, m, 1.0].map(number::<$scalar>);
            let omega = Scalar::sqrt(k / m);
            for time in [0.0, 1e-3, 0.3, 1.0, 7.0, 50.0] {
                let t = number::<$scalar>(time);
                let (sin, cos) = Scalar::sin_cos(omega * t);
                let phase = 2.0 + (omega * t).to_f64();
                assert_close(response.to_impulse(t), sin / (m * omega), phase / (m * omega).to_f64(), 8.0);
                assert_close(response.to_step(t), (one - cos) / k, phase / k.to_f64(), 8.0);
            }
            assert_close(response.static_value().unwrap(), one / k, (one / k).to_f64(), 4.0);
        }
    };
}
oscillator_in!(an_oscillator_in_f64, f64);
oscillator_in!(an_oscillator_in_f32, f32);
oscillator_in!(an_oscillator_in_double_double, DoubleDouble);

/// Closed forms of the textbook: `(e^{λ₁t} - e^{λ₂t})/(m (λ₁ - λ₂))` for all but critical damping, and its integral.
#[test]
fn a_damped_oscillator_vibrates_or_creeps() {
    let (k, m) = (5.0_f64, 0.75);
    for ratio in [0.0, 0.01, 0.3, 0.99, 1.01, 2.0, 20.0] {
        let c = 2.0 * ratio * (k * m).sqrt();
        let system = Damped { k, c, m }.build().unwrap();
        let tip = Damped::mass_2.output();
        // a pair, or two of the real axis
        let roots = system.eigenvalues::<2>(Region { re: -150.0..=1.0, im: 0.0..=5.0 }).unwrap();
        let response = system.modal_response::<2, _>(&roots, tip.force(), tip.deflection()).unwrap();
        let (delta, square) = (c / (2.0 * m), c * c / (4.0 * m * m) - k / m);
        let conditioning = 4.0 * ratio * ratio + 1.0 / (1.0 - ratio).abs().sqrt();
        for t in [0.0_f64, 1e-3, 0.3, 1.0, 7.0] {
            let beta = square.abs().sqrt();
            let (s, c) = if square < 0.0 {
                ((beta * t).sin(), (beta * t).cos())
            } else {
                ((beta * t).sinh(), (beta * t).cosh())
            };
            let decay = (-delta * t).exp();
            // near critical damping two large terms cancel; far beyond, the spring and the damper nearly do
            let scale = (2.0 + 3.0 * t) * conditioning;
            assert_close(response.to_impulse(t), decay * s / beta / m, scale / m, 16.0);
            assert_close(response.to_step(t), (1.0 - decay * (c + delta / beta * s)) / k, scale / k, 16.0);
        }
        assert_close(response.static_value().unwrap(), 1.0 / k, conditioning / k, 16.0);
    }
}

/// Closed form: `t/m` and `t²/(2m)`, from a frequency of zero as from an eigenvalue of zero.
#[test]
fn a_rigid_body_moves_off() {
    let system = Alone { m: 0.3 }.build().unwrap();
    let tip = Alone::mass_1.output();
    let by_frequency = system.first_frequencies::<1>().unwrap();
    let by_eigenvalue = system.first_eigenvalues::<2>().unwrap();
    assert_eq!(by_eigenvalue[0].lambda, Complex::new(0.0, 0.0));
    // rigid bodies take no room
    let real = system.modal_response::<0, _>(&by_frequency, tip.force(), tip.deflection()).unwrap();
    let complex = system.modal_response::<0, _>(&by_eigenvalue, tip.force(), tip.deflection()).unwrap();
    for t in [0.0, 0.1, 1.0, 30.0] {
        for [impulse, step] in [[real.to_impulse(t), real.to_step(t)], [complex.to_impulse(t), complex.to_step(t)]] {
            assert_close(impulse, t / 0.3, t / 0.3, 4.0);
            assert_close(step, t * t / 0.6, t * t / 0.6, 4.0);
        }
    }
    assert_eq!(real.static_value(), Err(MotionError::Resonance { frequency: 0.0 }));
}

/// Closed form: the common centre moves off as one body, and about it the masses vibrate as one of `m n/(m + n)`.
#[test]
fn two_masses_move_off_and_vibrate() {
    let (m, n, k, c) = (2.0, 3.0, 4.0, 0.5);
    let system = Pair { m, n, k, c }.build().unwrap();
    let (here, there) = (Pair::mass_1.output(), Pair::mass_3.output());
    let roots = system.first_eigenvalues::<3>().unwrap();
    let at = |entry| system.modal_response::<1, _>(&roots, here.force(), entry).unwrap();
    let (near, far) = (at(here.deflection()), at(there.deflection()));
    let (whole, reduced) = (m + n, m * n / (m + n));
    let delta = c / (2.0 * reduced);
    let omega = (k / reduced - delta * delta).sqrt();
    for t in [0.0, 0.5, 2.0, 9.0] {
        let relative = (-delta * t).exp() * (omega * t).sin() / omega;
        assert_close(near.to_impulse(t), t / whole + n / (whole * m) * relative, 1.0 + t, 8.0);
        assert_close(far.to_impulse(t), t / whole - relative / whole, 1.0 + t, 8.0);
    }
}

/// Closed form: together `m ẍ + c ẋ = F/2`, against each other an oscillator on twice the spring.
#[test]
fn what_dampers_alone_hold_drifts() {
    let (m, k, c) = (2.0, 4.0, 0.5);
    let system = Drifting { m, k, c }.build().unwrap();
    let tip = Drifting::mass_1.output();
    let roots = system.first_eigenvalues::<3>().unwrap();
    let response = system.modal_response::<3, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let delta = c / (2.0 * m);
    let omega = (2.0 * k / m - delta * delta).sqrt();
    for t in [0.0, 0.5, 2.0, 9.0] {
        let decay = (-c / m * t).exp();
        let together = (1.0 - decay) / (2.0 * c);
        let apart = (-delta * t).exp() * (omega * t).sin() / (2.0 * m * omega);
        assert_close(response.to_impulse(t), together + apart, 1.0 + t, 16.0);
        let together = (t - (1.0 - decay) * m / c) / (2.0 * c);
        let held = 1.0 - (-delta * t).exp() * ((omega * t).cos() + delta / omega * (omega * t).sin());
        assert_close(response.to_step(t), together + held / (4.0 * k), 1.0 + t, 16.0);
    }
    assert_eq!(response.static_value(), Err(MotionError::Resonance { frequency: 0.0 }));

    let system = Sliding { m, c }.build().unwrap();
    let tip = Sliding::mass_2.output();
    let roots = system.first_eigenvalues::<2>().unwrap();
    let response = system.modal_response::<2, _>(&roots, tip.force(), tip.deflection()).unwrap();
    assert_close(response.to_impulse(3.0), (1.0 - (-3.0 * c / m).exp()) / c, 1.0 / c, 16.0);
}

/// Closed form: one motion in which all three take part, and two of the same frequency in which the spring they share rests.
#[test]
fn all_shapes_of_a_multiple_root_take_part() {
    let (k, m, ground) = (2.0_f64, 0.5, 3.0);
    let system = Star { k, m, ground }.build().unwrap();
    let (first, second) = (Star::mass_1.output(), Star::mass_6.output());
    let roots = system.first_frequencies::<3>().unwrap();
    assert_eq!(roots.iter().map(|root| root.multiplicity).collect::<Vec<_>>(), [1, 2]);
    let at = |entry| system.modal_response::<3, _>(&roots, first.force(), entry).unwrap();
    let (near, far) = (at(first.deflection()), at(second.deflection()));
    let (common, apart) = ((k * ground / (ground + 3.0 * k) / m).sqrt(), (k / m).sqrt());
    for t in [0.0, 0.4, 3.0, 11.0] {
        let (s, a) = ((common * t).sin() / (3.0 * m * common), (apart * t).sin() / (3.0 * m * apart));
        assert_close(near.to_impulse(t), s + 2.0 * a, 1.0 + t, 64.0);
        assert_close(far.to_impulse(t), s - a, 1.0 + t, 64.0);
    }
    let few = system.modal_response::<2, _>(&roots, first.force(), first.deflection());
    assert_eq!(few.unwrap_err(), MotionError::Capacity { capacity: 2 });
}

/// The textbook: `e^{-ζωt} sin(ω_d t)/(m ω_d)` and its integral.
#[test]
fn a_damping_ratio_is_that_of_the_textbook() {
    let (k, m) = (5.0_f64, 0.75);
    let system = Oscillator { k, m }.build().unwrap();
    let tip = Oscillator::mass_2.output();
    let roots = system.first_frequencies::<1>().unwrap();
    let undamped = system.modal_response::<1, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let omega = (k / m).sqrt();
    for ratio in [0.0, 0.01, 0.3, 0.9] {
        let response = undamped.with_damping_ratio(ratio).unwrap();
        let slow = omega * (1.0 - ratio * ratio).sqrt();
        for t in [0.0, 0.01, 1.0, 8.0] {
            let (decay, s, c) = ((-ratio * omega * t).exp(), (slow * t).sin(), (slow * t).cos());
            let phase = 2.0 + omega * t;
            assert_close(response.to_impulse(t), decay * s / (m * slow), phase / (m * slow), 4.0);
            assert_close(
                response.to_step(t),
                (1.0 - decay * (c + ratio * omega / slow * s)) / k,
                phase * omega / slow / k,
                4.0,
            );
        }
        assert_close(response.static_value().unwrap(), 1.0 / k, omega / slow / k, 4.0);
    }
    for ratio in [-0.1, 1.0, f64::INFINITY] {
        assert_eq!(undamped.with_damping_ratio(ratio).unwrap_err(), MotionError::DampingRatio { ratio });
    }
    assert!(undamped.with_damping_ratio(f64::NAN).is_err());
}

#[test]
fn what_cannot_be_said_is_an_error() {
    let system = Oscillator { k: 5.0, m: 0.75 }.build().unwrap();
    let tip = Oscillator::mass_2.output();
    let roots = system.first_frequencies::<1>().unwrap();
    for (load, entry) in [(tip.torque(), tip.deflection()), (tip.force(), tip.rotation())] {
        let response = system.modal_response::<1, _>(&roots, load, entry);
        assert_eq!(response.unwrap_err(), system.frequency_response(load, entry).unwrap_err());
    }
    let none = system.modal_response::<0, _>(&roots, tip.force(), tip.deflection());
    assert_eq!(none.unwrap_err(), MotionError::Capacity { capacity: 0 });
    let others = Oscillator { k: 6.0, m: 0.75 }.build().unwrap().first_frequencies::<1>().unwrap();
    let foreign = system.modal_response::<1, _>(&others, tip.force(), tip.deflection());
    assert!(matches!(foreign, Err(MotionError::NotARoot { .. })));

    let response = system.modal_response::<1, _>(&roots, tip.force(), tip.deflection()).unwrap();
    for step in [0.0, -0.1, f64::INFINITY] {
        assert_eq!(response.history(step).unwrap_err(), MotionError::TimeStep { step });
    }
    assert!(response.history(f64::NAN).is_err());
    assert!(response.to_impulse(f64::NAN).is_nan() && response.to_step(f64::NAN).is_nan());
    assert_eq!((response.to_impulse(-1.0), response.to_step(-1.0)), (0.0, 0.0));

    let system = Damped { k: 4.0, c: 4.0, m: 1.0 }.build().unwrap();
    let (tip, roots) = (Damped::mass_2.output(), system.first_eigenvalues::<2>().unwrap());
    let response = system.modal_response::<4, _>(&roots, tip.force(), tip.deflection());
    assert!(matches!(response, Err(MotionError::Defective { multiplicity: 2, .. })), "{response:?}");
}

/// What is printed of a list is what is in it.
#[test]
fn lists_show_no_unused_memory() {
    let system = Oscillator { k: 5.0, m: 0.75 }.build().unwrap();
    let none = system.natural_frequencies::<2>(0.0..=1.0).unwrap();
    assert!(format!("{none:?}").starts_with("FrequencyList { frequencies: [], "), "{none:?}");
    let all = system.natural_frequencies::<3>(0.0..=10.0).unwrap();
    let shapes = system.mode_shapes::<3, _>(&all[0]).unwrap();
    let printed = format!("{shapes:?}");
    assert!(printed.starts_with("[ModeShape") && !printed.contains("None"), "{printed}");
}

/// Eigenvalues of the lower half plane say nothing that their conjugates have not said.
#[test]
fn conjugates_count_once() {
    let system = models::damped_oscillator().build().unwrap();
    let point = models::DampedOscillator::conn_5;
    let region = |low| Region { re: -1e3..=1.0, im: low..=3e3 };
    let [upper, whole] = [0.0, -3e3].map(|low| system.eigenvalues::<16>(region(low)).unwrap());
    assert!(whole.len() > upper.len());
    let [upper, whole] = [upper, whole]
        .map(|roots| system.modal_response::<16, _>(&roots, point.force(), point.deflection()).unwrap().to_step(1e-3));
    assert_close(upper, whole, upper, 64.0);
}
