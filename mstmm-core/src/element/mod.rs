//! The traits of elements: transfer matrix, step of the plane method, back transfer and energies.

pub(crate) mod back_transfer;
pub(crate) mod energies;
pub(crate) mod listed;
pub(crate) mod moving;
pub(crate) mod traits;
pub(crate) mod visit;
