//! Members of any type, for networks whose size the program decides.

use crate::element::{
    ByName, Charted, Element, MemberChart, MemberElement, MemberEnds, MemberGradient, MemberMatrix, MemberNumbers,
    MemberSlopes, MemberTransfer, MemberVisit, VisitMember, along_member, member_transfer,
};
use crate::elements::damped_joint::DampedJoint;
use crate::elements::joint::Joint;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::sideways::Sideways;
use crate::elements::twist::{DampedTwist, Twist};
use crate::elements::{
    Across, Beam, DampedBeam, DampedRod, DampedShaft, DampedSpring, DampedString, DampedTorsionSpring, Damper,
    GeneralBeam, InPlane, Rod, Shaft, Spring, SpringDamper, TautString, TorsionDamper, TorsionSpring,
    TorsionSpringDamper,
};
use crate::model::{FrequencyEstimates, InvalidParameter};
use crate::number::{ComplexFrequency, Frequency, FrequencyPowers, Oscillation, Real, Scalar, Single};
use crate::structure::Chart;
use mstmm_plan::Freedoms;

/// The cross section of a beam between two points, which give its length: an [`InPlane`] of a [`Beam`] without it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section<T> {
    /// Axial stiffness EA \[N\], positive.
    pub axial_stiffness: T,
    /// Bending stiffness EI [N m²], positive.
    pub bending_stiffness: T,
    /// Mass per length m [kg/m], zero or positive.
    pub mass_per_length: T,
}

impl<T> Section<T> {
    fn beam(self, length: T) -> InPlane<Beam<T>>
    where
        T: Scalar,
    {
        let Section { axial_stiffness, bending_stiffness, mass_per_length } = self;
        InPlane { axial_stiffness, across: Beam { length, bending_stiffness, mass_per_length } }
    }
}

/// The freedoms of the ends of beams along a line, and of strings in the plane.
const ACROSS: Freedoms = Freedoms::Y.union(Freedoms::RZ);
const DISPLACEMENTS: Freedoms = Freedoms::X.union(Freedoms::Y);

/// Declares an enum of members, and one of them built.
macro_rules! any_member {
    ($(#[$doc:meta])* $name:ident, $built:ident, $frequency:ident: $($beam:ident($kind:ty) in $freedoms:expr,)* ; $($connector:ident)* ; $($joint:ident)*) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum $name<T: Real> {
            /// A beam with bending and longitudinal vibration.
            Beam(Section<T>),
            $(
                #[doc = concat!("A [`", stringify!($joint), "`] of two points at one place.")]
                $joint($joint<T>),
            )*
            $(
                #[doc = concat!("A `", stringify!($kind), "`, whose length is that between its ends.")]
                $beam($kind),
            )*
            $(
                #[doc = concat!("A [`", stringify!($connector), "`]: of a translation along the member, of a rotation about z.")]
                $connector($connector<T>),
            )*
        }

        #[doc = concat!("A built [`", stringify!($name), "`].")]
        #[derive(Clone, Copy, Debug)]
        pub enum $built<T: Real> {
            /// A built beam.
            Beam(<InPlane<Beam<T>> as Element>::Built),
            $(
                #[doc = concat!("A built [`", stringify!($joint), "`].")]
                $joint(<$joint<T> as Element>::Built),
            )*
            $(
                #[doc = concat!("A built `", stringify!($kind), "`.")]
                $beam(<$kind as Element>::Built),
            )*
            $(
                #[doc = concat!("A built [`", stringify!($connector), "`].")]
                $connector(<$connector<T> as Element>::Built),
            )*
        }

        impl<T: Real> From<Section<T>> for $name<T> {
            fn from(section: Section<T>) -> Self {
                $name::Beam(section)
            }
        }

        $(
            impl<T: Real> From<$joint<T>> for $name<T> {
                fn from(joint: $joint<T>) -> Self {
                    $name::$joint(joint)
                }
            }
        )*

        $(
            impl<T: Real> From<$kind> for $name<T> {
                fn from(beam: $kind) -> Self {
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
            const MAY_BUCKLE: bool = <InPlane<Beam<T>> as Element>::MAY_BUCKLE
                $(|| <$joint<T> as Element>::MAY_BUCKLE)*
                $(|| <$kind as Element>::MAY_BUCKLE)*
                $(|| <$connector<T> as Element>::MAY_BUCKLE)*;

            fn may_buckle(built: &$built<T>) -> bool {
                match built {
                    $built::Beam(_) => <InPlane<Beam<T>> as Element>::MAY_BUCKLE,
                    $($built::$joint(_) => <$joint<T> as Element>::MAY_BUCKLE,)*
                    $($built::$beam(_) => <$kind as Element>::MAY_BUCKLE,)*
                    $($built::$connector(_) => <$connector<T> as Element>::MAY_BUCKLE,)*
                }
            }

            fn build(self, length: T) -> Result<$built<T>, InvalidParameter> {
                Ok(match self {
                    $name::Beam(section) => $built::Beam(section.beam(length).build()?),
                    $($name::$joint(joint) => $built::$joint(joint.build()?),)*
                    $($name::$beam(beam) => $built::$beam(beam.of_length(length).build()?),)*
                    $($name::$connector(connector) => $built::$connector(connector.build()?),)*
                })
            }

            /// A beam without an axial force becomes one with it.
            fn under_axial_force(built: $built<T>, force: [f64; 2]) -> Result<Option<$built<T>>, InvalidParameter> {
                Ok(match built {
                    $built::Beam(beam) => Some($built::GeneralInPlane(beam.under_axial_force(T::of_words(force)).build()?)),
                    $($built::$joint(_) => None,)*
                    $($built::$beam(mut beam) => {
                        <$kind as Element>::add_axial_force(&mut beam, force)?.then_some($built::$beam(beam))
                    })*
                    $($built::$connector(mut line) => {
                        <$connector<T> as Element>::add_axial_force(&mut line, force)?.then_some($built::$connector(line))
                    })*
                })
            }

            fn name(&self) -> &'static str {
                match self {
                    $name::Beam(_) => "beam",
                    $($name::$joint(_) => "joint",)*
                    $($name::$beam(_) => if $freedoms.contains(Freedoms::RZ) { "beam" } else { "string" },)*
                    $($name::$connector(_) => stringify!($connector),)*
                }
            }

            fn freedoms(&self) -> Freedoms {
                match self {
                    $name::Beam(_) => Freedoms::PLANE,
                    $($name::$joint(joint) => joint.freedoms(),)*
                    $($name::$beam(_) => $freedoms,)*
                    $($name::$connector(_) => along_member::<$connector<T>>(),)*
                }
            }

            fn is_joint(&self) -> bool {
                matches!(self, $($name::$joint(_))|*)
            }

            fn estimate(built: &$built<T>, estimates: &mut FrequencyEstimates) {
                match built {
                    $built::Beam(beam) => <InPlane<Beam<T>> as Element>::estimate(beam, estimates),
                    $($built::$joint(joint) => <$joint<T> as Element>::estimate(joint, estimates),)*
                    $($built::$beam(built) => <$kind as Element>::estimate(built, estimates),)*
                    $($built::$connector(built) => <$connector<T> as Element>::estimate(built, estimates),)*
                }
            }

            fn member_numbers(built: &$built<T>) -> MemberNumbers {
                match built {
                    $built::Beam(beam) => <InPlane<Beam<T>> as Element>::member_numbers(beam),
                    $($built::$joint(joint) => <$joint<T> as Element>::member_numbers(joint),)*
                    $($built::$beam(built) => <$kind as Element>::member_numbers(built),)*
                    $($built::$connector(built) => <$connector<T> as Element>::member_numbers(built),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + ChartScalar> MemberChart<S> for $name<T> {
            fn chart(built: &$built<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
                match built {
                    $built::Beam(beam) => <InPlane<Beam<T>> as Charted<S>>::chart(beam, at, length),
                    $($built::$joint(joint) => <$joint<T> as Charted<S>>::chart(joint, at, length),)*
                    $($built::$beam(built) => <$kind as Charted<S>>::chart(built, at, length),)*
                    $($built::$connector(built) => <$connector<T> as Charted<S>>::chart(built, at, length),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberVisit<S> for $name<T> {
            fn visit<V: VisitMember<S>>(built: &$built<T>, visitor: V) -> V::Output {
                match built {
                    $built::Beam(beam) => visitor.member::<InPlane<Beam<T>>>(beam),
                    $($built::$joint(joint) => visitor.member::<$joint<T>>(joint),)*
                    $($built::$beam(built) => visitor.member::<$kind>(built),)*
                    $($built::$connector(built) => visitor.member::<$connector<T>>(built),)*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberSlopes<S> for $name<T> {
            fn slope(built: &$built<T>, motion: &MemberEnds<S>, name: &str) -> Option<S> {
                match built {
                    $built::Beam(beam) => <InPlane<Beam<T>> as MemberGradient<S>>::member_gradient(beam, motion).by_name(name),
                    $($built::$joint(joint) => <$joint<T> as MemberGradient<S>>::member_gradient(joint, motion).by_name(name),)*
                    $($built::$beam(beam) => <$kind as MemberGradient<S>>::member_gradient(beam, motion).by_name(name),)*
                    $($built::$connector(built) => {
                        <$connector<T> as MemberGradient<S>>::member_gradient(built, motion).by_name(name)
                    })*
                }
            }
        }

        impl<T: Real, S: $frequency<T> + Single> MemberMatrix<S> for $name<T> {
            fn transfer(built: &$built<T>, x: S) -> MemberTransfer<S> {
                match built {
                    $built::Beam(beam) => member_transfer::<InPlane<Beam<T>>, S>(beam, x),
                    $($built::$joint(joint) => member_transfer::<$joint<T>, S>(joint, x),)*
                    $($built::$beam(built) => member_transfer::<$kind, S>(built, x),)*
                    $($built::$connector(built) => member_transfer::<$connector<T>, S>(built, x),)*
                }
            }
        }
    };
}

any_member!(
    /// Any member without damping.
    UndampedMember, BuiltUndampedMember, Frequency:
    GeneralInPlane(InPlane<GeneralBeam<T>>) in Freedoms::PLANE,
    GeneralBeam(GeneralBeam<T>) in ACROSS,
    StringInPlane(InPlane<TautString<T>>) in DISPLACEMENTS,
    Sideways(Sideways<TautString<T>>) in Freedoms::Y,
    Twist(Twist<T>) in Freedoms::RZ,
    ; Spring TorsionSpring TautString Rod Shaft; Joint
);
any_member!(
    /// Any member; a network with a damper has complex eigenvalues only.
    AnyMember, BuiltAnyMember, ComplexFrequency:
    GeneralInPlane(InPlane<GeneralBeam<T>>) in Freedoms::PLANE,
    GeneralBeam(GeneralBeam<T>) in ACROSS,
    StringInPlane(InPlane<TautString<T>>) in DISPLACEMENTS,
    DampedInPlane(InPlane<DampedBeam<T>>) in Freedoms::PLANE,
    DampedBeam(DampedBeam<T>) in ACROSS,
    DampedStringInPlane(InPlane<DampedString<T>>) in DISPLACEMENTS,
    Sideways(Sideways<TautString<T>>) in Freedoms::Y,
    DampedSideways(Sideways<DampedString<T>>) in Freedoms::Y,
    Twist(Twist<T>) in Freedoms::RZ,
    DampedTwist(DampedTwist<T>) in Freedoms::RZ,
    ;
    Spring TorsionSpring Damper TorsionDamper SpringDamper TorsionSpringDamper TautString Rod Shaft
    DampedSpring DampedTorsionSpring DampedString DampedRod DampedShaft; Joint DampedJoint
);

impl<T: Real> AnyMember<T> {
    /// The member, if it is one without damping.
    pub fn undamped(self) -> Option<UndampedMember<T>> {
        Some(match self {
            AnyMember::Beam(section) => section.into(),
            AnyMember::Joint(joint) => joint.into(),
            AnyMember::GeneralInPlane(beam) => beam.into(),
            AnyMember::GeneralBeam(beam) => beam.into(),
            AnyMember::StringInPlane(string) => string.into(),
            AnyMember::Sideways(string) => string.into(),
            AnyMember::Twist(twist) => twist.into(),
            AnyMember::Spring(spring) => spring.into(),
            AnyMember::TorsionSpring(spring) => spring.into(),
            AnyMember::TautString(string) => string.into(),
            AnyMember::Rod(rod) => rod.into(),
            AnyMember::Shaft(shaft) => shaft.into(),
            _ => return None,
        })
    }
}
