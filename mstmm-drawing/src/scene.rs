//! Where a model is in space, whatever the view.

use crate::loose::Loose;
use crate::vector3::Vector3;
use crate::view::View;

/// The places of a model in space.
#[derive(Debug)]
pub(crate) struct Scene {
    pub(crate) view: View,
    /// What the source calls each place of the model, and where it is \[m\]: all that the paper must hold.
    pub(crate) extent: Vec<(String, Vector3)>,
    /// The place of each anchor; none of a loose one, which is placed on the paper.
    pub(crate) places: Vec<Option<Place>>,
    /// How near each anchor is, in units of the paper.
    pub(crate) depths: Vec<f64>,
    pub(crate) loose: Vec<Loose>,
    /// The direction of the motion of each loose anchor; zero where it turns.
    pub(crate) ways: Vec<Vector3>,
    /// The direction of each part in which its path acts.
    pub(crate) directions: Vec<Option<Vector3>>,
    /// The local axes y and z of each part that has them.
    pub(crate) axes: Vec<Option<[Vector3; 2]>>,
}

/// A place in space: metres of the model, and what the drawing adds in units of the paper.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) metres: Vector3,
    pub(crate) aside: Vector3,
}
