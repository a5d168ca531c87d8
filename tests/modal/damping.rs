//! Damping of each mode, and in proportion, in frequency and in time.

use crate::models::{Cantilever, assert_close, number, reference};
use core::f64::consts::PI;
use mstmm::Complex;
use mstmm::motion::MotionError;
use mstmm::prelude::*;
use mstmm::search::ProportionalDamping;

type C = Complex<f64>;

/// A ratio for each mode: values of fields with 40 digits.
#[test]
fn each_mode_has_its_ratio() {
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<5>().unwrap();
    let tip = Cantilever::conn_tip;
    let response = cantilever.modal_response::<5, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let part = reference("damping")["ratio_per_mode"].clone();
    let ratios: Vec<f64> = part["ratios"].as_array().unwrap().iter().map(number).collect();
    let damped = response.with_damping_ratios(&ratios).unwrap();
    let mut grid = Vec::new();
    for row in part["values"].as_array().unwrap() {
        let (lambda, expected) = (C::new(0.0, number(&row[0])), C::new(number(&row[1]), number(&row[2])));
        assert_close(damped.at(lambda).unwrap(), expected, 1e-12);
        grid.push(lambda);
    }
    let mut values = vec![C::ZERO; grid.len()];
    damped.on(&grid, &mut values).unwrap();
    assert_eq!(values[3], damped.at(grid[3]).unwrap());
    assert!(matches!(damped.on(&grid, &mut values[1..]), Err(MotionError::Capacity { .. })));
    // by frequency, and one for all
    let by = response.with_damping_ratios_by(|omega| if omega < 50.0 { 0.02 } else { 0.04 }).unwrap();
    let same = response.with_damping_ratios(&[0.02, 0.04, 0.04, 0.04, 0.04]).unwrap();
    let one = response.with_damping_ratio(0.03).unwrap();
    let all = response.with_damping_ratios(&[0.03; 5]).unwrap();
    for time in [0.0, 0.01, 0.3] {
        assert_eq!(by.to_step(time), same.to_step(time));
        assert_eq!(one.to_impulse(time), all.to_impulse(time));
    }
    let refused = |ratios: &[f64]| response.with_damping_ratios(ratios).unwrap_err();
    assert_eq!(refused(&[0.02; 4]), MotionError::DampingRatios { given: 4, needed: 5 });
    assert!(refused(&[0.02; 4]).to_string().contains("5 roots, and 4 damping ratios"));
    assert_eq!(refused(&[0.02, 0.02, 1.0, 0.02, 0.02]), MotionError::DampingRatio { ratio: 1.0 });
    assert!(matches!(refused(&[0.02, f64::NAN, 0.1, 0.02, 0.02]), MotionError::DampingRatio { .. }));
}

/// Without damping the sum is the exact response less what the modes that were left out add: it vanishes with the square of the frequency.
#[test]
fn sums_without_damping_tend_to_exact_responses() {
    let cantilever = Cantilever {}.build().unwrap();
    let tip = Cantilever::conn_tip;
    let exact = cantilever.frequency_response(tip.force(), tip.deflection()).unwrap();
    let roots = cantilever.first_frequencies::<8>().unwrap();
    let response = cantilever.modal_response::<8, _>(&roots, tip.force(), tip.deflection()).unwrap();
    for omega in [0.0, 5.0, 20.0, 60.0, 200.0] {
        let (found, expected) = (response.at(omega).unwrap(), exact.at(omega).unwrap());
        // Σ_{n > 8} φ²/ω_n⁴ ω², each φ² at most 4/m_moving
        assert!(
            (found - expected).abs() <= 1e-15 + 4.0 * omega * omega / 3900_f64.powi(4),
            "{omega}: {found} {expected}"
        );
    }
    assert!(matches!(response.at(roots[2].omega), Err(MotionError::Resonance { .. })));
    let curve = response.curve::<2000>(1.0..=700.0, 1e-3).unwrap();
    assert!(curve.len() > 30 && curve.iter().all(|sample| response.at(sample.omega).unwrap() == sample.value));
    let damped = response.with_damping_ratio(1e-4).unwrap();
    let curve = damped.curve::<4000>(1.0..=700.0, 1e-3).unwrap();
    for root in &roots[..4] {
        let peak = curve.iter().map(|sample| sample.value.norm()).filter(|value| *value > 0.0);
        let at = damped.at(C::new(0.0, root.omega)).unwrap().norm();
        assert!(peak.fold(0.0, f64::max) >= at * 0.999_999, "no resonance is missed");
    }
}

/// Damping in proportion: the exact response at another frequency, and sums whose residual is late.
#[test]
fn damping_in_proportion_needs_no_modes() {
    let cantilever = Cantilever {}.build().unwrap();
    let tip = Cantilever::conn_tip;
    let exact = cantilever.frequency_response(tip.force(), tip.deflection()).unwrap();
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let response = cantilever.modal_response::<3, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let part = reference("damping")["rayleigh"].clone();
    let damping = ProportionalDamping::new(number(&part["alpha"]), number(&part["beta"]), 0.0).unwrap();
    let damped = response.with_damping(&damping).unwrap();
    for row in part["rows"].as_array().unwrap() {
        let lambda = C::new(0.0, number(&row["omega"]));
        let expected = C::new(number(&row["exact"][0]), number(&row["exact"][1]));
        assert_close(damping.response(&exact, lambda).unwrap(), expected, 1e-13);
        // what the modes that are left out miss is that of the fields, too
        let missed = (damped.at(lambda).unwrap() - expected).norm();
        assert_close(missed, number(&row["modes_and_residual_over_1_beta_lambda_error"]), 1e-4);
    }
}

system! {
    /// The cantilever with damping of its materials and of its masses.
    #[derive(Clone, Copy)]
    struct Rayleigh { alpha: f64, beta: f64, eta: f64 }
    fixed -> beam 1 {
        length: 1.2, bending_stiffness: 180.0, mass_per_length: 2.5, kelvin_voigt_time: beta, external_damping: 2.5 * alpha, loss_factor: eta
    } -> point_mass 2 { mass: 0.8, inertia: 0.0 } -> conn tip -> free;
    fixed -> spring 3 { stiffness: 350.0, kelvin_voigt_time: beta, damping: 0.8 * alpha, loss_factor: eta } -> conn tip;
}

/// The exact response of elements that are damped so, loss factors among them.
#[test]
fn damping_in_proportion_is_that_of_damped_elements() {
    let cantilever = Cantilever {}.build().unwrap();
    let tip = Cantilever::conn_tip;
    let exact = cantilever.frequency_response(tip.force(), tip.deflection()).unwrap();
    for (alpha, beta, eta) in [(0.7, 0.0, 0.0), (0.0, 3e-4, 0.0), (0.4, 2e-4, 0.0), (0.0, 0.0, 0.05), (0.2, 1e-5, 0.02)]
    {
        let damped = Rayleigh { alpha, beta, eta }.build().unwrap();
        let of_elements =
            damped.frequency_response(Rayleigh::conn_tip.force(), Rayleigh::conn_tip.deflection()).unwrap();
        let damping = ProportionalDamping::new(alpha, beta, eta).unwrap();
        for lambda in [C::new(0.0, 3.0), C::new(0.0, 21.0), C::new(0.0, 300.0), C::new(-1.0, 40.0), C::new(2.0, 105.0)]
        {
            let expected = of_elements.at(lambda).unwrap();
            assert_close(damping.response(&exact, lambda).unwrap(), expected, 1e-13);
        }
    }
    let lossy = ProportionalDamping::new(0.0, 0.0, 0.05).unwrap();
    assert_eq!(lossy.response(&exact, C::new(0.0, -3.0)), Err(MotionError::LossFactor));
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let response = cantilever.modal_response::<3, _>(&roots, tip.force(), tip.deflection()).unwrap();
    assert_eq!(response.with_damping(&lossy).err(), Some(MotionError::LossFactor));
}

system! {
    /// A strut.
    struct Strut { force: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 10.0, mass_per_length: 1.0, axial_force: force } -> conn tip -> free;
}

/// An axial force is a stiffness that nothing damps.
#[test]
fn axial_forces_are_refused() {
    let damping = ProportionalDamping::new(0.1, 1e-3, 0.0).unwrap();
    let at = |force: f64| {
        let strut = Strut { force }.build().unwrap();
        let exact = strut.frequency_response(Strut::conn_tip.force(), Strut::conn_tip.deflection()).unwrap();
        damping.response(&exact, C::new(0.0, 2.0))
    };
    assert!(at(0.0).is_ok());
    assert_eq!(at(-1.0), Err(MotionError::AxialForce));
}

system! {
    /// One mass on a spring.
    struct Oscillator { k: f64, m: f64 }
    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free
}

/// Closed forms of a step: `x/x_static = 1 + (λ_b e^{λ_a t} - λ_a e^{λ_b t})/(λ_a - λ_b)`, whether the mass vibrates or creeps.
#[test]
fn one_mass_with_damping_in_proportion() {
    let (k, m) = (100.0, 4.0);
    let oscillator = Oscillator { k, m }.build().unwrap();
    let roots = oscillator.first_frequencies::<1>().unwrap();
    let point = Oscillator::mass_2.output();
    let response = oscillator.modal_response::<2, _>(&roots, point.force(), point.deflection()).unwrap();
    for (alpha, beta) in [(0.3, 1e-3), (0.0, 0.02), (30.0, 0.0), (1.0, 2.0)] {
        let damped = response.with_damping(&ProportionalDamping::new(alpha, beta, 0.0).unwrap()).unwrap();
        let (half, root) = (0.5 * (alpha + beta * k / m), C::from(k / m));
        let split = (C::from(half * half) - root).sqrt();
        let (a, b) = (split - half, -split - half);
        for time in [0.0, 0.01, 0.2, 1.0, 7.0] {
            let expected = (C::ONE + (b * (a * time).exp() - a * (b * time).exp()) / (a - b)).re / k;
            assert!((damped.to_step(time) - expected).abs() < 1e-14 / k, "{alpha} {beta} {time}");
            let expected = (((a * time).exp() - (b * time).exp()) / (a - b)).re / m;
            assert!((damped.to_impulse(time) - expected).abs() < 1e-13, "{alpha} {beta} {time}");
        }
        let lambda = C::new(0.0, 3.0);
        let expected = 1.0 / (lambda * lambda * m + lambda * (alpha * m + beta * k) + k);
        assert_close(damped.at(lambda).unwrap(), expected, 1e-14);
        assert_close(damped.static_value().unwrap(), 1.0 / k, 1e-14);
    }
    // critical, and without room for two terms
    let critical = ProportionalDamping::new(2.0 * (k / m).sqrt(), 0.0, 0.0).unwrap();
    assert_eq!(response.with_damping(&critical).err(), Some(MotionError::Critical { frequency: 5.0 }));
    let full = oscillator.modal_response::<1, _>(&roots, point.force(), point.deflection()).unwrap();
    let creeping = ProportionalDamping::new(30.0, 0.0, 0.0).unwrap();
    assert_eq!(full.with_damping(&creeping).err(), Some(MotionError::Capacity { capacity: 1 }));
}

system! {
    /// A mass that nothing holds.
    struct Alone { m: f64 }
    free -> mass 1 { mass: m } -> free
}

/// Closed form: a free mass in a drag, `x = (t - (1 - e^{-αt})/α)/(mα)`.
#[test]
fn a_free_mass_is_dragged() {
    let (m, alpha) = (3.0, 0.7);
    let alone = Alone { m }.build().unwrap();
    let roots = alone.first_frequencies::<1>().unwrap();
    let point = Alone::mass_1.output();
    let response = alone.modal_response::<2, _>(&roots, point.force(), point.deflection()).unwrap();
    let dragged = response.with_damping(&ProportionalDamping::new(alpha, 0.1, 0.0).unwrap()).unwrap();
    for time in [0.01, 0.5, 4.0] {
        let expected = (time - (1.0 - (-alpha * time).exp()) / alpha) / (m * alpha);
        assert!((dragged.to_step(time) - expected).abs() < 1e-14 * time, "{time}");
    }
    let lambda = C::new(0.0, 2.0);
    assert_close(dragged.at(lambda).unwrap(), 1.0 / (m * lambda * (lambda + alpha)), 1e-14);
    assert!(matches!(dragged.at(C::ZERO), Err(MotionError::Resonance { .. })));
    assert!(matches!(response.at(0.0), Err(MotionError::Resonance { .. })));
    assert_close(response.at(2.0).unwrap(), -1.0 / (m * 4.0), 1e-14);
}

/// Modes that are not in the list are late: histories and steps agree, and a step ends at the static value.
#[test]
fn what_is_not_in_the_list_is_late() {
    let cantilever = Cantilever {}.build().unwrap();
    let tip = Cantilever::conn_tip;
    let roots = cantilever.first_frequencies::<1>().unwrap();
    let response = cantilever.modal_response::<1, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let damped = response.with_damping(&ProportionalDamping::new(0.5, 0.01, 0.0).unwrap()).unwrap();
    assert_eq!(damped.to_step(0.0), 0.0);
    let mut history = damped.history(0.003).unwrap();
    let scale = damped.static_value().unwrap();
    for k in 0..200 {
        let (time, found) = (0.003 * f64::from(k), history.next(1.0));
        assert!((found - damped.to_step(time)).abs() < 1e-13 * scale, "{time}: {found} {}", damped.to_step(time));
    }
    assert_close(damped.to_step(100.0), scale, 1e-12);
    // a sweep of one period of a slow sine is followed as its frequency response says
    let omega = 2.0;
    let mut history = damped.history(0.01).unwrap();
    let at = damped.at(C::new(0.0, omega)).unwrap();
    let steps = (40.0 * PI / omega / 0.01) as u32;
    let last = (0..=steps).fold(0.0, |_, k| history.next((omega * 0.01 * f64::from(k)).cos()));
    let time = 0.01 * f64::from(steps);
    let expected = (at * C::new(0.0, omega * time).exp()).re;
    assert!((last - expected).abs() < 1e-4 * at.norm(), "{last} {expected}");
}

system! {
    /// A beam between clamps, of a damped material, with a mass.
    struct DampedSpan { time: f64, eta: f64 }
    fixed -> beam 1 { length: 1.1, bending_stiffness: 30.0, mass_per_length: 1.7, kelvin_voigt_time: time, loss_factor: eta } -> point_mass 2 { mass: 0.4 }
        -> conn a -> beam 3 { length: 0.7, bending_stiffness: 30.0, mass_per_length: 1.7, kelvin_voigt_time: time, loss_factor: eta } -> fixed;
}

system! {
    struct Span {}
    fixed -> beam 1 { length: 1.1, bending_stiffness: 30.0, mass_per_length: 1.7 } -> point_mass 2 { mass: 0.4 }
        -> conn a -> beam 3 { length: 0.7, bending_stiffness: 30.0, mass_per_length: 1.7 } -> fixed;
}

/// Forces are those of the stiffness and of its damping, as elements of a damped material have them.
#[test]
fn forces_of_damping_are_those_of_damped_elements() {
    let (time, eta) = (2e-3, 0.03);
    let span = Span {}.build().unwrap();
    let damped = |eta| DampedSpan { time, eta }.build().unwrap();
    let loads = [Span::conn_a.force(), Span::beam_1.input().slip(), Load::self_weight()];
    let same = [DampedSpan::conn_a.force(), DampedSpan::beam_1.input().slip(), Load::self_weight()];
    let entries = [Span::beam_3.output().moment(), Span::conn_a.shear(), Span::conn_a.deflection()];
    let twins = [DampedSpan::beam_3.output().moment(), DampedSpan::conn_a.shear(), DampedSpan::conn_a.deflection()];
    let roots = span.first_frequencies::<8>().unwrap();
    for (load, same) in loads.into_iter().zip(same) {
        for (entry, twin) in entries.into_iter().zip(twins) {
            let exact = span.frequency_response(load, entry).unwrap();
            for eta in [0.0, eta] {
                let damping = ProportionalDamping::new(0.0, time, eta).unwrap();
                for omega in [3.0, 21.0, 300.0] {
                    let lambda = C::new(0.0, omega);
                    let expected = damped(eta).frequency_response(same, twin).unwrap().at(lambda).unwrap();
                    assert_close(damping.response(&exact, lambda).unwrap(), expected, 1e-11);
                }
            }
            // the sum over modes has it, too, as far as its list goes
            let damping = ProportionalDamping::new(0.4, time, 0.0).unwrap();
            let plain = span.modal_response::<8, _>(&roots, load, entry).unwrap();
            let sum = plain.with_damping(&damping).unwrap();
            for omega in [0.0, 3.0, 21.0, 60.0] {
                let lambda = C::new(0.0, omega);
                let expected = damping.response(&exact, lambda).unwrap();
                // what the list leaves out without damping, far from resonances
                let left_out = (plain.at(omega).unwrap() - exact.at(omega).unwrap()).abs();
                let error = (sum.at(lambda).unwrap() - expected).norm();
                assert!(error <= 1.5 * left_out + 1e-3 * expected.norm(), "{omega}: {error} {left_out} {expected}");
            }
        }
    }
    // what is damped already, and what bears an axial force
    let damping = ProportionalDamping::new(0.3, 1e-3, 0.0).unwrap();
    let twice = damped(0.0);
    let exact = twice.frequency_response(same[0], twins[2]).unwrap();
    assert_eq!(damping.response(&exact, C::new(0.0, 3.0)), Err(MotionError::Damped));
    let strut = Strut { force: -5.0 }.build().unwrap();
    let (load, entry) = (Strut::beam_1.output().force(), Strut::beam_1.output().deflection());
    let roots = strut.first_frequencies::<3>().unwrap();
    let sum = strut.modal_response::<4, _>(&roots, load, entry).unwrap();
    assert_eq!(sum.with_damping(&damping).unwrap_err(), MotionError::AxialForce);
    let of_masses = ProportionalDamping::new(0.3, 0.0, 0.0).unwrap();
    let exact = strut.frequency_response(load, entry).unwrap();
    let lambda = C::new(0.0, 3.0);
    assert_close(
        of_masses.response(&exact, lambda).unwrap(),
        sum.with_damping(&of_masses).unwrap().at(lambda).unwrap(),
        1e-4,
    );
}
