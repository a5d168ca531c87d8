//! Where variables of objects go in the front of a node.

/// Where the variable of an object goes in the front.
#[derive(Clone, Copy, Debug)]
pub(super) struct Target {
    /// A power of two for its row, and its place.
    pub(super) power: f64,
    pub(super) place: u32,
    pub(super) kind: Kind,
}

impl Target {
    /// Not known yet.
    pub(super) const NONE: Target = Target { kind: Kind::Place, place: 0, power: 0.0 };
}

/// The kind of a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// To a place.
    Place,
    /// To the motions of the node, the sum of them with the coefficients of its row.
    Motions,
    /// Out of it: a force that the node does not take.
    Nowhere,
}
