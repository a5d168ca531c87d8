//! The motion of an end of a member.

use crate::number::Scalar;

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

    /// Leaves nothing but what is along the member.
    pub(crate) fn keep_longitudinal(&mut self) {
        for part in [&mut self.displacements, &mut self.forces] {
            part[1..].fill(S::zero());
        }
    }
}
