//! A system as finite elements see it: beams between nodes, and what is lumped at their unknowns.

/// Deflection and rotation of a node as numbers of unknowns; `None` where a support holds it.
pub type Node = [Option<usize>; 2];

/// A node that a pin holds: its rotation is the unknown of this number.
pub fn pinned(rotation: usize) -> Node {
    [None, Some(rotation)]
}

/// A node whose deflection is the unknown of this number, its rotation the next.
pub fn free(deflection: usize) -> Node {
    [Some(deflection), Some(deflection + 1)]
}

/// A node that is clamped.
pub const FIXED: Node = [None, None];

/// A uniform beam between two nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Length l \[m\]
    pub length: f64,
    /// Bending stiffness EI [N m²]
    pub bending_stiffness: f64,
    /// Mass per length m [kg/m]
    pub mass_per_length: f64,
    /// Its two nodes.
    pub nodes: [Node; 2],
}

/// Which of the three matrices something adds to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matrix {
    /// K
    Stiffness,
    /// C
    Damping,
    /// M
    Mass,
}

/// A spring, dashpot, mass or inertia: the form `value (Σ factor · unknown)²` of twice the energy, or of the dissipation.
#[derive(Clone, Debug, PartialEq)]
pub struct Lumped {
    /// The matrix.
    pub matrix: Matrix,
    /// Stiffness, damping, mass or moment of inertia.
    pub value: f64,
    /// Unknowns with their factors.
    pub factors: Vec<(usize, f64)>,
}

impl Lumped {
    /// A form of one unknown: grounded springs, point masses, inertias.
    pub fn at(matrix: Matrix, unknown: usize, value: f64) -> Self {
        Lumped { matrix, value, factors: vec![(unknown, 1.0)] }
    }

    /// A form of the difference of two unknowns: springs and dashpots between them.
    pub fn between(matrix: Matrix, unknowns: [usize; 2], value: f64) -> Self {
        Lumped { matrix, value, factors: vec![(unknowns[0], 1.0), (unknowns[1], -1.0)] }
    }

    /// A rigid body at a node `free(deflection)`: its mass moves with `y + centre θ`, its inertia is about the mass centre.
    pub fn body(deflection: usize, mass: f64, inertia: f64, centre: f64) -> [Self; 2] {
        let factors = vec![(deflection, 1.0), (deflection + 1, centre)];
        [Lumped { matrix: Matrix::Mass, value: mass, factors }, Lumped::at(Matrix::Mass, deflection + 1, inertia)]
    }
}

/// Beams and lumped elements over numbered unknowns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Structure {
    /// The beams, along each path.
    pub spans: Vec<Span>,
    /// What is lumped at nodes.
    pub lumped: Vec<Lumped>,
}

impl Structure {
    /// One more than the largest number of an unknown.
    fn count(&self) -> usize {
        let nodal = self.spans.iter().flat_map(|span| span.nodes.into_iter().flatten().flatten());
        let lumped = self.lumped.iter().flat_map(|form| form.factors.iter().map(|pair| pair.0));
        nodal.chain(lumped).max().map_or(0, |last| last + 1)
    }

    /// The same system with every beam cut into equal parts.
    pub fn refined(&self, parts: usize) -> Structure {
        let mut next = self.count();
        let mut spans = Vec::with_capacity(self.spans.len() * parts);
        for span in &self.spans {
            let mut start = span.nodes[0];
            for part in 1..=parts {
                let end = if part == parts { span.nodes[1] } else { free(next) };
                next += if part == parts { 0 } else { 2 };
                spans.push(Span { length: span.length / parts as f64, nodes: [start, end], ..*span });
                start = end;
            }
        }
        Structure { spans, lumped: self.lumped.clone() }
    }
}
