//! The unknowns of a node.

use crate::structure::chart::MOST_MOTIONS;

/// The unknown of a motion: its number and its slot.
#[derive(Clone, Copy, Debug)]
pub struct MotionUnknown {
    pub(crate) number: u32,
    pub(crate) slot: u32,
}

/// The unknowns of a node, one for each motion. Several nodes may share an unknown; a motion at rest has none.
#[derive(Clone, Copy, Debug)]
pub struct NodeUnknowns {
    pub(crate) motions: [Option<MotionUnknown>; MOST_MOTIONS],
    pub(crate) count: u32,
    pub(crate) has_entered: bool,
}

impl NodeUnknowns {
    /// None yet.
    pub(crate) const NONE: Self = NodeUnknowns { motions: [None; MOST_MOTIONS], count: 0, has_entered: false };

    /// The slots of its motions, with their indices.
    pub(crate) fn slots(&self) -> impl Iterator<Item = (usize, u32)> {
        self.motions.into_iter().enumerate().filter_map(|(motion, unknown)| Some((motion, unknown?.slot)))
    }
}
