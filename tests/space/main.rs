//! Frames in space: exact values, an independent model, laws.

mod cases;
mod exact;
