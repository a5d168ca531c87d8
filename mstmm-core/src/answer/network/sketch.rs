//! What a built plane structure looks like.

use crate::pass::network::{Drawn, DrawnBody, DrawnMember, DrawnPoint, DrawnSupport};

/// A built plane structure with the names and the coordinates of its parts, on which drawings stand.
///
/// Its iterators allocate nothing, and always go the same way: of a list by its indices. Indices of points lead into
/// [`points`](Sketch::points), those of nodes say what moves together.
#[derive(Debug)]
pub struct Sketch<'a, Y> {
    pub(super) system: &'a Y,
}

impl<'a, Y: Drawn> Sketch<'a, Y> {
    /// The points with a place.
    pub fn points(&self) -> impl Iterator<Item = DrawnPoint<Y::Model, Y::Parameter>> + use<'a, Y> {
        self.system.points()
    }

    /// The points that move with a node: those that a rigid body there ties.
    pub fn points_of(&self, node: usize) -> impl Iterator<Item = DrawnPoint<Y::Model, Y::Parameter>> + use<'a, Y> {
        self.points().filter(move |point| point.node == node)
    }

    /// The members.
    pub fn members(&self) -> impl Iterator<Item = DrawnMember<Y::Model, Y::Parameter>> + use<'a, Y> {
        self.system.members()
    }

    /// The bodies and masses.
    pub fn bodies(&self) -> impl Iterator<Item = DrawnBody<Y::Parameter>> + use<'a, Y> {
        self.system.bodies()
    }

    /// The supports of points.
    pub fn supports(&self) -> impl Iterator<Item = DrawnSupport<Y::Parameter>> + use<'a, Y> {
        self.system.supports()
    }
}
