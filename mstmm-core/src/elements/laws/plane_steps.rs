//! The step of every element, against its transfer matrix.

use crate::element::{MatrixOf, PlaneStep, TransferMatrix};
use crate::elements::laws::subspaces::{
    MINORS, check, coordinates, for_each_stepping_element, for_each_undamped_stepping_element, plain, random_states,
    read, space, states_of_tip, step, subspace, supports,
};
use crate::elements::laws::{C, Rows, Sample, built, rows};
use crate::number::{FrequencyPowers, Scalar, assert_close};
use crate::subspace::{Connecting, NoCount, Plane, Subspace};
use core::ops::Index;
use mstmm_plan::Space;
use std::vec::Vec;

/// Decades of |λ| in which a beam of the samples has z from 0.005 (its series) to 15 (its closed form); beyond, the minors
/// of the transfer matrix have lost too many digits to be an oracle.
const ORDINARY: core::ops::Range<f64> = -4.0..1.5;

/// Roundings of an entry of a transfer matrix (ten), times those of a sum of six products: as in the other laws.
const ROUNDINGS: f64 = 60.0;

/// States behind the element, and bounds of the terms of their entries.
fn transferred(u: &Rows, states: &Rows) -> (Rows, Rows) {
    let times = |state: &Vec<C>, modulus: bool| -> Vec<C> {
        let term = |row: &Vec<C>, k: usize| row[k] * state[k];
        let sum = |row: &Vec<C>| {
            (0..row.len()).map(|k| if modulus { term(row, k).norm().into() } else { term(row, k) }).sum()
        };
        u.iter().map(sum).collect()
    };
    (states.iter().map(|s| times(s, false)).collect(), states.iter().map(|s| times(s, true)).collect())
}

/// Sums of the moduli of all terms of [`coordinates`]: what their roundings are relative to.
fn scales(bounds: &Rows) -> Vec<f64> {
    match bounds.as_slice() {
        [line] => line.iter().map(|entry| entry.re).collect(),
        [a, b] => MINORS.iter().map(|&(i, j)| a[i].re * b[j].re + a[j].re * b[i].re).collect(),
        _ => panic!("{} states", bounds.len()),
    }
}

/// The factor of a step besides the transfer matrix: the denominator of a dashpot, else a constant of the element, taken here at
/// rest from one line or plane.
fn factor<E>(element: &E, lambda: C) -> C
where
    E: Sample + TransferMatrix<C> + PlaneStep<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    if let Some(kappa) = E::denominator(&built(*element), lambda) {
        return kappa;
    }
    let states = random_states(space::<E>(), &[0.7, 0.4, 0.9, 0.2, 0.1, 0.8, 0.3, 0.6], 0.0);
    let (behind, bounds) = transferred(&rows(element, C::ZERO), &states);
    let output = plain(step(element, C::ZERO, subspace(space::<E>(), &coordinates(space::<E>(), &states))));
    let (expected, scales) = (coordinates(space::<E>(), &behind), scales(&bounds));
    // the coordinate whose terms cancel least
    let share = |k: &usize| if scales[*k] > 0.0 { expected[*k].norm() / scales[*k] } else { 0.0 };
    let best = (0..expected.len()).max_by(|a, b| share(a).total_cmp(&share(b))).unwrap();
    output[best] / expected[best]
}

/// The step of a line or plane is the line or plane of the transferred states, times the same factor for all.
fn a_step_is_the_transfer_matrix<E>()
where
    E: Sample + TransferMatrix<C> + PlaneStep<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(ORDINARY, |element: E, lambda, numbers| {
        let states = random_states(space::<E>(), numbers, 1.0);
        let output = plain(step(&element, lambda, subspace(space::<E>(), &coordinates(space::<E>(), &states))));
        let kappa = factor(&element, lambda);
        let (behind, bounds) = transferred(&rows(&element, lambda), &states);
        let expected = coordinates(space::<E>(), &behind);
        // where matrix and step do not share their waves, each has the rounding of its own
        let roundings = ROUNDINGS.max(8.0 * element.phase(lambda.norm().sqrt()));
        for ((actual, expected), scale) in output.iter().zip(expected).zip(scales(&bounds)) {
            assert_close((actual - kappa * expected).norm(), 0.0, kappa.norm() * scale, roundings);
        }
    });
}

/// A step from a tip is the step from the line or plane of that tip up to the sign, which is free in a subspace.
/// Each coordinate is one term, so that each agrees to a few roundings of itself.
fn a_step_from_a_tip_is_that_from_its_subspace<E>()
where
    E: Sample + PlaneStep<C>,
{
    check(ORDINARY, |element: E, lambda, _| {
        for support in supports(space::<E>()) {
            let full = subspace(space::<E>(), &coordinates(space::<E>(), &states_of_tip(space::<E>(), support)));
            let output = step(&element, lambda, Subspace::Tip(support, space::<E>()));
            let output = if matches!(output, Subspace::Tip(..)) { full } else { output };
            let (short, long) = (plain(output), plain(step(&element, lambda, full)));
            let largest = (0..long.len()).max_by(|&i, &j| long[i].size().total_cmp(&long[j].size())).unwrap();
            let sign = if (short[largest] / long[largest]).re < 0.0 { -1.0 } else { 1.0 };
            for (a, b) in short.iter().zip(long) {
                assert_close((a - b * sign).norm(), 0.0, b.norm(), 16.0);
            }
        }
    });
}

/// Forms of a plane in which some minors are known to be zero or one: grounded springs, a point on a pin.
fn short_forms(numbers: &[f64]) -> [Subspace<C>; 5] {
    let [a, b] = [0, 1].map(|k| C::from(numbers[k]));
    let springs = |y, theta| Subspace::Springs { y, theta };
    let on_pin = Plane { y_theta: C::ZERO, y_m: C::ZERO, w: C::ZERO, theta_q: a, m_q: b, exponent: 0 };
    [
        springs(None, None),
        springs(Some(a), None),
        springs(None, Some(b)),
        springs(Some(a), Some(b)),
        Subspace::OnPin(on_pin),
    ]
}

/// A step from a short form is the step from its plane; sums in another order differ by a few roundings.
fn a_step_from_a_short_form_is_that_from_its_plane<E>()
where
    E: Sample + PlaneStep<C>,
{
    check(ORDINARY, |element: E, lambda, numbers| {
        if !space::<E>().is(Space::Bending) {
            return;
        }
        for form in short_forms(numbers) {
            let plane = Subspace::Plane(form.plane());
            let (short, long) = (plain(step(&element, lambda, form)), plain(step(&element, lambda, plane)));
            let scale = long.iter().map(|minor| minor.norm()).fold(1.0, f64::max);
            for (a, b) in short.iter().zip(long) {
                assert_close((a - b).norm(), 0.0, scale, ROUNDINGS);
            }
        }
    });
}

/// The last step before the root gives the bits of a step and `at_root`.
fn a_step_into_the_root_is_a_step_and_the_root<E>()
where
    E: Sample + PlaneStep<C>,
{
    check(ORDINARY, |element: E, lambda, numbers| {
        let coefficients = E::coefficients(&built(element), &FrequencyPowers::new(lambda, E::WAVES));
        let space = space::<E>();
        let random = subspace(space, &coordinates(space, &random_states(space, numbers, 1.0)));
        let mut inputs: Vec<_> = supports(space).into_iter().map(|support| Subspace::Tip(support, space)).collect();
        inputs.push(random);
        if space.is(Space::Bending) {
            inputs.extend(short_forms(numbers));
        }
        for input in inputs {
            for support in supports(space) {
                let root = E::root(&coefficients, input, support, &mut NoCount);
                assert_eq!(root, E::step(&coefficients, input, &mut NoCount).at_root(support, &mut NoCount));
            }
        }
    });
}

/// A real ω and the complex λ = iω give the same step.
fn a_step_at_a_real_frequency_is_that_at_the_complex_one<E>()
where
    E: Sample + PlaneStep<C> + PlaneStep<f64> + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(ORDINARY, |element: E, lambda, numbers| {
        let omega = lambda.norm();
        let lambda = C::new(0.0, omega);
        let states = random_states(space::<E>(), numbers, 0.0);
        let input = coordinates(space::<E>(), &states);
        let real_input: Vec<f64> = input.iter().map(|z| z.re).collect();
        let real = plain(step(&element, omega, subspace(space::<E>(), &real_input)));
        let complex = plain(step(&element, lambda, subspace(space::<E>(), &input)));
        let (_, bounds) = transferred(&rows(&element, lambda), &states);
        let kappa = factor(&element, C::ZERO).norm();
        for ((real, complex), scale) in real.iter().zip(complex).zip(scales(&bounds)) {
            assert_close((complex - real).norm(), 0.0, kappa * scale, ROUNDINGS);
        }
    });
}

/// Two steps of half the element make the step of the whole, up to z = 1e5 where no transfer matrix is left to compare
/// with. The error of z, an eps of itself, is a phase; the rest are roundings of sums of five terms, relative to the
/// largest coordinate in units of the wave number s (parameters are near 1: another factor of 16 at most).
fn two_half_steps_make_the_whole<E>()
where
    E: Sample + PlaneStep<C>,
{
    check(-4.0..9.0, |element: E, lambda, numbers| {
        let Some(half) = element.halves() else { return };
        let input = subspace(space::<E>(), &coordinates(space::<E>(), &random_states(space::<E>(), numbers, 1.0)));
        let (whole, exponent) = read(step(&element, lambda, input));
        let (halves, other_exponent) = read(step(&half, lambda, step(&half, lambda, input)));
        let s = lambda.norm().sqrt();
        let unit = |k: usize| s.max(1.0).powi(k as i32);
        let size = whole.iter().enumerate().map(|(k, x)| x.size() / unit(k)).fold(0.0, f64::max);
        for (k, (&a, b)) in whole.iter().zip(halves).enumerate() {
            let b = b.times_power_of_two(other_exponent - exponent);
            assert_close((a - b).norm(), 0.0, size * unit(k), 16.0 * (5.0 + element.phase(s)));
        }
    });
}

#[test]
fn steps_of_all_elements() {
    for_each_stepping_element!(a_step_is_the_transfer_matrix);
    for_each_stepping_element!(a_step_from_a_tip_is_that_from_its_subspace);
    for_each_stepping_element!(a_step_from_a_short_form_is_that_from_its_plane);
    for_each_stepping_element!(a_step_into_the_root_is_a_step_and_the_root);
    for_each_stepping_element!(two_half_steps_make_the_whole);
}

#[test]
fn steps_of_undamped_elements() {
    for_each_undamped_stepping_element!(a_step_at_a_real_frequency_is_that_at_the_complex_one);
}
