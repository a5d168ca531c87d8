//! A beam with damping in the plane, where it stretches as well.

use crate::element::{
    Charted, Element, Forms, Inside, MatrixOf, MemberEnds, MemberGradient, MemberMotion, MemberNumbers, MemberWork,
    TransferMatrix,
};
use crate::elements::general_beam::damped::BuiltDampedBeam;
use crate::elements::general_beam::damped_beam::DampedBeam;
use crate::elements::general_beam::members::BuiltPlanarGeneralBeam;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::damped_line::DampedLine;
use crate::elements::shared::planar_matrix::planar_matrix;
use crate::elements::shared::rod_motion::Stretch;
use crate::model::{EndMotion, Extent, FrequencyEstimates, InvalidParameter, Planar};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use mstmm_plan::Freedoms;

/// A beam with damping that stretches; the medium around it resists both displacements alike.
#[derive(Clone, Copy, Debug)]
pub struct BuiltPlanarDampedBeam<T> {
    bending: BuiltDampedBeam<T>,
    rod: DampedLine<T>,
}

impl<T: Parameter> BuiltPlanarDampedBeam<T> {
    fn new(bending: BuiltDampedBeam<T>, axial_stiffness: T) -> Result<Self, InvalidParameter> {
        let BuiltDampedBeam { beam, dissipation } = bending;
        let line = BuiltPlanarGeneralBeam::new(beam, axial_stiffness)?.rod;
        Ok(BuiltPlanarDampedBeam { bending, rod: DampedLine { line, dissipation } })
    }

    fn estimate(&self, estimates: &mut FrequencyEstimates) {
        self.bending.estimate(estimates);
        let section = self.rod.line.section;
        estimates.translational_stiffness((section.stiffness / section.length).to_f64());
    }

    fn chart<S: ComplexFrequency<T> + ChartScalar>(&self, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        let longitudinal = self.rod.longitudinal(at, length);
        let mut chart = self.bending.chart(at, length, Freedoms::ALL, longitudinal.unit(), [1, 2, 4, 5]);
        S::enter_longitudinal(&longitudinal, &mut chart, [0, 3]);
        chart
    }
}

/// [`DampedBeam`] between two points of the plane, with exact longitudinal vibration, which is damped alike; the foundation acts across it.
///
/// # Source
/// That of the beam; along it `EA (1 + iη)(1 + cλ) X'' = (mλ² + c_e λ) X`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarDampedBeam<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Axial stiffness EA \[N\], positive.
    pub axial_stiffness: T,
    /// Bending stiffness EI [N m²], positive.
    pub bending_stiffness: T,
    /// Mass per length m [kg/m], positive.
    pub mass_per_length: T,
    /// Shear stiffness `k G A` \[N\], positive, with a finite reciprocal; infinite is a beam without shear.
    pub shear_stiffness: T,
    /// Rotary inertia per length `r = ρ I` [kg m], zero or positive.
    pub rotary_inertia: T,
    /// Axial force N \[N\], positive in tension; greater than `-kGA - G`.
    pub axial_force: T,
    /// Stiffness k of the foundation per length [N/m²], zero or positive.
    pub foundation_stiffness: T,
    /// Stiffness G of the shear layer of the foundation \[N\], zero or positive.
    pub foundation_shear_stiffness: T,
    /// Loss factor η of EA, EI and kGA, zero or positive.
    pub loss_factor: T,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    pub kelvin_voigt_time: T,
    /// Damping c_e per length against displacements along the beam and across it [N s/m²], zero or positive.
    pub external_damping: T,
}

impl<T> PlanarDampedBeam<T> {
    fn in_bending(self) -> DampedBeam<T> {
        let PlanarDampedBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
            loss_factor,
            kelvin_voigt_time,
            external_damping,
            ..
        } = self;
        DampedBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
            loss_factor,
            kelvin_voigt_time,
            external_damping,
        }
    }
}

impl<T: Parameter> Element for PlanarDampedBeam<T> {
    type State = Planar;
    type Built = BuiltPlanarDampedBeam<T>;

    fn build(self) -> Result<BuiltPlanarDampedBeam<T>, InvalidParameter> {
        BuiltPlanarDampedBeam::new(self.in_bending().build()?, self.axial_stiffness)
    }

    fn estimate(built: &BuiltPlanarDampedBeam<T>, estimates: &mut FrequencyEstimates) {
        built.estimate(estimates);
    }

    fn extent(built: &BuiltPlanarDampedBeam<T>) -> Extent {
        Extent::along(built.rod.line.section.length.to_f64())
    }

    fn member_numbers(built: &BuiltPlanarDampedBeam<T>) -> MemberNumbers {
        let BuiltPlanarDampedBeam { bending, rod } = built;
        MemberNumbers::Beam(bending.beam.numbers(rod.line.section.stiffness)).damped(rod.dissipation.numbers())
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for PlanarDampedBeam<T> {
    fn transfer_matrix(built: &BuiltPlanarDampedBeam<T>, x: S) -> MatrixOf<Self, S> {
        let waves = built.rod.waves(&FrequencyPowers::new(x, false));
        planar_matrix(&built.bending.transfer_matrix(x), &waves.transfer_matrix(false))
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + ChartScalar> Charted<S> for PlanarDampedBeam<T> {
    fn chart(built: &BuiltPlanarDampedBeam<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        built.chart(at, length)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberMotion<S> for PlanarDampedBeam<T> {
    fn forms(built: &BuiltPlanarDampedBeam<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let stretch = built.rod.forms(&Stretch::of(first), &Stretch::of(second));
        built.bending.forms(&first.bending(), &second.bending()).plus(stretch)
    }

    fn inside(built: &BuiltPlanarDampedBeam<T>, x: S) -> Option<Inside> {
        let (bending, rod) = (built.bending.motion(x).interior(), built.rod.inside(x));
        Some(Inside { wave_number: bending.wave_number.max(rod.wave_number), ..bending })
    }

    fn motion_at(built: &BuiltPlanarDampedBeam<T>, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
        let stretch = built.rod.state_at(&Stretch::of(motion), T::from_f64(distance));
        built.bending.motion_at(&motion.bending(), distance).stretched(stretch)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberGradient<S> for PlanarDampedBeam<T> {
    type Gradient = PlanarDampedBeam<S>;

    fn member_gradient(built: &BuiltPlanarDampedBeam<T>, work: &MemberWork<S>) -> PlanarDampedBeam<S> {
        let motion = MemberEnds { x: work.x, ends: work.ends };
        let bending = DampedBeam::gradient_of(&built.bending, &motion.bending());
        let ([length, axial_stiffness, mass, _], [loss, time, external]) = built.rod.gradient(&Stretch::of(&motion));
        PlanarDampedBeam {
            length: bending.length + length,
            axial_stiffness,
            bending_stiffness: bending.bending_stiffness,
            mass_per_length: bending.mass_per_length + mass,
            shear_stiffness: bending.shear_stiffness,
            rotary_inertia: bending.rotary_inertia,
            axial_force: bending.axial_force,
            foundation_stiffness: bending.foundation_stiffness,
            foundation_shear_stiffness: bending.foundation_shear_stiffness,
            loss_factor: bending.loss_factor + loss,
            kelvin_voigt_time: bending.kelvin_voigt_time + time,
            external_damping: bending.external_damping + external,
        }
    }
}

#[cfg(test)]
impl crate::elements::laws::Sample for PlanarDampedBeam<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let axial_stiffness = next();
        PlanarDampedBeam::of(DampedBeam::sample(next), axial_stiffness)
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn halves(self) -> Option<Self> {
        Some(PlanarDampedBeam { length: self.length / 2.0, ..self })
    }

    fn phase(&self, s: f64) -> f64 {
        self.in_bending().phase(s)
    }

    fn untied(self) -> Self {
        PlanarDampedBeam::of(self.in_bending().untied(), self.axial_stiffness)
    }

    fn lossless(self) -> Self {
        PlanarDampedBeam { loss_factor: 0.0, ..self }
    }
}

#[cfg(test)]
impl PlanarDampedBeam<f64> {
    fn of(bending: DampedBeam<f64>, axial_stiffness: f64) -> Self {
        let DampedBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
            loss_factor,
            kelvin_voigt_time,
            external_damping,
        } = bending;
        PlanarDampedBeam {
            length,
            axial_stiffness,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
            loss_factor,
            kelvin_voigt_time,
            external_damping,
        }
    }
}
