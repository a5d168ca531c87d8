//! A structure in space: its places, its symbols and what it moves with, whatever the view.

use crate::error::DrawingError;
use crate::figure::{Anchor, Figure, Holds, Inside, Moves, Part, Support, label_of};
use crate::kind::Kind;
use crate::loose::Loose;
use crate::projection::project;
use crate::scene::{Place, Scene};
use crate::solid::Solid;
use crate::spatial_kind::{grip, is_bar, kind_of, release};
use crate::symbols::beams::scale_beams;
use crate::vector3::{Vector3, direction3, length3, plus3, times};
use crate::view::{Sight, View};
use mstmm_core::{Drawn, DrawnBody, DrawnEnd, DrawnMember, Freedoms, Parameter, Real, Sketch, Skew};

/// Distance on the paper from a node of the symbol of what an end does not share with it.
const BESIDE: f64 = 9.0;

/// The figure of a sketch, in the isometric view.
pub(crate) fn figure<Y: Drawn>(sketch: &Sketch<'_, Y>) -> Result<Figure<Y::Model>, DrawingError> {
    let mut frame = Builder::of(sketch);
    if frame.scene.extent.is_empty() {
        return Err(DrawingError::Empty);
    }
    sketch.members().for_each(|member| frame.add_member(member));
    frame.add_bodies(sketch);
    frame.add_supports(sketch);
    let mut figure = frame.finished();
    scale_beams(&mut figure);
    project(&mut figure, View::isometric())?;
    Ok(figure)
}

/// A place in plain numbers.
fn plain<T: Parameter>(place: [T; 3]) -> Vector3 {
    place.map(Parameter::to_f64)
}

/// A figure while it grows.
struct Builder<M> {
    figure: Figure<M>,
    scene: Scene,
    /// The node of each point.
    nodes: Vec<usize>,
}

impl<M> Builder<M> {
    /// The points of a sketch.
    fn of<Y: Drawn<Model = M>>(sketch: &Sketch<'_, Y>) -> Self {
        let figure = Figure {
            anchors: Vec::new(),
            parts: Vec::new(),
            supports: Vec::new(),
            spots: Vec::new(),
            scale: 1.0,
            origin: [0.0; 2],
            sight: Sight::PLANE,
            scene: None,
        };
        let scene = Scene {
            view: View::isometric(),
            extent: Vec::new(),
            places: Vec::new(),
            depths: Vec::new(),
            loose: Vec::new(),
            ways: Vec::new(),
            directions: Vec::new(),
            axes: Vec::new(),
        };
        let mut frame = Builder { figure, scene, nodes: sketch.points().map(|point| point.node).collect() };
        for point in sketch.points() {
            let (name, metres) = (point.name.to_string(), plain(point.position));
            let shown = label_of(&name).is_some().then(|| name.clone());
            frame.scene.extent.push((name, metres));
            frame.add_anchor(Some(Place { metres, aside: [0.0; 3] }), Moves::Point(point.label), shown);
        }
        frame
    }

    fn add_anchor(&mut self, place: Option<Place>, moves: Moves<M>, name: Option<String>) -> usize {
        self.figure.anchors.push(Anchor { at: [0.0; 2], moves, name });
        self.scene.places.push(place);
        self.figure.anchors.len() - 1
    }

    /// Adds a part, with the direction of its path and its local axes y and z.
    fn add_part(&mut self, part: Part<M>, direction: Option<Vector3>, axes: Option<[Vector3; 2]>) {
        self.figure.parts.push(part);
        self.scene.directions.push(direction);
        self.scene.axes.push(axes);
    }

    /// The place of an anchor \[m\].
    fn metres(&self, anchor: usize) -> Option<Vector3> {
        self.scene.places[anchor].map(|place| place.metres)
    }

    fn add_member<T: Real>(&mut self, member: DrawnMember<M, T>) {
        let name = member.name.to_string();
        let axes = member.axes.map(|axes| axes.map(plain));
        let along = member.ends.iter().find_map(|end| direction3(plain(end.along?)));
        let kind = kind_of(member.kind, member.freedoms, along, axes).of_stiffness(member.bending_stiffness);
        let kind = if is_bar(kind, member.freedoms, [&member.ends[0].released, &member.ends[1].released]) {
            Kind::Bar
        } else {
            kind
        };
        let ends = [0, 1].map(|end| self.anchor_of_end(&member.ends[end], &name));
        let between = self.metres(ends[0]).zip(self.metres(ends[1])).map(|(from, to)| plus3(to, from, -1.0));
        let bends = matches!(kind, Kind::Beam { .. } | Kind::Bar)
            || matches!(kind, Kind::Line) && member.freedoms.contains(Freedoms::Y);
        let inside = between.filter(|_| bends).map(|way| Inside::Member(member.label, length3(way)));
        let part = Part { name, word: member.kind, kind, ends: ends.into(), inside };
        self.add_part(part, along, axes.map(|[_, y, z]| [y, z]));
        let Some(axes) = axes.filter(|_| matches!(kind, Kind::Beam { .. } | Kind::Line)) else { return };
        for ((end, anchor), inward) in member.ends.iter().zip(ends).zip([1.0, -1.0]) {
            if let Some(solid) = release(end.released, axes) {
                self.add_release(anchor, times(axes[0], inward * BESIDE), solid);
            }
        }
    }

    /// A symbol beside a node where the end of a member does not share all motions with it.
    fn add_release(&mut self, anchor: usize, aside: Vector3, solid: Solid) {
        let place = self.scene.places[anchor].map(|place| Place { aside, ..place });
        let moves = self.figure.anchors[anchor].moves.copy();
        let own = self.add_anchor(place, moves, None);
        let (kind, ends) = (Kind::Solid(solid), vec![own, own]);
        self.add_part(Part { name: String::new(), word: "release", kind, ends, inside: None }, None, None);
    }

    /// The anchor of an end of a member: its point, a place of its own that a rigid link ties to the point, or what is placed later.
    fn anchor_of_end<T: Real>(&mut self, end: &DrawnEnd<M, T>, member: &str) -> usize {
        let (Some(point), Some(metres)) = (end.point, end.position.map(plain)) else {
            return self.loose_anchor(end);
        };
        let slides = [Freedoms::X, Freedoms::Y, Freedoms::Z].iter().any(|freedom| end.released.contains(*freedom));
        let is_there = self.metres(point) == Some(metres);
        if is_there && !slides {
            return point;
        }
        self.scene.extent.push((member.to_owned(), metres));
        let own = self.add_anchor(Some(Place { metres, aside: [0.0; 3] }), Moves::End(end.label), None);
        if !is_there {
            self.add_link(format!("link of {member}"), "link", [point, own]);
        }
        own
    }

    fn add_link(&mut self, name: String, word: &'static str, ends: [usize; 2]) {
        let part = Part { name, word, kind: Kind::Lever, ends: ends.into(), inside: None };
        self.add_part(part, None, None);
    }

    /// The anchor of a motion of a path, or of the ground behind it, which are placed on the paper.
    fn loose_anchor<T: Real>(&mut self, end: &DrawnEnd<M, T>) -> usize {
        let known = self.scene.loose.iter().find(|loose| !loose.rests && !end.rests && loose.node == end.node);
        if let Some(loose) = known {
            return loose.anchor;
        }
        let moves = if end.rests { Moves::Rest } else { Moves::Path { node: end.node, along: [0.0; 3] } };
        let anchor = self.add_anchor(None, moves, None);
        self.scene.loose.push(Loose { anchor, node: end.node, rests: end.rests });
        self.scene.ways.push([0.0; 3]);
        anchor
    }

    fn add_bodies<Y: Drawn<Model = M>>(&mut self, sketch: &Sketch<'_, Y>) {
        let mut with_body = Vec::new();
        for body in sketch.bodies() {
            let name = body.name.to_string();
            let tied: Vec<usize> = (0..self.nodes.len()).filter(|&point| self.nodes[point] == body.node).collect();
            with_body.push(body.node);
            let (Some(metres), Some(&first)) = (body.centre.map(plain), tied.first()) else {
                self.add_mass_of_path(&body, name);
                continue;
            };
            let Some(from) = self.metres(first) else { continue };
            self.scene.extent.push((name.clone(), metres));
            let moves = Moves::Tied { anchor: first, arm: plus3(metres, from, -1.0) };
            let own = self.add_anchor(Some(Place { metres, aside: [0.0; 3] }), moves, None);
            let is_one = tied.iter().all(|&point| self.metres(point) == Some(metres));
            let (word, kind) =
                if is_one { ("point_mass", Kind::PointMass) } else { ("rigid_body", Kind::Solid(Solid::Body)) };
            let ends = tied.into_iter().chain([own]).collect();
            self.add_part(Part { name, word, kind, ends, inside: None }, None, None);
        }
        // points that move together without a mass
        for point in 0..self.nodes.len() {
            let node = self.nodes[point];
            let first = self.nodes.iter().position(|other| *other == node).unwrap_or(point);
            if first != point && !with_body.contains(&node) && self.metres(first) != self.metres(point) {
                self.add_link(format!("link of point {point}"), "rigid_link", [first, point]);
            }
        }
    }

    /// A mass, or an inertia, that moves with a path.
    fn add_mass_of_path<T: Real>(&mut self, body: &DrawnBody<T>, name: String) {
        let Some(loose) = self.scene.loose.iter().find(|loose| loose.node == body.node && !loose.rests) else { return };
        let ends = vec![loose.anchor, loose.anchor];
        let (word, kind) = if body.mass.vanishes() { ("inertia", Kind::Inertia) } else { ("mass", Kind::Mass) };
        self.add_part(Part { name, word, kind, ends, inside: None }, None, None);
    }

    fn add_supports<Y: Drawn<Model = M>>(&mut self, sketch: &Sketch<'_, Y>) {
        for support in sketch.supports() {
            let skew = support.skew.map(|skew| match skew {
                Skew::Along(direction) => Skew::Along(plain(direction)),
                Skew::Normal(direction) => Skew::Normal(plain(direction)),
            });
            let away = self.away_from_parts(support.point);
            if let Some(grip) = grip(support.held, skew, away) {
                let (name, anchor) = (support.name.to_string(), support.point);
                self.figure.supports.push(Support { name, anchor, holds: Holds::InSpace(grip) });
            }
        }
    }

    /// The way from a point on which its parts are not, as far as they have one side.
    fn away_from_parts(&self, point: usize) -> Vector3 {
        let Some(at) = self.metres(point) else { return [0.0; 3] };
        let places = self.figure.parts.iter().filter(|part| part.kind != Kind::Tie).filter_map(|part| {
            let ends: Vec<Vector3> = part.ends.iter().filter_map(|end| self.metres(*end)).collect();
            ends.contains(&at).then_some(ends)
        });
        let ways = places.flatten().filter_map(|place| direction3(plus3(place, at, -1.0)));
        ways.fold([0.0; 3], |sum, way| plus3(sum, way, -1.0))
    }

    /// The figure, with the direction of the motion of each path.
    fn finished(mut self) -> Figure<M> {
        for _ in 0..self.scene.loose.len() {
            for (part, along) in self.figure.parts.iter().zip(&self.scene.directions) {
                let ends = [part.ends[0], part.ends[1]];
                let of_end = |end| self.scene.loose.iter().position(|loose| loose.anchor == end);
                let known = ends.iter().filter_map(|end| of_end(*end)).map(|loose| self.scene.ways[loose]);
                let known = along.or(known.into_iter().find(|way| *way != [0.0; 3])).filter(|_| !part.kind.turns());
                for (end, way) in ends.iter().filter_map(|end| Some((of_end(*end)?, known?))) {
                    self.scene.ways[end] = way;
                }
            }
        }
        self.figure.scene = Some(self.scene);
        self.figure
    }
}
