//! Numbers that no sketch can be built from: errors that name what has them.

use mstmm::prelude::*;

system! {
    /// A frame with one of everything that has numbers.
    #[derive(Clone, Copy)]
    struct Frame { x: f64, dx: f64, ea: f64, mass: f64, centre: f64, k: f64, gap: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at (x, 1.0)
        -> pin 2 {} -> beam 3 { axial_stiffness: ea, bending_stiffness: 2.0, mass_per_length: 1.5 }
        -> roller at (2.0, 0.0) along (dx, 0.0);
    conn a <- rigid_body 4 { mass, inertia: 0.1, centre: (centre, 1.0) };
    conn a -> spring 5 { stiffness: k } -> conn g at (1.0, 1.0 + gap) <- fixed;
    conn a <- along (dx, 1.0 - dx) <- spring 6 { stiffness: 1.0 } <- mass 7 { mass: 1.0 } <- free;
}

const RIGHT: Frame = Frame { x: 1.0, dx: 1.0, ea: 900.0, mass: 2.0, centre: 1.5, k: 3.0, gap: 1.0 };

#[track_caller]
fn assert_refused(frame: Frame, message: &str) {
    assert_eq!(frame.build().unwrap_err().to_string(), message);
}

#[test]
fn errors_name_the_element_or_the_point_and_the_number() {
    assert!(RIGHT.build().is_ok());
    let nan = f64::NAN;
    assert_refused(Frame { x: nan, ..RIGHT }, "conn a: x is NaN, but must be a finite number");
    assert_refused(Frame { gap: f64::INFINITY, ..RIGHT }, "conn g: y is inf, but must be a finite number");
    assert_refused(
        Frame { dx: 0.0, ..RIGHT },
        "roller at beam 3: along is 0, but must be a direction, whose largest part is between 1e-70 and 1e70",
    );
    assert_refused(Frame { mass: -2.0, ..RIGHT }, "rigid_body 4: mass is -2, but must be zero or positive, and finite");
    assert_refused(Frame { centre: nan, ..RIGHT }, "rigid_body 4: centre is NaN, but must be a finite number");
    assert_refused(Frame { ea: 0.0, ..RIGHT }, "beam 1: axial_stiffness is 0, but must be positive and finite");
    assert_refused(
        Frame { k: -1.0, ..RIGHT },
        "spring 5: stiffness is -1, but must be zero, or positive and finite, with a finite reciprocal",
    );
}

#[test]
fn two_points_at_one_place_are_named() {
    assert_refused(
        Frame { gap: 0.0, ..RIGHT },
        "spring 5: length is 0, but must be positive and finite: conn a and conn g are at one place",
    );
    system! {
        struct Cantilever { length: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 9.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
            -> free at (length, 0.0);
    }
    assert_eq!(
        Cantilever { length: 0.0 }.build().unwrap_err().to_string(),
        "beam 1: length is 0, but must be positive and finite: fixed at beam 1 and free at beam 1 are at one place"
    );
    let error = Cantilever { length: f64::NAN }.build().unwrap_err();
    assert_eq!((error.element, error.parameter), ("free at beam 1", "x"));
}

system! {
    /// A cable is a spring along itself: across it nothing holds its knot.
    struct Loose { k: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 5.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn tip at (1.0, 0.0);
    conn tip -> spring 2 { stiffness: k } -> conn knot at (1.0, 1.0);
    conn knot -> spring 3 { stiffness: k } -> fixed at (1.0, 2.0);
}

#[test]
fn a_mechanism_without_mass_is_named() {
    let error = Loose { k: 3.0 }.build().unwrap().first_frequencies::<2>().unwrap_err();
    assert!(error.to_string().ends_with("or a massless part by nothing, as shows at conn knot"), "{error}");
}
