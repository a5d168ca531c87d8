//! The argument principle: how many eigenvalues a contour encloses.

use crate::characteristic::{Characteristic, System};
use crate::error::SearchError;
use crate::scalar::{Dual, Real, Scalar};
use num_complex::Complex;

/// A contour passes so close to a root that its steps would become shorter than this part of its size: it is moved.
const SHORTEST_STEP: f64 = 1e-8;

/// Where Δ is known: the point, Δ up to a positive factor, and `Δ'/Δ`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<T> {
    pub(super) lambda: Complex<T>,
    value: Complex<T>,
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
    /// The number of quarter turns of Δ.
    Quarters(i64),
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
        let Dual { value, derivative } = self.system.characteristic(Dual::variable(lambda)).mantissa();
        let rate = derivative / value;
        let is_root = !rate.size().is_finite();
        if !value.size().is_finite() || (is_root && !derivative.size().is_finite()) {
            return Err(SearchError::NotANumber { x: lambda.re.to_f64(), y: lambda.im.to_f64() });
        }
        let value = if lambda.im.is_zero() { Complex::new(value.re, T::zero()) } else { value };
        Ok(Point { lambda, value, rate, is_root })
    }

    /// Quarter turns of Δ along a polygon. A step is accepted where `|step Δ'/Δ| < 1` at both of its ends: the phase alone
    /// could hide a whole turn between them. Points from which a root seems near are shown to `visit`.
    pub(super) fn walk(
        &mut self,
        corners: &[Complex<T>],
        mut visit: impl FnMut(&Point<T>),
    ) -> Result<Walk, SearchError> {
        let Some((&first, others)) = corners.split_first() else { return Ok(Walk::Quarters(0)) };
        let size = others.iter().map(|&corner| modulus(corner - first)).fold(T::zero(), larger);
        let shortest = size * T::from_f64(SHORTEST_STEP);
        let mut quarters = 0;
        let start = self.at(first)?;
        let mut here = start;
        for &corner in others {
            while here.lambda != corner {
                if here.is_root {
                    return Ok(Walk::MeetsRoot);
                }
                let Some(there) = self.step(&here, corner, &start, shortest)? else { return Ok(Walk::MeetsRoot) };
                quarters += quarter_turn(&here, &there).unwrap_or(0);
                here = there;
                visit(&here);
            }
        }
        if here.is_root { Ok(Walk::MeetsRoot) } else { Ok(Walk::Quarters(quarters)) }
    }

    /// The next point on the way to a corner, which may be the start again; `None` if steps become too short.
    fn step(
        &mut self,
        here: &Point<T>,
        corner: Complex<T>,
        start: &Point<T>,
        shortest: T,
    ) -> Result<Option<Point<T>>, SearchError> {
        let rest = corner - here.lambda;
        let length = modulus(rest);
        let mut step = T::from_f64(0.9) / modulus(here.rate);
        loop {
            let there = if step < length { here.lambda + rest * (step / length) } else { corner };
            let there = if there == start.lambda { *start } else { self.at(there)? };
            let taken = if step < length { step } else { length };
            if !there.is_root
                && taken * larger(modulus(here.rate), modulus(there.rate)) < T::one()
                && quarter_turn(here, &there).is_some()
            {
                return Ok(Some(there));
            }
            step = taken * T::from_f64(0.5);
            if step < shortest || there.lambda == here.lambda {
                return Ok(None);
            }
        }
    }
}

/// Quarter turns from one value to the next, none of them more than a quarter away; `None` if they are opposite.
fn quarter_turn<T: Real>(here: &Point<T>, there: &Point<T>) -> Option<i64> {
    match (quadrant(there.value) - quadrant(here.value)).rem_euclid(4) {
        0 => Some(0),
        1 => Some(1),
        3 => Some(-1),
        _ => None,
    }
}

/// Index of the quadrant, each with its first half-axis.
fn quadrant<T: Real>(value: Complex<T>) -> i64 {
    let zero = T::zero();
    match (value.re > zero, value.im > zero) {
        (true, _) if value.im >= zero => 0,
        (false, true) => 1,
        (false, false) if value.re < zero => 2,
        _ => 3,
    }
}

/// Modulus of a complex number.
pub(super) fn modulus<T: Real>(z: Complex<T>) -> T {
    (z.re * z.re + z.im * z.im).sqrt()
}

/// The larger of two numbers.
pub(super) fn larger<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}
