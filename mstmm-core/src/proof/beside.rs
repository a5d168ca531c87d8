//! What is known beside estimates: bounds of the count at both ends of the narrowest intervals, of several estimates in the same runs.

use crate::number::Real;
use crate::proof::certificate::{Bound, Point, Precision, Prover, share_of, zero_of};
use crate::proof::count::Side;
use core::array::from_fn;

/// Estimates whose runs are made at once.
pub(crate) const AT_ONCE: usize = 8;

/// Times that an estimate is moved to the zero of Δ between its ends.
const MOVES: usize = 4;

/// Relative distance to which the zero of Δ between two neighbouring numbers is followed: from farther away it is no better than a guess.
const FOLLOWED: f64 = 1e-6;

/// What is known beside an estimate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Evidence<T> {
    /// The zero of Δ, as far as it was followed.
    pub(crate) omega: T,
    pub(crate) ends: [T; 2],
    /// A bound of the count from above at the lower end, and one from below at the upper end.
    pub(crate) bounds: [Bound; 2],
}

impl<T: Real> Evidence<T> {
    /// The numbers next to an estimate, about which nothing is known.
    pub(crate) fn around(omega: T) -> Self {
        Evidence { omega, ends: [omega.next_below(), omega.next_above()], bounds: [Bound::UNKNOWN; 2] }
    }

    /// Whether a frequency is proven to be between the ends.
    fn is_proven(&self) -> bool {
        let [most, least] = self.bounds.map(|bound| bound.count);
        most.is_some() && most < least
    }

    /// The numbers next to the zero of Δ, if nothing is proven and it is near.
    fn moved(&self) -> Option<Self> {
        let moved = zero_of(self.ends, self.bounds);
        let is_near = (moved - self.omega).abs() < self.omega * T::from_f64(FOLLOWED);
        (!self.is_proven() && is_near && moved != self.omega).then(|| Self::around(moved))
    }

    /// The number between two ends of which a frequency is proven to be between, if it is one, as a lower or an upper end.
    fn middle(&self, as_upper: bool) -> Option<Point<T>> {
        let middle = self.ends[0].next_above();
        let side = if as_upper { Side::AtLeast } else { Side::AtMost };
        (self.is_proven() && middle < self.ends[1]).then_some(Point { omega: middle, side })
    }

    /// Takes a number between both ends for one of them, if all frequencies are proven to be on the other side.
    fn narrow(&mut self, point: Point<T>, bound: Bound) {
        let Point { omega, side } = point;
        match side {
            Side::AtLeast if bound.count >= self.bounds[1].count => (self.ends[1], self.bounds[1]) = (omega, bound),
            Side::AtMost if bound.count.is_some() && bound.count <= self.bounds[0].count => {
                (self.ends[0], self.bounds[0]) = (omega, bound);
            }
            _ => {}
        }
    }
}

impl Prover<'_> {
    /// What is known beside up to [`AT_ONCE`] estimates; those beyond their number repeat the last one.
    pub(crate) fn beside<T: Real>(&mut self, estimates: &[T], precision: Precision) -> [Evidence<T>; AT_ONCE] {
        let count = estimates.len().min(AT_ONCE);
        let mut all: [_; AT_ONCE] = from_fn(|k| Evidence::around(estimates[k.min(count - 1)]));
        let mut is_open: [_; AT_ONCE] = from_fn(|k| k < count);
        for round in 1..=MOVES {
            let ends = |found: &Evidence<T>, open: bool| {
                let [lower, upper] = found.ends;
                let points = [Point { omega: lower, side: Side::AtMost }, Point { omega: upper, side: Side::AtLeast }];
                points.map(|point| open.then_some(point))
            };
            let points: [_; AT_ONCE] = from_fn(|k| ends(&all[k], is_open[k]));
            let bounds = self.bounds_at::<T, { 2 * AT_ONCE }>(points.as_flattened(), precision);
            for (k, found) in all.iter_mut().enumerate() {
                if !is_open[k] {
                    continue;
                }
                found.bounds = [bounds[2 * k], bounds[2 * k + 1]];
                match found.moved() {
                    Some(moved) if round < MOVES => *found = moved,
                    _ => is_open[k] = false,
                }
            }
            if is_open == [false; AT_ONCE] {
                break;
            }
        }
        let is_lower = all.map(|found| share_of(found.bounds) < 0.5);
        for is_other in [false, true] {
            let points: [_; AT_ONCE] =
                from_fn(|k| if k < count { all[k].middle(is_lower[k] != is_other) } else { None });
            let bounds = self.bounds_at::<T, AT_ONCE>(&points, precision);
            for (k, point) in points.into_iter().enumerate() {
                point.into_iter().for_each(|point| all[k].narrow(point, bounds[k]));
            }
        }
        all
    }
}
