//! Anchors without a place of their own.

/// An anchor without a place: a motion of a path, or the ground behind it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Loose {
    pub(crate) anchor: usize,
    /// Index of its node.
    pub(crate) node: usize,
    pub(crate) rests: bool,
}
