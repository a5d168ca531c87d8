//! Tests of the proof.
#![expect(clippy::needless_range_loop, reason = "entries of matrices are named by row and column")]

mod arithmetic;
mod assembly;
mod campaign;
mod closed_forms;
mod counts;
mod discs;
mod element_numbers;
mod exact;
mod functions;
mod general_bending;
mod lanes;
mod members;
mod models;
mod random;
mod rounded_runs;
mod singular;
mod step;
mod tapered;
mod theorem;
mod transfer;
mod trees;
mod truth;
mod two_roads;
mod worst;
