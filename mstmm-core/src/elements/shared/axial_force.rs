//! Rigid elements under an axial force: their geometric stiffness.

use crate::elements::shared::line_forms::half;
use crate::model::Ends;
use crate::number::{Frequency, Parameter, Scalar};
use crate::subspace::{Covector, Plane, Subspace};

/// An axial force N between the ends of a rigid element, tension positive, and the position b of the output end.
///
/// Where the element turns by Θ its ends come closer by `|b| Θ²/2` against N, which is a stiffness `N |b|` against Θ.
#[derive(Clone, Copy, Debug)]
pub struct AxialForce<T> {
    pub(crate) force: T,
    pub(crate) output_x: T,
}

impl<T: Parameter> AxialForce<T> {
    /// The geometric stiffness `N |b|`.
    #[inline(always)]
    pub(crate) fn stiffness<S: Frequency<T>>(&self) -> S {
        S::from_parameter(self.force) * self.output_x.abs()
    }

    /// `∂L/∂N` and `∂L/∂b` of the dynamic work `N |b| Θ²/2`.
    pub(crate) fn gradient<S: Frequency<T>>(&self, ends: &Ends<S>) -> [S; 2] {
        let square = half(ends.input.theta * ends.input.theta);
        let by_lever = square * self.force;
        [square * self.output_x.abs(), S::select(S::from_parameter(self.output_x).is_negative(), -by_lever, by_lever)]
    }
}

/// A subspace behind a stiffness k against Θ: `p_YM + k p_YΘ` and `p_MQ + k p_ΘQ`.
#[inline(always)]
pub(crate) fn stiffened<S: Scalar>(k: S, input: &Subspace<S>) -> Subspace<S> {
    let p = input.plane();
    let minors = [p.y_theta, p.y_m + k * p.y_theta, p.w, p.theta_q, p.m_q + k * p.theta_q];
    Subspace::Plane(Plane::new(minors, p.exponent))
}

/// A covector in front of a stiffness k against Θ.
pub(crate) fn before_stiffness<S: Scalar>(k: S, covector: Covector<S>) -> Covector<S> {
    let ([y, theta, m, q], exponent) = covector.entries();
    Covector::Plane([y, theta + k * m, m, q], exponent)
}

/// Declares an element as a rigid one under an axial force.
macro_rules! under_axial_force {
    (
        $(#[$doc:meta])*
        $column:ident of $rigid:ident { $($(#[$field_doc:meta])* $field:ident,)* }
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $column<T> {
            $($(#[$field_doc])* pub $field: T,)*
            /// Axial force N between both ends \[N\], tension positive.
            pub axial_force: T,
        }

        impl<T: Parameter> Element for $column<T> {
            type State = Bending;
            type Built = (<$rigid<T> as Element>::Built, AxialForce<T>);
            const MAY_BUCKLE: bool = true;

            fn build(self) -> Result<Self::Built, InvalidParameter> {
                let rigid = $rigid { $($field: self.$field),* }.build()?;
                Requirement::Finite.check("axial_force", self.axial_force)?;
                Ok((rigid, AxialForce { force: self.axial_force, output_x: self.output_x }))
            }

            fn estimate(built: &Self::Built, estimates: &mut FrequencyEstimates) {
                <$rigid<T> as Element>::estimate(&built.0, estimates);
                estimates.torsional_stiffness((built.1.force * built.1.output_x).abs().to_f64());
            }

            fn extent(built: &Self::Built) -> Extent {
                <$rigid<T> as Element>::extent(&built.0)
            }

            fn member_numbers(built: &Self::Built) -> MemberNumbers {
                <$rigid<T> as Element>::member_numbers(&built.0).under_axial_force(built.1.force.words())
            }
        }

        impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for $column<T> {
            fn transfer_matrix(built: &Self::Built, x: S) -> Matrix4<S> {
                let mut u = <$rigid<T> as TransferMatrix<S>>::transfer_matrix(&built.0, x);
                u[(2, 1)] += built.1.stiffness::<S>();
                u
            }
        }

        impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for $column<T> {
            type Coefficients = (<$rigid<T> as PlaneStep<S>>::Coefficients, S);

            #[inline(always)]
            fn coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> Self::Coefficients {
                (<$rigid<T> as PlaneStep<S>>::coefficients(&built.0, at), built.1.stiffness())
            }

            #[inline(always)]
            fn step<C: RootCounter<S>>(
                (rigid, k): &Self::Coefficients,
                input: Subspace<S>,
                counter: &mut C,
            ) -> Subspace<S> {
                <$rigid<T> as PlaneStep<S>>::step(rigid, stiffened(*k, &input), counter)
            }
        }

        impl<T: Real, S: Oscillation<T>> BackTransfer<S> for $column<T> {
            type BackCoefficients = (<$rigid<T> as BackTransfer<S>>::BackCoefficients, S);
            const SYMMETRIC: bool = <$rigid<T> as BackTransfer<S>>::SYMMETRIC;

            fn reversed(built: &Self::Built) -> Self::Built {
                (<$rigid<T> as BackTransfer<S>>::reversed(&built.0), built.1)
            }

            fn back_coefficients(built: &Self::Built, at: &FrequencyPowers<S>) -> Self::BackCoefficients {
                (<$rigid<T> as BackTransfer<S>>::back_coefficients(&built.0, at), built.1.stiffness())
            }

            fn back_transfer(
                (rigid, k): &Self::BackCoefficients,
                input: &Subspace<S>,
                covector: Covector<S>,
            ) -> Covector<S> {
                before_stiffness(*k, <$rigid<T> as BackTransfer<S>>::back_transfer(rigid, input, covector))
            }
        }

        impl<T: Real, S: Oscillation<T>> Energies<S> for $column<T> {
            type Gradient = $column<S>;

            fn units(built: &Self::Built, at: &FrequencyPowers<S>) -> [f64; 2] {
                let [force, moment] = <$rigid<T> as Energies<S>>::units(&built.0, at);
                [force, moment.max(S::size(built.1.stiffness::<S>()))]
            }

            fn mass_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
                <$rigid<T> as Energies<S>>::mass_form(&built.0, first, second)
            }

            /// `N |b| Θ₁ Θ₂`.
            fn stiffness_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S {
                built.1.stiffness::<S>() * first.input.theta * second.input.theta
            }

            fn gradient(built: &Self::Built, ends: &Ends<S>) -> $column<S> {
                let $rigid { $($field),* } = <$rigid<T> as Energies<S>>::gradient(&built.0, ends);
                let [axial_force, by_lever] = built.1.gradient(ends);
                let mut gradient = $column { $($field,)* axial_force };
                gradient.output_x += by_lever;
                gradient
            }
        }
    };
}
pub(crate) use under_axial_force;
