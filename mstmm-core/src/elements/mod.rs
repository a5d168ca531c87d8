//! The elements: one file holds everything about one element.

mod any;
mod beam;
mod body;
mod elastic_hinge;
#[cfg(test)]
mod laws;
mod line;
mod planar_beam;
mod planar_body;
mod planar_hinge;
mod point_mass;
pub(crate) mod shared;

pub use any::{AnyElement, AnyUndamped};
pub use beam::Beam;
pub use body::Body;
pub use elastic_hinge::ElasticHinge;
pub use line::{Damper, Inertia, Mass, Spring, SpringDamper, TorsionDamper, TorsionSpring, TorsionSpringDamper};
pub use planar_beam::PlanarBeam;
pub use planar_body::PlanarBody;
pub use planar_hinge::PlanarHinge;
pub use point_mass::PointMass;

/// Declares the list of the elements, which the laws of the tests and the lists of steps share. Planar elements, which have
/// no step of the plane method and no damping, stand apart.
macro_rules! elements {
    (
        undamped { $($element:ident),* $(,)? }
        damped { $($damped_element:ident),* $(,)? }
        planar { $($planar_element:ident),* $(,)? }
    ) => {
        /// Names of all element types, for the test that compares them with the keywords of the language.
        #[doc(hidden)]
        pub const NAMES: &[&str] =
            &[$(stringify!($element),)* $(stringify!($damped_element),)* $(stringify!($planar_element)),*];

        /// Hands the elements of the plane method to a macro: those without damping, then those with.
        macro_rules! stepping_elements {
            ($use_of_them:ident) => {
                $use_of_them! { undamped { $($element),* } damped { $($damped_element),* } }
            };
        }
        pub(crate) use stepping_elements;

        #[cfg(test)]
        macro_rules! for_each_undamped_element {
            ($law:ident) => {
                $($law::<$element<f64>>();)*
                $($law::<$planar_element<f64>>();)*
            };
        }
        #[cfg(test)]
        macro_rules! for_each_element {
            ($law:ident) => {
                $($law::<$element<f64>>();)*
                $($law::<$damped_element<f64>>();)*
                $($law::<$planar_element<f64>>();)*
            };
        }
        #[cfg(test)]
        use {for_each_element, for_each_undamped_element};
    };
}

elements! {
    undamped {
        Spring,
        TorsionSpring,
        Mass,
        Inertia,
        PointMass,
        ElasticHinge,
        Body,
        Beam,
    }
    damped {
        Damper,
        TorsionDamper,
        SpringDamper,
        TorsionSpringDamper,
    }
    planar {
        PlanarBody,
        PlanarBeam,
        PlanarHinge,
    }
}
