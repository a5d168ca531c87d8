//! The twist of a beam in space: a shaft as long as its places are apart.

use crate::element::{
    ByName, Charted, Element, Forms, Inside, MemberEnds, MemberGradient, MemberMotion, MemberNumbers, TransferMatrix,
};
use crate::elements::in_plane::AlongWaves;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::damped_line::DampedLine;
use crate::elements::shared::uniform_line::{UniformLine, line_chart};
use crate::elements::{DampedShaft, Shaft};
use crate::model::{EndMotion, FrequencyEstimates, InvalidParameter, Rotation};
use crate::number::{ComplexFrequency, Frequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use mstmm_plan::Freedoms;
use nalgebra::Matrix2;

/// The twist of a beam in space, `GJ Θ'' = ρI_p λ² Θ`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<T> {
    /// Length l \[m\], positive: that between its ends.
    pub length: T,
    /// Torsional stiffness GJ [N m²], positive.
    pub torsional_stiffness: T,
    /// Polar inertia per length ρI_p [kg m], zero or positive.
    pub polar_inertia_per_length: T,
}

/// The twist of a beam in space with damping of its material: `GJ (1 + iη)(1 + cλ) Θ'' = ρI_p λ² Θ`, at complex frequencies λ only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedTwist<T> {
    /// Length l \[m\], positive: that between its ends.
    pub length: T,
    /// Torsional stiffness GJ [N m²], positive.
    pub torsional_stiffness: T,
    /// Polar inertia per length ρI_p [kg m], zero or positive.
    pub polar_inertia_per_length: T,
    /// Loss factor η of GJ, zero or positive.
    pub loss_factor: T,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    pub kelvin_voigt_time: T,
}

/// What a parameter of a shaft is called in a beam.
fn of_beam(error: InvalidParameter) -> InvalidParameter {
    let parameter = if error.parameter == "inertia_per_length" { "polar_inertia_per_length" } else { error.parameter };
    InvalidParameter { parameter, ..error }
}

/// Declares a twist that builds what a shaft builds.
macro_rules! twist {
    ($twist:ident as $shaft:ident, $built:ident, $frequency:ident: $($loss:ident)*) => {
        impl<T> $twist<T> {
            /// The twist of another length.
            pub(crate) fn of_length(self, length: T) -> Self {
                $twist { length, ..self }
            }
        }

        #[diagnostic::do_not_recommend]
        impl<T: Parameter> Element for $twist<T> {
            type State = Rotation;
            type Built = $built<T>;

            fn build(self) -> Result<$built<T>, InvalidParameter> {
                let $twist { length, torsional_stiffness, polar_inertia_per_length, $($loss,)* } = self;
                let inertia_per_length = polar_inertia_per_length;
                shaft!($shaft { length, torsional_stiffness, inertia_per_length, $($loss,)* }).build().map_err(of_beam)
            }

            /// An axial force does not act on the twist.
            fn add_axial_force(_: &mut $built<T>, _: [f64; 2]) -> Result<bool, InvalidParameter> {
                Ok(true)
            }

            fn estimate(built: &$built<T>, estimates: &mut FrequencyEstimates) {
                <$shaft<T> as Element>::estimate(built, estimates);
            }

            fn member_numbers(built: &$built<T>) -> MemberNumbers {
                <$shaft<T> as Element>::member_numbers(built).between_places(2)
            }
        }

        #[diagnostic::do_not_recommend]
        impl<T: Parameter, S: $frequency<T> + Single> TransferMatrix<S> for $twist<T> {
            fn transfer_matrix(built: &$built<T>, x: S) -> Matrix2<S> {
                <$shaft<T> as TransferMatrix<S>>::transfer_matrix(built, x)
            }
        }

        #[diagnostic::do_not_recommend]
        impl<T: Parameter, S: $frequency<T> + ChartScalar> Charted<S> for $twist<T> {
            fn chart(built: &$built<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
                line_chart(&AlongWaves::<S>::longitudinal(built, at, length), Freedoms::RZ)
            }
        }

        #[diagnostic::do_not_recommend]
        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberMotion<S> for $twist<T> {
            fn forms(built: &$built<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
                <$shaft<T> as MemberMotion<S>>::forms(built, first, second)
            }

            fn inside(built: &$built<T>, x: S) -> Option<Inside> {
                <$shaft<T> as MemberMotion<S>>::inside(built, x)
            }

            fn motion_at(built: &$built<T>, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
                <$shaft<T> as MemberMotion<S>>::motion_at(built, motion, distance)
            }
        }

        #[diagnostic::do_not_recommend]
        impl<T: Real, S: $frequency<T> + Oscillation<T>> MemberGradient<S> for $twist<T> {
            type Gradient = $twist<S>;

            fn member_gradient(built: &$built<T>, motion: &MemberEnds<S>) -> $twist<S> {
                let gradient = <$shaft<T> as MemberGradient<S>>::member_gradient(built, motion);
                let $shaft { length, torsional_stiffness, inertia_per_length, $($loss,)* .. } = gradient;
                $twist { length, torsional_stiffness, polar_inertia_per_length: inertia_per_length, $($loss,)* }
            }
        }

        impl<S: Copy> ByName<S> for $twist<S> {
            /// The slope by the length is in the slopes by the places of its ends.
            fn by_name(&self, name: &str) -> Option<S> {
                match name {
                    "torsional_stiffness" => Some(self.torsional_stiffness),
                    "polar_inertia_per_length" => Some(self.polar_inertia_per_length),
                    $(stringify!($loss) => Some(self.$loss),)*
                    _ => None,
                }
            }
        }
    };
}

/// A shaft with what a twist has; what damps its displacements does not damp its rotation.
macro_rules! shaft {
    (Shaft { $($field:ident,)* }) => {
        Shaft { $($field,)* }
    };
    (DampedShaft { $($field:ident,)* }) => {
        DampedShaft { $($field,)* external_damping: T::zero() }
    };
}

twist!(Twist as Shaft, UniformLine, Frequency: );
twist!(DampedTwist as DampedShaft, DampedLine, ComplexFrequency: loss_factor kelvin_voigt_time);
