//! Rigid body in a bending path.

use crate::at::At;
use crate::bounds::FrequencyBounds;
use crate::count::Tally;
use crate::element::{Element, PlaneStep, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real};
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

/// A body with what does not depend on the frequency.
#[derive(Clone, Copy, Debug)]
pub struct BuiltBody<T> {
    parameters: Body<T>,
    /// Moment of inertia about the mass centre, `J_I - m c1²`.
    about_centre: T,
    /// Way from the mass centre to the output end, `b1 - c1`.
    from_centre: T,
}

impl<T: Real> Element for Body<T> {
    type State = Bending;
    type Built = BuiltBody<T>;

    fn build(self) -> Result<BuiltBody<T>, InvalidParameter> {
        Requirement::NonNegative.check("mass", self.mass)?;
        Requirement::Finite.check("output_x", self.output_x)?;
        Requirement::Finite.check("centre_x", self.centre_x)?;
        let of_centre = self.mass * self.centre_x * self.centre_x;
        Requirement::at_least(of_centre, "mass * centre_x²").check("inertia", self.inertia)?;
        let about_centre = self.inertia - of_centre;
        Ok(BuiltBody {
            parameters: self,
            // the requirement leaves room for rounding
            about_centre: if about_centre < T::zero() { T::zero() } else { about_centre },
            from_centre: self.output_x - self.centre_x,
        })
    }

    fn bound(built: &BuiltBody<T>, bounds: &mut FrequencyBounds) {
        let Body { mass, inertia, output_x, centre_x } = built.parameters;
        bounds.mass(mass.to_f64());
        bounds.length(output_x.to_f64());
        bounds.length(centre_x.to_f64());
        bounds.moment_of_inertia(inertia.to_f64());
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Body<T> {
    #[rustfmt::skip]
    fn transfer_matrix(built: &BuiltBody<T>, x: S) -> Matrix4<S> {
        let Body { mass, inertia, output_x, centre_x } = built.parameters;
        let (zero, one) = (S::zero(), S::one());
        let b1 = S::from_parameter(output_x);
        let lambda_squared = x.lambda_squared();
        let a = lambda_squared * mass;
        let b = lambda_squared * (mass * centre_x);
        let j = lambda_squared * inertia;
        Matrix4::new(
            one,          b1,         zero, zero,
            zero,         one,        zero, zero,
            b - a * b1,   j - b * b1, one,  b1,
            -a,           -b,         zero, one,
        )
    }
}

/// `a = mλ²`, `j = J_c λ²` about the mass centre, and the ways to it and from it.
///
/// About the mass centre nothing cancels: about the input end the determinant of the inertias, `J_I m - (m c1)²`, loses all
/// digits of a small `J_c`, and with them the frequency of a body pinned at its centre.
#[derive(Clone, Copy, Debug)]
pub struct BodyCoefficients<T, S> {
    a: S,
    j: S,
    to_centre: T,
    from_centre: T,
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for Body<T> {
    type Coefficients = BodyCoefficients<T, S>;

    #[inline(always)]
    fn coefficients(built: &BuiltBody<T>, at: &At<S>) -> BodyCoefficients<T, S> {
        BodyCoefficients {
            a: at.lambda_squared * built.parameters.mass,
            j: at.lambda_squared * built.about_centre,
            to_centre: built.parameters.centre_x,
            from_centre: built.from_centre,
        }
    }

    #[inline(always)]
    fn step<C: Tally<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, _tally: &mut C) -> Subspace<S> {
        let plane = coefficients.at_centre(input);
        Subspace::Plane(shifted(plane, coefficients.from_centre).in_range())
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
        let p = coefficients.at_centre(input);
        Scaled::new(p.m_q, i64::from(p.exponent))
    }
}

impl<T: Real, S: Frequency<T>> BodyCoefficients<T, S> {
    /// The plane behind the body's inertia, at the mass centre.
    #[inline(always)]
    fn at_centre(&self, input: Subspace<S>) -> Plane<S> {
        let BodyCoefficients { a, j, .. } = *self;
        if let Subspace::Tip(Support::Free, _) = input {
            return Plane::unscaled([S::one(), j, S::zero(), a, j * a], 0);
        }
        let p = shifted(input.plane(), self.to_centre);
        let theta_q = p.theta_q + a * p.y_theta;
        let minors = [p.y_theta, p.y_m + j * p.y_theta, p.w, theta_q, p.m_q + a * p.y_m + j * theta_q];
        Plane::unscaled(minors, p.exponent)
    }
}

/// The plane at another point of a rigid body: Y and M follow from Θ and Q.
#[inline(always)]
fn shifted<T: Real, S: Frequency<T>>(p: Plane<S>, shift: T) -> Plane<S> {
    let moved = p.theta_q * shift;
    let y_m = p.y_m + (p.w + p.w + moved) * shift;
    Plane::unscaled([p.y_theta, y_m, p.w + moved, p.theta_q, p.m_q], p.exponent)
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
