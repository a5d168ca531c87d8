//! Springs with damping of their material, and a dashpot beside it.

use crate::element::{
    BackTransfer, Charted, Element, Energies, Forms, MemberEnds, MemberGradient, MemberMotion, MemberNumbers,
    PlaneStep, TransferMatrix, along_member,
};
use crate::elements::shared::connector::connector;
use crate::elements::shared::damped_stiffness::DampedStiffness;
use crate::elements::shared::line_forms::{elongations, unit_of};
use crate::elements::shared::line_step::{back_through_stiffness, through_stiffness};
use crate::elements::shared::massless::off_pole;
use crate::model::{Ends, FrequencyEstimates, InvalidParameter, Requirement, Rotation, StateSpace, Translation};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::{Coordinate, Space};
use nalgebra::Matrix2;

/// Declares springs by their space and coordinate, and the estimates that stiffness and damping enter.
macro_rules! damped_springs {
    ($(
        $(#[$doc:meta])*
        $element:ident in $space:ident, $coordinate:ident: $stiffness_estimate:ident, $damping_estimate:ident {
            $($(#[$field_doc:meta])* $field:ident,)*
        }
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $element<T> {
            $($(#[$field_doc])* pub $field: T,)*
        }

        impl<T: Parameter> Element for $element<T> {
            type State = $space;
            type Built = DampedStiffness<T>;

            fn build(self) -> Result<DampedStiffness<T>, InvalidParameter> {
                DampedStiffness::new(Requirement::InvertibleOrZero, [$(self.$field),*], ["stiffness", "damping"])
            }

            fn member_numbers(built: &DampedStiffness<T>) -> MemberNumbers {
                MemberNumbers::Spring(if is_rotation::<Self>() { 2 } else { 0 }, built.stiffness.words())
                    .damped(built.dissipation.numbers())
            }

            fn estimate(built: &DampedStiffness<T>, estimates: &mut FrequencyEstimates) {
                built.estimate(estimates, [FrequencyEstimates::$stiffness_estimate, FrequencyEstimates::$damping_estimate]);
            }
        }

        impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for $element<T> {
            fn transfer_matrix(built: &DampedStiffness<T>, x: S) -> Matrix2<S> {
                let (_, compliance) = off_pole(built.at(x));
                let compliance = if is_rotation::<Self>() { compliance } else { -compliance };
                Matrix2::new(S::one(), compliance, S::zero(), S::one())
            }

            fn denominator(built: &DampedStiffness<T>, x: S) -> Option<S> {
                Some(off_pole(built.at(x)).0)
            }
        }

        impl<T: Parameter, S: ComplexFrequency<T>> PlaneStep<S> for $element<T> {
            type Coefficients = S;

            fn coefficients(built: &DampedStiffness<T>, at: &FrequencyPowers<S>) -> S {
                built.at(at.x)
            }

            fn step<C: RootCounter<S>>(kappa: &S, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
                through_stiffness(*kappa, input, counter)
            }
        }

        impl<T: Parameter, S: ComplexFrequency<T>> Charted<S> for $element<T> {
            fn chart(built: &DampedStiffness<T>, at: &FrequencyPowers<S>, _length: S) -> Chart<S> {
                connector(built.at(at.x), along_member::<Self>())
            }
        }

        impl<T: Real, S: ComplexFrequency<T>> BackTransfer<S> for $element<T> {
            type BackCoefficients = S;
            const SYMMETRIC: bool = true;

            fn reversed(built: &DampedStiffness<T>) -> DampedStiffness<T> {
                *built
            }

            fn back_coefficients(built: &DampedStiffness<T>, at: &FrequencyPowers<S>) -> S {
                built.at(at.x)
            }

            fn back_transfer(kappa: &S, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                back_through_stiffness(*kappa, input, covector)
            }
        }

        impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> Energies<S> for $element<T> {
            type Gradient = $element<S>;

            fn units(built: &DampedStiffness<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
                unit_of(Coordinate::$coordinate, built.size(S::size(at.x)))
            }

            fn mass_form(_built: &DampedStiffness<T>, _first: &Ends<S>, _second: &Ends<S>) -> S {
                S::zero()
            }

            fn stiffness_form(built: &DampedStiffness<T>, first: &Ends<S>, second: &Ends<S>) -> S {
                built.forms(first.x, elongations(Coordinate::$coordinate, first, second)).stiffness
            }

            fn damping_form(built: &DampedStiffness<T>, first: &Ends<S>, second: &Ends<S>) -> S {
                built.forms(first.x, elongations(Coordinate::$coordinate, first, second)).damping
            }

            fn gradient(built: &DampedStiffness<T>, ends: &Ends<S>) -> $element<S> {
                let [$($field),*] = built.gradient(ends.x, elongations(Coordinate::$coordinate, ends, ends));
                $element { $($field),* }
            }
        }

        impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberMotion<S> for $element<T> {
            fn forms(built: &DampedStiffness<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
                let elongation = |motion| built.elongation(motion, freedom::<Self>());
                built.forms(first.x, elongation(first) * elongation(second))
            }
        }

        impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberGradient<S> for $element<T> {
            type Gradient = $element<S>;

            fn member_gradient(built: &DampedStiffness<T>, motion: &MemberEnds<S>) -> $element<S> {
                let elongation: S = built.elongation(&motion, freedom::<Self>());
                let [$($field),*] = built.gradient(motion.x, elongation * elongation);
                $element { $($field),* }
            }
        }

        #[cfg(test)]
        impl super::laws::Sample for $element<f64> {
            fn sample(mut next: impl FnMut() -> f64) -> Self {
                $element { stiffness: next(), loss_factor: 0.2 * next(), kelvin_voigt_time: next(), damping: 0.5 * next() }
            }

            fn lossless(self) -> Self {
                $element { loss_factor: 0.0, ..self }
            }
        }
    )*};
}

/// Whether the force of a spring is a moment.
const fn is_rotation<E: Element>() -> bool {
    E::State::SPACE.is(Space::Rotation)
}

/// The freedom of a member in which a spring acts: along it, or about z.
const fn freedom<E: Element>() -> usize {
    if is_rotation::<E>() { 2 } else { 0 }
}

damped_springs! {
    /// Massless translational spring with damping of its material, `Q = (K (1 + iη)(1 + cλ) + dλ)(Y_I - Y_O)`, at complex frequencies λ only.
    ///
    /// With a time c alone it is a spring and a dashpot Kc in parallel. A loss factor describes motions with `Im λ > 0`.
    ///
    /// # Source
    /// Eq. (3) of the paper with a complex stiffness.
    DampedSpring in Translation, Y: translational_stiffness, translational_damping {
        /// Stiffness K [N/m], positive, with a finite reciprocal.
        stiffness,
        /// Loss factor η, zero or positive.
        loss_factor,
        /// Time c of Kelvin and Voigt \[s\], zero or positive.
        kelvin_voigt_time,
        /// Damping d of a dashpot beside it, [N s/m], zero or positive.
        damping,
    }

    /// Massless torsion spring with damping of its material, `M = (K (1 + iη)(1 + cλ) + dλ)(Θ_O - Θ_I)`, at complex frequencies λ only.
    ///
    /// # Source
    /// Eq. (4) of the paper with a complex stiffness.
    DampedTorsionSpring in Rotation, Theta: torsional_stiffness, torsional_damping {
        /// Stiffness K [N m/rad], positive, with a finite reciprocal.
        stiffness,
        /// Loss factor η, zero or positive.
        loss_factor,
        /// Time c of Kelvin and Voigt \[s\], zero or positive.
        kelvin_voigt_time,
        /// Damping d of a dashpot beside it, [N m s/rad], zero or positive.
        damping,
    }
}
