//! Pivots on one and two variables, which leave the front or change their kind.

use crate::number::{Scalar, Size};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::total::Total;
use crate::subspace::front::triangle::{self, row};

/// What becomes of a variable that was a pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum After {
    /// It is eliminated.
    Leaves,
    /// It stays as the other kind: of the displacement of a port its force, or the other way round.
    Flips,
}

impl<S: Scalar> Front<'_, S> {
    /// `log2` of the factor by which the unit of a variable has changed a pivot on it.
    #[inline]
    fn unit_power(&self, place: usize) -> i64 {
        let variable = &self.variables[place];
        i64::from(if variable.is_force { 2 * variable.unit } else { -2 * variable.unit })
    }

    /// A number, of opposite sign for a force.
    #[inline]
    fn signed(&self, place: usize, number: S) -> S {
        if self.variables[place].is_force { -number } else { number }
    }

    /// Carries what rounding has done to the rows of pivots to all others, with what these lose by them, given the errors of pivots.
    #[cold]
    fn carry_errors<const N: usize>(&mut self, of_pivots: [f64; N]) {
        let mut largest = [0.0_f64; N];
        for (largest, solved) in largest.iter_mut().zip(&self.solved) {
            *largest = triangle::largest(&solved[..self.count]);
        }
        for row in 0..self.count {
            let (mut of_row, mut inherited) = (0.0, 0.0);
            for k in 0..N {
                let (factor, part) = (self.pivots[k][row].size().first(), self.solved[k][row].size().first());
                of_row += factor * largest[k];
                inherited += part * part * of_pivots[k];
            }
            self.note_error(row, of_row.max(inherited));
        }
    }

    /// Lets a pivot become the other kind and writes its row, given which of the solved rows is its own, its diagonal entry, and its error.
    fn flip(&mut self, place: usize, own: usize, diagonal: S, error: f64, total: &mut Total<S>) {
        for other in 0..self.count {
            self.entries[triangle::place(place, other)] = self.signed(place, self.solved[own][other]);
        }
        self.entries[triangle::place(place, place)] = diagonal;
        self.terms[place] = 0.0;
        self.errors[place] = triangle::largest(&self.solved[own][..self.count]).max(error);
        if !self.variables[place].is_force {
            total.count(-1.0);
        }
        self.variables[place].is_force ^= true;
    }

    /// Pivots on the last variable, which leaves.
    #[inline]
    pub(super) fn pivot_on_last(&mut self, total: &mut Total<S>) {
        let last = self.count - 1;
        let (rest, own) = self.entries[..row(self.count)].split_at_mut(row(last));
        let pivot = own[last];
        let inverse = S::one() / pivot;
        let solved = &mut self.solved[0][..last];
        for (solved, entry) in solved.iter_mut().zip(&*own) {
            *solved = *entry * inverse;
        }
        subtract(rest, [&own[..last]], [solved], &mut self.terms[..last]);
        self.multiply_by_one(pivot, last, total);
        self.count = last;
        if total.carries_errors {
            self.pivots[0][..last].copy_from_slice(&self.entries[row(last)..row(last) + last]);
            self.carry_errors([self.errors[last]]);
        }
    }

    /// Flips a variable of the boundary.
    pub(super) fn flip_one(&mut self, place: usize, total: &mut Total<S>) {
        self.gather(0, place);
        let pivot = self.pivots[0][place];
        let inverse = S::one() / pivot;
        self.multiply_by_one(pivot, place, total);
        for (solved, entry) in self.solved[0][..self.count].iter_mut().zip(&self.pivots[0][..self.count]) {
            *solved = *entry * inverse;
        }
        let error = self.errors[place];
        let count = self.count;
        subtract(
            &mut self.entries[..row(count)],
            [&self.pivots[0][..count]],
            [&self.solved[0][..count]],
            &mut self.terms[..count],
        );
        if total.carries_errors {
            self.carry_errors([error]);
        }
        let size = inverse.size().first();
        self.flip(place, 0, -inverse, size * size * error, total);
    }

    /// Pivots on the last two variables, which leave.
    pub(super) fn pivot_on_last_two(&mut self, total: &mut Total<S>) {
        let (i, j) = (self.count - 1, self.count - 2);
        let (rest, others) = self.entries[..row(self.count)].split_at_mut(row(j));
        let (two, one) = others.split_at(j + 1);
        let block = Block::of([one[i], one[j], two[j]]);
        let (one, two) = (&one[..j], &two[..j]);
        let [solved, other] = &mut self.solved;
        block.solve([one, two], [solved, other]);
        subtract(rest, [one, two], [&solved[..j], &other[..j]], &mut self.terms[..j]);
        if total.carries_errors {
            self.pivots[0][..j].copy_from_slice(one);
            self.pivots[1][..j].copy_from_slice(two);
        }
        self.count = j;
        self.multiply_by_two(&block, [i, j], total);
        if total.carries_errors {
            self.carry_errors([self.errors[i], self.errors[j]]);
        }
    }

    /// Pivots on two variables, of which the second one flips on the boundary and the first one, too, or leaves as the last one.
    pub(super) fn pivot_on_two(&mut self, places: [usize; 2], after: After, total: &mut Total<S>) {
        let [i, j] = places;
        self.gather(0, i);
        self.gather(1, j);
        let block = Block::of([self.pivots[0][i], self.pivots[0][j], self.pivots[1][j]]);
        self.multiply_by_two(&block, places, total);
        self.count -= usize::from(after == After::Leaves);
        let count = self.count;
        let pivots = [&self.pivots[0][..count], &self.pivots[1][..count]];
        let [solved, other] = &mut self.solved;
        block.solve(pivots, [solved, other]);
        subtract(
            &mut self.entries[..row(count)],
            pivots,
            [&solved[..count], &other[..count]],
            &mut self.terms[..count],
        );
        let errors = places.map(|place| self.errors[place]);
        if total.carries_errors {
            self.carry_errors(errors);
        }
        let [own, between, other] = block.inverse;
        let flipped = -self.signed(i, self.signed(j, between));
        let [of_own, cross, of_other] = block.inverse.map(|entry| entry.size().first() * entry.size().first());
        self.flip(j, 1, -other, cross * errors[0] + of_other * errors[1], total);
        if after == After::Flips {
            self.flip(i, 0, -own, of_own * errors[0] + cross * errors[1], total);
            self.entries[triangle::place(i, j)] = flipped;
        }
    }

    /// Multiplies Δ by a pivot on one variable, and counts it.
    fn multiply_by_one(&self, pivot: S, place: usize, total: &mut Total<S>) {
        total.multiply(self.signed(place, pivot), self.unit_power(place));
        total.count_if(pivot.is_negative());
    }

    /// Multiplies Δ by a pivot on two variables, and counts it.
    fn multiply_by_two(&self, block: &Block<S>, [i, j]: [usize; 2], total: &mut Total<S>) {
        let determinant = self.signed(i, self.signed(j, block.determinant));
        total.multiply(determinant, self.unit_power(i) + self.unit_power(j));
        let definite = S::Size::choose(block.is_first_negative, S::Size::of(2.0), S::Size::of(0.0));
        let negative = S::Size::choose(block.determinant.is_negative(), S::Size::of(1.0), definite);
        total.below = total.below + negative;
    }
}

/// A pivot on two variables.
struct Block<S: Scalar> {
    determinant: S,
    is_first_negative: S::Truth,
    /// The inverse: of the first variable, of both, of the second one.
    inverse: [S; 3],
}

impl<S: Scalar> Block<S> {
    /// The block with these entries.
    #[inline(always)]
    fn of([a, b, c]: [S; 3]) -> Self {
        let determinant = a * c - b * b;
        let inverse = S::one() / determinant;
        let inverse = [c * inverse, -(b * inverse), a * inverse];
        Block { determinant, is_first_negative: a.is_negative(), inverse }
    }

    /// Divides the rows of both variables by the block.
    #[inline(always)]
    fn solve(&self, [one, two]: [&[S]; 2], [solved, other_solved]: [&mut [S]; 2]) {
        let [own, between, other] = self.inverse;
        for (((one, two), solved), other_solved) in one.iter().zip(two).zip(solved).zip(other_solved) {
            *solved = own * *one + between * *two;
            *other_solved = between * *one + other * *two;
        }
    }
}

/// Takes the products of the rows of pivots with their own columns from a triangle: `M_kl -= Σ_P M_kP (D⁻¹M)_Pl`. Notes the sizes of the
/// terms on the diagonal.
#[inline(always)]
fn subtract<S: Scalar, const N: usize>(
    triangle: &mut [S],
    pivots: [&[S]; N],
    solved: [&[S]; N],
    largest_terms: &mut [f64],
) {
    let mut rest = triangle;
    for (k, largest) in largest_terms.iter_mut().enumerate() {
        let (entries, others) = rest.split_at_mut(k + 1);
        rest = others;
        let factors = pivots.map(|pivot| pivot[k]);
        if factors.into_iter().all(S::is_constant_zero) {
            continue;
        }
        let mut term = 0.0;
        for (factor, solved) in factors.into_iter().zip(solved) {
            term += factor.size().first() * solved[k].size().first();
            for (entry, solved) in entries.iter_mut().zip(solved) {
                *entry -= factor * *solved;
            }
        }
        *largest = if term > *largest { term } else { *largest };
    }
}
