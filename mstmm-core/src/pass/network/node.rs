//! The nodes of a network: points with what holds them and rigid bodies about them.

use crate::model::FrequencyEstimates;
use crate::number::{Frequency, Parameter, Real, Truth};
use crate::pass::network::frame::unit;
use mstmm_plan::Freedoms;

/// A point of a plane network, with the displacements x, y and the rotation about z.
///
/// ```
/// use mstmm_core::{Node, Support};
/// let foot = Node::at([0.0, 0.0]).held(Support::Pinned.holds());
/// let machine = Node::at([2.0, 3.0]).with_body(150.0, 12.0, [2.0, 3.4]);
/// assert!(foot.mass == 0.0 && machine.inertia == 12.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node<T> {
    /// Its place \[m\].
    pub position: [T; 2],
    /// The freedoms that are held.
    pub held: Freedoms,
    /// The direction along which the node moves, of any length; it is held across. None where x and y are as `held` says.
    pub along: Option<[T; 2]>,
    /// Mass of a rigid body that moves with the node \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia of the body about its mass centre [kg m²], zero or positive.
    pub inertia: T,
    /// Mass centre of the body \[m\].
    pub centre: [T; 2],
}

impl<T: Parameter> Node<T> {
    /// A free point without mass.
    pub fn at(position: [T; 2]) -> Self {
        Node { position, held: Freedoms::NONE, along: None, mass: T::zero(), inertia: T::zero(), centre: position }
    }

    /// The point with freedoms held, such as `Support::Fixed.holds()`.
    #[must_use]
    pub fn held(self, held: Freedoms) -> Self {
        Node { held, ..self }
    }

    /// The point held across a direction, along which it moves.
    #[must_use]
    pub fn along(self, direction: [T; 2]) -> Self {
        Node { along: Some(direction), ..self }
    }

    /// The point with a rigid body: its mass, its moment of inertia about its mass centre, and that centre.
    #[must_use]
    pub fn with_body(self, mass: T, inertia: T, centre: [T; 2]) -> Self {
        Node { mass, inertia, centre, ..self }
    }

    /// The point with a rigid body beside the one that it has: both are one body then.
    pub(crate) fn and_body(self, mass: T, inertia: T, centre: [T; 2]) -> Self
    where
        T: Real,
    {
        let total = self.mass + mass;
        if self.mass.vanishes() && self.inertia.vanishes() {
            return self.with_body(mass, inertia, centre);
        }
        if total.vanishes() {
            return Node { inertia: self.inertia + inertia, ..self };
        }
        // about the common centre: parallel axes
        let [x, y] = [0, 1].map(|k| centre[k] - self.centre[k]);
        let part = mass / total;
        let apart = self.mass * part * (x * x + y * y);
        let centre = [self.centre[0] + part * x, self.centre[1] + part * y];
        Node { mass: total, inertia: self.inertia + inertia + apart, centre, ..self }
    }
}

/// No joint.
pub(super) const NONE: u32 = u32::MAX;

/// What a motion of a node is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shared {
    /// A motion that no joint ties to another node.
    Own,
    /// The motion of another node, to which a rigid joint ties it.
    With {
        /// The other node.
        node: u32,
        /// The index of its motion.
        motion: u8,
    },
    /// None: a rigid joint ties it to a node at rest.
    AtRest,
}

/// The motions that its supports leave a node, each by its displacements x and y and its rotation.
#[derive(Clone, Copy, Debug)]
pub struct Motions<T> {
    directions: [[T; 3]; 3],
    pub(crate) count: usize,
    /// What each motion is.
    pub(crate) shared: [Shared; 3],
    /// The joint by which the node hangs on another one.
    pub(crate) hangs_by: u32,
    /// Whether it is the motion of a path, which has no place.
    pub(crate) is_of_path: bool,
}

impl<T: Parameter> Motions<T> {
    /// No motions.
    pub(crate) fn none() -> Self {
        Motions {
            directions: [[T::zero(); 3]; 3],
            count: 0,
            shared: [Shared::Own; 3],
            hangs_by: NONE,
            is_of_path: false,
        }
    }

    /// The motions of a node.
    pub(crate) fn of(node: &Node<T>) -> Self {
        let (zero, one) = (T::zero(), T::one());
        let mut motions = Motions::none();
        let mut push = |direction| {
            motions.directions[motions.count] = direction;
            motions.count += 1;
        };
        match node.along {
            Some([x, y]) => push([x, y, zero]),
            None => {
                if !node.held.contains(Freedoms::X) {
                    push([one, zero, zero]);
                }
                if !node.held.contains(Freedoms::Y) {
                    push([zero, one, zero]);
                }
            }
        }
        if !node.held.contains(Freedoms::RZ) {
            push([zero, zero, one]);
        }
        motions
    }

    /// λ² times the mass matrix of the body of a node over its motions, if it has one.
    pub(crate) fn body<S: Frequency<T>>(&self, node: &Node<T>, lambda_squared: S) -> Option<[[S; 3]; 3]> {
        node.has_body().then(|| self.masses::<S>(node).map(|column| column.map(|entry| lambda_squared * entry)))
    }

    /// The mass matrix of the body of a node over its motions.
    pub(crate) fn masses<S: Frequency<T>>(&self, node: &Node<T>) -> [[S; 3]; 3] {
        // of all three displacements by all motions, and then of all motions by these
        let rows = node.mass_matrix::<S>().map(|row| self.parts_of(row));
        [0, 1, 2].map(|l| self.parts_of(rows.map(|row| row[l])))
    }

    /// What the motions are of a sum of x, y and rotation.
    #[inline]
    pub(crate) fn parts_of<S: Frequency<T>>(&self, sum: [S; 3]) -> [S; 3] {
        self.directions.map(|direction| {
            let mut part = S::zero();
            for (term, direction) in sum.iter().zip(direction).filter(|(_, direction)| !direction.vanishes().all()) {
                part += *term * direction;
            }
            part
        })
    }
}

impl<T: Parameter> Motions<T> {
    /// The displacements x, y and the rotation of the node in its motions.
    pub(crate) fn displacements<S: Frequency<T>>(&self, motions: [S; 3]) -> [S; 3] {
        [0, 1, 2].map(|k| {
            let parts = motions.iter().zip(&self.directions).filter(|(_, direction)| !direction[k].vanishes().all());
            parts.fold(S::zero(), |sum, (motion, direction)| sum + *motion * direction[k])
        })
    }
}

impl<T: Parameter> Node<T> {
    /// What a displacement of 1 of its support along x, along y or about z moves the node by; `None` where it does not hold the node so.
    /// Where the node may move along a direction, its own motion takes back what is along that.
    pub(crate) fn moved<S: Frequency<T>>(&self, axis: usize) -> Option<[S; 3]> {
        let mut moved = [S::zero(); 3];
        moved[axis] = S::one();
        if let Some(along) = self.along.filter(|_| axis < 2) {
            return (!along[1 - axis].vanishes().all()).then_some(moved);
        }
        self.held.contains(Freedoms::SINGLE[axis]).then_some(moved)
    }

    /// The direction along which it moves, if it does.
    pub(crate) fn direction<S: Frequency<T>>(&self) -> Option<[S; 2]> {
        self.along.map(|along| unit(along.map(S::from_parameter)))
    }

    /// Whether a body moves with the node.
    pub(crate) fn has_body(&self) -> bool {
        !(self.mass.vanishes() & self.inertia.vanishes()).all()
    }

    /// The mass matrix of the body times displacements x, y and the rotation of the node.
    pub(crate) fn momentum<S: Frequency<T>>(&self, displacements: [S; 3]) -> [S; 3] {
        self.mass_matrix::<S>().map(|row| {
            let terms = row.into_iter().zip(displacements).map(|(mass, displacement)| mass * displacement);
            terms.fold(S::zero(), |sum, term| sum + term)
        })
    }

    /// The mass form `uᵀ M v` of the body in two motions of the node.
    pub(crate) fn mass_form<S: Frequency<T>>(&self, first: [S; 3], second: [S; 3]) -> S {
        let terms = first.into_iter().zip(self.momentum(second)).map(|(one, other)| one * other);
        terms.fold(S::zero(), |sum, term| sum + term)
    }

    /// The mass matrix of the body over x, y and the rotation of the node.
    pub(crate) fn mass_matrix<S: Frequency<T>>(&self) -> [[S; 3]; 3] {
        let number = S::from_parameter;
        let (mass, zero) = (number(self.mass), S::zero());
        let [x, y] = [0, 1].map(|k| number(self.centre[k]) - number(self.position[k]));
        let (mx, my) = (mass * x, mass * y);
        [[mass, zero, -my], [zero, mass, mx], [-my, mx, number(self.inertia) + mx * x + my * y]]
    }
}

impl<T: Real> Node<T> {
    /// Adds the body to the estimates from which searches take their first steps.
    pub(crate) fn estimate(&self, estimates: &mut FrequencyEstimates) {
        estimates.mass(self.mass.to_f64());
        estimates.moment_of_inertia(self.inertia.to_f64());
        let offset = [0, 1].map(|k| (self.centre[k] - self.position[k]).to_f64());
        offset.into_iter().for_each(|lever| estimates.lever(lever));
    }
}
