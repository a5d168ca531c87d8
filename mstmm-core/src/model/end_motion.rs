//! The motion of an end of a member.

use crate::model::State;
use crate::number::Scalar;

/// Signs of forces on a member, along it, across and of the moment, in its axial force, shear and bending moment: at the input end and
/// at the output end, where the sketch of a beam has them as at a cut.
const SIGNS: [[f64; 3]; 2] = [[-1.0, 1.0, -1.0], [1.0, -1.0, 1.0]];

/// The displacement and the force of an end of a member, in its own axes: along it, across, and of the rotation. The force acts on the
/// member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndMotion<S> {
    /// Displacements \[m\], \[m\], \[rad\].
    pub displacements: [S; 3],
    /// Forces \[N\], \[N\], [N m].
    pub forces: [S; 3],
}

impl<S: Scalar> EndMotion<S> {
    /// At rest, without forces.
    pub(crate) fn at_rest() -> Self {
        EndMotion { displacements: [S::zero(); 3], forces: [S::zero(); 3] }
    }

    /// Axial force, shear and bending moment, of forces on the input end 0 or on the output end 1.
    pub(crate) fn internal(&self, end: usize) -> [S; 3] {
        let [along, across, moment] = self.forces;
        let [axial, shear, bending] = SIGNS[end].map(S::from_f64);
        [axial * along, shear * across, bending * moment]
    }

    /// The displacement of an end, 0 or 1, beside its node that works 1 times an internal force: against the force on the member.
    pub(crate) fn dislocation(end: usize, force: usize) -> f64 {
        -SIGNS[end][force]
    }

    /// The state of bending, of the input end 0 or of the output end 1.
    pub(crate) fn bending(&self, end: usize) -> State<S> {
        let ([_, y, theta], [_, q, m]) = (self.displacements, self.internal(end));
        State { y, theta, m, q }
    }

    /// The motion of an output end of a translation path, along the member.
    pub fn translated(state: State<S>) -> Self {
        EndMotion::at_rest().in_freedom(0, [state.y, -state.q])
    }

    /// The motion of an output end of a rotation path.
    pub fn rotated(state: State<S>) -> Self {
        EndMotion::at_rest().in_freedom(2, [state.theta, state.m])
    }

    /// The motion of an output end in a state of bending.
    pub(crate) fn bent(state: State<S>) -> Self {
        let State { y, theta, m, q } = state;
        EndMotion { displacements: [S::zero(), y, theta], forces: [S::zero(), -q, m] }
    }

    /// The motion of an output end with a displacement along the member and an axial force.
    #[must_use]
    pub(crate) fn stretched(self, displacement_and_force: [S; 2]) -> Self {
        self.in_freedom(0, displacement_and_force)
    }

    /// The motion of an output end with a displacement and an internal force in a freedom, along the member or about z.
    #[must_use]
    pub(crate) fn in_freedom(mut self, freedom: usize, [displacement, force]: [S; 2]) -> Self {
        (self.displacements[freedom], self.forces[freedom]) = (displacement, force);
        self
    }
}
