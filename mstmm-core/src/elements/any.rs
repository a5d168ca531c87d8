//! Elements of any type, for lists of steps.

use crate::element::{
    CarriesLoad, Element, Energies, ListElement, ListMoving, ListStepping, MOST_PARAMETERS, MemberNumbers, Visit,
    VisitStep,
};
use crate::elements::*;
use crate::model::{Ends, Extent, FrequencyEstimates, ParameterError, StateSpace};
use crate::number::{ComplexFrequency, Frequency, Oscillation, Real, Scalar};
use mstmm_plan::Space;

/// Declares an enum of built elements with the traits of list elements.
macro_rules! any_element {
    ($(#[$doc:meta])* $name:ident, $frequency:ident: $($element:ident { $($field:ident),* })*) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub enum $name<T: Real> {
            $(
                #[doc = concat!("A built [`", stringify!($element), "`].")]
                $element(<$element<T> as Element>::Built),
            )*
        }

        $(
            impl<T: Real> TryFrom<$element<T>> for $name<T> {
                type Error = ParameterError;

                fn try_from(element: $element<T>) -> Result<Self, ParameterError> {
                    element.build().map($name::$element).map_err(|error| error.of(stringify!($element)))
                }
            }
        )*

        impl<T: Real> CarriesLoad for $name<T> {}

        impl<T: Real> ListElement for $name<T> {
            type Parameter = T;
            const MAY_BUCKLE: bool = false $(|| <$element<T> as Element>::MAY_BUCKLE)*;

            fn may_buckle(&self) -> bool {
                match self {
                    $($name::$element(_) => <$element<T> as Element>::MAY_BUCKLE,)*
                }
            }

            fn space(&self) -> Space {
                match self {
                    $($name::$element(_) => <$element<T> as Element>::State::SPACE,)*
                }
            }

            fn name(&self) -> &'static str {
                match self {
                    $($name::$element(_) => stringify!($element),)*
                }
            }

            fn extent(&self) -> Extent {
                match self {
                    $($name::$element(built) => <$element<T> as Element>::extent(built),)*
                }
            }

            fn parameters(&self) -> &'static [&'static str] {
                match self {
                    $($name::$element(_) => &[$(stringify!($field)),*],)*
                }
            }

            fn member_numbers(&self) -> MemberNumbers {
                match self {
                    $($name::$element(built) => <$element<T> as Element>::member_numbers(built),)*
                }
            }

            fn estimate(&self, estimates: &mut FrequencyEstimates) {
                match self {
                    $($name::$element(built) => <$element<T> as Element>::estimate(built, estimates),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T>> ListStepping<S> for $name<T>
        {
            fn visit_step<V: VisitStep<S>>(&self, visitor: V) -> V::Output {
                match self {
                    $($name::$element(built) => visitor.element::<$element<T>>(built),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> ListMoving<S> for $name<T>
        {
            fn visit<V: Visit<S>>(&self, visitor: V) -> V::Output {
                match self {
                    $($name::$element(built) => visitor.element::<$element<T>>(built, None),)*
                }
            }

            fn gradient(&self, ends: &Ends<S>) -> [S; MOST_PARAMETERS] {
                match self {
                    $($name::$element(built) => {
                        let $element { $($field),* } = <$element<T> as Energies<S>>::gradient(built, ends);
                        filled([$($field),*])
                    })*
                }
            }
        }
    };
}

/// Numbers, and zeros behind them.
fn filled<S: Scalar, const N: usize>(numbers: [S; N]) -> [S; MOST_PARAMETERS] {
    const { assert!(N <= MOST_PARAMETERS) };
    core::array::from_fn(|k| numbers.get(k).copied().unwrap_or_default())
}

macro_rules! any_elements {
    (
        undamped { $($element:ident { $($field:ident),* })* }
        damped { $($damped:ident { $($damped_field:ident),* })* }
        spinning { $($spinning:ident)* } spinning damped { $($spinning_damped:ident)* }
    ) => {
        any_element!(
            /// Any built-in element without damping.
            AnyUndamped, Frequency: $($element { $($field),* })*
        );
        any_element!(
            /// Any built-in element; a list with a damper has complex eigenvalues only.
            AnyElement, ComplexFrequency: $($element { $($field),* })* $($damped { $($damped_field),* })*
        );
    };
}
crate::elements::stepping_elements!(any_elements);
