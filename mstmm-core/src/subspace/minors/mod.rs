//! Subspaces of states up to bending by their minors: lines and planes.
//!
//! Joins and conversions are nested, and stand in line where a build is optimised. In a debug build, where nothing of a copy is left
//! out, that would double the code of every model; there they are called.

pub(crate) mod connecting;
pub(crate) mod covector;
pub(crate) mod join;
pub(crate) mod line;
pub(crate) mod plane;
pub(crate) mod subspace;
