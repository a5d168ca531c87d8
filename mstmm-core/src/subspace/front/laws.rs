//! The kernel beside dense algebra: whatever the pivots are, relation, determinant and inertia are those of the whole matrix.

use crate::subspace::front::eliminate::Choice;
use crate::subspace::front::matrix::Front;
use crate::subspace::front::room::FrontScalar;
use crate::subspace::front::total::Total;
use crate::subspace::front::variable::Variable;
use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use std::vec::Vec;

const INTERIOR: usize = 5;
const COUNT: usize = 8;
const BOUNDARY: usize = COUNT - INTERIOR;

type Matrix = SMatrix<f64, COUNT, COUNT>;

/// A symmetric matrix over variables, each of a kind, with entries of all sizes or none.
#[derive(Clone, Debug)]
struct Case {
    entries: Matrix,
    is_force: Vec<bool>,
}

prop_compose! {
    fn cases()(
        numbers in proptest::collection::vec(-1.0..1.0f64, COUNT * COUNT),
        exponents in proptest::collection::vec(-2..3i32, COUNT * COUNT),
        absent in proptest::collection::vec(proptest::bool::weighted(0.3), COUNT * COUNT),
        is_force in proptest::collection::vec(any::<bool>(), COUNT),
    ) -> Case {
        let entry = |k: usize| if absent[k] { 0.0 } else { numbers[k] * 10.0_f64.powi(exponents[k]) };
        let entries = Matrix::from_fn(|i, j| entry(i.min(j) * COUNT + i.max(j)));
        Case { entries, is_force }
    }
}

/// Fills a front with a case, whose interior variables are its first ones.
fn fill(front: &mut Front<'_, f64>, case: &Case) {
    front.begin(BOUNDARY, COUNT);
    let place = |row: usize| (row + BOUNDARY) % COUNT;
    for row in 0..COUNT {
        front.variables[place(row)] =
            Variable { node: row as u32, is_force: case.is_force[row], ..Variable::DISPLACEMENT };
        for column in 0..=row {
            front.add(place(row), place(column), case.entries[(row, column)]);
        }
    }
}

/// Checks a front that is left of a case.
fn check(case: &Case, left: &Front<'_, f64>, total: &Total<f64>) {
    // the variables of the boundary stand in front now
    let is_force = |k: usize| left.variables[k - INTERIOR].is_force;
    let entries = &case.entries;
    let flipped: Vec<usize> = (INTERIOR..COUNT).filter(|k| is_force(*k) != case.is_force[*k]).collect();
    let pivots: Vec<usize> = (0..INTERIOR).chain(flipped.iter().copied()).collect();
    // ones stand for what is no pivot
    let is_pivot = |k: usize| pivots.contains(&k);
    let block = Matrix::from_fn(|i, j| match (i == j, is_pivot(i) && is_pivot(j)) {
        (_, true) => entries[(i, j)],
        (is_diagonal, _) => f64::from(u8::from(is_diagonal)),
    });
    let eigenvalues = block.symmetric_eigen().eigenvalues;
    // rounding decides the sign of what is nearly zero
    let least = eigenvalues.iter().fold(f64::INFINITY, |least, value| value.abs().min(least));
    if least <= 1e-9 * eigenvalues.amax() {
        return;
    }
    let became_forces = flipped.iter().filter(|k| !case.is_force[**k]).count();
    let negative = eigenvalues.iter().filter(|value| **value < 0.0).count();
    assert_eq!(total.below, negative as f64 - became_forces as f64, "{case:?}");
    let forces = pivots.iter().filter(|k| case.is_force[**k]).count();
    let expected = block.determinant() * if forces % 2 == 0 { 1.0 } else { -1.0 };
    let delta = total.delta();
    let found = delta.mantissa() * 2.0_f64.powi(delta.exponent() as i32);
    assert!((found / expected - 1.0).abs() < 1e-5, "{found:e} {expected:e}");
    // any values of the boundary, and what the interior makes of them
    let interior = entries.fixed_view::<INTERIOR, INTERIOR>(0, 0).into_owned();
    let between = entries.fixed_view::<INTERIOR, BOUNDARY>(0, INTERIOR).into_owned();
    let values = SVector::<f64, BOUNDARY>::from_fn(|k, _| 1.0 + k as f64 * 0.37);
    let sizes = interior.symmetric_eigen().eigenvalues.abs();
    if sizes.min() <= 1e-4 * sizes.max() {
        // what the interior makes of the values would dwarf them
        return;
    }
    let Some(solved) = interior.lu().solve(&(-(between * values))) else { return };
    let own = entries.fixed_view::<BOUNDARY, BOUNDARY>(INTERIOR, INTERIOR) * values;
    let others = between.transpose() * solved + own;
    let now = |k: usize| {
        let (value, other) = (values[k - INTERIOR], others[k - INTERIOR]);
        match (case.is_force[k], is_force(k)) {
            (false, true) => [other, -value],
            (true, false) => [-other, value],
            _ => [value, other],
        }
    };
    for row in INTERIOR..COUNT {
        let terms = (INTERIOR..COUNT).map(|column| left.entry(row - INTERIOR, column - INTERIOR) * now(column)[0]);
        let (sum, scale) =
            terms.fold((0.0, now(row)[1].abs()), |(sum, scale), term| (sum + term, scale.max(term.abs())));
        assert!((sum - now(row)[1]).abs() <= 1e-5 * scale, "{sum:e} {:e} {scale:e} {case:?}", now(row)[1]);
    }
}

proptest! {
    #[test]
    fn what_is_left_is_the_schur_complement_of_what_left(case in cases()) {
        for choice in [Choice::Largest, Choice::InOrder] {
            f64::in_memory::<COUNT, _>(|room| {
                let mut fronts = room.fronts(choice, true);
                let (front, total) = (&mut fronts.front, &mut fronts.total);
                fill(front, &case);
                front.eliminate(choice, total);
                check(&case, front, total);
                let bound = 4.0 + 1e-9;
                assert!((0..BOUNDARY).all(|row| front.size(row, row) <= bound));
            });
        }
    }
}
