//! The motions of springs, dampers and masses: elements of translation and rotation paths share their formulas.

use crate::model::ends::Ends;
use crate::model::state::{Coordinate, Support};
use crate::number::scalar::Scalar;
use crate::subspace::minors::covector::Covector;
use crate::subspace::minors::subspace::Subspace;

/// Against a massless element of dynamic stiffness κ: its step multiplies a line by `κ U`, a grounded one by `-κ U`.
pub(crate) fn back_through_stiffness<S: Scalar>(kappa: S, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
    let is_grounded = matches!(input, Subspace::Tip(Support::Fixed, _));
    covector.times(if is_grounded { -kappa } else { kappa }, 0)
}

/// The form `ΔY₁ ΔY₂`, or `ΔΘ₁ ΔΘ₂`, of a stiffness or a damping of 1.
pub(crate) fn elongations<S: Scalar>(coordinate: Coordinate, first: &Ends<S>, second: &Ends<S>) -> S {
    let elongation = |ends: &Ends<S>| ends.output.entry(coordinate) - ends.input.entry(coordinate);
    elongation(first) * elongation(second)
}

/// The form `Y₁ Y₂`, or `Θ₁ Θ₂`, of an inertia of 1.
pub(crate) fn displacements<S: Scalar>(coordinate: Coordinate, first: &Ends<S>, second: &Ends<S>) -> S {
    first.input.entry(coordinate) * second.input.entry(coordinate)
}

/// Usual sizes `[Q/Y, M/Θ]` of an element that knows one of them.
pub(crate) fn unit_of(coordinate: Coordinate, size: f64) -> [f64; 2] {
    if coordinate == Coordinate::Y { [size, 0.0] } else { [0.0, size] }
}

/// Half of a form of a motion with itself.
pub(crate) fn half<S: Scalar>(form: S) -> S {
    form * S::from_f64(0.5)
}

/// The motion of a massless element with the elongation of a coordinate, given the names of its stiffness and its damping.
macro_rules! massless_motion {
    ($element:ident, $coordinate:ident, $frequency:ident, [$($stiffness:ident)?], [$($damping:ident)?]) => {
        impl<T: Real, S: $frequency<T> + Oscillation<T>> Energies<S> for $element<T> {
            type BackCoefficients = S;
            type Gradient = $element<S>;
            const SYMMETRIC: bool = true;

            fn reversed(built: &Self) -> Self {
                *built
            }

            fn links(built: &Self, at: &FrequencyPowers<S>) -> S {
                Self::coefficients(built, at)
            }

            fn back_transfer(kappa: &S, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                back_through_stiffness(*kappa, input, covector)
            }

            /// Of the parts, not of their sum: an overdamped motion is where they cancel.
            fn units(built: &Self, at: &FrequencyPowers<S>) -> [f64; 2] {
                let _lambda = S::size(Oscillation::<T>::lambda(at.x));
                let size = 0.0 $(+ built.$stiffness.to_f64())? $(+ built.$damping.to_f64() * _lambda)?;
                unit_of(Coordinate::$coordinate, size)
            }

            fn mass_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
                S::zero()
            }

            fn stiffness_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
                S::zero() $(+ elongations(Coordinate::$coordinate, _first, _second) * _built.$stiffness)?
            }

            $(fn damping_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
                elongations(Coordinate::$coordinate, first, second) * built.$damping
            })?

            fn gradient(_built: &Self, ends: &Ends<S>) -> $element<S> {
                let form = half(elongations(Coordinate::$coordinate, ends, ends));
                $element { $($stiffness: form,)? $($damping: ends.x.lambda() * form,)? }
            }
        }
    };
}

/// The motion of an element that has inertia alone, given the coordinate that it moves in and the name of its parameter.
macro_rules! inertial_motion {
    ($element:ident, $coordinate:ident, $inertia:ident) => {
        impl<T: Real, S: Oscillation<T>> Energies<S> for $element<T> {
            type BackCoefficients = ();
            type Gradient = $element<S>;
            const SYMMETRIC: bool = true;

            fn reversed(built: &Self) -> Self {
                *built
            }

            fn links(_built: &Self, _at: &FrequencyPowers<S>) {}

            fn back_transfer(_links: &(), _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                covector
            }

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

pub(crate) use {inertial_motion, massless_motion};
