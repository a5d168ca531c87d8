//! Members of rotors at run time: members of other frames, beams that spin, discs and seals.

use crate::element::{
    ByName, Charted, Element, MemberChart, MemberElement, MemberEnds, MemberGradient, MemberMatrix, MemberNumbers,
    MemberSlopes, MemberSpins, MemberTransfer, MemberVisit, Spins, VisitMember, along_member, member_transfer,
};
use crate::elements::any_member::{AnyMember, UndampedMember};
use crate::elements::gyroscope::Gyroscope;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::{CrossCoupledSpring, DampedSpinningBeam, SpinningBeam};
use crate::model::{FrequencyEstimates, InvalidParameter};
use crate::number::{ComplexFrequency, Frequency, FrequencyPowers, Oscillation, Real, Single};
use crate::structure::Chart;
use mstmm_plan::Freedoms;

/// Declares an enum of the members of a rotor: members that stand still, beams that spin, and connectors of one motion each.
macro_rules! rotor_member {
    ($(#[$doc:meta])* $name:ident, $built:ident of $standing:ident at $frequency:ident: $($beam:ident)* ; $($connector:ident)*) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum $name<T: Real> {
            /// A member that does not spin.
            Standing($standing<T>),
            $(
                #[doc = concat!("A `", stringify!($beam), "`, whose length is that between its ends.")]
                $beam($beam<T>),
            )*
            $(
                #[doc = concat!("A `", stringify!($connector), "`.")]
                $connector($connector<T>),
            )*
        }

        #[doc = concat!("A built [`", stringify!($name), "`].")]
        #[derive(Clone, Copy, Debug)]
        pub enum $built<T: Real> {
            /// A built member that does not spin.
            Standing(<$standing<T> as MemberElement>::Built),
            $(
                #[doc = concat!("A built `", stringify!($beam), "`.")]
                $beam(<$beam<T> as Element>::Built),
            )*
            $(
                #[doc = concat!("A built `", stringify!($connector), "`.")]
                $connector(<$connector<T> as Element>::Built),
            )*
        }

        impl<T: Real> From<$standing<T>> for $name<T> {
            fn from(member: $standing<T>) -> Self {
                $name::Standing(member)
            }
        }

        $(
            impl<T: Real> From<$beam<T>> for $name<T> {
                fn from(beam: $beam<T>) -> Self {
                    $name::$beam(beam)
                }
            }
        )*

        $(
            impl<T: Real> From<$connector<T>> for $name<T> {
                fn from(connector: $connector<T>) -> Self {
                    $name::$connector(connector)
                }
            }
        )*

        impl<T: Real> MemberElement for $name<T> {
            type Parameter = T;
            type Built = $built<T>;
            const MAY_BUCKLE: bool = true;
            const SPINS: bool = true;

            fn may_buckle(built: &$built<T>) -> bool {
                match built {
                    $built::Standing(built) => <$standing<T> as MemberElement>::may_buckle(built),
                    $($built::$beam(_) => <$beam<T> as Element>::MAY_BUCKLE,)*
                    $($built::$connector(_) => <$connector<T> as Element>::MAY_BUCKLE,)*
                }
            }

            fn build(self, length: T) -> Result<$built<T>, InvalidParameter> {
                Ok(match self {
                    $name::Standing(member) => $built::Standing(member.build(length)?),
                    $($name::$beam(beam) => $built::$beam($beam { length, ..beam }.build()?),)*
                    $($name::$connector(connector) => $built::$connector(connector.build()?),)*
                })
            }

            fn under_axial_force(built: $built<T>, force: [f64; 2]) -> Result<Option<$built<T>>, InvalidParameter> {
                Ok(match built {
                    $built::Standing(built) => {
                        <$standing<T> as MemberElement>::under_axial_force(built, force)?.map($built::Standing)
                    }
                    _ => None,
                })
            }

            fn name(&self) -> &'static str {
                match self {
                    $name::Standing(member) => member.name(),
                    $($name::$beam(_) => stringify!($beam),)*
                    $($name::$connector(_) => stringify!($connector),)*
                }
            }

            fn freedoms(&self) -> Freedoms {
                match self {
                    $name::Standing(member) => member.freedoms(),
                    $($name::$beam(_) => Freedoms::Y.union(Freedoms::RZ),)*
                    $($name::$connector(_) => along_member::<$connector<T>>(),)*
                }
            }

            fn is_joint(&self) -> bool {
                matches!(self, $name::Standing(member) if member.is_joint())
            }

            fn estimate(built: &$built<T>, estimates: &mut FrequencyEstimates) {
                match built {
                    $built::Standing(built) => <$standing<T> as MemberElement>::estimate(built, estimates),
                    $($built::$beam(built) => <$beam<T> as Element>::estimate(built, estimates),)*
                    $($built::$connector(built) => <$connector<T> as Element>::estimate(built, estimates),)*
                }
            }

            fn member_numbers(built: &$built<T>) -> MemberNumbers {
                match built {
                    $built::Standing(built) => <$standing<T> as MemberElement>::member_numbers(built),
                    $($built::$beam(built) => <$beam<T> as Element>::member_numbers(built),)*
                    $($built::$connector(built) => <$connector<T> as Element>::member_numbers(built),)*
                }
            }
        }

        impl<T: Real> MemberSpins for $name<T> {
            fn turned_round(built: $built<T>) -> $built<T> {
                match built {
                    $built::Standing(_) => built,
                    $($built::$beam(built) => $built::$beam(<$beam<T> as Spins>::turned_round(built)),)*
                    $($built::$connector(built) => $built::$connector(<$connector<T> as Spins>::turned_round(built)),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + ChartScalar> MemberChart<S> for $name<T> {
            fn chart(built: &$built<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
                match built {
                    $built::Standing(built) => <$standing<T> as MemberChart<S>>::chart(built, at, length),
                    $($built::$beam(built) => <$beam<T> as Charted<S>>::chart(built, at, length),)*
                    $($built::$connector(built) => <$connector<T> as Charted<S>>::chart(built, at, length),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberVisit<S> for $name<T> {
            fn visit<V: VisitMember<S>>(built: &$built<T>, visitor: V) -> V::Output {
                match built {
                    $built::Standing(built) => <$standing<T> as MemberVisit<S>>::visit(built, visitor),
                    $($built::$beam(built) => visitor.member::<$beam<T>>(built),)*
                    $($built::$connector(built) => visitor.member::<$connector<T>>(built),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberSlopes<S> for $name<T> {
            fn slope(built: &$built<T>, motion: &MemberEnds<S>, name: &str) -> Option<S> {
                match built {
                    $built::Standing(built) => <$standing<T> as MemberSlopes<S>>::slope(built, motion, name),
                    $($built::$beam(built) => <$beam<T> as MemberGradient<S>>::member_gradient(built, motion).by_name(name),)*
                    $($built::$connector(built) => {
                        <$connector<T> as MemberGradient<S>>::member_gradient(built, motion).by_name(name)
                    })*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + Single> MemberMatrix<S> for $name<T> {
            fn transfer(built: &$built<T>, x: S) -> MemberTransfer<S> {
                match built {
                    $built::Standing(built) => <$standing<T> as MemberMatrix<S>>::transfer(built, x),
                    $($built::$beam(built) => member_transfer::<$beam<T>, S>(built, x),)*
                    $($built::$connector(built) => member_transfer::<$connector<T>, S>(built, x),)*
                }
            }
        }
    };
}

rotor_member!(
    /// Any member of a rotor without damping.
    UndampedRotorMember, BuiltUndampedRotorMember of UndampedMember at Frequency: SpinningBeam; Gyroscope
);
rotor_member!(
    /// Any member of a rotor.
    RotorMember, BuiltRotorMember of AnyMember at ComplexFrequency:
    SpinningBeam DampedSpinningBeam; Gyroscope CrossCoupledSpring
);

impl<T: Real> RotorMember<T> {
    /// The member, if it is one without damping.
    pub fn undamped(self) -> Option<UndampedRotorMember<T>> {
        Some(match self {
            RotorMember::Standing(member) => member.undamped()?.into(),
            RotorMember::SpinningBeam(beam) => beam.into(),
            RotorMember::Gyroscope(gyroscope) => gyroscope.into(),
            RotorMember::DampedSpinningBeam(_) | RotorMember::CrossCoupledSpring(_) => return None,
        })
    }

    /// The member, if nothing of it belongs to a rotor.
    pub fn standing(self) -> Option<AnyMember<T>> {
        match self {
            RotorMember::Standing(member) => Some(member),
            _ => None,
        }
    }
}
