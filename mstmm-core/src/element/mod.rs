//! What an element is, how subspaces go through it, and its energies.

pub(crate) mod back_transfer;
pub(crate) mod energies;
pub(crate) mod listed;
pub(crate) mod moving;
pub(crate) mod traits;
pub(crate) mod visit;
