//! States of paths, with all displacements and forces of space, and those of the parts of a member.

use crate::element::PartState;
use crate::number::Scalar;
use crate::pass::network::vector::Six;
use crate::structure::MOST_MOTIONS;
use mstmm_plan::{Freedoms, MOST_PARTS};

/// The state of a path at a point: displacements, and the forces that what lies upstream exerts on what follows.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathState<S> {
    pub(super) displacements: Six<S>,
    pub(super) forces: Six<S>,
}

/// The places of what is along, across and turns in the parts of a member, and whether it is that of the member, or the opposite: the second part
/// turns about -y.
const OF_PARTS: [[Option<(usize, bool)>; 3]; MOST_PARTS] = [
    [Some((0, true)), Some((1, true)), Some((2, true))],
    [None, Some((3, true)), Some((5, false))],
    [None, None, Some((4, true))],
];

impl<S: Scalar> PathState<S> {
    /// At rest, without forces.
    pub(super) fn zero() -> Self {
        PathState { displacements: [S::zero(); MOST_MOTIONS], forces: [S::zero(); MOST_MOTIONS] }
    }

    /// The state without the entries of other freedoms.
    pub(super) fn of_freedoms(mut self, freedoms: Freedoms) -> Self {
        for k in numbers(Freedoms::SPACE.without(freedoms)) {
            (self.displacements[k], self.forces[k]) = (S::zero(), S::zero());
        }
        self
    }

    /// The state of what meets this one from the other side.
    pub(super) fn opposite(self) -> Self {
        PathState { forces: self.forces.map(|force| -force), ..self }
    }

    /// What a part of a member has of the state in the axes of the member.
    pub(super) fn of_part(&self, part: usize) -> PartState<S> {
        let entry = |six: &Six<S>, place: Option<(usize, bool)>| match place {
            Some((place, true)) => six[place],
            Some((place, false)) => -six[place],
            None => S::zero(),
        };
        PartState {
            displacements: OF_PARTS[part].map(|place| entry(&self.displacements, place)),
            forces: OF_PARTS[part].map(|place| entry(&self.forces, place)),
        }
    }

    /// Sets what a part has.
    pub(super) fn set_part(&mut self, part: usize, own: PartState<S>) {
        let entries = own.displacements.into_iter().zip(own.forces).zip(OF_PARTS[part]);
        for ((displacement, force), place) in entries {
            match place {
                Some((place, true)) => (self.displacements[place], self.forces[place]) = (displacement, force),
                Some((place, false)) => (self.displacements[place], self.forces[place]) = (-displacement, -force),
                None => {}
            }
        }
    }
}

/// The places of freedoms in a state.
pub(super) fn numbers(freedoms: Freedoms) -> impl Iterator<Item = usize> {
    let all = Freedoms::EACH.into_iter().enumerate();
    all.filter(move |(_, freedom)| freedoms.contains(*freedom)).map(|(k, _)| k)
}
