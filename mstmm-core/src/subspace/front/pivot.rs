//! Pivots on one and two variables, which leave the front or change their kind.

use crate::number::{Scalar, Size};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::total::Total;

/// What becomes of a variable that was a pivot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum After {
    /// It is eliminated.
    Leaves,
    /// It stays as the other kind: of the displacement of a port its force, or the other way round.
    Flips,
}

impl<S: Scalar, const W: usize> Front<S, W> {
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

    /// Takes the products of the rows of pivots with their own columns from all others: `M_kl -= Σ_P M_kP (D⁻¹M)_Pl`.
    #[inline(always)]
    fn subtract<const N: usize>(&mut self, pivots: [usize; N], carries_errors: bool) {
        if carries_errors {
            self.carry_errors(pivots);
        }
        let (from, count) = (self.next, self.count);
        for row in from..count {
            let entries = &mut self.entries[row];
            let factors = pivots.map(|pivot| entries[pivot]);
            if pivots.contains(&row) || factors.iter().all(S::is_zero) {
                continue;
            }
            let mut term = 0.0;
            for (k, factor) in factors.iter().enumerate() {
                let solved = &self.solved[k];
                term += factor.size().first() * solved[row].size().first();
                for (entry, solved) in entries[from..count].iter_mut().zip(&solved[from..count]) {
                    *entry -= *factor * *solved;
                }
            }
            self.terms[row] = if term > self.terms[row] { term } else { self.terms[row] };
        }
    }

    /// Carries what rounding has done to the rows of pivots to all others, with what these lose by them.
    #[cold]
    fn carry_errors<const N: usize>(&mut self, pivots: [usize; N]) {
        let (from, count) = (self.next, self.count);
        let mut largest = [0.0_f64; N];
        for (largest, solved) in largest.iter_mut().zip(&self.solved) {
            *largest = solved[from..count].iter().fold(0.0, |largest, entry| entry.size().first().max(largest));
        }
        for row in (from..count).filter(|row| !pivots.contains(row)) {
            let (mut of_row, mut inherited) = (0.0, 0.0);
            for (k, pivot) in pivots.into_iter().enumerate() {
                let (factor, part) = (self.size(row, pivot), self.solved[k][row].size().first());
                of_row += factor * largest[k];
                inherited += part * part * self.errors[pivot];
            }
            self.note_error(row, of_row.max(inherited));
        }
    }

    /// Writes the row of a pivot as that of the other kind, given which of the solved rows is its own, and its error; entries among pivots
    /// follow apart.
    fn flip_row(&mut self, place: usize, own: usize, error: f64, total: &mut Total<S>) {
        for other in self.next..self.count {
            let entry = self.signed(place, self.solved[own][other]);
            self.entries[place][other] = entry;
            self.entries[other][place] = entry;
        }
        self.terms[place] = 0.0;
        if total.carries_errors {
            let entries = self.entries[place][self.next..self.count].iter();
            self.errors[place] = entries.fold(error, |largest, entry| entry.size().first().max(largest));
        }
        if !self.variables[place].is_force {
            total.count(-1.0);
        }
    }

    /// Pivots on one variable. One that leaves is the next one.
    pub(super) fn pivot_on_one(&mut self, place: usize, after: After, total: &mut Total<S>) {
        let pivot = self.entries[place][place];
        let inverse = S::one() / pivot;
        for (solved, entry) in self.solved[0][..self.count].iter_mut().zip(&self.entries[place][..self.count]) {
            *solved = *entry * inverse;
        }
        self.next += usize::from(after == After::Leaves);
        self.subtract([place], total.carries_errors);
        total.multiply(self.signed(place, pivot), self.unit_power(place));
        total.count_if(pivot.is_negative());
        if after == After::Flips {
            let size = inverse.size().first();
            self.flip_row(place, 0, size * size * self.errors[place], total);
            self.entries[place][place] = -inverse;
            self.variables[place].is_force ^= true;
        }
    }

    /// Pivots on two variables. Those that leave are the next ones.
    pub(super) fn pivot_on_two(&mut self, places: [usize; 2], after: [After; 2], total: &mut Total<S>) {
        let [i, j] = places;
        let (a, b, c) = (self.entries[i][i], self.entries[i][j], self.entries[j][j]);
        let determinant = a * c - b * b;
        let inverse = S::one() / determinant;
        let (own, between, other) = (c * inverse, -(b * inverse), a * inverse);
        for column in self.next..self.count {
            let (one, two) = (self.entries[i][column], self.entries[j][column]);
            self.solved[0][column] = own * one + between * two;
            self.solved[1][column] = between * one + other * two;
        }
        self.next += after.into_iter().filter(|after| *after == After::Leaves).count();
        self.subtract(places, total.carries_errors);
        let signed = self.signed(i, self.signed(j, determinant));
        total.multiply(signed, self.unit_power(i) + self.unit_power(j));
        let definite = S::Size::choose(a.is_negative(), S::Size::of(2.0), S::Size::of(0.0));
        total.below = total.below + S::Size::choose(determinant.is_negative(), S::Size::of(1.0), definite);
        let flipped = -self.signed(i, self.signed(j, between));
        let errors = places.map(|place| self.errors[place]);
        let square = |number: S| number.size().first() * number.size().first();
        let cross = square(between);
        let errors = [square(own) * errors[0] + cross * errors[1], cross * errors[0] + square(other) * errors[1]];
        for k in (0..2).filter(|k| after[*k] == After::Flips) {
            self.flip_row(places[k], k, errors[k], total);
        }
        for (k, diagonal) in [own, other].into_iter().enumerate().filter(|(k, _)| after[*k] == After::Flips) {
            self.entries[places[k]][places[k]] = -diagonal;
            self.variables[places[k]].is_force ^= true;
        }
        if after == [After::Flips; 2] {
            self.entries[i][j] = flipped;
            self.entries[j][i] = flipped;
        }
    }
}
