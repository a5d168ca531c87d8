//! The language of `system!`: what may be written, what it means, what is refused, and the README's first model.

mod bad_numbers;
mod bodies;
mod by_parameters;
pub mod expansion;
mod formulas;
mod named_points;
mod readme;
mod scenes;
#[path = "../support/mod.rs"]
pub mod support;
