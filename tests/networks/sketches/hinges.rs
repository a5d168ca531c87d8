//! Hinges between places: zero lets go, and a derivative tells what the first stiffness does.

use super::{assert_near, frequencies};
use mstmm::frame::{Frame, Hinge, Section};
use mstmm::network::Support;
use mstmm::prelude::*;

system! {
    /// A portal whose girder is on hinges.
    struct Portal { k: f64 }
    section steel { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn left at (0.0, 1.0) -> hinge 2 { stiffness_rz: k } -> beam 3 { ..steel }
        -> hinge 4 { stiffness_rz: k } -> conn right at (1.3, 1.1) -> beam 5 { ..steel } -> fixed at (1.3, 0.0);
}

system! {
    /// The same with pins.
    struct Pinned {}
    section steel { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn left at (0.0, 1.0) -> pin 2 {} -> beam 3 { ..steel }
        -> pin 4 {} -> conn right at (1.3, 1.1) -> beam 5 { ..steel } -> fixed at (1.3, 0.0);
}

#[test]
fn a_hinge_without_stiffness_is_a_pin() {
    let (hinged, pinned) = (Portal { k: 0.0 }.build().unwrap(), Pinned {}.build().unwrap());
    assert_near(&frequencies(&pinned), &frequencies(&hinged), 1e-15);
    let root = hinged.frequencies(3).unwrap()[2];
    let (shape, other) = (hinged.mode_shape(&root).unwrap(), pinned.mode_shape(&root).unwrap());
    let [one, two] = [shape.along(Portal::beam_3, 0.4), other.along(Pinned::beam_3, 0.4)].map(Result::unwrap);
    assert!((one.moment.abs() - two.moment.abs()).abs() < 1e-12 * (1.0 + two.moment.abs()), "{one:?} {two:?}");
    let shares = shape.energy_shares(Portal::hinge_2).unwrap();
    assert!(shares.strain == 0.0, "{shares:?}");
}

/// Oracle: a one-sided difference of the second order, at the stiffness at which both hinges let go.
#[test]
fn the_first_stiffness_has_a_derivative() {
    let root = |k: f64| Portal { k }.build().unwrap().frequencies(2).unwrap()[1];
    let system = Portal { k: 0.0 }.build().unwrap();
    let derivative = system.sensitivity(&root(0.0)).unwrap().iter().next().unwrap().1;
    let step = 1e-4;
    let difference = (4.0 * root(step).omega - root(2.0 * step).omega - 3.0 * root(0.0).omega) / (2.0 * step);
    assert!((derivative - difference).abs() < 1e-6 * derivative, "{derivative} {difference}");
}

#[test]
fn a_hinge_of_a_frame_lets_go_at_zero() {
    let steel = Section::new().axial_stiffness(900.0).bending_stiffness(2.0).mass_per_length(1.5);
    let mut frame = Frame::new();
    let places = [[0.0, 0.0], [0.0, 1.0], [0.0, 1.0], [1.3, 1.1], [1.3, 1.1], [1.3, 0.0]];
    let [foot, left, from, to, right, far] = places.map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.hold(far, Support::Fixed);
    frame.member(foot, left, steel);
    frame.member(left, from, Hinge::new().stiffness_rz(0.0));
    frame.member(from, to, steel);
    frame.member(to, right, Hinge::new().stiffness_rz(0.0));
    frame.member(right, far, steel);
    assert_near(&frequencies(&Pinned {}.build().unwrap()), &frequencies(&frame.build().unwrap()), 1e-15);
}

#[test]
fn a_stiffness_without_a_reciprocal_is_told_with_few_digits() {
    let error = Portal { k: 1e-320 }.build().unwrap_err().to_string();
    assert_eq!(
        error,
        "hinge 2: stiffness_rz is 1e-320, but must be zero, or positive and finite, with a finite reciprocal"
    );
}
