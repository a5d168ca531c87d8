//! A beam with damping along a line.

use crate::element::{
    BackTransfer, CarriesLoad, Charted, Deflection, Element, Energies, Forms, Inside, MatrixOf, MemberEnds,
    MemberGradient, MemberMotion, MemberNumbers, PlaneStep, TransferMatrix,
};
use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::compound::GeneralCompound;
use crate::elements::general_beam::damped::BuiltDampedBeam;
use crate::elements::general_beam::kinds::GeneralBeam;
use crate::elements::general_beam::of_built::{energies_of_built, members_of_built, steps_of_built};
use crate::elements::general_beam::transfer::BackThrough;
use crate::elements::in_plane::across::{Across, AlongGradient, ChartedAcross, Stretching};
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::damped_line::DampedLine;
use crate::elements::shared::dissipation::Dissipation;
use crate::model::{Bending, EndMotion, Ends, Extent, FrequencyEstimates, InvalidParameter, State};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Scaled, Single};
use crate::structure::Chart;
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::Support;

/// Uniform beam with damping of its material and of a medium around it, exact at every frequency: a [`GeneralBeam`] with
/// `EI (1 + iη)(1 + cλ)`, `kGA (1 + iη)(1 + cλ)` and `k + c_e λ`, which exists at complex frequencies λ only.
///
/// The axial force and the foundation have no loss. A loss factor describes motions with `Im λ > 0`; a time of Kelvin and Voigt leaves no
/// stiffness at `λ = -1/c`, about which eigenvalues accumulate. Searches refuse regions that meet either.
///
/// # Source
/// Structural damping by a complex modulus; the viscoelastic solid of Kelvin and Voigt; viscous damping by a medium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedBeam<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Bending stiffness EI [N m²], positive.
    pub bending_stiffness: T,
    /// Mass per length m [kg/m], zero or positive.
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
    /// Loss factor η of EI and kGA, zero or positive.
    pub loss_factor: T,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    pub kelvin_voigt_time: T,
    /// Damping c_e per length against deflections [N s/m²], zero or positive.
    pub external_damping: T,
}

impl<T: Copy> DampedBeam<T> {
    /// The beam without its damping.
    pub(super) fn undamped(self) -> GeneralBeam<T> {
        let DampedBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
            ..
        } = self;
        GeneralBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
        }
    }

    /// A beam with damping, or the derivatives with respect to all of it.
    pub(super) fn with_damping(
        beam: GeneralBeam<T>,
        [loss_factor, kelvin_voigt_time, external_damping]: [T; 3],
    ) -> Self {
        let GeneralBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
        } = beam;
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

impl<T: Parameter> Element for DampedBeam<T> {
    type State = Bending;
    type Built = BuiltDampedBeam<T>;
    const IS_STRAIGHT: bool = false;

    fn build(self) -> Result<BuiltDampedBeam<T>, InvalidParameter> {
        let beam: BuiltGeneralBeam<T> = self.undamped().build()?;
        let DampedBeam { loss_factor, kelvin_voigt_time: time, external_damping: external, .. } = self;
        let dissipation = Dissipation { loss_factor, time, external };
        dissipation.check()?;
        Ok(BuiltDampedBeam { beam, dissipation })
    }

    fn add_axial_force(built: &mut BuiltDampedBeam<T>, force: [f64; 2]) -> Result<bool, InvalidParameter> {
        built.beam.add_axial_force(force)?;
        Ok(true)
    }

    fn estimate(built: &BuiltDampedBeam<T>, estimates: &mut FrequencyEstimates) {
        built.estimate(estimates);
    }

    fn extent(built: &BuiltDampedBeam<T>) -> Extent {
        built.beam.extent()
    }

    fn member_numbers(built: &BuiltDampedBeam<T>) -> MemberNumbers {
        MemberNumbers::Beam(built.beam.numbers()).damped(built.dissipation.numbers())
    }
}

steps_of_built!(DampedBeam at ComplexFrequency);

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> Energies<S> for DampedBeam<T> {
    type Gradient = DampedBeam<S>;

    energies_of_built!();

    fn damping_form(built: &BuiltDampedBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first, second).damping
    }

    fn gradient(built: &BuiltDampedBeam<T>, ends: &Ends<S>) -> DampedBeam<S> {
        DampedBeam::gradient_of(built, ends)
    }
}

impl<S: Scalar> DampedBeam<S> {
    /// The derivatives of the dynamic work of a motion.
    pub(super) fn gradient_of<T: Real>(built: &BuiltDampedBeam<T>, ends: &Ends<S>) -> Self
    where
        S: ComplexFrequency<T> + Oscillation<T>,
    {
        let (beam, damping) = built.gradient(ends);
        DampedBeam::with_damping(GeneralBeam::of_gradient(beam, &built.beam.parameters), damping)
    }
}

members_of_built!(DampedBeam at ComplexFrequency);

impl<S: Scalar> Across for DampedBeam<S> {
    type Number = S;

    fn of_length(self, length: S) -> Self {
        DampedBeam { length, ..self }
    }

    fn and_along(mut self, along: AlongGradient<S>) -> Self {
        let [loss, time, external] = along.damping;
        self.length += along.length;
        self.mass_per_length += along.mass;
        self.loss_factor += loss;
        self.kelvin_voigt_time += time;
        self.external_damping += external;
        self
    }
}

/// The line along it is damped alike, and the medium around it resists both displacements.
impl<T: Parameter> Stretching for DampedBeam<T> {
    type Line = DampedLine<T>;

    fn line(built: &BuiltDampedBeam<T>, axial_stiffness: T) -> Result<DampedLine<T>, InvalidParameter> {
        Ok(DampedLine { line: built.beam.line_along(axial_stiffness)?, dissipation: built.dissipation })
    }
}

impl<T: Real> CarriesLoad for DampedBeam<T> {}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberGradient<S> for DampedBeam<T> {
    type Gradient = DampedBeam<S>;

    fn member_gradient(built: &BuiltDampedBeam<T>, motion: &MemberEnds<S>) -> DampedBeam<S> {
        DampedBeam::gradient_of(built, &motion.bending())
    }
}

#[cfg(test)]
impl crate::elements::laws::Sample for DampedBeam<f64> {
    /// A beam whose stiffness vanishes far from the frequencies of the laws.
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let beam = GeneralBeam::sample(&mut next);
        DampedBeam::with_damping(beam, [0.2 * next(), 0.005 * next(), 0.5 * next()])
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn halves(self) -> Option<Self> {
        Some(DampedBeam { length: self.length / 2.0, ..self })
    }

    fn phase(&self, s: f64) -> f64 {
        // near λ = -1/c the stiffness is a small part of what it is at rest
        10.0 * self.undamped().phase(s)
    }

    fn untied(self) -> Self {
        let damping = [self.loss_factor, self.kelvin_voigt_time, self.external_damping];
        DampedBeam::with_damping(self.undamped().untied(), damping)
    }

    fn lossless(self) -> Self {
        DampedBeam { loss_factor: 0.0, ..self }
    }
}
