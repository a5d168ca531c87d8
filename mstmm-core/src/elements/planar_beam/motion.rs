//! A beam in planar motion between its ends: bending and stretching side by side.

use crate::element::{CarriesLoad, Forms, Inside, MemberEnds, MemberMotion};
use crate::elements::Beam;
use crate::elements::planar_beam::{BuiltPlanarBeam, PlanarBeam};
use crate::elements::shared::bending_motion::BendingMotion;
use crate::elements::shared::rod_motion::Stretch;
use crate::elements::shared::uniform_line::LineSection;
use crate::model::EndMotion;
use crate::number::{Oscillation, Real};

impl<T: Real> BuiltPlanarBeam<T> {
    fn bending(&self) -> BendingMotion<T> {
        let PlanarBeam { length, bending_stiffness, mass_per_length, .. } = self.parameters;
        let parameters = Beam { length, bending_stiffness, mass_per_length };
        BendingMotion { parameters, wave: self.wave, wave_fourth: self.wave_fourth }
    }

    fn rod(&self) -> LineSection<T> {
        let PlanarBeam { length, axial_stiffness, mass_per_length, .. } = self.parameters;
        LineSection { length, stiffness: axial_stiffness, inertia: mass_per_length, foundation: T::zero() }
    }
}

impl<T: Real> CarriesLoad for PlanarBeam<T> {}

impl<T: Real, S: Oscillation<T>> MemberMotion<S> for PlanarBeam<T> {
    fn forms(built: &BuiltPlanarBeam<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let [mass, stiffness] = built.rod().forms(&Stretch::of(first), &Stretch::of(second));
        built.bending().member_forms(first, second).plus(Forms { mass, stiffness, ..Forms::none() })
    }

    fn inside(built: &BuiltPlanarBeam<T>, x: S) -> Option<Inside> {
        let bending = built.bending().inside(x);
        let longitudinal = built.rod().zeta(x) / bending.length;
        Some(Inside { wave_number: bending.wave_number.max(longitudinal), ..bending })
    }

    fn motion_at(built: &BuiltPlanarBeam<T>, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
        let distance = T::from_f64(distance);
        let bent = EndMotion::bent(built.bending().state_at(&motion.bending(), distance));
        bent.stretched(built.rod().at(&Stretch::of(motion), distance))
    }

    fn load_work(built: &BuiltPlanarBeam<T>, motion: &MemberEnds<S>) -> Option<[S; 2]> {
        Some([built.rod().load_work(&Stretch::of(motion)), built.bending().load_work(&motion.bending())])
    }

    fn mass_per_length(built: &BuiltPlanarBeam<T>) -> S {
        S::from_parameter(built.parameters.mass_per_length)
    }

    fn motion_under_load(
        built: &BuiltPlanarBeam<T>,
        motion: &MemberEnds<S>,
        [along, across]: [S; 2],
        distance: f64,
    ) -> EndMotion<S> {
        let distance = T::from_f64(distance);
        let bent = EndMotion::bent(built.bending().state_under(&motion.bending(), across, distance));
        bent.stretched(built.rod().at_under(&Stretch::of(motion), along, distance))
    }
}
