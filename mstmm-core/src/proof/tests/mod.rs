//! Tests of the proof.

mod functions;
mod general_bending;
mod tapered;
mod trees;
