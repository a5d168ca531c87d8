//! Responses of rates and accelerations, and those to accelerations of what moves.

use crate::answer::modal::response::{ModalResponse, Term};
use crate::model::MotionError;
use crate::number::{List, Real};
use num_complex::Complex;
use num_traits::Zero;

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// The response with the motion of the ground: of a displacement along an acceleration of the ground the displacement in space, in place of that relative to the
    /// ground. Other entries stay.
    ///
    /// # Errors
    /// [`MotionError::NotOfGround`] for another load than an acceleration of the ground.
    pub fn absolute(&self) -> Result<Self, MotionError> {
        Ok(ModalResponse { carried: self.along.ok_or(MotionError::NotOfGround)?, ..*self })
    }

    /// The response of the rate of the entry, such as a velocity. Modes that are not in the list have no part in it.
    ///
    /// # Errors
    /// [`MotionError::Capacity`] where there is no room for a rigid body beside `N` modes; [`MotionError::SupportMotion`] under the motion of a support, with which a
    /// part of the entry moves at once.
    pub fn rate(&self) -> Result<Self, MotionError> {
        let mut rate = self.derived(|lambda| lambda, |term| term.residue.re)?;
        if !self.away().is_zero() {
            rate.push(Term { lambda: Complex::zero(), residue: Complex::from(self.away()), root: 0 })?;
        }
        Ok(rate)
    }

    /// The response of the acceleration of the entry. Modes that are not in the list have no part in it: with [`absolute`](ModalResponse::absolute) they ride with
    /// the ground.
    ///
    /// # Errors
    /// [`MotionError::SupportMotion`] as for [`rate`](ModalResponse::rate).
    pub fn acceleration(&self) -> Result<Self, MotionError> {
        let mut acceleration = self.derived(|lambda| lambda * lambda, |term| (term.residue * term.lambda).re)?;
        acceleration.residual += self.away();
        Ok(acceleration)
    }

    /// The response of a derivative: its terms by a factor, and what follows the load at once.
    fn derived(
        &self,
        factor: impl Fn(Complex<T>) -> Complex<T>,
        at_once: impl Fn(&Term<T>) -> T,
    ) -> Result<Self, MotionError> {
        if self.is_motion {
            return Err(MotionError::SupportMotion);
        }
        let mut terms = List::new();
        let mut residual = T::zero();
        for term in &self.terms {
            residual += at_once(term);
            let derived = Term { residue: term.residue * factor(term.lambda), ..*term };
            terms.push(derived).map_err(|_| MotionError::Capacity { capacity: N })?;
        }
        let zero = T::zero();
        Ok(ModalResponse { terms, residual, rigid: zero, carried: zero, lag: zero, along: None, ..*self })
    }

    /// The response to the acceleration of a support, in place of its motion: as a record of an earthquake has it. The motion is its second integral from rest, in closed
    /// form; modes that are not in the list go along as at rest.
    ///
    /// # Errors
    /// [`MotionError::NoSupportMotion`] for another load than the motion of a support; [`MotionError::Resonance`] as
    /// [`static_value`](ModalResponse::static_value).
    pub fn from_acceleration(&self) -> Result<Self, MotionError> {
        if !self.is_motion {
            return Err(MotionError::NoSupportMotion);
        }
        let rigid = self.static_value()?;
        let mut terms = List::new();
        for term in &self.terms {
            let integrated = Term { residue: term.residue / (term.lambda * term.lambda), ..*term };
            terms.push(integrated).map_err(|_| MotionError::Capacity { capacity: N })?;
        }
        let zero = T::zero();
        Ok(ModalResponse { terms, rigid, residual: zero, lag: zero, is_motion: false, ..*self })
    }

    /// The entry at a time \[s\] after a constant load of 1, under which the system rested, is taken away; the static value before that, NaN for a time that is NaN.
    ///
    /// # Errors
    /// As [`static_value`](ModalResponse::static_value).
    pub fn to_release(&self, time: T) -> Result<T, MotionError> {
        Ok(self.static_value()? - self.to_step(time))
    }
}
