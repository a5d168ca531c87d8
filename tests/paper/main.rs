//! The paper's numbers, and those of cases with exact ones: tables, the overall matrix, certified intervals.

mod decimal;
mod overall_matrix;
#[path = "../support/mod.rs"]
pub mod support;
mod tables;
mod validation;

use support::models;
