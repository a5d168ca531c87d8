//! Cases of validation.json in the language, with the same parameters in the same order as the lists of steps.

use mstmm::prelude::*;

/// A model from the values of its fields in order.
pub(crate) trait FromValues {
    type System;
    fn system_of(values: &[f64]) -> Self::System;
}

/// Declares a model with fields that are all numbers, and its construction from a slice.
macro_rules! model {
    ($(#[$doc:meta])* $model:ident, $system:ident { $($field:ident),* } $($scene:tt)*) => {
        system! {
            $(#[$doc])*
            #[derive(Clone, Copy, Debug)]
            pub(crate) struct $model { $($field: f64),* }
            $($scene)*
        }

        impl FromValues for $model {
            type System = $system;
            fn system_of(values: &[f64]) -> $system {
                let mut values = values.iter().copied();
                $model { $($field: values.next().unwrap()),* }.build().unwrap()
            }
        }
    };
}

model! {
    /// Cantilever of two different halves.
    Stepped, SteppedSystem { l1, ei1, m1, l2, ei2, m2 }
    fixed -> beam 1 { length: l1, bending_stiffness: ei1, mass_per_length: m1 }
          -> beam 2 { length: l2, bending_stiffness: ei2, mass_per_length: m2 } -> free
}

model! {
    /// Two equal cantilevers whose tips are joined by a spring.
    Twins, TwinsSystem { l, ei, m, k }
    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> conn 2 -> spring 3 { stiffness: k }
          -> conn 4 -> free;
    fixed -> beam 5 { length: l, bending_stiffness: ei, mass_per_length: m } -> conn 4
}

model! {
    /// Cantilever with three sprung masses.
    SprungMasses, SprungMassesSystem { ei, m, l1, l2, l3, l4, m1, m2, m3, k1, k2, k3 }
    fixed -> beam a { length: l1, bending_stiffness: ei, mass_per_length: m } -> conn 1
          -> beam b { length: l2, bending_stiffness: ei, mass_per_length: m } -> conn 2
          -> beam c { length: l3, bending_stiffness: ei, mass_per_length: m } -> conn 3
          -> beam d { length: l4, bending_stiffness: ei, mass_per_length: m } -> free;
    free -> mass d1 { mass: m1 } -> spring s1 { stiffness: k1 } -> conn 1;
    free -> mass d2 { mass: m2 } -> spring s2 { stiffness: k2 } -> conn 2;
    free -> mass d3 { mass: m3 } -> spring s3 { stiffness: k3 } -> conn 3
}

model! {
    /// Pinned beam with a grounded dashpot at mid-span.
    DampedBeam, DampedBeamSystem { half, ei, m, c }
    pinned -> beam 1 { length: half, bending_stiffness: ei, mass_per_length: m } -> conn 2
           -> beam 3 { length: half, bending_stiffness: ei, mass_per_length: m } -> pinned;
    fixed -> damper 4 { damping: c } -> conn 2
}
