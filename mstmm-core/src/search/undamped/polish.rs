//! The last digits of a single root, by inverse interpolation with derivatives inside a bracket of counts.

use crate::model::SearchError;
use crate::number::{Dual, Real};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::undamped::found::NaturalFrequency;
use crate::search::undamped::sampling::{Isolation, Sample, Slope, middle};

/// Number of steps within which a bracket has to be halved, else the next step halves it.
const PATIENCE: u32 = 3;

/// Steps at most: each bit of a word takes as many as a bracket may be left unhalved, and one.
const STEPS: u32 = 64 * (PATIENCE + 1);

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
    Y: System<Parameter = T> + Characteristic<T> + Characteristic<Dual<T>> + ?Sized,
{
    /// The single root of a bracket. No end of the bracket moves outward.
    #[inline]
    pub(super) fn polish(
        &mut self,
        mut lower: Sample<T>,
        mut upper: Sample<T>,
    ) -> Result<NaturalFrequency<T>, SearchError> {
        let below = lower.below;
        let mut point = first_point(&lower, &upper);
        let mut previous: Option<Slope<T>> = None;
        let (mut width, mut patience) = (upper.omega - lower.omega, PATIENCE);
        let length = (width + width).to_f64().min(upper.omega.to_f64()) / 8.0;
        for _ in 0..STEPS {
            if upper.omega - lower.omega <= upper.omega * self.half_width * T::from_f64(0.25) {
                break;
            }
            let slope = self.slope(point)?;
            if slope.below <= below && slope.omega > lower.omega {
                lower = slope.into();
            } else if slope.below > below && slope.omega < upper.omega {
                upper = slope.into();
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
                return Ok(self.estimate(estimate, 1));
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
        Ok(self.estimate(middle(lower.omega, upper.omega), 1))
    }
}

/// The zero of the chord between two samples, as a share of their distance.
#[inline]
fn chord_share<T: Real>(lower: &Sample<T>, upper: &Sample<T>) -> T {
    let (a, b) = (lower.value.mantissa(), upper.value.over_power(lower.value.exponent()));
    a / (a - b)
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
