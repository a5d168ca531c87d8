//! What supports hold.

use crate::frame::dimension::{Dimension, Plane, Space};
use crate::model::Skew;
use core::marker::PhantomData;
use mstmm_plan::{Freedoms, Support};

/// What a support holds of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hold<D> {
    pub(crate) freedoms: Freedoms,
    /// How the point moves along directions, if it does.
    pub(crate) skew: Option<Skew<f64>>,
    /// Whether the support says which way it holds.
    pub(crate) has_direction: bool,
    of: PhantomData<fn() -> D>,
}

impl<D: Dimension> From<Support> for Hold<D> {
    fn from(support: Support) -> Self {
        let held = D::held_by(support);
        Hold { has_direction: held.is_some(), ..Hold::from(held.unwrap_or(Freedoms::NONE)) }
    }
}

impl<D: Dimension> From<Freedoms> for Hold<D> {
    fn from(freedoms: Freedoms) -> Self {
        Hold { freedoms: freedoms.intersection(D::FREEDOMS), skew: None, has_direction: true, of: PhantomData }
    }
}

/// A support that lets a point move along a direction and holds it across, or moves it across a direction and holds it along.
///
/// `V` is a direction: `[f64; 2]` in the plane, `[f64; 3]` in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roller<V = [f64; 2]> {
    direction: V,
    is_normal: bool,
    holds_rotation: bool,
}

impl<V: Copy> Roller<V> {
    /// The roller that moves along a direction, of any length.
    pub const fn along(direction: V) -> Self {
        Roller { direction, is_normal: false, holds_rotation: false }
    }

    /// The roller that holds a direction, of any length, and moves across it.
    pub const fn normal(direction: V) -> Self {
        Roller { direction, is_normal: true, holds_rotation: false }
    }

    /// The roller that holds all rotations, too: a guide.
    #[must_use]
    pub const fn without_rotation(self) -> Self {
        Roller { holds_rotation: true, ..self }
    }

    /// What it holds, given the rotations of its dimension.
    fn hold<D: Dimension>(self, skew: Skew<f64>, rotations: Freedoms) -> Hold<D> {
        let freedoms = if self.holds_rotation { rotations } else { Freedoms::NONE };
        Hold { skew: Some(skew), ..Hold::from(freedoms) }
    }
}

impl From<Roller> for Hold<Plane> {
    fn from(roller: Roller) -> Self {
        let [x, y] = roller.direction;
        // across a normal there is one direction in the plane
        let along = if roller.is_normal { [-y, x, 0.0] } else { [x, y, 0.0] };
        roller.hold(Skew::Along(along), Freedoms::RZ)
    }
}

impl From<Roller<[f64; 3]>> for Hold<Space> {
    fn from(roller: Roller<[f64; 3]>) -> Self {
        let skew = if roller.is_normal { Skew::Normal(roller.direction) } else { Skew::Along(roller.direction) };
        roller.hold(skew, Freedoms::RX.union(Freedoms::RY).union(Freedoms::RZ))
    }
}
