//! The motions that its supports leave a node.

use crate::model::{Skew, across};
use crate::number::{Frequency, Parameter, Truth, binary_exponent};
use crate::pass::network::placed_node::{PlacedNode, XYZ};
use crate::pass::network::vector::{DISPLACEMENTS, Six};
use crate::structure::MOST_MOTIONS;
use mstmm_plan::Freedoms;

/// The place of y among displacements.
const ACROSS: usize = 1;

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

/// What a motion moves a node by.
#[derive(Clone, Copy, Debug)]
enum Direction<T> {
    /// A displacement along an axis, or a rotation about one.
    Of(usize),
    /// A displacement along a vector.
    Along([T; 3]),
}

/// The motions that its supports leave a node: first its displacements in the plane and its rotation there.
#[derive(Clone, Copy, Debug)]
pub struct Motions<T> {
    directions: [Direction<T>; MOST_MOTIONS],
    pub(crate) count: usize,
    /// What each motion is.
    pub(crate) shared: [Shared; MOST_MOTIONS],
    /// The joint by which the node hangs on another one.
    pub(crate) hangs_by: u32,
    /// Whether it is the motion of a path, which has no place.
    pub(crate) is_of_path: bool,
}

/// A direction over a power of two, with which its largest part is at least 1 and less than 2: displacements of the node are of the size of its motions,
/// however long the direction is.
fn of_size_one<T: Parameter>(direction: [T; 3]) -> [T; 3] {
    let largest = direction.iter().fold(0.0, |largest: f64, part| largest.max(part.to_f64().abs()));
    direction.map(|part| part.times_power_of_two(-binary_exponent(largest)))
}

impl<T: Parameter> Motions<T> {
    /// No motions.
    pub(crate) fn none() -> Self {
        Motions {
            directions: [Direction::Of(0); MOST_MOTIONS],
            count: 0,
            shared: [Shared::Own; MOST_MOTIONS],
            hangs_by: NONE,
            is_of_path: false,
        }
    }

    /// The motions of a node.
    pub(crate) fn of(node: &PlacedNode<T>) -> Self {
        let mut motions = Motions::none();
        let mut push = |direction| {
            motions.directions[motions.count] = direction;
            motions.count += 1;
        };
        match node.skew {
            Some(Skew::Along(direction)) => push(Direction::Along(of_size_one(direction))),
            Some(Skew::Normal(normal)) => {
                let normal = of_size_one(normal);
                let sizes = normal.map(|part| part.to_f64().abs());
                across(normal, sizes, T::zero()).into_iter().for_each(|own| push(Direction::Along(own)));
            }
            None => {}
        }
        let held = if node.skew.is_some() { node.held.union(XYZ) } else { node.held };
        for (place, freedom) in Freedoms::EACH.into_iter().enumerate() {
            if !held.contains(freedom) {
                push(Direction::Of(place));
            }
        }
        motions
    }

    /// Whether a joint ties its displacement along an axis to a node at rest.
    pub(crate) fn rests_along(&self, axis: usize) -> bool {
        let mut own = self.directions.iter().zip(&self.shared).take(self.count);
        own.any(|(direction, shared)| {
            matches!(direction, Direction::Of(place) if *place == axis) && *shared == Shared::AtRest
        })
    }

    /// Whether it is the motion of a path which is along no axis of the structure: in the plane and in space; on a line it is that along y.
    pub(crate) fn has_no_direction(&self) -> bool {
        self.is_of_path && !self.directions.iter().take(self.count).any(|own| matches!(own, Direction::Of(ACROSS)))
    }

    /// Whether all are motions in the plane of x and y.
    pub(crate) fn is_in_plane(&self) -> bool {
        let is_flat = |direction: &Direction<T>| match direction {
            Direction::Of(place) => Freedoms::PLANE.contains(Freedoms::EACH[*place]),
            Direction::Along([.., z]) => z.vanishes().all(),
        };
        self.directions.iter().take(self.count).all(is_flat)
    }

    /// λ² times the mass matrix of the body of a node over its motions, if it has one.
    pub(crate) fn body<S: Frequency<T>>(&self, node: &PlacedNode<T>, lambda_squared: S) -> Option<[Six<S>; 6]> {
        node.has_body().then(|| {
            let mut masses = self.masses::<S>(node);
            for column in masses.iter_mut().take(self.count) {
                column.iter_mut().take(self.count).for_each(|entry| *entry = lambda_squared * *entry);
            }
            masses
        })
    }

    /// The mass matrix of the body of a node over its motions.
    pub(crate) fn masses<S: Frequency<T>>(&self, node: &PlacedNode<T>) -> [Six<S>; 6] {
        // of all displacements by all motions, and then of all motions by these
        let rows = node.mass_matrix::<S>().map(|row| self.parts_of(row));
        let mut masses = [[S::zero(); MOST_MOTIONS]; MOST_MOTIONS];
        for (motion, column) in masses.iter_mut().enumerate().take(self.count) {
            *column = self.parts_of(rows.map(|row| row[motion]));
        }
        masses
    }

    /// What the motions are of a sum of displacements and rotations.
    #[inline]
    pub(crate) fn parts_of<S: Frequency<T>>(&self, sum: Six<S>) -> Six<S> {
        let mut parts = [S::zero(); MOST_MOTIONS];
        for (part, direction) in parts.iter_mut().zip(&self.directions).take(self.count) {
            match direction {
                Direction::Of(place) => *part = sum[*place],
                Direction::Along(vector) => {
                    for (own, place) in vector.iter().zip(DISPLACEMENTS).filter(|(own, _)| !own.vanishes().all()) {
                        *part += sum[place] * *own;
                    }
                }
            }
        }
        parts
    }

    /// The displacements of the node in its motions.
    pub(crate) fn displacements<S: Frequency<T>>(&self, motions: Six<S>) -> Six<S> {
        let mut displacements = [S::zero(); MOST_MOTIONS];
        for (motion, direction) in motions.iter().zip(&self.directions).take(self.count) {
            match direction {
                Direction::Of(place) => displacements[*place] += *motion,
                Direction::Along(vector) => {
                    for (own, place) in vector.iter().zip(DISPLACEMENTS).filter(|(own, _)| !own.vanishes().all()) {
                        displacements[place] += *motion * *own;
                    }
                }
            }
        }
        displacements
    }
}
