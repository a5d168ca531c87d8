//! The paper's searches: minima of a function on a grid.

pub(crate) mod cells;
pub(crate) mod fmin1d;
pub(crate) mod fmin2d;
pub(crate) mod grid;
