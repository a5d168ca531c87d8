//! Elements of any type in one, as lists of steps hold them.

use crate::element::member_numbers::MemberNumbers;
use crate::element::visit::{Visit, VisitStep};
use crate::model::{Ends, Extent, FrequencyEstimates};
use crate::number::{Real, Scalar};
use mstmm_plan::Space;

/// The largest number of parameters of an element of a list, that of a tapered beam. A plan has this number of places for the derivatives of each step.
pub const MOST_PARAMETERS: usize = 12;

/// An element of a list, of any type.
pub trait ListElement {
    /// Scalar of the parameters.
    type Parameter: Real;

    /// Whether some element of this type may have a negative stiffness at rest.
    const MAY_BUCKLE: bool = false;

    /// Whether this element may.
    fn may_buckle(&self) -> bool {
        Self::MAY_BUCKLE
    }

    /// Space of the states at both ends.
    fn space(&self) -> Space;

    /// The name of its type, for drawings.
    fn name(&self) -> &'static str {
        "element"
    }

    /// Where its output end is from its input end, for drawings.
    fn extent(&self) -> Extent {
        Extent::default()
    }

    /// Names of the parameters, in the order of the fields.
    fn parameters(&self) -> &'static [&'static str];

    /// The numbers from which its dynamic stiffness follows.
    fn member_numbers(&self) -> MemberNumbers {
        MemberNumbers::Other
    }

    /// Adds the element to the estimates of the searches.
    fn estimate(&self, estimates: &mut FrequencyEstimates);
}

/// A [`ListElement`] through which subspaces go at frequencies of type `S`.
pub trait ListStepping<S: Scalar>: ListElement {
    /// Shows the element to a visitor of a pass.
    fn visit_step<V: VisitStep<S>>(&self, visitor: V) -> V::Output;
}

/// A [`ListElement`] that says all about its motion.
pub trait ListMoving<S: Scalar>: ListStepping<S> {
    /// Shows the element to a visitor of an answer.
    fn visit<V: Visit<S>>(&self, visitor: V) -> V::Output;

    /// `∂L/∂p` for each parameter, zero beyond the last.
    fn gradient(&self, ends: &Ends<S>) -> [S; MOST_PARAMETERS];
}
