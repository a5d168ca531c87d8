//! Random structures in space, described once and built in several ways.
#![expect(clippy::unwrap_used, reason = "all names are those of parameters")]

use crate::numbers::Random;
use mstmm::elements::{Spring, TorsionSpring};
use mstmm::frame::{
    Bar, End, Frame, Ground, Hinge, Member, OfBeam, Point, PointMass, RigidBody, RigidLink, Roller, Section, Space,
    Tensor, Tie,
};
use mstmm::network::{Freedoms, Support};

/// A vector.
pub(crate) type Vector = [f64; 3];

/// A rotation, as its three rows.
pub(crate) type Rotation = [Vector; 3];

/// A beam or a bar.
#[derive(Clone, Debug)]
pub(crate) struct Beam {
    pub(crate) ends: [usize; 2],
    /// What its section names.
    pub(crate) named: Vec<(&'static str, f64)>,
    pub(crate) up: Vector,
    pub(crate) is_bar: bool,
    /// What its output end does not share.
    pub(crate) released: Freedoms,
}

impl Beam {
    /// Its section, with another value of one parameter.
    pub(crate) fn section(&self, changed: Option<(&str, f64)>) -> Section {
        let name = |section: Section, (name, value): &(&str, f64)| {
            let other = changed.filter(|(changed, _)| changed == name);
            section.with(name, other.map_or(*value, |(_, other)| other)).unwrap()
        };
        self.named.iter().fold(Section::new().up(self.up), name)
    }
}

/// What holds a point.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Held {
    Fixed,
    Pinned,
    Normal(Vector),
    Along(Vector),
}

/// A structure in space.
#[derive(Clone, Debug, Default)]
pub(crate) struct Model {
    pub(crate) places: Vec<Vector>,
    pub(crate) holds: Vec<(usize, Held)>,
    pub(crate) beams: Vec<Beam>,
    /// A point on the ground's spring, its direction and stiffness.
    pub(crate) springs: Vec<(usize, Vector, f64)>,
    pub(crate) turning: Vec<(usize, Vector, f64)>,
    /// A point with a mass and a tensor of inertia.
    pub(crate) masses: Vec<(usize, f64, [f64; 6])>,
    /// Two points at one place, and the axis of the joint between them.
    pub(crate) joints: Vec<([usize; 2], Tie, Vector)>,
    pub(crate) hinges: Vec<([usize; 2], Hinge, Vector)>,
    /// Two points of a rigid body, its mass, its tensor and its centre.
    pub(crate) bodies: Vec<([usize; 2], f64, [f64; 6], Vector)>,
}

/// A rotation by angles about z, y and x.
pub(crate) fn rotation([about_z, about_y, about_x]: Vector) -> Rotation {
    let ([a, b, c], [p, q, r]) = ([about_z, about_y, about_x].map(f64::cos), [about_z, about_y, about_x].map(f64::sin));
    [[a * b, a * q * r - p * c, a * q * c + p * r], [p * b, p * q * r + a * c, p * q * c - a * r], [-q, b * r, b * c]]
}

/// A vector turned by a rotation.
pub(crate) fn turned(by: &Rotation, vector: Vector) -> Vector {
    [0, 1, 2].map(|row| (0..3).map(|column| by[row][column] * vector[column]).sum())
}

/// A tensor of entries xx, yy, zz, xy, yz and zx turned by a rotation.
fn turned_tensor(by: &Rotation, [xx, yy, zz, xy, yz, zx]: [f64; 6]) -> [f64; 6] {
    let tensor = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
    let entry = |i: usize, j: usize| -> f64 {
        (0..3).flat_map(|k| (0..3).map(move |l| by[i][k] * tensor[k][l] * by[j][l])).sum()
    };
    [entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)]
}

impl Model {
    /// The structure turned by a rotation: holds along axes become skew.
    pub(crate) fn turned(&self, by: &Rotation) -> Model {
        let of = |vector: Vector| turned(by, vector);
        let held = |held: Held| match held {
            Held::Normal(normal) => Held::Normal(of(normal)),
            Held::Along(along) => Held::Along(of(along)),
            other => other,
        };
        Model {
            places: self.places.iter().map(|place| of(*place)).collect(),
            holds: self.holds.iter().map(|(point, hold)| (*point, held(*hold))).collect(),
            beams: self.beams.iter().map(|beam| Beam { up: of(beam.up), ..beam.clone() }).collect(),
            springs: self.springs.iter().map(|(point, along, k)| (*point, of(*along), *k)).collect(),
            turning: self.turning.iter().map(|(point, about, k)| (*point, of(*about), *k)).collect(),
            masses: self
                .masses
                .iter()
                .map(|(point, mass, inertia)| (*point, *mass, turned_tensor(by, *inertia)))
                .collect(),
            joints: self.joints.iter().map(|(points, tie, axis)| (*points, *tie, of(*axis))).collect(),
            hinges: self
                .hinges
                .iter()
                .map(|(points, hinge, axis)| (*points, hinge.up(of(UP_OF_HINGE)), of(*axis)))
                .collect(),
            bodies: self
                .bodies
                .iter()
                .map(|(points, mass, inertia, centre)| (*points, *mass, turned_tensor(by, *inertia), of(*centre)))
                .collect(),
        }
    }

    /// The structure with a point in each beam, at a part of its length.
    pub(crate) fn cut(&self, part: f64) -> Model {
        let mut cut = Model { beams: Vec::new(), ..self.clone() };
        for beam in &self.beams {
            let [from, to] = beam.ends.map(|end| self.places[end]);
            if beam.is_bar {
                cut.beams.push(beam.clone());
                continue;
            }
            cut.places.push([0, 1, 2].map(|k| from[k] + part * (to[k] - from[k])));
            let middle = cut.places.len() - 1;
            cut.beams.push(Beam { ends: [beam.ends[0], middle], released: Freedoms::NONE, ..beam.clone() });
            cut.beams.push(Beam { ends: [middle, beam.ends[1]], ..beam.clone() });
        }
        cut
    }

    /// Its chain of beams alone: what holds it, and no points that nothing joins.
    pub(crate) fn beams_alone(&self) -> Model {
        let first =
            self.joints.iter().map(|(points, ..)| points[1]).chain(self.hinges.iter().map(|(points, ..)| points[1]));
        let of_bodies = self.bodies.iter().map(|(points, ..)| points[1]);
        let count = first.chain(of_bodies).min().unwrap_or(self.places.len());
        Model {
            places: self.places[..count].to_vec(),
            holds: self.holds.clone(),
            beams: self.beams.iter().filter(|beam| beam.ends.iter().all(|end| *end < count)).cloned().collect(),
            ..Model::default()
        }
    }

    /// The frame, and its points.
    pub(crate) fn frame(&self) -> (Frame<Space>, Vec<Point<Space>>) {
        let (frame, points, _) = self.frame_and_members();
        (frame, points)
    }

    /// The frame, its points, and the members of its beams.
    pub(crate) fn frame_and_members(&self) -> (Frame<Space>, Vec<Point<Space>>, Vec<Member<OfBeam>>) {
        let mut frame = Frame::new();
        let points: Vec<_> = self.places.iter().map(|place| frame.point(*place)).collect();
        for (point, held) in &self.holds {
            match *held {
                Held::Fixed => frame.hold(points[*point], Support::Fixed),
                Held::Pinned => frame.hold(points[*point], Support::Pinned),
                Held::Normal(normal) => frame.hold(points[*point], Roller::normal(normal)),
                Held::Along(along) => frame.hold(points[*point], Roller::along(along)),
            }
        }
        let mut members = Vec::new();
        for beam in &self.beams {
            let [from, to] = beam.ends.map(|end| points[end]);
            let to = End::from(to).releasing(beam.released);
            members.push(if beam.is_bar {
                frame.member(from, to, Bar(beam.section(None)))
            } else {
                frame.member(from, to, beam.section(None))
            });
        }
        for (point, along, stiffness) in &self.springs {
            frame.member(points[*point].along(*along), Ground, Spring { stiffness: *stiffness });
        }
        for (point, about, stiffness) in &self.turning {
            frame.member(points[*point].about(*about), Ground, TorsionSpring { stiffness: *stiffness });
        }
        for (point, mass, inertia) in &self.masses {
            frame.body([points[*point]], PointMass { mass: *mass, inertia: Tensor::new(*inertia) });
        }
        for ([one, other], tie, axis) in &self.joints {
            frame.member(points[*one].along(*axis), points[*other].along(*axis), *tie);
        }
        for ([one, other], hinge, axis) in &self.hinges {
            frame.member(points[*one].along(*axis), points[*other].along(*axis), *hinge);
        }
        for ([one, other], mass, inertia, centre) in &self.bodies {
            let tied = [points[*one], points[*other]];
            if *mass == 0.0 {
                frame.body(tied, RigidLink);
            } else {
                frame.body(tied, RigidBody { mass: *mass, inertia: Tensor::new(*inertia), centre: *centre });
            }
        }
        (frame, points, members)
    }
}

/// The z axis of hinges, made normal to their axes.
pub(crate) const UP_OF_HINGE: Vector = [0.2, 0.9, 0.3];

/// Makes one structure.
struct Generator {
    random: Random,
    /// Powers of ten over which parameters are spread, to both sides.
    span: f64,
}

/// A random structure: a chain of beams with loops, joints, bodies, springs and skew supports.
pub(crate) fn random_model(seed: u64, span: f64) -> Model {
    let random = Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
    Generator { random, span }.model()
}

impl Generator {
    fn size(&mut self) -> f64 {
        10_f64.powf(self.span * (2.0 * self.random.unit() - 1.0)) * self.random.value()
    }

    fn vector(&mut self) -> Vector {
        [0, 1, 2].map(|_| 2.0 * self.random.unit() - 1.0)
    }

    fn named(&mut self, is_bar: bool) -> Vec<(&'static str, f64)> {
        let [along, bending_y, bending_z, mass] = [0; 4].map(|_| self.size());
        let mut named = vec![
            ("axial_stiffness", 1e3 * along),
            ("mass_per_length", mass),
            ("bending_stiffness_y", bending_y),
            ("bending_stiffness_z", bending_z),
        ];
        if !is_bar {
            named.extend([("torsional_stiffness", self.size()), ("polar_inertia_per_length", 0.01 * self.size())]);
        }
        if self.random.chance(0.3) {
            named.extend([("shear_stiffness_y", 1e2 * self.size()), ("rotary_inertia_z", 0.01 * self.size())]);
        }
        if self.random.chance(0.2) {
            named.extend([("axial_force", 0.1 * bending_y.min(bending_z)), ("foundation_stiffness_z", self.size())]);
        }
        named
    }

    fn beam(&mut self, ends: [usize; 2]) -> Beam {
        let is_bar = self.random.chance(0.15);
        let named = self.named(is_bar);
        let released = if !is_bar && self.random.chance(0.15) { Freedoms::RZ } else { Freedoms::NONE };
        Beam { ends, named, up: self.vector(), is_bar, released }
    }

    fn tensor(&mut self) -> [f64; 6] {
        let [x, y, z] = [0; 3].map(|_| 0.1 * self.size());
        let by = rotation(self.vector());
        if self.random.chance(0.3) { [x, y, z, 0.0, 0.0, 0.0] } else { turned_tensor(&by, [x, y, z, 0.0, 0.0, 0.0]) }
    }

    fn model(mut self) -> Model {
        let mut model = Model::default();
        model.places.push([0.0; 3]);
        model.holds.push((0, Held::Fixed));
        let members = 2 + self.random.below(4);
        for _ in 0..members {
            let from = self.random.below(model.places.len());
            let step = self.vector().map(|part| 2.0 * part);
            let place = [0, 1, 2].map(|k| model.places[from][k] + step[k] + if k == 0 { 0.5 } else { 0.0 });
            model.places.push(place);
            let to = model.places.len() - 1;
            let mut beam = self.beam([from, to]);
            // what hangs on one member alone is held by that
            (beam.is_bar, beam.released, beam.named) = (false, Freedoms::NONE, self.named(false));
            model.beams.push(beam);
        }
        let points = model.places.len();
        if self.random.chance(0.5) && points > 3 {
            let beam = self.beam([0, points - 1]);
            if !model.beams.iter().any(|other| other.ends == beam.ends) {
                model.beams.push(beam);
            }
        }
        let last = points - 1;
        match self.random.below(5) {
            0 => model.holds.push((last, Held::Pinned)),
            1 => model.holds.push((last, Held::Normal(self.vector()))),
            2 => model.holds.push((last, Held::Along(self.vector()))),
            _ => {}
        }
        if self.random.chance(0.4) {
            model.springs.push((last, self.vector(), self.size()));
        }
        if self.random.chance(0.3) {
            model.turning.push((last, self.vector(), self.size()));
        }
        if self.random.chance(0.4) {
            let tensor = self.tensor();
            model.masses.push((1, self.size(), tensor));
        }
        if self.random.chance(0.4) {
            self.add_joint(&mut model);
        }
        if self.random.chance(0.3) {
            // a rigid arm with a spring at its tip
            let tip = [0, 1, 2].map(|k| model.places[last][k] + if k == 1 { 0.4 } else { 0.1 });
            model.places.push(tip);
            let tensor = self.tensor();
            let own = model.places.len() - 1;
            model.bodies.push(([last, own], self.size(), tensor, tip));
            model.springs.push((own, self.vector(), self.size()));
        }
        model
    }

    /// A beam behind a joint at the last point of the chain.
    fn add_joint(&mut self, model: &mut Model) {
        let last = model.places.len() - 1;
        let place = model.places[last];
        let step = self.vector();
        model.places.push(place);
        model.places.push([0, 1, 2].map(|k| place[k] + step[k] + if k == 2 { 0.7 } else { 0.0 }));
        let mut beam = self.beam([last + 1, last + 2]);
        (beam.is_bar, beam.released, beam.named) = (false, Freedoms::NONE, self.named(false));
        model.beams.push(beam);
        let axis = self.vector();
        let joint = match self.random.below(5) {
            0 => Tie::revolute(),
            1 => Tie::universal(),
            2 => Tie::prismatic(),
            3 => Tie::cylindrical(),
            _ => {
                let hinge = Hinge::new().stiffness_rx(self.size()).stiffness_rz(self.size()).stiffness_z(self.size());
                model.hinges.push(([last, last + 1], hinge.up(UP_OF_HINGE), axis));
                return;
            }
        };
        model.joints.push(([last, last + 1], joint, axis));
        // what the joint lets go is held by springs
        for _ in 0..2 {
            model.springs.push((last + 2, self.vector(), self.size()));
            model.turning.push((last + 2, self.vector(), self.size()));
        }
    }
}
