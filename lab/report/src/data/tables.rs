//! The tables of the paper: its examples, solved.

use crate::error::ReportError;
use paper::{Example, Solved, examples, solve};

/// An example with its results.
#[derive(Debug)]
pub(crate) struct Table {
    pub(crate) example: Example,
    pub(crate) solved: Solved,
}

/// Solves all examples.
pub(crate) fn tables() -> Result<Vec<Table>, ReportError> {
    let table = |example| solve(&example).map(|solved| Table { example, solved });
    let tables = examples().and_then(|examples| examples.into_iter().map(table).collect::<Result<_, _>>());
    tables.map_err(ReportError::Paper)
}
