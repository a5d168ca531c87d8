//! Sensitivities of plane structures: how a root moves with each field of the model.

use crate::answer::network::shape::simple;
use crate::answer::network::states::PlaneStates;
use crate::answer::root::moved_by_work;
use crate::answer::sensitivity::Sensitivities;
use crate::model::{Fields, MotionError};
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, Placed, PlaneFrequency};

/// A built plane structure whose dynamic work has derivatives with respect to the fields of the model.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no sensitivities",
    note = "a network as a list has none: its model in `system!` has them"
)]
pub trait PlaneChain<S: PlaneFrequency<<Self as System>::Parameter>>: Fields + Placed {
    /// `∂L/∂(field)`, summed over members, places, directions and masses.
    #[doc(hidden)]
    fn plane_chain(&self, states: &PlaneStates<'_, Self, S>) -> Self::PerField<S>
    where
        Self: Sized;
}

/// The derivatives of a root: of the dynamic work of its shape, times what that moves it by.
pub(super) fn sensitivities<Y, S>(system: &Y, x: S) -> Result<Sensitivities<Y, S>, MotionError>
where
    Y: MovingNetwork<S> + PlaneChain<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    if x.is_zero() {
        return Err(MotionError::ZeroFrequency);
    }
    let shape = simple(system, x)?;
    let mut values = system.plane_chain(&shape);
    let factor = moved_by_work::<<Y as System>::Parameter, S>(x);
    for value in values.as_mut() {
        *value *= factor;
    }
    Ok(Sensitivities { values })
}
