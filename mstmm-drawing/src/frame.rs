//! A plane structure on the paper.

use crate::anchors::Scale;
use crate::error::DrawingError;
use crate::figure::{Anchor, Figure, Holds, Inside, Moves, Part, Support, label_of};
use crate::kind::Kind;
use crate::lanes::lay_side_by_side;
use crate::loose::Loose;
use crate::path_places::place_paths;
use crate::symbols::beams::scale_beams;
use crate::vector::{Vector, direction, distance, plus, turned};
use crate::view::Sight;
use mstmm_core::{Drawn, DrawnBody, DrawnEnd, DrawnPoint, DrawnSupport, Freedoms, Parameter, Real, Sketch, Skew};

/// Distance on the paper within which two places are one.
const SAME: f64 = 1e-6;

/// Distance on the paper from a node of the symbol of what an end does not share with it: a radius of a pin more than its own and that of a node.
const BESIDE: f64 = 9.0;

/// Puts a sketch on the paper.
pub(crate) fn figure<Y: Drawn>(sketch: &Sketch<'_, Y>) -> Result<Figure<Y::Model>, DrawingError> {
    let mut frame = Builder::of(sketch)?;
    frame.add_members(sketch);
    frame.add_bodies(sketch);
    let is_flat = frame.figure.anchors.iter().all(|anchor| anchor.at[1] == 0.0);
    frame.add_supports(sketch);
    if is_flat {
        lay_side_by_side(&mut frame.figure, &frame.loose);
    }
    place_paths(&mut frame.figure, &frame.loose, &frame.directions);
    scale_beams(&mut frame.figure);
    Ok(frame.figure)
}

/// A figure while it grows.
struct Builder<M> {
    figure: Figure<M>,
    scale: Scale,
    /// The node of each point.
    nodes: Vec<usize>,
    /// Whether points have displacements along x.
    is_plane: bool,
    /// The anchors of ends without a place.
    loose: Vec<Loose>,
    /// The direction of each part in which its path acts, on the paper.
    directions: Vec<Option<Vector>>,
}

/// A place in plain numbers.
fn plain<T: Parameter>([x, y, _]: [T; 3]) -> Vector {
    [x, y].map(Parameter::to_f64)
}

/// The direction of a vector of the model on the paper.
fn on_paper([x, y]: [f64; 2]) -> Option<Vector> {
    direction([x, -y])
}

impl<M> Builder<M> {
    /// The points of a sketch.
    fn of<Y: Drawn<Model = M>>(sketch: &Sketch<'_, Y>) -> Result<Self, DrawingError> {
        let points: Vec<DrawnPoint<M, Y::Parameter>> = sketch.points().collect();
        let mut places: Vec<(String, Vector)> = Vec::new();
        places.extend(points.iter().map(|point| (point.name.to_string(), plain(point.position))));
        for member in sketch.members() {
            let name = member.name.to_string();
            places.extend(member.ends.iter().filter_map(|end| Some((name.clone(), plain(end.position?)))));
        }
        places.extend(sketch.bodies().filter_map(|body| Some((body.name.to_string(), plain(body.centre?)))));
        let scale = Scale::of(places.iter().map(|(name, place)| (name.as_str(), *place)))?;
        let anchors = points.iter().map(|point| {
            let name = point.name.to_string();
            let name = label_of(&name).is_some().then_some(name);
            Anchor { at: scale.place(plain(point.position)), moves: Moves::Point(point.label), name }
        });
        Ok(Builder {
            figure: Figure {
                anchors: anchors.collect(),
                parts: Vec::new(),
                supports: Vec::new(),
                spots: Vec::new(),
                scale: scale.size,
                origin: scale.place([0.0; 2]),
                sight: Sight::PLANE,
                scene: None,
            },
            scale,
            nodes: points.iter().map(|point| point.node).collect(),
            is_plane: points.iter().any(|point| point.freedoms.contains(Freedoms::X)),
            loose: Vec::new(),
            directions: Vec::new(),
        })
    }

    fn add_members<Y: Drawn<Model = M>>(&mut self, sketch: &Sketch<'_, Y>) {
        for member in sketch.members() {
            let name = member.name.to_string();
            let direction_of = |end: &DrawnEnd<M, Y::Parameter>| end.along.map(plain).and_then(on_paper);
            let along = member.ends.iter().find_map(direction_of);
            let kind = match (Kind::of(member.kind).of_stiffness(member.bending_stiffness), along) {
                (Kind::Slider(_), Some(along)) => Kind::Slider(along),
                (kind, _) => kind,
            };
            let ends = [0, 1].map(|end| self.anchor_of_end(&member.ends[end], &name));
            let [from, to] = [0, 1].map(|end| member.ends[end].position.map(plain));
            let length = from.zip(to).map_or(0.0, |(from, to)| distance(from, to));
            self.directions.resize(self.figure.parts.len(), None);
            self.directions.push(along);
            // lines of paths have lengths of their own, and stretch evenly enough; a string between two places moves across itself
            let bends = matches!(kind, Kind::Beam { .. })
                || matches!(kind, Kind::Line) && member.freedoms.contains(Freedoms::Y);
            let inside = Some(Inside::Member(member.label, length)).filter(|_| bends);
            self.figure.parts.push(Part { name, word: member.kind, kind, ends: ends.into(), inside });
            let line = from.zip(to).and_then(|(from, to)| on_paper([to[0] - from[0], to[1] - from[1]]));
            for ((end, anchor), inward) in member.ends.iter().zip(ends).zip([1.0, -1.0]) {
                self.add_release(end, anchor, (along.or(line), inward));
            }
        }
    }

    /// A symbol beside a node where the end of a member does not share all motions with it, on the member, whose line leads inward or outward.
    fn add_release<T: Real>(&mut self, end: &DrawnEnd<M, T>, anchor: usize, (line, inward): (Option<Vector>, f64)) {
        let Some([x, y]) = line.filter(|_| !end.released.is_empty() && end.position.is_some()) else { return };
        let Anchor { at, moves, .. } = &self.figure.anchors[anchor];
        let beside = Anchor { at: plus(*at, [x, y], inward * BESIDE), moves: moves.copy(), name: None };
        let anchor = self.figure.anchors.len();
        self.figure.anchors.push(beside);
        let (word, kind) = if end.released.contains(Freedoms::RZ) {
            ("pin", Kind::Pin)
        } else if end.released.contains(Freedoms::X) {
            ("slider", Kind::Slider([x, y]))
        } else {
            ("slider", Kind::Slider([-y, x]))
        };
        self.figure.parts.push(Part { name: String::new(), word, kind, ends: vec![anchor, anchor], inside: None });
    }

    /// The anchor of an end of a member: its point, a place of its own that a rigid link ties to the point, or what is placed later.
    fn anchor_of_end<T: Real>(&mut self, end: &DrawnEnd<M, T>, member: &str) -> usize {
        let (Some(point), Some(position)) = (end.point, end.position.map(plain)) else {
            return self.loose_anchor(end);
        };
        let at = self.scale.place(position);
        let slides = end.released.contains(Freedoms::X) || end.released.contains(Freedoms::Y);
        if distance(at, self.figure.anchors[point].at) < SAME && !slides {
            return point;
        }
        let own = self.figure.anchors.len();
        self.figure.anchors.push(Anchor { at, moves: Moves::End(end.label), name: None });
        if !slides {
            let name = format!("link of {member}");
            let ends = vec![point, own];
            self.figure.parts.push(Part { name, word: "link", kind: Kind::Lever, ends, inside: None });
        }
        own
    }

    /// The anchor of a motion of a path, or of the ground behind it, which are placed later.
    fn loose_anchor<T: Real>(&mut self, end: &DrawnEnd<M, T>) -> usize {
        let known = self.loose.iter().find(|loose| !loose.rests && !end.rests && loose.node == end.node);
        if let Some(loose) = known {
            return loose.anchor;
        }
        let anchor = self.figure.anchors.len();
        let moves = if end.rests { Moves::Rest } else { Moves::Path { node: end.node, along: [0.0, 1.0, 0.0] } };
        self.figure.anchors.push(Anchor { at: [0.0; 2], moves, name: None });
        self.loose.push(Loose { anchor, node: end.node, rests: end.rests });
        anchor
    }

    fn add_bodies<Y: Drawn<Model = M>>(&mut self, sketch: &Sketch<'_, Y>) {
        for body in sketch.bodies() {
            let name = body.name.to_string();
            let word: &'static str = if name.starts_with("rigid_body") { "rigid_body" } else { "point_mass" };
            let tied: Vec<usize> = (0..self.nodes.len()).filter(|&point| self.nodes[point] == body.node).collect();
            let (Some(centre), Some(&first)) = (body.centre.map(plain), tied.first()) else {
                self.add_mass_of_path(&body, name);
                continue;
            };
            if name.starts_with("rigid_link") {
                let links = tied.iter().filter(|&&point| point != first).map(|&point| Part {
                    name: name.clone(),
                    word: "rigid_link",
                    kind: Kind::Lever,
                    ends: vec![first, point],
                    inside: None,
                });
                self.figure.parts.extend(links);
                continue;
            }
            let (at, from) = (self.scale.place(centre), self.figure.anchors[first].at);
            let arm = [(at[0] - from[0]) / self.scale.size, (from[1] - at[1]) / self.scale.size, 0.0];
            let own = self.figure.anchors.len();
            self.figure.anchors.push(Anchor { at, moves: Moves::Tied { anchor: first, arm }, name: None });
            let is_one = tied.iter().all(|&point| distance(self.figure.anchors[point].at, at) < SAME);
            let kind = if is_one && word == "point_mass" { Kind::PointMass } else { Kind::Body };
            let ends = tied.into_iter().chain([own]).collect();
            self.figure.parts.push(Part { name, word, kind, ends, inside: None });
        }
    }

    /// A mass, or an inertia, that moves with a path.
    fn add_mass_of_path<T: Real>(&mut self, body: &DrawnBody<T>, name: String) {
        let Some(loose) = self.loose.iter().find(|loose| loose.node == body.node && !loose.rests) else { return };
        let is_inertia = name.starts_with("inertia");
        let (word, kind) = if is_inertia { ("inertia", Kind::Inertia) } else { ("mass", Kind::Mass) };
        self.figure.parts.push(Part { name, word, kind, ends: vec![loose.anchor, loose.anchor], inside: None });
    }

    fn add_supports<Y: Drawn<Model = M>>(&mut self, sketch: &Sketch<'_, Y>) {
        for support in sketch.supports() {
            let name = support.name.to_string();
            // at a point that does not turn it holds no rotation, and is one all the same
            let is_fixed = name.starts_with("fixed");
            let holds = if is_fixed { Some(Holds::All) } else { holds(&support, self.is_plane) };
            self.figure.supports.extend(holds.map(|holds| Support { name, anchor: support.point, holds }));
        }
    }
}

/// What a support holds; none where it holds nothing.
fn holds<T: Real>(support: &DrawnSupport<T>, is_plane: bool) -> Option<Holds> {
    let has = |freedom| support.held.contains(freedom);
    if support.held.is_empty() && support.skew.is_none() {
        return None;
    }
    // with one coordinate nothing moves along it
    let [x, y, rotation] = [has(Freedoms::X) || !is_plane, has(Freedoms::Y), has(Freedoms::RZ)];
    // across a normal there is one direction in the plane
    let along = support.skew.and_then(|skew| match skew {
        Skew::Along(direction) => on_paper(plain(direction)),
        Skew::Normal(direction) => on_paper(turned(plain(direction))),
    });
    let along = along.or(match (x, y) {
        (true, false) => Some([0.0, 1.0]),
        (false, true) => Some([1.0, 0.0]),
        _ => None,
    });
    Some(match (along, rotation) {
        (Some(along), false) => Holds::Across(along),
        (Some(along), true) => Holds::AcrossAndRotation(along),
        (None, true) if x && y => Holds::All,
        (None, true) => Holds::Rotation,
        (None, false) => Holds::Displacements,
    })
}
