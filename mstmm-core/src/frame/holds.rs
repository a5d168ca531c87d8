//! What supports hold.

use crate::frame::dimension::{Dimension, Plane};
use core::marker::PhantomData;
use mstmm_plan::{Freedoms, Support};

/// What a support holds of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hold<D> {
    pub(crate) freedoms: Freedoms,
    /// The direction along which the point moves; it is held across that.
    pub(crate) along: Option<[f64; 2]>,
    of: PhantomData<fn() -> D>,
}

impl<D: Dimension> From<Support> for Hold<D> {
    fn from(support: Support) -> Self {
        Hold::from(support.holds())
    }
}

impl<D: Dimension> From<Freedoms> for Hold<D> {
    fn from(freedoms: Freedoms) -> Self {
        Hold { freedoms: freedoms.intersection(D::FREEDOMS), along: None, of: PhantomData }
    }
}

/// A support that lets a point move along a direction and holds it across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roller {
    along: [f64; 2],
    holds_rotation: bool,
}

impl Roller {
    /// The roller of a direction, of any length.
    pub const fn along(direction: [f64; 2]) -> Self {
        Roller { along: direction, holds_rotation: false }
    }

    /// The roller that holds the rotation, too: a guide.
    #[must_use]
    pub const fn without_rotation(self) -> Self {
        Roller { holds_rotation: true, ..self }
    }
}

impl From<Roller> for Hold<Plane> {
    fn from(Roller { along, holds_rotation }: Roller) -> Self {
        let freedoms = if holds_rotation { Freedoms::RZ } else { Freedoms::NONE };
        Hold { freedoms, along: Some(along), of: PhantomData }
    }
}
