//! How the parameters of a member change its dynamic work.

use crate::element::charted::MemberElement;
use crate::element::member_motion::MemberEnds;
use crate::element::traits::Element;
use crate::number::Scalar;

/// An element of a plane structure whose dynamic work has derivatives with respect to its parameters.
///
/// The dynamic work of a member is `L = ½ Σ f u` over both ends, `V + λ² T + λ D` with half its forms of stiffness, mass and damping.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say how its parameters change a frame",
    label = "no `MemberGradient<{S}>` for this element",
    note = "sensitivities of frames need it; an element of your own implements `mstmm::element::MemberGradient<S>` for every \
            `S: mstmm::number::Oscillation<T>`, with its struct over `S` as `Gradient`"
)]
pub trait MemberGradient<S: Scalar>: Element {
    /// The derivatives with respect to the parameters: the struct of the parameters, over `S`.
    type Gradient;

    /// `∂L/∂p` for each parameter, with the displacements of both ends held.
    fn member_gradient(built: &Self::Built, motion: &MemberEnds<S>) -> Self::Gradient;
}

/// The parameters of an element by their names, or the derivatives with respect to each parameter.
pub trait ByName<S> {
    /// The parameter of a name, or the derivative with respect to it.
    fn by_name(&self, name: &str) -> Option<S>;
}

/// A member of any type that says how its parameters change its dynamic work.
pub trait MemberSlopes<S: Scalar>: MemberElement {
    /// `∂L/∂p` for the parameter of a name, if there is one.
    fn slope(built: &Self::Built, motion: &MemberEnds<S>, name: &str) -> Option<S>;
}
