//! The ends of members: at points, at points of paths, at the ground.

use crate::frame::dimension::{Dimension, Place, Plane, Space};
use crate::frame::point::Point;
use crate::model::Handle;
use core::fmt::{self, Debug};
use core::marker::PhantomData;
use mstmm_plan::Freedoms;

/// What an end is joined to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Seat {
    Point(Handle),
    Path(Handle),
    Ground,
}

/// The end of a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End<D: Dimension> {
    pub(crate) seat: Seat,
    /// Its place, tied rigidly to its point; none at that of the point.
    pub(crate) place: Option<D::Place>,
    /// The freedoms that it does not share with its point, in the axes of its member.
    pub(crate) released: Freedoms,
    /// The direction in which it acts, or the axis about which it turns.
    pub(crate) along: Option<[f64; 3]>,
    /// Whether it turns about that.
    pub(crate) turns: bool,
}

impl<D: Dimension> End<D> {
    fn of(seat: Seat) -> Self {
        End { seat, place: None, released: Freedoms::NONE, along: None, turns: false }
    }

    /// The end without freedoms that it shares with its point, in the axes of its member.
    #[must_use]
    pub fn releasing(self, freedoms: Freedoms) -> Self {
        End { released: self.released.union(freedoms), ..self }
    }

    /// The end at another place, tied rigidly to its point.
    #[must_use]
    pub fn at(self, place: impl Place<Dimension = D>) -> Self {
        End { place: Some(place.place()), ..self }
    }
}

impl End<Plane> {
    /// The end in a direction, of any length: of a spring, a damper, a path, or a joint.
    #[must_use]
    pub fn along(self, [x, y]: [f64; 2]) -> Self {
        End { along: Some([x, y, 0.0]), ..self }
    }
}

impl End<Space> {
    /// The end in a direction, of any length: of a spring, a damper, a path, or a joint.
    #[must_use]
    pub fn along(self, direction: [f64; 3]) -> Self {
        End { along: Some(direction), ..self }
    }

    /// The end of what turns about an axis, of any length, right-handed: of a torsion spring, a torsion damper, a shaft of a path.
    #[must_use]
    pub fn about(self, axis: [f64; 3]) -> Self {
        End { along: Some(axis), turns: true, ..self }
    }
}

/// The ground: what nothing moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ground;

/// A point of a path of one motion, without a place.
pub struct PathPoint<D> {
    pub(crate) handle: Handle,
    of: PhantomData<fn() -> D>,
}

impl<D> PathPoint<D> {
    pub(crate) fn new(handle: Handle) -> Self {
        PathPoint { handle, of: PhantomData }
    }
}

impl<D> Clone for PathPoint<D> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D> Copy for PathPoint<D> {}

impl<D> Debug for PathPoint<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PathPoint").field("handle", &self.handle).finish()
    }
}

impl<D: Dimension> Point<D> {
    /// An end here that does not share freedoms with the point, in the axes of its member: `Freedoms::RZ` is a hinge.
    pub fn releasing(self, freedoms: Freedoms) -> End<D> {
        End::from(self).releasing(freedoms)
    }

    /// An end at another place, tied rigidly to the point.
    pub fn at(self, place: impl Place<Dimension = D>) -> End<D> {
        End::from(self).at(place)
    }
}

impl Point<Plane> {
    /// An end here that acts along a direction, of any length: of a spring, a damper, a path, or a joint.
    pub fn along(self, direction: [f64; 2]) -> End<Plane> {
        End::from(self).along(direction)
    }
}

impl Point<Space> {
    /// An end here that acts along a direction, of any length: of a spring, a damper, a path, or a joint.
    pub fn along(self, direction: [f64; 3]) -> End<Space> {
        End::from(self).along(direction)
    }

    /// An end here of what turns about an axis, of any length, right-handed: of a torsion spring, a torsion damper, a shaft of a path.
    pub fn about(self, axis: [f64; 3]) -> End<Space> {
        End::from(self).about(axis)
    }
}

impl<D: Dimension> From<Point<D>> for End<D> {
    fn from(point: Point<D>) -> Self {
        End::of(Seat::Point(point.handle))
    }
}

impl<D: Dimension> From<PathPoint<D>> for End<D> {
    fn from(point: PathPoint<D>) -> Self {
        End::of(Seat::Path(point.handle))
    }
}

impl<D: Dimension> From<Ground> for End<D> {
    fn from(_: Ground) -> Self {
        End::of(Seat::Ground)
    }
}
