//! Massless rigid link in a bending path; the same under an axial force.

use crate::element::{BackTransfer, BodyNumbers, Element, Energies, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::shared::arm::Arm;
use crate::elements::shared::axial_force::{AxialForce, before_stiffness, stiffened, under_axial_force};
use crate::model::{Bending, Ends, Extent, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::subspace::{Covector, RootCounter, Subspace};
use nalgebra::Matrix4;

/// Massless rigid link from one point of a bending path to another: an offset, or an arm of a body with several points.
///
/// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus b at (Y, Θ) and at (M, Q), with the output end at b along the path.
///
/// # Source
/// Eq. (16) of the paper without mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lever<T> {
    /// Position b of the output end from the input end \[m\], of any sign, or zero.
    pub output_x: T,
}

impl<T: Parameter> Element for Lever<T> {
    type State = Bending;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Finite.check("output_x", self.output_x)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.lever(built.output_x.to_f64());
    }

    fn extent(built: &Self) -> Extent {
        Extent::along(built.output_x.to_f64())
    }

    fn member_numbers(built: &Self) -> MemberNumbers {
        MemberNumbers::Body(BodyNumbers { output_x: built.output_x.words(), ..BodyNumbers::default() })
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for Lever<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, _x: S) -> Matrix4<S> {
        let (mut u, b) = (Matrix4::identity(), S::from_parameter(built.output_x));
        u[(0, 1)] = b;
        u[(2, 3)] = b;
        u
    }
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for Lever<T> {
    type Coefficients = Arm<T>;

    #[inline(always)]
    fn coefficients(built: &Self, _at: &FrequencyPowers<S>) -> Arm<T> {
        Arm::new(built.output_x)
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(arm: &Arm<T>, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        Subspace::Plane(arm.carried(&input.plane(), counter))
    }
}

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for Lever<T> {
    type BackCoefficients = Arm<T>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &Self) -> Self {
        *built
    }

    fn back_coefficients(built: &Self, _at: &FrequencyPowers<S>) -> Arm<T> {
        Arm::new(built.output_x)
    }

    fn back_transfer(arm: &Arm<T>, _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        Covector::Plane([y, theta + arm.times(y), m, q + arm.times(m)], exponent)
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for Lever<T> {
    type Gradient = Lever<S>;

    fn units(_built: &Self, _at: &FrequencyPowers<S>) -> [f64; 2] {
        [0.0; 2]
    }

    fn mass_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn stiffness_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    /// The shift of the output end moves what is downstream by Θ: its derivative is the work `Q_O Θ`.
    fn gradient(_built: &Self, ends: &Ends<S>) -> Lever<S> {
        Lever { output_x: ends.output.q * ends.input.theta }
    }
}

under_axial_force! {
    /// Massless rigid link under an axial force N: the limit `EI → ∞` of a beam under that force.
    ///
    /// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus b at (Y, Θ) and at (M, Q) and the geometric stiffness `N |b|` at (M, Θ), with
    /// the output end at b along the path.
    ///
    /// # Source
    /// Eq. (16) of the paper without mass, and the second variation of the work of N.
    LeverColumn of Lever {
        /// Position b of the output end from the input end \[m\], of any sign, or zero.
        output_x,
    }
}

#[cfg(test)]
impl super::laws::Sample for LeverColumn<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        LeverColumn { output_x: next() - 1.0, axial_force: next() - 1.0 }
    }

    fn halves(self) -> Option<Self> {
        Some(LeverColumn { output_x: self.output_x / 2.0, ..self })
    }

    fn untied(self) -> Self {
        LeverColumn { axial_force: 0.0, ..self }
    }
}

#[cfg(test)]
impl super::laws::Sample for Lever<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Lever { output_x: next() - 1.0 }
    }

    fn halves(self) -> Option<Self> {
        Some(Lever { output_x: self.output_x / 2.0 })
    }
}
