//! Exact responses of a system with damping in proportion: the system without damping has the same motion at another frequency.

use crate::answer::facts::Facts;
use crate::answer::frequency_response::FrequencyResponse;
use crate::answer::network::response::PlaneResponse;
use crate::model::MotionError;
use crate::number::{Oscillation, Real, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, PlaneFrequency};
use crate::pass::tree::ExtendedTree;
use crate::search::ProportionalDamping;
use num_complex::Complex;
use num_traits::Zero;

/// An exact response of a system without damping.
pub trait ExactResponse<T> {
    /// The response at λ.
    #[doc(hidden)]
    fn exactly(&self, lambda: Complex<T>) -> Result<Complex<T>, MotionError>;

    /// What its load and its entry are.
    #[doc(hidden)]
    fn facts(&self) -> Facts<T>;
}

impl<T, Y> ExactResponse<T> for FrequencyResponse<'_, Y>
where
    T: Real,
    Complex<T>: Oscillation<T>,
    Y: ExtendedTree<Complex<T>> + System<Parameter = T>,
{
    fn exactly(&self, lambda: Complex<T>) -> Result<Complex<T>, MotionError> {
        const { assert!(!Y::SPINS, "gyroscopic moments grow with λ: no damping of a rotor is in proportion") };
        self.at(lambda)
    }

    fn facts(&self) -> Facts<T> {
        FrequencyResponse::facts(self)
    }
}

impl<T, Y> ExactResponse<T> for PlaneResponse<'_, Y>
where
    T: Real,
    Complex<T>: PlaneFrequency<T>,
    Y: MovingNetwork<Complex<T>> + System<Parameter = T>,
{
    fn exactly(&self, lambda: Complex<T>) -> Result<Complex<T>, MotionError> {
        const { assert!(!Y::SPINS, "gyroscopic moments grow with λ: no damping of a rotor is in proportion") };
        self.at(lambda)
    }

    fn facts(&self) -> Facts<T> {
        PlaneResponse::facts(self)
    }
}

impl<T: Real> ProportionalDamping<T> {
    /// The response at λ of a system that is damped in proportion, `λ = iω` for a steady vibration, from the exact response without damping: with
    /// `d = (1 + βλ)(1 + iη)` it is `H(λ')/d` at `λ'² = (λ² + αλ)/d`. No mode is needed, and none is left out. A force or a moment is that of the stiffness and of its
    /// damping, d times as large.
    ///
    /// Under the motion of a support the damping of inertias moves with the support: `H(0) + (H(λ') - H(0)) λ/(λ + α)`.
    ///
    /// ```
    /// use mstmm_core::elements::Spring;
    /// use mstmm_core::frame::{Frame, Ground};
    /// use mstmm_core::search::ProportionalDamping;
    /// use mstmm_core::FrameAnalysis;
    /// use num_complex::Complex;
    ///
    /// let mut frame = Frame::new();
    /// let point = frame.point(0.0);
    /// frame.member(point, Ground, Spring { stiffness: 100.0 });
    /// frame.mass(point, 2.0);
    /// let oscillator = frame.build()?;
    /// let exact = oscillator.frequency_response(point.force_y(), point.displacement_y())?;
    /// let damping = ProportionalDamping::new(0.3, 1e-3, 0.0)?;
    /// let lambda = Complex::new(0.0, 7.0);
    /// let expected = 1.0 / (2.0 * lambda * lambda + (0.3 * 2.0 + 1e-3 * 100.0) * lambda + 100.0);
    /// assert!((damping.response(&exact, lambda)? - expected).norm() < 1e-15 * expected.norm());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MotionError::AxialForce`] for damping of stiffnesses where a member bears an axial force, a stiffness that nothing damps; [`MotionError::Damped`] where something is
    /// damped already; [`MotionError::LossFactor`] for `Im λ < 0` beside a loss factor; else as the response.
    pub fn response(&self, exact: &impl ExactResponse<T>, lambda: Complex<T>) -> Result<Complex<T>, MotionError> {
        let one = Complex::from(T::one());
        let (alpha, beta, loss) = (self.of_inertias(), self.of_stiffnesses(), self.loss_factor());
        let Facts { is_motion, is_force, obstacles, .. } = exact.facts();
        if obstacles.damping {
            return Err(MotionError::Damped);
        }
        if obstacles.axial_force && !(beta.is_zero() && loss.is_zero()) {
            return Err(MotionError::AxialForce);
        }
        if lambda.im < T::zero() && !loss.is_zero() {
            return Err(MotionError::LossFactor);
        }
        let factor = (one + lambda * beta) * Complex::new(T::one(), loss);
        let square = lambda * (lambda + Complex::from(alpha)) / factor;
        // a force is that of the stiffness and of its damping
        let of_entry = if is_force { factor } else { one };
        if is_motion {
            let at_rest = exact.exactly(Complex::zero())?;
            if lambda.is_zero() {
                return Ok(at_rest * of_entry);
            }
            let share = lambda / (lambda + Complex::from(alpha));
            return Ok((at_rest + (exact.exactly(square.sqrt())? - at_rest) * share) * of_entry);
        }
        Ok(exact.exactly(square.sqrt())? * (of_entry / factor))
    }
}
