//! The number of coordinates of a frame, as a type.

use core::fmt::Debug;
use mstmm_plan::Freedoms;

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Line {}
    impl Sealed for super::Plane {}
}

/// The dimension of a frame: [`Line`] or [`Plane`]. It follows from the first place.
pub trait Dimension: sealed::Sealed + Copy + Debug + PartialEq + Send + Sync + 'static {
    /// The coordinates of a place \[m\].
    type Place: Copy + Debug + PartialEq + Send + Sync;

    /// The freedoms that a point may have.
    #[doc(hidden)]
    const FREEDOMS: Freedoms;

    /// The direction in which paths of one motion act where they name none.
    #[doc(hidden)]
    const ACROSS: Option<[f64; 2]>;

    /// A place in the plane.
    #[doc(hidden)]
    fn in_plane(place: Self::Place) -> [f64; 2];
}

/// Structures along a line, with one coordinate, whose members move across it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {}

/// Structures in the plane, with two coordinates: x to the right, y upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {}

impl Dimension for Line {
    type Place = f64;
    const FREEDOMS: Freedoms = Freedoms::Y.union(Freedoms::RZ);
    const ACROSS: Option<[f64; 2]> = Some([0.0, 1.0]);

    fn in_plane(x: f64) -> [f64; 2] {
        [x, 0.0]
    }
}

impl Dimension for Plane {
    type Place = [f64; 2];
    const FREEDOMS: Freedoms = Freedoms::ALL;
    const ACROSS: Option<[f64; 2]> = None;

    fn in_plane(place: [f64; 2]) -> [f64; 2] {
        place
    }
}

/// The coordinates of a place: a number along a line, two in the plane.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no place",
    note = "a place is `x` along a line, an `f64`, or `[x, y]` in the plane, an `[f64; 2]`"
)]
pub trait Place {
    /// The dimension of frames that have such places.
    type Dimension: Dimension;

    /// The coordinates.
    fn place(self) -> <Self::Dimension as Dimension>::Place;
}

impl Place for f64 {
    type Dimension = Line;

    fn place(self) -> f64 {
        self
    }
}

impl Place for [f64; 2] {
    type Dimension = Plane;

    fn place(self) -> [f64; 2] {
        self
    }
}
