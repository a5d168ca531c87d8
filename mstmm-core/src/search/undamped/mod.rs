//! Natural frequencies of undamped systems: certified by counts.

pub(crate) mod approach;
mod beyond_doubt;
pub(crate) mod certificate;
pub(crate) mod confirm;
pub(crate) mod found;
pub(crate) mod in_step;
mod interpolation;
pub(crate) mod isolation;
pub(crate) mod natural;
mod network_samples;
pub(crate) mod polish;
pub(crate) mod sampling;
pub(crate) mod stability;
pub(crate) mod sweep;
pub(crate) mod together;
