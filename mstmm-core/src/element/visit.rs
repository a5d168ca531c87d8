//! What is done with elements of whatever type.

use crate::element::moving::{CoefficientsOf, Moving};
use crate::element::traits::PlaneStep;
use crate::number::Scalar;

/// What a pass does with an element, of whatever type.
pub trait VisitStep<S: Scalar> {
    /// What comes of it.
    type Output;

    /// Visits an element.
    fn element<E: PlaneStep<S>>(self, built: &E::Built) -> Self::Output;
}

/// What an answer about motions does with an element, of whatever type.
pub trait Visit<S: Scalar> {
    /// What comes of it.
    type Output;

    /// Visits an element, with what was computed of it at a frequency if that was evaluated.
    fn element<E: Moving<S>>(self, built: &E::Built, coefficients: Option<&CoefficientsOf<E, S>>) -> Self::Output;
}
