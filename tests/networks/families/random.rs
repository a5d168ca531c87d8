//! Random structures: trees and loops, parallel members, offsets, releases, skew supports, springs, bodies with many ports.
//!
//! Positions are multiples of 1/64, so that middles of members are numbers too. No node is a mechanism without mass.

use crate::structure::{Element, End, Freedoms, Node, Section, Structure};
use crate::support::random_tree::Random;

/// How far parameters differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spread {
    /// Stiffnesses and masses within two decades, members a hundred to ten thousand times as stiff along their axes.
    Moderate,
    /// Stiffnesses and masses within 1e±4, each by itself.
    Wide,
    /// `EA/EI` from 1e-9 to 1e12, some members 1e±12 times as stiff as others, springs likewise.
    Stiff,
}

/// Makes one structure.
struct Generator {
    random: Random,
    spread: Spread,
    structure: Structure,
}

/// A random structure of two to six nodes with members between them; it may be free to move as a whole.
pub(crate) fn random_structure(seed: u64, spread: Spread) -> Structure {
    let random = Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
    let mut generator = Generator { random, spread, structure: Structure::default() };
    let nodes = 2 + generator.random.below(5);
    for _ in 0..nodes {
        let position = generator.place();
        generator.structure.node(Node::at(position));
    }
    let hub = generator.random.chance(0.2);
    for node in 1..nodes {
        // a body with many ports has all members
        let other = if hub { 0 } else { generator.random.below(node) };
        generator.beam(other, node, hub);
    }
    for _ in 0..generator.random.pick([0, 0, 1, 1, 2, 3]) {
        let from = generator.random.below(nodes);
        let to = (from + 1 + generator.random.below(nodes - 1)) % nodes;
        generator.beam(from, to, hub);
    }
    (0..nodes).for_each(|node| generator.furnish(node));
    if generator.random.chance(0.3) {
        generator.spring_between(nodes);
    }
    if generator.random.chance(0.2) {
        generator.lone_mass(nodes);
    }
    generator.fill_mechanisms();
    generator.structure
}

/// The number with three digits: short to read.
fn short(value: f64) -> f64 {
    let exponent = value.log10().floor() - 2.0;
    let digits = (value / 10f64.powf(exponent)).round();
    format!("{digits}e{exponent}").parse().unwrap_or(value)
}

fn distance([x, y]: [f64; 2], [other_x, other_y]: [f64; 2]) -> f64 {
    (x - other_x).hypot(y - other_y)
}

impl Generator {
    /// A number whose decimal logarithm is between two.
    fn decades(&mut self, from: f64, to: f64) -> f64 {
        short(10f64.powf(from + (to - from) * self.random.unit()))
    }

    /// A multiple of 1/64 up to a size, of any sign.
    fn offset(&mut self, size: f64) -> f64 {
        ((2.0 * self.random.unit() - 1.0) * size * 64.0).round() / 64.0
    }

    fn near(&mut self, [x, y]: [f64; 2], size: f64) -> [f64; 2] {
        [x + self.offset(size), y + self.offset(size)]
    }

    /// A position away from all others.
    fn place(&mut self) -> [f64; 2] {
        loop {
            let place = self.near([0.0, 0.0], 2.0);
            if self.structure.nodes.iter().all(|node| distance(node.position, place) > 0.4) {
                return place;
            }
        }
    }

    fn direction(&mut self) -> [f64; 2] {
        self.random.pick([[1.0, 0.0], [0.0, 1.0], [3.0, 4.0], [-0.28, 0.96], [1.0, -1.0], [5.0, 0.125]])
    }

    fn section(&mut self) -> Section {
        if self.spread == Spread::Wide {
            let [axial_stiffness, bending_stiffness, mass_per_length] = [0, 1, 2].map(|_| self.decades(-4.0, 4.0));
            return Section { axial_stiffness, bending_stiffness, mass_per_length };
        }
        let bending_stiffness = self.decades(-1.0, 1.0);
        let mass_per_length = self.decades(-1.0, 1.0);
        let ratio = match self.spread {
            Spread::Moderate | Spread::Wide => self.decades(2.0, 4.0),
            Spread::Stiff => self.decades(-9.0, 12.0),
        };
        let axial_stiffness = short(bending_stiffness * ratio);
        let section = Section { axial_stiffness, bending_stiffness, mass_per_length };
        let is_other = self.spread == Spread::Stiff && self.random.chance(0.25);
        if is_other { section.times(self.decades(-12.0, 12.0)) } else { section }
    }

    fn stiffness(&mut self) -> f64 {
        match self.spread {
            Spread::Moderate => self.decades(-1.0, 2.0),
            Spread::Wide => self.decades(-4.0, 4.0),
            Spread::Stiff => self.decades(-8.0, 10.0),
        }
    }

    /// The end of a member at a node, off it now and then.
    fn end(&mut self, node: usize, is_port: bool) -> End {
        let is_off = is_port && node == 0 || self.random.chance(0.2);
        let end = End::from(node);
        if is_off { end.at(self.near(self.structure.nodes[node].position, 0.125)) } else { end }
    }

    /// What the end does not share: of both ends no more than one is released much.
    fn releases(&mut self) -> Freedoms {
        let one = self.random.pick([Freedoms::X, Freedoms::Y, Freedoms::RZ, Freedoms::RZ]);
        if self.random.chance(0.2) { one } else { Freedoms::NONE }
    }

    fn beam(&mut self, from: usize, to: usize, is_hub: bool) {
        let section = self.section();
        let [from, to] = [from, to].map(|node| self.end(node, is_hub).releasing(self.releases()));
        self.structure.beam(from, to, section);
    }

    /// Gives a node supports, a body, springs to the ground.
    fn furnish(&mut self, index: usize) {
        let mut node = self.structure.nodes[index];
        let kind = self.random.unit();
        if kind < 0.15 {
            node = node.held(Freedoms::ALL);
        } else if kind < 0.25 {
            node = node.held(Freedoms::PIN);
        } else if kind < 0.35 {
            let rotation = if self.random.chance(0.3) { Freedoms::RZ } else { Freedoms::NONE };
            node = node.along(self.direction()).held(rotation);
        } else if kind < 0.42 {
            node = node.held(self.random.pick([Freedoms::X, Freedoms::Y, Freedoms::RZ]));
        }
        if self.random.chance(0.3) {
            node = self.body(node);
        }
        self.structure.nodes[index] = node;
        if self.random.chance(0.25) {
            self.grounded_spring(index);
        }
        if self.random.chance(0.1) {
            let (ground, stiffness) = (self.structure.clamp(node.position), self.stiffness());
            self.structure.torsion_spring(index, ground, stiffness);
        }
    }

    fn body(&mut self, node: Node) -> Node {
        let (mass, inertia) = match self.spread {
            Spread::Wide => (self.decades(-4.0, 4.0), self.decades(-4.0, 4.0)),
            Spread::Moderate | Spread::Stiff => (self.decades(-1.0, 1.0), self.decades(-2.0, 0.0)),
        };
        let centre = self.near(node.position, 0.25);
        node.body(mass, inertia, centre)
    }

    /// A spring from a node to the ground, along a line or in a direction.
    fn grounded_spring(&mut self, node: usize) {
        let (stiffness, from) = (self.stiffness(), self.end(node, false));
        let place = self.place();
        let ground = self.structure.clamp(place);
        if self.random.chance(0.5) && self.structure.position(&from) != place {
            self.structure.spring(from, ground, stiffness);
        } else {
            let direction = self.direction();
            self.structure.spring_along(from, ground, direction, stiffness);
        }
    }

    /// A spring between two nodes, along a line, in a direction or between their rotations.
    fn spring_between(&mut self, nodes: usize) {
        let from = self.random.below(nodes);
        let to = (from + 1 + self.random.below(nodes - 1)) % nodes;
        let stiffness = self.stiffness();
        match self.random.below(3) {
            0 => self.structure.torsion_spring(from, to, stiffness),
            1 => {
                let direction = self.direction();
                let [from, to] = [from, to].map(|node| self.end(node, false));
                self.structure.spring_along(from, to, direction, stiffness);
            }
            _ => self.structure.spring(from, to, stiffness),
        }
    }

    /// A mass that three springs of any stiffness join to other nodes.
    fn lone_mass(&mut self, nodes: usize) {
        let place = self.place();
        let node = self.body(Node::at(place));
        let mass = self.structure.node(node);
        for _ in 0..3 {
            let (other, stiffness) = (self.random.below(nodes), self.stiffness());
            let end = End::from(mass).at(self.near(place, 0.125));
            self.structure.spring(other, end, stiffness);
        }
    }

    /// A node without a member that shares all displacements has a mass instead.
    fn fill_mechanisms(&mut self) {
        for index in 0..self.structure.nodes.len() {
            let node = self.structure.nodes[index];
            let shares = |end: &End| end.node == index && end.released.is_empty();
            let is_member = |element: &Element| matches!(element, Element::Beam(_));
            let mut members = self.structure.members.iter().filter(|member| is_member(&member.element));
            let is_moved = members.any(|member| member.ends.iter().any(shares));
            if node.held != Freedoms::ALL && node.mass == 0.0 && !is_moved {
                self.structure.nodes[index] = self.body(node);
            }
        }
    }
}
