//! Eigenvalues of springs, lines and beams with damping of their material or in a medium.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::complex_beam::{C, ComplexBeam, product, refined};
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::{DampedBeam, DampedSpring, Mass};
use mstmm::list::{AnyElement, ListStep, StepList};
use mstmm::prelude::*;
use mstmm::search::{EigenvalueList, ProportionalDamping};

system! {
    /// A shear-soft beam with a spring at its middle and a rod and a shaft at its end.
    struct Plain { l: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: 40.0, mass_per_length: 2.0 } -> conn 2
        -> beam 3 { length: 0.7 * l, bending_stiffness: 30.0, mass_per_length: 1.5, shear_stiffness: 900.0, rotary_inertia: 0.02 }
        -> conn 4 -> beam 5 { length: 0.2, bending_stiffness: 10.0, mass_per_length: 1.0, rotary_inertia: 0.03 } -> free;
    conn 2 <- spring 6 { stiffness: 70.0 } <- fixed;
    conn 4 <- rod 7 { length: 1.1, axial_stiffness: 60.0, mass_per_length: 0.4 } <- fixed;
    conn 4 <- shaft 8 { length: 0.6, torsional_stiffness: 3.0, inertia_per_length: 0.02 } <- fixed;
    conn 2 <- torsion_spring 9 { stiffness: 5.0 } <- fixed
}

system! {
    /// The same with one loss for all of it.
    struct Lossy { l: f64, eta: f64, c: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: 40.0, mass_per_length: 2.0, loss_factor: eta, kelvin_voigt_time: c } -> conn 2
        -> beam 3 { length: 0.7 * l, bending_stiffness: 30.0, mass_per_length: 1.5, shear_stiffness: 900.0, rotary_inertia: 0.02,
            loss_factor: eta, kelvin_voigt_time: c }
        -> conn 4 -> beam 5 { length: 0.2, bending_stiffness: 10.0, mass_per_length: 1.0, rotary_inertia: 0.03, loss_factor: eta,
            kelvin_voigt_time: c } -> free;
    conn 2 <- spring 6 { stiffness: 70.0, loss_factor: eta, kelvin_voigt_time: c } <- fixed;
    conn 4 <- rod 7 { length: 1.1, axial_stiffness: 60.0, mass_per_length: 0.4, loss_factor: eta, kelvin_voigt_time: c } <- fixed;
    conn 4 <- shaft 8 { length: 0.6, torsional_stiffness: 3.0, inertia_per_length: 0.02, loss_factor: eta, kelvin_voigt_time: c } <- fixed;
    conn 2 <- torsion_spring 9 { stiffness: 5.0, loss_factor: eta, kelvin_voigt_time: c } <- fixed
}

system! {
    /// Columns, strings and beams on foundations in a medium that resists in proportion to their masses.
    struct InMedium { alpha: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 40.0, mass_per_length: 2.0, axial_force: -30.0, external_damping: 2.0 * alpha } -> conn 2
        -> beam 3 { length: 0.7, bending_stiffness: 30.0, mass_per_length: 1.5, foundation_stiffness: 90.0,
            external_damping: 1.5 * alpha } -> free;
    conn 2 <- string 4 { length: 0.9, tension: 25.0, mass_per_length: 0.3, foundation_stiffness: 4.0, external_damping: 0.3 * alpha } <- fixed;
    conn 2 <- shaft 5 { length: 0.6, torsional_stiffness: 3.0, inertia_per_length: 0.2, external_damping: 0.2 * alpha } <- fixed
}

system! {
    struct InVacuum {}
    fixed -> beam 1 { length: 1.0, bending_stiffness: 40.0, mass_per_length: 2.0, axial_force: -30.0 } -> conn 2
        -> beam 3 { length: 0.7, bending_stiffness: 30.0, mass_per_length: 1.5, foundation_stiffness: 90.0 } -> free;
    conn 2 <- string 4 { length: 0.9, tension: 25.0, mass_per_length: 0.3, foundation_stiffness: 4.0 } <- fixed;
    conn 2 <- shaft 5 { length: 0.6, torsional_stiffness: 3.0, inertia_per_length: 0.2 } <- fixed
}

/// Every expected eigenvalue with `Im λ >= 0` up to the largest that was found is among these, and there are no others.
#[track_caller]
fn assert_same<const N: usize>(found: &EigenvalueList<f64, N>, expected: &[C]) {
    let largest = found.iter().map(|root| root.frequency()).fold(0.0, f64::max);
    let mut expected: Vec<C> =
        expected.iter().copied().filter(|lambda| lambda.norm() <= largest * (1.0 + 1e-9)).collect();
    expected.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    assert_eq!(found.len(), expected.len(), "{found:?} beside {expected:?}");
    for root in found {
        let nearest = expected.iter().map(|lambda| (lambda - root.lambda).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= 1e-13 * root.lambda.norm(), "{root:?}: {nearest:e} from {expected:?}");
    }
}

/// Closed form: `λ² + (1 + cλ)(1 + iη) ω² = 0` at the certified frequencies of the system without damping.
#[test]
fn one_loss_for_all_stiffnesses_is_damping_in_proportion() {
    let plain = Plain { l: 1.0 }.build().unwrap().first_frequencies::<14>().unwrap();
    for (eta, c) in [(0.1, 0.0), (1.3, 0.0), (0.0, 2e-3), (0.0, 5e-3), (0.2, 1e-3)] {
        let damping = ProportionalDamping::new(0.0, c, eta).unwrap();
        let system = Lossy { l: 1.0, eta, c }.build().unwrap();
        let all = plain.iter().flat_map(|root| damping.eigenvalues(root)).flatten();
        let upper: Vec<C> = all.map(|root| root.lambda).filter(|lambda| lambda.im >= 0.0).collect();
        assert_same(&system.first_eigenvalues::<6>().unwrap(), &upper);
    }
}

/// Closed form: `λ² + αλ + ω² = 0`; neither the axial force nor the foundation is damped.
#[test]
fn a_medium_in_proportion_to_masses() {
    let plain = InVacuum {}.build().unwrap().first_frequencies::<14>().unwrap();
    for alpha in [0.3, 11.0] {
        let damping = ProportionalDamping::new(alpha, 0.0, 0.0).unwrap();
        let all = plain.iter().flat_map(|root| damping.eigenvalues(root)).flatten();
        let upper: Vec<C> = all.map(|root| root.lambda).filter(|lambda| lambda.im >= 0.0).collect();
        assert_same(&InMedium { alpha }.build().unwrap().first_eigenvalues::<7>().unwrap(), &upper);
    }
}

pub(crate) fn list_of(elements: &[AnyElement<f64>], tips: [Support; 2]) -> Vec<ListStep<AnyElement<f64>>> {
    let steps = elements.iter().copied().map(ListStep::Element);
    core::iter::once(ListStep::Tip(tips[0])).chain(steps).chain([ListStep::Root(tips[1])]).collect()
}

fn decade(random: &mut Random, from: f64, to: f64) -> f64 {
    10f64.powf(from + (to - from) * random.unit())
}

/// A random beam of moderate numbers with all that it may have.
fn random_beam(random: &mut Random) -> ComplexBeam {
    let [length, bending_stiffness, mass_per_length] = [0, 1, 2].map(|_| decade(random, -0.3, 0.3));
    let scale = bending_stiffness / (length * length);
    ComplexBeam {
        length,
        bending_stiffness,
        mass_per_length,
        shear_stiffness: (random.unit() < 0.5).then(|| scale * decade(random, 1.0, 3.0)),
        rotary_inertia: mass_per_length * length * length * 0.02 * random.unit(),
        axial_force: scale * (6.0 * random.unit() - 2.0),
        foundation_stiffness: scale / (length * length) * 50.0 * random.unit(),
        loss_factor: 0.0,
        kelvin_voigt_time: 0.0,
        external_damping: 0.0,
    }
}

fn damped(beam: &ComplexBeam) -> AnyElement<f64> {
    let ComplexBeam { length, bending_stiffness, mass_per_length, rotary_inertia, .. } = *beam;
    let (loss_factor, kelvin_voigt_time, external_damping) =
        (beam.loss_factor, beam.kelvin_voigt_time, beam.external_damping);
    let beam = DampedBeam {
        length,
        bending_stiffness,
        mass_per_length,
        shear_stiffness: beam.shear_stiffness.unwrap_or(f64::INFINITY),
        rotary_inertia,
        axial_force: beam.axial_force,
        foundation_stiffness: beam.foundation_stiffness,
        foundation_shear_stiffness: 0.0,
        loss_factor,
        kelvin_voigt_time,
        external_damping,
    };
    beam.try_into().unwrap()
}

/// Oracle: the exponential of the equations of two beams in a row, with losses of their own, on random supports.
#[test]
fn roots_of_random_beams_are_those_of_the_exponential() {
    let mut random = Random(20);
    let rows = |support: Support| match support {
        Support::Fixed => ([2, 3], [0, 1]),
        Support::Pinned => ([1, 3], [0, 2]),
        Support::Guided => ([0, 2], [1, 3]),
        _ => ([0, 1], [2, 3]),
    };
    let (mut compared, mut worst) = (0, 0.0_f64);
    for model in 0..60 {
        let mut beams = [random_beam(&mut random), random_beam(&mut random)];
        let period = 6.0 * beams[0].length.powi(2) * (beams[0].mass_per_length / beams[0].bending_stiffness).sqrt();
        for (index, beam) in beams.iter_mut().enumerate() {
            let way = (model + index) % 4;
            beam.loss_factor = if way == 0 || model % 5 == 0 { 0.3 * random.unit() } else { 0.0 };
            beam.kelvin_voigt_time = if way == 1 { 5e-4 * period * random.unit() } else { 0.0 };
            beam.external_damping = if way > 1 { beam.mass_per_length / period * 9.0 * random.unit() } else { 0.0 };
            if way == 3 {
                (beam.axial_force, beam.foundation_stiffness) = (0.0, 0.0);
            }
        }
        let tips = [Support::Fixed, [Support::Free, Support::Pinned, Support::Guided][model % 3]];
        let steps = list_of(&beams.map(|beam| damped(&beam)), tips);
        let found = StepList::new(&steps).unwrap().first_eigenvalues::<4>().unwrap();
        let ([a, b], [i, j]) = (rows(tips[0]).0, rows(tips[1]).1);
        let determinant = |lambda: C| {
            let u = product(&beams[1].transfer(lambda), &beams[0].transfer(lambda));
            u[i][a] * u[j][b] - u[i][b] * u[j][a]
        };
        for root in &found {
            let exact = refined(determinant, root.lambda);
            let error = (exact - root.lambda).norm() / root.frequency();
            (compared, worst) = (compared + 1, worst.max(error));
            // what the determinant of a matrix with growing waves is good for
            assert!(error < 1e-9, "{root:?} beside {exact} of {beams:?}");
        }
    }
    assert!(compared >= 240 && worst > 0.0, "{compared} roots, {worst:e}");
}

/// Oracle: three masses between springs, whose characteristic polynomial is written out; dampers and losses of all kinds.
#[test]
fn a_chain_of_masses_has_the_roots_of_its_polynomial() {
    let (masses, stiffnesses) = ([1.0, 0.5, 2.0], [300.0, 100.0, 250.0]);
    for (losses, times) in
        [([0.3, 0.02, 0.8], [0.0; 3]), ([0.0; 3], [0.01, 0.002, 0.05]), ([0.1, 0.0, 0.4], [0.0, 0.01, 0.003])]
    {
        let mut elements: Vec<AnyElement<f64>> = Vec::new();
        for k in 0..3 {
            let spring = DampedSpring {
                stiffness: stiffnesses[k],
                loss_factor: losses[k],
                kelvin_voigt_time: times[k],
                damping: 0.0,
            };
            elements.push(spring.try_into().unwrap());
            elements.push(Mass { mass: masses[k] }.try_into().unwrap());
        }
        let steps = list_of(&elements, [Support::Fixed, Support::Free]);
        let system = StepList::new(&steps).unwrap();
        let determinant = |lambda: C| {
            let k: [C; 3] =
                core::array::from_fn(|k| stiffnesses[k] * C::new(1.0, losses[k]) * (1.0 + times[k] * lambda));
            let inertia = masses.map(|mass| lambda * lambda * mass);
            let [a, b, c] = [k[0] + k[1] + inertia[0], k[1] + k[2] + inertia[1], k[2] + inertia[2]];
            a * (b * c - k[2] * k[2]) - k[1] * k[1] * c
        };
        let found = system.first_eigenvalues::<3>().unwrap();
        assert_eq!(found.len(), 3);
        for root in &found {
            let exact = refined(determinant, root.lambda);
            assert!((exact - root.lambda).norm() <= 1e-14 * root.frequency(), "{root:?} beside {exact}");
            assert!(root.lambda.im > 0.0 && root.lambda.re < 0.0, "{root:?}");
        }
        // a polynomial of degree six: with a loss factor three roots are above the axis, else these have their images
        let above = Region { re: -100.0..=1.0, im: 1e-3..=100.0 };
        assert_eq!(system.count_in(above.clone()).unwrap(), 3);
        assert_eq!(system.eigenvalues::<4>(above).unwrap().len(), 3);
    }
}
