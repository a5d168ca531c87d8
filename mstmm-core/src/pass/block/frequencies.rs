//! The frequencies of all lanes with their powers, a column for each number.

use crate::number::{BranchFree, Frequency, FrequencyPowers, InColumns};
use crate::pass::block::WIDTH;
use crate::pass::block::loops::{Task, widest};
use core::marker::PhantomData;

/// The frequencies of a block with their powers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frequencies<S: InColumns> {
    x: S::Columns<WIDTH>,
    powers: [S::Columns<WIDTH>; 9],
}

impl<S: InColumns> Frequencies<S> {
    /// Frequencies of zero.
    pub(crate) fn new() -> Self {
        Frequencies { x: S::zero().columns(), powers: [S::zero().columns(); 9] }
    }

    /// Takes frequencies, at most one per lane; the last fills the lanes that remain. Returns whether there were any.
    pub(crate) fn take<T>(&mut self, frequencies: &[S]) -> bool
    where
        S: Frequency<T>,
        BranchFree<S, false>: Frequency<T>,
    {
        let Some(&last) = frequencies.last() else { return false };
        let filled: [S; WIDTH];
        let all = match frequencies.first_chunk() {
            Some(all) => all,
            None => {
                filled = core::array::from_fn(|lane| frequencies.get(lane).copied().unwrap_or(last));
                &filled
            }
        };
        if !widest(Powers::<S, T> { of: all, to: self, parameter: PhantomData }) {
            self.take_roots_alone::<T>(all);
        }
        true
    }

    /// Sets the frequencies whose branch-free square root is NaN.
    #[cold]
    fn take_roots_alone<T>(&mut self, all: &[S; WIDTH])
    where
        S: Frequency<T>,
    {
        for (lane, &x) in all.iter().enumerate() {
            if self.lane(lane, |number| number).powers[0].size().is_nan() {
                self.set(lane, FrequencyPowers::new::<T>(x, true), |number| number);
            }
        }
    }

    /// Sets the frequency in a lane, from another scalar.
    #[inline(always)]
    fn set<X>(&mut self, lane: usize, at: FrequencyPowers<X>, number: impl Fn(X) -> S) {
        let FrequencyPowers { x, lambda_squared, powers: [s, s2, s3, s4], inverse_powers: [i, i2, i3, i4] } = at;
        number(x).put(&mut self.x, lane);
        for (column, power) in self.powers.iter_mut().zip([lambda_squared, s, s2, s3, s4, i, i2, i3, i4]) {
            number(power).put(column, lane);
        }
    }

    /// The frequency in a lane, over another scalar.
    #[inline(always)]
    pub(crate) fn lane<X>(&self, lane: usize, number: impl Fn(S) -> X) -> FrequencyPowers<X> {
        let power = |column: usize| number(S::get(&self.powers[column], lane));
        FrequencyPowers {
            x: number(S::get(&self.x, lane)),
            lambda_squared: power(0),
            powers: [power(1), power(2), power(3), power(4)],
            inverse_powers: [power(5), power(6), power(7), power(8)],
        }
    }
}

/// The powers of frequencies by branch-free numbers.
struct Powers<'a, S: InColumns, T> {
    of: &'a [S; WIDTH],
    to: &'a mut Frequencies<S>,
    parameter: PhantomData<T>,
}

impl<T, S: Frequency<T> + InColumns> Task for Powers<'_, S, T>
where
    BranchFree<S, false>: Frequency<T>,
{
    /// Whether all frequencies have a branch-free square root.
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let mut are_good = true;
        for lane in 0..WIDTH {
            let at = FrequencyPowers::new::<T>(BranchFree::<S, false>(self.of[lane]), true);
            are_good &= !at.powers[0].0.size().is_nan();
            self.to.set(lane, at, |number| number.0);
        }
        are_good
    }
}
