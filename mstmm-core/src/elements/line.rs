//! Springs, dampers and masses: the elements of translation and rotation paths.
//!
//! They differ in their coordinate, in the sign of its force, and in which of stiffness, damping and inertia they have.

use crate::element::{
    BackTransfer, Charted, DampingNumbers, Element, Energies, Forms, MemberEnds, MemberGradient, MemberMotion,
    MemberNumbers, PlaneStep, TransferMatrix, along_member,
};
use crate::elements::shared::connector::connector;
use crate::elements::shared::line_forms::{displacements, elongations, half, unit_of};
use crate::elements::shared::line_step::{back_through_stiffness, through_inertia, through_stiffness};
use crate::elements::shared::massless::Massless;
use crate::model::{Ends, FrequencyEstimates, InvalidParameter, Requirement, Rotation, StateSpace, Translation};
use crate::number::{ComplexFrequency, Frequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::{Coordinate, Space};
use nalgebra::Matrix2;

/// Declares elements by their kind, space, coordinate and type of frequency, and for each parameter its range and the estimate that
/// it enters.
macro_rules! line_elements {
    ($(
        $(#[$doc:meta])*
        $kind:ident $element:ident in $space:ident, $coordinate:ident at $frequency:ident {
            $($(#[$field_doc:meta])* $field:ident: $range:ident, $estimate:ident;)*
        }
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $element<T> {
            $($(#[$field_doc])* pub $field: T,)*
        }

        impl<T: Parameter> Element for $element<T> {
            type State = $space;
            type Built = Self;

            fn build(self) -> Result<Self, InvalidParameter> {
                $(Requirement::$range.check(stringify!($field), self.$field)?;)*
                Ok(self)
            }

            fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
                $(estimates.$estimate(built.$field.to_f64());)*
            }

            fn member_numbers(_built: &Self) -> MemberNumbers {
                numbers!(_built, $($field)*)
            }
        }

        $kind!($element, $coordinate, $frequency, $($field)*);

        #[cfg(test)]
        impl super::laws::Sample for $element<f64> {
            fn sample(mut next: impl FnMut() -> f64) -> Self {
                $element { $($field: next()),* }
            }
        }
    )*};
}

/// The numbers of an element that has these fields.
macro_rules! numbers {
    ($built:ident, stiffness) => {
        MemberNumbers::Spring(if is_rotation::<Self>() { 2 } else { 0 }, $built.stiffness.words())
    };
    ($built:ident, mass) => {
        MemberNumbers::mass([$built.mass, T::zero()])
    };
    ($built:ident, inertia) => {
        MemberNumbers::mass([T::zero(), $built.inertia])
    };
    ($built:ident, damping) => {
        dashpot!($built, T::zero())
    };
    ($built:ident, stiffness damping) => {
        dashpot!($built, $built.stiffness)
    };
}

/// The numbers of an element with damping and a stiffness.
macro_rules! dashpot {
    ($built:ident, $stiffness:expr) => {
        MemberNumbers::Spring(if is_rotation::<Self>() { 2 } else { 0 }, $stiffness.words())
            .damped(DampingNumbers { viscous: $built.damping.words(), ..DampingNumbers::default() })
    };
}

/// Stiffness and damping of an element that has these fields.
macro_rules! parts {
    ($built:ident, stiffness) => {
        Massless { stiffness: Some($built.stiffness), damping: None }
    };
    ($built:ident, damping) => {
        Massless { stiffness: None, damping: Some($built.damping) }
    };
    ($built:ident, stiffness damping) => {
        Massless { stiffness: Some($built.stiffness), damping: Some($built.damping) }
    };
}

/// The derivative of the dynamic work with respect to a field, given the frequency and half of the form of the elongations.
macro_rules! slope {
    (stiffness, $x:expr, $form:ident) => {
        $form
    };
    (damping, $x:expr, $form:ident) => {
        $x.lambda() * $form
    };
}

/// Implements a massless element: its force is its dynamic stiffness times its elongation.
macro_rules! massless {
    ($element:ident, $coordinate:ident, $frequency:ident, $($field:ident)*) => {
        impl<T: Parameter, S: $frequency<T> + Single> TransferMatrix<S> for $element<T> {
            #[inline(always)]
            fn transfer_matrix(built: &Self, x: S) -> Matrix2<S> {
                let compliance = parts!(built, $($field)*).compliance(x);
                let compliance = if is_rotation::<Self>() { compliance } else { -compliance };
                Matrix2::new(S::one(), compliance, S::zero(), S::one())
            }

            #[inline(always)]
            fn denominator(built: &Self, x: S) -> Option<S> {
                parts!(built, $($field)*).denominator(x)
            }
        }

        impl<T: Parameter, S: $frequency<T>> PlaneStep<S> for $element<T> {
            type Coefficients = S;

            #[inline(always)]
            fn coefficients(built: &Self, at: &FrequencyPowers<S>) -> S {
                parts!(built, $($field)*).dynamic_stiffness(at.x)
            }

            #[inline(always)]
            fn step<C: RootCounter<S>>(kappa: &S, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
                through_stiffness(*kappa, input, counter)
            }
        }

        impl<T: Parameter, S: $frequency<T>> Charted<S> for $element<T> {
            fn chart(built: &Self, at: &FrequencyPowers<S>, _length: S) -> Chart<S> {
                connector(Self::coefficients(built, at), along_member::<Self>())
            }
        }

        impl<T: Real, S: $frequency<T>> BackTransfer<S> for $element<T> {
            type BackCoefficients = S;
            const SYMMETRIC: bool = true;

            fn reversed(built: &Self) -> Self {
                *built
            }

            fn back_coefficients(built: &Self, at: &FrequencyPowers<S>) -> S {
                Self::coefficients(built, at)
            }

            fn back_transfer(kappa: &S, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                back_through_stiffness(*kappa, input, covector)
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> Energies<S> for $element<T> {
            type Gradient = $element<S>;

            fn units(built: &Self, at: &FrequencyPowers<S>) -> [f64; 2] {
                let lambda = S::size(Oscillation::<T>::lambda(at.x));
                unit_of(Coordinate::$coordinate, parts!(built, $($field)*).size(lambda))
            }

            fn mass_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
                S::zero()
            }

            fn stiffness_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
                let form = |stiffness| elongations(Coordinate::$coordinate, first, second) * stiffness;
                parts!(built, $($field)*).stiffness.map_or(S::zero(), form)
            }

            fn damping_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
                let form = |damping| elongations(Coordinate::$coordinate, first, second) * damping;
                parts!(built, $($field)*).damping.map_or(S::zero(), form)
            }

            fn gradient(_built: &Self, ends: &Ends<S>) -> $element<S> {
                let form = half(elongations(Coordinate::$coordinate, ends, ends));
                $element { $($field: slope!($field, ends.x, form)),* }
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberGradient<S> for $element<T> {
            type Gradient = $element<S>;

            fn member_gradient(built: &Self, motion: &MemberEnds<S>) -> $element<S> {
                let freedom = if is_rotation::<Self>() { 2 } else { 0 };
                let elongation: S = parts!(built, $($field)*).elongation(motion.x, &motion.ends, freedom);
                let form = half(elongation * elongation);
                $element { $($field: slope!($field, motion.x, form)),* }
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberMotion<S> for $element<T> {
            fn forms(built: &Self, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
                parts!(built, $($field)*).member_forms(if is_rotation::<Self>() { 2 } else { 0 }, first, second)
            }
        }
    };
}

/// Implements an element with inertia alone: its force is the inertia times λ² times its displacement.
macro_rules! inertial {
    ($element:ident, $coordinate:ident, $frequency:ident, $inertia:ident) => {
        impl<T: Parameter, S: $frequency<T> + Single> TransferMatrix<S> for $element<T> {
            #[inline(always)]
            fn transfer_matrix(built: &Self, x: S) -> Matrix2<S> {
                let inertia = x.lambda_squared() * built.$inertia;
                let inertia = if is_rotation::<Self>() { inertia } else { -inertia };
                Matrix2::new(S::one(), S::zero(), inertia, S::one())
            }
        }

        impl<T: Parameter, S: $frequency<T>> PlaneStep<S> for $element<T> {
            type Coefficients = S;

            #[inline(always)]
            fn coefficients(built: &Self, at: &FrequencyPowers<S>) -> S {
                at.lambda_squared * built.$inertia
            }

            #[inline(always)]
            fn step<C: RootCounter<S>>(inertia: &S, input: Subspace<S>, _counter: &mut C) -> Subspace<S> {
                through_inertia(*inertia, input)
            }
        }

        impl<T: Real, S: $frequency<T>> BackTransfer<S> for $element<T> {
            type BackCoefficients = ();
            const SYMMETRIC: bool = true;

            fn reversed(built: &Self) -> Self {
                *built
            }

            fn back_coefficients(_built: &Self, _at: &FrequencyPowers<S>) {}

            fn back_transfer(_coefficients: &(), _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                covector
            }
        }

        impl<T: Real, S: Oscillation<T>> Energies<S> for $element<T> {
            type Gradient = $element<S>;

            fn units(built: &Self, at: &FrequencyPowers<S>) -> [f64; 2] {
                unit_of(Coordinate::$coordinate, (at.lambda_squared * built.$inertia).size())
            }

            fn mass_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
                displacements(Coordinate::$coordinate, first, second) * built.$inertia
            }

            fn stiffness_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
                S::zero()
            }

            fn gradient(_built: &Self, ends: &Ends<S>) -> $element<S> {
                let form = half(displacements(Coordinate::$coordinate, ends, ends));
                $element { $inertia: ends.x.lambda_squared() * form }
            }
        }
    };
}

/// Whether the force of an element is a moment, which is counted with the opposite sign.
const fn is_rotation<E: Element>() -> bool {
    E::State::SPACE.is(Space::Rotation)
}

line_elements! {
    /// Massless translational spring, `Q = K (Y_I - Y_O)`.
    ///
    /// Transfer matrix on `[Y, Q]`: `[[1, -1/K], [0, 1]]`.
    ///
    /// # Source
    /// Eq. (3) of the paper.
    massless Spring in Translation, Y at Frequency {
        /// Stiffness K [N/m], zero, or positive with a finite reciprocal; of zero it joins nothing.
        stiffness: InvertibleOrZero, translational_stiffness;
    }

    /// Massless torsion spring, `M = K (Θ_O - Θ_I)`; mind the sign, which is opposite to that of a translational spring.
    ///
    /// Transfer matrix on `[Θ, M]`: `[[1, 1/K], [0, 1]]`.
    ///
    /// # Source
    /// Eq. (4) of the paper.
    massless TorsionSpring in Rotation, Theta at Frequency {
        /// Stiffness K [N m/rad], zero, or positive with a finite reciprocal; of zero it joins nothing.
        stiffness: InvertibleOrZero, torsional_stiffness;
    }

    /// Massless viscous damper, `Q = Cλ (Y_I - Y_O)`.
    ///
    /// Transfer matrix on `[Y, Q]`: `[[1, -1/κ], [0, 1]]` with the dynamic stiffness `κ = Cλ`, whose zero is the
    /// element's [`denominator`](TransferMatrix::denominator). It exists at complex frequencies λ only.
    ///
    /// # Source
    /// Eq. (6) of the paper.
    massless Damper in Translation, Y at ComplexFrequency {
        /// Damping C [N s/m], zero or positive.
        damping: NonNegative, translational_damping;
    }

    /// Massless viscous torsion damper, `M = Cλ (Θ_O - Θ_I)`.
    ///
    /// Transfer matrix on `[Θ, M]`: `[[1, 1/κ], [0, 1]]` with the dynamic stiffness `κ = Cλ`, whose zero is the
    /// element's [`denominator`](TransferMatrix::denominator). It exists at complex frequencies λ only.
    ///
    /// # Source
    /// Eq. (6) of the paper, on rotations as in eq. (4).
    massless TorsionDamper in Rotation, Theta at ComplexFrequency {
        /// Damping C [N m s/rad], zero or positive.
        damping: NonNegative, torsional_damping;
    }

    /// Massless spring and viscous damper in parallel, `Q = (K + Cλ)(Y_I - Y_O)`.
    ///
    /// Transfer matrix on `[Y, Q]`: `[[1, -1/κ], [0, 1]]` with the dynamic stiffness `κ = K + Cλ`, whose zero is the
    /// element's [`denominator`](TransferMatrix::denominator). It exists at complex frequencies λ only.
    ///
    /// # Source
    /// Eq. (39) of the paper.
    massless SpringDamper in Translation, Y at ComplexFrequency {
        /// Stiffness K [N/m], zero, or positive with a finite reciprocal; of zero it joins nothing.
        stiffness: InvertibleOrZero, translational_stiffness;
        /// Damping C [N s/m], zero or positive.
        damping: NonNegative, translational_damping;
    }

    /// Massless torsion spring and viscous torsion damper in parallel, `M = (K + Cλ)(Θ_O - Θ_I)`.
    ///
    /// Transfer matrix on `[Θ, M]`: `[[1, 1/κ], [0, 1]]` with the dynamic stiffness `κ = K + Cλ`, whose zero is the
    /// element's [`denominator`](TransferMatrix::denominator). It exists at complex frequencies λ only.
    ///
    /// # Source
    /// Eq. (39) of the paper, on rotations as in eq. (4).
    massless TorsionSpringDamper in Rotation, Theta at ComplexFrequency {
        /// Stiffness K [N m/rad], zero, or positive with a finite reciprocal; of zero it joins nothing.
        stiffness: InvertibleOrZero, torsional_stiffness;
        /// Damping C [N m s/rad], zero or positive.
        damping: NonNegative, torsional_damping;
    }

    /// Lumped mass without moment effects on a translation path.
    ///
    /// Transfer matrix on `[Y, Q]`: `[[1, 0], [-mλ², 1]]`.
    ///
    /// # Source
    /// Eq. (5) of the paper.
    inertial Mass in Translation, Y at Frequency {
        /// Mass m \[kg\], zero or positive.
        mass: NonNegative, mass;
    }

    /// Rotary inertia on a rotation path.
    ///
    /// Transfer matrix on `[Θ, M]`: `[[1, 0], [Jλ², 1]]`.
    ///
    /// # Source
    /// The rotation of a rigid body, eq. (15) of the paper with `b = c = 0`.
    inertial Inertia in Rotation, Theta at Frequency {
        /// Moment of inertia J [kg m²], zero or positive.
        inertia: NonNegative, moment_of_inertia;
    }
}
