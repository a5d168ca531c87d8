//! An element of one's own, in a crate of its own: a string in tension.
#![no_std]

mod member;
mod motion;

use mstmm::element::{
    Element, Extent, FrequencyEstimates, FrequencyPowers, InvalidParameter, Line, PlaneStep, Requirement, RootCounter,
    SMatrix, Subspace, TransferMatrix, Translation,
};
use mstmm::number::{Frequency, Parameter, Single, Size};

/// A uniform string in tension, exact at every frequency.
///
/// Transfer matrix on `[Y, Q]` with `φ = ω l sqrt(m/H)`:
///
/// ```text
/// cos φ           -(l/H) sin φ/φ
/// (H/l) φ sin φ    cos φ
/// ```
///
/// The wave equation `H Y'' = mλ² Y` with the transverse force `Q = -H Y'` in the sign convention of a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cable<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Tension H \[N\], positive.
    pub tension: T,
    /// Mass per length m [kg/m], positive.
    pub mass_per_length: T,
}

impl<T: Parameter> Element for Cable<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("tension", self.tension)?;
        Requirement::Positive.check("mass_per_length", self.mass_per_length)?;
        Ok(self)
    }

    fn estimate(cable: &Self, estimates: &mut FrequencyEstimates) {
        let (l, h, m) = (cable.length.to_f64(), cable.tension.to_f64(), cable.mass_per_length.to_f64());
        estimates.waves(mstmm::number::Scalar::sqrt(h / m) / l);
        estimates.translational_stiffness(h / l);
        estimates.mass(m * l);
    }

    fn extent(cable: &Self) -> Extent {
        Extent::along(cable.length.to_f64())
    }
}

impl<T: Parameter> Cable<T> {
    /// `cos φ` and `sin φ/φ`, entire in `φ² = -mλ²l²/H`, and φ.
    fn waves<S: Frequency<T>>(&self, lambda_squared: S) -> (S, S, S) {
        let phi = (-lambda_squared * (self.mass_per_length / self.tension * self.length * self.length)).sqrt();
        let (sin, cos) = phi.sin_cos();
        (cos, S::select(phi.vanishes(), S::one(), sin / phi), phi)
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for Cable<T> {
    fn transfer_matrix(cable: &Self, x: S) -> SMatrix<S, 2, 2> {
        let (cos, sinc, phi) = cable.waves(x.lambda_squared());
        let flexibility = cable.length / cable.tension;
        SMatrix::<S, 2, 2>::new(cos, -(sinc * flexibility), phi * phi * sinc * (T::one() / flexibility), cos)
    }
}

/// What depends on the frequency: the transfer matrix by name, and φ for the count.
#[derive(Clone, Copy, Debug)]
pub struct CableCoefficients<S> {
    cos: S,
    flexibility: S,
    stiffness: S,
    phi: S,
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for Cable<T> {
    type Coefficients = CableCoefficients<S>;

    fn coefficients(cable: &Self, at: &FrequencyPowers<S>) -> CableCoefficients<S> {
        let (cos, sinc, phi) = cable.waves(at.lambda_squared);
        let flexibility = cable.length / cable.tension;
        let stiffness = phi * phi * sinc * (T::one() / flexibility);
        CableCoefficients { cos, flexibility: sinc * flexibility, stiffness, phi }
    }

    fn step<C: RootCounter<S>>(k: &CableCoefficients<S>, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        let before = input.line();
        let (y, q) = (k.cos * before.y - k.flexibility * before.q, k.stiffness * before.y + k.cos * before.q);
        let after = Line::new(y, q, before.exponent);
        if C::COUNTS {
            // held at both ends it vibrates at φ = π, 2π, ..; the sign of sin φ is that of its flexibility
            let (half_waves, is_odd) = (k.phi.size() / S::Size::of(core::f64::consts::PI)).whole();
            counter.line(&before, &after, half_waves, is_odd);
        }
        Subspace::Line(after, input.space())
    }
}
