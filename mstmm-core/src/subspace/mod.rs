//! The subspaces that boundary conditions leave of the state at a point, and the count of natural frequencies.

pub(crate) mod connecting;
pub(crate) mod count;
pub(crate) mod minors;
pub(crate) mod remainder;
