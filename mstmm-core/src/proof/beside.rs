//! What is known beside estimates: bounds of the count at both ends of the narrowest intervals, of several estimates in the same runs.

use crate::number::Real;
use crate::proof::count::Side;
use crate::proof::prover::{Bound, Point, Precision, Prover, share_of};

/// Estimates whose runs are made at once: their ends fill three blocks of eight lanes.
pub(crate) const AT_ONCE: usize = 12;

/// Times that the ends are moved to the zero of Δ between them.
const MOVES: usize = 4;

/// Relative distance to which the zero of Δ between two neighbouring numbers is followed: from farther away it is no better than a guess.
const FOLLOWED: f64 = 1e-6;

/// Width, in units of eps, within which frequencies are one entry.
pub(crate) const ONE_ENTRY: f64 = 4.0;

/// What is known beside an estimate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Evidence<T> {
    pub(crate) ends: [T; 2],
    /// A bound of the count from above at the lower end, and one from below at the upper end.
    pub(crate) bounds: [Bound; 2],
    next: Next,
}

/// What is asked next.
#[derive(Clone, Copy, Debug)]
enum Next {
    /// The bounds at both ends, so many times at most.
    Ends(usize),
    /// The bound at the number between the ends, as an upper or a lower end; and whether it was neither the other way.
    Middle(Side, bool),
    Nothing,
}

impl<T: Real> Evidence<T> {
    /// The numbers next to an estimate, about which nothing is known.
    pub(crate) fn around(omega: T) -> Self {
        let ends = [omega.next_below(), omega.next_above()];
        Evidence { ends, bounds: [Bound::UNKNOWN; 2], next: Next::Ends(MOVES) }
    }

    /// The number between both ends, or the lower one of two neighbours.
    pub(crate) fn omega(&self) -> T {
        let [lower, upper] = self.ends;
        lower + (upper - lower) * T::from_f64(0.5)
    }

    /// Where bounds are wanted.
    fn asks(&self) -> [Option<Point<T>>; 2] {
        let [lower, upper] = self.ends;
        match self.next {
            Next::Ends(_) => {
                [Some(Point { omega: lower, side: Side::AtMost }), Some(Point { omega: upper, side: Side::AtLeast })]
            }
            Next::Middle(side, _) => [Some(Point { omega: lower.next_above(), side }), None],
            Next::Nothing => [None; 2],
        }
    }

    /// Takes the bounds.
    fn learn(&mut self, bounds: [Bound; 2]) {
        let [lower, upper] = self.ends;
        match self.next {
            Next::Ends(left) => {
                self.bounds = bounds;
                let [most, least] = bounds.map(|bound| bound.count);
                let is_proven = most.is_some() && most < least;
                self.next = Next::Nothing;
                if is_proven && lower.next_above() < upper {
                    let side = if share_of(bounds) < 0.5 { Side::AtLeast } else { Side::AtMost };
                    self.next = Next::Middle(side, false);
                } else if let (false, true, Some(ends)) = (is_proven, left > 1, self.moved()) {
                    (self.ends, self.next) = (ends, Next::Ends(left - 1));
                }
            }
            Next::Middle(side, is_second) => {
                let (middle, [bound, _]) = (lower.next_above(), bounds);
                let (end, other) = match side {
                    Side::AtLeast => (1, Side::AtMost),
                    Side::AtMost => (0, Side::AtLeast),
                };
                // all frequencies between the ends have to be on the other side
                let is_as_good = match side {
                    Side::AtLeast => bound.count >= self.bounds[1].count,
                    Side::AtMost => bound.count.is_some() && bound.count <= self.bounds[0].count,
                };
                if is_as_good {
                    (self.ends[end], self.bounds[end]) = (middle, bound);
                }
                self.next = if is_as_good || is_second { Next::Nothing } else { Next::Middle(other, true) };
            }
            Next::Nothing => {}
        }
    }

    /// The numbers next to the zero of Δ, if it is near; with a number more where they have been ends.
    fn moved(&self) -> Option<[T; 2]> {
        let [lower, upper] = self.ends;
        let offset = (upper - lower) * T::from_f64(share_of(self.bounds));
        let nearest = lower + offset;
        let is_near = offset.abs() < lower * T::from_f64(FOLLOWED);
        let ends =
            if nearest - lower <= offset { [nearest, nearest.next_above()] } else { [nearest.next_below(), nearest] };
        let is_new = |ends: [T; 2]| ends[0] < lower || upper < ends[1];
        let wider = [nearest.next_below(), nearest.next_above()];
        let ends = if is_new(ends) { ends } else { wider };
        (is_near && is_new(ends)).then_some(ends)
    }
}

/// What is known beside several estimates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beside<T> {
    /// One for each estimate.
    pub(crate) found: [Evidence<T>; AT_ONCE],
    /// Where it was asked for: the farthest number in one entry with the lower end of the last one, and a bound from below there.
    pub(crate) beyond: Option<(T, Bound)>,
}

impl<T: Real> Beside<T> {
    /// Nothing is known.
    pub(crate) fn nothing() -> Self {
        Beside { found: [Evidence::around(T::zero()); AT_ONCE], beyond: None }
    }

    /// What is known beside up to [`AT_ONCE`] estimates.
    pub(crate) fn of(prover: &mut Prover<'_>, estimates: &[T], precision: Precision) -> Self {
        let mut beside = Self::nothing();
        beside.find(prover, estimates, precision, false);
        beside
    }

    /// Finds what is known beside up to [`AT_ONCE`] estimates, and beyond the last one.
    pub(crate) fn find(&mut self, prover: &mut Prover<'_>, estimates: &[T], precision: Precision, and_beyond: bool) {
        let used = &mut self.found[..estimates.len()];
        let Some(last) = used.len().checked_sub(1) else { return };
        for (evidence, omega) in used.iter_mut().zip(estimates) {
            *evidence = Evidence::around(*omega);
        }
        self.beyond = None;
        let mut bounds = [Bound::UNKNOWN; 2 * AT_ONCE + 1];
        loop {
            let mut points = [None; 2 * AT_ONCE + 1];
            for (k, evidence) in used.iter().enumerate() {
                [points[2 * k], points[2 * k + 1]] = evidence.asks();
            }
            let asks_beyond = and_beyond && self.beyond.is_none() && !matches!(used[last].next, Next::Ends(_));
            let end = used[last].ends[0] + used[last].ends[0] * T::from_f64(ONE_ENTRY * T::EPSILON);
            points[2 * AT_ONCE] = asks_beyond.then_some(Point { omega: end, side: Side::AtLeast });
            if points.iter().all(Option::is_none) {
                return;
            }
            prover.bounds_at(&points, precision, &mut bounds);
            for (k, evidence) in used.iter_mut().enumerate() {
                evidence.learn([bounds[2 * k], bounds[2 * k + 1]]);
            }
            if asks_beyond {
                self.beyond = Some((end, bounds[2 * AT_ONCE]));
            }
        }
    }
}
