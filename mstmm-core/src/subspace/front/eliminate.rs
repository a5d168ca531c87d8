//! The choice of pivots: interior variables leave by those that let entries grow least, and the rest stays bounded.

use crate::number::{Scalar, Size};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::pivot::After;
use crate::subspace::front::total::Total;
use crate::subspace::front::triangle::{self, row};
use core::ops::Range;

/// The part of the largest entry of its row that a pivot on one variable must have.
const SUFFICIENT: f64 = 0.64;

/// The part of the square of the largest entry inside that the determinant over two variables must have, if they are taken without a look
/// at all others.
const PAIRED: f64 = 0.64;

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
            if self.suffices(total) {
                self.pivot_on_last(total);
            } else {
                self.pivot_on_best(total);
            }
        }
        self.bound(total);
    }

    /// The interior variable with the largest entry on the diagonal.
    #[inline]
    fn largest(&self) -> usize {
        let (mut place, mut own) = (self.count - 1, 0.0);
        let mut at = row(self.boundary) + self.boundary;
        for other in self.interior() {
            let size = self.entries[at].size().first();
            at += other + 2;
            if size > own {
                (place, own) = (other, size);
            }
        }
        place
    }

    /// Whether the last variable is a pivot by itself.
    #[inline]
    fn suffices(&self, total: &mut Total<S>) -> bool {
        let last = self.count - 1;
        let entries = &self.entries[row(last)..row(self.count)];
        let largest = triangle::largest(entries);
        total.look_at_row(largest, self.terms[last], self.errors[last]);
        let own = entries[last].size().first();
        own > 0.0 && own >= SUFFICIENT * largest
    }

    /// Takes a pivot on the last variable and another one, which leaves as well, or flips on the boundary.
    #[inline]
    fn pivot_with(&mut self, partner: usize, total: &mut Total<S>) {
        let last = self.count - 1;
        if total.carries_errors {
            self.look_at_two([last, partner], total);
        }
        if partner < self.boundary {
            self.pivot_on_two([last, partner], After::Leaves, total);
        } else {
            self.swap(partner, last - 1);
            self.pivot_on_last_two(total);
        }
    }

    /// Looks at a pivot on two variables beside what the errors of both rows do to it.
    #[cold]
    fn look_at_two(&self, [one, two]: [usize; 2], total: &mut Total<S>) {
        let [own, between, other] = [[one, one], [one, two], [two, two]].map(|[row, column]| self.entry(row, column));
        let determinant = own * other - between * between;
        let [of_one, of_two] = [one, two].map(|place| self.errors[place]);
        let of_between: f64 = Scalar::sqrt(of_one * of_two);
        let [own, between, other] = [own, between, other].map(|entry| entry.size().first());
        let error = own * of_two + 2.0 * between * of_between + other * of_one;
        total.look_at_pivot(determinant.size().first(), error);
    }

    /// The partner of the last variable, if both together are as good a pivot as any.
    fn partner(&self) -> Option<usize> {
        let last = self.count - 1;
        let (before, entries) = self.entries[..row(self.count)].split_at(row(last));
        let (mut partner, mut largest) = (last, 0.0);
        for (k, entry) in entries[self.boundary..last].iter().enumerate() {
            let size = entry.size().first();
            if size > largest {
                (partner, largest) = (self.boundary + k, size);
            }
        }
        if partner == last {
            return None;
        }
        let between = entries[partner];
        let determinant = (entries[last] * before[row(partner) + partner] - between * between).size().first();
        let sizes = self.interior().map(|place| triangle::largest(&self.entries[row(place)..row(place + 1)]));
        let of_all = sizes.fold(0.0, f64::max);
        (determinant >= PAIRED * of_all * of_all).then_some(partner)
    }

    /// Takes the pivot with the largest gain.
    fn pivot_on_best(&mut self, total: &mut Total<S>) {
        if let Some(partner) = self.partner() {
            return self.pivot_with(partner, total);
        }
        match self.best_pivot() {
            Some((place, None)) => {
                let last = self.count - 1;
                self.swap(place, last);
                total.look_at_pivot(self.size(last, last), self.errors[last]);
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
    fn best_pivot(&mut self) -> Option<Pivot> {
        let diagonal = &mut self.solved[0][..self.count];
        for (k, entry) in diagonal.iter_mut().enumerate() {
            *entry = self.entries[row(k) + k];
        }
        // squares of gains
        let (mut gain, mut best) = (0.0, None);
        for place in self.boundary..self.count {
            let (own, entries) = (diagonal[place], &self.entries[row(place)..row(place) + place]);
            let size = own.size().first();
            if size * size > gain {
                (gain, best) = (size * size, Some((place, None)));
            }
            for (other, (between, of_other)) in entries.iter().zip(&*diagonal).enumerate() {
                if between.is_zero() {
                    continue;
                }
                let size = (own * *of_other - *between * *between).size().first();
                let square = if other < self.boundary { size * size } else { size };
                if square > gain {
                    (gain, best) = (square, Some((place, Some(other))));
                }
            }
        }
        best
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
        let mut rows = (0..self.boundary).map(|place| &self.entries[row(place)..row(place + 1)]);
        if !rows.any(|entries| entries.iter().any(|entry| entry.size().first() > BOUND)) {
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
        let between = self.entry(one, other);
        let determinant = self.entry(one, one) * self.entry(other, other) - between * between;
        (determinant.size().first() >= BOUND).then_some((one, Some(other)))
    }
}
