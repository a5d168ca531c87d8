//! The sections that are made of pictures.

use crate::data::landscapes::Landscapes;
use crate::error::ReportError;
use crate::growth::{exponent, leap};
use crate::measurements::Measurements;
use crate::method::{METHODS, named};
use crate::plots;
use crate::scene::note;
use maud::{Markup, PreEscaped, html};
use rivals::Run;

/// A drawing with its caption.
pub(super) fn figure(title: &str, note: &str, svg: &str) -> Markup {
    html! {
        figure {
            figcaption { (title) @if !note.is_empty() { " " span { (note) } } }
            div role="img" aria-label=(format!("{title} {note}")) { (PreEscaped(svg)) }
        }
    }
}

/// What is said first, and panels beside and below it, as many in a row as there is room for.
pub(super) fn panels(lead: Markup, panels: impl IntoIterator<Item = Markup>) -> Markup {
    html! { div class="panels" { div class="lead" { (lead) } @for panel in panels { (panel) } } }
}

/// Error against time, a panel for each scene.
pub(super) fn error_time(runs: &[Run]) -> Result<Markup, ReportError> {
    for run in runs {
        named(&run.method)?;
    }
    let scenes = plots::error_time::scenes(runs);
    let panels = scenes.iter().map(|scene| Ok((scene, plots::error_time::svg(runs, scene)?)));
    let panels = panels.collect::<Result<Vec<_>, ReportError>>()?;
    let used = METHODS.iter().filter(|method| runs.iter().any(|run| run.method == method.name));
    let legend = used.map(|method| Ok((method.name, method.look.sample()?)));
    let legend = legend.collect::<Result<Vec<_>, ReportError>>()?;
    let lead = html! {
        p {
            "Each point is a method at one setting: the median time of all wanted roots, and the largest relative error among them. \
            Left and low is better. Hollow markers at the top are runs that lose a root."
        }
        ul class="legend" { @for (name, sample) in &legend { li { (PreEscaped(sample)) (name) } } }
    };
    Ok(self::panels(lead, panels.iter().map(|(scene, svg)| figure(scene, note(scene), svg))))
}

/// The same in columns, for panels of different heights.
pub(super) fn columns(lead: Markup, panels: impl IntoIterator<Item = Markup>) -> Markup {
    html! { div class="columns" { div class="lead" { (lead) } @for panel in panels { (panel) } } }
}

/// |Δ| over ω and over λ.
pub(super) fn landscapes(landscapes: &Landscapes) -> Result<Markup, ReportError> {
    let lines = landscapes.undamped.iter().map(|own| Ok((&own.id, plots::landscape::svg(own)?)));
    let maps = landscapes.damped.iter().map(|own| Ok((&own.id, plots::heat_map::svg(own)?)));
    let panels = lines.chain(maps).collect::<Result<Vec<_>, ReportError>>()?;
    let lead = html! {
        p {
            "Δ by planes, the determinant of the overall matrix but for a constant, in the ranges of the paper's searches, as in its \
            Figures 5 and 10. Marked are the roots that the certified search lists."
        }
        p {
            "|Δ| grows by many decades with the waves of the beams. Here it is divided by its trend, " code { "c |λ|ᵃ exp(b √λ)" }
            " fitted to it, which has no root: what is left is about 1 between the roots, and a pit at each. A pit has no bottom; all \
            are cut at the same depth."
        }
        p { "The map of the damped example has equal scales, so that pits are round. The thin frame is the paper's search." }
    };
    Ok(columns(lead, panels.iter().map(|(id, svg)| figure(id, note(id), svg))))
}

/// Digits kept.
pub(super) fn digits(measurements: &Measurements) -> Result<Markup, ReportError> {
    let modes = plots::digits::over_modes(&measurements.digits_of_modes)?;
    let stiffness = plots::digits::over_stiffness(&measurements.digits_of_stiffness)?;
    let lead = html! {
        p {
            "Correct digits of a root, sixteen being all that a double has: by a bisection on the sign of "
            code { "overall_determinant" } ", inside a bracket that holds no other root, and by the certified search, which carries \
            planes. Hollow markers are brackets in which the signs of the determinant show no root, or more than the one that is there."
        }
        p {
            "The determinant loses " code { "exp(βl)" } ": ten modes of a beam, and it is noise. A large ratio of stiffnesses is no \
            difficulty by itself, as the tip spring of a cantilever shows from 10⁻¹⁵ to 10¹⁵. It is one where a soft span takes part in \
            modes of a stiff one: βl of the soft span grows with the fourth root of the ratio."
        }
    };
    let figures = [
        figure("Mode number", "fixed-pinned beam", &modes),
        figure("Stiffness ratio", "soft and stiff span; cantilever with tip spring", &stiffness),
    ];
    Ok(panels(lead, figures))
}

/// Cost against size.
pub(super) fn growth(measurements: &Measurements) -> Result<Markup, ReportError> {
    let Measurements { elements, roots, .. } = measurements;
    let power = |points| format!("{:.2}", exponent(points));
    let pictures = [plots::growth::over_elements(elements)?, plots::growth::over_roots(roots)?];
    let lead = html! {
        p {
            "Exponents are fitted to the larger half of the sizes. The time of an evaluation grows with the number of beams to the power "
            (power(&elements.evaluation)) ", that of the certified search for the lowest frequency to the power "
            (power(&elements.search)) ". Of the first n roots of a pinned beam, the time of each grows with n to the power "
            (power(&roots.pinned)) "; that of mode n alone to the power " (power(&roots.alone)) ". "
            @if let Some(mode) = leap(&roots.cantilever) {
                "Among the first " (mode) " roots of the cantilever rounding raises a doubt, and the search is made again in 32 \
                digits: hence the leap."
            }
        }
    };
    let figures = [
        figure("Number of elements", "chain, pinned at every joint", &pictures[0]),
        figure("Mode number", "certified search of one beam", &pictures[1]),
    ];
    Ok(panels(lead, figures))
}
