//! Sensitivities: how a root moves with each field of the model.

use crate::answer::mode_shape::simple;
use crate::answer::root::moved_by_work;
use crate::element::ListElement;
use crate::model::{Chain, Fields, MotionError, NamedFields};
use crate::number::{Oscillation, Single};
use crate::pass::characteristic::System;
use crate::pass::planned_list::{ListParameter, PlannedList};
use crate::pass::tree::ExtendedTree;
use core::fmt;

/// The derivatives of a root with respect to the fields of the model, dω/dp or dλ/dp, with their names.
///
/// Their unit is rad/s, or 1/s, per unit of the field. A field p that grows by 1 % moves the root by `0.01 p` times its derivative,
/// to first order; a frequency in Hz by that over 2π.
pub struct Sensitivities<Y: Fields + ?Sized, S: Single> {
    pub(crate) values: Y::PerField<S>,
}

impl<Y: Fields + ?Sized, S: Single> Clone for Sensitivities<Y, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Y: Fields + ?Sized, S: Single> Copy for Sensitivities<Y, S> {}

impl<Y: NamedFields + ?Sized, S: Single> fmt::Debug for Sensitivities<Y, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self.iter()).finish()
    }
}

impl<Y: NamedFields + ?Sized, S: Single> Sensitivities<Y, S> {
    /// Names and derivatives, in the order of the struct; fields that are marked `#[no_sensitivity]` are not among them.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, S)> {
        Y::NAMES.iter().copied().zip(self.values.as_ref().iter().copied())
    }

    /// The derivative with respect to a field; `None` if no field with a derivative has this name.
    pub fn get(&self, field: &str) -> Option<S> {
        self.iter().find(|(name, _)| *name == field).map(|(_, value)| value)
    }
}

impl<E: ListElement, S: Single, const STEPS: usize> Sensitivities<PlannedList<'_, E, STEPS>, S> {
    /// The derivative with respect to a parameter of a list, which is zero for one of another list that has no such step.
    pub fn of(&self, parameter: ListParameter) -> S {
        self.values.as_ref().get(parameter.index).copied().unwrap_or_default()
    }
}

/// The derivatives of a root: of the dynamic work of its shape, times what that moves it by.
pub(crate) fn sensitivities<Y, S>(system: &Y, x: S) -> Result<Sensitivities<Y, S>, MotionError>
where
    Y: ExtendedTree<S> + Chain<S> + ?Sized,
    S: Oscillation<<Y as System>::Parameter>,
{
    if x.is_zero() {
        return Err(MotionError::ZeroFrequency);
    }
    let shape = simple(system, x)?;
    let mut values = system.chain(|step| shape.ends(step));
    let factor = moved_by_work::<<Y as System>::Parameter, S>(x);
    for value in values.as_mut() {
        *value *= factor;
    }
    Ok(Sensitivities { values })
}
