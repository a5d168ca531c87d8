//! What tests of several subjects share, compiled once for each of their programs.
#![allow(dead_code, reason = "each program takes what it needs")]

pub mod example;
pub(crate) mod list_of_tree;
pub(crate) mod random;
pub(crate) mod random_tree;
pub(crate) mod roots;
pub(crate) mod shares;
pub(crate) mod tree;

pub use paper::models;
