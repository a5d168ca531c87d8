//! Sums over modes in frequency.

use crate::answer::frequency_response::on_grid;
use crate::answer::modal::response::ModalResponse;
use crate::answer::response_curve::{Sample, refined};
use crate::model::{MotionError, hertz};
use crate::number::{ComplexEigenvalue, Frequency, List, Oscillation, Real, RealFrequency, Scalar};
use crate::search::ClosedRange;
use num_complex::Complex;
use num_traits::Zero;

/// The response of a meaning of frequencies at numbers of a type.
macro_rules! in_frequency {
    ($meaning:ident at $frequency:ty: $($doc:literal)*) => {
        impl<T, const N: usize> ModalResponse<T, N, $meaning>
        where
            T: Real,
            $frequency: Oscillation<T>,
        {
            $(#[doc = $doc])*
            ///
            /// # Errors
            /// [`MotionError::Resonance`] where it is infinite: at a root of the list, and at rest where a rigid body moves off.
            pub fn at(&self, x: $frequency) -> Result<$frequency, MotionError> {
                let omega = x.omega().to_complex();
                Ok(<$frequency>::from_complex(self.whole_at(Complex::new(-omega.im, omega.re))?))
            }

            /// Writes the responses at the frequencies of `grid` to `values`, each with the bits that `at` gives it.
            ///
            /// # Errors
            /// As `at`, for the first frequency where it fails; [`MotionError::Capacity`] where `values` is shorter than `grid`.
            pub fn on(&self, grid: &[$frequency], values: &mut [$frequency]) -> Result<(), MotionError> {
                on_grid(|x| self.at(x), grid, values)
            }

            /// The response over a range of ω [rad/s], refined where it bends: between two samples it differs from the straight line at the middle by no
            /// more than `tolerance` times the largest of the three. No resonance of the list is missed, however narrow.
            ///
            /// # Errors
            /// [`MotionError::Capacity`] for more than `CAP` samples; [`MotionError::Range`] for a range that is empty, reversed or not finite;
            /// [`MotionError::Tolerance`] for a tolerance that is not positive.
            pub fn curve<const CAP: usize>(
                &self,
                range: impl ClosedRange<T>,
                tolerance: f64,
            ) -> Result<List<Sample<T, $frequency>, CAP>, MotionError> {
                let peaks = self.terms.iter().map(|term| (term.lambda.im.abs(), term.lambda.re.abs()));
                refined(|x| self.at(x), &range.closed(), peaks, tolerance)
            }
        }
    };
}

in_frequency!(RealFrequency at T: "The entry under a load that vibrates at a frequency ω [rad/s]: the sum over the modes of the list, with the residual compliance of all others.");
in_frequency!(ComplexEigenvalue at Complex<T>: "The entry under a load `e^{λt}`, `λ = iω` for a steady vibration: the sum over the modes of the list, with the residual compliance of all others.");

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// The entry under a steady vibration of a frequency \[Hz\], by its amplitude and its phase: `at` the frequency `2π f`, or `λ = 2π f i`.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where it is infinite: at a root of the list, and at rest where a rigid body moves off.
    pub fn at_hertz(&self, frequency: T) -> Result<Complex<T>, MotionError> {
        self.whole_at(Complex::new(T::zero(), hertz(frequency)))
    }

    /// The whole response at λ.
    pub(crate) fn whole_at(&self, lambda: Complex<T>) -> Result<Complex<T>, MotionError> {
        let frequency = lambda.modulus();
        if !frequency.is_finite() {
            return Err(MotionError::NotFinite { frequency });
        }
        let value = self.sum_of_all(lambda)?;
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::Resonance { frequency }) }
    }

    /// The sum of all modes, the residual compliance and what moves off.
    fn sum_of_all(&self, lambda: Complex<T>) -> Result<Complex<T>, MotionError> {
        let late = Complex::from(T::one()) + lambda * self.lag;
        let (sum, _) = self.sum_at(lambda);
        let held = Complex::from(self.residual) / late + sum + lambda * self.flow;
        if self.away().is_zero() {
            return Ok(held);
        }
        if lambda.is_zero() {
            return Err(MotionError::Resonance { frequency: 0.0 });
        }
        Ok(held + Complex::from(self.away()) / (lambda * lambda))
    }
}
