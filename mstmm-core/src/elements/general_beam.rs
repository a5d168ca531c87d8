//! The general uniform beam: shear, rotary inertia, axial force, elastic foundation.

use crate::element::{BeamNumbers, Element, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::shared::compound::Units;
use crate::model::{Bending, Extent, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Parameter, Scaled, Single, Truth};
use crate::subspace::{RootCounter, Subspace};
use compound::GeneralCompound;
use constants::{Constants, SectionAt};
use mstmm_plan::Support;
use nalgebra::Matrix4;
use transfer::Transfer;

mod chart;
mod compound;
mod constants;
mod damped;
mod damped_kinds;
mod damped_members;
mod held;
mod inside;
mod kinds;
mod members;
mod motion;
mod transfer;
mod under_load;
mod wave_pair;

pub use damped_kinds::{DampedBeam, DampedTimoshenkoBeam, DampedUniformBeam};
pub use damped_members::{PlanarDampedBeam, PlanarDampedTimoshenkoBeam, PlanarDampedUniformBeam};
pub use kinds::{BeamColumn, FoundationBeam, RayleighBeam, TimoshenkoBeam, UniformBeam};
pub use members::{
    PlanarBeamColumn, PlanarFoundationBeam, PlanarGeneralBeam, PlanarRayleighBeam, PlanarTimoshenkoBeam,
    PlanarUniformBeam,
};

/// Uniform beam with shear, rotary inertia, axial force and an elastic foundation, exact at every frequency.
///
/// Θ is the rotation of the cross section. With `T = N + G`, `σ = 1/(1 + T f)`, `τ = f σ`, `g = σ T + r λ²` and `h = -m λ² - k` the state
/// obeys
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralBeam<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Bending stiffness EI [N m²], positive.
    pub bending_stiffness: T,
    /// Mass per length m [kg/m], positive.
    pub mass_per_length: T,
    /// Shear flexibility `f = 1/(k G A)` [1/N], zero or positive; zero is a beam without shear.
    pub shear_flexibility: T,
    /// Rotary inertia per length `r = ρ I` [kg m], zero or positive.
    pub rotary_inertia: T,
    /// Axial force N \[N\], positive in tension; greater than `-1/f - G` where f is not zero.
    pub axial_force: T,
    /// Stiffness k of the foundation per length [N/m²], zero or positive.
    pub foundation_stiffness: T,
    /// Stiffness G of the shear layer of the foundation \[N\], zero or positive.
    pub foundation_shear_stiffness: T,
}

/// A beam with its quantities that do not depend on the frequency.
#[derive(Clone, Copy, Debug)]
pub struct BuiltGeneralBeam<T> {
    parameters: GeneralBeam<T>,
    /// The shear stiffness, if the shear flexibility is its rounded inverse; else zero.
    shear_stiffness: T,
    constants: Constants<T>,
    units: Units<T>,
}

impl<T: Parameter> Element for GeneralBeam<T> {
    type State = Bending;
    type Built = BuiltGeneralBeam<T>;
    const MAY_BUCKLE: bool = true;
    const IS_STRAIGHT: bool = false;

    fn build(self) -> Result<BuiltGeneralBeam<T>, InvalidParameter> {
        self.check()?;
        let built = BuiltGeneralBeam {
            parameters: self,
            shear_stiffness: T::zero(),
            constants: Constants::of(self),
            units: Units::new(self.bending_stiffness, T::one() / self.length),
        };
        if let Some((parameter, value)) = built.constants.out_of_range(&self) {
            return Err(InvalidParameter { parameter, value, requirement: Requirement::Rescale });
        }
        if !built.units.are_in_range() {
            let powers = [("bending_stiffness", self.bending_stiffness), ("length", self.length)];
            return Err(InvalidParameter::most_extreme(powers));
        }
        Ok(built)
    }

    fn estimate(built: &BuiltGeneralBeam<T>, estimates: &mut FrequencyEstimates) {
        let GeneralBeam { length, bending_stiffness, mass_per_length, rotary_inertia, .. } = built.parameters;
        let [l, ei, m, r] = [length, bending_stiffness, mass_per_length, rotary_inertia].map(T::to_f64);
        let foundation = built.parameters.foundation_stiffness.to_f64();
        // where bending has z = 1
        estimates.waves((T::one() / built.constants.mass).sqrt().to_f64());
        estimates.translational_stiffness(ei / (l * l * l));
        estimates.translational_stiffness(foundation * l);
        estimates.translational_stiffness(built.parameters.tension().to_f64().abs() / l);
        estimates.torsional_stiffness(ei / l);
        estimates.length(l);
        estimates.mass(m * l);
        estimates.moment_of_inertia(m * l * l * l);
        estimates.moment_of_inertia(r * l);
    }

    fn extent(built: &BuiltGeneralBeam<T>) -> Extent {
        Extent::along(built.parameters.length.to_f64())
    }

    fn member_numbers(built: &BuiltGeneralBeam<T>) -> MemberNumbers {
        MemberNumbers::Beam(built.numbers(T::zero()))
    }
}

impl<T: Parameter> BuiltGeneralBeam<T> {
    /// Its numbers, with an axial stiffness; zero without longitudinal vibration.
    fn numbers(&self, axial_stiffness: T) -> BeamNumbers {
        BeamNumbers {
            length: self.parameters.length.words(),
            bending_stiffness: self.parameters.bending_stiffness.words(),
            mass_per_length: self.parameters.mass_per_length.words(),
            axial_stiffness: axial_stiffness.words(),
            shear_flexibility: if self.shear_stiffness.vanishes().all() {
                self.parameters.shear_flexibility.words()
            } else {
                [0.0; 2]
            },
            shear_stiffness: self.shear_stiffness.words(),
            rotary_inertia: self.parameters.rotary_inertia.words(),
            axial_force: self.parameters.axial_force.words(),
            shear_layer: self.parameters.foundation_shear_stiffness.words(),
            foundation_stiffness: self.parameters.foundation_stiffness.words(),
        }
    }
}

impl<T: Parameter> GeneralBeam<T> {
    /// What holds against the slope, `N + G`.
    pub(crate) fn tension(&self) -> T {
        self.axial_force + self.foundation_shear_stiffness
    }

    /// Whether it has neither shear nor rotary inertia nor an axial force.
    fn bends_only(&self) -> bool {
        let others = [self.shear_flexibility, self.rotary_inertia, self.axial_force, self.foundation_shear_stiffness];
        others.iter().all(|parameter| parameter.vanishes().all())
    }

    /// Checks each parameter against its range.
    fn check(&self) -> Result<(), InvalidParameter> {
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("bending_stiffness", self.bending_stiffness)?;
        Requirement::Positive.check("mass_per_length", self.mass_per_length)?;
        Requirement::NonNegative.check("shear_flexibility", self.shear_flexibility)?;
        Requirement::NonNegative.check("rotary_inertia", self.rotary_inertia)?;
        Requirement::NonNegative.check("foundation_stiffness", self.foundation_stiffness)?;
        Requirement::NonNegative.check("foundation_shear_stiffness", self.foundation_shear_stiffness)?;
        if self.shear_flexibility.vanishes().all() {
            return Requirement::Finite.check("axial_force", self.axial_force);
        }
        let bound = T::zero() - T::one() / self.shear_flexibility - self.foundation_shear_stiffness;
        let formula = "-shear_stiffness - foundation_shear_stiffness";
        Requirement::above(bound, formula).check("axial_force", self.axial_force)
    }
}

impl<S> GeneralBeam<S> {
    /// The parameters as numbers of another type.
    #[inline]
    pub(crate) fn map<R>(self, to: impl Fn(S) -> R) -> GeneralBeam<R> {
        GeneralBeam {
            length: to(self.length),
            bending_stiffness: to(self.bending_stiffness),
            mass_per_length: to(self.mass_per_length),
            shear_flexibility: to(self.shear_flexibility),
            rotary_inertia: to(self.rotary_inertia),
            axial_force: to(self.axial_force),
            foundation_stiffness: to(self.foundation_stiffness),
            foundation_shear_stiffness: to(self.foundation_shear_stiffness),
        }
    }

    /// The derivatives themselves; the kinds of the general beam have other parameters.
    fn of_gradient<T>(gradient: Self, _beam: &GeneralBeam<T>) -> Self {
        gradient
    }
}

impl<T: Parameter> BuiltGeneralBeam<T> {
    /// The constants of the equations at a frequency. In extended precision they are computed anew, since `build` has rounded.
    #[inline]
    fn at<S: Frequency<T>>(&self, lambda_squared: S) -> SectionAt<S> {
        if S::IS_EXTENDED {
            return Constants::of(self.parameters.map(S::from_parameter)).at(lambda_squared);
        }
        self.constants.map(S::from_parameter).at(lambda_squared)
    }

    /// The units of minors.
    #[inline]
    fn units<S: Frequency<T>>(&self) -> Units<S> {
        let GeneralBeam { length, bending_stiffness, .. } = self.parameters;
        if S::IS_EXTENDED {
            return Units::new(S::from_parameter(bending_stiffness), S::one() / S::from_parameter(length));
        }
        self.units.map(S::from_parameter)
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for GeneralBeam<T> {
    fn transfer_matrix(built: &BuiltGeneralBeam<T>, x: S) -> Matrix4<S> {
        Transfer::new(&built.at(x.lambda_squared())).matrix(&built.parameters.map(S::from_parameter))
    }
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for GeneralBeam<T> {
    type Coefficients = GeneralCompound<S>;

    fn coefficients(built: &BuiltGeneralBeam<T>, at: &FrequencyPowers<S>) -> GeneralCompound<S> {
        GeneralCompound::new(built.at(at.lambda_squared), built.units())
    }

    fn step<C: RootCounter<S>>(compound: &GeneralCompound<S>, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        compound.step(input, counter)
    }

    fn root<C: RootCounter<S>>(
        compound: &GeneralCompound<S>,
        input: Subspace<S>,
        support: Support,
        counter: &mut C,
    ) -> Scaled<S> {
        compound.root(input, support, counter)
    }
}

#[cfg(test)]
impl super::laws::Sample for GeneralBeam<f64> {
    /// A beam whose clamped frequencies are above 2, in compression as often as in tension.
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        GeneralBeam {
            length: next(),
            bending_stiffness: next(),
            mass_per_length: next(),
            shear_flexibility: next() * 0.005,
            rotary_inertia: next() * 0.005,
            axial_force: next() - 1.25,
            foundation_stiffness: next(),
            foundation_shear_stiffness: next() * 0.5,
        }
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn halves(self) -> Option<Self> {
        Some(GeneralBeam { length: self.length / 2.0, ..self })
    }

    fn phase(&self, s: f64) -> f64 {
        let constants = Constants::of(*self);
        let h = constants.mass * s.powi(4) + constants.foundation;
        let g = constants.rotary * s.powi(4) + constants.tension.abs();
        h.sqrt().max(g).max(constants.tau * h).sqrt()
    }

    fn untied(self) -> Self {
        GeneralBeam { foundation_stiffness: 0.0, foundation_shear_stiffness: 0.0, axial_force: 0.0, ..self }
    }
}

#[cfg(test)]
mod tests;
