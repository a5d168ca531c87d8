//! Tests of the proof.
#![expect(clippy::needless_range_loop, reason = "entries of matrices are named by row and column")]

mod arithmetic;
mod assembly;
mod counts;
mod exact;
mod functions;
mod general_bending;
mod lanes;
mod members;
mod random;
mod singular;
mod step;
mod tapered;
mod theorem;
mod trees;
mod worst;
