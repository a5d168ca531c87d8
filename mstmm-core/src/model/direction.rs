//! Directions in which a whole model moves, or is pulled, and axes about which it turns.

use crate::model::plain::plain;
use core::marker::PhantomData;

/// A direction along an axis of a model `M`, in which its ground moves. A model without places has y alone, that of its deflections.
pub struct Direction<M> {
    /// The place of the axis among displacements and rotations.
    pub(crate) axis: usize,
    /// The place through which an axis of rotation leads.
    pub(crate) about: Option<[f64; 3]>,
    of: PhantomData<fn() -> M>,
}

/// A place of a structure: x of a line, `[x, y]` of the plane, `[x, y, z]` of space.
pub trait AxisPlace {
    /// The place in space.
    #[doc(hidden)]
    fn in_space(self) -> [f64; 3];
}

impl AxisPlace for f64 {
    fn in_space(self) -> [f64; 3] {
        [self, 0.0, 0.0]
    }
}

impl AxisPlace for [f64; 2] {
    fn in_space(self) -> [f64; 3] {
        [self[0], self[1], 0.0]
    }
}

impl AxisPlace for [f64; 3] {
    fn in_space(self) -> [f64; 3] {
        self
    }
}

impl<M> Direction<M> {
    const fn along(axis: usize) -> Self {
        Direction { axis, about: None, of: PhantomData }
    }

    /// Along x.
    pub const fn x() -> Self {
        Direction::along(0)
    }

    /// Along y.
    pub const fn y() -> Self {
        Direction::along(1)
    }

    /// Along z, in space.
    pub const fn z() -> Self {
        Direction::along(3)
    }

    /// About z, through a place `[x, y]` of the plane, or x of a line. Participation and moving mass take it; the ground of `base_acceleration` does not turn.
    pub fn about(place: impl AxisPlace) -> Self {
        Direction::through(2, place)
    }

    /// About x, through a place of space.
    pub fn about_x(place: impl AxisPlace) -> Self {
        Direction::through(4, place)
    }

    /// About y, through a place of space.
    pub fn about_y(place: impl AxisPlace) -> Self {
        Direction::through(5, place)
    }

    /// About z, through a place of space.
    pub fn about_z(place: impl AxisPlace) -> Self {
        Direction::about(place)
    }

    fn through(axis: usize, place: impl AxisPlace) -> Self {
        Direction { axis, about: Some(place.in_space()), of: PhantomData }
    }
}

plain!(Direction<M>, axis, about);
