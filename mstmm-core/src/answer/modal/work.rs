//! What a load works on the shape of a tree.

use crate::answer::mode_shape::ModeShape;
use crate::model::{Acting, Load, MotionError};
use crate::number::Single;
use crate::pass::route::Place;
use crate::pass::tree::Tree;

impl<Y, S> ModeShape<'_, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Single,
{
    /// The work of a load of 1 on the shape: what excites its mode. Of a force it is the deflection at its point, of a moment the rotation, of a
    /// dislocation its internal force, of the weight the factor of participation [kg^½].
    ///
    /// # Errors
    /// [`MotionError::NoSuchEntry`] where nothing there moves with the load, [`MotionError::NoUniformLoad`] for a load along an element that takes none.
    pub fn work(&self, load: Load<Y::Model>) -> Result<S, MotionError> {
        match load.acting {
            Acting::At(step, coordinate) => {
                let place = Place::of_load(self.system, (step, coordinate))?;
                // a force does work along the deflection, a moment along the rotation, and so back
                Ok(self.at(place.step, place.beyond).entry(coordinate.dual()))
            }
            Acting::Spread(spread) => Ok(self.work_of(spread)?.value),
        }
    }
}
