//! How well a recorded shape keeps the laws of its sketch: boundary conditions, geometry and forces at connections, and the
//! relation between the ends of each element, all from the formulas of the elements and none from the library.

use crate::mode_shapes::recorded::{C, Ends, Recorded};
use crate::mode_shapes::sketch::{Node, Sketch};
use crate::mode_shapes::waves::Section;
use mstmm::element::State;
use std::collections::BTreeMap;

/// A law that a shape keeps worst.
#[derive(Clone, Debug, Default)]
pub(crate) struct Worst {
    /// Relative to the largest scaled entry of the shape.
    pub(crate) size: f64,
    pub(crate) of: String,
}

/// Units of the entries `[Y, Θ, M, Q]`.
type Units = [f64; 4];

struct Audit<'a> {
    sketch: &'a Sketch,
    recorded: &'a Recorded<'a>,
    /// Units of the elements, node by node; of supports and connections those of what is around.
    units: Vec<Units>,
    worst: Worst,
}

/// The worst residual of all laws.
pub(crate) fn worst_residual(sketch: &Sketch, recorded: &Recorded<'_>) -> Worst {
    let mut audit = Audit { sketch, recorded, units: Vec::new(), worst: Worst::default() };
    audit.units = audit.all_units();
    for node in 0..sketch.nodes.len() {
        match &sketch.nodes[node] {
            Node::Support(kind) => audit.support(node, kind),
            Node::Connection(name) => audit.connection(node, name),
            Node::Element { kind, name, parameters } => audit.element(node, kind, name, parameters),
        }
    }
    let scale = audit.scale();
    Worst { size: audit.worst.size / scale, of: audit.worst.of }
}

pub(crate) fn entries(state: &State<C>) -> [C; 4] {
    [state.y, state.theta, state.m, state.q]
}

fn larger(a: Units, b: Units) -> Units {
    core::array::from_fn(|k| a[k].max(b[k]))
}

/// Which of `[Y, Θ]` an element carries.
pub(crate) fn carries(kind: &str) -> [bool; 2] {
    match kind {
        "spring" | "damper" | "mass" => [true, false],
        "torsion_spring" | "torsion_damper" | "inertia" => [false, true],
        _ => [true, true],
    }
}

/// Which of `[Y, Θ]` a support holds.
fn holds(kind: &str) -> [bool; 2] {
    match kind {
        "fixed" => [true, true],
        "pinned" => [true, false],
        "guided" => [false, true],
        _ => [false, false],
    }
}

/// The beam of an element's parameters.
pub(crate) fn section(parameters: &BTreeMap<String, f64>, lambda_squared: C) -> Section {
    Section::new(parameters["length"], parameters["bending_stiffness"], parameters["mass_per_length"], lambda_squared)
}

/// `K + Cλ` of a parallel pair; each of them is zero where the element has none.
fn stiffness(parameters: &BTreeMap<String, f64>, lambda: C) -> C {
    let of = |name: &str| parameters.get(name).copied().unwrap_or(0.0);
    lambda * of("damping") + of("stiffness")
}

impl Audit<'_> {
    fn own_units(&self, node: usize) -> Units {
        let Node::Element { kind, parameters, .. } = &self.sketch.nodes[node] else { return [0.0; 4] };
        let (squared, lambda) = (self.recorded.lambda_squared, self.recorded.lambda);
        let inertial = |name: &str| (squared * parameters[name]).norm();
        // spring and damper may cancel, not their sizes
        let of = |name: &str| parameters.get(name).copied().unwrap_or(0.0);
        let kappa = of("stiffness") + of("damping") * lambda.norm();
        let (y, theta) = match kind.as_str() {
            "beam" => return section(parameters, squared).units(),
            "spring" | "damper" => (kappa, 0.0),
            "mass" => (inertial("mass"), 0.0),
            "inertia" => (0.0, inertial("inertia")),
            "body" | "point_mass" => (inertial("mass"), inertial("inertia")),
            "hinge" => (parameters["stiffness_y"], parameters["stiffness_rz"]),
            _ => (0.0, kappa),
        };
        [1.0, 1.0, theta, y]
    }

    fn neighbours(&self, node: usize) -> impl Iterator<Item = usize> {
        self.sketch.before(node).chain(self.sketch.after(node))
    }

    /// Units of beams are those of whatever is next to them, and so on; without beams those of the largest element are.
    fn all_units(&self) -> Vec<Units> {
        let is_beam = |node: &Node| matches!(node, Node::Element { kind, .. } if kind == "beam");
        let has_beams = self.sketch.nodes.iter().any(is_beam);
        let all = 0..self.sketch.nodes.len();
        let own = |node| if has_beams && !is_beam(&self.sketch.nodes[node]) { [0.0; 4] } else { self.own_units(node) };
        let mut units: Vec<Units> = all.clone().map(own).collect();
        if !has_beams {
            let largest = units.iter().copied().fold([0.0; 4], larger);
            return vec![largest; units.len()];
        }
        for _ in all.clone() {
            let around = |node| self.neighbours(node).fold([0.0; 4], |sum, other| larger(sum, units[other]));
            let new = all.clone().map(|node| if units[node] == [0.0; 4] { around(node) } else { units[node] });
            units = new.collect();
        }
        units
    }

    /// The largest entry at any end, scaled.
    fn scale(&self) -> f64 {
        let mut scale = 0.0_f64;
        for (node, units) in self.sketch.nodes.iter().zip(&self.units) {
            let Node::Element { name, .. } = node else { continue };
            let Ends { input, output, .. } = self.ends(name);
            for (entry, unit) in entries(input).iter().chain(&entries(output)).zip(units.iter().chain(units)) {
                if *unit > 0.0 {
                    scale = scale.max(entry.norm() / unit);
                }
            }
        }
        scale
    }

    fn ends(&self, name: &str) -> &Ends<'_> {
        &self.recorded.elements[name]
    }

    /// Keeps a residual of one coordinate at a node.
    fn keep(&mut self, node: usize, coordinate: usize, residual: C, of: impl FnOnce() -> String) {
        let unit = self.units[node][coordinate];
        let size = if residual.norm() == 0.0 { 0.0 } else { residual.norm() / unit };
        if size > self.worst.size || size.is_nan() {
            self.worst = Worst { size, of: format!("{}, entry {coordinate}", of()) };
        }
    }

    /// The state at an arrow.
    fn at_arrow(&self, from: usize, to: usize) -> Option<State<C>> {
        match (&self.sketch.nodes[from], &self.sketch.nodes[to]) {
            (Node::Element { name, .. }, _) => Some(self.ends(name).output),
            (_, Node::Element { name, .. }) => Some(self.ends(name).input),
            (Node::Connection(name), Node::Connection(_)) => Some(self.recorded.connections[name.as_str()]),
            _ => None,
        }
    }

    /// A support at the end of an element; at a connection it is part of that.
    fn support(&mut self, node: usize, kind: &str) {
        let beside = self.neighbours(node).next().unwrap();
        let Node::Element { kind: element, name, .. } = &self.sketch.nodes[beside] else { return };
        let state = if self.sketch.after(node).is_some() { self.ends(name).input } else { self.ends(name).output };
        for (k, (held, carried)) in holds(kind).into_iter().zip(carries(element)).enumerate() {
            let entry = if held { k } else { 3 - k };
            if carried {
                self.keep(beside, entry, entries(&state)[entry], || format!("{kind} at {name}"));
            }
        }
    }

    /// Which of `[Y, Θ]` the state of a connection has: those of the elements around it and of connections that lead to it.
    fn width(&self, connection: usize) -> [bool; 2] {
        let mut width = [false; 2];
        let mut add = |other: [bool; 2]| width = core::array::from_fn(|k| width[k] || other[k]);
        for node in self.sketch.before(connection) {
            match &self.sketch.nodes[node] {
                Node::Element { kind, .. } => add(carries(kind)),
                Node::Connection(_) => add(self.width(node)),
                Node::Support(_) => {}
            }
        }
        if let Some(Node::Element { kind, .. }) = self.sketch.after(connection).map(|node| &self.sketch.nodes[node]) {
            add(carries(kind));
        }
        width
    }

    /// Which of `[Y, Θ]` goes along an arrow at a connection.
    fn carried(&self, from: usize, to: usize) -> [bool; 2] {
        match (&self.sketch.nodes[from], &self.sketch.nodes[to]) {
            (Node::Element { kind, .. }, _) | (_, Node::Element { kind, .. }) => carries(kind),
            _ => self.width(from),
        }
    }

    /// Displacements of all paths are equal, and zero where a support holds them; forces add up where none does.
    fn connection(&mut self, node: usize, name: &str) {
        let arrows: Vec<(usize, usize)> =
            self.sketch.arrows.iter().copied().filter(|(from, to)| *from == node || *to == node).collect();
        let width = self.width(node);
        for k in (0..2).filter(|k| width[*k]) {
            let mut forces = C::new(0.0, 0.0);
            let mut displacement = None;
            let mut is_held = false;
            for &(from, to) in &arrows {
                let other = if from == node { to } else { from };
                if let Node::Support(kind) = &self.sketch.nodes[other] {
                    is_held |= holds(kind)[k];
                    continue;
                }
                let Some(state) = self.at_arrow(from, to).filter(|_| self.carried(from, to)[k]) else { continue };
                let state = entries(&state);
                forces += if to == node { state[3 - k] } else { -state[3 - k] };
                let first = *displacement.get_or_insert(state[k]);
                self.keep(node, k, state[k] - first, || format!("displacements at {name}"));
            }
            if is_held {
                self.keep(node, k, displacement.unwrap(), || format!("support at {name}"));
            } else {
                self.keep(node, 3 - k, forces, || format!("forces at {name}"));
            }
        }
        self.state_of_connection(node, name);
    }

    /// The state that is told of a connection is that which goes on.
    fn state_of_connection(&mut self, node: usize, name: &str) {
        let told = entries(&self.recorded.connections[name]);
        let after = self.sketch.after(node).unwrap();
        let Some(state) = self.at_arrow(node, after) else { return };
        for (k, entry) in entries(&state).into_iter().enumerate() {
            self.keep(node, k, told[k] - entry, || format!("state of {name}"));
        }
    }

    fn element(&mut self, node: usize, kind: &str, name: &str, parameters: &BTreeMap<String, f64>) {
        let Ends { input, output, .. } = self.ends(name);
        let (input, output) = (*input, *output);
        let before = self.sketch.before(node).next().map(|before| &self.sketch.nodes[before]);
        if let Some(Node::Element { name: other, .. }) = before {
            let upstream = entries(&self.ends(other).output);
            for (k, entry) in entries(&input).into_iter().enumerate() {
                self.keep(node, k, entry - upstream[k], || format!("{other} to {name}"));
            }
        }
        let unused = carries(kind).map(|carried| !carried);
        for k in (0..2).filter(|k| unused[*k]) {
            for state in [input, output].map(|state| entries(&state)) {
                assert!(state[k].norm() == 0.0 && state[3 - k].norm() == 0.0, "{name} carries no entry {k}: {state:?}");
            }
        }
        if kind == "beam" {
            return self.beam(node, name, &section(parameters, self.recorded.lambda_squared), &input, &output);
        }
        for (k, residual) in self.law(kind, parameters, [&input, &output], self.units[node]) {
            self.keep(node, k, residual, || format!("law of {name}"));
        }
    }

    /// Residuals of the equations of an element without waves, each with the entry in whose units it is; those of springs
    /// are in forces, so that nothing divides by a stiffness.
    fn law(
        &self,
        kind: &str,
        parameters: &BTreeMap<String, f64>,
        [input, output]: [&State<C>; 2],
        units: Units,
    ) -> Vec<(usize, C)> {
        let squared = self.recorded.lambda_squared;
        let kappa = stiffness(parameters, self.recorded.lambda);
        let of = |name: &str| parameters.get(name).copied().unwrap_or(0.0);
        let [y, theta, m, q] = [output.y - input.y, output.theta - input.theta, output.m - input.m, output.q - input.q];
        // of what is stiffer than all around it the elongation is known to rounding, not the force
        let [_, turn, moment, force] = units;
        let soft = |residual: C, kappa: C, unit: f64| residual / (kappa.norm() / unit).max(1.0);
        match kind {
            "spring" | "damper" => vec![(3, q), (3, soft(input.q + kappa * y, kappa, force))],
            "torsion_spring" | "torsion_damper" => {
                vec![(2, m), (2, soft(input.m - kappa * theta, kappa, moment / turn))]
            }
            "hinge" => {
                let [ky, kt] = ["stiffness_y", "stiffness_rz"].map(|name| C::new(of(name), 0.0));
                let twist = soft(input.m - kt * theta, kt, moment / turn);
                vec![(2, m), (2, twist), (3, q), (3, soft(input.q + ky * y, ky, force))]
            }
            "mass" | "inertia" | "point_mass" => {
                let (moment, force) = (squared * of("inertia") * input.theta, squared * of("mass") * input.y);
                vec![(0, y), (1, theta), (2, m - moment), (3, q + force)]
            }
            "body" => {
                let (mass, b, c) = (of("mass"), of("output_x"), of("centre_x"));
                let lever = squared * (mass * (b - c)) * input.y;
                let inertial = squared * (of("inertia") - mass * b * c) * input.theta;
                vec![
                    (0, y - input.theta * b),
                    (1, theta),
                    (2, m + lever - inertial - input.q * b),
                    (3, q + squared * mass * (input.y + input.theta * c)),
                ]
            }
            _ => panic!("{kind} has no law here"),
        }
    }

    /// Four relations between the ends of a beam, and the states inside.
    fn beam(&mut self, node: usize, name: &str, section: &Section, input: &State<C>, output: &State<C>) {
        let units = section.units();
        if section.is_short() {
            let arrived = section.series(input, section.length);
            for (k, entry) in entries(output).into_iter().enumerate() {
                self.keep(node, k, entry - arrived[k], || format!("ends of {name}"));
            }
        } else {
            for mismatch in section.mismatches(input, output) {
                self.keep(node, 0, mismatch, || format!("waves of {name}"));
            }
        }
        for part in [0.0, 0.013, 0.28, 0.5, 0.77, 0.991, 1.0] {
            let distance = part * section.length;
            let expected = if section.is_short() {
                section.series(input, distance)
            } else {
                section.inside(input, output, distance)
            };
            let told = entries(&(self.ends(name).along)(distance));
            for k in 0..4 {
                let residual = (told[k] - expected[k]) / units[k];
                self.keep(node, 0, residual, || format!("inside of {name} at {part}"));
            }
        }
    }
}
