//! Structures of bending beams in a line: what a chain of planes would be, with loops by springs, by stiffnesses.

use crate::families::Named;
use crate::structure::{End, Freedoms, Node, Section, Structure};
use crate::support::random_tree::Random;

/// How far stiffnesses differ.
const DECADES: [f64; 2] = [2.0, 10.0];

struct Line {
    random: Random,
    decades: f64,
    structure: Structure,
}

/// A structure in a line whose nodes do not move along it: a chain or a tree, with springs beside and across, bodies, hinges.
pub(crate) fn line_structure(seed: u64) -> Structure {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x51);
    let decades = random.pick(DECADES);
    let mut line = Line { random, decades, structure: Structure::default() };
    let nodes = 2 + line.random.below(8);
    let is_chain = line.random.chance(0.6);
    line.structure.node(Node::at([0.0, 0.0]).held(Freedoms::X));
    for node in 1..nodes {
        let other = if is_chain { node - 1 } else { line.random.below(node) };
        line.beam_from(other);
    }
    (0..nodes).for_each(|node| line.furnish(node));
    for _ in 0..line.random.below(4) {
        line.spring_between(nodes);
    }
    line.structure
}

/// Random structures in a line of consecutive seeds.
pub(crate) fn line_structures(seeds: core::ops::Range<u64>) -> impl Iterator<Item = Named> {
    seeds.map(|seed| (format!("line_structure({seed})"), line_structure(seed)))
}

impl Line {
    fn stiffness(&mut self) -> f64 {
        10f64.powf(self.decades * (self.random.unit() - 0.5)) * self.random.value()
    }

    /// A new node, and a beam to it; a hinge at its end now and then.
    fn beam_from(&mut self, other: usize) {
        let [x, _] = self.structure.nodes[other].position;
        // multiples of 1/64 are lengths without rounding
        let length = (1 + self.random.below(160)) as f64 / 64.0;
        let place = [if self.random.chance(0.2) { x - length } else { x + length }, 0.0];
        let node = self.structure.node(Node::at(place).held(Freedoms::X));
        let bending_stiffness = if self.random.chance(0.2) { self.stiffness() } else { self.random.value() };
        let section = Section { axial_stiffness: 1e3, bending_stiffness, mass_per_length: self.random.value() };
        let end = End::from(other);
        let is_hinge = self.random.chance(0.15);
        let from = if is_hinge { end.releasing(Freedoms::RZ) } else { end };
        self.structure.beam(from, node, section);
    }

    fn furnish(&mut self, index: usize) {
        let [x, _] = self.structure.nodes[index].position;
        let held = self.random.pick([
            Freedoms::NONE,
            Freedoms::NONE,
            Freedoms::NONE,
            Freedoms::NONE,
            Freedoms::Y,
            Freedoms::RZ,
            Freedoms::ALL,
        ]);
        let mut node = self.structure.nodes[index].held(held);
        // a first node with hinges only has no mass else
        if index == 0 || self.random.chance(0.3) {
            let centre = [x + self.random.below(64) as f64 / 128.0, 0.0];
            node = node.body(self.random.value(), 0.1 * self.random.value(), centre);
        }
        self.structure.nodes[index] = node;
        if self.random.chance(0.3) {
            let (ground, stiffness) = (self.structure.clamp([x, 0.0]), self.stiffness());
            self.structure.spring_along(index, ground, [0.0, 1.0], stiffness);
        }
        if self.random.chance(0.2) {
            let (ground, stiffness) = (self.structure.clamp([x, 0.0]), self.stiffness());
            self.structure.torsion_spring(index, ground, stiffness);
        }
    }

    /// A spring between two nodes: beside a beam, or a loop.
    fn spring_between(&mut self, nodes: usize) {
        let from = self.random.below(nodes);
        let to = (from + 1 + self.random.below(nodes - 1)) % nodes;
        let stiffness = self.stiffness();
        if self.random.chance(0.4) {
            return self.structure.torsion_spring(from, to, stiffness);
        }
        let [from, to] = [from, to].map(|node| {
            let [x, _] = self.structure.nodes[node].position;
            let end = End::from(node);
            if self.random.chance(0.5) { end.at([x + 0.25, 0.0]) } else { end }
        });
        self.structure.spring_along(from, to, [0.0, 1.0], stiffness);
    }
}
