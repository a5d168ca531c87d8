//! What an element is, how subspaces go through it, and its energies.

pub(crate) mod energies;
pub(crate) mod traits;
