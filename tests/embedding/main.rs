//! What a program with few means must know: allocations, stack, operations, features.

// as the programs of tests/firmware call it
extern crate mstmm as vibrations;

mod features;
pub mod firmware;
pub mod no_allocation;
pub mod operations;
mod stack;
#[path = "../support/mod.rs"]
pub mod support;
