//! A beam that spins about its axis, with damping.

use crate::element::{
    BackTransfer, CarriesLoad, Charted, DampingNumbers, Deflection, Element, Energies, Forms, Inside, MatrixOf,
    MemberEnds, MemberGradient, MemberMotion, MemberNumbers, PlaneStep, Spins, TransferMatrix,
};
use crate::elements::general_beam::compound::GeneralCompound;
use crate::elements::general_beam::damped_spinning::BuiltDampedSpinningBeam;
use crate::elements::general_beam::kinds::GeneralBeam;
use crate::elements::general_beam::of_built::{energies_of_built, members_of_built, steps_of_built};
use crate::elements::general_beam::spinning_beam::SpinningBeam;
use crate::elements::general_beam::transfer::BackThrough;
use crate::elements::in_plane::across::ChartedAcross;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::model::{Bending, EndMotion, Ends, Extent, FrequencyEstimates, InvalidParameter, State};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Scaled, Single};
use crate::structure::Chart;
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::Support;

/// Uniform shaft that spins about its axis, with damping, exact at every frequency: a [`SpinningBeam`] with `EI e`, `kGA e` and `k + c_e λ`, where
/// `e = 1 + t (λ - iΩ)`, which exists at complex frequencies λ only.
///
/// The damping of its material turns with the shaft, and drives forward whirl where the speed is beyond its frequency. The medium around it stands still. A
/// loss factor would change its sign there, so that it has none.
///
/// # Source
/// The viscoelastic solid of Kelvin and Voigt in the frame that turns with the shaft; Genta, Dynamics of Rotating Systems (2005), 2.4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedSpinningBeam<T> {
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
    /// Time t of Kelvin and Voigt \[s\] of the material, zero or positive.
    pub kelvin_voigt_time: T,
    /// Damping c_e per length against deflections [N s/m²] of a medium at rest, zero or positive.
    pub external_damping: T,
}

impl<T: Copy> DampedSpinningBeam<T> {
    /// The beam without its damping.
    fn undamped(self) -> SpinningBeam<T> {
        let DampedSpinningBeam {
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
            ..
        } = self;
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

    /// A beam with damping, or the derivatives with respect to all of it.
    pub(crate) fn with_damping(beam: SpinningBeam<T>, [kelvin_voigt_time, external_damping]: [T; 2]) -> Self {
        let SpinningBeam {
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
        } = beam;
        DampedSpinningBeam {
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
            kelvin_voigt_time,
            external_damping,
        }
    }
}

impl<T: Parameter> Element for DampedSpinningBeam<T> {
    type State = Bending;
    type Built = BuiltDampedSpinningBeam<T>;
    const IS_STRAIGHT: bool = false;

    fn build(self) -> Result<Self::Built, InvalidParameter> {
        let undamped = self.undamped().build()?;
        BuiltDampedSpinningBeam::new(undamped.beam, undamped.spin, [self.kelvin_voigt_time, self.external_damping])
    }

    fn estimate(built: &Self::Built, estimates: &mut FrequencyEstimates) {
        GeneralBeam::estimate(&built.beam, estimates);
        built.spin.estimate(estimates, built.beam.parameters.length.to_f64());
        built.estimate(estimates);
    }

    fn extent(built: &Self::Built) -> Extent {
        built.beam.extent_of_shaft()
    }

    fn member_numbers(built: &Self::Built) -> MemberNumbers {
        let [time, viscous] = built.damping();
        let damping = DampingNumbers { time, viscous, ..DampingNumbers::default() };
        MemberNumbers::DampedSpinningBeam(built.beam.numbers(), damping, built.spin.numbers())
    }
}

impl<T: Parameter> Spins for DampedSpinningBeam<T> {
    fn turned_round(built: Self::Built) -> Self::Built {
        built.turned_round()
    }
}

steps_of_built!(DampedSpinningBeam at ComplexFrequency);

impl<T: Real> CarriesLoad for DampedSpinningBeam<T> {}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> Energies<S> for DampedSpinningBeam<T> {
    type Gradient = DampedSpinningBeam<S>;

    energies_of_built!();

    fn damping_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first, second).damping
    }

    fn gradient(built: &Self::Built, ends: &Ends<S>) -> DampedSpinningBeam<S> {
        let (beam, [time, external, polar_inertia, speed]) = built.gradient(ends);
        let beam = GeneralBeam::of_gradient(beam, &built.beam.parameters);
        DampedSpinningBeam::with_damping(SpinningBeam::spinning(beam, [polar_inertia, speed]), [time, external])
    }
}

members_of_built!(DampedSpinningBeam at ComplexFrequency);

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberGradient<S> for DampedSpinningBeam<T> {
    type Gradient = DampedSpinningBeam<S>;

    fn member_gradient(built: &Self::Built, motion: &MemberEnds<S>) -> DampedSpinningBeam<S> {
        let ends = motion.bending();
        <DampedSpinningBeam<T> as Energies<S>>::gradient(built, &ends)
    }
}

#[cfg(test)]
impl crate::elements::laws::Sample for DampedSpinningBeam<f64> {
    /// A beam whose stiffness vanishes far from the frequencies of the laws.
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let beam = SpinningBeam::sample(&mut next);
        DampedSpinningBeam::with_damping(beam, [0.005 * next(), 0.5 * next()])
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn halves(self) -> Option<Self> {
        Some(DampedSpinningBeam { length: self.length / 2.0, ..self })
    }

    fn phase(&self, s: f64) -> f64 {
        // near λ = -1/t the stiffness is a small part of what it is at rest
        10.0 * self.undamped().phase(s)
    }

    fn untied(self) -> Self {
        DampedSpinningBeam::with_damping(self.undamped().untied(), [self.kelvin_voigt_time, self.external_damping])
    }

    fn lossless(self) -> Self {
        DampedSpinningBeam { speed: 0.0, ..self }
    }
}
