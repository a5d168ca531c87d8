//! `#[undamped(Name)]`: one sketch for the damped and the undamped model.

use mstmm::prelude::*;

system! {
    /// A beam with losses, a machine on a spring with a dashpot, a dashpot alone.
    #[derive(Clone, Copy)]
    #[undamped(QuietStand)]
    struct Stand { ei: f64, eta: f64, c: f64, k: f64 }
    let soft = 0.5 * c;
    section steel { mass_per_length: 3.0, loss_factor: eta }
    fixed -> beam 1 { length: 1.2, bending_stiffness: ei, ..steel } -> conn top -> hinge 2 { stiffness_rz: 40.0 } -> beam 3 { length: 0.8, bending_stiffness: ei, ..steel } -> free;
    conn top <- spring 4 { stiffness: k, damping: soft } <- mass 5 { mass: 2.0 } <- free;
}

system! {
    /// The same as somebody would write it a second time.
    #[derive(Clone, Copy)]
    struct ByHand { ei: f64, k: f64 }
    section steel { mass_per_length: 3.0 }
    fixed -> beam 1 { length: 1.2, bending_stiffness: ei, ..steel } -> conn top -> hinge 2 { stiffness_rz: 40.0 } -> beam 3 { length: 0.8, bending_stiffness: ei, ..steel } -> free;
    conn top <- spring 4 { stiffness: k } <- mass 5 { mass: 2.0 } <- free;
}

system! {
    #[undamped(QuietFrame)]
    struct Frame { c: f64, time: f64, turn: f64 }
    section steel { axial_stiffness: 9e3, bending_stiffness: 20.0, mass_per_length: 0.5, kelvin_voigt_time: time }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.0, 1.0);
    conn a -> hinge 2 { damping_rz: turn } -> conn a2 -> beam 3 { ..steel } -> conn b at (1.5, 1.2);
    conn b -> beam 4 { ..steel, external_damping: 0.3 } -> pinned at (1.5, 0.0);
    conn b -> damper 5 { damping: c } -> fixed at (3.0, 0.0);
}

system! {
    struct FrameByHand {}
    section steel { axial_stiffness: 9e3, bending_stiffness: 20.0, mass_per_length: 0.5 }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.0, 1.0);
    conn a -> hinge 2 { stiffness_rz: 0.0 } -> conn a2 -> beam 3 { ..steel } -> conn b at (1.5, 1.2);
    conn b -> beam 4 { ..steel } -> pinned at (1.5, 0.0);
}

#[test]
fn the_undamped_model_is_that_without_what_damps() {
    let stand = Stand { ei: 200.0, eta: 0.04, c: 3.0, k: 400.0 };
    let (quiet, by_hand) = (stand.undamped().build().unwrap(), ByHand { ei: 200.0, k: 400.0 }.build().unwrap());
    let (roots, others) = (quiet.first_frequencies::<4>().unwrap(), by_hand.first_frequencies::<4>().unwrap());
    for (root, other) in roots.iter().zip(others.iter()) {
        assert_eq!((root.omega, root.lower, root.upper), (other.omega, other.lower, other.upper));
        let (slopes, hand) = (quiet.sensitivity(root).unwrap(), by_hand.sensitivity(other).unwrap());
        assert_eq!([slopes.get("ei"), slopes.get("k")], [hand.get("ei"), hand.get("k")]);
        assert_eq!([slopes.get("eta"), slopes.get("c")], [Some(0.0), Some(0.0)]);
    }
    let (load, entry) = (QuietStand::mass_5.output().force(), QuietStand::conn_top.deflection());
    let response = quiet.modal_response::<4, _>(&roots, load, entry).unwrap().with_damping_ratio(0.02).unwrap();
    assert!(response.at_hertz(roots[0].hertz()).unwrap().norm() > 0.0);
    // and the damped model is as it was
    let damped = stand.build().unwrap().first_eigenvalues::<2>().unwrap();
    assert!(damped.iter().all(|root| root.lambda.re < 0.0));
}

#[test]
fn dampers_of_frames_become_springs_without_stiffness() {
    let quiet = Frame { c: 2.0, time: 1e-3, turn: 0.4 }.undamped().build().unwrap();
    let by_hand = FrameByHand {}.build().unwrap();
    for (root, other) in quiet.frequencies(6).unwrap().iter().zip(by_hand.frequencies(6).unwrap()) {
        assert!(root.is_proven && (root.omega / other.omega - 1.0).abs() < 1e-15, "{root} {other}");
    }
}
