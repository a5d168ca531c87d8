//! Stiffnesses of members at complex frequencies, by exact solutions of their equations.
//!
//! `y = e^(kx)` solves the equation of a beam for four numbers k. With the displacements that it has at both ends the stiffness has to give its forces:
//! no function of the stiffness is in that.

use crate::element::{BeamNumbers, DampingNumbers, LineNumbers, SpinNumbers};
use crate::proof::ball::Ball;
use crate::proof::disc::bending::bending;
use crate::proof::disc::complex::ComplexBall;
use crate::proof::disc::general::Piece;
use crate::proof::disc::line::line;
use crate::proof::disc::member::{Frequency, Member};
use crate::proof::four_words::FourWords;
use crate::proof::level::Level;
use crate::proof::member::place;
use crate::proof::number::{OneWord, TwoWords};
use crate::proof::tests::discs::exact_complex::{ExactComplex, points};
use crate::proof::tests::exact::Exactly;
use crate::proof::tests::random::Random;

/// How far the forces of a stiffness, over a factor, are from those of a solution, in what its radii allow; none where nothing is known.
fn used<N: Exactly + Level<Word = f64>, const F: usize, const E: usize>(
    member: &Member<N, E>,
    displacements: &[ExactComplex; F],
    forces: &[ExactComplex; F],
) -> Option<f64> {
    let mut most = 0.0f64;
    for row in 0..F {
        let (mut rest, mut allowed) = (forces[row].clone(), 0.0);
        for column in 0..F {
            let entry = member.stiffness[place(row, column)];
            rest = &rest - &(&ExactComplex::centre(entry) * &displacements[column]);
            allowed += entry.rad * displacements[column].size();
        }
        if !(member.is_known() && allowed.is_finite()) {
            return None;
        }
        most = most.max(rest.size() / allowed);
    }
    Some(most)
}

fn one() -> ExactComplex {
    ExactComplex::of(1.0, 0.0)
}

/// Looks at a line, `w²` in a ball.
fn check_line<N: Exactly + Level<Word = f64>>(y: ComplexBall<N>) -> Option<f64> {
    let member = line(y);
    let mut most = 0.0f64;
    for y in &points(y) {
        for w in [y.sqrt(), -&y.sqrt()] {
            let end = w.exp();
            let forces = [-&w, &w * &end];
            most = most.max(used(&member, &[one(), end], &forces)?);
        }
    }
    Some(most)
}

/// Looks at a plain beam, `z⁴` in a ball.
fn check_bending<N: Exactly + Level<Word = f64>>(x: ComplexBall<N>) -> Option<f64> {
    let member = bending(x);
    let mut most = 0.0f64;
    for x in &points(x) {
        let z = x.sqrt().sqrt();
        let turned = &z * &ExactComplex::of(0.0, 1.0);
        for k in [-&z, z, -&turned, turned] {
            let (end, square) = (k.exp(), &k * &k);
            let cube = &square * &k;
            let displacements = [one(), k.clone(), end.clone(), &k * &end];
            let forces = [cube.clone(), -&square, -&(&cube * &end), &square * &end];
            most = most.max(used(&member, &displacements, &forces)?);
        }
    }
    Some(most)
}

/// A complex number of some decades, at any angle, near the imaginary axis, or real.
fn argument<N: Level<Word = f64>>(random: &mut Random, decades: f64) -> ComplexBall<N> {
    let size = 10f64.powf(decades * random.signed());
    let (re, im) = match random.below(4) {
        0 => (size * random.signed(), size * random.signed()),
        1 => (size, size * 1e-3 * random.signed()),
        2 => (-size, size * 1e-3 * random.signed()),
        _ => (size * random.signed(), 0.0),
    };
    let ball = ComplexBall::exactly(N::of(re), N::of(im));
    let rad = if random.below(3) == 0 { ball.size() * 10f64.powf(-2.0 - 25.0 * random.unit()) } else { 0.0 };
    ComplexBall { rad, ..ball }
}

fn check_members<N: Exactly + Level<Word = f64>>(runs: usize) {
    let mut random = Random::new(13);
    let (mut most, mut known) = ([0.0f64; 2], [0; 2]);
    for _ in 0..runs {
        let found = [check_line(argument::<N>(&mut random, 3.5)), check_bending(argument::<N>(&mut random, 5.0))];
        for (k, share) in found.into_iter().enumerate() {
            let Some(share) = share else { continue };
            assert!(share <= 1.0, "{}: member {k} uses {share}", N::NAME);
            (most[k], known[k]) = (most[k].max(share), known[k] + 1);
        }
    }
    std::println!("{}: lines and beams use {most:.3?}, of {runs} {known:?} are known", N::NAME);
    assert!(known.iter().all(|known| 2 * known >= runs));
}

#[test]
fn lines_and_beams_give_the_forces_of_exact_solutions() {
    check_members::<OneWord>(60);
    check_members::<TwoWords<f64>>(100);
    check_members::<FourWords>(30);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_lines_and_beams_give_the_forces_of_exact_solutions() {
    check_members::<OneWord>(3_000);
    check_members::<TwoWords<f64>>(10_000);
    check_members::<FourWords>(1_000);
}

/// Parameters of a general beam with damping.
fn parameters(random: &mut Random) -> (BeamNumbers, DampingNumbers) {
    let mut some = |most: f64, chance: usize| [if random.below(chance) > 0 { most * random.unit() } else { 0.0 }, 0.0];
    let ([flexibility, _], rotary_inertia) = (some(0.3, 3), some(0.3, 3));
    let beam = BeamNumbers {
        length: [1.0, 0.0],
        bending_stiffness: [0.5 + some(1.0, 9)[0], 0.0],
        mass_per_length: [0.3 + some(1.0, 9)[0], 0.0],
        axial_stiffness: [0.0; 2],
        shear_stiffness: [if flexibility > 0.0 { 1.0 / flexibility } else { 0.0 }, 0.0],
        rotary_inertia,
        axial_force: [some(2.0, 3)[0] - some(1.0, 2)[0], 0.0],
        shear_layer: some(1.0, 3),
        foundation_stiffness: some(3.0, 3),
    };
    (
        beam,
        DampingNumbers {
            loss_factor: some(0.5, 3),
            time: some(0.3, 3),
            viscous: some(2.0, 3),
            ..DampingNumbers::default()
        },
    )
}

/// The pieces of general beams by `Y' = σΘ - τQ`, `Θ' = M`, `M' = gΘ + σQ`, `Q' = hY` with the parameters themselves.
fn check_pieces<N: Exactly + Level<Word = f64>>(runs: usize) {
    let mut random = Random::new(14);
    let (mut most, mut known) = (0.0f64, 0);
    for run in 0..runs {
        let (beam, damping) = parameters(&mut random);
        let lambda = argument::<N>(&mut random, 0.4);
        let length = 0.2 + 0.8 * random.unit();
        let piece = Piece::of(&Frequency::new(lambda), (&beam, &damping, &SpinNumbers::NONE), Ball::of(length));
        let member = piece.stiffness();
        for lambda in &points(lambda) {
            let parameter = |pair: [f64; 2]| ExactComplex::of(pair[0], 0.0);
            let [loss, time, viscous] = [damping.loss_factor, damping.time, damping.viscous].map(parameter);
            let e = &(&one() + &(&loss * &ExactComplex::of(0.0, 1.0))) * &(&one() + &(&time * lambda));
            let stiffness = &e * &parameter(beam.bending_stiffness);
            let f = if beam.shears() { &one() / &(&parameter(beam.shear_stiffness) * &e) } else { parameter([0.0; 2]) };
            let tension = &parameter(beam.axial_force) + &parameter(beam.shear_layer);
            let l = ExactComplex::of(length, 0.0);
            let scale = &(&l * &l) / &stiffness;
            let square = lambda * lambda;
            let sigma = &one() / &(&one() + &(&tension * &f));
            let tau = &(&f * &sigma) / &scale;
            let g = &(&(&sigma * &tension) + &(&parameter(beam.rotary_inertia) * &square)) * &scale;
            let load = &(&(&parameter(beam.mass_per_length) * &square) + &(&viscous * lambda))
                + &parameter(beam.foundation_stiffness);
            let h = -&(&(&load * &scale) * &(&l * &l));
            // κ² - (g - τh) κ - h (σ² + τg) = 0
            let sum = &g - &(&tau * &h);
            let cut = &(&sigma * &sigma) + &(&tau * &g);
            let four = ExactComplex::of(4.0, 0.0);
            let root = (&(&sum * &sum) + &(&four * &(&h * &cut))).sqrt();
            for kappa in [&sum + &root, &sum - &root] {
                let kappa = &kappa / &ExactComplex::of(2.0, 0.0);
                for k in [kappa.sqrt(), -&kappa.sqrt()] {
                    // with Q = h e^(kx): Y = k e^(kx), Θ = σQ/(κ - g)
                    let end = k.exp();
                    let theta = &(&sigma * &h) / &(&kappa - &g);
                    let moment = &k * &theta;
                    let displacements = [k.clone(), theta.clone(), &k * &end, &theta * &end];
                    let forces = [h.clone(), -&moment, -&(&h * &end), &moment * &end];
                    let Some(share) = used(&member, &displacements, &forces) else { continue };
                    assert!(share <= 1.0, "{}: piece {run} uses {share}", N::NAME);
                    (most, known) = (most.max(share), known + 1);
                }
            }
        }
    }
    std::println!("{}: pieces use {most:.3}, {known} solutions of {runs} pieces are known", N::NAME);
    assert!(known >= 2 * runs);
}

#[test]
fn pieces_of_general_beams_give_the_forces_of_exact_solutions() {
    check_pieces::<OneWord>(30);
    check_pieces::<TwoWords<f64>>(60);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_pieces_of_general_beams_give_the_forces_of_exact_solutions() {
    check_pieces::<OneWord>(2_000);
    check_pieces::<TwoWords<f64>>(4_000);
}

/// What damping makes of parameters, against the same in many digits.
#[test]
fn parameters_are_damped_as_their_elements_are() {
    type Two = TwoWords<f64>;
    let mut random = Random::new(15);
    for _ in 0..100 {
        let (beam, damping) = parameters(&mut random);
        let lambda = argument::<Two>(&mut random, 2.0);
        let at = Frequency::new(lambda);
        let line = LineNumbers {
            length: [2.0, 0.0],
            stiffness: beam.bending_stiffness,
            inertia: beam.mass_per_length,
            foundation: beam.foundation_stiffness,
        };
        let length = Ball::<Two>::of(2.0);
        let [of_line, y] = at.of_line((&line, &damping), length);
        let [of_beam, x] = at.of_beam((&beam, &damping), length);
        let spring = at.spring(&beam.bending_stiffness, &damping);
        for lambda in &points(lambda) {
            let real = |pair: [f64; 2]| ExactComplex::of(pair[0], 0.0);
            let two = ExactComplex::of(2.0, 0.0);
            let e = &(&one() + &(&real(damping.loss_factor) * &ExactComplex::of(0.0, 1.0)))
                * &(&one() + &(&real(damping.time) * lambda));
            let stiffness = &e * &real(beam.bending_stiffness);
            let load = &(&(&real(beam.mass_per_length) * lambda) + &real(damping.viscous)) * lambda;
            let load = &load + &real(beam.foundation_stiffness);
            let four = &two * &two;
            let expected = [
                (of_line, &stiffness / &two),
                (y, &(&load * &four) / &stiffness),
                (of_beam, &stiffness / &(&four * &two)),
                (x, -&(&(&load * &(&four * &four)) / &stiffness)),
                (spring, &stiffness + &(&real(damping.viscous) * lambda)),
            ];
            for (ball, number) in &expected {
                let off = (&ExactComplex::centre(*ball) - number).size();
                assert!(off <= ball.rad && ball.rad < f64::INFINITY, "{ball:?} {number:?}");
            }
        }
    }
}
