//! What visitors ask of elements: traits that follow from the others.

use crate::element::back_transfer::BackTransfer;
use crate::element::energies::Energies;
use crate::element::traits::PlaneStep;
use crate::number::branch_free::BranchFree;
use crate::number::scalar::Scalar;

/// The coefficients of an element at a frequency.
pub type CoefficientsOf<E, S> = <E as PlaneStep<S>>::Coefficients;

/// An element whose step stands in straight-line code as well.
pub trait Stepping<S: Scalar>: PlaneStep<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>> {}

impl<S: Scalar, E> Stepping<S> for E where
    E: PlaneStep<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>>
{
}

/// An element that says all about its motion.
pub trait Moving<S: Scalar>: Stepping<S> + BackTransfer<S> + Energies<S> {}

impl<S: Scalar, E: Stepping<S> + BackTransfer<S> + Energies<S>> Moving<S> for E {}
