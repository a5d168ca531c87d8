//! The response of a tree as a sum over modes takes it.

use crate::answer::at_rest::Part;
use crate::answer::facts::Facts;
use crate::answer::frequency_response::FrequencyResponse;
use crate::answer::modal::response::{Superposed, USUAL_MULTIPLICITY};
use crate::answer::modal::truncation::Side;
use crate::answer::mode_shape::{ModeShape, simple};
use crate::answer::repeated_root::all_shapes;
use crate::answer::root::{Root, simple_root};
use crate::model::{Entry, Load, MotionError};
use crate::number::{Oscillation, Real, Single};
use crate::pass::characteristic::System;
use crate::pass::route::Place;
use crate::pass::tree::{ExtendedTree, Planned, Tree};
use crate::search::NaturalFrequency;

/// The response of a tree.
pub(crate) struct OfTree<'a, Y: Planned + ?Sized> {
    system: &'a Y,
    load: Load<Y::Model>,
    entry: Place,
    response: FrequencyResponse<'a, Y>,
}

impl<'a, Y: Planned + ?Sized> OfTree<'a, Y> {
    pub(crate) fn new(system: &'a Y, load: Load<Y::Model>, entry: Entry<Y::Model>) -> Result<Self, MotionError> {
        let response = FrequencyResponse::new(system, load, entry)?;
        Ok(OfTree { system, load, entry: Place::of_entry(system, entry)?, response })
    }

    /// What bounds of truncation need of a load whose entry works with it.
    pub(crate) fn side<'r, const N: usize>(
        &self,
        roots: impl IntoIterator<Item = &'r NaturalFrequency<Y::Parameter>> + Clone,
        reach: Y::Parameter,
    ) -> Result<Side<Y::Parameter>, MotionError>
    where
        Y: ExtendedTree<<Y as System>::Parameter> + Sized,
        Y::Parameter: Oscillation<<Y as System>::Parameter> + 'r,
    {
        Side::new::<N>(self, roots, reach, self.entry.coordinate.is_force())
    }

    /// `φ φ` of a shape: what the load works on it, times the entry.
    fn product<S: Single>(&self, shape: &ModeShape<'_, Y, S>) -> Result<S, MotionError>
    where
        Y: Tree<S>,
    {
        let Place { step, beyond, coordinate } = self.entry;
        Ok(shape.work(self.load)? * shape.at(step, beyond).entry(coordinate))
    }
}

/// Hands on what a function makes of each shape of a root, of which there is room for as many as usual, or for `CAP`.
pub(crate) fn for_each_shape<const CAP: usize, T, R, Y>(
    system: &Y,
    root: &R,
    mut number: impl FnMut(&ModeShape<'_, Y, R::Frequency>) -> Result<R::Frequency, MotionError>,
    add: &mut dyn FnMut(R::Frequency) -> Result<(), MotionError>,
) -> Result<(), MotionError>
where
    T: Real,
    R: Root<T>,
    Y: ExtendedTree<R::Frequency> + System<Parameter = T>,
{
    let mut add = |shape: &ModeShape<'_, Y, R::Frequency>| add(number(shape)?);
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
    add: impl FnMut(&ModeShape<'_, Y, R::Frequency>) -> Result<(), MotionError>,
) -> Result<(), MotionError>
where
    T: Real,
    R: Root<T>,
    Y: ExtendedTree<R::Frequency> + System<Parameter = T>,
{
    all_shapes::<CAP, _, _, _>(system, root)?.iter().try_for_each(add)
}

impl<T, R, Y> Superposed<T, R> for OfTree<'_, Y>
where
    T: Real,
    R: Root<T>,
    Y: ExtendedTree<R::Frequency> + System<Parameter = T>,
{
    fn for_each_product<const CAP: usize>(
        &self,
        root: &R,
        add: &mut dyn FnMut(R::Frequency) -> Result<(), MotionError>,
    ) -> Result<(), MotionError> {
        for_each_shape::<CAP, _, _, _>(self.system, root, |shape| self.product(shape), add)
    }

    fn held_at_rest(&self) -> Result<Option<R::Frequency>, MotionError> {
        self.response.held_at_rest()
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
