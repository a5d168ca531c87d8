//! The argument principle: how many eigenvalues a contour encloses.

use crate::characteristic::{Characteristic, System};
use crate::error::SearchError;
use crate::scalar::{Dual, Real, Scalar, argument, modulus};
use num_complex::Complex;

/// Steps after which a walk is given up: rounding noise can make it creep.
const STEPS: u32 = 20_000;

/// A step is at most so much longer than the one before: between two roots, where Δ' vanishes, the rate alone would let it
/// leap over the next one, or the next two.
const STEP_GROWTH: f64 = 2.0;

/// Bound of `|step Δ'/Δ|` at both ends of a step.
const STEP_BOUND: f64 = 1.5;

/// Bound of the relative difference between Δ at the end of a step and what the rates at both ends make of its start.
const STEP_MISMATCH: f64 = 0.4;

/// Where Δ is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<T> {
    pub(super) lambda: Complex<T>,
    /// Δ, to be multiplied by a power of two.
    value: Complex<T>,
    exponent: i64,
    /// `Δ'/Δ`.
    pub(super) rate: Complex<T>,
    /// Whether Δ vanishes, or so nearly that its inverse overflows.
    pub(super) is_root: bool,
}

/// Evaluates a system on the complex plane and counts the evaluations.
pub(super) struct Evaluation<'a, Y: System + ?Sized> {
    system: &'a Y,
    pub(super) evaluations: usize,
}

/// What a walk along a contour found.
pub(super) enum Walk {
    /// By how much the argument of Δ grew.
    Argument(f64),
    /// The contour meets a root, or nearly.
    MeetsRoot,
}

impl<'a, T, Y> Evaluation<'a, Y>
where
    T: Real,
    Y: System<Parameter = T> + Characteristic<Dual<Complex<T>>> + ?Sized,
{
    pub(super) fn new(system: &'a Y) -> Self {
        Evaluation { system, evaluations: 0 }
    }

    /// Δ and its logarithmic derivative. On the real axis Δ is real, whatever the rounding.
    pub(super) fn at(&mut self, lambda: Complex<T>) -> Result<Point<T>, SearchError> {
        self.evaluations += 2;
        let dual = self.system.characteristic(Dual::variable(lambda));
        let Dual { value, derivative } = dual.mantissa();
        let rate = derivative / value;
        let is_root = !rate.size().is_finite();
        if !value.size().is_finite() || !derivative.size().is_finite() {
            return Err(SearchError::NotANumber { x: lambda.re.to_f64(), y: lambda.im.to_f64() });
        }
        let value = if lambda.im.is_zero() { Complex::new(value.re, T::zero()) } else { value };
        Ok(Point { lambda, value, exponent: dual.exponent(), rate, is_root })
    }

    /// Growth of the argument of Δ along a polygon. A polygon on which steps would have to be shorter than `shortest`
    /// meets a root; the first step, before anything is known about the way, is no longer than `first_step`; both are
    /// parts of the polygon's size. Every point on the way is shown to `visit`.
    pub(super) fn walk(
        &mut self,
        corners: &[Complex<T>],
        [shortest, first_step]: [f64; 2],
        mut visit: impl FnMut(&Point<T>),
    ) -> Result<Walk, SearchError> {
        let Some((&first, others)) = corners.split_first() else { return Ok(Walk::Argument(0.0)) };
        let size = others.iter().map(|&corner| modulus(corner - first)).fold(T::zero(), larger);
        let shortest = size * T::from_f64(shortest);
        let start = self.at(first)?;
        let (mut here, mut angle, mut steps) = (start, 0.0, 0);
        let mut longest = size * T::from_f64(first_step);
        for &corner in others {
            while here.lambda != corner {
                steps += 1;
                if here.is_root || steps > STEPS {
                    return Ok(Walk::MeetsRoot);
                }
                let Some((there, change)) = self.step(&here, corner, &start, [shortest, longest])? else {
                    return Ok(Walk::MeetsRoot);
                };
                if there.lambda != corner {
                    longest = modulus(there.lambda - here.lambda) * T::from_f64(STEP_GROWTH);
                }
                angle += change;
                here = there;
                visit(&here);
            }
        }
        if here.is_root { Ok(Walk::MeetsRoot) } else { Ok(Walk::Argument(angle)) }
    }

    /// The next point on the way to a corner, which may be the start again, and the growth of the argument up to there;
    /// `None` if steps become too short.
    ///
    /// A step must be short beside `Δ/Δ'` at both ends, and the mean of `Δ'/Δ` must predict Δ: a phase alone could hide a
    /// whole turn.
    fn step(
        &mut self,
        here: &Point<T>,
        corner: Complex<T>,
        start: &Point<T>,
        [shortest, longest]: [T; 2],
    ) -> Result<Option<(Point<T>, f64)>, SearchError> {
        let rest = corner - here.lambda;
        let length = modulus(rest);
        let mut step = smaller(T::from_f64(0.9 * STEP_BOUND) / modulus(here.rate), longest);
        loop {
            let there = if step < length { here.lambda + rest * (step / length) } else { corner };
            if there == here.lambda {
                return Ok(None);
            }
            let there = if there == start.lambda { *start } else { self.at(there)? };
            if let Some(change) = change_of_argument(here, &there) {
                return Ok(Some((there, change)));
            }
            step = smaller(step, length) * T::from_f64(0.5);
            if step < shortest {
                return Ok(None);
            }
        }
    }
}

/// Growth of the argument of Δ from one point to the next, if they are close enough to tell.
fn change_of_argument<T: Real>(here: &Point<T>, there: &Point<T>) -> Option<f64> {
    let step = there.lambda - here.lambda;
    let bound = T::from_f64(STEP_BOUND);
    if there.is_root || modulus(step) * larger(modulus(here.rate), modulus(there.rate)) > bound {
        return None;
    }
    let predicted = step * (here.rate + there.rate) * T::from_f64(0.5);
    let shift = (there.exponent - here.exponent).clamp(-2000, 2000) as i32;
    let (sinh, cosh) = predicted.re.sinh_cosh();
    let (sin, cos) = predicted.im.sin_cos();
    let expected = here.value * Complex::new(cos, sin) * (cosh + sinh);
    let found = there.value.times_power_of_two(shift) / expected;
    let mismatch = found - Complex::from(T::one());
    if modulus(mismatch) > T::from_f64(STEP_MISMATCH) {
        return None;
    }
    Some(predicted.im.to_f64() + argument(found.re.to_f64(), found.im.to_f64()))
}

/// The larger of two numbers.
pub(super) fn larger<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// The smaller of two numbers; the second if the first is not a number.
pub(super) fn smaller<T: Real>(a: T, b: T) -> T {
    if a < b { a } else { b }
}
