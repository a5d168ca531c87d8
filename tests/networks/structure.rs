//! Plane structures as plain numbers: what tests describe once for the library and for its oracles.

/// A set of displacements: of a node along the global axes, of the end of a member along its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Freedoms {
    pub(crate) x: bool,
    pub(crate) y: bool,
    pub(crate) rz: bool,
}

impl Freedoms {
    pub(crate) const NONE: Self = Freedoms { x: false, y: false, rz: false };
    pub(crate) const X: Self = Freedoms { x: true, ..Freedoms::NONE };
    pub(crate) const Y: Self = Freedoms { y: true, ..Freedoms::NONE };
    pub(crate) const RZ: Self = Freedoms { rz: true, ..Freedoms::NONE };
    pub(crate) const PIN: Self = Freedoms { x: true, y: true, rz: false };
    pub(crate) const ALL: Self = Freedoms { x: true, y: true, rz: true };

    pub(crate) fn union(self, other: Self) -> Self {
        Freedoms { x: self.x || other.x, y: self.y || other.y, rz: self.rz || other.rz }
    }

    pub(crate) fn is_empty(self) -> bool {
        self == Freedoms::NONE
    }
}

/// A node: a point, or a rigid body whose displacements are those of its material point at `position`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) position: [f64; 2],
    /// Displacements that are held, along the global axes.
    pub(crate) held: Freedoms,
    /// The direction along which the node moves; across it the node is held.
    pub(crate) along: Option<[f64; 2]>,
    pub(crate) mass: f64,
    /// Inertia about the mass centre.
    pub(crate) inertia: f64,
    /// Position of the mass centre.
    pub(crate) centre: [f64; 2],
}

impl Node {
    pub(crate) fn at(position: [f64; 2]) -> Self {
        Node { position, held: Freedoms::NONE, along: None, mass: 0.0, inertia: 0.0, centre: position }
    }

    pub(crate) fn held(self, held: Freedoms) -> Self {
        Node { held: self.held.union(held), ..self }
    }

    pub(crate) fn along(self, direction: [f64; 2]) -> Self {
        Node { along: Some(direction), ..self }
    }

    pub(crate) fn body(self, mass: f64, inertia: f64, centre: [f64; 2]) -> Self {
        Node { mass, inertia, centre, ..self }
    }
}

/// The end of a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct End {
    pub(crate) node: usize,
    /// Where the end is, tied rigidly to its node; absent, at the node.
    pub(crate) position: Option<[f64; 2]>,
    /// Displacements along the member's axes that the end does not share with its node.
    pub(crate) released: Freedoms,
}

impl From<usize> for End {
    fn from(node: usize) -> Self {
        End { node, position: None, released: Freedoms::NONE }
    }
}

impl End {
    pub(crate) fn at(self, position: [f64; 2]) -> Self {
        End { position: Some(position), ..self }
    }

    pub(crate) fn releasing(self, released: Freedoms) -> Self {
        End { released: self.released.union(released), ..self }
    }
}

/// What is between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Element {
    /// Bends as an Euler-Bernoulli beam and stretches as a rod.
    Beam(Section),
    /// A massless spring between two points, along a direction.
    Spring { stiffness: f64 },
    /// A massless spring between the rotations of two nodes.
    TorsionSpring { stiffness: f64 },
    /// Springs between two points at one place: along a direction, across it and of the rotations.
    Hinge { stiffness: [f64; 3] },
    /// Two points at one place share freedoms.
    Weld { freedoms: Freedoms },
    /// A dashpot between two points, along a direction.
    Damper { damping: f64 },
    /// A dashpot between the rotations of two nodes.
    TorsionDamper { damping: f64 },
}

/// The section of a beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Section {
    pub(crate) axial_stiffness: f64,
    pub(crate) bending_stiffness: f64,
    pub(crate) mass_per_length: f64,
}

impl Section {
    /// A section as stiff in both ways as `factor` of these.
    pub(crate) fn times(self, factor: f64) -> Self {
        Section {
            axial_stiffness: factor * self.axial_stiffness,
            bending_stiffness: factor * self.bending_stiffness,
            ..self
        }
    }
}

/// An element between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Member {
    pub(crate) ends: [End; 2],
    /// The direction in which a spring or a dashpot acts; absent, from end to end.
    pub(crate) along: Option<[f64; 2]>,
    pub(crate) element: Element,
}

/// A plane structure.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Structure {
    pub(crate) nodes: Vec<Node>,
    pub(crate) members: Vec<Member>,
}

impl Structure {
    /// Adds a node.
    pub(crate) fn node(&mut self, node: Node) -> usize {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    /// Adds a node that holds all displacements.
    pub(crate) fn clamp(&mut self, position: [f64; 2]) -> usize {
        self.node(Node::at(position).held(Freedoms::ALL))
    }

    /// Adds a beam.
    pub(crate) fn beam(&mut self, from: impl Into<End>, to: impl Into<End>, section: Section) {
        let element = Element::Beam(section);
        self.members.push(Member { ends: [from.into(), to.into()], along: None, element });
    }

    /// Adds a spring along the line through both ends.
    pub(crate) fn spring(&mut self, from: impl Into<End>, to: impl Into<End>, stiffness: f64) {
        let element = Element::Spring { stiffness };
        self.members.push(Member { ends: [from.into(), to.into()], along: None, element });
    }

    /// Adds a spring that acts in a direction.
    pub(crate) fn spring_along(
        &mut self,
        from: impl Into<End>,
        to: impl Into<End>,
        direction: [f64; 2],
        stiffness: f64,
    ) {
        let element = Element::Spring { stiffness };
        self.members.push(Member { ends: [from.into(), to.into()], along: Some(direction), element });
    }

    /// Adds a spring between the rotations of two nodes.
    pub(crate) fn torsion_spring(&mut self, from: usize, to: usize, stiffness: f64) {
        let element = Element::TorsionSpring { stiffness };
        self.members.push(Member { ends: [from.into(), to.into()], along: None, element });
    }

    /// Adds an elastic hinge at a place of both ends.
    pub(crate) fn hinge(&mut self, from: impl Into<End>, to: impl Into<End>, direction: [f64; 2], stiffness: [f64; 3]) {
        let element = Element::Hinge { stiffness };
        self.members.push(Member { ends: [from.into(), to.into()], along: Some(direction), element });
    }

    /// Makes two points at one place share freedoms.
    pub(crate) fn weld(&mut self, from: impl Into<End>, to: impl Into<End>, freedoms: Freedoms) {
        let element = Element::Weld { freedoms };
        self.members.push(Member { ends: [from.into(), to.into()], along: None, element });
    }

    /// Where an end is.
    pub(crate) fn position(&self, end: &End) -> [f64; 2] {
        end.position.unwrap_or(self.nodes[end.node].position)
    }
}
