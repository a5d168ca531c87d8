//! Eigenvalues of damped systems: certified by the argument principle.

pub(crate) mod circles;
pub(crate) mod contour;
pub(crate) mod deflation;
pub(crate) mod eigenvalues;
pub(crate) mod evaluation;
pub(crate) mod found;
pub(crate) mod growth;
pub(crate) mod newton;
pub(crate) mod peak;
pub(crate) mod point;
pub(crate) mod proven;
pub(crate) mod reach;
pub(crate) mod rectangle;
pub(crate) mod search;
pub(crate) mod session;
mod settled;
