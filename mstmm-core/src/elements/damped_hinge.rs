//! A hinge with damping in a bending path.

use crate::element::{BackTransfer, Element, Energies, PlaneStep, TransferMatrix};
use crate::elements::shared::damped_ties::DampedTies;
#[cfg(test)]
use crate::elements::shared::damped_ties::by_compliance;
use crate::elements::shared::line_forms::elongations;
use crate::model::{Bending, Ends, FrequencyEstimates, InvalidParameter};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Single, Size, Truth};
use crate::subspace::{Covector, Held, Plane, RootCounter, Subspace};
use mstmm_plan::Coordinate;
use nalgebra::Matrix4;

/// Massless hinge in a bending path with damping, at complex frequencies λ only: in each freedom `κ = K (1 + iη)(1 + cλ) + dλ`.
///
/// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `-1/κ_y` at (Y, Q) and `1/κ_θ` at (Θ, M). A plane goes on times both κ, so that a
/// κ of zero lets go.
///
/// # Source
/// Eq. (32) of the paper with complex stiffnesses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedHinge<T> {
    /// Translational stiffness K_y [N/m], zero or positive; infinite is rigid.
    pub stiffness_y: T,
    /// Torsional stiffness K_θ [N m/rad], zero or positive; infinite is rigid.
    pub stiffness_theta: T,
    /// Damping d_y of a dashpot beside the one [N s/m], zero or positive.
    pub damping_y: T,
    /// Damping d_θ of a dashpot beside the other [N m s/rad], zero or positive.
    pub damping_theta: T,
    /// Loss factor η, zero or positive.
    pub loss_factor: T,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    pub kelvin_voigt_time: T,
}

impl<T: Parameter> Element for DampedHinge<T> {
    type State = Bending;
    type Built = DampedTies<T>;
    const IS_STRAIGHT: bool = false;

    fn build(self) -> Result<DampedTies<T>, InvalidParameter> {
        let DampedHinge { stiffness_y, stiffness_theta, damping_y, damping_theta, loss_factor, kelvin_voigt_time } =
            self;
        let along_x = [T::from_f64(f64::INFINITY), T::zero()];
        DampedTies::or_rigid(
            [along_x, [stiffness_y, damping_y], [stiffness_theta, damping_theta]],
            [loss_factor, kelvin_voigt_time],
        )
    }

    fn estimate(built: &DampedTies<T>, estimates: &mut FrequencyEstimates) {
        built.estimate(estimates);
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for DampedHinge<T> {
    fn transfer_matrix(built: &DampedTies<T>, x: S) -> Matrix4<S> {
        let [_, y, rotation] = built.compliances(x);
        let mut u = Matrix4::identity();
        (u[(0, 3)], u[(1, 2)]) = (-y, rotation);
        u
    }

    fn denominator(built: &DampedTies<T>, x: S) -> Option<S> {
        Some(built.denominator(x))
    }
}

/// Of both freedoms κ, or 1 where it is rigid, and 1, or 0 there: the compliance is the second over the first.
#[derive(Clone, Copy, Debug)]
pub struct DampedHingeCoefficients<S> {
    stiffness: [S; 2],
    gives_way: [S; 2],
}

impl<S: Scalar> DampedHingeCoefficients<S> {
    /// Takes a plane through the hinge, times both stiffnesses.
    fn through(&self, p: &Plane<S>) -> Plane<S> {
        let ([y, rotation], [of_y, of_rotation]) = (self.stiffness, self.gives_way);
        let product = y * rotation;
        let (mixed_y, mixed_rotation) = (y * of_rotation, rotation * of_y);
        let minors = [
            p.y_theta * product + p.y_m * mixed_y + p.theta_q * mixed_rotation + p.m_q * of_y * of_rotation,
            p.y_m * product + p.m_q * mixed_rotation,
            p.w * product,
            p.theta_q * product + p.m_q * mixed_y,
            p.m_q * product,
        ];
        Plane::new(minors, p.exponent)
    }
}

impl<T: Parameter, S: ComplexFrequency<T>> PlaneStep<S> for DampedHinge<T> {
    type Coefficients = DampedHingeCoefficients<S>;

    fn coefficients(built: &DampedTies<T>, at: &FrequencyPowers<S>) -> DampedHingeCoefficients<S> {
        let [_, y, rotation] = built.ties;
        let both = [y, rotation].map(|tie| tie.map_or([S::one(), S::zero()], |tie| [tie.at(at.x), S::one()]));
        DampedHingeCoefficients { stiffness: both.map(|part| part[0]), gives_way: both.map(|part| part[1]) }
    }

    fn step<C: RootCounter<S>>(
        coefficients: &DampedHingeCoefficients<S>,
        input: Subspace<S>,
        counter: &mut C,
    ) -> Subspace<S> {
        let before = input.plane();
        let after = coefficients.through(&before);
        let stiffness = [coefficients.stiffness[0], S::one()];
        let held = Held { below: S::Size::of(0.0), is_negative: S::Truth::of(false), stiffness, units: None };
        counter.plane(&before, &after, held);
        Subspace::Plane(after)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> BackTransfer<S> for DampedHinge<T> {
    type BackCoefficients = DampedHingeCoefficients<S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &DampedTies<T>) -> DampedTies<T> {
        *built
    }

    fn back_coefficients(built: &DampedTies<T>, at: &FrequencyPowers<S>) -> DampedHingeCoefficients<S> {
        Self::coefficients(built, at)
    }

    /// `κ_y κ_θ Uᵀ η`, since the step multiplies by the stiffnesses.
    fn back_transfer(
        coefficients: &DampedHingeCoefficients<S>,
        _input: &Subspace<S>,
        covector: Covector<S>,
    ) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        let ([of_y, of_theta], [gives_y, gives_theta]) = (coefficients.stiffness, coefficients.gives_way);
        let product = of_y * of_theta;
        let entries = [
            y * product,
            theta * product,
            m * product + theta * of_y * gives_theta,
            q * product - y * of_theta * gives_y,
        ];
        Covector::Plane(entries, exponent)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> Energies<S> for DampedHinge<T> {
    type Gradient = DampedHinge<S>;

    fn units(built: &DampedTies<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
        let [_, y, rotation] = built.ties;
        [y, rotation].map(|tie| tie.map_or(0.0, |tie| tie.size(S::size(at.x))))
    }

    fn mass_form(_built: &DampedTies<T>, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn stiffness_form(built: &DampedTies<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first.x, of_path(first, second)).stiffness
    }

    fn damping_form(built: &DampedTies<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first.x, of_path(first, second)).damping
    }

    fn gradient(built: &DampedTies<T>, ends: &Ends<S>) -> DampedHinge<S> {
        let ([_, [stiffness_y, damping_y], [stiffness_theta, damping_theta]], [loss_factor, kelvin_voigt_time]) =
            built.gradient(ends.x, of_path(ends, ends));
        DampedHinge { stiffness_y, stiffness_theta, damping_y, damping_theta, loss_factor, kelvin_voigt_time }
    }
}

/// The products of the elongations of two motions of a bending path.
fn of_path<S: Scalar>(first: &Ends<S>, second: &Ends<S>) -> [S; 3] {
    let [y, rotation] = [Coordinate::Y, Coordinate::Theta].map(|coordinate| elongations(coordinate, first, second));
    [S::zero(), y, rotation]
}

#[cfg(test)]
impl super::laws::Sample for DampedHinge<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        DampedHinge {
            stiffness_y: by_compliance(next()),
            stiffness_theta: by_compliance(next()),
            damping_y: 0.5 * next(),
            damping_theta: 0.5 * next(),
            loss_factor: 0.2 * next(),
            kelvin_voigt_time: next(),
        }
    }

    fn lossless(self) -> Self {
        DampedHinge { loss_factor: 0.0, ..self }
    }
}
