//! Shapes, responses and sensitivities through hinges of one freedom and levers, in closed form.

use crate::hinged_models::{Gerber, Sliding};
use mstmm::motion::MotionError;
use mstmm::prelude::*;

#[track_caller]
fn assert_close(actual: f64, expected: f64, size: f64) {
    assert!((actual - expected).abs() <= 1e-11 * size, "{actual} is not {expected}");
}

/// Solutions of `cos z ch z = -1`.
fn cantilever(k: usize) -> f64 {
    let (start, sign) = ((k as f64 + 0.5) * core::f64::consts::PI, if k.is_multiple_of(2) { 1.0 } else { -1.0 });
    (0..60).fold(start, |z, _| start + sign * (1.0 / z.cosh()).asin())
}

/// Closed form: in symmetric modes each half is a cantilever, `ch - cos - σ (sh - sin)` with `σ = (ch z + cos z)/(sh z + sin z)`; the
/// moment at its end is zero, and the slope jumps to its opposite.
#[test]
fn the_slope_jumps_at_a_perfect_hinge() {
    let system = Gerber { stiffness: 0.0 }.build().unwrap();
    let roots = system.first_frequencies::<8>().unwrap();
    for k in 0..4 {
        let z = cantilever(k);
        let root = roots.iter().find(|root| (root.omega / (z * z) - 1.0).abs() < 1e-12).unwrap();
        let shape = system.mode_shape(root).unwrap();
        let [before, after] = [Gerber::hinge_2.input(), Gerber::hinge_2.output()].map(|point| shape.state(point));
        let sigma = (z.cosh() + z.cos()) / (z.sinh() + z.sin());
        let deflection = z.cosh() - z.cos() - sigma * (z.sinh() - z.sin());
        let slope = z * (z.sinh() + z.sin() - sigma * (z.cosh() - z.cos()));
        assert_close(before.theta, before.y * slope / deflection, before.theta.abs());
        assert_close(after.theta, -before.theta, before.theta.abs());
        assert_close(after.y, before.y, before.y.abs());
        for state in [before, after] {
            assert_close(state.m, 0.0, z * z * before.y.abs());
            assert_close(state.q, 0.0, z * z * z * before.y.abs());
        }
    }
}

/// The moment at a hinge is its stiffness times the jump of the slope, the force at a shear hinge likewise; the share of the strain is
/// the square of the jump times the stiffness, over ω² times the modal mass.
#[test]
fn forces_of_hinges_are_stiffness_times_jump() {
    for stiffness in [1e-3, 0.25, 3.0, 100.0] {
        let system = Gerber { stiffness }.build().unwrap();
        for root in &system.first_frequencies::<6>().unwrap() {
            let shape = system.mode_shape(root).unwrap();
            let hinge = Gerber::hinge_2;
            let [before, after] = [hinge.input(), hinge.output()].map(|point| shape.state(point));
            let (jump, size) = (after.theta - before.theta, root.omega * (before.y.abs() + after.theta.abs()));
            assert_close(before.m, stiffness * jump, size);
            for [one, other] in [[before.y, after.y], [before.m, after.m], [before.q, after.q]] {
                assert_close(one, other, root.omega.powf(1.5) * size);
            }
            let strain = stiffness * jump * jump / (root.omega * root.omega * shape.modal_mass());
            assert_close(shape.energy_shares(hinge).strain, strain, 1.0);
        }
        let system = Sliding { stiffness }.build().unwrap();
        for root in &system.first_frequencies::<6>().unwrap() {
            let shape = system.mode_shape(root).unwrap();
            let hinge = Sliding::hinge_2;
            let [before, after] = [hinge.input(), hinge.output()].map(|point| shape.state(point));
            let size = root.omega.powf(1.5) * (before.y.abs() + after.y.abs() + before.theta.abs());
            assert_close(before.q, stiffness * (before.y - after.y), size);
            for [one, other] in [[before.theta, after.theta], [before.m, after.m], [before.q, after.q]] {
                assert_close(one, other, size);
            }
            let strain = stiffness * (after.y - before.y).powi(2) / (root.omega * root.omega * shape.modal_mass());
            assert_close(shape.energy_shares(hinge).strain, strain, 1.0);
        }
    }
}

/// Closed form: `z (1 + cos ch) + 2K (cos sh + sin ch) = 0` gives `dω/dK = 4 (sin - th/ch)/(sin + th/ch)` at K = 0, and
/// `z³ (1 + cos ch) - 2K (cos sh - sin ch) = 0` gives `4/z²`. Modes without a jump do not feel their hinge.
#[test]
fn a_perfect_hinge_has_a_derivative() {
    let (gerber, sliding) = (Gerber { stiffness: 0.0 }.build().unwrap(), Sliding { stiffness: 0.0 }.build().unwrap());
    let (roots, others) = (gerber.first_frequencies::<8>().unwrap(), sliding.first_frequencies::<8>().unwrap());
    for k in 0..4 {
        let z = cantilever(k);
        let is_own = |omega: f64| (omega / (z * z) - 1.0).abs() < 1e-12;
        let decaying = z.tanh() / z.cosh();
        let root = roots.iter().find(|root| is_own(root.omega)).unwrap();
        let slope = gerber.sensitivity(root).unwrap().get("stiffness").unwrap();
        let expected = 4.0 * (z.sin() - decaying) / (z.sin() + decaying);
        assert_close(slope, expected, expected.abs());
        let root = others.iter().find(|root| is_own(root.omega)).unwrap();
        let slope = sliding.sensitivity(root).unwrap().get("stiffness").unwrap();
        assert_close(slope, 4.0 / (z * z), 4.0 / (z * z));
    }
    let pinned = roots.iter().find(|root| (root.omega - 15.418_205_716_9).abs() < 1e-6).unwrap();
    assert_close(gerber.sensitivity(pinned).unwrap().get("stiffness").unwrap(), 0.0, 1.0);
    let guided = others.iter().find(|root| (root.omega - 5.593_321_376_2).abs() < 1e-6).unwrap();
    assert_close(sliding.sensitivity(guided).unwrap().get("stiffness").unwrap(), 0.0, 1.0);
}

system! {
    /// A Gerber beam on three supports: the second beam rests on the end of the first.
    struct Spans { a: f64, b: f64, stiffness: f64 }
    fixed -> beam 1 { length: a, bending_stiffness: 2.0, mass_per_length: 1.0 }
          -> hinge 2 { stiffness_rz: stiffness }
          -> beam 3 { length: b, bending_stiffness: 2.0, mass_per_length: 1.0 } -> pinned;
}

system! {
    /// A cantilever with a crack, a slide and a lever at its end.
    struct Jointed { a: f64, b: f64, crack: f64, slide: f64, lever: f64 }
    fixed -> beam 1 { length: a, bending_stiffness: 2.0, mass_per_length: 1.0 }
          -> hinge 2 { stiffness_rz: crack } -> hinge 3 { stiffness_y: slide }
          -> beam 4 { length: b, bending_stiffness: 2.0, mass_per_length: 1.0 } -> rigid_link 5 { output_x: lever } -> free;
}

/// Closed form: under a force at a perfect hinge the first beam is a cantilever, `δ = F a³/(3EI)`, and the second turns as a rod.
#[test]
fn a_gerber_beam_carries_a_force_at_its_hinge_alone() {
    let (a, b) = (1.5, 0.75);
    let system = Spans { a, b, stiffness: 0.0 }.build().unwrap();
    let hinge = Spans::hinge_2;
    let value = |entry| system.frequency_response(hinge.output().force(), entry).unwrap().at(0.0).unwrap();
    let deflection = a * a * a / 6.0;
    assert_close(value(hinge.input().deflection()), deflection, deflection);
    assert_close(value(hinge.output().deflection()), deflection, deflection);
    assert_close(value(hinge.input().rotation()), a * a / 4.0, 1.0);
    assert_close(value(hinge.output().rotation()), -deflection / b, 1.0);
    assert_close(value(hinge.output().moment()), 0.0, 1.0);
    // a torque behind the hinge is carried by a force at the hinge, T/b
    let torque = system.frequency_response(hinge.output().torque(), hinge.input().deflection()).unwrap();
    assert_close(torque.at(0.0).unwrap(), -deflection / b, 1.0);
}

/// Closed form: compliances add up, `L³/(3EI) + (b + c)²/K + 1/k` at the end of a lever c, with what the elastic part does there.
#[test]
fn compliances_add_up() {
    let Jointed { a, b, crack, slide, lever } = Jointed { a: 0.75, b: 1.25, crack: 3.0, slide: 7.0, lever: 0.5 };
    for lever in [lever, 0.0, -lever] {
        let system = Jointed { a, b, crack, slide, lever }.build().unwrap();
        let end = Jointed::rigid_link_5.output();
        let (length, ei) = (a + b, 2.0);
        let elastic = length * (length * length / 3.0 + lever * length + lever * lever) / ei;
        let expected = elastic + (b + lever).powi(2) / crack + 1.0 / slide;
        let response = system.frequency_response(end.force(), end.deflection()).unwrap();
        assert_close(response.at(0.0).unwrap(), expected, expected);
        let rotation = system.frequency_response(end.force(), end.rotation()).unwrap().at(0.0).unwrap();
        let turning = length * (0.5 * length + lever) / ei + (b + lever) / crack;
        assert_close(rotation, turning, 10.0);
    }
}

system! {
    /// A beam that hangs on a perfect hinge at a free end.
    struct Loose { length: f64 }
    free -> hinge 1 { stiffness_rz: 0.0 } -> beam 2 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
}

/// What turns without stiffness or inertia has no response.
#[test]
fn a_massless_mechanism_does_not_respond() {
    let system = Loose { length: 1.0 }.build().unwrap();
    let end = Loose::beam_2.input();
    let response = system.frequency_response(end.force(), end.deflection()).unwrap();
    assert!(matches!(response.at(2.0), Err(MotionError::Resonance { .. })), "{:?}", response.at(2.0));
}
