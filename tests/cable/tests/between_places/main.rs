//! Elements of one's own as members of plane frames: beside those of the language between the same places, and closed forms.
//!
//! What the language has in common with them is the network alone; charts, forms and gradients are written twice.

mod elements;

use core::f64::consts::PI;
use elements::{Coil, Dashpot, Known};
use mstmm::motion::{MotionError, PlaneLoad};
use mstmm::prelude::*;

const EA: f64 = 4e4;
const EI: f64 = 30.0;
const M: f64 = 2.0;

/// A portal with a string in its diagonal, the way of which is given.
macro_rules! portals {
    ($($name:ident { $($string:tt)+ })*) => {$(
        system! {
            struct $name { span: f64, height: f64, length: f64, tension: f64, mass_per_length: f64 }
            fixed at (0.0, 0.0)
                -> beam 1 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn b at (0.0, height)
                -> beam 2 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn c at (span, height)
                <- beam 3 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } <- conn d at (span, 0.0);
            conn d <- pinned;
            conn b -> $($string)+ brace { length, tension, mass_per_length } -> conn d;
        }

        impl $name {
            const SAMPLE: Self = $name { span: 4.0, height: 3.0, length: 4.8, tension: 900.0, mass_per_length: 0.7 };
        }
    )*};
}

portals! {
    Own { cable::Cable }
    InNumbers { self::Known }
    BuiltIn { string }
}

/// Two intervals of one root; the string of one's own rounds its constants.
fn agree(one: &NaturalFrequency, other: &NaturalFrequency) -> bool {
    let room = 4.0 * f64::EPSILON * one.omega;
    let meet = one.lower - room <= other.upper && other.lower - room <= one.upper;
    meet && (one.multiplicity, one.index) == (other.multiplicity, other.index)
}

#[test]
fn a_frame_with_a_string_of_ones_own_has_the_certified_frequencies_of_the_built_in_one() {
    let (own, numbers, built_in) = (Own::SAMPLE.build(), InNumbers::SAMPLE.build(), BuiltIn::SAMPLE.build());
    let (own, numbers, built_in) = (own.unwrap(), numbers.unwrap(), built_in.unwrap());
    let found = built_in.first_frequencies::<60>().unwrap();
    for roots in [own.first_frequencies::<60>().unwrap(), numbers.first_frequencies::<60>().unwrap()] {
        assert!(roots.iter().zip(&found).all(|(one, other)| agree(one, other)));
    }
    for omega in [0.0, 1.0, 30.0, 151.3, 900.0, 1e4] {
        assert_eq!(own.count_below(omega), built_in.count_below(omega), "{omega}");
        assert_eq!(numbers.count_below(omega), built_in.count_below(omega), "{omega}");
    }
}

/// Strings from slack to stiff, light to heavy: the numbers are those of a fixed sequence.
#[test]
fn counts_are_those_of_the_built_in_one_in_many_portals() {
    let mut state = 7_u64;
    let mut next = |decades: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        10.0_f64.powf(decades * ((state >> 11) as f64 / 2.0_f64.powi(53) - 0.5))
    };
    for _ in 0..100 {
        let (length, tension, mass_per_length) = (4.8 * next(2.0), 900.0 * next(8.0), 0.7 * next(6.0));
        let own = Own { length, tension, mass_per_length, ..Own::SAMPLE }.build().unwrap();
        let built_in = BuiltIn { length, tension, mass_per_length, ..BuiltIn::SAMPLE }.build().unwrap();
        for _ in 0..10 {
            let omega = 100.0 * next(6.0);
            assert_eq!(
                own.count_below(omega),
                built_in.count_below(omega),
                "{length} {tension} {mass_per_length} {omega}"
            );
        }
    }
}

/// At the clamped frequencies of the string, `nπ/l sqrt(H/m)`, and beside them.
#[test]
fn counts_hold_beside_the_clamped_frequencies_of_the_string() {
    let (own, built_in) = (Own::SAMPLE.build().unwrap(), BuiltIn::SAMPLE.build().unwrap());
    let Own { length, tension, mass_per_length, .. } = Own::SAMPLE;
    for n in 1..40 {
        let clamped = f64::from(n) * PI / length * (tension / mass_per_length).sqrt();
        for omega in [clamped * (1.0 - 4.0 * f64::EPSILON), clamped, clamped * (1.0 + 4.0 * f64::EPSILON)] {
            assert_eq!(own.count_below(omega), built_in.count_below(omega), "{n}: {omega}");
        }
    }
}

#[test]
fn its_shapes_are_those_of_the_built_in_one() {
    let (own, built_in) = (Own::SAMPLE.build().unwrap(), BuiltIn::SAMPLE.build().unwrap());
    let roots = (own.first_frequencies::<20>().unwrap(), built_in.first_frequencies::<20>().unwrap());
    for (one, other) in roots.0.iter().zip(&roots.1) {
        let (one, other) = (own.mode_shape(one).unwrap(), built_in.mode_shape(other).unwrap());
        let at = |share: f64| {
            let distance = share * Own::SAMPLE.length;
            let (one, other) = (one.along(Own::Cable_brace, distance), other.along(BuiltIn::string_brace, distance));
            (one.unwrap(), other.unwrap())
        };
        let corners = (one.value(Own::conn_b.displacement_x()), other.value(BuiltIn::conn_b.displacement_x()));
        let sign = (corners.0.unwrap() * corners.1.unwrap()).signum();
        for share in [0.0, 0.13, 0.5, 0.91, 1.0] {
            let (one, other) = at(share);
            let forces = (one.axial_force, sign * other.axial_force);
            assert!((one.displacement_x - sign * other.displacement_x).abs() < 1e-10, "{share}: {one:?} {other:?}");
            assert!((forces.0 - forces.1).abs() < 1e-10 * Own::SAMPLE.tension * 10.0, "{share}: {one:?} {other:?}");
        }
        let shares = (one.energy_shares(Own::Cable_brace), other.energy_shares(BuiltIn::string_brace));
        let (one, other) = (shares.0.unwrap(), shares.1.unwrap());
        assert!((one.strain - other.strain).abs() < 1e-11 && (one.kinetic - other.kinetic).abs() < 1e-11);
    }
}

#[test]
fn its_responses_are_those_of_the_built_in_one() {
    let (own, built_in) = (Own::SAMPLE.build().unwrap(), BuiltIn::SAMPLE.build().unwrap());
    let one = own.frequency_response(Own::conn_c.force_x(), Own::Cable_brace.input().axial_force()).unwrap();
    let other = built_in.frequency_response(BuiltIn::conn_c.force_x(), BuiltIn::string_brace.input().axial_force());
    let other = other.unwrap();
    for omega in [0.0, 0.5, 7.0, 55.0, 410.0] {
        let (one, other) = (one.at(omega).unwrap(), other.at(omega).unwrap());
        assert!((one / other - 1.0).abs() < 1e-10, "{omega}: {one} {other}");
    }
}

#[test]
fn its_sensitivities_are_those_of_the_built_in_one() {
    let (own, built_in) = (Own::SAMPLE.build().unwrap(), BuiltIn::SAMPLE.build().unwrap());
    let roots = (own.first_frequencies::<12>().unwrap(), built_in.first_frequencies::<12>().unwrap());
    for (one, other) in roots.0.iter().zip(&roots.1) {
        let size = one.omega;
        let (one, other) = (own.sensitivity(one).unwrap(), built_in.sensitivity(other).unwrap());
        for (field, slope) in other.iter() {
            assert!((one.get(field).unwrap() - slope).abs() < 1e-10 * size, "{field}: {one:?}");
        }
    }
}

#[test]
fn its_overall_matrix_has_the_size_of_the_built_in_one() {
    const { assert!(OwnSystem::<f64>::N == BuiltInSystem::<f64>::N) };
    let (own, built_in) = (Own::SAMPLE.build().unwrap(), BuiltIn::SAMPLE.build().unwrap());
    for omega in [1.0, 20.0] {
        let (one, other) = (own.overall_matrix(omega), built_in.overall_matrix(omega));
        assert!((one - other).amax() < 1e-11 * other.amax());
    }
}

/// What a load along it works it does not say.
#[test]
fn its_weight_is_refused() {
    let own = Own::SAMPLE.build().unwrap();
    let response = own.frequency_response(PlaneLoad::self_weight_y(), Own::conn_b.displacement_y());
    assert_eq!(response.and_then(|response| response.at(0.0)), Err(MotionError::NoUniformLoad));
}

/// Drawings know it by the name of its type, from place to place.
#[test]
fn it_is_in_the_sketch() {
    let own = Own::SAMPLE.build().unwrap();
    let sketch = own.sketch();
    let member = sketch.members().find(|member| member.kind == "Cable").unwrap();
    assert_eq!(member.name.to_string(), "Cable brace");
    assert_eq!(member.ends.map(|end| end.position), [Some([0.0, 3.0, 0.0]), Some([4.0, 0.0, 0.0])]);
}

system! {
    /// A string from a wall to a mass that slides along it.
    struct Slider { length: f64, tension: f64, mass_per_length: f64, mass: f64 }
    fixed at (0.0, 0.0) -> cable::Cable 1 { length, tension, mass_per_length } -> conn m at (0.3, 0.4);
    conn m -> point_mass 2 { mass };
    conn m <- roller along (3.0, 4.0);
}

/// `H k cos kl = M ω² sin kl` with `k = ω sqrt(m/H)`, whatever the distance of the points.
#[test]
fn a_string_and_a_mass_obey_the_frequency_equation() {
    let Slider { length, tension, mass_per_length, mass } =
        Slider { length: 2.0, tension: 50.0, mass_per_length: 0.02, mass: 0.05 };
    let system = Slider { length, tension, mass_per_length, mass }.build().unwrap();
    let found = system.first_frequencies::<30>().unwrap();
    let equation = |omega: f64| {
        let k = omega * (mass_per_length / tension).sqrt();
        tension * k * (k * length).cos() - mass * omega * omega * (k * length).sin()
    };
    for (n, root) in (0..).zip(&found) {
        // one root in each half wave
        let first = PI / length * (tension / mass_per_length).sqrt();
        assert!(f64::from(n) * first < root.omega && root.omega < f64::from(n + 1) * first);
        let room = 1e-13 * root.omega;
        assert!(equation(root.lower - room) * equation(root.upper + room) < 0.0, "{root:?}");
    }
}

/// A path without places in between: two strings, a mass between them, each string one's own or of the language, along a direction.
macro_rules! hangers {
    ($($name:ident { $($first:tt)+ } { $($second:tt)+ })*) => {$(
        system! {
            struct $name { mass: f64 }
            fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn a at (2.0, 1.0);
            conn a <- along (1.0, -2.0) <- $($first)+ 2 { length: 1.5, tension: 70.0, mass_per_length: 0.3 } <- mass 3 { mass }
                <- $($second)+ 4 { length: 0.7, tension: 70.0, mass_per_length: 0.3 } <- conn e <- fixed;
        }
    )*};
}

hangers! {
    OwnHanger { cable::Cable } { cable::Cable }
    MixedHanger { string } { cable::Cable }
    BuiltInHanger { string } { string }
}

#[test]
fn a_path_of_strings_and_masses_acts_along_its_direction() {
    let found = BuiltInHanger { mass: 1.5 }.build().unwrap().first_frequencies::<25>().unwrap();
    let own = OwnHanger { mass: 1.5 }.build().unwrap().first_frequencies::<25>().unwrap();
    let mixed = MixedHanger { mass: 1.5 }.build().unwrap().first_frequencies::<25>().unwrap();
    assert!(
        found.iter().zip(own.iter().zip(&mixed)).all(|(root, (one, other))| agree(root, one) && agree(root, other))
    );
}

/// A coil over a pin: between two points at one place, and from a point to the ground; no direction is said.
macro_rules! joints {
    ($($name:ident { $($coil:tt)+ })*) => {$(
        system! {
            struct $name { stiffness: f64 }
            fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn a at (1.0, 1.0)
                -> pin 2 {} -> conn b -> beam 3 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn c at (3.0, 1.0);
            conn c <- pinned;
            conn a -> $($coil)+ 4 { stiffness } -> conn b;
            conn c -> $($coil)+ 5 { stiffness: 2.0 * stiffness } -> fixed;
            conn a -> $($coil)+ 6 { stiffness: 0.5 * stiffness } -> conn c;
        }
    )*};
}

joints! {
    OwnJoint { self::Coil }
    BuiltInJoint { torsion_spring }
}

#[test]
fn an_element_of_ones_own_turns() {
    let (own, built_in) =
        (OwnJoint { stiffness: 8.0 }.build().unwrap(), BuiltInJoint { stiffness: 8.0 }.build().unwrap());
    let found = (own.first_frequencies::<25>().unwrap(), built_in.first_frequencies::<25>().unwrap());
    assert!(found.0.iter().zip(&found.1).all(|(one, other)| agree(one, other)));
}

/// Across a line of one coordinate.
macro_rules! lines {
    ($($name:ident { $($string:tt)+ } { $($damper:tt)+ })*) => {$(
        system! {
            struct $name { damping: f64 }
            pinned at 0.0 -> beam 1 { bending_stiffness: EI, mass_per_length: M } -> conn a at 1.5
                -> beam 2 { bending_stiffness: EI, mass_per_length: M } -> pinned at 4.0;
            conn a <- $($string)+ 3 { length: 1.0, tension: 300.0, mass_per_length: 0.5 } <- fixed;
            conn a <- $($damper)+ 4 { damping } <- fixed;
        }
    )*};
}

lines! {
    OwnLine { cable::Cable } { self::Dashpot }
    BuiltInLine { string } { damper }
}

#[test]
fn an_element_of_ones_own_damps_across_a_line() {
    let (own, built_in) = (OwnLine { damping: 4.0 }.build().unwrap(), BuiltInLine { damping: 4.0 }.build().unwrap());
    let region = Region { re: -60.0..=1.0, im: -1.0..=200.0 };
    let (own, built_in) = (own.eigenvalues::<40>(region.clone()).unwrap(), built_in.eigenvalues::<40>(region).unwrap());
    assert!(own.len() == built_in.len() && own.len() > 10);
    for (one, other) in own.iter().zip(&built_in) {
        assert!((one.lambda - other.lambda).norm() <= one.error + other.error, "{one:?} {other:?}");
    }
}
