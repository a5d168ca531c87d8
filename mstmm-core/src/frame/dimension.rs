//! The number of coordinates of a frame, as a type.

use crate::frame::tensor::Tensor;
use core::fmt::Debug;
use mstmm_plan::{Freedoms, Support};

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Line {}
    impl Sealed for super::Plane {}
    impl Sealed for super::Space {}
}

/// The dimension of a frame: [`Line`], [`Plane`] or [`Space`]. It follows from the first place.
pub trait Dimension: sealed::Sealed + Copy + Debug + PartialEq + Send + Sync + 'static {
    /// The coordinates of a place \[m\].
    type Place: Copy + Debug + PartialEq + Send + Sync;

    /// The inertia of a body about its mass centre [kg m²]: a moment of inertia, in space a [`Tensor`].
    type Inertia: Copy + Debug + PartialEq + Send + Sync;

    /// The freedoms that a point may have.
    #[doc(hidden)]
    const FREEDOMS: Freedoms;

    /// The direction in which paths of one motion act where they name none.
    #[doc(hidden)]
    const ACROSS: Option<[f64; 3]>;

    /// A place in space.
    #[doc(hidden)]
    fn in_space(place: Self::Place) -> [f64; 3];

    /// The entries xx, yy, zz, xy, yz and zx of an inertia.
    #[doc(hidden)]
    fn tensor(inertia: Self::Inertia) -> [f64; 6];

    /// What a support holds; none where it has no direction.
    #[doc(hidden)]
    fn held_by(support: Support) -> Option<Freedoms>;
}

/// Structures along a line, with one coordinate, whose members move across it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {}

/// Structures in the plane, with two coordinates: x to the right, y upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {}

/// Structures in space, with three coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {}

impl Dimension for Line {
    type Place = f64;
    type Inertia = f64;
    const FREEDOMS: Freedoms = Freedoms::Y.union(Freedoms::RZ);
    const ACROSS: Option<[f64; 3]> = Some([0.0, 1.0, 0.0]);

    fn in_space(x: f64) -> [f64; 3] {
        [x, 0.0, 0.0]
    }

    fn tensor(about_z: f64) -> [f64; 6] {
        Plane::tensor(about_z)
    }

    fn held_by(support: Support) -> Option<Freedoms> {
        Some(support.holds().intersection(Line::FREEDOMS))
    }
}

impl Dimension for Plane {
    type Place = [f64; 2];
    type Inertia = f64;
    const FREEDOMS: Freedoms = Freedoms::PLANE;
    const ACROSS: Option<[f64; 3]> = None;

    fn in_space([x, y]: [f64; 2]) -> [f64; 3] {
        [x, y, 0.0]
    }

    fn tensor(about_z: f64) -> [f64; 6] {
        [0.0, 0.0, about_z, 0.0, 0.0, 0.0]
    }

    fn held_by(support: Support) -> Option<Freedoms> {
        Some(support.holds())
    }
}

impl Dimension for Space {
    type Place = [f64; 3];
    type Inertia = Tensor;
    const FREEDOMS: Freedoms = Freedoms::SPACE;
    const ACROSS: Option<[f64; 3]> = None;

    fn in_space(place: [f64; 3]) -> [f64; 3] {
        place
    }

    fn tensor(inertia: Tensor) -> [f64; 6] {
        inertia.entries()
    }

    fn held_by(support: Support) -> Option<Freedoms> {
        match support {
            Support::Fixed => Some(Freedoms::SPACE),
            Support::Pinned => Some(Freedoms::X.union(Freedoms::Y).union(Freedoms::Z)),
            Support::Free => Some(Freedoms::NONE),
            Support::Guided | Support::Roller => None,
        }
    }
}

/// The coordinates of a place: a number along a line, two in the plane, three in space.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no place",
    note = "a place is `x` along a line, an `f64`, `[x, y]` in the plane, an `[f64; 2]`, or `[x, y, z]` in space, an `[f64; 3]`"
)]
pub trait Place {
    /// The dimension of frames that have such places.
    type Dimension: Dimension;

    /// The coordinates.
    fn place(self) -> <Self::Dimension as Dimension>::Place;
}

/// Places of dimensions.
macro_rules! places {
    ($($place:ty: $dimension:ty;)*) => {$(
        impl Place for $place {
            type Dimension = $dimension;

            fn place(self) -> $place {
                self
            }
        }
    )*};
}
places!(f64: Line; [f64; 2]: Plane; [f64; 3]: Space;);
