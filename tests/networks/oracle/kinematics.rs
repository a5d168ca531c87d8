//! The displacements of a structure as forms of its unknowns.

use super::global_matrix::sum;
use super::{Bending, Inertia, Link, Oracle, Rod, double};
use crate::stiffness_matrix::Form;
use crate::structure::{Element, End, Node, Section, Structure};
use mstmm::number::{DoubleDouble, Scalar};

/// A vector of two components.
type Vector = [DoubleDouble; 2];

/// A material point of a rigid body: where it is, and its displacements.
struct Point {
    position: Vector,
    x: Form,
    y: Form,
    rz: Form,
}

fn minus([x, y]: Vector, [other_x, other_y]: Vector) -> Vector {
    [x - other_x, y - other_y]
}

fn length([x, y]: Vector) -> DoubleDouble {
    (x * x + y * y).sqrt()
}

fn unit([x, y]: Vector) -> Vector {
    let length = length([x, y]);
    [x / length, y / length]
}

fn scaled(factor: DoubleDouble, form: &Form) -> Form {
    sum(&Form::new(), factor, form)
}

impl Point {
    /// The point of the same body at another position.
    fn at(&self, position: Vector) -> Self {
        let [dx, dy] = minus(position, self.position);
        Point { position, x: sum(&self.x, -dy, &self.rz), y: sum(&self.y, dx, &self.rz), rz: self.rz.clone() }
    }

    /// Its displacement along a direction of length one.
    fn along(&self, [x, y]: Vector) -> Form {
        sum(&scaled(x, &self.x), y, &self.y)
    }
}

impl Oracle {
    fn unknown(&mut self) -> Form {
        self.unknowns += 1;
        vec![(self.unknowns - 1, double(1.0))]
    }

    fn unless(&mut self, is_held: bool) -> Form {
        if is_held { Form::new() } else { self.unknown() }
    }

    /// The unknowns of a node, and its masses.
    fn node(&mut self, node: &Node) -> Point {
        let (x, y) = match node.along {
            Some(direction) => {
                assert!(!node.held.x && !node.held.y, "{node:?} is held twice");
                let moved = self.unknown();
                let [x, y] = unit(direction.map(double));
                (scaled(x, &moved), scaled(y, &moved))
            }
            None => (self.unless(node.held.x), self.unless(node.held.y)),
        };
        let rz = self.unless(node.held.rz);
        let point = Point { position: node.position.map(double), x, y, rz };
        let centre = point.at(node.centre.map(double));
        for (form, mass) in [(centre.x, node.mass), (centre.y, node.mass), (centre.rz, node.inertia)] {
            if mass != 0.0 {
                self.masses.push(Inertia { form, mass: double(mass) });
            }
        }
        point
    }

    /// `[u, v, θ]` of the end of a member along its axis and across; what is released is an unknown.
    fn end(&mut self, end: &End, point: &Point, [c, s]: Vector) -> [Form; 3] {
        let released = end.released;
        let shared = [point.along([c, s]), point.along([-s, c]), point.rz.clone()];
        let mut index = 0;
        shared.map(|form| {
            index += 1;
            if [released.x, released.y, released.rz][index - 1] { self.unknown() } else { form }
        })
    }

    fn beam(&mut self, ends: &[End; 2], [from, to]: [&Point; 2], section: &Section) {
        let axis = minus(to.position, from.position);
        let (length, direction) = (length(axis), unit(axis));
        let [ea, ei, m] = [section.axial_stiffness, section.bending_stiffness, section.mass_per_length].map(double);
        let [u, v, theta] = self.end(&ends[0], from, direction);
        let [u_out, v_out, theta_out] = self.end(&ends[1], to, direction);
        self.rods.push(Rod { ends: [u, u_out], parameters: [length, ea, m] });
        self.bendings.push(Bending { ends: [v, theta, v_out, theta_out], parameters: [length, ei, m] });
    }

    fn dashpot(&mut self, from: &Form, to: &Form, damping: f64) {
        self.dashpots.push(Link { form: sum(to, double(-1.0), from), stiffness: double(damping) });
    }

    fn link(&mut self, from: &Form, to: &Form, stiffness: f64) {
        self.links.push(Link { form: sum(to, double(-1.0), from), stiffness: double(stiffness) });
    }
}

/// The unknowns of a structure and what joins them.
pub(super) fn model(structure: &Structure) -> Oracle {
    let mut model = Oracle::default();
    let nodes: Vec<Point> = structure.nodes.iter().map(|node| model.node(node)).collect();
    model.nodes = nodes.iter().map(|node| [node.x.clone(), node.y.clone(), node.rz.clone()]).collect();
    for member in &structure.members {
        let point = |end: &End| nodes[end.node].at(structure.position(end).map(double));
        let [from, to] = member.ends.each_ref().map(point);
        assert!(
            matches!(member.element, Element::Beam(_) | Element::Hinge { .. })
                || member.ends.iter().all(|end| end.released.is_empty()),
            "{member:?} has releases"
        );
        let along = || {
            let line = minus(to.position, from.position);
            let direction = unit(member.along.map_or(line, |direction| direction.map(double)));
            [from.along(direction), to.along(direction)]
        };
        match &member.element {
            Element::Beam(section) => model.beam(&member.ends, [&from, &to], section),
            Element::Spring { stiffness } => {
                let [from, to] = along();
                model.link(&from, &to, *stiffness);
            }
            Element::Damper { damping } => {
                let [from, to] = along();
                model.dashpot(&from, &to, *damping);
            }
            Element::TorsionSpring { stiffness } => model.link(&from.rz, &to.rz, *stiffness),
            Element::Hinge { stiffness: [k, across, rotation] } => {
                let [c, s] = unit(member.along.map_or([1.0, 0.0], |direction| direction).map(double));
                let [from, to] = [(&member.ends[0], &from), (&member.ends[1], &to)]
                    .map(|(end, point)| model.end(end, point, [c, s]));
                for (freedom, stiffness) in [k, across, rotation].into_iter().enumerate() {
                    model.link(&from[freedom], &to[freedom], *stiffness);
                }
            }
            Element::TorsionDamper { damping } => model.dashpot(&from.rz, &to.rz, *damping),
            Element::Weld { freedoms } => {
                for (one, other, _) in
                    [(&from.x, &to.x, freedoms.x), (&from.y, &to.y, freedoms.y), (&from.rz, &to.rz, freedoms.rz)]
                        .into_iter()
                        .filter(|tied| tied.2)
                {
                    model.link(one, other, f64::INFINITY);
                }
            }
        }
    }
    model
}
