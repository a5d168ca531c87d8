//! What ties points rigidly: bodies, links, masses at points.

use crate::elements::gyroscope::Gyroscope;
use crate::frame::dimension::{Dimension, Line, Plane, Space};
use crate::frame::tensor::Tensor;

/// A rigid body that ties points: its mass, its inertia about its mass centre, and that centre.
///
/// `P` is a place: `f64` along a line, `[f64; 2]` in the plane, `[f64; 3]` in space. There the inertia is a [`Tensor`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody<P, I = f64> {
    /// Mass \[kg\], zero or positive.
    pub mass: f64,
    /// Moment of inertia, or tensor of inertia, about the mass centre [kg m²], zero or positive.
    pub inertia: I,
    /// Mass centre \[m\].
    pub centre: P,
}

/// What ties points rigidly, without mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RigidLink;

/// A mass at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointMass<I = f64> {
    /// Mass \[kg\], zero or positive.
    pub mass: f64,
    /// Moment of inertia [kg m²], zero or positive; in space a [`Tensor`].
    pub inertia: I,
}

/// What ties points rigidly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid<D: Dimension> {
    pub(crate) mass: f64,
    /// The entries of its tensor of inertia.
    pub(crate) inertia: [f64; 6],
    /// The mass centre; none at the first point.
    pub(crate) centre: Option<D::Place>,
    /// Whether the points turn with it, even where it has no inertia.
    pub(crate) turns: bool,
    /// What spins of it.
    pub(crate) gyroscope: Option<Gyroscope<f64>>,
}

impl<D: Dimension> From<RigidLink> for Rigid<D> {
    fn from(_: RigidLink) -> Self {
        Rigid { mass: 0.0, inertia: [0.0; 6], centre: None, turns: true, gyroscope: None }
    }
}

/// Bodies with places of a dimension.
macro_rules! bodies {
    ($($dimension:ty: $place:ty, $inertia:ty;)*) => {$(
        impl From<RigidBody<$place, $inertia>> for Rigid<$dimension> {
            fn from(RigidBody { mass, inertia, centre }: RigidBody<$place, $inertia>) -> Self {
                let inertia = <$dimension>::tensor(inertia);
                Rigid { mass, inertia, centre: Some(centre), turns: true, gyroscope: None }
            }
        }

        impl From<PointMass<$inertia>> for Rigid<$dimension> {
            fn from(PointMass { mass, inertia }: PointMass<$inertia>) -> Self {
                let inertia = <$dimension>::tensor(inertia);
                Rigid { mass, inertia, centre: None, turns: inertia != [0.0; 6], gyroscope: None }
            }
        }
    )*};
}
bodies!(Line: f64, f64; Plane: [f64; 2], f64; Space: [f64; 3], Tensor;);

/// Whether a number is a mass.
pub(crate) fn is_mass(mass: f64) -> bool {
    mass >= 0.0 && mass.is_finite()
}
