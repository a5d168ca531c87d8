//! A built system as a tree whose elements can be visited one by one: what the macro emits for motions.

use crate::element::energies::Energies;
use crate::element::traits::PlaneStep;
use crate::number::branch_free::BranchFree;
use crate::number::frequency::{ExtendedOf, Oscillation};
use crate::number::frequency_powers::FrequencyPowers;
use crate::number::scalar::Scalar;
use crate::pass::characteristic::System;
use core::fmt::Debug;
use mstmm_plan::Scheme;

/// What is done with an element, of whatever type.
pub trait Visit<S: Scalar> {
    /// What comes of it.
    type Output;

    /// Visits an element.
    fn element<E: Energies<S>>(self, built: &E::Built) -> Self::Output;
}

/// What is done with an element at a frequency.
pub trait VisitAt<S: Scalar> {
    /// What comes of it.
    type Output;

    /// Visits an element with what was computed of it at the frequency.
    fn element<E: Energies<S>>(self, built: &E::Built, coefficients: &E::Coefficients) -> Self::Output;
}

/// A built system with its plan.
pub trait Planned {
    /// The model whose labels it has.
    type Model;

    /// A value per step of the plan.
    type PerStep<V: Copy + Debug>: AsRef<[V]> + AsMut<[V]> + Copy + Debug;

    /// One value for all steps.
    fn per_step<V: Copy + Debug>(value: V) -> Self::PerStep<V>;

    /// The plan.
    fn scheme() -> Scheme<'static>;
}

/// A built system whose elements all say how they move.
#[diagnostic::on_unimplemented(
    message = "the motions of `{Self}` are not known at a frequency of type `{S}`",
    note = "a real ω is a frequency of undamped systems only; planar elements have no motions yet"
)]
pub trait Tree<S: Scalar>: System + Planned {
    /// Coefficients of all elements at a frequency.
    type Evaluated;

    /// The frequency with what the elements need of it.
    fn at(x: S) -> FrequencyPowers<S>;

    /// Computes what depends on the frequency, once for equal elements.
    fn evaluate(&self, at: &FrequencyPowers<S>) -> Self::Evaluated;

    /// Visits the element of a step; `None` where the step is none.
    fn visit<V: Visit<S>>(&self, step: usize, visitor: V) -> Option<V::Output>;

    /// Visits the element of a step at the frequency of what was evaluated; `None` where the step is none.
    fn visit_at<V: VisitAt<S>>(&self, evaluated: &Self::Evaluated, step: usize, visitor: V) -> Option<V::Output>;
}

/// What is done with an element at the frequencies of a block.
pub trait VisitInBlock<S: Scalar> {
    /// Visits an element.
    fn element<E>(self, built: &E::Built)
    where
        E: Energies<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>>;
}

/// A tree whose elements take blocks of frequencies.
#[diagnostic::on_unimplemented(
    message = "the motions of `{Self}` are not known at frequencies of type `{S}`",
    note = "a real ω is a frequency of undamped systems only; planar elements have no motions yet; an element of your own \
            implements `mstmm::PlaneStep<S>` and `mstmm::Energies<S>` for every `S`"
)]
pub trait TreeInBlocks<S: Scalar>: Tree<S> {
    /// Visits the element of a step, if it is one.
    fn visit_in_block<V: VisitInBlock<S>>(&self, step: usize, visitor: V);
}

/// A tree at frequencies of some type, and at those in the arithmetic that judges them.
pub trait ExtendedTree<S>: Tree<S> + Tree<ExtendedOf<S, <Self as System>::Parameter>>
where
    S: Oscillation<<Self as System>::Parameter>,
{
}

impl<Y, S> ExtendedTree<S> for Y
where
    S: Oscillation<<Y as System>::Parameter>,
    Y: Tree<S> + Tree<ExtendedOf<S, <Y as System>::Parameter>> + ?Sized,
{
}
