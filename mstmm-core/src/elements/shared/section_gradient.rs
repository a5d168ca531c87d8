//! How stiffness, mass and length of a uniform member change its dynamic work.

use crate::element::MemberWork;
use crate::elements::shared::line_forms::half;
use crate::number::{Frequency, Parameter};

/// `∂L/∂EI`, `∂L/∂m` and `∂L/∂l` of bending, with the displacements of both ends held.
pub(crate) struct SectionGradient<S> {
    pub(crate) stiffness: S,
    pub(crate) mass: S,
    pub(crate) length: S,
}

impl<S> SectionGradient<S> {
    /// Of bending. The growth of the output end adds `-M²/2EI + λ² m y²/2 - f θ`, with its force f and its moment M.
    pub(crate) fn of_bending<T: Parameter>(work: &MemberWork<S>, stiffness_and_mass: [T; 2]) -> Self
    where
        S: Frequency<T>,
    {
        let [ei, m] = stiffness_and_mass.map(S::from_parameter);
        let square = work.x.lambda_squared();
        let (kinetic, output) = (work.kinetic[1], &work.ends[1]);
        let [force, moment] = [output.forces[1], output.forces[2]];
        let [deflection, rotation] = [output.displacements[1], output.displacements[2]];
        let density = half(square * m * deflection * deflection - moment * moment / ei);
        SectionGradient {
            stiffness: (half(work.of_ends(1) + work.of_ends(2)) - square * kinetic) / ei,
            mass: square * kinetic / m,
            length: density - force * rotation,
        }
    }
}
