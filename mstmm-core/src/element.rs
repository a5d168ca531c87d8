//! The few traits: what an element is, and what a built system can evaluate.

use crate::error::{InvalidParameter, ParameterError};
use crate::scalar::Scalar;
use crate::scaled::Scaled;
use crate::state::{Space, StateSpace};

/// The square matrix over the states of an element `E`.
pub type MatrixOf<E, S> = <<E as Element>::State as StateSpace>::Matrix<S>;

/// An element with one input end and one output end.
///
/// An element of one's own is a struct generic over its parameter type `T`, with public fields of type `T`; it takes
/// part in a model by its path, `my_crate::Cable 4 { .. }`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an element of a model",
    note = "an element implements `mstmm::Element` and `mstmm::TransferMatrix<S>`"
)]
pub trait Element {
    /// Space of the states at both ends.
    type State: StateSpace;

    /// Checks every parameter against its range.
    ///
    /// # Errors
    /// [`InvalidParameter`] names the first parameter out of its range, with its value.
    fn validate(&self) -> Result<(), InvalidParameter>;
}

/// The transfer equation `z_O = U(x) z_I` of an element at a frequency `x` (see [`Frequency`](crate::Frequency)).
pub trait TransferMatrix<S: Scalar>: Element {
    /// The transfer matrix `U`.
    fn transfer_matrix(&self, x: S) -> MatrixOf<Self, S>;

    /// The factor that frees `U` of its poles, `K + Cλ` for a dashpot; `None` where `U` is an entire function.
    #[inline]
    fn denominator(&self, _x: S) -> Option<S> {
        None
    }
}

/// A dynamic stiffness κ as a divisor: where it vanishes, at the pole of the transfer matrix or for a damper without
/// damping, a number so small takes its place that the product with the denominator does not show it.
pub(crate) fn off_pole<S: Scalar>(kappa: S) -> S {
    if kappa.is_zero() { S::one().times_power_of_two(-100) } else { kappa }
}

/// The space of the states of an element.
#[doc(hidden)]
pub const fn space_of<E: Element>() -> Space {
    E::State::SPACE
}

/// Validates an element under its name in the model.
#[doc(hidden)]
pub fn validate<E: Element>(element: &E, name: &'static str) -> Result<(), ParameterError> {
    element.validate().map_err(|error| error.of(name))
}

/// A determinant times the denominator of an element, if the element has one.
#[doc(hidden)]
#[inline]
pub fn without_pole<E: TransferMatrix<S>, S: Scalar>(determinant: Scaled<S>, element: &E, x: S) -> Scaled<S> {
    match element.denominator(x) {
        None => determinant,
        Some(denominator) => determinant.times(denominator),
    }
}

/// A built system, evaluated at a frequency `x`: ω for a real scalar (undamped systems only), λ for a complex one.
pub trait Evaluate<S: Scalar> {
    /// `SMatrix<S, N, N>`, with `N` the number of unknowns at the boundaries.
    type Matrix;

    /// The reduced overall matrix of `U_all z_all = 0`: main transfer equation first, then the geometrical equations;
    /// columns by tips, the root's last.
    ///
    /// # Source
    /// Eqs. (30), (35), (36), (40) of the paper, boundary zeros removed.
    fn overall_matrix(&self, x: S) -> Self::Matrix;

    /// `det U_all` times the dashpots' `K + Cλ`, an entire function of λ whose zeros are the eigenvalues.
    ///
    /// In double precision its zeros are good for the first ten modes or so; products of more than about `e^700`
    /// leave the range of `f64` and give a mantissa that is not finite.
    fn overall_determinant(&self, x: S) -> Scaled<S>;
}
