//! Writes a drawing as SVG.

use crate::diagram::Diagram;
use crate::drawing::Drawing;
use crate::figure::label_of;
use crate::ink::{Ink, Pen};
use crate::kind::Kind;
use crate::labels::{Placed, Wanted, corners, placed};
use crate::outline::{Outline, number};
use crate::pose::Pose;
use crate::shape::Number;
use crate::supports::Standing;
use crate::vector::{Vector, between};
use std::f64::consts::TAU;
use std::fmt;
use svg::Node;
use svg::node::Text;
use svg::node::element::Element;

/// White around everything.
const MARGIN: f64 = 14.0;

/// Radius of a point that has a name.
const POINT: f64 = 2.9;

/// Moments of a motion whose parts are out of phase, between which it is drawn straight.
const MOMENTS: u32 = 16;

/// Duration of a vibration on the screen.
const PERIOD: &str = "2.4s";

/// A picture while it grows: its groups, one upon the other, and all that they hold.
#[derive(Default)]
struct Picture {
    groups: Vec<Element>,
    inks: Vec<Ink>,
    /// What is drawn at other moments than the first: it is in the picture, and may pass over labels.
    later: Vec<Ink>,
}

/// The drawing as SVG, of which a page can take the element as it is.
impl<M> fmt::Display for Drawing<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", picture(self))
    }
}

/// The whole picture.
fn picture<M>(drawing: &Drawing<M>) -> Element {
    let mut picture = Picture::default();
    let diagrams = drawing.force.as_ref().map_or(&[][..], |(_, diagrams, _)| diagrams);
    picture.add_diagrams(drawing, diagrams);
    picture.add_model(drawing);
    picture.add_supports(drawing);
    picture.add_mode(drawing);
    let labels = placed(wanted(drawing, diagrams), &picture.inks);
    picture.groups.push(group_of_labels(&labels));
    let (low, high) = bounds(picture.inks.iter().chain(&picture.later), &labels);
    let [width, height] = [0, 1].map(|axis| (high[axis] - low[axis]).ceil());
    let mut svg = element("svg", "mstmm");
    svg.assign("xmlns", "http://www.w3.org/2000/svg");
    svg.assign("viewBox", format!("{} {} {width} {height}", number(low[0]), number(low[1])));
    svg.assign("width", width);
    svg.assign("height", height);
    svg.assign("role", "img");
    svg.assign("aria-label", if drawing.motion.is_some() { "a model in motion" } else { "a model" });
    svg.assign("data-scale", drawing.figure.scale);
    svg.assign("data-origin", pair(drawing.figure.origin));
    if let Some((_, reach)) = &drawing.motion {
        svg.assign("data-reach", reach.norm());
        svg.assign("data-phase", reach.arg());
    }
    if let Some((force, _, scale)) = &drawing.force {
        svg.assign("data-force", force.name());
        svg.assign("data-force-scale", *scale);
    }
    let mut style = Element::new("style");
    style.append(Text::new(include_str!("style.css")));
    svg.append(style);
    picture.groups.into_iter().for_each(|group| svg.append(group));
    svg
}

/// An element of a class.
fn element(name: &str, class: &str) -> Element {
    let mut element = Element::new(name);
    element.assign("class", class);
    element
}

/// A path.
fn path(class: &str, outline: &Outline) -> Element {
    let mut path = element("path", class);
    path.assign("d", outline.data());
    path
}

/// A part of the model with its name.
fn group(name: &str, word: &str) -> Element {
    let mut group = Element::new("g");
    group.assign("data-kind", word);
    group.assign("data-name", name);
    group
}

impl Picture {
    fn add_diagrams<M>(&mut self, drawing: &Drawing<M>, diagrams: &[Diagram]) {
        let mut all = element("g", "force");
        for diagram in diagrams {
            let part = &drawing.figure.parts[diagram.part];
            let mut group = group(&part.name, part.word);
            let area = Outline::Area(diagram.area.clone());
            let across = Outline::Lines(diagram.lines.clone());
            group.append(path("diagram", &area));
            group.append(path("across", &across));
            self.inks.extend([area, across].map(|outline| Ink::new(Pen::Hatch, outline)));
            all.append(group);
        }
        if !diagrams.is_empty() {
            self.groups.push(all);
        }
    }

    fn add_supports<M>(&mut self, drawing: &Drawing<M>) {
        let mut all = element("g", "supports");
        for support in &drawing.figure.supports {
            let standing = Standing::of(&drawing.figure, support.anchor, support.holds);
            let mut group = group(&support.name, support.holds.symbol());
            group.assign("data-at", pair(standing.at));
            group.assign("data-ground", pair(standing.ground));
            self.draw(&mut group, standing.inks(support.holds));
            all.append(group);
        }
        self.groups.push(all);
    }

    /// The model at rest, pale below a motion.
    fn add_model<M>(&mut self, drawing: &Drawing<M>) {
        let rest = Pose::at_rest(&drawing.figure);
        let mut all = element("g", if drawing.motion.is_some() { "model rest" } else { "model" });
        let (below, above): (Vec<usize>, Vec<usize>) =
            order(drawing).into_iter().partition(|index| rank(drawing.figure.parts[*index].kind) < 2);
        let mut draw = |index: usize| {
            let part = &drawing.figure.parts[index];
            let mut group = group(&part.name, part.word);
            self.draw(&mut group, rest.inks(&drawing.figure, index));
            group
        };
        below.into_iter().for_each(|index| all.append(draw(index)));
        for anchor in &drawing.figure.anchors {
            if let Some(name) = &anchor.name {
                let mut group = group(name, "point");
                group.assign("data-at", pair(anchor.at));
                group.append(path(Pen::Dot.class(), &Outline::Disc(anchor.at, POINT)));
                all.append(group);
            }
        }
        above.into_iter().for_each(|index| all.append(draw(index)));
        self.groups.push(all);
    }

    /// The model in its motion: still, and moving where the reader has nothing against it.
    fn add_mode<M>(&mut self, drawing: &Drawing<M>) {
        let Some((motion, reach)) = &drawing.motion else { return };
        let by = |angle: f64| reach * Number::from_polar(1.0, angle);
        let angles: Vec<f64> = if motion.is_complex() {
            (0..=MOMENTS).map(|moment| TAU * f64::from(moment) / f64::from(MOMENTS)).collect()
        } else {
            vec![0.0, 0.5 * TAU, TAU]
        };
        let poses: Vec<Pose> = angles.iter().map(|angle| Pose::moved(&drawing.figure, motion, by(*angle))).collect();
        let (mut still, mut moving) = (element("g", "mode still"), element("g", "mode moving"));
        for index in order(drawing) {
            let part = &drawing.figure.parts[index];
            let moments: Vec<Vec<Ink>> = poses.iter().map(|pose| pose.inks(&drawing.figure, index)).collect();
            let [mut quiet, mut lively] = [group(&part.name, part.word), group(&part.name, part.word)];
            for (number, ink) in moments[0].iter().enumerate() {
                let mut path = path(ink.pen.class(), &ink.outline);
                quiet.append(path.clone());
                path.append(animation(
                    moments.iter().map(|inks| inks[number].outline.data()).collect(),
                    motion.is_complex(),
                ));
                lively.append(path);
            }
            let mut moments = moments.into_iter();
            self.inks.extend(moments.next().into_iter().flatten());
            self.later.extend(moments.flatten());
            still.append(quiet);
            moving.append(lively);
        }
        self.groups.extend([still, moving]);
    }

    /// Draws in a group.
    fn draw(&mut self, group: &mut Element, inks: Vec<Ink>) {
        for ink in inks {
            group.append(path(ink.pen.class(), &ink.outline));
            self.inks.push(ink);
        }
    }
}

/// The parts, those behind others first: lines, bodies, then what stands on both.
fn order<M>(drawing: &Drawing<M>) -> Vec<usize> {
    let parts = &drawing.figure.parts;
    let mut order: Vec<usize> = (0..parts.len()).collect();
    order.sort_by_key(|index| rank(parts[*index].kind));
    order
}

/// How far above others a part is.
fn rank(kind: Kind) -> u8 {
    match kind {
        Kind::Body => 1,
        kind if kind.is_at_a_point() && kind != Kind::Tie => 2,
        _ => 0,
    }
}

/// The motion of a path through its data at moments of a period.
fn animation(moments: Vec<String>, is_complex: bool) -> Element {
    let mut animate = Element::new("animate");
    animate.assign("attributeName", "d");
    animate.assign("dur", PERIOD);
    animate.assign("repeatCount", "indefinite");
    animate.assign("values", moments.join(";"));
    if !is_complex {
        // a cosine
        animate.assign("calcMode", "spline");
        animate.assign("keyTimes", "0;0.5;1");
        animate.assign("keySplines", "0.364 0 0.636 1;0.364 0 0.636 1");
    }
    animate
}

/// A place or a direction as an attribute.
fn pair(vector: Vector) -> String {
    format!("{} {}", vector[0] + 0.0, vector[1] + 0.0)
}

/// The labels of points, parts and largest values, each once.
fn wanted<M>(drawing: &Drawing<M>, diagrams: &[Diagram]) -> Vec<Wanted> {
    let figure = &drawing.figure;
    let mut wanted: Vec<Wanted> = Vec::new();
    let mut add = |name: &str, class, at| {
        if let Some(text) = label_of(name).filter(|_| !name.starts_with("link of") && !name.starts_with("ground of")) {
            let label = Wanted { text: text.to_owned(), class, title: name.to_owned(), at };
            let is_new = wanted.iter().all(|known| known.title != label.title);
            wanted.extend(Some(label).filter(|_| is_new));
        }
    };
    for anchor in &figure.anchors {
        add(anchor.name.as_deref().unwrap_or_default(), "point", anchor.at);
    }
    for part in figure.parts.iter().filter(|part| part.kind != Kind::Tie) {
        let [from, to] = [part.ends[0], part.ends[part.ends.len() - 1]].map(|end| figure.anchors[end].at);
        let is_joint = matches!(part.kind, Kind::Pin | Kind::Slider(_) | Kind::ElasticHinge) && from == to;
        add(
            &part.name,
            if is_joint { "joint" } else { "element" },
            if part.kind == Kind::Body { to } else { between(from, to, 0.5) },
        );
    }
    wanted.extend(diagrams.iter().filter_map(|diagram| diagram.label.clone()));
    wanted
}

fn group_of_labels(labels: &[Placed]) -> Element {
    let mut all = element("g", "labels");
    for label in labels {
        let mut text = element("text", label.wanted.class);
        text.assign("x", number(label.middle[0]));
        text.assign("y", number(label.middle[1]));
        let mut title = Element::new("title");
        title.append(Text::new(label.wanted.title.clone()));
        text.append(Text::new(label.wanted.text.clone()));
        text.append(title);
        all.append(text);
    }
    all
}

/// The corners of the picture.
fn bounds<'a>(inks: impl Iterator<Item = &'a Ink>, labels: &[Placed]) -> (Vector, Vector) {
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
