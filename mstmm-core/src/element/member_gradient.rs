//! How the parameters of a member change its dynamic work.

use crate::element::charted::MemberElement;
use crate::element::traits::Element;
use crate::model::EndMotion;
use crate::number::Scalar;

/// The motion of a member: what its ends do, and the halves of its mass forms, `½ ∫ m u² dx` along it and across it, at a frequency x.
#[derive(Clone, Copy, Debug)]
pub struct MemberWork<S> {
    /// The frequency: ω for a real scalar, λ for a complex one.
    pub x: S,
    /// The motions of the input end and of the output end.
    pub ends: [EndMotion<S>; 2],
    /// The halves of the mass forms of longitudinal and of transverse motion.
    pub kinetic: [S; 2],
}

impl<S: Scalar> MemberWork<S> {
    /// A member at rest.
    pub(crate) fn at_rest(x: S) -> Self {
        MemberWork { x, ends: [EndMotion::at_rest(); 2], kinetic: [S::zero(); 2] }
    }

    /// The work of forces and displacements of a freedom at both ends.
    pub(crate) fn of_ends(&self, freedom: usize) -> S {
        let [input, output] = &self.ends;
        input.forces[freedom] * input.displacements[freedom] + output.forces[freedom] * output.displacements[freedom]
    }
}

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
    fn member_gradient(built: &Self::Built, work: &MemberWork<S>) -> Self::Gradient;
}

/// The parameters of an element by their names, or the derivatives with respect to each parameter.
pub trait ByName<S> {
    /// The parameter of a name, or the derivative with respect to it.
    fn by_name(&self, name: &str) -> Option<S>;
}

/// A member of any type that says how its parameters change its dynamic work.
pub trait MemberSlopes<S: Scalar>: MemberElement {
    /// `∂L/∂p` for the parameter of a name, if there is one.
    fn slope(built: &Self::Built, work: &MemberWork<S>, name: &str) -> Option<S>;
}
