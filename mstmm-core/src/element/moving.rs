//! The traits that visitors require of elements; each follows from others.

use crate::element::back_transfer::BackTransfer;
use crate::element::energies::Energies;
use crate::element::traits::PlaneStep;
use crate::number::{BranchFree, Scalar};

/// The coefficients of an element at a frequency.
pub type CoefficientsOf<E, S> = <E as PlaneStep<S>>::Coefficients;

/// An element whose step also computes with branch-free numbers.
pub trait Stepping<S: Scalar>: PlaneStep<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>> {}

impl<S: Scalar, E> Stepping<S> for E where
    E: PlaneStep<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>>
{
}

/// An element with steps, back transfer and energies.
pub trait Moving<S: Scalar>: Stepping<S> + BackTransfer<S> + Energies<S> {}

impl<S: Scalar, E: Stepping<S> + BackTransfer<S> + Energies<S>> Moving<S> for E {}
