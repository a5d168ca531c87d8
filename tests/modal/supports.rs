//! Motions of supports: what damps a mode moves with them.

use crate::models::{Portal, assert_close, oscillator};
use mstmm::Complex;
use mstmm::frame::{Frame, Section};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm::search::ProportionalDamping;

type C = Complex<f64>;

/// Closed form of one mass on a spring whose other end moves, with a dashpot beside the spring: `(1 + 2iζx)/(1 - x² + 2iζx)`.
#[test]
fn a_ratio_damps_relative_to_the_support() {
    let (k, m, ratio) = (900.0, 4.0, 0.1);
    let (frame, [foot, mass]) = oscillator(k, m);
    let system = frame.build().unwrap();
    let roots = system.first_frequencies::<1>().unwrap();
    let omega = (k / m).sqrt();
    assert_close(roots[0].omega, omega, 1e-15);
    let response = system.modal_response::<2, _>(&roots, foot.motion_x(), mass.displacement_x()).unwrap();
    let damped = response.with_damping_ratio(ratio).unwrap();
    for x in [0.0, 0.3, 0.9, 1.0, 1.1, 2.0, 10.0] {
        let part = C::new(0.0, 2.0 * ratio * x);
        let expected = (1.0 + part) / (1.0 - x * x + part);
        assert_close(damped.at(C::new(0.0, x * omega)).unwrap(), expected, 1e-13);
    }
    // at its resonance it is 5.099, not 5
    let peak = damped.at(C::new(0.0, omega)).unwrap().norm();
    assert_close(peak, (1.0 + 4.0 * ratio * ratio).sqrt() / (2.0 * ratio), 1e-13);
    // a step of the support: 1 - e^{-ζωt} (cos ω_d t - ζ/√(1-ζ²) sin ω_d t)
    let slowed = (1.0 - ratio * ratio).sqrt();
    for time in [0.0, 0.01, 0.1, 0.7] {
        let (sin, cos) = (omega * slowed * time).sin_cos();
        let expected = 1.0 - (-ratio * omega * time).exp() * (cos - ratio / slowed * sin);
        assert!((damped.to_step(time) - expected).abs() < 1e-13, "{time}");
    }
    // in proportion to the stiffness it is the same, and to the mass the drag moves along
    let (alpha, beta) = (0.8, 2e-3);
    let damping = ProportionalDamping::new(alpha, beta, 0.0).unwrap();
    let sum = response.with_damping(&damping).unwrap();
    let exact = system.frequency_response(foot.motion_x(), mass.displacement_x()).unwrap();
    for omega in [0.0, 3.0, 15.0, 40.0] {
        let lambda = C::new(0.0, omega);
        let drag = lambda * (alpha * m + beta * k);
        let expected = (drag + k) / (lambda * lambda * m + drag + k);
        assert_close(sum.at(lambda).unwrap(), expected, 1e-13);
        assert_close(damping.response(&exact, lambda).unwrap(), expected, 1e-13);
    }
}

/// A structure of many modes: the sum with a small ratio is near the exact response with damping of the material, where a support moves.
#[test]
fn sums_of_moved_frames_tend_to_responses_of_damped_materials() {
    let portal = Portal {}.build().unwrap();
    let roots = portal.first_frequencies::<9>().unwrap();
    let (load, entry) = (Portal::conn_a.motion_x(), Portal::conn_c.displacement_x());
    let response = portal.modal_response::<9, _>(&roots, load, entry).unwrap();
    let exact = portal.frequency_response(load, entry).unwrap();
    let damping = ProportionalDamping::new(0.3, 4e-5, 0.0).unwrap();
    let sum = response.with_damping(&damping).unwrap();
    for omega in [0.0, 10.0, 39.2, 120.0, 193.0, 300.0] {
        let lambda = C::new(0.0, omega);
        let expected = damping.response(&exact, lambda).unwrap();
        let error = (sum.at(lambda).unwrap() - expected).norm();
        // the modes that are left out are beyond 1,500 rad/s
        assert!(error <= 1e-12 + 0.2 * (omega / 1500.0).powi(2), "{omega}: {error:e} beside {}", expected.norm());
    }
    // the same with the damping in the materials of a frame
    let mut frame = Frame::new();
    let [a, b, c, d] = [[0.0, 0.0], [0.0, 3.0], [4.0, 3.0], [4.0, 0.0]].map(|place| frame.point(place));
    let steel =
        Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0).kelvin_voigt_time(4e-5);
    for ends in [[a, b], [b, c], [c, d]] {
        frame.member(ends[0], ends[1], steel);
    }
    frame.mass(b, 100.0);
    frame.hold(a, Support::Fixed);
    frame.hold(d, Support::Pinned);
    let damped = frame.build_damped().unwrap();
    let of_material = damped.frequency_response(a.motion_x(), c.displacement_x()).unwrap();
    let stiffness = ProportionalDamping::new(0.0, 4e-5, 0.0).unwrap();
    for omega in [1.0, 39.2, 193.0, 600.0] {
        let lambda = C::new(0.0, omega);
        assert_close(stiffness.response(&exact, lambda).unwrap(), of_material.at(lambda).unwrap(), 1e-12);
    }
}
