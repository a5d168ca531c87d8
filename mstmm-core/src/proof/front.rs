//! The elimination of a symmetric matrix whose errors are given to their own pivots: a bound of the number of its negative eigenvalues.
//!
//! A front holds the variables that are not eliminated yet. Parts are added, variables leave. What an entry may be off by is collected for the
//! rows, as [the theorem](crate::proof) wants it: the exact matrix is no lower than the stored one less the errors on its diagonal, and no
//! higher than the stored one with them added.

use crate::number::{Scalar, Size};
use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::member::{any, place};
use crate::proof::number::{Number, UNDERFLOW};
use crate::proof::row::Term;
use crate::proof::word::{Word, apart};

/// A variable in a front.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variable<W> {
    /// What its row may be off by, times its weight.
    error: W,
    /// The weight w by which the error δ of an entry is shared: `δ w_j/w_i` to row i and `δ w_i/w_j` to row j. Any positive number is valid; the
    /// inverse root of the stiffness of the row is sharp.
    weight: f64,
    /// The sizes of the terms of its diagonal entry, from which the weight follows.
    size: f64,
    is_taken: bool,
    /// While a variable leaves: the rows that it touches, from the first place on.
    touched: usize,
}

impl<W: Word> Variable<W> {
    /// No variable.
    #[inline(always)]
    pub(crate) fn none() -> Self {
        Variable { error: W::of(0.0), weight: 1.0, size: 0.0, is_taken: false, touched: 0 }
    }
}

/// A front in memory for its lower triangle, row after row, and for its variables.
#[derive(Debug)]
pub(crate) struct Front<'m, N: Number> {
    entries: &'m mut [N],
    variables: &'m mut [Variable<N::Word>],
    /// Number of places that are in use or were.
    width: usize,
    /// -1 in lanes that are bounded from above: pivots are moved down there; 1 in those that are bounded from below.
    toward: N::Word,
    pub(crate) total: Total<N::Word>,
}

/// What the pivots so far tell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Total<W> {
    /// The number of negative pivots; NaN in a lane in which a bound was lost.
    pub(crate) negative: W,
    /// Their product over powers of two that are the same in all lanes, as near as words are: it decides nothing.
    pub(crate) product: W,
    pub(crate) exponent: i64,
    /// The node or the step whose variables leave.
    pub(crate) place: usize,
    /// The smallest pivot beside the terms of its diagonal entry, in the first lane, and its place.
    pub(crate) smallest: f64,
    pub(crate) smallest_at: usize,
}

/// What a million million errors lose where they underflow: each less than the smallest normal number, of the error itself or of that times its
/// weight.
const UNDERFLOWS: f64 = 1e-280;

/// The least positive number: only zero is below it in size.
const LEAST: f64 = f64::from_bits(1);

/// What a pivot becomes that is zero: any number on the right side of zero is valid.
const SMALLEST_PIVOT: f64 = 1e-250;

/// Size of a pivot, beside the terms of its entry, below which its variable waits. The bound is valid whatever it is. A row that stays gets the
/// quotient by the pivot, with its rounding: at 1e-3 the bound loses three of 32 digits, where a pivot that vanishes loses half of them. Pivots do
/// vanish at frequencies of a system: a beam on a pin with a free end has those of one with that end clamped.
const SMALL_PIVOT: f64 = 1e-3;

/// Errors are sums of rounded positive numbers, of up to 9e9 of them: each sum loses u of itself at most. A joint of a million members adds some ten
/// million. The squares of rounding in the parts of errors are covered by it, too.
const ADDED_UP: f64 = 1.0 + 1e-6;

/// The residual of an inverse below which that is one: what a quotient by it is off by is known to a relative `1e-10` then.
const NEAR_INVERSE: f64 = 1e-11;

/// Factor between the sizes of a row at which its weight is found anew.
const GROWTH: f64 = 16.0;

impl<'m, N: Number> Front<'m, N> {
    /// An empty front.
    #[inline(always)]
    pub(crate) fn new(entries: &'m mut [N], variables: &'m mut [Variable<N::Word>], toward: N::Word) -> Self {
        let total = Total {
            negative: N::Word::of(0.0),
            product: N::Word::of(1.0),
            exponent: 0,
            place: 0,
            smallest: f64::INFINITY,
            smallest_at: 0,
        };
        Front { entries, variables, width: 0, toward, total }
    }

    /// Whether the count of a lane is bounded from above.
    #[inline(always)]
    pub(crate) fn is_bounded_above(&self) -> <N::Word as Word>::Mask {
        self.toward.is_less(N::Word::of(0.0))
    }

    /// Takes a place for a variable; none where there is no room.
    #[inline(always)]
    pub(crate) fn enter(&mut self) -> Option<usize> {
        enter(self)
    }

    /// Tells a variable that its diagonal entry gets a term of this size.
    #[inline(always)]
    pub(crate) fn grow(&mut self, variable: usize, size: f64) {
        let own = &mut self.variables[variable];
        if !(size > 0.0 && size < f64::INFINITY) {
            return;
        }
        let before = own.size;
        own.size += size;
        if own.size > before * GROWTH {
            let weight = inverse_root(own.size);
            own.error = own.error * N::Word::of(weight / own.weight);
            own.weight = weight;
        }
    }

    /// The size of the terms of the diagonal entry of a variable.
    pub(crate) fn size(&self, variable: usize) -> f64 {
        self.variables[variable].size
    }

    /// Adds a ball to an entry and to its mirror image.
    #[inline(always)]
    pub(crate) fn add(&mut self, row: usize, column: usize, ball: Ball<N>) {
        let entry = &mut self.entries[place(row, column)];
        *entry = entry.plus(ball.mid);
        let off = ball.rad + N::Word::of(N::SUM) * entry.size() + N::Word::of(UNDERFLOW);
        let weights = [self.variables[column].weight, self.variables[row].weight];
        self.variables[row].add_error(off, weights[0]);
        if row != column {
            self.variables[column].add_error(off, weights[1]);
        }
    }

    /// Eliminates a variable.
    #[inline(always)]
    pub(crate) fn leave(&mut self, variable: usize) {
        leave(self, variable, true);
    }

    /// Eliminates a variable, unless its pivot is small in some lane. Returns whether it has left.
    #[inline(always)]
    pub(crate) fn leave_if_large(&mut self, variable: usize) -> bool {
        leave(self, variable, false)
    }

    /// The pivot of a variable beside the terms of its diagonal entry, in the first lane.
    #[inline(always)]
    pub(crate) fn share(&self, variable: usize) -> f64 {
        share(self, variable)
    }

    /// What underflow does to a row while a variable leaves, times the weight of the row.
    ///
    /// A factor is off by `UNDERFLOW`, hence an entry by `UNDERFLOW (1 + |a|)` with its product: row i has `UNDERFLOW (1 + |a_j|) w_j` of each row j.
    /// The sum over j is at most the product of the sums of both. The terms of errors lose far less than `UNDERFLOW (1 + w_j)`.
    #[inline(always)]
    fn underflows(&self, variable: usize, touched: usize) -> N::Word {
        let (mut sizes, mut weights) = (N::Word::of(1.0), 0.0);
        for listed in &self.variables[..touched] {
            sizes = sizes + self.entries[place(listed.touched, variable)].size();
            weights += 1.0 + self.variables[listed.touched].weight;
        }
        sizes * N::Word::of(2.0 * UNDERFLOW * weights)
    }

    /// Whether an entry of the column of a variable is not zero in some lane.
    #[inline(always)]
    fn is_coupled(&self, row: usize, variable: usize) -> bool {
        row != variable && self.variables[row].is_taken && !self.entries[place(row, variable)].leading().vanishes()
    }

    /// Lists the rows that are coupled to a variable; returns their number.
    #[inline(always)]
    fn touch(&mut self, variable: usize) -> usize {
        let mut count = 0;
        for row in 0..self.width {
            if self.is_coupled(row, variable) {
                self.variables[count].touched = row;
                count += 1;
            }
        }
        count
    }
}

apart! {
    /// See [`Front::enter`].
    fn enter<N: Number>(front: &mut Front<'_, N>) -> Option<usize> {
        let free = front.variables[..front.width].iter().position(|variable| !variable.is_taken);
        let place_of = match free {
            Some(free) => free,
            None if front.width < front.variables.len() => {
                front.width += 1;
                front.width - 1
            }
            None => return None,
        };
        front.variables[place_of] = Variable { is_taken: true, ..Variable::none() };
        for other in 0..front.width {
            front.entries[place(place_of, other)] = N::of(0.0);
        }
        Some(place_of)
    }

    /// See [`Front::share`].
    fn share<N: Number>(front: &Front<'_, N>, variable: usize) -> f64 {
        front.entries[place(variable, variable)].size().first() / front.variables[variable].size
    }

    /// See [`Front::leave`] and [`Front::leave_if_large`].
    fn leave<N: Number>(front: &mut Front<'_, N>, variable: usize, even_if_small: bool) -> bool {
        let word = N::Word::of;
        let own = front.variables[variable];
        let entry = front.entries[place(variable, variable)];
        if !even_if_small && any::<N::Word>(entry.size().is_less(word(SMALL_PIVOT * own.size))) {
            return false;
        }
        front.variables[variable].is_taken = false;
        // 2.1 SUM |entry| covers the rounding of the sum with the nudge, and that |entry| is taken by its leading word
        let nudge = own.own_error() + entry.size() * word(2.1 * N::SUM);
        let moved = entry.plus(N::of_word(front.toward * nudge));
        // not of a NaN, which stays one
        let is_zero = moved.size().is_less(word(LEAST));
        let pivot = N::select(is_zero, N::of_word(front.toward * word(SMALLEST_PIVOT)), moved);
        front.total.include(pivot.leading(), own.weight);
        let inverse = pivot.near_inverse();
        let residual = N::of(1.0).minus(pivot.times(inverse)).size() + word(1.01 * N::PRODUCT + N::SUM);
        let of_inverse =
            N::Word::select(residual.is_less(word(NEAR_INVERSE)), residual * word(1.0 + 1e-10), word(f64::INFINITY));
        // of the factor l and of the product t = a l
        let of_product = of_inverse + word(2.02 * N::PRODUCT);
        let touched = front.touch(variable);
        let of_row = of_product * word(touched as f64);
        let underflows = front.underflows(variable, touched);
        for k in 0..touched {
            let row = front.variables[k].touched;
            let a = front.entries[place(row, variable)];
            let factor = a.times(inverse);
            // |a_i a_j/d - t| shared by |a_i/a_j|: each row has the same part of its own |a_i l_i|
            let weight = front.variables[row].weight;
            let mut error = of_row * (factor.size() * a.size()) * word(weight) + underflows;
            for j in 0..=k {
                let column = front.variables[j].touched;
                let beside = front.entries[place(column, variable)];
                let entry = &mut front.entries[place(row, column)];
                *entry = entry.minus(factor.times(beside));
                let off = word(N::SUM) * entry.size();
                error = error + off * word(front.variables[column].weight);
                if j < k {
                    front.variables[column].add_error(off, weight);
                }
            }
            front.variables[row].error = front.variables[row].error + error;
        }
        true
    }

    /// Puts a combination of other variables in the place of one, which no part knows any more: the exact matrix is transformed by exact
    /// coefficients, of which these are balls.
    pub(crate) fn substitute<N: Level>(front: &mut Front<'_, N>, variable: usize, row: &[Term<N::Alone>]) {
        let word = N::Word::of;
        let own = front.variables[variable];
        front.variables[variable].is_taken = false;
        let diagonal = Ball::<N>::exactly(front.entries[place(variable, variable)]);
        for &Term { variable: target, coefficient, .. } in row {
            let square = coefficient.largest() * coefficient.largest();
            front.grow(target, own.size * square);
            // e (Σ c y)² <= e n Σ c² y²
            let error = own.own_error() * word(row.len() as f64 * square);
            let weight = front.variables[target].weight;
            front.variables[target].add_error(error, weight);
        }
        for other in 0..front.width {
            if !front.is_coupled(other, variable) {
                continue;
            }
            let beside = Ball::exactly(front.entries[place(other, variable)]);
            for &Term { variable: target, coefficient, .. } in row {
                let term = Ball::everywhere(coefficient) * beside;
                front.add(target, other, if target == other { term.scaled(2.0) } else { term });
            }
        }
        for (index, &Term { variable: target, coefficient, .. }) in row.iter().enumerate() {
            let scaled = Ball::everywhere(coefficient) * diagonal;
            for (before, &Term { variable: other, coefficient: of_other, .. }) in row[..=index].iter().enumerate() {
                let term = scaled * Ball::everywhere(of_other);
                // two terms of one variable have their product twice in its square
                let is_twice = target == other && before < index;
                front.add(target, other, if is_twice { term.scaled(2.0) } else { term });
            }
        }
    }
}

impl<W: Word> Variable<W> {
    /// No less than the error of the row.
    #[inline(always)]
    fn own_error(&self) -> W {
        self.error * W::of(ADDED_UP / self.weight) + W::of(UNDERFLOWS * (1.0 + 1.0 / self.weight))
    }

    /// Adds a part of the error of an entry, given the weight of the other row.
    #[inline(always)]
    fn add_error(&mut self, off: W, weight: f64) {
        self.error = self.error + off * W::of(weight);
    }
}

impl<W: Word> Total<W> {
    /// Counts a pivot.
    #[inline(always)]
    fn include(&mut self, pivot: W, weight: f64) {
        // zero times what is not finite is NaN
        self.negative = self.negative + pivot.one_if_negative() + pivot * W::of(0.0);
        let in_units = pivot * W::of(weight) * W::of(weight);
        let size = in_units.size().first();
        if size < self.smallest {
            (self.smallest, self.smallest_at) = (size, self.place);
        }
        self.multiply(in_units);
    }

    /// Multiplies the product by a number, and moves it back into the range by a power of two.
    #[inline(always)]
    pub(crate) fn multiply(&mut self, factor: W) {
        self.product = self.product * factor;
        if let Some(exponent) = Size::exponent(self.product.size().first())
            && exponent.abs() > 200
        {
            self.product = self.product * W::of(f64::from(-exponent)).power_of_two();
            self.exponent += i64::from(exponent);
        }
    }
}

/// What tests look at and set.
#[cfg(test)]
impl<N: Number<Word = f64>> Front<'_, N> {
    /// What the pivot of a variable would be moved by, but for the rounding of that sum.
    pub(crate) fn error(&self, variable: usize) -> f64 {
        self.variables[variable].own_error()
    }

    pub(crate) fn entry(&self, row: usize, column: usize) -> N {
        self.entries[place(row, column)]
    }

    /// Puts a number in the place of an entry and of its mirror image, without an error.
    pub(crate) fn put(&mut self, row: usize, column: usize, number: N) {
        self.entries[place(row, column)] = number;
    }

    /// Adds to the error of a variable.
    pub(crate) fn disturb(&mut self, variable: usize, by: f64) {
        self.variables[variable].error += by * self.variables[variable].weight;
    }
}

/// Nearly `1/√size`: a power of two.
fn inverse_root(size: f64) -> f64 {
    1.0.times_power_of_two(Size::exponent(size).map_or(0, |exponent| -exponent / 2))
}
