//! Uniform beams against series over modes known in closed form.

use super::assert_close;
use mstmm::prelude::*;

system! {
    #[derive(Clone, Copy, Debug)]
    pub struct Cantilever { l: f64, ei: f64, m: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> free;
}

system! {
    #[derive(Clone, Copy, Debug)]
    pub struct FreeBeam { l: f64, ei: f64, m: f64 }
    free -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> free;
}

const L: f64 = 1.7;
const EI: f64 = 33.0;
const M: f64 = 0.4;
const MODES: usize = 200;

/// The root of `cos β = sign/cosh β` next to a guess, by Newton's method.
fn wave_number(guess: f64, sign: f64) -> f64 {
    (0..20).fold(guess, |beta, _| {
        let sech = beta.cosh().recip();
        beta - (beta.cos() - sign * sech) / (-beta.sin() + sign * sech * beta.tanh())
    })
}

/// ω of a wave number times the length.
fn omega(beta: f64) -> f64 {
    beta * beta * (EI / M).sqrt() / (L * L)
}

/// A mode of the cantilever: ω, and deflection and rotation of its tip for unit modal mass.
fn cantilever_mode(k: usize) -> (f64, f64, f64) {
    let beta = wave_number((k as f64 + 0.5) * std::f64::consts::PI, -1.0);
    let (sech, tanh) = (beta.cosh().recip(), beta.tanh());
    let common = 2.0 / (tanh + beta.sin() * sech) / (M * L).sqrt();
    (omega(beta), common * (beta.sin() - beta.cos() * tanh), common * beta / L * beta.sin() * tanh)
}

/// Oracle: 200 modes of Bernoulli's cantilever, with forces and moments at its tip.
#[test]
fn the_tip_of_a_cantilever_is_a_series_over_its_modes() {
    let system = Cantilever { l: L, ei: EI, m: M }.build().unwrap();
    let tip = Cantilever::beam_1.output();
    let roots = system.first_frequencies::<MODES>().unwrap();
    let modes: Vec<_> = (0..MODES).map(cantilever_mode).collect();
    let at = |load, entry| system.modal_response::<MODES, _>(&roots, load, entry).unwrap();
    let pairs = [
        (at(tip.force(), tip.deflection()), [true, true]),
        (at(tip.torque(), tip.deflection()), [false, true]),
        (at(tip.force(), tip.rotation()), [true, false]),
        (at(tip.torque(), tip.rotation()), [false, false]),
    ];
    for (response, of) in &pairs {
        for t in [1e-4, 0.01, 0.2, 1.0] {
            let (mut step, mut impulse, mut size) = (0.0, 0.0, [0.0, 0.0]);
            for (omega, deflection, rotation) in &modes {
                let product: f64 = of.iter().map(|y| if *y { deflection } else { rotation }).product();
                let half = (0.5 * omega * t).sin();
                step += product * 2.0 * half * half / (omega * omega);
                impulse += product * (omega * t).sin() / omega;
                // the phase takes on the rounding of ω
                size[0] += product.abs() * (2.0 + omega * t) / (omega * omega);
                size[1] += product.abs() * (2.0 + omega * t) / omega;
            }
            assert_close(response.to_step(t), step, size[0], 16.0);
            assert_close(response.to_impulse(t), impulse, size[1], 16.0);
        }
    }
    // Σ 4/β⁴ over the modes that are left out, as an integral
    let tail =
        4.0 / (3.0 * (std::f64::consts::PI * (MODES as f64 - 0.5)).powi(3) * std::f64::consts::PI) * L.powi(3) / EI;
    let rest = L.powi(3) / (3.0 * EI) - pairs[0].0.static_value().unwrap();
    assert!(rest > 0.0 && rest < tail, "{rest:e} {tail:e}");
}

/// Closed form: the moment at the clamp is the lever. Its series alternates, so that the first term left out bounds the rest.
#[test]
fn moments_converge_slowly_but_to_the_right_value() {
    let system = Cantilever { l: L, ei: EI, m: M }.build().unwrap();
    let (clamp, tip) = (Cantilever::beam_1.input(), Cantilever::beam_1.output());
    let roots = system.first_frequencies::<MODES>().unwrap();
    let response = system.modal_response::<MODES, _>(&roots, tip.force(), clamp.moment()).unwrap();
    let error = (response.static_value().unwrap() / L - 1.0).abs();
    assert!(error < 4.0 / ((MODES as f64 + 0.5) * std::f64::consts::PI).powi(2), "{error:e}");
}

/// Oracle: the beam as a rigid rod of mass `m l`, whose end yields `4 t/(m l)`, and its bending modes, whose ends move by 2
/// over the root of that mass.
#[test]
fn a_free_beam_moves_off_and_vibrates() {
    let system = FreeBeam { l: L, ei: EI, m: M }.build().unwrap();
    let (left, right) = (FreeBeam::beam_1.input(), FreeBeam::beam_1.output());
    let mass = M * L;
    let roots = system.first_frequencies::<40>().unwrap();
    assert_eq!(roots[0].multiplicity, 2);
    let near = system.modal_response::<40, _>(&roots, left.force(), left.deflection()).unwrap();
    let far = system.modal_response::<40, _>(&roots, left.force(), right.deflection()).unwrap();
    for t in [1e-3, 0.05, 0.4, 3.0] {
        let (mut here, mut there) = (4.0 * t / mass, -2.0 * t / mass);
        let (mut here_to_step, mut size) = (2.0 * t * t / mass, (t + t * t) / mass);
        for k in 0..38 {
            let omega = omega(wave_number((k as f64 + 1.5) * std::f64::consts::PI, 1.0));
            let half = (0.5 * omega * t).sin();
            here += 4.0 / mass * (omega * t).sin() / omega;
            there += if k % 2 == 0 { 4.0 } else { -4.0 } / mass * (omega * t).sin() / omega;
            here_to_step += 8.0 / mass * half * half / (omega * omega);
            size += 4.0 / mass * (2.0 + omega * t) / omega;
        }
        assert_close(near.to_impulse(t), here, size, 16.0);
        assert_close(far.to_impulse(t), there, size, 16.0);
        assert_close(near.to_step(t), here_to_step, size, 16.0);
    }
}
