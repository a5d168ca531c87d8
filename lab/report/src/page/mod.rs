//! The page.

mod figures;
mod summary;
mod tables;
mod text;

use crate::error::ReportError;
use crate::measurements::Measurements;
use crate::palette::dark_rules;
use maud::{DOCTYPE, Markup, PreEscaped, html};

pub use summary::markdown;

const STYLE: &str = include_str!("style.css");

/// The page as one HTML document, without scripts and without anything that would have to be loaded.
///
/// # Errors
/// [`ReportError`] where a picture cannot be drawn.
pub fn page(measurements: &Measurements) -> Result<String, ReportError> {
    let Measurements { runs, tables, landscapes, shapes, .. } = measurements;
    let dark = format!("@media (prefers-color-scheme: dark) {{ {} }}", dark_rules());
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { "mstmm: error against run time" }
                style { (PreEscaped(STYLE)) (PreEscaped(dark)) }
            }
            body {
                header {
                    h1 { "mstmm: error against run time" }
                    p {
                        "Vibrations by the transfer matrix method, and by other ways to the same roots. All times are of one run on \
                        one machine; quote the ratios."
                    }
                }
                main {
                    (section("summary", "How much faster", summary::section(runs)?))
                    (section("paper", "The tables of the paper", tables::section(tables)))
                    (section("error-time", "Error against run time", figures::error_time(runs)?))
                    (section("landscapes", "|Δ| and its roots", figures::landscapes(landscapes)?))
                    (section("shapes", "Mode shapes", figures::shapes(shapes)?))
                    (section("digits", "Digits kept", figures::digits(measurements)?))
                    (section("growth", "Cost against size", figures::growth(measurements)?))
                }
            }
        }
    };
    Ok(page.into_string())
}

fn section(id: &str, title: &str, content: Markup) -> Markup {
    html! { section id=(id) { h2 { (title) } (content) } }
}
