//! The portal by this library and by programs of finite elements.

use super::drawings::modes;
use super::figures::{figure, panels};
use super::tables::beside;
use super::text::{error, time};
use crate::data::frames::Frames;
use crate::data::shapes::Shapes;
use crate::error::ReportError;
use crate::growth::{OverElements, leap};
use crate::plots;
use frames_beside::Program;
use maud::{Markup, html};

/// Pictures, and a table of all runs.
pub(super) fn section(frames: &Frames, storeys: &OverElements, portal: &Shapes) -> Result<Markup, ReportError> {
    let figures = &frames.figures;
    let lead = html! {
        p {
            "A portal of steel tube, 4 m high and 6 m wide, on clamped feet; wanted are its first ten frequencies. Members are exact \
            here, and the list is certified; in programs of finite elements they are meshed, each with 4 to 128 elements."
        }
        p {
            "Errors are relative to values by exact stiffnesses in forty digits. Elements converge with the square of their length: the \
            tenth mode stretches the members, and rods of elements are linear. A time is the least of some rounds, of one process after \
            its imports. The command " code { "cargo run --release -p frames_beside" } " measures it alone."
        }
        @if let Some(storeys) = leap(&storeys.search) {
            p {
                "In buildings of " (storeys) " storeys and more rounding raises a doubt, and the search is made again in 32 digits: hence \
                the leap."
            }
        }
        p class="quiet" { (origin(frames)) }
    };
    let growth = plots::growth::over_storeys(storeys)?;
    let growth = figure("Buildings of many storeys", "of one bay, first ten frequencies", &growth);
    let plot = plots::frames::svg(figures)?;
    let pictures = [modes(portal), figure("Error against run time", "ten frequencies of the portal", &plot)];
    let own = figures.programs.first().and_then(|program| program.runs.first()).map(|run| run.seconds);
    let table = html! {
        table class="plain" {
            thead {
                tr { th { "program" } th { "elements per member" } th { "time" } th { "times as long" } th { "largest error" } }
            }
            tbody { @for program in &figures.programs { (rows(program, own)) } }
        }
    };
    Ok(html! { (panels(lead, pictures)) (beside(growth, table)) })
}

/// When and where the figures were taken.
fn origin(Frames { figures, missing }: &Frames) -> String {
    let versions = figures.programs.iter().map(|program| format!("{} {}", program.program, program.version));
    let versions = versions.collect::<Vec<_>>().join(", ");
    if missing.is_empty() {
        format!("Measured with the rest of this page: {versions}.")
    } else {
        format!("Not measured with the rest of this page, where programs are missing. {} {versions}.", figures.origin())
    }
}

/// The runs of a program.
fn rows(program: &Program, own: Option<f64>) -> Markup {
    html! {
        @for run in &program.runs {
            tr {
                td { (program.program) }
                td { (run.elements) }
                td { (time(run.seconds)) }
                td { @if let Some(own) = own { (format!("{:.0}", run.seconds / own)) } }
                td { (error(run.error())) }
            }
        }
    }
}
