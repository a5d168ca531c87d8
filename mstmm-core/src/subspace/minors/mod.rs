//! Subspaces of states up to bending by their minors: lines and planes.

pub(crate) mod connecting;
pub(crate) mod covector;
pub(crate) mod join;
pub(crate) mod line;
pub(crate) mod plane;
pub(crate) mod subspace;
