//! Spring of a seal or a fluid film, which pushes a whirling shaft along its path.

use crate::element::{
    BackTransfer, Charted, Element, Energies, Forms, MemberEnds, MemberGradient, MemberMotion, MemberNumbers,
    PlaneStep, Spins, TransferMatrix, along_member,
};
use crate::elements::shared::connector::connector;
use crate::elements::shared::damped_stiffness::DampedStiffness;
use crate::elements::shared::line_forms::{elongations, half, unit_of};
use crate::elements::shared::line_step::{back_through_stiffness, through_stiffness};
use crate::elements::shared::massless::{elongation, off_pole};
use crate::model::{EndMotion, Ends, FrequencyEstimates, InvalidParameter, Requirement, Translation};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Single, Truth};
use crate::structure::Chart;
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::Coordinate;
use nalgebra::Matrix2;

/// Massless spring that is alike in all directions across a shaft, with forces across its displacement:
/// `Q = (K (1 + iη)(1 + cλ) + dλ - i (k_c + c_c λ))(Y_I - Y_O)` with `Y = v + iw`, at complex frequencies λ only.
///
/// A positive cross stiffness drives forward whirl, and damps backward whirl, which sees both cross terms with the other sign.
///
/// # Source
/// Eq. (3) of the paper with a complex stiffness; Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), 7.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossCoupledSpring<T> {
    /// Stiffness K [N/m], positive, with a finite reciprocal.
    pub stiffness: T,
    /// Loss factor η, zero or positive.
    pub loss_factor: T,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    pub kelvin_voigt_time: T,
    /// Damping d of a dashpot beside it, [N s/m], zero or positive.
    pub damping: T,
    /// Cross stiffness k_c [N/m], of either sign: the force in y of a displacement in z is `-k_c z`, that in z of one in y `k_c y`.
    pub cross_stiffness: T,
    /// Cross damping c_c [N s/m], of either sign.
    pub cross_damping: T,
}

/// A cross-coupled spring as a whirl sees it.
#[derive(Clone, Copy, Debug)]
pub struct BuiltCrossCoupledSpring<T> {
    spring: DampedStiffness<T>,
    /// Cross stiffness and cross damping, with the sign of the whirl.
    cross: [T; 2],
    /// 1 for forward whirl, -1 for backward whirl.
    sense: T,
}

/// `-i`.
fn quarter_turn_back<T, S: ComplexFrequency<T>>() -> S {
    S::one().signed_omega()
}

impl<T: Parameter> BuiltCrossCoupledSpring<T> {
    /// The dynamic stiffness `κ = K (1 + iη)(1 + cλ) + dλ - i (k_c + c_c λ)`.
    fn at<S: ComplexFrequency<T>>(&self, lambda: S) -> S {
        let [stiffness, damping] = self.cross;
        let across = S::from_parameter(stiffness) + lambda * damping;
        self.spring.at(lambda) + quarter_turn_back::<T, S>() * across
    }

    /// The sum of the sizes of its terms: κ itself may cancel.
    fn size(&self, lambda: f64) -> f64 {
        let [stiffness, damping] = self.cross.map(|part| part.to_f64().abs());
        self.spring.size(lambda) + stiffness + damping * lambda
    }
}

impl<T: Real> BuiltCrossCoupledSpring<T> {
    /// The forms of two motions, the first at λ, given the product of their elongations.
    fn forms<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S, product: S) -> Forms<S> {
        let Forms { mass, stiffness, damping } = self.spring.forms(lambda, product);
        let [across, swept] = self.cross.map(|term| quarter_turn_back::<T, S>() * (product * term));
        Forms { mass, stiffness: stiffness + across, damping: damping + swept }
    }

    /// The derivatives of the dynamic work with respect to all parameters, given the square of the elongation.
    fn gradient<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S, square: S) -> CrossCoupledSpring<S> {
        let [stiffness, loss_factor, kelvin_voigt_time, damping] = self.spring.gradient(lambda, square);
        let cross_stiffness = quarter_turn_back::<T, S>() * half(square) * self.sense;
        let cross_damping = cross_stiffness * lambda;
        CrossCoupledSpring { stiffness, loss_factor, kelvin_voigt_time, damping, cross_stiffness, cross_damping }
    }

    /// The elongation between both ends of a member.
    fn elongation<S: ComplexFrequency<T> + Oscillation<T>>(&self, x: S, ends: &[EndMotion<S>; 2]) -> S {
        elongation(self.at(x), self.size(S::size(x)), ends, 0)
    }
}

impl<T: Parameter> Element for CrossCoupledSpring<T> {
    type State = Translation;
    type Built = BuiltCrossCoupledSpring<T>;

    fn build(self) -> Result<Self::Built, InvalidParameter> {
        let CrossCoupledSpring { stiffness, loss_factor, kelvin_voigt_time: time, damping, .. } = self;
        let parameters = [stiffness, loss_factor, time, damping];
        let spring = DampedStiffness::new(Requirement::InvertibleOrZero, parameters, ["stiffness", "damping"])?;
        Requirement::Finite.check("cross_stiffness", self.cross_stiffness)?;
        Requirement::Finite.check("cross_damping", self.cross_damping)?;
        Ok(BuiltCrossCoupledSpring { spring, cross: [self.cross_stiffness, self.cross_damping], sense: T::one() })
    }

    fn estimate(built: &Self::Built, estimates: &mut FrequencyEstimates) {
        let of_path = [FrequencyEstimates::translational_stiffness, FrequencyEstimates::translational_damping];
        built.spring.estimate(estimates, of_path);
        if !built.cross.iter().all(|term| term.vanishes().all()) {
            estimates.whirl();
        }
    }

    fn member_numbers(built: &Self::Built) -> MemberNumbers {
        let damping = built.spring.dissipation.numbers().across(built.cross.map(T::words));
        MemberNumbers::Spring(0, built.spring.stiffness.words()).damped(damping)
    }
}

impl<T: Parameter> Spins for CrossCoupledSpring<T> {
    fn turned_round(built: Self::Built) -> Self::Built {
        let turned = |number: T| T::zero() - number;
        BuiltCrossCoupledSpring { cross: built.cross.map(turned), sense: turned(built.sense), ..built }
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for CrossCoupledSpring<T> {
    fn transfer_matrix(built: &Self::Built, x: S) -> Matrix2<S> {
        let (_, compliance) = off_pole(built.at(x));
        Matrix2::new(S::one(), -compliance, S::zero(), S::one())
    }

    fn denominator(built: &Self::Built, x: S) -> Option<S> {
        Some(off_pole(built.at(x)).0)
    }
}

impl<T: Parameter, S: ComplexFrequency<T>> PlaneStep<S> for CrossCoupledSpring<T> {
    type Coefficients = S;

    fn coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> S {
        built.at(at.x)
    }

    fn step<C: RootCounter<S>>(kappa: &S, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        through_stiffness(*kappa, input, counter)
    }
}

impl<T: Parameter, S: ComplexFrequency<T>> Charted<S> for CrossCoupledSpring<T> {
    fn chart(built: &Self::Built, at: &FrequencyPowers<S>, _length: S) -> Chart<S> {
        connector(built.at(at.x), along_member::<Self>())
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberMotion<S> for CrossCoupledSpring<T> {
    fn forms(built: &Self::Built, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let [one, other] = [first, second].map(|motion| built.elongation(motion.x, &motion.ends));
        built.forms(first.x, one * other)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberGradient<S> for CrossCoupledSpring<T> {
    type Gradient = CrossCoupledSpring<S>;

    fn member_gradient(built: &Self::Built, motion: &MemberEnds<S>) -> CrossCoupledSpring<S> {
        let elongation = built.elongation(motion.x, &motion.ends);
        built.gradient(motion.x, elongation * elongation)
    }
}

impl<T: Real, S: ComplexFrequency<T>> BackTransfer<S> for CrossCoupledSpring<T> {
    type BackCoefficients = S;
    const SYMMETRIC: bool = true;

    fn reversed(built: &Self::Built) -> Self::Built {
        *built
    }

    fn back_coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> S {
        built.at(at.x)
    }

    fn back_transfer(kappa: &S, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        back_through_stiffness(*kappa, input, covector)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> Energies<S> for CrossCoupledSpring<T> {
    type Gradient = CrossCoupledSpring<S>;

    fn units(built: &Self::Built, at: &FrequencyPowers<S>) -> [f64; 2] {
        unit_of(Coordinate::Y, built.size(S::size(at.x)))
    }

    fn mass_form(_built: &Self::Built, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn stiffness_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first.x, elongations(Coordinate::Y, first, second)).stiffness
    }

    fn damping_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first.x, elongations(Coordinate::Y, first, second)).damping
    }

    fn gradient(built: &Self::Built, ends: &Ends<S>) -> CrossCoupledSpring<S> {
        built.gradient(ends.x, elongations(Coordinate::Y, ends, ends))
    }
}

#[cfg(test)]
impl super::laws::Sample for CrossCoupledSpring<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        CrossCoupledSpring {
            stiffness: next(),
            loss_factor: 0.2 * next(),
            kelvin_voigt_time: next(),
            damping: 0.5 * next(),
            cross_stiffness: next() - 1.25,
            cross_damping: next() - 1.25,
        }
    }

    fn lossless(self) -> Self {
        CrossCoupledSpring { loss_factor: 0.0, cross_stiffness: 0.0, cross_damping: 0.0, ..self }
    }
}
