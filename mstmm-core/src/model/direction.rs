//! Directions in which a whole model moves, or is pulled.

use crate::model::plain::plain;
use core::marker::PhantomData;

/// A direction along an axis of a model `M`, in which its ground moves. A model without places has y alone, that of its deflections.
pub struct Direction<M> {
    /// The place of the axis among displacements.
    pub(crate) axis: usize,
    of: PhantomData<fn() -> M>,
}

impl<M> Direction<M> {
    const fn along(axis: usize) -> Self {
        Direction { axis, of: PhantomData }
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
}

plain!(Direction<M>, axis);
