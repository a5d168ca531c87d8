//! Models with sliders, solved anew while these are dragged: frequencies, eigenvalues, shapes and responses as tables of numbers, which a
//! page reads from the memory of WebAssembly. Without std there, and without bindings.
#![cfg_attr(target_family = "wasm", no_std)]

pub mod bridge;
pub mod drawing;
#[cfg(target_family = "wasm")]
mod exports;
pub mod model;
pub mod portal;
pub mod problem;
pub mod shown;
pub mod slider;
pub mod table;
pub mod text;
