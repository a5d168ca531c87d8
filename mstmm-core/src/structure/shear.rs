//! Two unknowns whose pivots are small: one is added to the other, which has a pivot then.

use crate::number::{Scalar, Size, binary_exponent, power_of_two};
use crate::structure::factor::{Factor, LOADS, Row};
use crate::structure::triangle::place;

impl<S: Scalar> Factor<'_, S> {
    /// Adds to an unknown with a small pivot, or to another one, what waits beside it, and returns the unknown whose pivot is largest then. Two unknowns
    /// without stiffness of their own are coupled so: `[[0, 1], [1, 0]]` has no pivot, `[[2, 1], [1, 0]]` has.
    pub(super) fn sheared(&mut self, best: usize) -> usize {
        let (mut pair, mut largest) = (None, self.share(best));
        for one in (0..self.width).filter(|slot| self.unknowns[*slot].waits) {
            for other in (0..one).filter(|slot| self.unknowns[*slot].waits) {
                let sizes = [one, other].map(|slot| Scalar::sqrt(self.unknowns[slot].size));
                let share = self.entries[place(one, other)].size().first() / sizes[0] / sizes[1];
                if share > largest && share < f64::INFINITY {
                    (pair, largest) = (Some([one, other]), share);
                }
            }
        }
        let Some([one, other]) = pair else { return best };
        [one, other].into_iter().for_each(|slot| self.load_everywhere(slot));
        // of the sizes of both, so that their terms compare
        let sizes = [one, other].map(|slot| binary_exponent(self.unknowns[slot].size));
        let power = S::from_f64(power_of_two((sizes[0] - sizes[1]) / 2));
        let [own, between, beside] =
            [[one, one], [one, other], [other, other]].map(|[row, column]| self.entries[place(row, column)]);
        let pivot = |factor: S| own + factor * (between + between + factor * beside);
        let is_less = pivot(power).size().first() < pivot(-power).size().first();
        let factor = if is_less { -power } else { power };
        for column in (0..self.width).filter(|column| *column != one && self.unknowns[*column].is_taken) {
            let term = factor * self.entries[place(other, column)];
            self.entries[place(one, column)] += term;
        }
        self.entries[place(one, one)] = pivot(factor);
        self.note(one as u32, (between * factor).size().first());
        for load in 0..LOADS {
            let term = factor * self.unknowns[other].loads[load];
            self.unknowns[one].loads[load] += term;
        }
        if self.keeps_rows && self.begin_row(Row::shear_of(self.unknowns[other].number)) {
            self.push_number(-factor, self.unknowns[one].number);
        }
        one
    }
}
