//! How the parameters of a beam in planar motion change its dynamic work.

use crate::element::{MemberGradient, MemberWork};
use crate::elements::planar_beam::{BuiltPlanarBeam, PlanarBeam};
use crate::elements::shared::section_gradient::SectionGradient;
use crate::number::{Frequency, Parameter};

impl<T: Parameter, S: Frequency<T>> MemberGradient<S> for PlanarBeam<T> {
    type Gradient = PlanarBeam<S>;

    fn member_gradient(built: &BuiltPlanarBeam<T>, work: &MemberWork<S>) -> PlanarBeam<S> {
        let PlanarBeam { axial_stiffness, bending_stiffness, mass_per_length, .. } = built.parameters;
        let rod = SectionGradient::of_rod(work, [axial_stiffness, mass_per_length]);
        let bending = SectionGradient::of_bending(work, [bending_stiffness, mass_per_length]);
        PlanarBeam {
            length: rod.length + bending.length,
            axial_stiffness: rod.stiffness,
            bending_stiffness: bending.stiffness,
            mass_per_length: rod.mass + bending.mass,
        }
    }
}
