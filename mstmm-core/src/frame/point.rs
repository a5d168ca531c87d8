//! The points of a frame: what loads and answers are asked about.

use crate::frame::dimension::{Line, Plane};
use crate::model::{Handle, PlaneEntry, PlaneLoad, PlanePoint};
use core::fmt::{self, Debug};
use core::marker::PhantomData;

/// The points and members of frames.
#[derive(Clone, Copy, Debug)]
pub enum InFrame {}

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

/// What is asked about a point and what acts on it, as far as it has the motion.
macro_rules! asked {
    ($dimension:ty: $($(#[$doc:meta])* $name:ident -> $kind:ident;)*) => {
        impl Point<$dimension> {
            $(
                $(#[$doc])*
                pub const fn $name(self) -> $kind<InFrame> {
                    self.label().$name()
                }
            )*
        }
    };
}

/// What points of all dimensions have.
macro_rules! asked_everywhere {
    ($($dimension:ty),*) => {$(
        asked! {
            $dimension:
            /// The displacement along y \[m\].
            displacement_y -> PlaneEntry;
            /// The rotation \[rad\], anticlockwise.
            rotation_z -> PlaneEntry;
            /// The force of the support along y on the point \[N\].
            reaction_y -> PlaneEntry;
            /// The moment of the support on the point [N m].
            reaction_z -> PlaneEntry;
            /// A force of 1 N along y.
            force_y -> PlaneLoad;
            /// A moment of 1 N m, anticlockwise.
            torque_z -> PlaneLoad;
            /// A motion of 1 m of the support along y, which takes with it what it holds.
            motion_y -> PlaneLoad;
            /// A rotation of 1 rad of the support about the point, anticlockwise.
            motion_z -> PlaneLoad;
        }
    )*};
}
asked_everywhere!(Line, Plane);

asked! {
    Plane:
    /// The displacement along x \[m\].
    displacement_x -> PlaneEntry;
    /// The force of the support along x on the point \[N\].
    reaction_x -> PlaneEntry;
    /// A force of 1 N along x.
    force_x -> PlaneLoad;
    /// A motion of 1 m of the support along x, which takes with it what it holds.
    motion_x -> PlaneLoad;
}
