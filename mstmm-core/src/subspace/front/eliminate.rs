//! The choice of pivots: interior variables leave by those that let entries grow least, and the rest stays bounded.

use crate::number::{Scalar, Size, elementary};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::pivot::After;
use crate::subspace::front::total::Total;

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

impl<S: Scalar, const W: usize> Front<S, W> {
    #[inline]
    pub(super) fn size(&self, row: usize, column: usize) -> f64 {
        self.entries[row][column].size().first()
    }

    /// Eliminates the interior variables, and bounds what is left.
    pub(crate) fn eliminate(&mut self, choice: Choice, total: &mut Total<S>) {
        while self.next < self.interior {
            let next = self.next;
            match self.pivot(choice, total) {
                Some((place, None)) => {
                    self.swap(next, place);
                    self.pivot_on_one(next, After::Leaves, total);
                }
                Some((place, Some(other))) if other < self.interior => {
                    self.swap(next, place);
                    // the other one stands behind
                    self.swap(next + 1, other);
                    self.pivot_on_two([next, next + 1], [After::Leaves; 2], total);
                }
                Some((place, Some(other))) => {
                    self.swap(next, place);
                    self.pivot_on_two([next, other], [After::Leaves, After::Flips], total);
                }
                None => self.pivot_on_nothing(total),
            }
        }
        self.bound(total);
    }

    /// Takes a row that is zero: Δ vanishes, since nothing holds the variable, or its terms have cancelled, and rounding stands for them.
    #[cold]
    fn pivot_on_nothing(&mut self, total: &mut Total<S>) {
        let next = self.next;
        self.entries[next][next] = S::from_f64(S::EPSILON * self.terms[next]);
        if self.terms[next] > 0.0 {
            self.pivot_on_one(next, After::Leaves, total);
        } else {
            total.multiply(S::zero(), 0);
            self.next += 1;
        }
    }

    /// The next pivot; none where the row of an interior variable is zero.
    fn pivot(&self, choice: Choice, total: &mut Total<S>) -> Option<Pivot> {
        let mut place = self.next;
        let mut own = self.size(place, place);
        if choice == Choice::Largest {
            for other in self.next + 1..self.interior {
                let size = self.size(other, other);
                if size > own {
                    (place, own) = (other, size);
                }
            }
        }
        let mut largest = 0.0_f64;
        for entry in &self.entries[place][self.next..self.count] {
            let size = entry.size().first();
            largest = if size > largest { size } else { largest };
        }
        total.look_at_row(largest, self.terms[place], self.errors[place]);
        if own > 0.0 && own >= SUFFICIENT * largest { Some((place, None)) } else { self.best_pivot() }
    }

    /// The pivot with the largest gain: of one interior variable, of two, or of one with a variable of the boundary that flips.
    fn best_pivot(&self) -> Option<Pivot> {
        let (mut gain, mut best) = (0.0, None);
        for place in self.next..self.interior {
            let own = self.size(place, place);
            if own > gain {
                (gain, best) = (own, Some((place, None)));
            }
            for other in place + 1..self.count {
                if self.size(place, other) == 0.0 {
                    continue;
                }
                let size = self.determinant(place, other);
                let is_interior = other < self.interior;
                let own = if is_interior { elementary!(f64::sqrt, libm::sqrt, size) } else { size };
                if own > gain {
                    (gain, best) = (own, Some((place, Some(other))));
                }
            }
        }
        best
    }

    /// The size of the determinant over two variables.
    fn determinant(&self, one: usize, other: usize) -> f64 {
        let between = self.entries[one][other];
        (self.entries[one][one] * self.entries[other][other] - between * between).size().first()
    }

    /// Flips variables of the boundary until no entry exceeds the bound. The product of pivots grows with each, so that it ends.
    fn bound(&mut self, total: &mut Total<S>) {
        // each flip gains a factor of the bound: more than these find no end for a NaN
        for _ in 0..8 * W {
            match self.beyond_bound() {
                Some((place, None)) => self.pivot_on_one(place, After::Flips, total),
                Some((place, Some(other))) => self.pivot_on_two([place, other], [After::Flips; 2], total),
                None => return,
            }
        }
    }

    /// A variable of the boundary, or two, whose entry exceeds the bound.
    fn beyond_bound(&self) -> Option<Pivot> {
        let (mut largest, mut single, mut pair) = (BOUND, None, None);
        let mut largest_beside = BOUND;
        for place in self.boundary() {
            let own = self.size(place, place);
            if own > largest {
                (largest, single) = (own, Some(place));
            }
            for other in place + 1..self.count {
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
        (self.determinant(one, other) >= BOUND).then_some((one, Some(other)))
    }
}
