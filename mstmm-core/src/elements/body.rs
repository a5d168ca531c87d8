//! Rigid body in a bending path.

use crate::at::At;
use crate::bounds::FrequencyBounds;
use crate::count::Tally;
use crate::element::{Element, PlaneStep, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::motion::line_motions::half;
use crate::motion::{Covector, Ends, Motion};
use crate::scalar::{Frequency, Oscillation, Real};
use crate::scaled::Scaled;
use crate::state::{Bending, Support};
use crate::subspace::{Plane, Subspace};
use nalgebra::Matrix4;

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

impl<T: Real> Element for Body<T> {
    type State = Bending;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::NonNegative.check("mass", self.mass)?;
        Requirement::Finite.check("output_x", self.output_x)?;
        Requirement::Finite.check("centre_x", self.centre_x)?;
        let about_centre = self.mass * self.centre_x * self.centre_x;
        Requirement::at_least(about_centre, "mass * centre_x²").check("inertia", self.inertia)?;
        Ok(self)
    }

    fn bound(built: &Self, bounds: &mut FrequencyBounds) {
        bounds.mass(built.mass.to_f64());
        bounds.length(built.output_x.to_f64());
        bounds.length(built.centre_x.to_f64());
        bounds.moment_of_inertia(built.inertia.to_f64());
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Body<T> {
    #[rustfmt::skip]
    fn transfer_matrix(built: &Self, x: S) -> Matrix4<S> {
        let (zero, one) = (S::zero(), S::one());
        let b1 = S::from_parameter(built.output_x);
        let lambda_squared = x.lambda_squared();
        let a = lambda_squared * built.mass;
        let b = lambda_squared * (built.mass * built.centre_x);
        let j = lambda_squared * built.inertia;
        Matrix4::new(
            one,          b1,         zero, zero,
            zero,         one,        zero, zero,
            b - a * b1,   j - b * b1, one,  b1,
            -a,           -b,         zero, one,
        )
    }
}

/// `a = mλ²`, `b = m c1 λ²`, `j = J_I λ²` and the shift b1 to the output end.
#[derive(Clone, Copy, Debug)]
pub struct BodyCoefficients<T, S> {
    a: S,
    b: S,
    j: S,
    shift: T,
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for Body<T> {
    const STRAIGHT: bool = true;
    type Coefficients = BodyCoefficients<T, S>;

    #[inline(always)]
    fn coefficients(built: &Self, at: &At<S>) -> BodyCoefficients<T, S> {
        let a = at.lambda_squared * built.mass;
        BodyCoefficients { a, b: a * built.centre_x, j: at.lambda_squared * built.inertia, shift: built.output_x }
    }

    #[inline(always)]
    fn step<C: Tally<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, _tally: &mut C) -> Subspace<S> {
        let (p, shift) = (coefficients.at_input(input), coefficients.shift);
        let moved = p.theta_q * shift;
        let y_m = p.y_m + (p.w + p.w + moved) * shift;
        Subspace::Plane(Plane::new([p.y_theta, y_m, p.w + moved, p.theta_q, p.m_q], p.exponent))
    }

    #[inline(always)]
    fn root<C: Tally<S>>(
        coefficients: &Self::Coefficients,
        input: Subspace<S>,
        support: Support,
        tally: &mut C,
    ) -> Scaled<S> {
        if C::COUNTS || support != Support::Free {
            return Self::step(coefficients, input, tally).at_root(support, tally);
        }
        // the shift to the output end does not change p_MQ
        let p = input.plane();
        Scaled::new(coefficients.m_q(&p), i64::from(p.exponent))
    }
}

impl<T: Real, S: Frequency<T>> BodyCoefficients<T, S> {
    /// The plane behind the body's inertia, still at the input end.
    #[inline(always)]
    fn at_input(&self, input: Subspace<S>) -> Plane<S> {
        let BodyCoefficients { a, b, j, .. } = *self;
        if let Subspace::Tip(Support::Free, _) = input {
            return Plane::unscaled([S::one(), j, -b, a, j * a - b * b], 0);
        }
        let p = input.plane();
        let minors = [p.y_theta, p.y_m + j * p.y_theta, p.w - b * p.y_theta, p.theta_q + a * p.y_theta, self.m_q(&p)];
        Plane::unscaled(minors, p.exponent)
    }

    /// `p_MQ` behind the body.
    #[inline(always)]
    fn m_q(&self, p: &Plane<S>) -> S {
        let BodyCoefficients { a, b, j, .. } = *self;
        let bw = b * p.w;
        p.m_q + a * p.y_m + j * p.theta_q + (bw + bw) + (j * a - b * b) * p.y_theta
    }
}

impl<T: Real, S: Oscillation<T>> Motion<S> for Body<T> {
    type Links = BodyCoefficients<T, S>;
    type Gradient = Body<S>;
    const SYMMETRIC: bool = false;

    /// The same body about its output end: `J_I + m b1 (b1 - 2 c1)` and `b1 - c1`.
    fn reversed(built: &Self) -> Self {
        let Body { mass, inertia, output_x, centre_x } = *built;
        let to_centre = output_x - centre_x;
        let inertia = inertia + mass * output_x * (to_centre - centre_x);
        Body { mass, inertia, output_x, centre_x: to_centre }
    }

    fn links(built: &Self, at: &At<S>) -> BodyCoefficients<T, S> {
        Self::coefficients(built, at)
    }

    fn pull_back(links: &BodyCoefficients<T, S>, _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        let BodyCoefficients { a, b, j, shift } = *links;
        let q_in = q + m * shift;
        let entries = [y + b * m - a * q_in, theta + y * shift + j * m - b * q_in, m, q_in];
        Covector::Plane(entries, exponent)
    }

    fn units(built: &Self, at: &At<S>) -> [f64; 2] {
        let BodyCoefficients { a, j, .. } = Self::coefficients(built, at);
        [S::size(a), S::size(j)]
    }

    /// `m (Y₁ Y₂ + c1 (Y₁ Θ₂ + Θ₁ Y₂)) + J_I Θ₁ Θ₂`
    fn mass_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
        let (first, second) = (first.input, second.input);
        let lever = (first.y * second.theta + first.theta * second.y) * built.centre_x;
        (first.y * second.y + lever) * built.mass + first.theta * second.theta * built.inertia
    }

    fn stiffness_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    /// The shift of the output end moves what is downstream by Θ: its derivative is the work `Q_O Θ`.
    fn gradient(built: &Self, ends: &Ends<S>) -> Body<S> {
        let (lambda_squared, input) = (ends.x.lambda_squared(), ends.input);
        let lever = input.y * input.theta;
        Body {
            mass: lambda_squared * (half(input.y * input.y) + lever * built.centre_x),
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
