//! A front with what has joined it, and the variables that wait.

use crate::element::DampingNumbers;
use crate::proof::ball::Ball;
use crate::proof::front::Front;
use crate::proof::join::{Failure, Join};
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::row::Term;
use crate::proof::word::Word;

/// The terms of a row.
pub(crate) type Terms<'r, N> = &'r [Term<<N as Level>::Alone>];

/// Most variables that wait; others leave at once, which is valid in any order.
pub(crate) const MOST_WAITING: usize = 48;

/// A front with what has joined it at a frequency.
#[derive(Debug)]
pub(crate) struct Joining<'m, N: Number> {
    pub(crate) front: Front<'m, N>,
    /// ω², of either sign.
    pub(crate) square: Ball<N>,
    /// ω; 0 where ω² is negative, at which nothing spins.
    pub(crate) omega: Ball<N>,
    /// The sum of the counts with held ends: of upper bounds in lanes that are bounded from above, of lower ones in the others.
    pub(crate) held: N::Word,
    /// Variables that leave behind others, borders and those with small pivots, each with the node or the step where it would have left.
    pub(crate) waiting: [(usize, usize); MOST_WAITING],
    pub(crate) waiting_count: usize,
    /// Why nothing is known; none so far.
    pub(crate) failure: Option<Failure>,
}

impl<'m, N: Level> Joining<'m, N> {
    /// A front that nothing has joined.
    #[inline(always)]
    pub(crate) fn new(front: Front<'m, N>, [square, omega]: [Ball<N>; 2]) -> Self {
        let held = N::Word::of(0.0);
        Joining { front, square, omega, held, waiting: [(0, 0); MOST_WAITING], waiting_count: 0, failure: None }
    }

    /// Lets a variable leave behind those of the end that leaves first: before that its pivot may be a pole.
    #[inline(always)]
    pub(crate) fn leaves_behind(&mut self, variable: usize) {
        if self.waiting_count < MOST_WAITING {
            self.waiting[self.waiting_count] = (variable, self.front.total.place);
            self.waiting_count += 1;
        } else {
            self.front.leave(variable);
        }
    }

    /// Eliminates all variables that wait, largest pivot first.
    pub(crate) fn leave_all(&mut self) {
        self.leave_behind();
        while self.waiting_count > 0 {
            let share = |k: &usize| self.front.share(self.waiting[*k].0);
            let largest = (0..self.waiting_count).max_by(|a, b| share(a).total_cmp(&share(b))).unwrap_or(0);
            let (variable, place) = self.waiting[largest];
            self.front.total.place = place;
            self.front.leave(variable);
            self.waiting_count -= 1;
            self.waiting.swap(largest, self.waiting_count);
        }
    }

    /// No count is known of what is damped.
    #[inline(always)]
    pub(crate) fn refuses(&mut self, damping: &DampingNumbers) -> bool {
        let is_damped = !damping.is_none();
        if is_damped {
            self.failure = Some(Failure::NotInNumbers);
        }
        is_damped
    }
}
