//! The response of a plane structure as a sum over modes takes it.

use crate::answer::at_rest::Part;
use crate::answer::facts::Facts;
use crate::answer::modal::response::{Superposed, USUAL_MULTIPLICITY};
use crate::answer::modal::truncation::Side;
use crate::answer::network::response::PlaneResponse;
use crate::answer::network::shape::{PlaneShape, all, simple};
use crate::answer::root::{Root, simple_root};
use crate::model::{MotionError, PlaneActing, PlaneEntry, PlaneLoad, Quantity};
use crate::number::Real;
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, Placed, PlaneFrequency};
use crate::search::NaturalFrequency;
use num_traits::Zero;

/// The response of a plane structure.
pub(super) struct OfFrame<'a, Y: Placed> {
    system: &'a Y,
    load: PlaneLoad<Y::Model>,
    entry: PlaneEntry<Y::Model>,
    response: PlaneResponse<'a, Y>,
}

impl<'a, Y: Placed> OfFrame<'a, Y> {
    pub(super) fn new(
        system: &'a Y,
        load: PlaneLoad<Y::Model>,
        entry: PlaneEntry<Y::Model>,
    ) -> Result<Self, MotionError> {
        if matches!((load.acting, entry.quantity), (PlaneActing::Motion(..), Quantity::Reaction(..))) {
            return Err(MotionError::NotModal);
        }
        Ok(OfFrame { system, load, entry, response: PlaneResponse::new(system, load, entry)? })
    }

    /// What bounds of truncation need of a load whose entry works with it.
    pub(super) fn side<'r, const N: usize>(
        &self,
        roots: impl IntoIterator<Item = &'r NaturalFrequency<Y::Parameter>> + Clone,
        reach: Y::Parameter,
    ) -> Result<Side<Y::Parameter>, MotionError>
    where
        Y: MovingNetwork<<Y as System>::Parameter>,
        Y::Parameter: PlaneFrequency<<Y as System>::Parameter> + 'r,
    {
        Side::new::<N>(self, roots, reach, matches!(self.entry.quantity, Quantity::Internal { .. }))
    }

    /// `φ φ` of a shape: what the load works on it, times the entry. A motion works against the reactions of its support.
    fn product<S>(&self, shape: &PlaneShape<'_, Y, S>) -> Result<S, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        Ok(shape.work(self.load)? * shape.value(self.entry)?)
    }
}

/// Hands on what a function makes of each shape of a root, of which there is room for as many as usual, or for `CAP`.
pub(super) fn for_each_shape<const CAP: usize, T, R, Y>(
    system: &Y,
    root: &R,
    mut number: impl FnMut(&PlaneShape<'_, Y, R::Frequency>) -> Result<R::Frequency, MotionError>,
    add: &mut dyn FnMut(R::Frequency) -> Result<(), MotionError>,
) -> Result<(), MotionError>
where
    T: Real,
    R: Root<T, Frequency: PlaneFrequency<T>>,
    Y: MovingNetwork<R::Frequency> + System<Parameter = T>,
{
    let mut add = |shape: &PlaneShape<'_, Y, R::Frequency>| add(number(shape)?);
    match root.multiplicity() {
        0..=1 => add(&simple(system, simple_root(root)?)?),
        2..=USUAL_MULTIPLICITY => for_each_of_several::<{ USUAL_MULTIPLICITY as usize }, _, _, _>(system, root, add),
        _ => for_each_of_several::<CAP, _, _, _>(system, root, add),
    }
}

/// Hands on the shapes of a multiple root. Not inlined, so that the memory of its shapes is freed.
#[inline(never)]
fn for_each_of_several<const CAP: usize, T, R, Y>(
    system: &Y,
    root: &R,
    add: impl FnMut(&PlaneShape<'_, Y, R::Frequency>) -> Result<(), MotionError>,
) -> Result<(), MotionError>
where
    T: Real,
    R: Root<T, Frequency: PlaneFrequency<T>>,
    Y: MovingNetwork<R::Frequency> + System<Parameter = T>,
{
    all::<CAP, _, _>(system, root.frequency(), root.multiplicity())?.iter().try_for_each(add)
}

impl<T, R, Y> Superposed<T, R> for OfFrame<'_, Y>
where
    T: Real,
    R: Root<T, Frequency: PlaneFrequency<T>>,
    Y: MovingNetwork<R::Frequency> + System<Parameter = T>,
{
    fn for_each_product<const CAP: usize>(
        &self,
        root: &R,
        add: &mut dyn FnMut(R::Frequency) -> Result<(), MotionError>,
    ) -> Result<(), MotionError> {
        for_each_shape::<CAP, _, _, _>(self.system, root, |shape| self.product(shape), add)
    }

    fn held_at_rest(&self) -> Result<Option<R::Frequency>, MotionError> {
        match self.response.states(R::Frequency::zero()) {
            Err(MotionError::Resonance { .. }) => Ok(None),
            states => states?.value(self.entry).map(Some),
        }
    }

    fn exactly(&self, x: R::Frequency) -> Result<R::Frequency, MotionError> {
        self.response.at(x)
    }

    fn sized(&self, x: R::Frequency) -> Result<Part<R::Frequency>, MotionError> {
        self.response.sized(x)
    }

    fn lowest_exponent(&self) -> i32 {
        self.system.frequency_estimates().lowest_exponent()
    }

    fn facts(&self) -> Facts<T> {
        self.response.facts()
    }

    fn has_loss(&self) -> bool {
        self.system.frequency_estimates().has_loss()
    }
}
