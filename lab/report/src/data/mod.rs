//! What the page shows besides the runs: computed here, drawn elsewhere.

pub(crate) mod counts;
pub(crate) mod digits;
pub(crate) mod frames;
pub(crate) mod landscapes;
pub(crate) mod shapes;
pub(crate) mod storeys;
pub(crate) mod tables;
mod trend;
