//! A picture while it grows, and the elements of which it is made.

use crate::ink::Ink;
use crate::labels::{Placed, corners};
use crate::outline::{Outline, number};
use crate::vector::Vector;
use svg::Node;
use svg::node::Text;
use svg::node::element::Element;

/// White around everything.
pub(crate) const MARGIN: f64 = 14.0;

/// Duration of a vibration on the screen.
const PERIOD: &str = "2.4s";

/// A picture while it grows: its groups, one upon the other, and all that they hold.
#[derive(Default)]
pub(crate) struct Picture {
    pub(crate) groups: Vec<Element>,
    pub(crate) inks: Vec<Ink>,
    /// What is drawn at other moments than the first: it is in the picture, and may pass over labels.
    pub(crate) later: Vec<Ink>,
}

impl Picture {
    /// Draws in a group.
    pub(crate) fn draw(&mut self, group: &mut Element, inks: Vec<Ink>) {
        for ink in inks {
            group.append(drawn(&ink));
            self.inks.extend(Some(ink).filter(|ink| !ink.pen.is_halo()));
        }
    }

    /// What is drawn of a part at moments of a period: the first one, and all of them as an animation.
    pub(crate) fn moving(&mut self, [name, word]: [&str; 2], moments: Vec<Vec<Ink>>) -> [Element; 2] {
        let [mut quiet, mut lively] = [group(name, word), group(name, word)];
        for (number, ink) in moments[0].iter().enumerate() {
            let mut path = drawn(ink);
            quiet.append(path.clone());
            path.append(animation(moments.iter().map(|inks| inks[number].outline.data()).collect()));
            lively.append(path);
        }
        let mut moments = moments.into_iter().map(|inks| inks.into_iter().filter(|ink| !ink.pen.is_halo()));
        self.inks.extend(moments.next().into_iter().flatten());
        self.later.extend(moments.flatten());
        [quiet, lively]
    }
}

/// An element of a class.
pub(crate) fn element(name: &str, class: &str) -> Element {
    let mut element = Element::new(name);
    element.assign("class", class);
    element
}

/// A text in the middle of a place, or before it.
pub(crate) fn text(class: &str, [x, y]: Vector, content: &str) -> Element {
    let mut text = element("text", class);
    text.assign("x", number(x));
    text.assign("y", number(y));
    text.append(Text::new(content));
    text
}

/// An element that says what it is under the pointer.
pub(crate) fn titled(mut element: Element, title: &str) -> Element {
    let mut own = Element::new("title");
    own.append(Text::new(title));
    element.append(own);
    element
}

/// A path.
pub(crate) fn path(class: &str, outline: &Outline) -> Element {
    let mut path = element("path", class);
    path.assign("d", outline.data());
    path
}

/// The path of a line or an area, with its width where it has one of its own.
fn drawn(ink: &Ink) -> Element {
    let mut path = path(ink.pen.class(), &ink.outline);
    if let Some(width) = ink.width {
        path.assign("style", format!("stroke-width:{}", number(width)));
    }
    path
}

/// A part of the model with its name.
pub(crate) fn group(name: &str, word: &str) -> Element {
    let mut group = Element::new("g");
    group.assign("data-kind", word);
    group.assign("data-name", name);
    group
}

/// The motion of a path through its data at moments of a period.
fn animation(moments: Vec<String>) -> Element {
    let mut animate = Element::new("animate");
    animate.assign("attributeName", "d");
    animate.assign("dur", PERIOD);
    animate.assign("repeatCount", "indefinite");
    animate.assign("values", moments.join(";"));
    if moments.len() == 3 {
        // a cosine from one end to the other and back
        animate.assign("calcMode", "spline");
        animate.assign("keyTimes", "0;0.5;1");
        animate.assign("keySplines", "0.364 0 0.636 1;0.364 0 0.636 1");
    }
    animate
}

/// A number of a motion as an attribute, without the digits that follow from the rounding of a root.
pub(crate) fn of_motion(value: f64) -> String {
    let rounded = format!("{value:.9e}");
    rounded.parse::<f64>().map_or(rounded, |value| (value + 0.0).to_string())
}

/// A place or a direction as an attribute.
pub(crate) fn pair(vector: Vector) -> String {
    format!("{} {}", vector[0] + 0.0, vector[1] + 0.0)
}

/// The labels of a picture.
pub(crate) fn group_of_labels(labels: &[Placed]) -> Element {
    let mut all = element("g", "labels");
    for label in labels {
        if let Some(ends) = label.leader {
            all.append(path("leader", &Outline::line(ends.into())));
        }
        let text = text(label.wanted.class, label.middle, &label.wanted.text);
        all.append(titled(text, &label.wanted.title));
    }
    all
}

/// The corners of the picture.
pub(crate) fn bounds<'a>(inks: impl Iterator<Item = &'a Ink>, labels: &[Placed]) -> (Vector, Vector) {
    let points = inks.flat_map(|ink| ink.outline.points());
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in points.chain(labels.iter().flat_map(corners)) {
        for axis in 0..2 {
            low[axis] = low[axis].min(point[axis] - MARGIN);
            high[axis] = high[axis].max(point[axis] + MARGIN);
        }
    }
    (low, high)
}
