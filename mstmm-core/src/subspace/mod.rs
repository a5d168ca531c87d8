//! The subspaces that boundary conditions leave of the state at a point, and the count of natural frequencies.

pub(crate) mod connecting;
pub(crate) mod count;
pub(crate) mod minors;
pub(crate) mod remainder;

pub(crate) use connecting::{Connecting, connection};
pub(crate) use count::{Held, NoCount, Purpose, RootCounter, Watch, WittrickWilliams};
pub(crate) use minors::covector::Covector;
pub(crate) use minors::join::in_parallel;
pub(crate) use minors::line::Line;
pub(crate) use minors::plane::Plane;
pub(crate) use minors::subspace::Subspace;
pub(crate) use remainder::Remainder;
