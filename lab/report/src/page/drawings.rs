//! Drawings of systems and of their modes.

use super::figures::columns;
use crate::data::shapes::{Mode, Shapes, System};
use crate::scene::{SCENES, note};
use maud::{Markup, PreEscaped, html};

/// A drawing, and the style that all drawings bring along.
fn parted(svg: &str) -> (String, &str) {
    let style =
        svg.split_once("<style>").and_then(|(_, rest)| rest.split_once("</style>")).map_or("", |(style, _)| style);
    (svg.replacen(&format!("<style>{style}</style>\n"), "", 1), style)
}

/// The style of all drawings, of which the page has one copy.
pub(super) fn style(systems: &[System]) -> &str {
    systems.first().map_or("", |system| parted(&system.svg).1)
}

/// Every system with its drawing and a sentence.
pub(super) fn systems(systems: &[System]) -> Markup {
    html! {
        p {
            "Nine scenes, from the paper's examples to extremes. Beams are uniform and carry waves: each has infinitely many \
            frequencies, of which the first few are wanted."
        }
        div class="systems" {
            @for scene in SCENES {
                figure {
                    figcaption { (scene.id) " " span { (scene.note) } }
                    @if let Some(system) = systems.iter().find(|system| system.id == scene.id) { (drawing(scene.note, &system.svg)) }
                    p { (scene.sentence) }
                }
            }
        }
    }
}

/// A drawing without its style.
pub(super) fn drawing(label: &str, svg: &str) -> Markup {
    html! { div role="img" aria-label=(label) class="drawing" { (PreEscaped(parted(svg).0)) } }
}

/// The modes of all examples.
pub(super) fn shapes(shapes: &[Shapes]) -> Markup {
    let lead = html! {
        p {
            "The modes that the paper lists, exact at every point of a beam; the largest displacement of each has the same size. They \
            move where your settings allow animations."
        }
        p { "With damping, in 4.5, the points of a mode move in different phases." }
    };
    columns(lead, shapes.iter().map(modes))
}

/// The modes of an example, the first on top.
pub(super) fn modes(Shapes { id, modes }: &Shapes) -> Markup {
    html! {
        figure class="modes" {
            figcaption { (id) " " span { (note(id)) } }
            @for (number, Mode { name, svg }) in (1..).zip(modes) {
                div {
                    div class="quiet" { (number) ": " (name) }
                    (drawing(&format!("{id}, mode {number}"), svg))
                }
            }
        }
    }
}
