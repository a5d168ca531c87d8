//! The general beam, and beams with some of its parameters.

use crate::element::{
    BackTransfer, CarriesLoad, Element, Energies, Inside, MatrixOf, MemberNumbers, PlaneStep, TransferMatrix,
};
use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::compound::GeneralCompound;
#[cfg(test)]
use crate::elements::general_beam::constants::Constants;
use crate::elements::general_beam::of_built::{energies_of_built, steps_of_built};
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::general_beam::transfer::BackThrough;
use crate::elements::shared::compliance::{compliance, is_rigid};
use crate::model::{Bending, Ends, Extent, FrequencyEstimates, InvalidParameter, Requirement, State};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Scaled, Single};
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::Support;

/// The shear stiffness of a beam that has these fields; zero without one, and where it is rigid.
macro_rules! shear_stiffness {
    ($beam:ident shear_stiffness $($other:ident)*) => {
        if is_rigid($beam.shear_stiffness) { T::zero() } else { $beam.shear_stiffness }
    };
    ($beam:ident $other:ident $($field:ident)*) => { shear_stiffness!($beam $($field)*) };
    ($beam:ident) => { T::zero() };
}

/// Declares beams by their parameters, the general beam that each is, and its derivatives as those of the general beam.
macro_rules! kinds {
    ($(
        $(#[$doc:meta])*
        $kind:ident { $($(#[$field_doc:meta])* $field:ident,)* }
        checked by { $($checked:ident: $range:ident),* }
        is |$beam:ident| { $($parameter:ident: $value:expr),* }
        derived by |$gradient:ident, $built:ident| { $($derived:ident: $derivative:expr),* }
        may buckle: $may_buckle:literal
        sampled by { $($sampled:expr),* } tied by { $($tie:ident),* }
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $kind<T> {
            /// Length l \[m\], positive.
            pub length: T,
            /// Bending stiffness EI [N m²], positive.
            pub bending_stiffness: T,
            /// Mass per length m [kg/m], zero or positive.
            pub mass_per_length: T,
            $($(#[$field_doc])* pub $field: T,)*
        }

        impl<T: Parameter> $kind<T> {
            /// Its parameters as the equations have them.
            fn parameters(self) -> BeamParameters<T> {
                let $kind { length, bending_stiffness, mass_per_length, .. } = self;
                let $beam = self;
                let plain = BeamParameters {
                    length,
                    bending_stiffness,
                    mass_per_length,
                    shear_flexibility: T::zero(),
                    rotary_inertia: T::zero(),
                    axial_force: T::zero(),
                    foundation_stiffness: T::zero(),
                    foundation_shear_stiffness: T::zero(),
                };
                BeamParameters { $($parameter: $value,)* ..plain }
            }
        }

        impl<T: Parameter> Element for $kind<T> {
            type State = Bending;
            type Built = BuiltGeneralBeam<T>;
            const MAY_BUCKLE: bool = $may_buckle;
            const IS_STRAIGHT: bool = false;

            fn build(self) -> Result<BuiltGeneralBeam<T>, InvalidParameter> {
                $(Requirement::$range.check(stringify!($checked), self.$checked)?;)*
                BuiltGeneralBeam::new(self.parameters(), shear_stiffness!(self $($field)*))
            }

            fn add_axial_force(built: &mut BuiltGeneralBeam<T>, force: [f64; 2]) -> Result<bool, InvalidParameter> {
                if $may_buckle {
                    built.add_axial_force(force)?;
                }
                Ok($may_buckle)
            }

            fn estimate(built: &BuiltGeneralBeam<T>, estimates: &mut FrequencyEstimates) {
                built.estimate(estimates);
            }

            fn extent(built: &BuiltGeneralBeam<T>) -> Extent {
                built.extent()
            }

            fn member_numbers(built: &BuiltGeneralBeam<T>) -> MemberNumbers {
                MemberNumbers::Beam(built.numbers())
            }
        }

        steps_of_built!($kind at Frequency);

        impl<T: Real> CarriesLoad for $kind<T> {}

        impl<T: Real, S: Oscillation<T>> Energies<S> for $kind<T> {
            type Gradient = $kind<S>;

            energies_of_built!();

            fn gradient(built: &BuiltGeneralBeam<T>, ends: &Ends<S>) -> $kind<S> {
                $kind::of_gradient(built.motion(ends.x).gradient(ends), &built.parameters)
            }
        }

        impl<S: Scalar> $kind<S> {
            /// The derivatives with respect to its parameters, given those of the general beam.
            pub(super) fn of_gradient<T: Real>($gradient: BeamParameters<S>, $built: &BeamParameters<T>) -> Self
            where
                S: Frequency<T>,
            {
                $kind {
                    length: $gradient.length,
                    bending_stiffness: $gradient.bending_stiffness,
                    mass_per_length: $gradient.mass_per_length,
                    $($derived: $derivative,)*
                }
            }
        }

        #[cfg(test)]
        impl crate::elements::laws::Sample for $kind<f64> {
            fn sample(mut next: impl FnMut() -> f64) -> Self {
                let [length, bending_stiffness, mass_per_length] = [next(), next(), next()];
                $kind { length, bending_stiffness, mass_per_length, $($derived: $sampled(next())),* }
            }

            fn length(&self) -> f64 {
                self.length
            }

            fn halves(self) -> Option<Self> {
                Some($kind { length: self.length / 2.0, ..self })
            }

            fn phase(&self, s: f64) -> f64 {
                let constants = Constants::of(self.parameters());
                let h = constants.mass * s.powi(4) + constants.foundation;
                let g = constants.rotary * s.powi(4) + constants.tension.abs();
                h.sqrt().max(g).max(constants.tau * h).sqrt()
            }

            fn untied(self) -> Self {
                $kind { $($tie: 0.0,)* ..self }
            }
        }
    )*};
}

kinds! {
    /// Uniform beam with rotary inertia and without shear, exact at every frequency.
    ///
    /// # Source
    /// Rayleigh's beam, a [`GeneralBeam`] with `f = 0`.
    RayleighBeam {
        /// Rotary inertia per length `r = ρ I` [kg m], zero or positive.
        rotary_inertia,
    }
    checked by {}
    is |beam| { rotary_inertia: beam.rotary_inertia }
    derived by |general, _beam| { rotary_inertia: general.rotary_inertia }
    may buckle: false
    sampled by { |x| x * 0.005 } tied by {}

    /// Uniform beam with shear and rotary inertia, exact at every frequency; Θ is the rotation of the cross section.
    ///
    /// # Source
    /// Timoshenko's beam, a [`GeneralBeam`] with `f = 1/(k G A)`.
    TimoshenkoBeam {
        /// Shear stiffness `k G A` \[N\], positive, with a finite reciprocal; infinite is a beam without shear.
        shear_stiffness,
        /// Rotary inertia per length `r = ρ I` [kg m], zero or positive.
        rotary_inertia,
    }
    checked by { shear_stiffness: InvertibleOrInfinite }
    is |beam| { shear_flexibility: compliance(beam.shear_stiffness), rotary_inertia: beam.rotary_inertia }
    derived by |general, beam| {
        shear_stiffness: -(general.shear_flexibility * (beam.shear_flexibility * beam.shear_flexibility)),
        rotary_inertia: general.rotary_inertia
    }
    may buckle: false
    sampled by { |x| 100.0 / x, |x| x * 0.005 } tied by {}

    /// Uniform Euler-Bernoulli beam under an axial force, exact at every frequency: a strut, a bar in tension, a string that bends.
    ///
    /// Q contains the slope times the axial force, which keeps its direction; whether the forces of elements at a point are in equilibrium
    /// is not checked. Beyond the load at which it buckles a system has modes that grow.
    ///
    /// # Source
    /// A [`GeneralBeam`] with `T = N`.
    BeamColumn {
        /// Axial force N \[N\], positive in tension.
        axial_force,
    }
    checked by {}
    is |beam| { axial_force: beam.axial_force }
    derived by |general, _beam| { axial_force: general.axial_force }
    may buckle: true
    sampled by { |x| x - 1.25 } tied by { axial_force }

    /// Uniform Euler-Bernoulli beam on an elastic foundation, exact at every frequency.
    ///
    /// # Source
    /// The foundation of Winkler, with the shear layer of Pasternak: a [`GeneralBeam`] with `T = G`.
    FoundationBeam {
        /// Stiffness k of the foundation per length [N/m²], zero or positive.
        foundation_stiffness,
        /// Stiffness G of the shear layer \[N\], zero or positive.
        foundation_shear_stiffness,
    }
    checked by {}
    is |beam| {
        foundation_stiffness: beam.foundation_stiffness,
        foundation_shear_stiffness: beam.foundation_shear_stiffness
    }
    derived by |general, _beam| {
        foundation_stiffness: general.foundation_stiffness,
        foundation_shear_stiffness: general.foundation_shear_stiffness
    }
    may buckle: false
    sampled by { |x| x, |x| x * 0.5 } tied by { foundation_stiffness, foundation_shear_stiffness }

    /// Uniform beam with shear, rotary inertia, axial force and an elastic foundation, exact at every frequency.
    ///
    /// Θ is the rotation of the cross section. With `f = 1/(k G A)`, `T = N + G`, `σ = 1/(1 + T f)`, `τ = f σ`, `g = σ T + r λ²` and
    /// `h = -m λ² - k` the state obeys
    ///
    /// ```text
    /// Y' = σ Θ - τ Q     Θ' = M/EI     M' = g Θ + σ Q     Q' = h Y
    /// ```
    ///
    /// Q does work on Y: `-Q = (Y' - Θ)/f + T Y'` contains the slope times the axial force, so that joints, springs and supports need no other
    /// formulas, and at a free end `Q = 0` is the condition of a load that keeps its direction. The transfer matrix is `exp(A l)` of these four
    /// equations, in functions of two squared wave numbers that are entire in both.
    ///
    /// The axial force is that of the element alone: whether the forces of elements at a point are in equilibrium is not checked.
    ///
    /// # Source
    /// Timoshenko's beam with axial force after Engesser, on a foundation of Winkler and Pasternak: `V = ½ ∫ EI Θ'² + (Y' - Θ)²/f + T Y'² + k Y²`,
    /// with the kinetic energy `½ ∫ m Ẏ² + r Θ̇²`.
    GeneralBeam {
        /// Shear stiffness `k G A` \[N\], positive, with a finite reciprocal; infinite is a beam without shear.
        shear_stiffness,
        /// Rotary inertia per length `r = ρ I` [kg m], zero or positive.
        rotary_inertia,
        /// Axial force N \[N\], positive in tension; greater than `-kGA - G`.
        axial_force,
        /// Stiffness k of the foundation per length [N/m²], zero or positive.
        foundation_stiffness,
        /// Stiffness G of the shear layer of the foundation \[N\], zero or positive.
        foundation_shear_stiffness,
    }
    checked by { shear_stiffness: InvertibleOrInfinite }
    is |beam| {
        shear_flexibility: compliance(beam.shear_stiffness),
        rotary_inertia: beam.rotary_inertia,
        axial_force: beam.axial_force,
        foundation_stiffness: beam.foundation_stiffness,
        foundation_shear_stiffness: beam.foundation_shear_stiffness
    }
    derived by |general, beam| {
        shear_stiffness: -(general.shear_flexibility * (beam.shear_flexibility * beam.shear_flexibility)),
        rotary_inertia: general.rotary_inertia,
        axial_force: general.axial_force,
        foundation_stiffness: general.foundation_stiffness,
        foundation_shear_stiffness: general.foundation_shear_stiffness
    }
    may buckle: true
    sampled by { |x| 100.0 / x, |x| x * 0.005, |x| x - 1.25, |x| x, |x| x * 0.5 }
    tied by { axial_force, foundation_stiffness, foundation_shear_stiffness }
}
