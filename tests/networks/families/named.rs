//! Structures with a name.

use super::section;
use crate::structure::{End, Freedoms, Node, Section, Structure};

/// An inclined portal with clamped feet; the girder is so many times as stiff as the legs.
pub(crate) fn portal(axial_stiffness: f64, girder: f64) -> Structure {
    let (mut structure, [left, right]) = legs(axial_stiffness);
    structure.beam(left, right, section(axial_stiffness).times(girder));
    structure
}

/// The inclined legs of a portal, and the nodes at their upper ends.
fn legs(axial_stiffness: f64) -> (Structure, [usize; 2]) {
    let mut structure = Structure::default();
    let feet = [[0.0, 0.0], [3.0, 0.0]].map(|position| structure.clamp(position));
    let corners = [[0.3, 2.0], [3.3, 2.5]].map(|position| structure.node(Node::at(position)));
    for (foot, corner) in feet.into_iter().zip(corners) {
        structure.beam(foot, corner, section(axial_stiffness));
    }
    (structure, corners)
}

/// A portal whose girder slides along itself on both legs, but for two springs: two parallel sliders.
pub(crate) fn portal_on_sliders(stiffness: f64) -> Structure {
    let (mut structure, [left, right]) = legs(1e4);
    let middle = structure.node(Node::at([1.8, 2.25]));
    for corner in [left, right] {
        let end = End::from(corner).releasing(Freedoms::X);
        structure.beam(end, middle, section(1e4));
        structure.spring(corner, middle, stiffness);
    }
    structure
}

/// A portal with two slender diagonals, stiffly joined or hinged.
pub(crate) fn portal_with_ties(bending_stiffness: f64, is_hinged: bool) -> Structure {
    let mut structure = portal(1e4, 1.0);
    let tie = Section { axial_stiffness: 1e3, bending_stiffness, mass_per_length: 0.01 };
    let released = if is_hinged { Freedoms::RZ } else { Freedoms::NONE };
    for [foot, corner] in [[0, 3], [1, 2]] {
        structure.beam(End::from(foot).releasing(released), End::from(corner).releasing(released), tie);
    }
    structure
}

/// A zigzag between two clamps, whose joints are elastic hinges: stiff springs along both axes and a soft torsion spring
/// between two nodes at one place.
pub(crate) fn hinged_zigzag(members: usize, stiffness: f64) -> Structure {
    let mut structure = Structure::default();
    let mut from = structure.clamp([0.0, 0.0]);
    for index in 1..=members {
        let position = [0.7 * index as f64, if index % 2 == 0 { 0.0 } else { 0.4 }];
        if index == members {
            let clamp = structure.clamp(position);
            structure.beam(from, clamp, section(1e4));
            break;
        }
        let [before, behind] = [0, 1].map(|_| structure.node(Node::at(position)));
        structure.beam(from, before, section(1e4));
        structure.spring_along(before, behind, [1.0, 0.0], 1e6);
        structure.spring_along(before, behind, [0.0, 1.0], 1e6);
        structure.torsion_spring(before, behind, stiffness);
        from = behind;
    }
    structure
}

/// A frame with a lone mass on a spring of any stiffness at an angle, which softer springs hold too.
pub(crate) fn mass_on_springs(stiffness: f64) -> Structure {
    let mut structure = Structure::default();
    let clamp = structure.clamp([0.0, 0.0]);
    let left = structure.node(Node::at([0.4, 1.0]));
    let right = structure.node(Node::at([1.6, 1.2]));
    let pin = structure.node(Node::at([1.9, 0.0]).held(Freedoms::PIN));
    for ends in [[clamp, left], [left, right], [right, pin]] {
        structure.beam(ends[0], ends[1], section(1e4));
    }
    let place = [2.5, 1.4];
    let mass = structure.node(Node::at(place).held(Freedoms::RZ).body(0.7, 0.0, place));
    let ground = structure.clamp(place);
    structure.spring_along(right, mass, [0.28, 0.96], stiffness);
    structure.spring_along(mass, ground, [-0.96, 0.28], 3.0);
    structure.spring_along(mass, ground, [0.28, 0.96], 1e-3);
    structure
}

/// A ladder of bays, clamped at one end; its rungs are so many times as stiff as its stringers.
pub(crate) fn ladder(bays: usize, rungs: f64) -> Structure {
    let mut structure = Structure::default();
    let mut last = [[0.0, 0.0], [0.0, 1.0]].map(|position| structure.clamp(position));
    for bay in 1..=bays {
        let x = bay as f64;
        let bend = if bay % 2 == 0 { 0.0 } else { 0.1 };
        let next = [[x, bend], [x, 1.0]].map(|position| structure.node(Node::at(position)));
        for side in 0..2 {
            structure.beam(last[side], next[side], section(1e4));
        }
        structure.beam(next[0], next[1], section(1e4).times(rungs));
        last = next;
    }
    structure
}

/// A frame of storeys and bays with clamped columns.
pub(crate) fn storeys(levels: usize, bays: usize) -> Structure {
    let mut structure = Structure::default();
    let mut below: Vec<usize> = (0..=bays).map(|column| structure.clamp([1.3 * column as f64, 0.0])).collect();
    for level in 1..=levels {
        let node = |column: usize| Node::at([1.3 * column as f64, level as f64]);
        let above: Vec<usize> = (0..=bays).map(|column| structure.node(node(column))).collect();
        for (foot, head) in below.iter().zip(&above) {
            structure.beam(*foot, *head, section(1e4));
        }
        for pair in above.windows(2) {
            structure.beam(pair[0], pair[1], section(1e4));
        }
        below = above;
    }
    structure
}

/// A cantilever of members at 60 and 30 degrees in turn.
pub(crate) fn zigzag(members: usize) -> Structure {
    let mut structure = Structure::default();
    let (mut last, mut place) = (structure.clamp([0.0, 0.0]), [0.0, 0.0]);
    for index in 0..members {
        let angle: f64 = if index % 2 == 0 { 60.0 } else { 30.0 };
        let (sin, cos) = angle.to_radians().sin_cos();
        place = [place[0] + cos, place[1] + sin];
        let next = structure.node(Node::at(place));
        structure.beam(last, next, section(1e4));
        last = next;
    }
    structure
}

/// Eight arms of one length, exactly, on pins: many motions in which the middle rests.
pub(crate) fn star(axial_stiffness: f64) -> Structure {
    let mut structure = Structure::default();
    let middle = structure.node(Node::at([0.0, 0.0]));
    for [x, y] in [[4.0, 3.0], [3.0, 4.0]] {
        for [x, y] in [[x, y], [-x, y], [x, -y], [-x, -y]] {
            let pin = structure.node(Node::at([x, y]).held(Freedoms::PIN));
            structure.beam(middle, pin, section(axial_stiffness));
        }
    }
    structure
}

/// A free ring of members.
pub(crate) fn ring(members: usize) -> Structure {
    let mut structure = Structure::default();
    for index in 0..members {
        let (sin, cos) = (core::f64::consts::TAU * index as f64 / members as f64).sin_cos();
        structure.node(Node::at([cos, sin]));
    }
    for index in 0..members {
        structure.beam(index, (index + 1) % members, section(1e4));
    }
    structure
}

/// A free square frame: rigid motions, and pairs of frequencies.
pub(crate) fn free_square(axial_stiffness: f64) -> Structure {
    let mut structure = Structure::default();
    for position in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        structure.node(Node::at(position));
    }
    for index in 0..4 {
        structure.beam(index, (index + 1) % 4, section(axial_stiffness));
    }
    structure
}
