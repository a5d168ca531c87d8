//! Tests of the proof.

mod functions;
mod general_bending;
mod lanes;
mod tapered;
mod trees;
