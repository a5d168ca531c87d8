//! Tests of the proof.

mod functions;
