//! Hinges of one freedom in a bending path: a spring in the rotation or in the deflection, all else rigid.
//!
//! They differ in the freedom that gives way.

use crate::element::{BackTransfer, Element, Energies, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::shared::line_forms::{elongations, half, unit_of};
use crate::model::{Bending, Ends, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Single, Size, Truth};
use crate::subspace::{Covector, Held, Plane, RootCounter, Subspace};
use mstmm_plan::{Coordinate, Freedoms};
use nalgebra::Matrix4;

/// Declares hinges by the freedom that gives way and the estimate that their stiffness enters.
macro_rules! hinges {
    ($(
        $(#[$doc:meta])*
        $element:ident in $coordinate:ident, $estimate:ident {
            $(#[$field_doc:meta])*
            stiffness
        }
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $element<T> {
            $(#[$field_doc])*
            pub stiffness: T,
        }

        impl<T: Parameter> Element for $element<T> {
            type State = Bending;
            type Built = Self;

            fn build(self) -> Result<Self, InvalidParameter> {
                Requirement::NonNegative.check("stiffness", self.stiffness)?;
                Ok(self)
            }

            fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
                estimates.$estimate(built.stiffness.to_f64());
            }

            fn member_numbers(built: &Self) -> MemberNumbers {
                let (zero, stiffness) = ([0.0; 2], built.stiffness.words());
                match Coordinate::$coordinate {
                    Coordinate::Theta => MemberNumbers::Joint(Freedoms::Y, [zero, zero, stiffness]),
                    _ => MemberNumbers::Joint(Freedoms::RZ, [zero, stiffness, zero]),
                }
            }
        }

        impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for $element<T> {
            #[inline(always)]
            fn transfer_matrix(built: &Self, _x: S) -> Matrix4<S> {
                transfer_matrix(Coordinate::$coordinate, S::from_parameter(T::one() / built.stiffness))
            }
        }

        impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for $element<T> {
            type Coefficients = S;

            #[inline(always)]
            fn coefficients(built: &Self, _at: &FrequencyPowers<S>) -> S {
                S::from_parameter(built.stiffness)
            }

            #[inline(always)]
            fn step<C: RootCounter<S>>(stiffness: &S, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
                let before = input.plane();
                let after = through(Coordinate::$coordinate, *stiffness, &before);
                counter.plane(&before, &after, held());
                Subspace::Plane(after)
            }
        }

        impl<T: Real, S: Oscillation<T>> BackTransfer<S> for $element<T> {
            type BackCoefficients = S;
            const SYMMETRIC: bool = true;

            fn reversed(built: &Self) -> Self {
                *built
            }

            fn back_coefficients(built: &Self, at: &FrequencyPowers<S>) -> S {
                Self::coefficients(built, at)
            }

            fn back_transfer(stiffness: &S, _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                back_through(Coordinate::$coordinate, *stiffness, covector)
            }
        }

        impl<T: Real, S: Oscillation<T>> Energies<S> for $element<T> {
            type Gradient = $element<S>;

            fn units(built: &Self, _at: &FrequencyPowers<S>) -> [f64; 2] {
                unit_of(Coordinate::$coordinate, built.stiffness.to_f64())
            }

            fn mass_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
                S::zero()
            }

            fn stiffness_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
                elongations(Coordinate::$coordinate, first, second) * built.stiffness
            }

            /// Half of the square of the jump, which a hinge without stiffness has, too.
            fn gradient(_built: &Self, ends: &Ends<S>) -> $element<S> {
                $element { stiffness: half(elongations(Coordinate::$coordinate, ends, ends)) }
            }
        }

        #[cfg(test)]
        impl super::laws::Sample for $element<f64> {
            fn sample(mut next: impl FnMut() -> f64) -> Self {
                $element { stiffness: next() }
            }
        }
    )*};
}

hinges! {
    /// Massless rotational hinge, `M = K (Θ_O - Θ_I)`: a crack, a semi-rigid joint or, without stiffness, a perfect hinge.
    ///
    /// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `1/K` at (Θ, M). A plane with minors p goes on as
    /// `(K p_YΘ + p_YM, K p_YM, K w, K p_ΘQ + p_MQ, K p_MQ)`, which K = 0 leaves finite, as it does shapes, responses and
    /// derivatives with respect to K. Only the matrix has no entry for it: with K = 0, or one without a finite reciprocal, the
    /// overall matrix and its determinant are not numbers.
    ///
    /// # Source
    /// Eq. (32) of the paper with a rigid translation.
    RotationalHinge in Theta, torsional_stiffness {
        /// Torsional stiffness K [N m/rad], zero or positive.
        stiffness
    }

    /// Massless shear hinge, `Q = K (Y_I - Y_O)`: both sides slide along each other and turn as one.
    ///
    /// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `-1/K` at (Y, Q). A plane with minors p goes on as
    /// `(K p_YΘ + p_ΘQ, K p_YM + p_MQ, K w, K p_ΘQ, K p_MQ)`. For K = 0 all is as for a [`RotationalHinge`].
    ///
    /// # Source
    /// Eq. (32) of the paper with a rigid rotation.
    ShearHinge in Y, translational_stiffness {
        /// Translational stiffness K [N/m], zero or positive.
        stiffness
    }
}

/// The transfer matrix of a hinge of a compliance in one freedom.
#[inline(always)]
fn transfer_matrix<S: Single>(freedom: Coordinate, compliance: S) -> Matrix4<S> {
    let mut u = Matrix4::identity();
    match freedom {
        Coordinate::Theta => u[(1, 2)] = compliance,
        _ => u[(0, 3)] = -compliance,
    }
    u
}

/// Takes a plane through a hinge.
#[inline(always)]
fn through<S: Scalar>(freedom: Coordinate, k: S, p: &Plane<S>) -> Plane<S> {
    let (y_theta, y_m, w, theta_q, m_q) = (k * p.y_theta, k * p.y_m, k * p.w, k * p.theta_q, k * p.m_q);
    let minors = match freedom {
        Coordinate::Theta => [y_theta + p.y_m, y_m, w, theta_q + p.m_q, m_q],
        _ => [y_theta + p.theta_q, y_m + p.m_q, w, theta_q, m_q],
    };
    Plane::new(minors, p.exponent)
}

/// One freedom of the input end is eliminated. Against the other the hinge is rigid, so that one eigenvalue at most is negative: where
/// p_YΘ changes its sign, as it would behind a stiffness of zero by what is left of it.
#[inline(always)]
fn held<S: Scalar>() -> Held<S> {
    let rigid = [S::one(), S::zero()];
    Held { below: S::Size::of(0.0), is_negative: S::Truth::of(false), stiffness: rigid, units: None }
}

/// `K Uᵀ η`, since the step multiplies by K.
#[inline]
fn back_through<S: Scalar>(freedom: Coordinate, k: S, covector: Covector<S>) -> Covector<S> {
    let ([y, theta, m, q], exponent) = covector.entries();
    let entries = match freedom {
        Coordinate::Theta => [y * k, theta * k, m * k + theta, q * k],
        _ => [y * k, theta * k, m * k, q * k - y],
    };
    Covector::Plane(entries, exponent)
}
