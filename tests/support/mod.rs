//! What tests of several subjects share, compiled once for each of their programs.
#![allow(dead_code, reason = "each program takes what it needs")]

pub(crate) mod list_of_tree;
#[path = "../../examples/paper/models.rs"]
pub mod models;
pub(crate) mod moving_tree;
pub(crate) mod random_tree;
pub(crate) mod roots;
pub(crate) mod tree;
