//! The motion of every element, against its transfer matrix.

use crate::element::{BackTransfer, Energies, MatrixOf, TransferMatrix};
use crate::elements::laws::subspaces::{
    check, coordinates, for_each_stepping_element, random_states, space, states_of_tip, step, subspace, supports,
};
use crate::elements::laws::{C, Rows, Sample, assert_same, built, product, rows};
use crate::model::{Ends, State};
use crate::number::{FrequencyPowers, assert_close};
use crate::subspace::{Covector, Subspace};
use core::ops::Index;
use mstmm_plan::{Coordinate, Space};
use std::vec::Vec;

/// Decades of |λ| in which a beam of the samples has z from 0.03 to 6: there its transfer matrix still has most digits.
const ORDINARY: core::ops::Range<f64> = -3.0..1.2;

/// An element of which the laws hold.
trait Moving: Sample + TransferMatrix<C> + BackTransfer<C> + Energies<C> {}
impl<E: Sample + TransferMatrix<C> + BackTransfer<C> + Energies<C>> Moving for E {}

/// The state behind an element.
fn behind<E>(element: &E, lambda: C, input: State<C>) -> State<C>
where
    E: Moving,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    let coordinates = space::<E>().coordinates();
    let u = rows(element, lambda);
    let entry = |coordinate: Coordinate| {
        let row = coordinates.iter().position(|&own| own == coordinate);
        row.map_or(C::ZERO, |row| coordinates.iter().zip(&u[row]).map(|(&c, factor)| factor * input.entry(c)).sum())
    };
    State { y: entry(Coordinate::Y), theta: entry(Coordinate::Theta), m: entry(Coordinate::M), q: entry(Coordinate::Q) }
}

/// A random state of an element's space.
fn random_state(space: Space, numbers: &[f64]) -> State<C> {
    let entry = |coordinate: Coordinate, k: usize| {
        let has = space.coordinates().contains(&coordinate);
        if has { C::new(numbers[k], numbers[(k + 3) % 8]) } else { C::ZERO }
    };
    State {
        y: entry(Coordinate::Y, 0),
        theta: entry(Coordinate::Theta, 1),
        m: entry(Coordinate::M, 2),
        q: entry(Coordinate::Q, 3),
    }
}

fn moving<E>(element: &E, lambda: C, numbers: &[f64]) -> Ends<C>
where
    E: Moving,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    let input = random_state(space::<E>(), numbers);
    Ends { x: lambda, input, output: behind(element, lambda, input) }
}

/// The element itself, but without the loss factor where no motion has one: for `Im λ < 0`.
fn that_moves<E: Moving>(element: E, lambda: C) -> E {
    if lambda.im < 0.0 { element.lossless() } else { element }
}

/// Bound of the roundings of a form: all its terms without their signs.
fn size(ends: &Ends<C>) -> f64 {
    1.0 + ends.input.size().max(ends.output.size()).powi(2)
}

/// The state that a covector gives at the input end is that from which the one at the output end comes.
fn a_covector_leads_back_to_the_input<E>()
where
    E: Moving,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(ORDINARY, |element: E, lambda, numbers| {
        let space = space::<E>();
        let random = subspace(space, &coordinates(space, &random_states(space, numbers, 1.0)));
        let tips = supports(space).into_iter().map(|support| Subspace::Tip(support, space));
        let points = supports(space).into_iter().map(|support| {
            let states: Rows = states_of_tip(space, support);
            subspace(space, &coordinates(space, &states))
        });
        let at = FrequencyPowers::new(lambda, E::WAVES);
        for input in tips.chain(points).chain([random]) {
            let entries = [4, 5, 6, 7].map(|k| C::new(numbers[k], numbers[k - 3]));
            let covector = if space.size() == 2 { Covector::Line(entries[0], 3) } else { Covector::Plane(entries, 3) };
            let output = step(&element, lambda, input);
            if matches!(output, Subspace::Tip(..)) {
                continue; // a support that holds a line holds it behind an inertia, too
            }
            let back = E::back_transfer(&E::back_coefficients(&built(element), &at), &input, covector);
            let (before, after) = (back.pick(&input).shifted(0), covector.pick(&output).shifted(0));
            let expected = behind(&element, lambda, before);
            let largest = rows(&element, lambda).iter().flatten().map(|z| z.norm()).fold(1.0, f64::max);
            let scale = largest * (before.size() + after.size());
            // four sums of four products, in the step, in the back transfer and in the matrix
            assert_close(after.plus(expected, -C::ONE).size(), 0.0, scale, 3.0 * 16.0 * 8.0);
        }
    });
}

/// Seen from the other side slopes and shear forces change their signs: `D U' D U = 1`.
fn the_reversed_element_leads_back<E>()
where
    E: Moving,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(ORDINARY, |element: E, lambda, _| {
        let coordinates = space::<E>().coordinates();
        let size = coordinates.len();
        let square = |entry: &dyn Fn(usize, usize) -> C| -> Rows {
            (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
        };
        let there = rows(&element, lambda);
        let u = E::transfer_matrix(&E::reversed(&built(element)), lambda);
        let reversed = square(&|i, j| u[(i, j)]);
        let sign = |k: usize| if matches!(coordinates[k], Coordinate::Theta | Coordinate::Q) { -1.0 } else { 1.0 };
        let back = square(&|i, j| u[(i, j)] * sign(i) * sign(j));
        let largest = there.iter().chain(&back).flatten().map(|z| z.norm()).fold(1.0, f64::max);
        let identity = square(&|i, j| C::from(if i == j { 1.0 } else { 0.0 }));
        assert_same(&product(&back, &there), &identity, largest.powi(2));
        assert!(!E::SYMMETRIC || reversed == there);
    });
}

/// The work at the ends is that of the forms, `[M Θ - Q Y] = stiffness + λ² mass + λ damping`.
fn the_work_at_the_ends_is_that_of_the_forms<E>()
where
    E: Moving,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(ORDINARY, |element: E, lambda, numbers| {
        let element = that_moves(element, lambda);
        let (ends, built) = (moving(&element, lambda, numbers), built(element));
        let work = |state: &State<C>| state.m * state.theta - state.q * state.y;
        let forms = E::stiffness_form(&built, &ends, &ends)
            + lambda * lambda * E::mass_form(&built, &ends, &ends)
            + lambda * E::damping_form(&built, &ends, &ends);
        let work = work(&ends.output) - work(&ends.input);
        assert_close((work - forms).norm(), 0.0, size(&ends), FORM);
    });
}

/// Roundings of a form: some forty sums of products, and the cancellation in a beam of `z⁴ = 1e-2`.
const FORM: f64 = 40.0 * 100.0;

/// The stiffness forms of two motions at different frequencies cancel: the rest of their works are mass and damping,
/// `[Q₁ Y₂ - M₁ Θ₂ + Θ₁ M₂ - Y₁ Q₂] = (λ₂² - λ₁²) mass + (λ₂ - λ₁) damping`.
fn two_motions_share_mass_and_damping<E>()
where
    E: Moving,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(ORDINARY, |element: E, lambda, numbers| {
        let element = that_moves(element, lambda);
        let turned: Vec<f64> = numbers.iter().rev().copied().collect();
        let built = built(element);
        for factor in [1.0 + 1e-4, 1.7, 30.0] {
            let (first, second) = (moving(&element, lambda, numbers), moving(&element, lambda * factor, &turned));
            let mixed = |u: &State<C>, v: &State<C>| u.q * v.y - u.m * v.theta + u.theta * v.m - u.y * v.q;
            let ends = mixed(&first.output, &second.output) - mixed(&first.input, &second.input);
            let forms = (second.x * second.x - lambda * lambda) * E::mass_form(&built, &first, &second)
                + (second.x - lambda) * E::damping_form(&built, &first, &second);
            assert_close((ends - forms).norm(), 0.0, size(&first) + size(&second), FORM);
        }
    });
}

#[test]
fn laws_of_motions() {
    for_each_stepping_element!(a_covector_leads_back_to_the_input);
    for_each_stepping_element!(the_reversed_element_leads_back);
    for_each_stepping_element!(the_work_at_the_ends_is_that_of_the_forms);
    for_each_stepping_element!(two_motions_share_mass_and_damping);
}
