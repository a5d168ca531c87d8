//! Peaks of responses over a band: what users ask, and of which responses.

pub(crate) mod of_modes;
pub(crate) mod of_proportional;
pub(crate) mod of_response;
pub(crate) mod ratio;
pub(crate) mod result;
