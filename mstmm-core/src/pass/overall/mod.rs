//! The overall transfer equation of the paper.

pub(crate) mod assembly;
pub(crate) mod determinant;
pub(crate) mod evaluate;
