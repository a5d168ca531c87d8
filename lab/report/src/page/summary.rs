//! How much faster the certified search is, as a table and in words.

use super::tables::{beside, scrolling};
use super::text::{error, time};
use crate::error::ReportError;
use crate::method::{METHODS, Method};
use crate::plots::error_time::scenes;
use maud::{Markup, html};
use rivals::factors::{CERTIFIED_ERROR, Factor, RIVAL_ERROR, factors};
use rivals::runs::CERTIFIED;
use rivals::{ROUNDS, Run};
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
    let lead = html! {
        p {
            "The time in which the certified search finds all wanted roots of a scene to a relative " (own) " or better, and how many \
            times as long each rival takes to a relative " (other) ": the median of " (ROUNDS) " rounds, and under it the least and the \
            largest. Below 1, in colour, the rival wins; a dash stands where it does not get there at any setting, nothing where it was \
            not run. The certified search proves that no root is missing. Its \
            rivals prove nothing: they are given matrices assembled beforehand, and grids and dimensions chosen with the roots known."
        }
        ul { @for sentence in sentences(runs) { li { (sentence) } } }
    };
    let table = scrolling(html! {
        thead { tr { th { "scene" } th { (CERTIFIED) } @for method in rivals(runs) { th { (method.name) } } } }
        tbody { @for row in rows(runs) { (table_row(&row)) } }
    });
    Ok(beside(lead, table))
}

fn table_row(row: &Row<'_>) -> Markup {
    html! {
        tr {
            td { (row.scene) }
            td { (seconds(row.seconds)) }
            @for rival in &row.rivals {
                td class=[wins(rival).then_some("wins")] {
                    (times(rival))
                    @if let Some(spread) = spread(rival) { br; small { (spread) } }
                }
            }
        }
    }
}

/// The table as Markdown, and what a rival does better.
pub fn markdown(runs: &[Run]) -> String {
    let names = rivals(runs);
    let head = |text: String, method: &&Method| format!("{text} {} |", method.name);
    let mut text = names.iter().fold(format!("| scene | {CERTIFIED} |"), head);
    text += &format!("\n|---|---|{}\n", "---|".repeat(names.len()));
    for row in rows(runs) {
        let cell = |rival| spread(rival).map_or(times(rival), |spread| format!("{} ({spread})", times(rival)));
        let cells: Vec<String> = row.rivals.iter().map(cell).collect();
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

/// A factor; nothing where the rival was not run.
fn times(rival: &Option<Factor>) -> String {
    match rival.as_ref().map(|factor| factor.factor) {
        None => String::new(),
        Some(None) => "–".to_owned(),
        Some(Some(factor)) => format!("× {}", two_digits(factor)),
    }
}

/// The least and the largest factor of a round, where they differ.
fn spread(rival: &Option<Factor>) -> Option<String> {
    let [least, most] = rival.as_ref()?.spread?.map(two_digits);
    (least != most).then(|| format!("{least}–{most}"))
}

/// A ratio with two digits, whole from 10 on.
fn two_digits(ratio: f64) -> String {
    let decimals = if ratio < 1.0 { 2 } else { usize::from(ratio < 10.0) };
    format!("{ratio:.decimals$}")
}

fn seconds(seconds: Option<f64>) -> String {
    seconds.map_or("–".to_owned(), time)
}
