//! What the boundary conditions upstream of a point leave of the state there, and the count that goes with it.

pub(crate) mod count;
pub(crate) mod minors;
pub(crate) mod remainder;
