//! Δ on the complex plane: evaluated, counted, watched, and given up where it takes too long.

use super::contour::Point;
use crate::characteristic::{Characteristic, System};
use crate::count::Watch;
use crate::doubt::ZEROS;
use crate::error::SearchError;
use crate::scalar::{Dual, Frequency, Real, Scalar, modulus};
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
    /// Whether Δ was less beside its terms than it is beside a well-conditioned root.
    pub(super) is_ill_conditioned: bool,
}

impl<'a, Y: System + ?Sized> Evaluation<'a, Y> {
    pub(super) fn new(system: &'a Y) -> Self {
        Evaluation { system, evaluations: 0, is_doubtful: false, is_ill_conditioned: false }
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
        self.is_ill_conditioned |= watch.cancelled.at_root;
        if watch.cancelled.partly && Self::is_last::<T>() {
            return Err(SearchError::Unresolved { near: modulus(lambda).to_f64() });
        }
        if value.size() == 0.0 {
            self.look_for_zeros(lambda)?;
        }
        let value = if lambda.im.is_zero() { Complex::new(value.re, T::zero()) } else { value };
        Ok(Point { lambda, value: Scaled::new(value, dual.exponent()), rate, is_root })
    }

    /// Whether the root is within a distance of a point by the arithmetic that judges, if Δ was small beside its terms there.
    pub(super) fn is_proven<T>(&mut self, lambda: Complex<T>, distance: T) -> bool
    where
        T: Real,
        Y: Characteristic<Dual<Complex<T::Judge>>>,
    {
        if !(core::mem::take(&mut self.is_ill_conditioned) && T::HAS_JUDGE) {
            return true;
        }
        self.evaluations += 2;
        judged_step(self.system, lambda) <= distance.to_f64()
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

/// The length of Newton's step by the arithmetic that judges; a call, since it is seldom asked.
#[cold]
#[inline(never)]
fn judged_step<T, Y>(system: &Y, lambda: Complex<T>) -> f64
where
    T: Real,
    Y: Characteristic<Dual<Complex<T::Judge>>> + ?Sized,
{
    let exactly = |part: T| <T::Judge as Frequency<T>>::from_parameter(part);
    let lambda = Complex::new(exactly(lambda.re), exactly(lambda.im));
    let Dual { value, derivative } = system.characteristic(Dual::variable(lambda)).mantissa();
    modulus(value / derivative).to_f64()
}
