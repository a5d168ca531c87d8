//! The approach to a single root by several points at once, without derivatives.

#[cfg(feature = "std")]
use crate::number::InLanes;
use crate::number::{Scalar, Size, Task, run};
use crate::search::undamped::interpolation::{Real, Sample, at_zero, without_growth, zero_among};

/// Roots that are approached side by side.
pub(super) const ROOTS: usize = 8;

/// Relative error of the square root of a frequency at which it counts as settled.
const SETTLED: f64 = 5e-17;

/// Factor on the error of the first round, whose points lie far apart.
const FIRST_ERROR: f64 = 3.0;

/// Difference between the linear and the cubic start, as a part of the bracket, beyond which phases do not grow evenly.
const UNEVEN: f64 = 0.3;

/// Rounding that an estimate may carry beyond its bracket.
const OUTSIDE: f64 = 1e-14;

/// A number for each root.
pub(super) type PerRoot = [f64; ROOTS];

/// Single roots on their way, with `POINTS` points for each in a round.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approaches<const POINTS: usize> {
    /// Number of roots.
    pub(super) count: usize,
    /// Δ grows as `exp(growth s)`, where waves are long.
    pub(super) growth: PerRoot,
    /// Estimates of the square roots of the frequencies.
    pub(super) estimate: PerRoot,
    /// Number of roots below each; negative where none is approached.
    pub(super) below: PerRoot,
    /// 1 for a root that has settled, else 0.
    pub(super) settled: PerRoot,
    /// The next points, and Δ there.
    pub(super) s: [PerRoot; POINTS],
    pub(super) values: [PerRoot; POINTS],
    /// The outermost of the last points, and Δ there.
    last: [PerRoot; 2],
    last_values: [PerRoot; 2],
    /// The bracket.
    ends: [PerRoot; 2],
    /// The inverse of the larger Δ at the ends of the bracket, with the sign of that at the lower end: products of Δ would leave the range.
    scale: PerRoot,
    /// Distances of the next points from each other.
    width: PerRoot,
    /// Errors of the estimates as the last round predicted them; infinite before the first one.
    predicted: PerRoot,
}

impl<const POINTS: usize> Approaches<POINTS> {
    /// Least distance of points, relative to the root: closer ones would have more rounding than difference.
    const LEAST_WIDTH: f64 = if POINTS > 2 { 1e-5 } else { 1e-6 };

    /// Distance of points that are spread over a bracket, as a part of it.
    const SPREAD: f64 = 1.0 / (POINTS + 1) as f64;

    /// No roots of a system whose Δ grows as `exp(growth s)`.
    #[inline]
    pub(super) fn new(growth: f64) -> Self {
        let ones = [1.0; ROOTS];
        Approaches {
            count: 0,
            growth: [growth; ROOTS],
            estimate: ones,
            below: [-1.0; ROOTS],
            settled: ones,
            s: [ones; POINTS],
            values: [ones; POINTS],
            last: [ones; 2],
            last_values: [ones; 2],
            ends: [ones; 2],
            scale: ones,
            width: ones,
            predicted: [f64::INFINITY; ROOTS],
        }
    }

    /// Starts from a bracket of two samples, beside which there are others: from the inverse cubic through the phases of four.
    pub(super) fn start(&mut self, k: usize, near: &[Sample; 4], [begin, end]: [Sample; 2], is_lowest: bool) {
        let (root, from) = (begin.below + 1.0, begin.point.s);
        let step = end.point.s - from;
        // the other sign than at the end, also where rounding has decided it: Δ is nearly zero at rest if rigid bodies move
        let first = begin.point.value.abs().copysign(-end.point.value);
        let linear = step * ((root - begin.phase) / (end.phase - begin.phase));
        let cubic = at_zero::<f64, 4>(
            [near[0].phase - root, near[1].phase - root, near[2].phase - root, near[3].phase - root],
            [near[0].point.s - from, near[1].point.s - from, near[2].point.s - from, near[3].point.s - from],
        );
        let difference = (cubic - linear).abs();
        // where phases do not grow evenly the points are spread over the bracket
        let is_even = cubic > 0.0 && cubic < step && difference < UNEVEN * step;
        let (start, width) =
            if is_even { (cubic, (difference * 0.25).max(step * 1e-4)) } else { (step * 0.5, step * Self::SPREAD) };
        // without phases Δ itself is interpolated
        let (start, width) = match begin
            .phase
            .is_nan()
            .then(|| zero_among(near, first, [begin.point, end.point], self.growth[0]))
            .flatten()
        {
            Some(zero) => (zero, ((zero - step * 0.5).abs() * 0.1).max(step * 0.02)),
            None => (start, width),
        };
        // below the first wave Δ is a polynomial in ω², whose first terms count
        let (start, width) = if is_lowest && begin.below == 0.0 {
            let share = first / (first - end.point.value);
            (step * Scalar::sqrt(Scalar::sqrt(share)), step * 0.03)
        } else {
            (start, width)
        };
        self.count = self.count.max(k + 1);
        (self.estimate[k], self.width[k]) = (from + start, width);
        (self.below[k], self.settled[k]) = (begin.below, 0.0);
        (self.last[0][k], self.last[1][k]) = (from, end.point.s);
        (self.last_values[0][k], self.last_values[1][k]) = (first, end.point.value);
        (self.ends[0][k], self.ends[1][k]) = (from, end.point.s);
        self.scale[k] = first.abs().max(end.point.value.abs()).recip().copysign(first);
        for (point, s) in self.s.iter_mut().enumerate() {
            s[k] = from + start + width * (point as f64 - (POINTS - 1) as f64 * 0.5);
        }
    }

    /// Goes on in the lanes of a number.
    #[inline(always)]
    fn go_on_in_lanes<S: Real>(&mut self) {
        let mut from = 0;
        while from < ROOTS {
            if from >= self.count {
                break;
            }
            self.store(from, Round::<S, POINTS>::load(self, from).next());
            from += S::LANES;
        }
    }

    /// Writes what follows from a round to the lanes from one on.
    #[inline(always)]
    fn store<S: Real>(&mut self, from: usize, round: Round<S, POINTS>) {
        let lanes = from..from + S::LANES;
        S::store(round.estimate, &mut self.estimate[lanes.clone()]);
        S::store(round.width, &mut self.width[lanes.clone()]);
        S::store(round.predicted, &mut self.predicted[lanes.clone()]);
        S::store(S::one_if(round.is_settled), &mut self.settled[lanes.clone()]);
        let mut k = 0;
        while k < 2 {
            S::store(round.ends[k], &mut self.ends[k][lanes.clone()]);
            S::store(round.last[k], &mut self.last[k][lanes.clone()]);
            S::store(round.last_values[k], &mut self.last_values[k][lanes.clone()]);
            k += 1;
        }
        let mut k = 0;
        while k < POINTS {
            S::store(round.s[k], &mut self.s[k][lanes.clone()]);
            k += 1;
        }
    }
}

/// A round of one root, or of several in lanes; the fields are those of [`Approaches`].
#[derive(Clone, Copy)]
struct Round<S: Real, const POINTS: usize> {
    estimate: S,
    is_settled: <S as Scalar>::Truth,
    s: [S; POINTS],
    values: [S; POINTS],
    last: [S; 2],
    last_values: [S; 2],
    ends: [S; 2],
    scale: S,
    width: S,
    predicted: S,
    /// An eighth of the growth.
    growth: S,
    /// The length over which a wave turns by 1.
    wave: S,
}

impl<S: Real, const POINTS: usize> Round<S, POINTS> {
    /// Reads the lanes from one on.
    #[inline(always)]
    fn load(all: &Approaches<POINTS>, from: usize) -> Self {
        let lanes = from..from + S::LANES;
        let (mut s, mut values) = ([S::zero(); POINTS], [S::zero(); POINTS]);
        let mut k = 0;
        while k < POINTS {
            (s[k], values[k]) = (S::load(&all.s[k][lanes.clone()]), S::load(&all.values[k][lanes.clone()]));
            k += 1;
        }
        Round {
            estimate: S::load(&all.estimate[lanes.clone()]),
            is_settled: <S as Size>::of(0.5).is_below(S::load(&all.settled[lanes.clone()])),
            s,
            values,
            last: [S::load(&all.last[0][lanes.clone()]), S::load(&all.last[1][lanes.clone()])],
            last_values: [S::load(&all.last_values[0][lanes.clone()]), S::load(&all.last_values[1][lanes.clone()])],
            ends: [S::load(&all.ends[0][lanes.clone()]), S::load(&all.ends[1][lanes.clone()])],
            scale: S::load(&all.scale[lanes.clone()]),
            width: S::load(&all.width[lanes.clone()]),
            predicted: S::load(&all.predicted[lanes.clone()]),
            growth: S::load(&all.growth[lanes.clone()]) * <S as Size>::of(0.125),
            wave: S::one() / S::load(&all.growth[lanes]),
        }
    }

    /// The bracket, narrowed by the signs of Δ at the points inside of it: beyond it are other roots.
    #[inline(always)]
    fn bracket(&self) -> [S; 2] {
        let ([mut lower, mut upper], zero) = (self.ends, S::zero());
        let mut k = 0;
        while k < POINTS {
            let is_below = zero.is_below(self.values[k] * self.scale);
            let is_inside = lower.is_below(self.s[k]) & self.s[k].is_below(upper);
            (lower, upper) =
                (S::choose(is_below & is_inside, self.s[k], lower), S::choose(!is_below & is_inside, self.s[k], upper));
            k += 1;
        }
        [lower, upper]
    }

    /// The zero of the inverse polynomial through the points and the outermost of the last ones, from the estimate on.
    #[inline(always)]
    fn zero(&self) -> S {
        let ([before, behind], [first, last]) = (self.last, self.last_values);
        let ((x0, v0), (x1, v1)) = (self.even(before, first), self.even(behind, last));
        let ((x2, v2), (x3, v3)) = (self.even(self.s[0], self.values[0]), self.even(self.s[1], self.values[1]));
        if POINTS == 2 {
            return at_zero::<S, 4>([v0, v2, v3, v1], [x0, x2, x3, x1]);
        }
        let (x4, v4) = self.even(self.s[POINTS - 1], self.values[POINTS - 1]);
        at_zero::<S, 5>([v0, v2, v3, v4, v1], [x0, x2, x3, x4, x1])
    }

    /// The distance of a point from the estimate, and Δ there without its growth, as a wave of even height.
    #[inline(always)]
    fn even(&self, s: S, value: S) -> (S, S) {
        let x = s - self.estimate;
        (x, value * (without_growth(x * self.growth) * self.scale))
    }

    /// The next round; what has settled stays.
    #[inline(always)]
    fn next(self) -> Self {
        let (number, one) = (<S as Size>::of, S::one());
        let [lower, upper] = self.bracket();
        let moved = self.zero();
        let (estimate, [before, behind]) = (self.estimate + moved, self.last);
        let margin = self.estimate * number(OUTSIDE);
        let is_inside = (lower - margin).is_below(estimate) & estimate.is_below(upper + margin);
        // the error falls as the product of the distances of the points, over the length in which Δ bends
        let moved = Scalar::size(moved);
        let length = estimate.or_smaller(self.wave);
        let unit = one / length;
        let distance = moved.or_larger(self.width) * unit;
        let far = Scalar::size((before - estimate) * (behind - estimate)) * (unit * unit);
        let product = length * far * distance * distance * if POINTS > 2 { distance } else { one };
        let change = (moved / self.predicted).or_larger(one);
        let error = product * S::choose(self.predicted.is_below(estimate), change, number(FIRST_ERROR));
        let is_good = error.is_below(estimate * number(SETTLED));
        let settles = is_good & moved.is_below(number(3.0) * self.width) & is_inside;
        let spread = (upper - lower) * number(Approaches::<POINTS>::SPREAD);
        let least = estimate * number(Approaches::<POINTS>::LEAST_WIDTH);
        let width = (error + error).or_larger(least).or_smaller(spread);
        // what has left its bracket starts anew from the middle
        let estimate = S::choose(is_inside, estimate, (lower + upper) * number(0.5));
        let width = S::choose(is_inside, width, spread);
        let stays = self.is_settled;
        let kept = |old, new| S::choose(stays, old, new);
        let estimate = kept(self.estimate, estimate);
        let mut s = self.s;
        let mut k = 0;
        while k < POINTS {
            s[k] = estimate + width * number(k as f64 - (POINTS - 1) as f64 * 0.5);
            k += 1;
        }
        Round {
            estimate,
            is_settled: settles | stays,
            s,
            last: [kept(before, self.s[0]), kept(behind, self.s[POINTS - 1])],
            last_values: [
                kept(self.last_values[0], self.values[0]),
                kept(self.last_values[1], self.values[POINTS - 1]),
            ],
            ends: [lower, upper],
            width,
            predicted: S::choose(is_inside, product, number(f64::INFINITY)),
            ..self
        }
    }
}

/// A round of approaches, compiled once with this crate: it knows no model.
pub(super) trait GoesOn {
    /// Goes on by Δ at the next points of all roots that have not settled.
    fn go_on(&mut self);
}

impl GoesOn for Approaches<2> {
    #[inline(never)]
    fn go_on(&mut self) {
        run(GoOn(self));
    }
}

impl GoesOn for Approaches<3> {
    #[inline(never)]
    fn go_on(&mut self) {
        run(GoOn(self));
    }
}

/// A round of all approaches.
struct GoOn<'a, const POINTS: usize>(&'a mut Approaches<POINTS>);

impl<const POINTS: usize> Task for GoOn<'_, POINTS> {
    type Output = ();

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx512(self) {
        self.0.go_on_in_lanes::<<f64 as InLanes>::OnAvx512>();
    }

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx2(self) {
        self.0.go_on_in_lanes::<<f64 as InLanes>::OnAvx2>();
    }

    #[inline]
    fn alone(self) {
        self.0.go_on_in_lanes::<f64>();
    }
}
