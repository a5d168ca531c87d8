//! Prints results beside the paper's, as a table or as JSON.

use comfy_table::{CellAlignment, Table, presets};
use paper::{Column, Example, Solution, Solved, Value};
use serde_json::json;

/// Significant digits of computed and exact values in a table.
const DIGITS: usize = 11;

/// A heading and a table: one row for each printed value, one pair of columns for each method.
pub(crate) fn table(example: &Example, solved: &Solved) -> String {
    let mut table = Table::new();
    table.load_style(presets::UTF8_FULL_CONDENSED).set_header(header(&solved.solutions));
    for column in &example.columns {
        for index in 0..column.printed.len() {
            table.add_row(row(column, solved, index));
        }
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    format!("{}\n{table}\n", heading(example, solved))
}

fn heading(example: &Example, solved: &Solved) -> String {
    let Example { id, title, table, .. } = example;
    let size = solved.size;
    let costs = solved.solutions.iter().map(|solution| {
        let Solution { method, evaluations, time, .. } = solution;
        format!("{method}: {evaluations} evaluations, {time:.1?}")
    });
    format!("{id} {title} (Table {table}, {size} x {size}); {}", costs.collect::<Vec<_>>().join("; "))
}

fn header(solutions: &[Solution]) -> Vec<String> {
    let mut header = vec!["quantity".to_owned(), "index".to_owned(), "printed".to_owned()];
    header.extend(solutions.iter().map(|solution| format!("computed ({})", solution.method)));
    header.push("exact".to_owned());
    for Solution { method, .. } in solutions {
        header.extend([format!("{method} to printed"), format!("{method} to exact")]);
    }
    header
}

fn row(column: &Column, solved: &Solved, index: usize) -> Vec<String> {
    let (printed, exact) = (column.printed[index], column.exact[index]);
    let name = if index == 0 { column.symbol() } else { "" };
    let values: Vec<_> = solved
        .solutions
        .iter()
        .map(|solution| solution.roots.get(index).map(|&root| column.quantity.of(root, solved.unit)))
        .collect();
    let mut row = vec![name.to_owned(), (index + 1).to_string(), printed.to_string()];
    row.extend(values.iter().map(|value| match value {
        Some(value) => format!("{value:.DIGITS$}"),
        None => "not found".to_owned(),
    }));
    row.push(format!("{exact:.DIGITS$}"));
    for value in values {
        row.extend([printed, exact].map(|reference| match value {
            Some(value) => format!("{:.1e}", value.relative_error(reference)),
            None => "-".to_owned(),
        }));
    }
    row
}

/// One JSON object for each method and value found, one per line.
pub(crate) fn json_lines(example: &Example, solved: &Solved) -> String {
    let mut lines = String::new();
    for solution in &solved.solutions {
        for column in &example.columns {
            for (index, (&root, &printed)) in solution.roots.iter().zip(&column.printed).enumerate() {
                let computed = column.quantity.of(root, solved.unit);
                let line = json!({
                    "example": example.id,
                    "method": solution.method,
                    "quantity": column.name,
                    "index": index + 1,
                    "computed": json(computed),
                    "printed": json(printed),
                    "relative_error_to_printed": computed.relative_error(printed),
                    "evaluations": solution.evaluations,
                });
                lines.push_str(&format!("{line}\n"));
            }
        }
    }
    lines
}

/// A number, or real and imaginary part as a pair.
fn json(value: Value) -> serde_json::Value {
    match value {
        Value::Real(value) => json!(value),
        Value::Complex(value) => json!([value.re, value.im]),
    }
}

/// A sentence for each method that found fewer roots than the paper printed.
pub(crate) fn missing(example: &Example, solved: &Solved) -> Vec<String> {
    let printed = example.columns.iter().map(|column| column.printed.len()).max().unwrap_or(0);
    let short = solved.solutions.iter().filter(|solution| solution.roots.len() < printed);
    short
        .map(|Solution { method, roots, .. }| {
            format!("{}: {method} found {} of {printed} printed roots", example.id, roots.len())
        })
        .collect()
}
