//! The transfer of covectors back through an element.

use crate::element::traits::PlaneStep;
use crate::number::{FrequencyPowers, Scalar};
use crate::subspace::{Covector, Subspace};

/// An element that transfers covectors from its output end to its input end, to recover states.
#[diagnostic::on_unimplemented(
    message = "`{Self}` takes no states back through it",
    label = "no `BackTransfer<{S}>` for this element",
    note = "mode shapes, responses and sensitivities need it; planar elements have motions between points with places; an element of your own \
            implements `mstmm::element::BackTransfer<S>`"
)]
pub trait BackTransfer<S: Scalar>: PlaneStep<S> {
    /// The coefficients of [`back_transfer`](BackTransfer::back_transfer) at a frequency.
    type BackCoefficients;

    /// Whether the element looks the same from both ends.
    const SYMMETRIC: bool;

    /// The element seen from its output end; itself if it is symmetric.
    fn reversed(built: &Self::Built) -> Self::Built;

    /// The coefficients of `back_transfer` at a frequency.
    fn back_coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> Self::BackCoefficients;

    /// The covector at the input end: with the subspaces that `PlaneStep::step` takes and returns it gives the state at the
    /// input end where `covector` gives that at the output end.
    ///
    /// `step` maps a plane to `c U P Uᵀ` and a line to `c U l`; this is `c Uᵀ η` or `c t`.
    fn back_transfer(coefficients: &Self::BackCoefficients, input: &Subspace<S>, covector: Covector<S>) -> Covector<S>;
}
