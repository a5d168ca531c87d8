//! The axes and the place of the end of a member in the plane, as its node sees them.

use crate::element::PathState;
use crate::number::{Frequency, Real, Scalar};
use crate::pass::network::placement::Placement;

/// Where an end of a member is from its node, and the direction of its x axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame<S> {
    pub(super) axis: [S; 2],
    pub(super) offset: [S; 2],
}

impl<S: Scalar> Frame<S> {
    /// The frame of an end.
    pub(super) fn of<T: Real>(placement: &Placement<T>, end: usize) -> Self
    where
        S: Frequency<T>,
    {
        let ([c, s, _], [x, y, _]) = (placement.axes(end).along, placement.offset(end));
        Frame { axis: [c, s], offset: [x, y] }
    }

    /// The axes of the plane at the node itself.
    pub(super) fn of_node() -> Self {
        Frame { axis: [S::one(), S::zero()], offset: [S::zero(); 2] }
    }

    /// The state of a node, seen at the end.
    pub(super) fn at_end(&self, state: PathState<S>) -> PathState<S> {
        PathState {
            displacements: turned(moved(state.displacements, self.offset), self.axis),
            forces: turned(moment_moved(state.forces, self.offset), self.axis),
        }
    }

    /// The state of the end, seen at the node.
    pub(super) fn at_node(&self, state: PathState<S>) -> PathState<S> {
        let ([c, s], back) = (self.axis, self.offset.map(|part| -part));
        PathState {
            displacements: moved(turned(state.displacements, [c, -s]), back),
            forces: moment_moved(turned(state.forces, [c, -s]), back),
        }
    }
}

/// The displacements of a place that is tied to a node at a distance.
fn moved<S: Scalar>([x, y, rotation]: [S; 3], [to_x, to_y]: [S; 2]) -> [S; 3] {
    [x - rotation * to_y, y + rotation * to_x, rotation]
}

/// A force with its moment about a place at a distance.
fn moment_moved<S: Scalar>([x, y, moment]: [S; 3], [to_x, to_y]: [S; 2]) -> [S; 3] {
    [x, y, moment - to_x * y + to_y * x]
}

/// A vector in axes that lead along a direction.
fn turned<S: Scalar>([x, y, about_z]: [S; 3], [c, s]: [S; 2]) -> [S; 3] {
    [c * x + s * y, c * y - s * x, about_z]
}
