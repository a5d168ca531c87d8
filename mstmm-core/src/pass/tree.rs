//! A built system as a plan whose elements can be visited one by one.

use crate::element::Visit;
use crate::number::{ExtendedOf, FrequencyPowers, Oscillation, Scalar};
use crate::pass::characteristic::System;
use core::fmt::Debug;
use mstmm_plan::Scheme;

/// A built system with its plan.
pub trait Planned: System {
    /// The model whose labels it has.
    type Model;

    /// A value per step of the plan.
    type PerStep<V: Copy + Debug>: AsRef<[V]> + AsMut<[V]> + Copy + Debug;

    /// One value for all steps.
    fn per_step<V: Copy + Debug>(value: V) -> Self::PerStep<V>;

    /// The plan.
    fn scheme(&self) -> Scheme<'_>;
}

/// A built system whose elements all have back transfer and energies.
#[diagnostic::on_unimplemented(
    message = "the motions of `{Self}` are not known at a frequency of type `{S}`",
    note = "a real ω is a frequency of undamped systems only; planar elements have motions between points with places, `conn a at (x, y)`; \
            an element of your own implements `mstmm::element::BackTransfer<S>` and `mstmm::element::Energies<S>`, and `mstmm::element::PlaneStep<S>` for every `S`",
    note = "a `StepList` answers this with a plan: `.planned(&mut room)?`"
)]
pub trait Tree<S: Scalar>: Planned {
    /// Coefficients of all elements at a frequency.
    type Evaluated;

    /// The powers of a frequency that the elements need.
    fn at(x: S) -> FrequencyPowers<S>;

    /// Computes the coefficients at a frequency, once for equal elements.
    fn evaluate(&self, at: &FrequencyPowers<S>) -> Self::Evaluated;

    /// Visits the element of a step, with its coefficients if they were computed; `None` where the step is not an element.
    fn visit<V: Visit<S>>(&self, evaluated: Option<&Self::Evaluated>, step: usize, visitor: V) -> Option<V::Output>;
}

/// A tree at frequencies of a type, and at those in its extended precision.
#[diagnostic::on_unimplemented(
    message = "the motions of `{Self}` are not known at a frequency of type `{S}`",
    note = "a `StepList` answers this with a plan: `.planned(&mut room)?`"
)]
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
