//! Bodies by their inertia about the mass centre, and about the input end.

use mstmm::prelude::*;

/// A beam with a body at its end, and what it says of the inertia of the body.
macro_rules! tip_body {
    ($fields:tt $($model:ident { $($path:tt)* })*) => {$(
        system! {
            #[derive(Clone, Copy)]
            struct $model $fields
            $($path)*
        }
    )*};
}

tip_body! {
    { l: f64, ei: f64, m: f64, mass: f64, j: f64, centre: f64, depth: f64, force: f64 }
    AboutCentre {
        fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m, axial_force: force }
              -> body 2 { mass, inertia: j, output_x: depth, centre_x: centre, axial_force: force } -> free;
    }
    AboutInput {
        let about_input = j + mass * centre * centre;
        fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m, axial_force: force }
              -> body 2 { mass, inertia_about_input: about_input, output_x: depth, centre_x: centre, axial_force: force } -> free;
    }
}

tip_body! {
    { mass: f64, j: f64, c1: f64, c2: f64, k: f64 }
    Plane {
        fixed -> hinge 1 { stiffness_x: k, stiffness_rz: 2.0 * k }
              -> body 2 { mass, inertia: j, output_x: 0.5, output_y: 0.3, centre_x: c1, centre_y: c2 } -> free;
    }
    PlaneAboutInput {
        let inertia_about_input = j + mass * c1 * c1 + mass * c2 * c2;
        fixed -> hinge 1 { stiffness_x: k, stiffness_rz: 2.0 * k }
              -> body 2 { mass, inertia_about_input, output_x: 0.5, output_y: 0.3, centre_x: c1, centre_y: c2 } -> free;
    }
}

/// Both are one body, and the derivatives with respect to its mass and its centre follow Steiner's theorem.
#[test]
fn both_inertias_say_the_same() {
    let [l, ei, m, mass, j, centre, depth, force] = [0.9, 2.0, 0.4, 0.6, 0.05, 0.3, 0.7, 0.2];
    let about_centre = AboutCentre { l, ei, m, mass, j, centre, depth, force }.build().unwrap();
    let about_input = AboutInput { l, ei, m, mass, j, centre, depth, force }.build().unwrap();
    let [first, second] =
        [about_centre.first_frequencies::<4>().unwrap(), about_input.first_frequencies::<4>().unwrap()];
    for (one, other) in first.iter().zip(&second) {
        assert!(one.is_proven && other.is_proven, "{one} and {other}");
        assert!((one.omega / other.omega - 1.0).abs() < 1e-14, "{one} and {other}");
        let (of_centre, of_input) = (about_centre.sensitivity(one).unwrap(), about_input.sensitivity(other).unwrap());
        for field in ["mass", "j", "centre", "depth", "force", "m"] {
            let [one, other] = [of_centre.get(field).unwrap(), of_input.get(field).unwrap()];
            assert!((one - other).abs() <= 1e-10 * one.abs().max(1.0), "{field}: {one} and {other}");
        }
    }
}

/// Closed form: a rigid body that a pin holds at its input end and a torsion spring turns back, `ω² = K/(J_C + m c²)`.
#[test]
fn a_pendulum_has_the_frequency_of_its_inertia_about_the_pin() {
    system! {
        struct Pendulum { k: f64, mass: f64, j: f64, centre: f64 }
        fixed -> hinge 1 { stiffness_rz: k } -> body 2 { mass, inertia: j, output_x: 0.0, centre_x: centre } -> free;
    }
    let root =
        Pendulum { k: 3.0, mass: 0.5, j: 0.02, centre: -0.8 }.build().unwrap().first_frequencies::<1>().unwrap()[0];
    let expected = (3.0_f64 / (0.02 + 0.5 * 0.64)).sqrt();
    assert!(root.is_proven && (root.omega / expected - 1.0).abs() < 1e-14, "{root} is not {expected}");
    // a body without inertia is a mass on an arm
    let root =
        Pendulum { k: 3.0, mass: 0.5, j: 0.0, centre: -0.8 }.build().unwrap().first_frequencies::<1>().unwrap()[0];
    assert!((root.omega / (3.0_f64 / 0.32).sqrt() - 1.0).abs() < 1e-14, "{root}");
}

#[test]
fn bodies_of_the_plane_have_both_inertias_too() {
    let [mass, j, c1, c2, k] = [0.6, 0.05, 0.3, -0.2, 4.0];
    let [one, other] = [2.0, 5.0].map(|omega| {
        let plane = Plane { mass, j, c1, c2, k }.build().unwrap().overall_determinant(omega).value();
        let about_input = PlaneAboutInput { mass, j, c1, c2, k }.build().unwrap().overall_determinant(omega).value();
        assert!((plane / about_input - 1.0).abs() < 1e-13, "{plane} and {about_input}");
        plane
    });
    assert_ne!(one, other);
    let error = Plane { mass, j: -1.0, c1, c2, k }.build().unwrap_err();
    assert_eq!((error.element, error.parameter, error.value), ("body 2", "inertia", -1.0));
    let error = PlaneAboutInput { mass, j: -1.0, c1, c2, k }.build().unwrap_err();
    assert_eq!((error.element, error.parameter), ("body 2", "inertia_about_input"));
}
