//! A beam that spins about its axis.

use crate::element::{
    BackTransfer, CarriesLoad, Charted, Deflection, Element, Energies, Forms, Inside, MatrixOf, MemberEnds,
    MemberGradient, MemberMotion, MemberNumbers, PlaneStep, Spins, TransferMatrix,
};
use crate::elements::general_beam::compound::GeneralCompound;
use crate::elements::general_beam::kinds::GeneralBeam;
use crate::elements::general_beam::of_built::{energies_of_built, members_of_built, steps_of_built};
use crate::elements::general_beam::spinning::BuiltSpinningBeam;
use crate::elements::general_beam::transfer::BackThrough;
use crate::elements::in_plane::across::ChartedAcross;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::spin::Spin;
use crate::model::{Bending, EndMotion, Ends, Extent, FrequencyEstimates, InvalidParameter, State};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scaled, Single};
use crate::structure::Chart;
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::Support;

/// Uniform shaft that spins about its axis, exact at every frequency: a [`GeneralBeam`] with gyroscopic moments.
///
/// With `u = v + iw` and the rotation `θ = θ_z - iθ_y` both bending planes are one, since the shaft is isotropic. A motion `e^{iωt}` has
///
/// ```text
/// Y' = σ Θ - τ Q     Θ' = M/EI     M' = (σ T - r ω² + r_p Ω ω) Θ + σ Q     Q' = (m ω² - k) Y
/// ```
///
/// with real numbers alone: forward whirl, in the sense of a positive speed Ω, has `ω > 0`, backward whirl `ω < 0`.
///
/// # Source
/// Rayleigh's and Timoshenko's rotating shafts; Nelson, J. Mech. Design 102 (1980), 793.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinningBeam<T> {
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
    /// Stiffness k of the foundation per length [N/m²], zero or positive, the same in all directions across the axis.
    pub foundation_stiffness: T,
    /// Stiffness G of the shear layer of the foundation \[N\], zero or positive.
    pub foundation_shear_stiffness: T,
    /// Polar moment of inertia per length `r_p = ρ I_p` [kg m], zero or positive; of a circular section twice the rotary inertia.
    pub polar_inertia_per_length: T,
    /// Speed Ω [rad/s] about the axis, of either sign.
    pub speed: T,
}

impl<T: Copy> SpinningBeam<T> {
    /// The beam without its spin.
    fn at_rest(self) -> GeneralBeam<T> {
        let SpinningBeam {
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

    /// A beam that spins, or the derivatives with respect to all of it.
    pub(crate) fn spinning(beam: GeneralBeam<T>, [polar_inertia_per_length, speed]: [T; 2]) -> Self {
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
        SpinningBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
            polar_inertia_per_length,
            speed,
        }
    }
}

impl<T: Parameter> Element for SpinningBeam<T> {
    type State = Bending;
    type Built = BuiltSpinningBeam<T>;
    const MAY_BUCKLE: bool = true;
    const IS_STRAIGHT: bool = false;

    fn build(self) -> Result<BuiltSpinningBeam<T>, InvalidParameter> {
        let beam = self.at_rest().build()?;
        let spin = Spin::new(self.polar_inertia_per_length, self.speed);
        spin.check("polar_inertia_per_length")?;
        Ok(BuiltSpinningBeam::new(beam, spin))
    }

    fn estimate(built: &BuiltSpinningBeam<T>, estimates: &mut FrequencyEstimates) {
        GeneralBeam::estimate(&built.beam, estimates);
        built.spin.estimate(estimates, built.beam.parameters.length.to_f64());
    }

    fn extent(built: &BuiltSpinningBeam<T>) -> Extent {
        built.beam.extent_of_shaft()
    }

    fn member_numbers(built: &BuiltSpinningBeam<T>) -> MemberNumbers {
        MemberNumbers::SpinningBeam(built.beam.numbers(), built.spin.numbers())
    }
}

impl<T: Parameter> Spins for SpinningBeam<T> {
    fn turned_round(built: BuiltSpinningBeam<T>) -> BuiltSpinningBeam<T> {
        built.turned_round()
    }
}

steps_of_built!(SpinningBeam at Frequency);

impl<T: Real> CarriesLoad for SpinningBeam<T> {}

impl<T: Real, S: Oscillation<T>> Energies<S> for SpinningBeam<T> {
    type Gradient = SpinningBeam<S>;

    energies_of_built!();

    fn damping_form(built: &BuiltSpinningBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first, second).damping
    }

    fn gradient(built: &BuiltSpinningBeam<T>, ends: &Ends<S>) -> SpinningBeam<S> {
        let (beam, spin) = built.gradient(ends);
        SpinningBeam::spinning(GeneralBeam::of_gradient(beam, &built.beam.parameters), spin)
    }
}

members_of_built!(SpinningBeam at Frequency);

impl<T: Real, S: Oscillation<T>> MemberGradient<S> for SpinningBeam<T> {
    type Gradient = SpinningBeam<S>;

    fn member_gradient(built: &BuiltSpinningBeam<T>, motion: &MemberEnds<S>) -> SpinningBeam<S> {
        let ends = motion.bending();
        <SpinningBeam<T> as Energies<S>>::gradient(built, &ends)
    }
}

#[cfg(test)]
impl crate::elements::laws::Sample for SpinningBeam<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let beam = GeneralBeam::sample(&mut next);
        SpinningBeam::spinning(beam, [0.01 * next(), next() - 1.25])
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn halves(self) -> Option<Self> {
        Some(SpinningBeam { length: self.length / 2.0, ..self })
    }

    fn phase(&self, s: f64) -> f64 {
        self.at_rest().phase(s)
    }

    fn untied(self) -> Self {
        SpinningBeam::spinning(self.at_rest().untied(), [self.polar_inertia_per_length, self.speed])
    }

    fn lossless(self) -> Self {
        SpinningBeam { speed: 0.0, ..self }
    }
}
