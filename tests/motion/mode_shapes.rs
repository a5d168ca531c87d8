//! Mode shapes, judged by laws, quadratures and closed forms of their own.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]
#![expect(clippy::panic, reason = "the same")]

mod checks;
mod closed_forms;
mod energy;
mod errors;
mod long;
mod models;
mod multiple;
mod nodes;
mod paper;
mod parts;
mod random;
mod recorded;
mod residuals;
mod single_beams;
mod sketch;
mod trees;
mod varied;
mod waves;
