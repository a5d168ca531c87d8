//! Writes a drawing as SVG.

use crate::arrows::shown;
use crate::captions::{below, title};
use crate::diagram::Diagram;
use crate::drawing::Drawing;
use crate::ink::{Ink, Pen};
use crate::kind::Kind;
use crate::labels::{Wanted, placed};
use crate::motion::Motion;
use crate::orbits::orbits;
use crate::outline::{Outline, number};
use crate::picture::{Picture, bounds, element, group, group_of_labels, of_motion, pair, path};
use crate::pose::Pose;
use crate::shape::Number;
use crate::supports::Standing;
use crate::triad::triad;
use crate::vector::Vector;
use crate::wanted::wanted;
use mstmm_core::Whirl;
use std::fmt;
use svg::Node;
use svg::node::Text;
use svg::node::element::Element;

/// Radius of a point that has a name.
pub(crate) const POINT: f64 = 2.9;

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
    if let Some(scene) = &drawing.figure.scene {
        picture.add_in_space(drawing, scene);
    } else {
        picture.add_model(drawing);
        picture.add_supports(drawing);
        picture.add_mode(drawing);
    }
    let loads = picture.add_loads(drawing);
    let labels = placed(wanted(drawing, diagrams, loads), &picture.inks);
    picture.groups.push(group_of_labels(&labels));
    let (mut low, mut high) = bounds(picture.inks.iter().chain(&picture.later), &labels);
    if drawing.figure.scene.is_some() {
        picture.groups.push(triad(&drawing.figure.sight, (&mut low, &mut high), (&picture, &labels)));
    }
    picture.add_captions(drawing, (&mut low, &mut high));
    let [width, height] = [0, 1].map(|axis| (high[axis] - low[axis]).ceil());
    let mut svg = element("svg", "mstmm");
    svg.assign("xmlns", "http://www.w3.org/2000/svg");
    svg.assign("viewBox", format!("{} {} {width} {height}", number(low[0]), number(low[1])));
    svg.assign("width", width);
    svg.assign("height", height);
    svg.assign("role", "img");
    let about = if drawing.motion.is_some() { "a model in motion" } else { "a model" };
    svg.assign("aria-label", drawing.title.as_deref().unwrap_or(about));
    svg.assign("data-scale", drawing.figure.scale);
    svg.assign("data-origin", pair(drawing.figure.origin));
    if let Some(scene) = &drawing.figure.scene {
        svg.assign("data-view", pair(scene.view.angles()));
    }
    if let Some((_, reach)) = &drawing.motion {
        svg.assign("data-reach", of_motion(reach.norm()));
        svg.assign("data-phase", of_motion(reach.arg()));
    }
    if let Some((force, _, scale)) = &drawing.force {
        svg.assign("data-force", force.name());
        svg.assign("data-force-scale", of_motion(*scale));
        svg.assign("data-force-unit", drawing.units.of(*force));
    }
    let mut style = Element::new("style");
    style.append(Text::new(include_str!("style.css")));
    if drawing.figure.scene.is_some() {
        style.append(Text::new(include_str!("style_in_space.css")));
    }
    svg.append(style);
    picture.groups.into_iter().for_each(|group| svg.append(group));
    svg
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

    /// The arrows of loads; their labels.
    fn add_loads<M>(&mut self, drawing: &Drawing<M>) -> Vec<Wanted> {
        let mut labels = Vec::new();
        let mut all = element("g", "loads");
        for load in shown(&drawing.figure, &drawing.loads, &drawing.units) {
            let mut group = element("g", "load");
            if let Some(label) = &load.label {
                group.assign("data-name", label.title.clone());
            }
            self.draw(&mut group, load.inks);
            all.append(group);
            labels.extend(load.label);
        }
        if !drawing.loads.is_empty() {
            self.groups.push(all);
        }
        labels
    }

    /// A title above the picture, and the unit of a diagram below it.
    fn add_captions<M>(&mut self, drawing: &Drawing<M>, (low, high): (&mut Vector, &mut Vector)) {
        if let Some(text) = &drawing.title {
            self.groups.push(title(text, (low, high)));
        }
        if let Some((force, ..)) = drawing.force {
            let free = if drawing.is_of_mode { ", of a mode, whose size is free" } else { "" };
            self.groups.push(below(&format!("{} [{}]{free}", force.name(), drawing.units.of(force)), (low, high)));
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
        let draw = |picture: &mut Picture, index: usize| {
            let part = &drawing.figure.parts[index];
            let mut group = group(&part.name, part.word);
            picture.draw(&mut group, rest.inks(&drawing.figure, index));
            group
        };
        below.into_iter().for_each(|index| all.append(draw(self, index)));
        for anchor in &drawing.figure.anchors {
            if let Some(name) = &anchor.name {
                let mut group = group(name, "point");
                group.assign("data-at", pair(anchor.at));
                self.draw(&mut group, vec![Ink::new(Pen::Dot, Outline::Disc(anchor.at, POINT))]);
                all.append(group);
            }
        }
        above.into_iter().for_each(|index| all.append(draw(self, index)));
        self.groups.push(all);
    }

    /// The model in its motion: still, and moving where the reader has nothing against it.
    fn add_mode<M>(&mut self, drawing: &Drawing<M>) {
        let Some((motion, reach)) = &drawing.motion else { return };
        if let Some(whirl) = drawing.whirl {
            return self.add_orbits(drawing, motion, *reach, whirl);
        }
        let poses = Pose::moments(&drawing.figure, motion, *reach);
        let (mut still, mut moving) = (element("g", "mode still"), element("g", "mode moving"));
        for index in order(drawing) {
            let part = &drawing.figure.parts[index];
            let moments = poses.iter().map(|pose| pose.inks(&drawing.figure, index)).collect();
            let [quiet, lively] = self.moving([&part.name, part.word], moments);
            still.append(quiet);
            moving.append(lively);
        }
        self.groups.extend([still, moving]);
    }

    /// The shape of a rotor, and the orbits on which its points go round.
    fn add_orbits<M>(&mut self, drawing: &Drawing<M>, motion: &Motion, reach: Number, whirl: Whirl) {
        let pose = Pose::moved(&drawing.figure, motion, reach);
        let mut all = element("g", "mode");
        for index in order(drawing) {
            let part = &drawing.figure.parts[index];
            let mut group = group(&part.name, part.word);
            self.draw(&mut group, pose.inks(&drawing.figure, index));
            all.append(group);
        }
        let mut circles = element("g", "orbits");
        self.draw(&mut circles, orbits(&drawing.figure, motion, reach, whirl));
        all.append(circles);
        self.groups.push(all);
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
pub(crate) fn rank(kind: Kind) -> u8 {
    match kind {
        kind if kind.is_body() => 1,
        kind if kind.is_at_a_point() && kind != Kind::Tie => 2,
        _ => 0,
    }
}
