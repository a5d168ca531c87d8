//! Tests of the proof.

mod functions;
mod tapered;
