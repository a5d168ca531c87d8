//! Frames in space: exact values, an independent model, laws.

mod buildings;
mod cases;
mod exact;
mod example;
mod laws;
mod messages;
mod motions;
#[expect(dead_code, reason = "some of what is random")]
#[path = "../support/random.rs"]
mod numbers;
mod overall;
mod random;
mod sketches;
