//! Δ on the complex plane: evaluated, counted, watched, and given up where it takes too long.

use super::contour::Point;
use crate::characteristic::{Characteristic, System};
use crate::count::Watch;
use crate::doubt::ZEROS;
use crate::error::SearchError;
use crate::scalar::{Dual, Real, Scalar, modulus};
use crate::scaled::Scaled;
use num_complex::Complex;

/// Evaluations that a search may take before it has found anything.
const EVALUATIONS: usize = 30_000;

/// Further ones for each root that it finds: narrow regions between close roots take some hundred.
const EVALUATIONS_PER_ROOT: usize = 2_000;

/// Evaluates a system on the complex plane in arithmetic of type `T`, and counts the evaluations.
pub(super) struct Evaluation<'a, Y: System + ?Sized> {
    system: &'a Y,
    pub(super) evaluations: usize,
    /// Whether sums cancelled.
    pub(super) is_doubtful: bool,
}

impl<'a, Y: System + ?Sized> Evaluation<'a, Y> {
    pub(super) fn new(system: &'a Y) -> Self {
        Evaluation { system, evaluations: 0, is_doubtful: false }
    }

    /// Whether no other arithmetic judges what this one makes of the system.
    fn is_last<T: Real>() -> bool {
        T::EPSILON < <Y::Parameter as Scalar>::EPSILON || !Y::Parameter::HAS_JUDGE
    }

    /// Δ and its logarithmic derivative. On the real axis Δ is real, whatever the rounding.
    pub(super) fn at<T>(&mut self, lambda: Complex<T>) -> Result<Point<T>, SearchError>
    where
        T: Real,
        Y: Characteristic<Dual<Complex<T>>>,
    {
        self.evaluations += 2;
        let mut watch = Watch::default();
        let dual = self.system.pass(Dual::variable(lambda), &mut watch);
        let Dual { value, derivative } = dual.mantissa();
        let rate = derivative / value;
        let is_root = !rate.size().is_finite();
        if !value.size().is_finite() || !derivative.size().is_finite() {
            return Err(SearchError::NotANumber { x: lambda.re.to_f64(), y: lambda.im.to_f64() });
        }
        self.is_doubtful |= watch.cancelled.any();
        if watch.cancelled.partly && Self::is_last::<T>() {
            return Err(SearchError::Unresolved { near: modulus(lambda).to_f64() });
        }
        if value.size() == 0.0 {
            self.look_for_zeros(lambda)?;
        }
        let value = if lambda.im.is_zero() { Complex::new(value.re, T::zero()) } else { value };
        Ok(Point { lambda, value: Scaled::new(value, dual.exponent()), rate, is_root })
    }

    /// Gives up where Δ vanishes at one point, and at others far from it.
    #[cold]
    fn look_for_zeros<T>(&mut self, lambda: Complex<T>) -> Result<(), SearchError>
    where
        T: Real,
        Y: Characteristic<Dual<Complex<T>>>,
    {
        let lowest = T::one().times_power_of_two(self.system.bounds().lowest_exponent());
        let mut size = modulus(lambda) + lowest;
        for _ in 1..ZEROS {
            size += size + size;
            self.evaluations += 2;
            let elsewhere = Complex::new(T::from_f64(-0.6), T::from_f64(0.8)) * size;
            if self.system.characteristic(Dual::variable(elsewhere)).mantissa().value.size() > 0.0 {
                return Ok(());
            }
        }
        Err(SearchError::Zero { points: ZEROS })
    }

    /// Gives up a search that takes too long for the number of roots that it found.
    pub(super) fn check_effort(&self, found: usize) -> Result<(), SearchError> {
        if self.evaluations <= EVALUATIONS + EVALUATIONS_PER_ROOT * found {
            return Ok(());
        }
        Err(SearchError::Effort { evaluations: self.evaluations, found })
    }
}
