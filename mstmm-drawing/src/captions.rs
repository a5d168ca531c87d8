//! What is written above and below a picture.

use crate::labels::width_of;
use crate::picture::{self, MARGIN, element};
use crate::vector::Vector;
use svg::Node;
use svg::node::element::Element;

/// Sizes of the letters of a title and of what is below a picture, as the style sheet has them.
const TITLE: f64 = 15.0;
const BELOW: f64 = 13.0;

/// A text without what XML has no letters for: line breaks and other control characters are blanks.
pub(crate) fn in_one_line(text: &str) -> String {
    let is_blank =
        |letter: char| letter.is_control() || matches!(letter, '\u{2028}' | '\u{2029}' | '\u{fffe}' | '\u{ffff}');
    text.chars().map(|letter| if is_blank(letter) { ' ' } else { letter }).collect()
}

/// A title above the middle of a picture, which becomes as high and as wide as that needs.
pub(crate) fn title(text: &str, (low, high): (&mut Vector, &mut Vector)) -> Element {
    let middle = make_room(width_of(text, TITLE), (low, high));
    low[1] -= TITLE + 0.5 * MARGIN;
    written("title", text, [middle, low[1] + MARGIN + 0.5 * TITLE])
}

/// A text below the middle of a picture, which becomes as high and as wide as that needs.
pub(crate) fn below(text: &str, (low, high): (&mut Vector, &mut Vector)) -> Element {
    let middle = make_room(width_of(text, BELOW), (low, high));
    high[1] += BELOW + 0.5 * MARGIN;
    written("unit", text, [middle, high[1] - MARGIN - 0.5 * BELOW])
}

/// Makes a picture as wide as a text needs, and tells its middle.
fn make_room(width: f64, (low, high): (&mut Vector, &mut Vector)) -> f64 {
    let middle = 0.5 * (low[0] + high[0]);
    let half = 0.5 * width + MARGIN;
    (low[0], high[0]) = (low[0].min(middle - half), high[0].max(middle + half));
    middle
}

fn written(class: &str, text: &str, at: Vector) -> Element {
    let mut all = element("g", "captions");
    all.append(picture::text(class, at, text));
    all
}
