//! Evaluation of Δ on the complex plane: its number is limited, and sums that cancel are noticed.

use crate::model::{FrequencyEstimates, SearchError};
use crate::number::{Dual, Real, Scalar, Scaled, is_extended, is_last, modulus};
use crate::pass::characteristic::{Characteristic, System, counted_pass};
use crate::search::damped::point::Point;
use crate::search::identity::check_identity;
use crate::subspace::Watch;
use num_complex::Complex;

/// Evaluations that a search may take before it has found anything. In extended precision each takes some fifty times as long.
const EVALUATIONS: usize = 100_000;
const EXTENDED_EVALUATIONS: usize = 30_000;

/// A point in units of the lowest frequency, off both axes, where no model of the tests has an eigenvalue.
const ELSEWHERE: [f64; 2] = [-0.3719, 0.7127];

/// Further evaluations for each root found: narrow regions between close roots take some hundred.
const EVALUATIONS_PER_ROOT: usize = 2_000;

/// Evaluates a system on the complex plane in arithmetic of type `T`, and counts the evaluations.
pub(super) struct Evaluation<'a, Y: System + ?Sized> {
    pub(super) system: &'a Y,
    /// Logarithm to base 2 of a low estimate of the frequencies.
    lowest_exponent: i32,
    /// Whether Δ is real on the real axis: not with a loss factor.
    is_real: bool,
    pub(super) evaluations: usize,
    /// Whether sums cancelled.
    pub(super) is_doubtful: bool,
}

impl<'a, Y: System + ?Sized> Evaluation<'a, Y> {
    pub(super) fn new(system: &'a Y, estimates: &FrequencyEstimates) -> Self {
        let (lowest_exponent, is_real) = (estimates.lowest_exponent(), estimates.have_images());
        Evaluation { system, lowest_exponent, is_real, evaluations: 0, is_doubtful: false }
    }

    /// Δ and its logarithmic derivative. On the real axis Δ is real, whatever the rounding, unless something has a loss factor.
    pub(super) fn at<T>(&mut self, lambda: Complex<T>) -> Result<Point<T>, SearchError>
    where
        T: Real,
        Y: Characteristic<Dual<Complex<T>>>,
    {
        self.evaluations += 2;
        let (watch, dual) = counted_pass(self.system, Dual::variable(lambda), Watch::default());
        let Dual { value, derivative } = dual.mantissa();
        let rate = derivative / value;
        let is_root = !rate.size().is_finite();
        if !value.size().is_finite() || !derivative.size().is_finite() {
            return Err(SearchError::NotANumber { x: lambda.re.to_f64(), y: lambda.im.to_f64() });
        }
        self.is_doubtful |= watch.cancelled.any();
        if watch.cancelled.partly && is_last::<T, Y::Parameter>() {
            return Err(SearchError::Unresolved { near: modulus(lambda).to_f64() });
        }
        if value.size() == 0.0 {
            self.look_for_zeros(lambda)?;
        }
        let value = if self.is_real && lambda.im.is_zero() { Complex::new(value.re, T::zero()) } else { value };
        Ok(Point { lambda, value: Scaled::new(value, dual.exponent()), rate, is_root })
    }

    /// Looks at a point where no eigenvalue is to be expected: where pivots of a frame vanish there rounding rules, or it is held twice.
    pub(super) fn look_elsewhere<T>(&mut self)
    where
        T: Real,
        Y: Characteristic<Dual<Complex<T>>>,
    {
        if const { !Y::IS_NETWORK } || is_extended::<T, Y::Parameter>() {
            return;
        }
        self.evaluations += 2;
        let scale = T::one().times_power_of_two(self.lowest_exponent);
        let [re, im] = ELSEWHERE.map(|part| scale * T::from_f64(part));
        let (watch, _) = counted_pass(self.system, Dual::variable(Complex::new(re, im)), Watch::default());
        self.is_doubtful |= watch.vanished.is_some();
    }

    /// Refuses a system whose Δ vanishes at one point and at others far from it.
    #[cold]
    fn look_for_zeros<T>(&mut self, lambda: Complex<T>) -> Result<(), SearchError>
    where
        T: Real,
        Y: Characteristic<Dual<Complex<T>>>,
    {
        check_identity(modulus(lambda) + T::one().times_power_of_two(self.lowest_exponent), |far| {
            self.evaluations += 2;
            let elsewhere = Complex::new(-far, far);
            // with a watch like all passes, so that they are one piece of code
            let (watch, value) = counted_pass(self.system, Dual::variable(elsewhere), Watch::default());
            let size = value.mantissa().value.size();
            // a NaN does not show that Δ differs from zero
            (size.is_nan() || size == 0.0, watch.vanished)
        })
    }

    /// Gives up a search that takes too long for the number of roots that it found.
    pub(super) fn check_effort<T: Real>(&self, found: usize) -> Result<(), SearchError> {
        let most = if is_extended::<T, Y::Parameter>() { EXTENDED_EVALUATIONS } else { EVALUATIONS };
        if self.evaluations <= most + EVALUATIONS_PER_ROOT * found {
            return Ok(());
        }
        Err(SearchError::Effort { evaluations: self.evaluations, found })
    }
}
