//! How the parameters of a located beam change its dynamic work.

use crate::element::{MemberGradient, MemberWork};
use crate::elements::beam::{Beam, BuiltBeam};
use crate::elements::shared::section_gradient::SectionGradient;
use crate::number::{Frequency, Parameter};

impl<T: Parameter, S: Frequency<T>> MemberGradient<S> for Beam<T> {
    type Gradient = Beam<S>;

    fn member_gradient(built: &BuiltBeam<T>, work: &MemberWork<S>) -> Beam<S> {
        let Beam { bending_stiffness, mass_per_length, .. } = built.parameters;
        let SectionGradient { stiffness, mass, length } =
            SectionGradient::of_bending(work, [bending_stiffness, mass_per_length]);
        Beam { length, bending_stiffness: stiffness, mass_per_length: mass }
    }
}
