//! An element, its transfer matrix and its step of the plane method.

use crate::element::member_numbers::MemberNumbers;
use crate::model::{Extent, FrequencyEstimates, InvalidParameter, ParameterError, StateSpace};
use crate::number::{FrequencyPowers, Scalar, Scaled, Single};
use crate::subspace::{Connecting, RootCounter, Subspace};
use core::fmt;
use mstmm_plan::{Space, Support};

/// The square matrix over the states of an element `E`.
pub type MatrixOf<E, S> = <<E as Element>::State as StateSpace>::Matrix<S>;

/// An element with one input end and one output end.
///
/// The type is the struct of its parameters, generic over their scalar `T`, with public fields of type `T`. A model takes
/// user-defined elements by their path, `my_crate::Cable 4 { .. }`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an element: it does not implement `Element`",
    label = "not an element",
    note = "an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element` and `mstmm::element::TransferMatrix<S>` \
            for every `T: mstmm::number::Parameter`"
)]
pub trait Element: Sized {
    /// Space of the states at both ends.
    type State: StateSpace;

    /// The element with its quantities that do not depend on the frequency; `Self` where these are the parameters alone.
    ///
    /// Derive `Clone` and `Debug` for it: the built system holds it, and can be cloned and printed.
    type Built: Clone + fmt::Debug;

    /// Whether the element may have a negative stiffness at rest, as a beam under axial compression has.
    ///
    /// A system with such an element may be statically unstable: searches prove first that no motion grows.
    const MAY_BUCKLE: bool = false;

    /// Whether its step takes no branch and tells the units of its waves. Searches take systems of such elements at many frequencies at once,
    /// in lanes, and start from their phases; others are evaluated at one frequency after the other.
    const IS_STRAIGHT: bool = true;

    /// Checks every parameter against its range and computes what does not depend on the frequency.
    ///
    /// # Errors
    /// [`InvalidParameter`] names the first parameter out of its range, with its value.
    fn build(self) -> Result<Self::Built, InvalidParameter>;

    /// Adds an axial force \[N\], tension positive, to that which the element has: the sum of two words. Returns whether the element bears one.
    ///
    /// By default it bears none, and is what it was.
    ///
    /// # Errors
    /// [`InvalidParameter`] where both forces together are out of the range of the parameter.
    #[inline]
    fn add_axial_force(_built: &mut Self::Built, _force: [f64; 2]) -> Result<bool, InvalidParameter> {
        Ok(false)
    }

    /// Adds the element's stiffnesses and masses to the estimates from which searches take their first steps.
    #[inline]
    fn estimate(_built: &Self::Built, _bounds: &mut FrequencyEstimates) {}

    /// Where its output end is from its input end, for drawings; no answer depends on it.
    #[inline]
    fn extent(_built: &Self::Built) -> Extent {
        Extent::default()
    }

    /// The numbers from which its dynamic stiffness as a member follows, for searches that evaluate networks at many frequencies at once.
    ///
    /// An element whose numbers are not known, as by default, is evaluated by its [chart](crate::Charted) alone, and so is a network with it.
    /// A string or a shaft of one's own has those of a [`uniform_line`](MemberNumbers::uniform_line).
    #[inline]
    fn member_numbers(_built: &Self::Built) -> MemberNumbers {
        MemberNumbers::Other
    }
}

/// The transfer equation `z_O = U(x) z_I` of an element at a frequency `x` (see [`Frequency`](crate::number::frequency::Frequency)).
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no transfer matrix at a frequency of type `{S}`",
    label = "no `TransferMatrix<{S}>` for this element",
    note = "an element of your own implements `mstmm::element::TransferMatrix<S>` for every `S: mstmm::number::Frequency<T>`"
)]
pub trait TransferMatrix<S: Scalar>: Element {
    /// The transfer matrix `U`.
    fn transfer_matrix(built: &Self::Built, x: S) -> MatrixOf<Self, S>;

    /// The factor that removes the poles of `U`, `K + Cλ` for a dashpot; `None` where `U` is an entire function.
    #[inline]
    fn denominator(_built: &Self::Built, _x: S) -> Option<S> {
        None
    }
}

/// The step of an element in the plane method, from the subspace at its input end to the one at its output end.
///
/// Every step is a polynomial in the element's entire functions: no division, no pole.
#[diagnostic::on_unimplemented(
    message = "`{Self}` takes no part in the plane method",
    label = "no `PlaneStep` for this element",
    note = "planar elements have `overall_matrix` and `overall_determinant` only; an element of your own implements \
            `mstmm::element::PlaneStep<S>`"
)]
pub trait PlaneStep<S: Scalar>: Element {
    /// Whether the element needs the square root of the frequency, as waves do.
    const WAVES: bool = false;

    /// The coefficients of a step at a frequency; computed once for equal elements.
    type Coefficients;

    /// The coefficients at a frequency.
    fn coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> Self::Coefficients;

    /// Takes the subspace of the input end to the output end, and reports to the counter.
    fn step<C: RootCounter<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, counter: &mut C) -> Subspace<S>;

    /// The last step before the root, which gives Δ.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn root<C: RootCounter<S>>(
        coefficients: &Self::Coefficients,
        input: Subspace<S>,
        support: Support,
        counter: &mut C,
    ) -> Scaled<S> {
        Self::step(coefficients, input, counter).at_root(support, counter)
    }
}

/// The space of the states of an element.
#[doc(hidden)]
#[inline]
pub const fn space_of<E: Element>() -> Space {
    E::State::SPACE
}

/// Builds an element under its name in the model.
#[doc(hidden)]
#[inline]
pub fn build<E: Element>(element: E, name: &'static str) -> Result<E::Built, ParameterError> {
    element.build().map_err(|error| error.of(name))
}

/// A determinant times the denominator of an element, if the element has one.
#[doc(hidden)]
#[inline]
pub fn without_pole<E: TransferMatrix<S>, S: Single>(determinant: Scaled<S>, built: &E::Built, x: S) -> Scaled<S> {
    match E::denominator(built, x) {
        None => determinant,
        Some(denominator) => determinant.times(denominator),
    }
}
