//! The page.

mod drawings;
mod figures;
mod frames;
mod proof;
mod summary;
mod tables;
mod text;

use crate::error::ReportError;
use crate::measurements::Measurements;
use crate::palette::dark_rules;
use maud::{DOCTYPE, PreEscaped, html};

pub use summary::markdown;

const STYLE: &str = include_str!("style.css");

/// The page as one HTML document, without scripts and without anything that would have to be loaded.
///
/// # Errors
/// [`ReportError`] where a picture cannot be drawn.
pub fn page(measurements: &Measurements) -> Result<String, ReportError> {
    let Measurements { runs, tables, counts, landscapes, systems, shapes, frames, storeys, portal, .. } = measurements;
    let dark = format!("@media (prefers-color-scheme: dark) {{ {} }}", dark_rules());
    let sections = [
        ("frames", "A portal frame beside finite elements", frames::section(frames, storeys, portal)?),
        ("systems", "What is solved", drawings::systems(systems)),
        ("proof", "A list with its proof", proof::section(counts)?),
        ("summary", "How much faster", summary::section(runs)?),
        ("error-time", "Error against run time", figures::error_time(runs)?),
        ("landscapes", "|Δ| and its roots", figures::landscapes(landscapes)?),
        ("shapes", "Mode shapes", drawings::shapes(shapes)),
        ("digits", "Digits kept", figures::digits(measurements)?),
        ("growth", "Cost against size", figures::growth(measurements)?),
        ("paper", "The tables of the paper", tables::section(tables, systems)),
    ];
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { "mstmm: error against run time" }
                style { (PreEscaped(drawings::style(systems))) (PreEscaped(STYLE)) (PreEscaped(dark)) }
            }
            body {
                header {
                    h1 { "mstmm: error against run time" }
                    p {
                        "Vibrations by the transfer matrix method, and by other ways to the same roots. All times are of one run on \
                        one machine; quote the ratios."
                    }
                    nav { @for (id, title, _) in &sections { a href={ "#" (id) } { (title) } " " } }
                }
                main { @for (id, title, content) in &sections { section id=(id) { h2 { (title) } (content) } } }
            }
        }
    };
    Ok(page.into_string())
}
