//! Rigid body in a bending path.

use crate::element::{BackTransfer, BodyNumbers, Element, Energies, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::shared::arm::Arm;
use crate::elements::shared::line_forms::half;
use crate::model::{Bending, Ends, Extent, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scaled, Single};
use crate::subspace::{Connecting, Covector, Plane, RootCounter, Subspace};
use levers::{Beside, Levers};
use mstmm_plan::Support;
use nalgebra::Matrix4;

mod central;
mod column;
mod levers;

pub use central::{CentralBody, CentralBodyColumn};
pub use column::BodyColumn;

/// Rigid body with one input and one output end in a bending path; small motions, no longitudinal displacement.
///
/// Transfer matrix on `[Y, Θ, M, Q]`, with the output end at b1 and the mass centre at c1 along the path:
///
/// ```text
/// 1              b1                  0   0
/// 0              1                   0   0
/// -mλ²(b1-c1)    λ²(J_I - m b1 c1)   1   b1
/// -mλ²           -mλ²c1              0   1
/// ```
///
/// A mass centre beside the path (`m b2 c2` in the paper) enters as `inertia := J_I - m b2 c2`.
///
/// # Source
/// Eq. (16) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia J_I about the input end [kg m²], at least `mass * centre_x²`.
    pub inertia: T,
    /// Position b1 of the output end from the input end \[m\].
    pub output_x: T,
    /// Position c1 of the mass centre from the input end \[m\].
    pub centre_x: T,
}

/// A body with its quantities that do not depend on the frequency: its inertia about the mass centre is subtracted once.
#[derive(Clone, Copy, Debug)]
pub struct BuiltBody<T> {
    mass: T,
    /// `J_C = J_I - m c1²`; below zero where the rounding of J_I has put it there.
    central_inertia: T,
    /// What rounding took from it.
    rest_of_inertia: T,
    /// What was given of it.
    inertia: Inertia<T>,
    /// b1 and c1.
    levers: Levers<T>,
    /// `b1 - c1`.
    centre_to_output: Arm<T>,
}

/// A moment of inertia as it was given.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Inertia<T> {
    /// J_I, about the input end.
    AboutInput(T),
    /// J_C, about the mass centre.
    AboutCentre(T),
}

impl<T: Parameter> BuiltBody<T> {
    fn new(mass: T, inertia: Inertia<T>, [output_x, centre_x]: [T; 2]) -> Self {
        let [central_inertia, rest_of_inertia] = match inertia {
            // the product must be exact, since for a mass on a long arm the difference may be rounding alone
            Inertia::AboutInput(inertia) => inertia.minus_product([mass, centre_x, centre_x]),
            Inertia::AboutCentre(inertia) => [inertia, T::zero()],
        };
        BuiltBody {
            mass,
            central_inertia,
            rest_of_inertia,
            inertia,
            levers: Levers::new(Arm::new(output_x), Arm::new(centre_x)),
            centre_to_output: Arm::between(centre_x, output_x),
        }
    }
}

impl<T: Parameter> Element for Body<T> {
    type State = Bending;
    type Built = BuiltBody<T>;

    fn build(self) -> Result<BuiltBody<T>, InvalidParameter> {
        Requirement::NonNegative.check("mass", self.mass)?;
        Requirement::Finite.check("output_x", self.output_x)?;
        Requirement::Finite.check("centre_x", self.centre_x)?;
        let about_centre = self.mass * self.centre_x * self.centre_x;
        Requirement::at_least(about_centre, "mass * centre_x²").check("inertia", self.inertia)?;
        Ok(BuiltBody::new(self.mass, Inertia::AboutInput(self.inertia), [self.output_x, self.centre_x]))
    }

    fn estimate(built: &BuiltBody<T>, estimates: &mut FrequencyEstimates) {
        estimates.mass(built.mass.to_f64());
        let Levers { output, centre, .. } = built.levers;
        // an inertia about the mass centre that is rounding alone gives high frequencies
        estimates.moment_of_inertia(built.central_inertia.abs().to_f64());
        estimates.lever(output.length.to_f64());
        estimates.lever(centre.length.to_f64());
        estimates.moment_of_inertia((built.central_inertia + built.mass * centre.length * centre.length).to_f64());
    }

    fn extent(built: &BuiltBody<T>) -> Extent {
        let [output, centre] = [built.levers.output, built.levers.centre].map(|arm| [arm.length.to_f64(), 0.0]);
        Extent { output, centre: Some(centre), ..Extent::default() }
    }

    fn member_numbers(built: &BuiltBody<T>) -> MemberNumbers {
        let (inertia, is_central) = match built.inertia {
            Inertia::AboutInput(inertia) => (inertia, false),
            Inertia::AboutCentre(inertia) => (inertia, true),
        };
        MemberNumbers::Body(BodyNumbers {
            mass: built.mass.words(),
            inertia: inertia.words(),
            is_central,
            centre_x: built.levers.centre.length.words(),
            output_x: built.levers.output.length.words(),
            axial_force: [0.0; 2],
        })
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for Body<T> {
    #[rustfmt::skip]
    fn transfer_matrix(built: &BuiltBody<T>, x: S) -> Matrix4<S> {
        let (zero, one) = (S::zero(), S::one());
        let BodyCoefficients { a, j, to_output, levers, .. } = BodyCoefficients::new(built, x.lambda_squared());
        let Levers { output, centre, .. } = levers;
        let b1 = output.times(one);
        Matrix4::new(
            one,        b1,                          zero, zero,
            zero,       one,                         zero, zero,
            -to_output, j - centre.times(to_output), one,  b1,
            -a,         -centre.times(a),            zero, one,
        )
    }
}

/// `a = mλ²` and `j = J_C λ²`, `a (b1 - c1)` and `j + a (b1 - c1)²`, and the levers from the input end.
#[derive(Clone, Copy, Debug)]
pub struct BodyCoefficients<T, S> {
    a: S,
    j: S,
    to_output: S,
    about_output: S,
    levers: Levers<T>,
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for Body<T> {
    type Coefficients = BodyCoefficients<T, S>;

    #[inline(always)]
    fn coefficients(built: &BuiltBody<T>, at: &FrequencyPowers<S>) -> BodyCoefficients<T, S> {
        BodyCoefficients::new(built, at.lambda_squared)
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        let BodyCoefficients { a, j, to_output, about_output, .. } = *coefficients;
        if let Subspace::Tip(Support::Free, _) = input {
            return Subspace::Plane(Plane::new([S::one(), about_output, to_output, a, a * j], 0));
        }
        let p = input.plane();
        let inertia = about_output * p.y_theta;
        let Behind { y_m, w, theta_q, m_q } = coefficients.behind(&p, inertia, counter);
        Subspace::Plane(Plane::new([p.y_theta, y_m + inertia, w + to_output * p.y_theta, theta_q, m_q], p.exponent))
    }

    #[inline(always)]
    fn root<C: RootCounter<S>>(
        coefficients: &Self::Coefficients,
        input: Subspace<S>,
        support: Support,
        counter: &mut C,
    ) -> Scaled<S> {
        if C::COUNTS || support != Support::Free {
            return Self::step(coefficients, input, counter).at_root(support, counter);
        }
        // the shift to the output end does not change p_MQ
        let p = input.plane();
        let Behind { m_q, .. } = coefficients.behind(&p, S::zero(), counter);
        Scaled::new(m_q, i64::from(p.exponent))
    }
}

/// Minors behind a body: p_YM and w as if it were massless, p_ΘQ and p_MQ with its inertia.
struct Behind<S> {
    y_m: S,
    w: S,
    theta_q: S,
    m_q: S,
}

impl<T: Parameter, S: Frequency<T>> BodyCoefficients<T, S> {
    #[inline(always)]
    fn new(built: &BuiltBody<T>, lambda_squared: S) -> Self {
        let BuiltBody { mass, central_inertia, rest_of_inertia, levers, centre_to_output, .. } = *built;
        let (a, mut j) = (lambda_squared * mass, lambda_squared * central_inertia);
        if S::IS_EXTENDED {
            j += lambda_squared * rest_of_inertia;
        }
        let to_output = centre_to_output.times(a);
        BodyCoefficients { a, j, to_output, about_output: j + centre_to_output.times(to_output), levers }
    }

    /// `p_ΘQ + a p_YΘ`, with it `p_MQ + a p_YM + j p_ΘQ` with p_YM of the mass centre, and p_YM and w at the output end. The shift is
    /// a single one, since one by way of the mass centre would leave rounding where it leads there and back.
    #[inline(always)]
    fn behind<C: RootCounter<S>>(&self, p: &Plane<S>, inertia: S, counter: &mut C) -> Behind<S> {
        let theta_q = p.theta_q + self.a * p.y_theta;
        let turning = self.j * theta_q;
        let beside = Beside { inertia, turning, a: self.a };
        let [[y_m, w], [at_centre, _]] = self.levers.far_ends(p, &beside, counter);
        Behind { y_m, w, theta_q, m_q: p.m_q + self.a * at_centre + turning }
    }
}

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for Body<T> {
    type BackCoefficients = BodyCoefficients<T, S>;
    const SYMMETRIC: bool = false;

    /// The body about its output end: the levers from its mass centre change places.
    fn reversed(built: &BuiltBody<T>) -> BuiltBody<T> {
        let Levers { output, centre, .. } = built.levers;
        BuiltBody { levers: Levers::new(output, built.centre_to_output), centre_to_output: centre, ..*built }
    }

    fn back_coefficients(built: &BuiltBody<T>, at: &FrequencyPowers<S>) -> BodyCoefficients<T, S> {
        Self::coefficients(built, at)
    }

    fn back_transfer(
        coefficients: &BodyCoefficients<T, S>,
        _input: &Subspace<S>,
        covector: Covector<S>,
    ) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        let BodyCoefficients { a, j, to_output, levers: Levers { output, centre, .. }, .. } = *coefficients;
        let force = a * q + to_output * m;
        let entries = [y - force, theta + output.times(y) + j * m - centre.times(force), m, q + output.times(m)];
        Covector::Plane(entries, exponent)
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for Body<T> {
    type Gradient = Body<S>;

    fn units(built: &BuiltBody<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
        let BodyCoefficients { a, j, levers: Levers { centre, .. }, .. } = Self::coefficients(built, at);
        [S::size(a), S::size(j + centre.times(centre.times(a)))]
    }

    /// `m Y₁ Y₂ + J_C Θ₁ Θ₂` with the deflections of the mass centre.
    fn mass_form(built: &BuiltBody<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        let (first, second) = (first.input, second.input);
        let [one, other] = [first, second].map(|end| end.y + built.levers.centre.times(end.theta));
        one * other * built.mass + first.theta * second.theta * built.central_inertia
    }

    fn stiffness_form(_built: &BuiltBody<T>, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    /// The shift of the output end moves what is downstream by Θ: its derivative is the work `Q_O Θ`.
    fn gradient(built: &BuiltBody<T>, ends: &Ends<S>) -> Body<S> {
        let (lambda_squared, input) = (ends.x.lambda_squared(), ends.input);
        let lever = input.y * input.theta;
        Body {
            mass: lambda_squared * (half(input.y * input.y) + built.levers.centre.times(lever)),
            inertia: lambda_squared * half(input.theta * input.theta),
            output_x: ends.output.q * input.theta,
            centre_x: lambda_squared * lever * built.mass,
        }
    }
}

#[cfg(test)]
impl super::laws::Sample for Body<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let (mass, centre_x) = (next(), next() - 1.0);
        Body { mass, inertia: mass * centre_x * centre_x + next(), output_x: next() - 1.0, centre_x }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_of_point_masses_on_its_centre_is_valid_whatever_the_rounding() {
        for k in 1..1000 {
            let (mass, centre_x) = (0.1 * f64::from(k), 1.0 / f64::from(k + 2));
            for inertia in [mass * (centre_x * centre_x), mass * centre_x * centre_x] {
                assert!(Body { mass, inertia, output_x: 1.0, centre_x }.build().is_ok());
            }
        }
    }

    #[test]
    fn an_inertia_below_that_of_the_mass_centre_is_refused_with_its_bound() {
        let error = Body { mass: 2.0, inertia: 0.4, output_x: 1.0, centre_x: 0.5 }.build().unwrap_err();
        assert_eq!((error.parameter, error.value), ("inertia", 0.4));
        assert_eq!(error.requirement, Requirement::AtLeast { bound: 0.5, formula: "mass * centre_x²" });
    }
}
