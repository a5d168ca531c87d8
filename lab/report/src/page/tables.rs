//! The tables of the paper, printed and computed.

use super::drawings::drawing;
use super::text::{error, symbol};
use crate::data::shapes::System;
use crate::data::tables::Table;
use maud::{Markup, html};
use paper::{Column, Solution, Solved, Value};

/// Significant digits of computed and exact values.
const DIGITS: usize = 10;

/// A table for each example.
pub(super) fn section(tables: &[Table], systems: &[System]) -> Markup {
    html! {
        p {
            "Beside the printed values stand those that the paper's own searches for minima of |Δ| find here, " code { "fmin1d" }
            " and " code { "fmin2d" } " with the paper's settings, and those of the certified search. Errors are relative to the \
            exact values, which come from another method in 60 digits."
        }
        @for table in tables { (example(table, systems)) }
    }
}

fn example(Table { example, solved }: &Table, systems: &[System]) -> Markup {
    let lead = html! {
        h3 { (example.id) " " (example.title) }
        p class="quiet" {
            "Table " (example.table) ", a matrix of " (solved.size) " × " (solved.size) ". "
            @for solution in &solved.solutions {
                (solution.method) ": " (solution.evaluations) " evaluations. "
            }
        }
        @if let Some(system) = systems.iter().find(|system| system.id == example.id) {
            (drawing(&example.title, &system.svg))
        }
    };
    let table = scrolling(html! {
            thead {
                tr {
                    th { "mode" } th { "printed" }
                    @for solution in &solved.solutions { th { "computed" br; (solution.method) } }
                    th { "exact" }
                    @for solution in &solved.solutions { th { "error of" br; (solution.method) } }
                }
            }
            tbody {
                @for column in &example.columns {
                    tr class="group" { th colspan=(3 + 2 * solved.solutions.len()) { (symbol(column.symbol())) } }
                    @for mode in 0..column.printed.len() { (row(column, mode, &values(column, mode, solved))) }
                }
            }
    });
    beside(lead, table)
}

/// A table beside what is said about it.
pub(super) fn beside(lead: Markup, table: Markup) -> Markup {
    html! { div class="beside" { div class="lead" { (lead) } (table) } }
}

/// A table that scrolls sideways where it is too wide, and says so: its first column stays.
pub(super) fn scrolling(content: Markup) -> Markup {
    html! {
        div class="wide" {
            p class="hint" aria-hidden="true" { "scroll sideways for more columns →" }
            div class="scroll" tabindex="0" { table { (content) } }
        }
    }
}

/// A value by each method; none where the method found too few roots.
fn values(column: &Column, mode: usize, solved: &Solved) -> Vec<Option<Value>> {
    let of = |solution: &Solution| Some(column.quantity.of(*solution.roots.get(mode)?, solved.unit));
    solved.solutions.iter().map(of).collect()
}

fn row(column: &Column, mode: usize, values: &[Option<Value>]) -> Markup {
    let exact = column.exact[mode];
    html! {
        tr {
            td { (mode + 1) } td { (shown(&column.printed[mode].to_string())) }
            @for value in values {
                td { @match value { Some(value) => (shown(&format!("{value:.DIGITS$}"))), None => "not found" } }
            }
            td { (shown(&format!("{exact:.DIGITS$}"))) }
            @for value in values {
                td { @match value { Some(value) => (error(value.relative_error(exact))), None => "–" } }
            }
        }
    }
}

/// A value with true minus signs; a complex one may break before its imaginary part and nowhere else.
fn shown(value: &str) -> String {
    value.replace('-', "−").replace("+ ", "+\u{a0}").replace("− ", "−\u{a0}")
}
