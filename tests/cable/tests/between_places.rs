//! The string as a member of plane frames, beside the built-in one between the same places and closed forms.

use core::f64::consts::PI;
use mstmm::prelude::*;

const EA: f64 = 4e4;
const EI: f64 = 30.0;
const M: f64 = 2.0;

/// A frame with a string between two of its corners, which is the one of the language or one's own.
macro_rules! braced_portal {
    ($name:ident, $($string:tt)*) => {
        system! {
            struct $name { span: f64, height: f64, length: f64, tension: f64, string_mass: f64 }
            let mass_per_length = string_mass;
            fixed at (0.0, 0.0) -> planar_beam 1 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn b at (0.0, height)
                -> planar_beam 2 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn c at (span, height)
                <- planar_beam 3 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } <- conn d at (span, 0.0);
            conn d <- pinned;
            conn b -> $($string)* brace { length, tension, mass_per_length } -> conn d;
        }
    };
}

braced_portal!(Portal, cable::Cable);
mod built_in {
    use super::*;
    system! {
        pub(super) struct Portal { pub(super) span: f64, pub(super) height: f64, pub(super) length: f64, pub(super) tension: f64, pub(super) string_mass: f64 }
        let mass_per_length = string_mass;
        fixed at (0.0, 0.0) -> planar_beam 1 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn b at (0.0, height)
            -> planar_beam 2 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn c at (span, height)
            <- planar_beam 3 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } <- conn d at (span, 0.0);
        conn d <- pinned;
        conn b -> string brace { length, tension, mass_per_length } -> conn d;
    }
}

#[test]
fn x() {
    let model = Portal { span: 4.0, height: 3.0, length: 5.0, tension: 900.0, string_mass: 0.7 };
    let Portal { span, height, length, tension, string_mass } = model;
    let own = model.build().unwrap();
    let other = built_in::Portal { span, height, length, tension, string_mass }.build().unwrap();
    let (a, b) = (own.first_frequencies::<30>().unwrap(), other.first_frequencies::<30>().unwrap());
    for (a, b) in a.iter().zip(&b) {
        println!("{} {}", a.omega, b.omega);
    }
    let _ = PI;
}
