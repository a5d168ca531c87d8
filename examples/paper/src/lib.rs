//! The examples of Abbas, Zhou, Bestle and Rui (2017): five systems, the paper's searches and results, and the exact values.
//!
//! For what is done with them elsewhere, too: tests, benchmarks, the report.

#[allow(rustdoc::broken_intra_doc_links, reason = "units stand in brackets")]
pub mod models;
mod quantity;
mod reference;
mod solve;

pub use quantity::{Quantity, Value};
pub use reference::{Column, Example, Failure, Search, examples};
pub use solve::{Solution, Solved, solve};
