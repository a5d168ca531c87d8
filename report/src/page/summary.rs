//! How much faster the certified search is, as a table and in words.

use super::text::time;
use crate::error::ReportError;
use crate::factor::{Factor, TARGET, factors};
use crate::method::{CERTIFIED, METHODS, Method};
use crate::plots::error_time::scenes;
use maud::{Markup, html};
use rivals::Run;
use std::fmt::Write;

/// A scene with the certified time and the factor of each rival in order.
struct Row<'a> {
    scene: &'a str,
    seconds: Option<f64>,
    factors: Vec<Option<f64>>,
}

/// The rivals that have runs.
fn rivals(runs: &[Run]) -> Vec<&'static Method> {
    let has_runs = |method: &&Method| runs.iter().any(|run| run.method == method.name);
    METHODS.iter().filter(|method| method.name != CERTIFIED).filter(has_runs).collect()
}

fn rows(runs: &[Run]) -> Vec<Row<'_>> {
    let list = factors(runs);
    let row = |scene| {
        let of = |method: &str| list.iter().find(|factor| factor.scene == scene && factor.method == method);
        let factors = rivals(runs).iter().map(|method| of(method.name).and_then(|factor| factor.ratio)).collect();
        let certified = runs.iter().find(|run| run.scene == scene && run.method == CERTIFIED);
        Row { scene, seconds: certified.map(|run| run.seconds), factors }
    };
    scenes(runs).into_iter().map(row).collect()
}

/// The table with what it means, and what a rival does better.
pub(super) fn section(runs: &[Run]) -> Result<Markup, ReportError> {
    let rivals = rivals(runs);
    Ok(html! {
        p {
            "The time of the certified search, and how many times longer each rival takes for its fastest run with all roots to a relative "
            (format!("{TARGET:.0e}")) "; – where no run of it does that. The certified search gives all digits, and a proof that no \
            root is missing."
        }
        div class="scroll" {
            table {
                thead { tr { th { "scene" } th { (CERTIFIED) } @for method in &rivals { th { (method.name) } } } }
                tbody {
                    @for row in rows(runs) {
                        tr {
                            td { (row.scene) } td { (row.seconds.map_or("–".to_owned(), time)) }
                            @for ratio in &row.factors { td class=[wins(*ratio).then_some("wins")] { (times(*ratio)) } }
                        }
                    }
                }
            }
        }
        ul { @for sentence in sentences(runs) { li { (sentence) } } }
    })
}

/// The table as Markdown.
pub fn markdown(runs: &[Run]) -> String {
    let names = rivals(runs);
    let mut text = format!("| scene | {CERTIFIED} |");
    let head = |text: String, method: &&Method| format!("{text} {} |", method.name);
    text = names.iter().fold(text, head) + "\n|---|---|" + &"---|".repeat(names.len()) + "\n";
    for Row { scene, seconds, factors } in rows(runs) {
        let cells: Vec<String> = factors.into_iter().map(times).collect();
        // writing to a string cannot fail
        let _ = writeln!(text, "| {scene} | {} | {} |", seconds.map_or("–".to_owned(), time), cells.join(" | "));
    }
    text
}

/// One sentence for each win of a rival; one that says so if there is none.
pub fn sentences(runs: &[Run]) -> Vec<String> {
    let list = factors(runs);
    let wins: Vec<String> = list.iter().filter(|factor| wins(factor.ratio)).map(win).collect();
    if wins.is_empty() { vec!["No rival is faster in any scene.".to_owned()] } else { wins }
}

fn win(factor: &Factor) -> String {
    let Factor { scene, method, ratio, error } = factor;
    let times = ratio.map_or(f64::NAN, f64::recip);
    format!("{scene}: {method} wins, {times:.1} times faster with an error of {error:.0e}, without a proof.")
}

fn wins(ratio: Option<f64>) -> bool {
    ratio.is_some_and(|ratio| ratio < 1.0)
}

/// A factor with two digits.
fn times(ratio: Option<f64>) -> String {
    match ratio {
        Some(ratio) if ratio < 10.0 => format!("× {ratio:.1}"),
        Some(ratio) => format!("× {ratio:.0}"),
        None => "–".to_owned(),
    }
}
