//! The front of a node at work: the matrix over its variables.

use crate::number::{Scalar, Size};
use crate::subspace::front::triangle::{self, row};
use crate::subspace::front::variable::Variable;

/// A symmetric matrix over variables, in memory of the caller's: those of the boundary first, then the interior ones, of which the last one leaves
/// first. So what is left when all have left stands at the beginning.
#[derive(Debug)]
pub(crate) struct Front<'r, S> {
    /// The lower triangle.
    pub(super) entries: &'r mut [S],
    /// The whole rows of pivots, and these divided by them.
    pub(super) pivots: [&'r mut [S]; 2],
    pub(super) solved: [&'r mut [S]; 2],
    pub(super) variables: &'r mut [Variable],
    /// Size of the largest term of each diagonal entry here: a row of no more than that times eps is nothing.
    pub(super) terms: &'r mut [f64],
    /// Error of each row in units of rounding, with what rounding has done to all that it was made of.
    pub(super) errors: &'r mut [f64],
    /// The number of those of the boundary, and of all.
    pub(super) boundary: usize,
    pub(super) count: usize,
}

impl<S: Scalar> Front<'_, S> {
    /// Begins anew with so many variables without entries, of which the first ones stay.
    pub(super) fn begin(&mut self, boundary: usize, count: usize) {
        self.entries[..row(count)].fill(S::zero());
        self.terms[..count].fill(0.0);
        self.errors[..count].fill(0.0);
        (self.boundary, self.count) = (boundary, count);
    }

    /// An entry, or its mirror image.
    #[inline(always)]
    pub(super) fn entry(&self, row: usize, column: usize) -> S {
        self.entries[triangle::place(row, column)]
    }

    /// Size of an entry.
    #[inline(always)]
    pub(super) fn size(&self, row: usize, column: usize) -> f64 {
        self.entry(row, column).size().first()
    }

    /// Adds to an entry, and thereby to its mirror image.
    #[inline]
    pub(super) fn add(&mut self, row: usize, column: usize, term: S) {
        self.entries[triangle::place(row, column)] += term;
        if row == column {
            self.note(row, term.size().first());
        }
    }

    /// Copies the whole row of a variable.
    #[inline]
    pub(super) fn gather(&mut self, into: usize, place: usize) {
        let (before, behind) = self.pivots[into][..self.count].split_at_mut(place + 1);
        before.copy_from_slice(&self.entries[row(place)..row(place + 1)]);
        let mut at = row(place + 1) + place;
        for (k, entry) in behind.iter_mut().enumerate() {
            *entry = self.entries[at];
            at += place + 2 + k;
        }
    }

    /// Lets two variables change places, of which the second one is not before the first one.
    pub(super) fn swap(&mut self, place: usize, other: usize) {
        if place == other {
            return;
        }
        let (rows, behind) = self.entries[..row(self.count)].split_at_mut(row(other));
        rows[row(place)..row(place) + place].swap_with_slice(&mut behind[..place]);
        core::mem::swap(&mut rows[row(place) + place], &mut behind[other]);
        for (k, entry) in behind[..other].iter_mut().enumerate().skip(place + 1) {
            core::mem::swap(&mut rows[row(k) + place], entry);
        }
        let mut rest = behind;
        for k in other + 1..self.count {
            rest = rest.split_at_mut(k).1;
            rest.swap(place, other);
        }
        self.variables.swap(place, other);
        self.terms.swap(place, other);
        self.errors.swap(place, other);
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
