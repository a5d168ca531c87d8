//! Responses of rates and accelerations, and those to accelerations of what moves.

use crate::answer::facts::Facts;
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
        Ok(ModalResponse { carried: self.facts.along.ok_or(MotionError::NotOfGround)?, ..*self })
    }

    /// The response of the rate of the entry, such as a velocity. Modes that are not in the list follow the rate of the load. Where they follow the load
    /// late, they have no part in the rate.
    ///
    /// Damping comes first: the rate of a response with damping is another one.
    ///
    /// # Errors
    /// [`MotionError::Capacity`] where there is no room for a rigid body beside `N` modes; [`MotionError::AtOnce`] for an entry of which a part follows the rate of the load
    /// already.
    pub fn rate(&self) -> Result<Self, MotionError> {
        let mut rate = self.derived(|lambda| lambda)?;
        rate.residual = self.terms.iter().fold(T::zero(), |sum, term| sum + term.residue.re);
        rate.flow = if self.lag.is_zero() { self.residual } else { T::zero() };
        if !self.away().is_zero() {
            rate.push(Term { lambda: Complex::zero(), residue: Complex::from(self.away()), root: 0 })?;
        }
        Ok(rate)
    }

    /// The response of the acceleration of the entry. Modes that are not in the list have no part in it: with [`absolute`](ModalResponse::absolute) they ride with
    /// the ground.
    ///
    /// # Errors
    /// [`MotionError::AtOnce`] under the motion of a support, with which a part of the entry moves at once, and as for [`rate`](ModalResponse::rate).
    pub fn acceleration(&self) -> Result<Self, MotionError> {
        if self.facts.is_motion {
            return Err(MotionError::AtOnce);
        }
        let mut acceleration = self.derived(|lambda| lambda * lambda)?;
        for term in &self.terms {
            acceleration.residual += (term.residue * term.lambda).re;
            acceleration.flow += term.residue.re;
        }
        acceleration.residual += self.away();
        Ok(acceleration)
    }

    /// The terms of a derivative, by a factor.
    fn derived(&self, factor: impl Fn(Complex<T>) -> Complex<T>) -> Result<Self, MotionError> {
        if !self.flow.is_zero() {
            return Err(MotionError::AtOnce);
        }
        let zero = T::zero();
        let facts = Facts { is_derived: true, along: None, ..self.facts };
        let (terms, [rigid, residual, lag, carried]) = (List::new(), [zero; 4]);
        let mut derived = ModalResponse { terms, rigid, residual, lag, carried, facts, ..*self };
        for term in self.terms.iter().filter(|term| !term.lambda.is_zero()) {
            derived.push(Term { residue: term.residue * factor(term.lambda), ..*term })?;
        }
        Ok(derived)
    }

    /// The response to the acceleration of a support, in place of its motion: as a record of an earthquake has it. The motion is its second integral from rest, in closed
    /// form; modes that are not in the list go along as at rest.
    ///
    /// # Errors
    /// [`MotionError::NoSupportMotion`] for another load than the motion of a support; [`MotionError::Resonance`] as
    /// [`static_value`](ModalResponse::static_value); [`MotionError::Capacity`] where there is no room for a drift beside `N` modes.
    pub fn from_acceleration(&self) -> Result<Self, MotionError> {
        if !self.facts.is_motion || self.facts.is_derived {
            return Err(MotionError::NoSupportMotion);
        }
        let zero = T::zero();
        let facts = Facts { is_motion: false, is_derived: true, ..self.facts };
        let (terms, rigid, [residual, lag, flow]) = (List::new(), self.static_value()?, [zero; 3]);
        let mut integrated = ModalResponse { terms, rigid, residual, lag, flow, facts, ..*self };
        // H(λ)/λ² = H(0)/λ² + H'(0)/λ + the integrated terms
        let mut drift = self.flow;
        for term in &self.terms {
            let residue = term.residue / (term.lambda * term.lambda);
            drift -= residue.re;
            integrated.push(Term { residue, ..*term })?;
        }
        if !drift.is_zero() {
            integrated.push(Term { lambda: Complex::zero(), residue: Complex::from(drift), root: 0 })?;
        }
        Ok(integrated)
    }

    /// The entry at a time \[s\] after a constant load of 1, under which the system rested, is taken away; the static value before that, NaN for a time that is NaN.
    ///
    /// # Errors
    /// As [`static_value`](ModalResponse::static_value).
    pub fn to_release(&self, time: T) -> Result<T, MotionError> {
        Ok(self.static_value()? - self.to_step(time))
    }
}
