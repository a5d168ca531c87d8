//! What a model is before any number: freedoms, supports, and which entries of a state they make unknown.
//!
//! This crate is an implementation detail of `mstmm`, which re-exports what users need.
#![no_std]
#![forbid(unsafe_code)]

mod coordinate;
mod freedom;
mod space;
mod support;

pub use coordinate::Coordinate;
pub use freedom::Freedoms;
pub use space::{Space, WIDEST};
pub use support::Support;
