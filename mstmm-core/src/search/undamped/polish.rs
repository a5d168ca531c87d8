//! The last digits of a single root, by inverse interpolation with derivatives inside a bracket of counts.

use crate::model::SearchError;
use crate::number::{Dual, Real, Scaled, is_straight};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::undamped::certificate::NEARBY;
use crate::search::undamped::found::NaturalFrequency;
use crate::search::undamped::sampling::{Isolation, Sample, Slope, extended, middle};

/// Number of steps within which a bracket has to be halved, else the next step halves it.
const PATIENCE: u32 = 3;

impl<T: Real> Slope<T> {
    /// Newton's next point.
    #[inline]
    fn newton(&self) -> T {
        self.omega - self.value / self.derivative
    }

    /// The zero of the inverse cubic through two points with their slopes: of order 1 + sqrt(3).
    #[inline]
    fn hermite(&self, other: &Self) -> T {
        let shift = (other.exponent - self.exponent).clamp(-2000, 2000) as i32;
        let (value, derivative) = (other.value.times_power_of_two(shift), other.derivative.times_power_of_two(shift));
        let height = value - self.value;
        let t = -(self.value / height);
        let (start, end) = (height / self.derivative, height / derivative);
        let chord = other.omega - self.omega;
        let one = T::one();
        // Hermite's cubic for ω(Δ) on t in [0, 1]
        let rest = one - t;
        let three = one + one + one;
        self.omega + t * t * (three - t - t) * chord + t * rest * (rest * start - t * end)
    }
}

impl<'a, T, Y> Isolation<'a, Y, T>
where
    T: Real,
    Y: System + Characteristic<T> + Characteristic<Dual<T>> + Characteristic<T::Extended> + ?Sized,
{
    /// The single root of a bracket.
    #[inline]
    pub(super) fn polish(
        &mut self,
        mut lower: Sample<T>,
        mut upper: Sample<T>,
    ) -> Result<NaturalFrequency<T>, SearchError> {
        let counts = (lower.below, upper.below);
        let mut point = first_point(&lower, &upper);
        let mut previous: Option<Slope<T>> = None;
        let (mut width, mut patience) = (upper.omega - lower.omega, PATIENCE);
        let length = (width + width).to_f64().min(upper.omega.to_f64()) / 8.0;
        while upper.omega - lower.omega > upper.omega * self.half_width * T::from_f64(0.25) {
            let slope = self.slope(point)?;
            if slope.below <= counts.0 {
                lower = slope.into()
            } else {
                upper = slope.into()
            }
            // a bracket may end in the root itself, and estimates carry roundings
            let margin = point * self.half_width;
            let inside = |omega: &T| *omega > lower.omega - margin && *omega < upper.omega + margin;
            let estimate = previous
                .map(|previous| slope.hermite(&previous))
                .filter(inside)
                .or_else(|| Some(slope.newton()).filter(inside));
            patience -= 1;
            if (upper.omega - lower.omega) * T::from_f64(2.0) <= width {
                (width, patience) = (upper.omega - lower.omega, PATIENCE);
            }
            if let Some(estimate) = estimate
                && is_exact(estimate, &slope, previous.as_ref(), length, self.precision)
            {
                // a forced halving lies farther from the root than the point before it
                let distance = |slope: &Slope<T>| (estimate - slope.omega).size();
                let nearest = previous.filter(|previous| distance(previous) < distance(&slope)).unwrap_or(slope);
                if let Some(root) = self.certify(estimate, counts, &nearest)? {
                    return Ok(root);
                }
                patience = 0;
            }
            previous = Some(slope);
            point = match estimate {
                Some(estimate) if patience > 0 => estimate,
                _ => {
                    patience = PATIENCE;
                    middle(lower.omega, upper.omega)
                }
            };
        }
        self.settle(Sample { below: counts.0, ..lower }, Sample { below: counts.1, ..upper })
    }

    /// The single root beside an estimate, above so many others: certified without doubt, or else as it has been found, if it has.
    #[inline]
    pub(super) fn certify_near(&mut self, omega: T, below: u64) -> Result<NaturalFrequency<T>, Option<T>> {
        let before = core::mem::take(&mut self.is_doubtful);
        let slope = self.slope(omega).map_err(|_| None)?;
        let root = self.certify(slope.newton(), (below, below + 1), &slope).map_err(|_| None)?;
        let is_certain = !core::mem::replace(&mut self.is_doubtful, before);
        root.filter(|_| is_certain).ok_or(root.map(|root| root.omega))
    }

    /// The single root between two frequencies, above so many others, certified without doubt; none where it is not the only one.
    pub(super) fn certify_between(&mut self, [lower, upper]: [T; 2], below: u64) -> Option<NaturalFrequency<T>> {
        let before = core::mem::take(&mut self.is_doubtful);
        let (lower, upper) = (self.sample(lower).ok()?, self.sample(upper).ok()?);
        if (lower.below, upper.below) != (below, below + 1) {
            return None;
        }
        let root = self.polish(lower, upper).ok()?;
        let is_certain = !core::mem::replace(&mut self.is_doubtful, before);
        if is_certain { Some(root) } else { self.certify_extended(root.omega, below) }
    }

    /// The single root beside an estimate by counts in extended precision: what one root leaves in doubt need not be searched anew for all.
    #[cold]
    pub(super) fn certify_extended(&mut self, mut omega: T, below: u64) -> Option<NaturalFrequency<T>> {
        for _ in 0..if T::HAS_EXTENDED { 2 } else { 0 } {
            let inner = omega * self.half_width * T::from_f64(0.5);
            let (start, end) = (omega - inner, omega + inner);
            (self.evaluations, self.extended) = (self.evaluations + 2, self.extended + 2);
            let [(first, lower), (last, upper)] = [start, end].map(|x| extended(self.system, x));
            if first.cancelled().partly || last.cancelled().partly {
                return None;
            }
            if (first.below(), last.below()) == (below, below + 1) {
                return Some(NaturalFrequency { omega, lower: start - inner, upper: end + inner, multiplicity: 1 });
            }
            let share = share_of_zero(lower, upper);
            omega = start + (end - start) * T::from_f64(share);
            if f64::abs(share) >= NEARBY || share.is_nan() {
                return None;
            }
        }
        None
    }

    /// The root at an estimate, if the counts on both sides certify it.
    #[inline]
    fn certify(
        &mut self,
        omega: T,
        counts: (u64, u64),
        nearest: &Slope<T>,
    ) -> Result<Option<NaturalFrequency<T>>, SearchError> {
        let mut omega = omega;
        for _ in 0..2 {
            // counts half a width inside the interval: the other half is room for their own rounding
            let inner = omega * self.half_width * T::from_f64(0.5);
            let (below, above) = self.both_sides(omega, inner)?;
            if below.below == counts.0 && above.below == counts.1 {
                self.is_doubtful |= !fits(&below, &above, nearest);
                let (lower, upper) = (below.omega - inner, above.omega + inner);
                let mut root = NaturalFrequency { omega, lower, upper, multiplicity: counts.1 - counts.0 };
                self.is_doubtful |= !self.is_proven(&mut root, counts);
                return Ok(Some(root));
            }
            let zero = below.omega + (above.omega - below.omega) * chord_share(&below, &above);
            let is_near = (zero - omega).size() < inner.size() * NEARBY;
            if !is_near {
                break;
            }
            omega = zero;
        }
        Ok(None)
    }
}

/// The zero of the chord between two values in extended precision, as a share of their distance.
pub(super) fn share_of_zero<S: Real>(lower: Scaled<S>, upper: Scaled<S>) -> f64 {
    let (value, other) = (lower.mantissa(), upper.over_power(lower.exponent()));
    (value / (value - other)).to_f64()
}

/// The zero of the chord between two samples, as a share of their distance.
#[inline]
fn chord_share<T: Real>(lower: &Sample<T>, upper: &Sample<T>) -> T {
    let (a, b) = (lower.value.mantissa(), upper.value.over_power(lower.value.exponent()));
    a / (a - b)
}

/// Whether the growth of Δ across a root fits its slope beside it, as it does unless rounding rules there.
#[inline]
fn fits<T: Real>(below: &Sample<T>, above: &Sample<T>, nearest: &Slope<T>) -> bool {
    let growth = above.value.over_power(nearest.exponent) - below.value.over_power(nearest.exponent);
    is_straight(growth / (nearest.derivative * (above.omega - below.omega)))
}

/// The first point: the zero of the chord if the bracket is not wide, else its middle.
#[inline]
fn first_point<T: Real>(lower: &Sample<T>, upper: &Sample<T>) -> T {
    let middle = middle(lower.omega, upper.omega);
    if lower.omega + lower.omega < upper.omega {
        return middle;
    }
    let width = upper.omega - lower.omega;
    let share = chord_share(lower, upper);
    let tenth = T::from_f64(0.1);
    if share > tenth && share < T::one() - tenth { lower.omega + width * share } else { middle }
}

/// Whether an estimate is good to a precision. With the distances a and b of its points and the length over which Δ bends, the
/// error of the inverse cubic is `(a b)²/length³`, that of Newton's step `a²/length`.
#[inline]
fn is_exact<T: Real>(estimate: T, slope: &Slope<T>, previous: Option<&Slope<T>>, length: f64, precision: f64) -> bool {
    let distance = |omega: T| (estimate - omega).size() / length;
    let product = distance(slope.omega) * previous.map_or(1.0, |previous| distance(previous.omega));
    let error = product * product;
    4.0 * error * length <= precision * estimate.size()
}
