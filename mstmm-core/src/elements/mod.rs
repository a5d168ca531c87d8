//! The elements: one file holds everything about one element.

use crate::element::{ByName, space_of};
use mstmm_plan::Space;

mod any;
pub(crate) mod any_member;
mod beam;
mod body;
mod cross_coupled_spring;
mod damped_hinge;
pub(crate) mod damped_joint;
mod damped_planar_hinge;
mod damped_spring;
mod damped_wave_line;
mod disc;
mod elastic_hinge;
mod general_beam;
#[cfg(feature = "std")]
pub(crate) mod gyroscope;
mod hinge;
pub(crate) mod in_plane;
pub(crate) mod joint;
#[cfg(test)]
mod laws;
mod lever;
mod line;
mod planar_body;
mod planar_hinge;
mod point_mass;
#[cfg(feature = "std")]
pub(crate) mod rotor_member;
pub(crate) mod shared;
pub(crate) mod sideways;
mod tapered_beam;
pub(crate) mod twist;
mod wave_line;

pub use any::{AnyElement, AnyUndamped};
pub use beam::Beam;
pub use body::{Body, BodyColumn, CentralBody, CentralBodyColumn};
pub use cross_coupled_spring::CrossCoupledSpring;
pub use damped_hinge::DampedHinge;
pub use damped_planar_hinge::DampedPlanarHinge;
pub use damped_spring::{DampedSpring, DampedTorsionSpring};
pub use damped_wave_line::{DampedRod, DampedShaft, DampedString};
pub use disc::Disc;
pub use elastic_hinge::ElasticHinge;
pub use general_beam::{
    BeamColumn, DampedBeam, DampedSpinningBeam, FoundationBeam, GeneralBeam, RayleighBeam, SpinningBeam, TimoshenkoBeam,
};
pub use hinge::{RotationalHinge, ShearHinge};
pub use in_plane::{Across, InPlane, Stretching};
pub use lever::{Lever, LeverColumn};
pub use line::{Damper, Inertia, Mass, Spring, SpringDamper, TorsionDamper, TorsionSpring, TorsionSpringDamper};
pub use planar_body::{PlanarBody, PlanarCentralBody};
pub use planar_hinge::PlanarHinge;
pub use point_mass::PointMass;
pub use sideways::Sideways;
pub use tapered_beam::TaperedBeam;
pub use twist::{DampedTwist, Twist};
pub use wave_line::{Rod, Shaft, TautString};

/// An element type: its name, space and parameters. The language has a row for each, too, and a test compares the two.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Name of the type.
    pub name: &'static str,
    /// Space of its states.
    pub space: Space,
    /// Names of its parameters, in the order of the fields.
    pub parameters: &'static [&'static str],
}

/// Declares the list of the elements with their parameters, which laws and lists of steps share. Planar elements are listed apart,
/// since they have no step of the plane method, and those that spin, since a list of steps has no whirl.
macro_rules! elements {
    (
        undamped { $($element:ident { $($field:ident),* })* }
        damped { $($damped:ident { $($damped_field:ident),* })* }
        spinning { $($spinning:ident { $($spinning_field:ident),* })* }
        spinning damped { $($spinning_damped:ident { $($spinning_damped_field:ident),* })* }
        planar { $($planar:ident { $($planar_field:ident),* })* }
        planar damped { $($planar_damped:ident { $($planar_damped_field:ident),* })* }
        stretching { $($stretching:ident)* }
        stretching damped { $($stretching_damped:ident)* }
    ) => {
        /// All element types.
        #[doc(hidden)]
        pub const ELEMENTS: &[Row] = &[
            $(row!($element { $($field),* }),)*
            $(row!($damped { $($damped_field),* }),)*
            $(row!($spinning { $($spinning_field),* }),)*
            $(row!($spinning_damped { $($spinning_damped_field),* }),)*
            $(row!($planar { $($planar_field),* }),)*
            $(row!($planar_damped { $($planar_damped_field),* }),)*
        ];

        /// Those that stretch as well in the plane, as an [`InPlane`].
        #[doc(hidden)]
        pub const STRETCHING: &[&str] = &[$(stringify!($stretching),)* $(stringify!($stretching_damped),)*];

        $(by_name!($element { $($field),* });)*
        $(by_name!($damped { $($damped_field),* });)*
        $(by_name!($spinning { $($spinning_field),* });)*
        $(by_name!($spinning_damped { $($spinning_damped_field),* });)*
        $(by_name!($planar { $($planar_field),* });)*
        $(by_name!($planar_damped { $($planar_damped_field),* });)*

        /// Hands the elements of the plane method to a macro: those without damping, then those with.
        macro_rules! stepping_elements {
            ($use_of_them:ident) => {
                $use_of_them! {
                    undamped { $($element { $($field),* })* } damped { $($damped { $($damped_field),* })* }
                    spinning { $($spinning)* } spinning damped { $($spinning_damped)* }
                }
            };
        }
        pub(crate) use stepping_elements;

        #[cfg(test)]
        macro_rules! for_each_undamped_element {
            ($law:ident) => {
                $($law::<$element<f64>>();)*
                $($law::<$spinning<f64>>();)*
                $($law::<$planar<f64>>();)*
                $($law::<InPlane<$stretching<f64>>>();)*
            };
        }
        #[cfg(test)]
        macro_rules! for_each_element {
            ($law:ident) => {
                $($law::<$element<f64>>();)*
                $($law::<$damped<f64>>();)*
                $($law::<$spinning<f64>>();)*
                $($law::<$spinning_damped<f64>>();)*
                $($law::<$planar<f64>>();)*
                $($law::<$planar_damped<f64>>();)*
                $($law::<InPlane<$stretching<f64>>>();)*
                $($law::<InPlane<$stretching_damped<f64>>>();)*
            };
        }
        #[cfg(test)]
        use {for_each_element, for_each_undamped_element};
    };
}

/// The parameters of an element by their names.
macro_rules! by_name {
    ($element:ident { $($field:ident),* }) => {
        impl<S: Copy> ByName<S> for $element<S> {
            fn by_name(&self, name: &str) -> Option<S> {
                match name {
                    $(stringify!($field) => Some(self.$field),)*
                    _ => None,
                }
            }
        }
    };
}

/// The row of an element; a field that is missing or misspelt does not compile.
macro_rules! row {
    ($element:ident { $($field:ident),* }) => {{
        const fn has_all_fields<T: Copy>($element { $($field: _),* }: $element<T>) {}
        let _ = has_all_fields::<f64>;
        Row { name: stringify!($element), space: space_of::<$element<f64>>(), parameters: &[$(stringify!($field)),*] }
    }};
}

elements! {
    undamped {
        Spring { stiffness }
        TorsionSpring { stiffness }
        Mass { mass }
        Inertia { inertia }
        PointMass { mass, inertia }
        ElasticHinge { stiffness_y, stiffness_theta }
        Body { mass, inertia, output_x, centre_x }
        BodyColumn { mass, inertia, output_x, centre_x, axial_force }
        CentralBody { mass, inertia, output_x, centre_x }
        CentralBodyColumn { mass, inertia, output_x, centre_x, axial_force }
        Beam { length, bending_stiffness, mass_per_length }
        RayleighBeam { length, bending_stiffness, mass_per_length, rotary_inertia }
        TimoshenkoBeam { length, bending_stiffness, mass_per_length, shear_stiffness, rotary_inertia }
        BeamColumn { length, bending_stiffness, mass_per_length, axial_force }
        FoundationBeam { length, bending_stiffness, mass_per_length, foundation_stiffness, foundation_shear_stiffness }
        GeneralBeam {
            length, bending_stiffness, mass_per_length, shear_stiffness, rotary_inertia, axial_force, foundation_stiffness,
            foundation_shear_stiffness
        }
        RotationalHinge { stiffness }
        ShearHinge { stiffness }
        Lever { output_x }
        LeverColumn { output_x, axial_force }
        TautString { length, tension, mass_per_length, foundation_stiffness }
        Rod { length, axial_stiffness, mass_per_length, foundation_stiffness }
        Shaft { length, torsional_stiffness, inertia_per_length }
        TaperedBeam {
            length, bending_stiffness, mass_per_length, width_taper, height_taper, rotary_inertia, axial_force, axial_load, rotation_speed,
            hub_radius, setting_angle, foundation_stiffness
        }
    }
    damped {
        Damper { damping }
        TorsionDamper { damping }
        SpringDamper { stiffness, damping }
        TorsionSpringDamper { stiffness, damping }
        DampedSpring { stiffness, loss_factor, kelvin_voigt_time, damping }
        DampedTorsionSpring { stiffness, loss_factor, kelvin_voigt_time, damping }
        DampedBeam {
            length, bending_stiffness, mass_per_length, shear_stiffness, rotary_inertia, axial_force, foundation_stiffness,
            foundation_shear_stiffness, loss_factor, kelvin_voigt_time, external_damping
        }
        DampedHinge { stiffness_y, stiffness_theta, damping_y, damping_theta, loss_factor, kelvin_voigt_time }
        DampedString { length, tension, mass_per_length, foundation_stiffness, external_damping }
        DampedRod {
            length, axial_stiffness, mass_per_length, foundation_stiffness, loss_factor, kelvin_voigt_time, external_damping
        }
        DampedShaft {
            length, torsional_stiffness, inertia_per_length, loss_factor, kelvin_voigt_time, external_damping
        }
    }
    spinning {
        SpinningBeam {
            length, bending_stiffness, mass_per_length, shear_stiffness, rotary_inertia, axial_force, foundation_stiffness,
            foundation_shear_stiffness, polar_inertia_per_length, speed
        }
        Disc { mass, inertia, polar_inertia, speed }
    }
    spinning damped {
        DampedSpinningBeam {
            length, bending_stiffness, mass_per_length, shear_stiffness, rotary_inertia, axial_force, foundation_stiffness,
            foundation_shear_stiffness, polar_inertia_per_length, speed, kelvin_voigt_time, external_damping
        }
        CrossCoupledSpring { stiffness, loss_factor, kelvin_voigt_time, damping, cross_stiffness, cross_damping }
    }
    planar {
        PlanarBody { mass, inertia, output_x, output_y, centre_x, centre_y }
        PlanarCentralBody { mass, inertia, output_x, output_y, centre_x, centre_y }
        PlanarHinge { stiffness_x, stiffness_y, stiffness_theta }
    }
    planar damped {
        DampedPlanarHinge {
            stiffness_x, stiffness_y, stiffness_theta, damping_x, damping_y, damping_theta, loss_factor, kelvin_voigt_time
        }
    }
    stretching { Beam RayleighBeam TimoshenkoBeam BeamColumn FoundationBeam GeneralBeam TautString }
    stretching damped { DampedBeam DampedString }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    #[test]
    fn each_element_has_its_row() {
        let (_, exports) = include_str!("mod.rs").split_once("pub use ").unwrap();
        let (exports, _) = exports.split_once("/// An element type").unwrap();
        let names = exports.split(['{', '}', ',', ':', ' ', ';', '\n']);
        // these are parts of elements in the plane and in space
        let parts = ["InPlane", "Sideways", "Twist", "DampedTwist"];
        let are_none = ["AnyElement", "AnyUndamped", "Across", "Stretching"];
        let is_type =
            |name: &&str| name.starts_with(char::is_uppercase) && !are_none.contains(name) && !parts.contains(name);
        let mut exported: Vec<&str> = names.filter(is_type).collect();
        let mut rows: Vec<&str> = ELEMENTS.iter().map(|row| row.name).collect();
        exported.sort_unstable();
        rows.sort_unstable();
        assert_eq!(exported, rows, "types that are exported, and rows of the list");
    }
}
