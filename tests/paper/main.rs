//! The paper's numbers, and those of cases with exact ones: tables, the overall matrix, certified intervals.

mod decimal;
mod overall_matrix;
#[path = "../support/mod.rs"]
pub mod support;
mod tables;
mod validation;

#[path = "../../examples/paper/quantity.rs"]
mod quantity;
#[expect(dead_code, reason = "the test needs the values of a table, not its heading")]
#[path = "../../examples/paper/reference.rs"]
mod reference;
#[expect(dead_code, reason = "the test needs the roots, not their cost")]
#[path = "../../examples/paper/solve.rs"]
mod solve;

use support::models;
