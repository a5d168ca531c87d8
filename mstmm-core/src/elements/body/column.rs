//! Rigid body under an axial force.

use crate::element::{BackTransfer, Element, Energies, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::body::Body;
use crate::elements::shared::axial_force::{AxialForce, before_stiffness, stiffened, under_axial_force};
use crate::model::{Bending, Ends, Extent, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::subspace::{Covector, RootCounter, Subspace};
use nalgebra::Matrix4;

under_axial_force! {
    /// Rigid body in a bending path under an axial force N between its ends.
    ///
    /// Transfer matrix on `[Y, Θ, M, Q]`: that of [`Body`], plus the geometric stiffness `N |b1|` at (M, Θ).
    ///
    /// # Source
    /// Eq. (16) of the paper, and the second variation of the work of N.
    BodyColumn of Body {
        /// Mass m \[kg\], zero or positive.
        mass,
        /// Moment of inertia J_I about the input end [kg m²], at least `mass * centre_x²`.
        inertia,
        /// Position b1 of the output end from the input end \[m\].
        output_x,
        /// Position c1 of the mass centre from the input end \[m\].
        centre_x,
    }
}

#[cfg(test)]
impl crate::elements::laws::Sample for BodyColumn<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let Body { mass, inertia, output_x, centre_x } = Body::sample(&mut next);
        BodyColumn { mass, inertia, output_x, centre_x, axial_force: next() - 1.0 }
    }

    fn untied(self) -> Self {
        BodyColumn { axial_force: 0.0, ..self }
    }
}
