//! The choice of pivots: interior variables leave by those that let entries grow least, and the rest stays bounded.

use crate::number::{Scalar, Size};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::pivot::After;
use crate::subspace::front::total::Total;
use crate::subspace::front::triangle::{self, row};
use core::ops::Range;

/// The part of the largest entry of its row that a pivot on one variable must have.
const SUFFICIENT: f64 = 0.64;

/// The size beyond which an entry on the boundary changes the kind of its variable.
pub(super) const BOUND: f64 = 4.0;

/// A choice of pivots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Choice {
    /// The pivot with the largest gain.
    Largest,
    /// The first one that suffices: another one, with other roundings.
    InOrder,
}

/// A variable that is a pivot, and perhaps a second one.
type Pivot = (usize, Option<usize>);

impl<S: Scalar> Front<'_, S> {
    /// The interior variables.
    fn interior(&self) -> Range<usize> {
        self.boundary..self.count
    }

    /// Eliminates the interior variables, and bounds what is left.
    pub(crate) fn eliminate(&mut self, choice: Choice, total: &mut Total<S>) {
        while self.boundary < self.count {
            if choice == Choice::Largest {
                self.swap(self.largest(), self.count - 1);
            }
            let last = self.count - 1;
            let (partner, largest) = self.largest_beside(last);
            let own = self.entries[row(last) + last].size().first();
            total.look_at_row(if own > largest { own } else { largest }, self.terms[last], self.errors[last]);
            if own > 0.0 && own >= SUFFICIENT * largest {
                self.pivot_on_last(total);
            } else if choice == Choice::InOrder && self.suffices(partner, largest) {
                self.pivot_with(partner, total);
            } else {
                self.pivot_on_best(total);
            }
        }
        self.bound(total);
    }

    /// The interior variable with the largest entry on the diagonal.
    fn largest(&self) -> usize {
        let mut place = self.count - 1;
        let mut own = self.size(place, place);
        for other in self.boundary..place {
            let size = self.size(other, other);
            if size > own {
                (place, own) = (other, size);
            }
        }
        place
    }

    /// The largest entry beside the diagonal in the row of the last variable, and its place.
    #[inline]
    fn largest_beside(&self, last: usize) -> (usize, f64) {
        let (mut place, mut largest) = (0, 0.0);
        for (k, entry) in self.entries[row(last)..row(last) + last].iter().enumerate() {
            let size = entry.size().first();
            if size > largest {
                (place, largest) = (k, size);
            }
        }
        (place, largest)
    }

    /// Whether the last variable and another one, given the size of the entry between both, are a pivot.
    #[inline]
    fn suffices(&self, partner: usize, between: f64) -> bool {
        let last = self.count - 1;
        let entries = &self.entries[row(last)..=row(last) + last];
        self.determinant(entries[last], entries[partner], partner) >= SUFFICIENT * between * between && between > 0.0
    }

    /// Takes a pivot on the last variable and another one, which leaves as well, or flips on the boundary.
    #[inline]
    fn pivot_with(&mut self, partner: usize, total: &mut Total<S>) {
        let last = self.count - 1;
        if partner < self.boundary {
            self.pivot_on_two([last, partner], After::Leaves, total);
        } else {
            self.swap(partner, last - 1);
            self.pivot_on_last_two(total);
        }
    }

    /// Takes the pivot with the largest gain.
    fn pivot_on_best(&mut self, total: &mut Total<S>) {
        match self.best_pivot() {
            Some((place, None)) => {
                self.swap(place, self.count - 1);
                self.pivot_on_last(total);
            }
            Some((place, Some(partner))) => {
                self.swap(place, self.count - 1);
                self.pivot_with(partner, total);
            }
            None => self.pivot_on_nothing(total),
        }
    }

    /// Takes a row that is zero: Δ vanishes, since nothing holds the variable, or its terms have cancelled, and rounding stands for them.
    #[cold]
    fn pivot_on_nothing(&mut self, total: &mut Total<S>) {
        let last = self.count - 1;
        self.entries[triangle::place(last, last)] = S::from_f64(S::EPSILON * self.terms[last]);
        if self.terms[last] > 0.0 {
            self.pivot_on_last(total);
        } else {
            total.multiply(S::zero(), 0);
            self.count = last;
        }
    }

    /// The pivot with the largest gain: of one interior variable, of two, or of one with a variable of the boundary that flips. The gain
    /// of two that leave is shared by both.
    fn best_pivot(&self) -> Option<Pivot> {
        // squares of gains
        let (mut gain, mut best) = (0.0, None);
        for place in self.interior() {
            let entries = &self.entries[row(place)..row(place + 1)];
            let own = entries[place].size().first();
            if own * own > gain {
                (gain, best) = (own * own, Some((place, None)));
            }
            for (other, between) in entries[..place].iter().enumerate() {
                if between.is_zero() {
                    continue;
                }
                let size = self.determinant(entries[place], *between, other);
                let square = if other < self.boundary { size * size } else { size };
                if square > gain {
                    (gain, best) = (square, Some((place, Some(other))));
                }
            }
        }
        best
    }

    /// The size of the determinant over two variables, given the diagonal entry of the one and the entry between both.
    #[inline]
    fn determinant(&self, own: S, between: S, other: usize) -> f64 {
        (own * self.entry(other, other) - between * between).size().first()
    }

    /// Flips variables of the boundary until no entry exceeds the bound. The product of pivots grows with each, so that it ends.
    fn bound(&mut self, total: &mut Total<S>) {
        // each flip gains a factor of the bound: more than these find no end for a NaN
        for _ in 0..8 * self.boundary {
            match self.beyond_bound() {
                Some((place, None)) => self.flip_one(place, total),
                Some((place, Some(other))) => self.pivot_on_two([place, other], After::Flips, total),
                None => return,
            }
        }
    }

    /// A variable of the boundary, or two, whose entry exceeds the bound.
    fn beyond_bound(&self) -> Option<Pivot> {
        let entries = &self.entries[..row(self.boundary)];
        if !entries.iter().any(|entry| entry.size().first() > BOUND) {
            return None;
        }
        let (mut largest, mut single, mut pair) = (BOUND, None, None);
        let mut largest_beside = BOUND;
        for place in 0..self.boundary {
            let own = self.size(place, place);
            if own > largest {
                (largest, single) = (own, Some(place));
            }
            for other in 0..place {
                let size = self.size(place, other);
                if size > largest_beside {
                    (largest_beside, pair) = (size, Some([place, other]));
                }
            }
        }
        if let Some(place) = single {
            return Some((place, None));
        }
        let [one, other] = pair?;
        (self.determinant(self.entry(one, one), self.entry(one, other), other) >= BOUND).then_some((one, Some(other)))
    }
}
