//! Tests of the proof.

mod functions;
mod trees;
