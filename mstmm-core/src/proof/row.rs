//! Rows: what a displacement of an end is of the variables of a front.

use crate::element::Exact;
use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::word::Word;

/// Most terms of the row of a member's end, or of the difference of two: of the three variables of each of two nodes.
pub(crate) const TERMS: usize = 6;

/// A variable and its coefficient.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term<N: Number> {
    pub(crate) variable: usize,
    pub(crate) coefficient: Ball<N>,
    /// Whether the coefficient is 1.
    is_one: bool,
}

/// A sum of variables with their coefficients.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<N: Number, const T: usize = TERMS> {
    terms: [Term<N>; T],
    count: usize,
}

/// Whether a ball is zero exactly.
#[inline(always)]
pub(crate) fn is_zero<N: Number>(ball: &Ball<N>) -> bool {
    ball.mid.leading().vanishes() && ball.rad.vanishes()
}

impl<N: Level<Word = f64, Alone = N>, const T: usize> Row<N, T> {
    /// No variable: what does not move.
    #[inline(always)]
    pub(crate) fn none() -> Self {
        Row { terms: [Term { variable: 0, coefficient: Ball::of(0.0), is_one: false }; T], count: 0 }
    }

    /// A variable alone.
    #[inline(always)]
    pub(crate) fn of(variable: usize) -> Self {
        let mut row = Row::none();
        row.terms[0] = Term { variable, coefficient: Ball::of(1.0), is_one: true };
        row.count = 1;
        row
    }

    /// The terms.
    #[inline(always)]
    pub(crate) fn terms(&self) -> &[Term<N>] {
        &self.terms[..self.count]
    }

    /// Adds a row times a number.
    #[inline(always)]
    pub(crate) fn add<const U: usize>(&mut self, other: &Row<N, U>, factor: Ball<N>) {
        if is_zero(&factor) {
            return;
        }
        for term in other.terms() {
            let coefficient = term.times(factor);
            if let Some(place) = self.terms().iter().position(|own| own.variable == term.variable) {
                let sum = self.terms[place].coefficient + coefficient;
                if is_zero(&sum) {
                    self.count -= 1;
                    self.terms.swap(place, self.count);
                } else {
                    self.terms[place] = Term { coefficient: sum, is_one: is_one(&sum), ..self.terms[place] };
                }
            } else {
                self.push(Term { variable: term.variable, coefficient, is_one: is_one(&coefficient) });
            }
        }
    }

    /// Adds a term of a variable that is not in it.
    #[inline(always)]
    fn push(&mut self, term: Term<N>) {
        if self.count < T {
            self.terms[self.count] = term;
            self.count += 1;
        } else {
            // no row of a model has so many: nothing is known of it
            self.terms[0].coefficient.rad = N::Word::of(f64::INFINITY);
        }
    }

    /// Whether a variable is in it.
    pub(crate) fn contains(&self, variable: usize) -> bool {
        self.terms().iter().any(|term| term.variable == variable)
    }

    /// The row with a combination of others in the place of a variable.
    pub(crate) fn substituted<const U: usize>(&self, variable: usize, by: &Row<N, U>) -> Self {
        let mut row = Row::none();
        for term in self.terms() {
            if term.variable == variable {
                row.add(by, term.coefficient);
            } else {
                row.add(&Row::<N, 1>::of(term.variable), term.coefficient);
            }
        }
        row
    }

    /// The row in room for another number of terms.
    #[inline(always)]
    pub(crate) fn widened<const U: usize>(&self) -> Row<N, U> {
        let mut row = Row::none();
        self.terms().iter().for_each(|term| row.push(*term));
        row
    }
}

/// Whether a ball is 1 exactly.
#[inline(always)]
pub(crate) fn is_one<N: Number>(ball: &Ball<N>) -> bool {
    let rest = ball.mid.minus(N::of(1.0));
    rest.leading().vanishes() && ball.rad.vanishes()
}

impl<N: Level> Term<N> {
    /// A number times the coefficient.
    #[inline(always)]
    pub(crate) fn times<M: Level<Alone = N>>(&self, factor: Ball<M>) -> Ball<M> {
        if self.is_one {
            return factor;
        }
        let coefficient = Ball::everywhere(self.coefficient);
        if is_one(&factor) {
            coefficient
        } else if is_one(&-factor) {
            -coefficient
        } else {
            factor * coefficient
        }
    }
}

/// The difference of two parameters.
#[inline(always)]
pub(crate) fn difference<N: Level>(from: Exact, to: Exact) -> Ball<N> {
    if from == to {
        return Ball::of(0.0);
    }
    let [from, to] = [from, to].map(Ball::of_pair);
    to - from
}

#[cfg(test)]
impl<N: Number> Term<N> {
    /// A variable with a coefficient.
    pub(crate) fn new(variable: usize, coefficient: Ball<N>) -> Self {
        Term { variable, coefficient, is_one: false }
    }
}
