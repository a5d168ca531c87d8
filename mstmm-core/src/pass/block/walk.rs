//! A built system step by step, for whoever evaluates it otherwise than in one pass at one frequency.

use crate::element::traits::PlaneStep;
use crate::model::state::{Space, Support};
use crate::number::branch_free::BranchFree;
use crate::number::scalar::Scalar;
use crate::pass::characteristic::System;

/// A built system whose steps can be walked through, from the tips to the root.
pub trait Walk<S: Scalar>: System {
    /// Shows all steps to a walker.
    fn walk<W: Walker<S>>(&self, walker: &mut W);
}

/// Someone to whom the steps of a system are shown, each path as far as it goes.
pub trait Walker<S: Scalar> {
    /// A path starts from a support.
    fn tip(&mut self, support: Support, space: Space);

    /// The last open path goes through an element.
    fn element<E>(&mut self, built: &E::Built)
    where
        E: PlaneStep<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>>;

    /// Open paths are joined, each told by the number of those opened after it; what is joined goes on as `output`, or into the
    /// root.
    fn connection(&mut self, inputs: &[usize], output: Option<Space>);

    /// The one open path ends in the root.
    fn root(&mut self, support: Support);
}
