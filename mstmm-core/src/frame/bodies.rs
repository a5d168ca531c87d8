//! What ties points rigidly: bodies, links, masses at points.

use crate::frame::dimension::{Dimension, Line, Plane};

/// A rigid body that ties points: its mass, its moment of inertia about its mass centre, and that centre.
///
/// `P` is a place: `f64` along a line, `[f64; 2]` in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody<P> {
    /// Mass \[kg\], zero or positive.
    pub mass: f64,
    /// Moment of inertia about the mass centre [kg m²], zero or positive.
    pub inertia: f64,
    /// Mass centre \[m\].
    pub centre: P,
}

/// What ties points rigidly, without mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RigidLink;

/// A mass at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointMass {
    /// Mass \[kg\], zero or positive.
    pub mass: f64,
    /// Moment of inertia [kg m²], zero or positive.
    pub inertia: f64,
}

/// What ties points rigidly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid<D: Dimension> {
    pub(crate) mass: f64,
    pub(crate) inertia: f64,
    /// The mass centre; none at the first point.
    pub(crate) centre: Option<D::Place>,
    /// Whether the points turn with it, even where it has no inertia.
    pub(crate) turns: bool,
}

impl<D: Dimension> From<RigidLink> for Rigid<D> {
    fn from(_: RigidLink) -> Self {
        Rigid { mass: 0.0, inertia: 0.0, centre: None, turns: true }
    }
}

impl<D: Dimension> From<PointMass> for Rigid<D> {
    fn from(PointMass { mass, inertia }: PointMass) -> Self {
        Rigid { mass, inertia, centre: None, turns: inertia != 0.0 }
    }
}

/// Bodies with places of a dimension.
macro_rules! with_centre {
    ($($dimension:ty: $place:ty;)*) => {$(
        impl From<RigidBody<$place>> for Rigid<$dimension> {
            fn from(RigidBody { mass, inertia, centre }: RigidBody<$place>) -> Self {
                Rigid { mass, inertia, centre: Some(centre), turns: true }
            }
        }
    )*};
}
with_centre!(Line: f64; Plane: [f64; 2];);
