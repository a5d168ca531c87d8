//! Tests of the proof.

mod arithmetic;
mod assembly;
mod counts;
mod exact;
mod functions;
mod members;
mod random;
mod singular;
mod step;
mod theorem;
mod worst;
