//! Families over decades: each breaks a rule of units or of pivots that looks right.

use super::named::{
    free_square, hinged_zigzag, ladder, mass_on_springs, portal, portal_on_sliders, portal_with_ties, ring, storeys,
};
use super::{Named, section};
use crate::equivalents::{reversed, shuffled_structure};
use crate::structure::{End, Freedoms, Node, Section, Structure};

/// Structures of one kind.
#[derive(Debug)]
pub(crate) struct Family {
    pub(crate) name: &'static str,
    pub(crate) structures: Vec<Named>,
}

/// Every so many decades of 1e-12 to 1e12.
pub(crate) fn decades(step: usize) -> impl Iterator<Item = f64> + Clone {
    (-12..=12).step_by(step).map(|decade| 10f64.powi(decade))
}

/// The structures that a function makes of numbers.
fn family(name: &'static str, scale: impl Iterator<Item = f64>, structure: impl Fn(f64) -> Structure) -> Family {
    Family { name, structures: scale.map(|k| (format!("{name}({k:e})"), structure(k))).collect() }
}

/// All families at every so many decades.
pub(crate) fn families(step: usize) -> Vec<Family> {
    let scale = || decades(step);
    let no_larger = |limit: f64| decades(step).filter(move |&k| k <= limit);
    let upwards = || (0..=20).step_by(step).map(|decade| 10f64.powi(decade));
    vec![
        family("portal of EA/EI", scale(), |k| portal(k, 1.0)),
        family("portal of girder", scale(), |k| portal(1e4, k)),
        family("two sliders", scale(), portal_on_sliders),
        family("six hinges of springs", scale(), |k| hinged_zigzag(6, k)),
        family("twenty hinges of springs", scale(), |k| hinged_zigzag(20, k)),
        family("ten soft hinges", scale(), |k| zigzag_on_joints(10, [1e6, 1e6, k])),
        family("ten soft joints", scale(), |k| zigzag_on_joints(10, [k; 3])),
        family("ten joints soft across", scale(), |k| zigzag_on_joints(10, [1e6, k, 1e3])),
        family("mass on a stiff spring", upwards(), mass_on_springs),
        family("the same, reversed", upwards(), |k| reversed(&mass_on_springs(k))),
        family("ladder of 5 bays, rungs", scale(), |k| ladder(5, k)),
        family("stiff ties", no_larger(1.0), |k| portal_with_ties(k, false)),
        family("hinged ties", no_larger(1.0), |k| portal_with_ties(k, true)),
        family("tower with cables", no_larger(1.0), |k| tower(6, k)),
        family("free storeys, columns", scale(), |k| free_storeys(3, 2, k)),
        family("free ladder, rungs", scale(), |k| free_ladder(5, k)),
        family("square on soft springs", scale(), |k| moored(free_square(1e4), [0, 1, 2, 3], k)),
        family("ring on soft springs", scale(), |k| moored(ring(9), [0, 2, 5, 7], k)),
        family("hub of levers", scale(), hub_of_levers),
        family("shuffled sliders", scale(), |k| shuffled_structure(&portal_on_sliders(k), k.to_bits())),
        family("shuffled ladder", scale(), |k| shuffled_structure(&ladder(5, k), k.to_bits())),
        family("shuffled tower", no_larger(1.0), |k| shuffled_structure(&tower(6, k), k.to_bits())),
        family("shuffled moored ring", scale(), |k| shuffled_structure(&moored(ring(9), [0, 2, 5, 7], k), k.to_bits())),
    ]
}

/// A zigzag between two clamps on joints of springs along, across and about each joint's own direction.
fn zigzag_on_joints(members: usize, stiffness: [f64; 3]) -> Structure {
    let mut structure = Structure::default();
    let mut from = structure.clamp([0.0, 0.0]);
    for index in 1..=members {
        let position = [0.7 * index as f64, if index % 2 == 0 { 0.0 } else { 0.4 }];
        let end = if index == members { structure.clamp(position) } else { structure.node(Node::at(position)) };
        structure.beam(from, end, section(1e4));
        if index < members {
            from = structure.node(Node::at(position));
            structure.hinge(end, from, [3.0, index as f64], stiffness);
        }
    }
    structure
}

/// A tower of two legs and braces with cables from its head to the ground: released at their ends, and all but without
/// bending stiffness.
fn tower(levels: usize, bending_stiffness: f64) -> Structure {
    let mut structure = ladder(levels, 1.0);
    let cable = Section { axial_stiffness: 1e3, bending_stiffness, mass_per_length: 0.02 };
    let brace = Section { axial_stiffness: 1e3, bending_stiffness, mass_per_length: 0.05 };
    let hinged = |node: usize| End::from(node).releasing(Freedoms::RZ);
    for level in 0..levels {
        let [left, right] = [2 * level, 2 * level + 3];
        structure.beam(hinged(left), hinged(right), brace);
    }
    let head = 2 * levels;
    for (node, x, y) in [(head, 0.6, -4.0), (head + 1, 0.4, 5.0)] {
        let anchor = structure.clamp([x, y]);
        structure.beam(hinged(node), hinged(anchor), cable);
    }
    structure
}

/// Storeys whose feet are free.
pub(crate) fn free_storeys(levels: usize, bays: usize, columns: f64) -> Structure {
    let mut structure = storeys(levels, bays);
    for node in &mut structure.nodes {
        node.held = Freedoms::NONE;
    }
    let feet = bays + 1;
    for member in &mut structure.members {
        let is_column = member.ends[1].node == member.ends[0].node + feet;
        if let (true, crate::structure::Element::Beam(section)) = (is_column, &mut member.element) {
            *section = section.times(columns);
        }
    }
    structure
}

/// A ladder that nothing holds.
pub(crate) fn free_ladder(bays: usize, rungs: f64) -> Structure {
    let mut structure = ladder(bays, rungs);
    for node in &mut structure.nodes {
        node.held = Freedoms::NONE;
    }
    structure
}

/// A structure whose nodes are moored to the ground by springs.
fn moored(mut structure: Structure, nodes: [usize; 4], stiffness: f64) -> Structure {
    for (node, direction) in nodes.into_iter().zip([[1.0, 0.0], [0.0, 1.0], [3.0, 4.0], [-5.0, 12.0]]) {
        let ground = structure.clamp(structure.nodes[node].position);
        structure.spring_along(node, ground, direction, stiffness);
    }
    structure
}

/// A wheel on an axle with springs at its rim and beams on levers; the rest of the rim is on a spring of some stiffness.
fn hub_of_levers(stiffness: f64) -> Structure {
    let mut structure = Structure::default();
    let hub = structure.node(Node::at([0.0, 0.0]).held(Freedoms::PIN).body(0.3, 0.7, [0.2, 0.1]));
    let left = structure.clamp([-3.0, 0.5]);
    let right = structure.node(Node::at([3.0, 0.25]));
    let rim = |x: f64, y: f64| End::from(hub).at([x, y]);
    structure.beam(left, rim(-1.5, 0.5), section(1e4));
    structure.beam(rim(1.5, 0.25), right, section(1e4));
    for (x, y) in [(0.5, 1.0), (-0.5, 1.0), (0.25, -1.25)] {
        let ground = structure.clamp([2.0 * x, 2.0 * y + 0.25]);
        structure.spring(rim(x, y), ground, stiffness);
    }
    structure
}
