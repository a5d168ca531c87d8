//! The front of a node at work: the matrix over its variables.

use crate::number::{Scalar, Size};
use core::ops::Range;

/// A variable of a front.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variable {
    /// Number of the freedom that it belongs to, as whoever builds the front counts them.
    pub(crate) label: usize,
    /// Whether it is a force; else it is a displacement.
    pub(crate) is_force: bool,
    /// Whether it is a rotation or a moment.
    pub(crate) is_rotation: bool,
    /// Logarithm to base 2 of the unit of the displacement; the force has its inverse.
    pub(crate) unit: i32,
    /// What its unit comes from.
    pub(crate) measure: Measure,
}

/// What gives a variable its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    /// A member with inertia, given the logarithm to base 2 of its wave number.
    Member(i32),
    /// A spring or damper.
    Connector,
    /// Nothing: a rigid joint has no size.
    Nothing,
}

impl Measure {
    /// What the unit comes from behind a node, which lends its own to a rigid joint.
    pub(super) fn once_joined(self) -> Self {
        if self == Measure::Nothing { Measure::Connector } else { self }
    }
}

impl Variable {
    pub(crate) const NONE: Variable =
        Variable { label: 0, is_force: false, is_rotation: false, unit: 0, measure: Measure::Nothing };

    /// Logarithm to base 2 of the factor of a row of this variable in another unit.
    #[inline]
    pub(crate) fn shift_to(&self, unit: i32) -> i32 {
        if self.is_force { self.unit - unit } else { unit - self.unit }
    }
}

/// A symmetric matrix over variables, the interior ones first. `W` is the largest number of them.
#[derive(Clone, Debug)]
pub(crate) struct Front<S: Scalar, const W: usize> {
    pub(super) entries: [[S; W]; W],
    /// The rows of pivots, divided by them.
    pub(super) solved: [[S; W]; 2],
    pub(super) variables: [Variable; W],
    /// Size of the largest term of each diagonal entry here: a row of no more than that times eps is nothing.
    pub(super) terms: [f64; W],
    /// Error of each row in units of rounding, with what rounding has done to all that it was made of.
    pub(super) errors: [f64; W],
    /// The number of variables that are eliminated, of interior ones with these, and of all.
    pub(super) next: usize,
    pub(super) interior: usize,
    pub(super) count: usize,
}

impl<S: Scalar, const W: usize> Front<S, W> {
    /// A front without variables.
    pub(crate) fn new() -> Self {
        Front {
            entries: [[S::zero(); W]; W],
            solved: [[S::zero(); W]; 2],
            variables: [Variable::NONE; W],
            terms: [0.0; W],
            errors: [0.0; W],
            next: 0,
            interior: 0,
            count: 0,
        }
    }

    /// Begins anew with so many variables without entries, of which the first ones are interior.
    pub(super) fn begin(&mut self, interior: usize, count: usize) {
        for row in &mut self.entries[..count] {
            row[..count].fill(S::zero());
        }
        self.terms[..count].fill(0.0);
        self.errors[..count].fill(0.0);
        (self.next, self.interior, self.count) = (0, interior, count);
    }

    /// The variables of the boundary.
    pub(crate) fn boundary(&self) -> Range<usize> {
        self.interior..self.count
    }

    /// Lets two variables change places.
    pub(super) fn swap(&mut self, one: usize, other: usize) {
        if one == other {
            return;
        }
        self.variables.swap(one, other);
        self.terms.swap(one, other);
        self.errors.swap(one, other);
        self.entries.swap(one, other);
        for row in &mut self.entries[self.next..self.count] {
            row.swap(one, other);
        }
    }

    /// Adds to an entry and to its mirror image.
    #[inline]
    pub(crate) fn add(&mut self, row: usize, column: usize, term: S) {
        self.entries[row][column] += term;
        if row == column {
            self.note(row, term.size().first());
        } else {
            self.entries[column][row] += term;
        }
    }

    /// Notes the size of a term on the diagonal.
    #[inline]
    pub(super) fn note(&mut self, row: usize, size: f64) {
        if size > self.terms[row] {
            self.terms[row] = size;
        }
    }

    /// Notes an error of a row, in units of rounding.
    #[inline]
    pub(super) fn note_error(&mut self, row: usize, size: f64) {
        if size > self.errors[row] {
            self.errors[row] = size;
        }
    }
}
