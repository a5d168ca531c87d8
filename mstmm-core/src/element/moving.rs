//! The traits that visitors require of elements; each follows from others.

use crate::element::back_transfer::BackTransfer;
use crate::element::energies::Energies;
use crate::element::traits::PlaneStep;
use crate::number::Scalar;

/// The coefficients of an element at a frequency.
pub type CoefficientsOf<E, S> = <E as PlaneStep<S>>::Coefficients;

/// An element that says all about its motion.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say how it moves",
    label = "no motion of this element at such a frequency",
    note = "planar elements have motions between points with places, `conn a at (x, y)`; an element of your own implements `PlaneStep`, `BackTransfer` and `Energies` of \
            `mstmm::element` for every `S`",
    note = "a system with a damper moves at a complex λ only: pass `Complex::new(re, im)` for λ [1/s], and search its `eigenvalues` \
            instead of `natural_frequencies`"
)]
pub trait Moving<S: Scalar>: PlaneStep<S> + BackTransfer<S> + Energies<S> {}

#[diagnostic::do_not_recommend]
impl<S: Scalar, E: PlaneStep<S> + BackTransfer<S> + Energies<S>> Moving<S> for E {}
