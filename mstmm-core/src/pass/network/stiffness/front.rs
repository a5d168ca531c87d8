//! A front of displacements alone, eliminated without a choice of pivots.

use crate::number::{Scalar, Size};
use crate::pass::network::stiffness::group::{Group, Set};
use crate::pass::network::stiffness::total::StiffnessTotal;
use crate::structure::triangle::{place, row};

/// Most variables of the plane that leave together, and of space.
pub(super) const IN_PLANE: usize = 3;
#[cfg(feature = "std")]
pub(super) const IN_SPACE: usize = 6;

/// The dynamic stiffness over the variables that members have brought and that have not left, each in its place.
pub(super) struct StiffnessFront<'r, S: Scalar> {
    /// The lower triangle, row after row; zero where no variable is, and between variables that nothing couples.
    pub(super) entries: &'r mut [S],
    /// The places of the variables that are coupled to those that leave, and their entries there over the pivots.
    places: &'r mut [usize],
    solved: &'r mut [S],
    pub(super) total: StiffnessTotal<S>,
}

impl<'r, S: Scalar> StiffnessFront<'r, S> {
    /// An empty front of up to so many variables, in memory for its entries, for places, and for what is solved of each.
    #[inline(always)]
    pub(super) fn new(width: usize, entries: &'r mut [S], places: &'r mut [usize], solved: &'r mut [S]) -> Self {
        entries[..row(width)].fill(S::zero());
        StiffnessFront { entries, places, solved, total: StiffnessTotal::new() }
    }
}

impl<S: Scalar> StiffnessFront<'_, S> {
    /// Eliminates variables, which leave their places to others. Loops are written out for the usual number.
    #[inline(always)]
    pub(super) fn eliminate(&mut self, group: &Group) {
        match group.places() {
            [first, IN_PLANE] => self.pivot_on::<IN_PLANE>([first, IN_PLANE], group.beside),
            places => self.pivot_on::<IN_PLANE>(places, group.beside),
        }
    }

    /// Eliminates up to six variables.
    #[cfg(feature = "std")]
    #[inline(always)]
    pub(super) fn eliminate_in_space(&mut self, group: &Group) {
        match group.places() {
            [first, IN_SPACE] => self.pivot_on::<IN_SPACE>([first, IN_SPACE], group.beside),
            places => self.pivot_on::<IN_SPACE>(places, group.beside),
        }
    }

    /// Pivots on variables, given their places, from the last one to the first one, and those that they are coupled to.
    #[inline(always)]
    fn pivot_on<const G: usize>(&mut self, [first, count]: [usize; 2], mut set: Set) {
        let own = self.take_pivots::<G>(first, count);
        let mut beside = 0;
        while set != 0 {
            let other = set.trailing_zeros() as usize;
            set &= set - 1;
            let mut factors = [S::zero(); G];
            for (k, factor) in factors[..count].iter_mut().enumerate() {
                // its place is free then
                *factor = core::mem::replace(&mut self.entries[place(other, first + k)], S::zero());
            }
            let mut solved = [S::zero(); G];
            for k in (0..count).rev() {
                for l in k + 1..count {
                    factors[k] -= factors[l] * own[l][k];
                }
                solved[k] = factors[k] * own[k][k];
            }
            (self.places[beside], self.solved.as_chunks_mut::<G>().0[beside]) = (other, solved);
            beside += 1;
            let start = row(other);
            for (other, solved) in self.places[..beside].iter().zip(self.solved.as_chunks::<G>().0) {
                let entry = &mut self.entries[start + other];
                for k in (0..count).rev() {
                    *entry -= factors[k] * solved[k];
                }
            }
        }
    }

    /// Takes the pivots of a group. Returns their inverses, each behind its row over the pivot.
    #[inline(always)]
    fn take_pivots<const G: usize>(&mut self, first: usize, count: usize) -> [[S; G]; G] {
        let mut own = [[S::zero(); G]; G];
        for k in 0..count {
            for (l, own) in own[k][..=k].iter_mut().enumerate() {
                *own = core::mem::replace(&mut self.entries[row(first + k) + first + l], S::zero());
            }
        }
        let (mut product, mut pivots) = (S::one(), [S::one(); G]);
        for pivot in (0..count).rev() {
            self.count(own[pivot][pivot]);
            product *= own[pivot][pivot];
            pivots[pivot] = own[pivot][pivot];
            let inverse = S::one() / own[pivot][pivot];
            own[pivot][pivot] = inverse;
            let (rows, solved) = own.split_at_mut(pivot);
            for (k, row) in rows.iter_mut().enumerate() {
                let factor = solved[0][k];
                solved[0][k] = factor * inverse;
                for (entry, solved) in row[..=k].iter_mut().zip(&solved[0]) {
                    *entry -= factor * *solved;
                }
            }
        }
        self.total.multiply_by_all(product, &pivots[..count]);
        own
    }

    /// Includes a pivot in Δ and the count.
    #[inline(always)]
    pub(super) fn take(&mut self, pivot: S) {
        self.count(pivot);
        self.total.multiply(pivot, 0);
    }

    /// Includes a pivot in the count.
    #[inline(always)]
    fn count(&mut self, pivot: S) {
        self.total.below = self.total.below + S::Size::one_if(pivot.is_negative());
    }
}
