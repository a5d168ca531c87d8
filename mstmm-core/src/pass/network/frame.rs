//! The axes and the place of the end of a member, as its node sees them.

use crate::number::{Frequency, Real, Scalar};
use crate::pass::network::path_state::PathState;
use crate::pass::network::placement::Placement;
use crate::pass::network::vector::{Six, at_node, displacements, dot, moved, rotations, six};

/// Where an end of a member is from its node, and its axes x, y and z.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame<S> {
    pub(super) axes: [[S; 3]; 3],
    pub(super) offset: [S; 3],
}

impl<S: Scalar> Frame<S> {
    /// The frame of an end.
    pub(super) fn of<T: Real>(placement: &Placement<T>, end: usize) -> Self
    where
        S: Frequency<T>,
    {
        Frame { axes: placement.axes_of_member(end), offset: placement.offset(end) }
    }

    /// The axes of the structure at the node itself.
    pub(super) fn of_node() -> Self {
        let axes = [0, 1, 2].map(|row| [0, 1, 2].map(|column| if row == column { S::one() } else { S::zero() }));
        Frame { axes, offset: [S::zero(); 3] }
    }

    /// The state of a node, seen at the end.
    pub(super) fn at_end(&self, state: PathState<S>) -> PathState<S> {
        PathState {
            displacements: turned(moved(state.displacements, self.offset), &self.axes),
            forces: turned(at_node(state.forces, self.offset.map(|part| -part)), &self.axes),
        }
    }

    /// The state of the end, seen at the node.
    pub(super) fn at_node(&self, state: PathState<S>) -> PathState<S> {
        let back = [0, 1, 2].map(|row| [0, 1, 2].map(|column| self.axes[column][row]));
        PathState {
            displacements: moved(turned(state.displacements, &back), self.offset.map(|part| -part)),
            forces: at_node(turned(state.forces, &back), self.offset),
        }
    }
}

/// Displacements or forces in other axes.
fn turned<S: Scalar>(of_node: Six<S>, axes: &[[S; 3]; 3]) -> Six<S> {
    let [moved, turned] = [displacements(of_node), rotations(of_node)];
    six(axes.map(|axis| dot(axis, moved)), axes.map(|axis| dot(axis, turned)))
}
