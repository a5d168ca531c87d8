//! The points of a frame: what loads and answers are asked about.

use crate::frame::dimension::{Line, Plane, Space};
use crate::model::asked::{asked_along_x, asked_along_y, asked_in_plane, asked_in_space};
use crate::model::{Handle, InSpace, PlanePoint};
use core::fmt::{self, Debug};
use core::marker::PhantomData;

/// The points and members of frames.
#[derive(Clone, Copy, Debug)]
pub enum InFrame {}

impl InSpace for InFrame {}

/// A point of a frame, with a place.
pub struct Point<D> {
    pub(crate) handle: Handle,
    of: PhantomData<fn() -> D>,
}

impl<D> Clone for Point<D> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D> Copy for Point<D> {}

impl<D> Debug for Point<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Point").field("handle", &self.handle).finish()
    }
}

impl<D> Point<D> {
    pub(crate) fn new(handle: Handle) -> Self {
        Point { handle, of: PhantomData }
    }

    const fn label(self) -> PlanePoint<InFrame> {
        PlanePoint::handle(self.handle)
    }
}

impl<D> From<Point<D>> for PlanePoint<InFrame> {
    fn from(point: Point<D>) -> Self {
        point.label()
    }
}

asked_along_y!([] Point<Line>, InFrame);
asked_in_plane!([] Point<Line>, InFrame);
asked_along_y!([] Point<Plane>, InFrame);
asked_along_x!([] Point<Plane>, InFrame);
asked_in_plane!([] Point<Plane>, InFrame);
asked_along_y!([] Point<Space>, InFrame);
asked_along_x!([] Point<Space>, InFrame);
asked_in_space!([] Point<Space>, InFrame);
