//! Frames in space: exact values, an independent model, laws.

mod cases;
mod exact;
mod laws;
#[path = "../support/random.rs"]
mod numbers;
mod random;
