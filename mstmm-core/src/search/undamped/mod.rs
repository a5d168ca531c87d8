//! Natural frequencies of undamped systems: proposed by searches that nobody has to trust, and proven.

pub(crate) mod approach;
mod at_rest;
mod domination;
pub(crate) mod field_box;
pub(crate) mod found;
pub(crate) mod in_step;
mod interpolation;
pub(crate) mod isolation;
pub(crate) mod natural;
mod network_samples;
pub(crate) mod polish;
pub(crate) mod proven;
pub(crate) mod sampling;
pub(crate) mod sweep;
pub(crate) mod together;
pub(crate) mod tolerance_box;
