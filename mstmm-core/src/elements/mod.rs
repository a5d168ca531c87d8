//! The elements: one file holds everything about one element.

#[cfg(test)]
mod laws;

/// Declares the files of the elements and re-exports their types; the laws of the tests and the lists of steps use the same
/// list. Planar elements, which have no step of the plane method and no damping, stand apart.
macro_rules! elements {
    (
        undamped { $($file:ident :: $element:ident),* $(,)? }
        damped { $($damped_file:ident :: $damped_element:ident),* $(,)? }
        planar { $($planar_file:ident :: $planar_element:ident),* $(,)? }
    ) => {
        $(mod $file; pub use $file::$element;)*
        $(mod $damped_file; pub use $damped_file::$damped_element;)*
        $(mod $planar_file; pub use $planar_file::$planar_element;)*

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
        spring::Spring,
        torsion_spring::TorsionSpring,
        mass::Mass,
        inertia::Inertia,
        point_mass::PointMass,
        elastic_hinge::ElasticHinge,
        body::Body,
        beam::Beam,
    }
    damped {
        damper::Damper,
        torsion_damper::TorsionDamper,
        spring_damper::SpringDamper,
        torsion_spring_damper::TorsionSpringDamper,
    }
    planar {
        planar_body::PlanarBody,
        planar_beam::PlanarBeam,
        planar_hinge::PlanarHinge,
    }
}
