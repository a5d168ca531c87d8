//! How much faster the certified search is, as a table and in words.

use super::text::{error, time};
use crate::error::ReportError;
use crate::method::{METHODS, Method};
use crate::plots::error_time::scenes;
use maud::{Markup, html};
use rivals::Run;
use rivals::factors::{CERTIFIED_ERROR, Factor, RIVAL_ERROR, factors};
use rivals::runs::CERTIFIED;
use std::fmt::Write;

/// A scene with the time of the certified search and each rival in order.
struct Row<'a> {
    scene: &'a str,
    seconds: Option<f64>,
    rivals: Vec<Option<Factor>>,
}

/// The rivals that have runs.
fn rivals(runs: &[Run]) -> Vec<&'static Method> {
    let has_runs = |method: &&Method| runs.iter().any(|run| run.method == method.name);
    METHODS.iter().filter(|method| method.name != CERTIFIED).filter(has_runs).collect()
}

fn rows(runs: &[Run]) -> Vec<Row<'_>> {
    let list = factors(runs);
    let row = |scene| {
        let of = |method: &str| list.iter().find(|factor| factor.scene == scene && factor.method == method).cloned();
        let rivals: Vec<_> = rivals(runs).iter().map(|method| of(method.name)).collect();
        let seconds = rivals.iter().flatten().find_map(|factor| factor.certified_seconds);
        Row { scene, seconds, rivals }
    };
    scenes(runs).into_iter().map(row).collect()
}

/// The table with what it means, and what a rival does better.
pub(super) fn section(runs: &[Run]) -> Result<Markup, ReportError> {
    let [own, other] = [CERTIFIED_ERROR, RIVAL_ERROR].map(error);
    Ok(html! {
        p {
            "The time in which the certified search finds all wanted roots of a scene to a relative " (own) " or better, and how many \
            times as long each rival takes to a relative " (other) ". Below 1, in colour, the rival wins; a dash stands where it does \
            not get there at any setting, nothing where it was not run. The certified search proves that no root is missing. Its \
            rivals prove nothing: they are given matrices assembled beforehand, and grids and dimensions chosen with the roots known."
        }
        div class="scroll" {
            table {
                thead { tr { th { "scene" } th { (CERTIFIED) } @for method in rivals(runs) { th { (method.name) } } } }
                tbody {
                    @for row in rows(runs) {
                        tr {
                            td { (row.scene) } td { (seconds(row.seconds)) }
                            @for rival in &row.rivals { td class=[wins(rival).then_some("wins")] { (times(rival)) } }
                        }
                    }
                }
            }
        }
        ul { @for sentence in sentences(runs) { li { (sentence) } } }
    })
}

/// The table as Markdown, and what a rival does better.
pub fn markdown(runs: &[Run]) -> String {
    let names = rivals(runs);
    let head = |text: String, method: &&Method| format!("{text} {} |", method.name);
    let mut text = names.iter().fold(format!("| scene | {CERTIFIED} |"), head);
    text += &format!("\n|---|---|{}\n", "---|".repeat(names.len()));
    for row in rows(runs) {
        let cells: Vec<String> = row.rivals.iter().map(times).collect();
        // writing to a string cannot fail
        let _ = writeln!(text, "| {} | {} | {} |", row.scene, seconds(row.seconds), cells.join(" | "));
    }
    for sentence in sentences(runs) {
        text += &format!("\n- {sentence}");
    }
    text + "\n"
}

/// One sentence for each win of a rival; one that says so if there is none.
fn sentences(runs: &[Run]) -> Vec<String> {
    let list = factors(runs);
    let wins: Vec<String> = list.iter().filter(|factor| factor.wins).map(win).collect();
    if wins.is_empty() { vec!["No rival is faster in any scene.".to_owned()] } else { wins }
}

fn win(factor: &Factor) -> String {
    let Factor { scene, method, seconds, certified_seconds, seconds_to_all_digits, .. } = factor;
    let [limit, all] = [RIVAL_ERROR, CERTIFIED_ERROR].map(error);
    let [own, rival] = [*certified_seconds, *seconds].map(self::seconds);
    let digits =
        seconds_to_all_digits.map_or(format!("{all} is not reached"), |seconds| format!("{} to {all}", time(seconds)));
    format!("{scene}: a win for {method}, {rival} to {limit} against {own} of the certified search ({digits}).")
}

fn wins(rival: &Option<Factor>) -> bool {
    rival.as_ref().is_some_and(|factor| factor.wins)
}

/// A factor with two digits; nothing where the rival was not run.
fn times(rival: &Option<Factor>) -> String {
    match rival.as_ref().map(|factor| factor.factor) {
        None => String::new(),
        Some(None) => "–".to_owned(),
        Some(Some(factor)) if factor < 1.0 => format!("× {factor:.2}"),
        Some(Some(factor)) if factor < 10.0 => format!("× {factor:.1}"),
        Some(Some(factor)) => format!("× {factor:.0}"),
    }
}

fn seconds(seconds: Option<f64>) -> String {
    seconds.map_or("–".to_owned(), time)
}
