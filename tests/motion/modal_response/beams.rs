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

/// Oracle: 200 modes of Bernoulli's cantilever, with forces and moments at its tip, and what they leave of its static deflection.
#[test]
fn the_tip_of_a_cantilever_is_a_series_over_its_modes() {
    let system = Cantilever { l: L, ei: EI, m: M }.build().unwrap();
    let tip = Cantilever::beam_1.output();
    let roots = system.first_frequencies::<MODES>().unwrap();
    let modes: Vec<_> = (0..MODES).map(cantilever_mode).collect();
    let at = |load, entry| system.modal_response::<MODES, _>(&roots, load, entry).unwrap();
    let pairs = [
        (at(tip.force(), tip.deflection()), [true, true], L.powi(3) / (3.0 * EI)),
        (at(tip.torque(), tip.deflection()), [false, true], L.powi(2) / (2.0 * EI)),
        (at(tip.force(), tip.rotation()), [true, false], L.powi(2) / (2.0 * EI)),
        (at(tip.torque(), tip.rotation()), [false, false], L / EI),
    ];
    for (response, of, at_rest) in &pairs {
        assert_close(response.static_value().unwrap(), *at_rest, *at_rest, 64.0);
        for t in [1e-4, 0.01, 0.2, 1.0] {
            let (mut step, mut impulse, mut size) = (*at_rest, 0.0, [*at_rest, 0.0]);
            for (omega, deflection, rotation) in &modes {
                let product: f64 = of.iter().map(|y| if *y { deflection } else { rotation }).product();
                let half = (0.5 * omega * t).sin();
                step += product * (2.0 * half * half - 1.0) / (omega * omega);
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
    let rest = pairs[0].0.to_step(0.0);
    assert!(rest > 0.0 && rest < tail, "{rest:e} {tail:e}");
}

/// Closed form: the moment at the clamp is the lever. Its series alternates, so that the first term left out bounds the rest, which
/// the residual compliance makes up for.
#[test]
fn moments_are_complete_however_few_modes_there_are() {
    fn check<const N: usize>() {
        let system = Cantilever { l: L, ei: EI, m: M }.build().unwrap();
        let (clamp, tip) = (Cantilever::beam_1.input(), Cantilever::beam_1.output());
        let roots = system.first_frequencies::<N>().unwrap();
        let response = system.modal_response::<N, _>(&roots, tip.force(), clamp.moment()).unwrap();
        let exact = system.frequency_response(tip.force(), clamp.moment()).unwrap().at(0.0).unwrap();
        let value = response.static_value().unwrap();
        assert!((value / exact - 1.0).abs() < 1e-12 && (value / L - 1.0).abs() < 1e-12, "{value}");
        let left_out = (response.to_step(0.0) / L).abs();
        let wave_number = (N as f64 + 0.5) * std::f64::consts::PI;
        assert!(left_out > 0.0 && left_out < 4.0 / wave_number.powi(2), "{left_out:e}");
    }
    check::<1>();
    check::<2>();
    check::<10>();
    check::<200>();
}

/// Oracle: 400 modes. Under a force that rises in ten periods of the first mode left out, the moment at the clamp is better by
/// orders with the residual compliance than without: what is left out errs by the square of the ratio of periods.
#[test]
fn a_truncated_sum_of_moments_is_better_for_its_residual() {
    const FEW: usize = 4;
    let system = Cantilever { l: L, ei: EI, m: M }.build().unwrap();
    let (clamp, tip) = (Cantilever::beam_1.input(), Cantilever::beam_1.output());
    let roots = system.first_frequencies::<400>().unwrap();
    let whole = system.modal_response::<400, _>(&roots, tip.force(), clamp.moment()).unwrap();
    let few = system.modal_response::<FEW, _>(&roots[..FEW], tip.force(), clamp.moment()).unwrap();
    let period = std::f64::consts::TAU / roots[FEW].omega;
    let (rise, dt) = (10.0 * period, period / 100.0);
    let force = |t: f64| if t < rise { 0.5 * (1.0 - (t / rise * std::f64::consts::PI).cos()) } else { 1.0 };
    let (mut with, mut without) = (0.0_f64, 0.0_f64);
    let (mut whole, mut truncated) = (whole.history(dt).unwrap(), few.history(dt).unwrap());
    for n in 0..2000 {
        let own = force(f64::from(n) * dt);
        let (expected, actual) = (whole.next(own), truncated.next(own));
        with = with.max((actual - expected).abs());
        without = without.max((actual - few.to_step(0.0) * own - expected).abs());
    }
    assert!(with < 0.01 * without, "{with:e} {without:e}");
}

/// Oracle: the beam as a rigid rod of mass `m l`, whose end yields `4 t/(m l)`, and its bending modes, whose ends move by 2
/// over the root of that mass. All of them together bend the ends by `4 l³/EI Σ 1/β⁴ = l³/(105 EI)` and `l³/(140 EI)`, from the series
/// of `cos β cosh β` and, for the symmetric ones, of `sin(β/2) cosh(β/2) + cos(β/2) sinh(β/2)`.
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
        let bent = [L.powi(3) / (105.0 * EI), L.powi(3) / (140.0 * EI)];
        let mut to_step = [bent[0] + 2.0 * t * t / mass, bent[1] - t * t / mass];
        let mut size = (t + t * t) / mass + bent[0];
        for k in 0..38 {
            let omega = omega(wave_number((k as f64 + 1.5) * std::f64::consts::PI, 1.0));
            let half = (0.5 * omega * t).sin();
            here += 4.0 / mass * (omega * t).sin() / omega;
            let product = [4.0, if k % 2 == 0 { 4.0 } else { -4.0 }].map(|product| product / mass);
            there += product[1] * (omega * t).sin() / omega;
            for (sum, product) in to_step.iter_mut().zip(product) {
                *sum += product * (2.0 * half * half - 1.0) / (omega * omega);
            }
            size += 4.0 / mass * (2.0 + omega * t) / omega;
        }
        assert_close(near.to_impulse(t), here, size, 16.0);
        assert_close(far.to_impulse(t), there, size, 16.0);
        assert_close(near.to_step(t), to_step[0], size, 16.0);
        assert_close(far.to_step(t), to_step[1], size, 16.0);
    }
}
