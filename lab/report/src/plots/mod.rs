//! The plots, each from its data.

pub(crate) mod cells;
mod curves;
pub(crate) mod digits;
pub(crate) mod error_time;
pub(crate) mod frames;
pub(crate) mod growth;
pub(crate) mod heat_map;
pub(crate) mod landscape;
pub(crate) mod staircase;
