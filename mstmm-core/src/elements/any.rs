//! Elements of any type, for lists of steps.

use crate::element::traits::{Element, PlaneStep};
use crate::elements::*;
use crate::model::error::InvalidParameter;
use crate::model::estimates::FrequencyEstimates;
use crate::model::state::{Space, StateSpace, Support};
use crate::number::branch_free::BranchFree;
use crate::number::frequency::{ComplexFrequency, Frequency, Real};
use crate::number::frequency_powers::FrequencyPowers;
use crate::number::scaled::Scaled;
use crate::pass::block::walk::Walker;
use crate::pass::step_list::{ListElement, ListPass, ListWalk};
use crate::subspace::count::RootCounter;
use crate::subspace::minors::subspace::Subspace;

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
                type Error = InvalidParameter;

                fn try_from(element: $element<T>) -> Result<Self, InvalidParameter> {
                    element.build().map($name::$element)
                }
            }
        )*

        impl<T: Real> ListElement for $name<T> {
            type Parameter = T;

            fn space(&self) -> Space {
                match self {
                    $($name::$element(_) => <$element<T> as Element>::State::SPACE,)*
                }
            }

            fn estimate(&self, estimates: &mut FrequencyEstimates) {
                match self {
                    $($name::$element(built) => <$element<T> as Element>::estimate(built, estimates),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T>> ListWalk<S> for $name<T>
        where
            BranchFree<S, false>: $frequency<T>,
            BranchFree<S, true>: $frequency<T>,
        {
            fn walk<W: Walker<S>>(&self, walker: &mut W) {
                match self {
                    $($name::$element(built) => walker.element::<$element<T>>(built),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T>> ListPass<S> for $name<T> {
            fn step<C: RootCounter<S>>(&self, at: &FrequencyPowers<S>, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
                match self {
                    $($name::$element(built) => {
                        $element::<T>::step(&$element::<T>::coefficients(built, at), input, counter)
                    })*
                }
            }

            fn root<C: RootCounter<S>>(
                &self,
                at: &FrequencyPowers<S>,
                input: Subspace<S>,
                support: Support,
                counter: &mut C,
            ) -> Scaled<S> {
                match self {
                    $($name::$element(built) => {
                        <$element<T> as PlaneStep<S>>::root(
                            &$element::<T>::coefficients(built, at), input, support, counter,
                        )
                    })*
                }
            }
        }
    };
}

macro_rules! any_elements {
    (undamped { $($element:ident { $($field:ident),* })* } damped { $($damped:ident { $($damped_field:ident),* })* }) => {
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
