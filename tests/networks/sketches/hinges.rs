//! Hinges between places: zero lets go, and a derivative tells what the first stiffness does.

use super::{assert_near, eigenvalues, frequencies};
use mstmm::frame::{Frame, Hinge, Member, OfJoint, Plane, Section};
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

/// The portal at run time with its two hinges, and the member that the first hinge is.
fn framed([first, second]: [Hinge; 2]) -> (Frame<Plane>, Member<OfJoint>) {
    let steel = Section::new().axial_stiffness(900.0).bending_stiffness(2.0).mass_per_length(1.5);
    let mut frame = Frame::new();
    let places = [[0.0, 0.0], [0.0, 1.0], [0.0, 1.0], [1.3, 1.1], [1.3, 1.1], [1.3, 0.0]];
    let [foot, left, from, to, right, far] = places.map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.hold(far, Support::Fixed);
    frame.member(foot, left, steel);
    let hinge = frame.member(left, from, first);
    frame.member(from, to, steel);
    frame.member(to, right, second);
    frame.member(right, far, steel);
    (frame, hinge)
}

#[test]
fn a_hinge_of_a_frame_lets_go_at_zero() {
    let (frame, _) = framed([Hinge::new().stiffness_rz(0.0); 2]);
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

system! {
    /// A portal whose girder is on hinges with dashpots and losses.
    struct Damped { k: f64, d: f64, c: f64 }
    section steel { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn left at (0.0, 1.0)
        -> hinge 2 { stiffness_rz: k, damping_rz: d, kelvin_voigt_time: c } -> beam 3 { ..steel }
        -> hinge 4 { damping_rz: 2.0 * d, stiffness_x: 40.0 * k } -> conn right at (1.3, 1.1) -> beam 5 { ..steel }
        -> fixed at (1.3, 0.0);
}

system! {
    /// The same with points on both sides, and springs between them.
    struct Sprung { k: f64, d: f64, c: f64 }
    section steel { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn left at (0.0, 1.0) -> pin 2 {} -> conn from -> beam 3 { ..steel }
        -> conn to -> slider 4 { along: (1.0, 0.0) } -> conn between -> pin 5 {} -> conn right at (1.3, 1.1)
        -> beam 6 { ..steel } -> fixed at (1.3, 0.0);
    conn left -> torsion_spring 7 { stiffness: k, damping: d, kelvin_voigt_time: c } -> conn from;
    conn between -> torsion_damper 8 { damping: 2.0 * d } -> conn right;
    conn to <- along (1.0, 0.0) <- spring 9 { stiffness: 40.0 * k } <- along (1.0, 0.0) <- conn between;
}

const DAMPED: Damped = Damped { k: 3.0, d: 0.2, c: 0.01 };

/// Oracle: pins and sliders, beside springs and dashpots of their own.
#[test]
fn damped_hinges_are_springs_and_dashpots_beside_pins() {
    let Damped { k, d, c } = DAMPED;
    let (hinged, sprung) = (DAMPED.build().unwrap(), Sprung { k, d, c }.build().unwrap());
    let [one, other] = [eigenvalues(&hinged), eigenvalues(&sprung)];
    assert!(one.len() > 4 && one.len() == other.len());
    for (one, other) in one.iter().zip(&other) {
        assert!((one - other).norm() < 1e-12 * other.norm(), "{one} {other}");
    }
    let lambda = Complex::new(-0.2, 3.1);
    let sway = |load, entry| hinged.frequency_response(load, entry).unwrap().at(lambda).unwrap();
    let expected = sprung.frequency_response(Sprung::conn_left.force_x(), Sprung::conn_right.displacement_x()).unwrap();
    let expected = expected.at(lambda).unwrap();
    let found = sway(Damped::conn_left.force_x(), Damped::conn_right.displacement_x());
    assert!((found - expected).norm() < 1e-12 * expected.norm(), "{found} {expected}");
}

#[test]
fn sensitivities_of_damped_hinges_are_differences() {
    let root = |model: Damped| model.build().unwrap().first_eigenvalues::<4>().unwrap()[2];
    let system = DAMPED.build().unwrap();
    let derivatives = system.sensitivity(&root(DAMPED)).unwrap();
    type Field = fn(&mut Damped) -> &mut f64;
    let fields: [(&str, Field); 3] =
        [("k", |model| &mut model.k), ("d", |model| &mut model.d), ("c", |model| &mut model.c)];
    for ((name, field), (of, derivative)) in fields.into_iter().zip(derivatives.iter()) {
        assert_eq!(name, of);
        let moved = |part: f64| {
            let mut model = DAMPED;
            *field(&mut model) *= 1.0 + part;
            root(model).lambda
        };
        let mut model = DAMPED;
        let difference = (moved(1e-6) - moved(-1e-6)) / (2e-6 * *field(&mut model));
        assert!(
            (derivative - difference).norm() < 1e-6 * (1.0 + difference.norm()),
            "{name}: {derivative} {difference}"
        );
    }
}

system! {
    /// Two beams of a path with a hinge between them that gives way in both freedoms.
    struct Path { ky: f64, kr: f64, d: f64, eta: f64 }
    fixed -> beam 1 { length: 1.2, bending_stiffness: 2.0, mass_per_length: 1.5 }
        -> hinge 2 { stiffness_y: ky, stiffness_rz: kr, damping_rz: d, loss_factor: eta }
        -> beam 3 { length: 0.7, bending_stiffness: 2.0, mass_per_length: 1.5 } -> pinned
}

system! {
    /// The same between places.
    struct Placed { ky: f64, kr: f64, d: f64, eta: f64 }
    fixed at 0.0 -> beam 1 { bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at 1.2
        -> hinge 2 { stiffness_y: ky, stiffness_rz: kr, damping_rz: d, loss_factor: eta } -> conn b
        -> beam 3 { bending_stiffness: 2.0, mass_per_length: 1.5 } -> pinned at 1.9;
}

system! {
    /// The same in the plane without places.
    struct Planar { ky: f64, kr: f64, d: f64, eta: f64 }
    section steel { length: 1.2, axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
    fixed -> beam 1 { ..steel } -> hinge 2 { stiffness_y: ky, stiffness_rz: kr, damping_rz: d, loss_factor: eta }
        -> beam 3 { ..steel, length: 0.7 } -> roller
}

/// Oracle: the elimination of frames beside minors and back transfer of paths, and the overall matrix of a planar path.
#[test]
fn damped_hinges_of_paths_are_those_between_places() {
    let (ky, kr, d, eta) = (40.0, 3.0, 0.2, 0.05);
    let (path, placed) = (Path { ky, kr, d, eta }.build().unwrap(), Placed { ky, kr, d, eta }.build().unwrap());
    let (one, other) = (path.first_eigenvalues::<5>().unwrap(), placed.first_eigenvalues::<5>().unwrap());
    let planar = Planar { ky, kr, d, eta }.build().unwrap();
    for (mode, (one, other)) in one.iter().zip(other.iter()).enumerate() {
        assert!((one.lambda - other.lambda).norm() < 1e-12 * other.lambda.norm(), "{one:?} {other:?}");
        let at = |lambda: Complex<f64>| planar.overall_determinant(lambda);
        let beside = at(one.lambda * 1.001).value();
        // the overall matrix loses the digits by which waves grow
        let rounding = 1e-12 * 100.0_f64.powi(mode as i32);
        assert!(at(one.lambda).value().norm() < rounding * beside.norm(), "{one:?}");
    }
    let root = &one[1];
    let (shape, located) = (path.mode_shape(root).unwrap(), placed.mode_shape(&other[1]).unwrap());
    let moment = shape.state(Path::hinge_2.output()).m;
    let end = located.along(Placed::beam_3, 0.0).unwrap().moment;
    assert!((moment.norm() - end.norm()).abs() < 1e-11 * end.norm(), "{moment} {end}");
    let derivatives = (path.sensitivity(root).unwrap(), placed.sensitivity(&other[1]).unwrap());
    for ((name, one), (_, other)) in derivatives.0.iter().zip(derivatives.1.iter()) {
        assert!((one - other).norm() < 1e-10 * (1.0 + other.norm()), "{name}: {one} {other}");
    }
}

/// A damped hinge of a frame at run time.
#[test]
fn damped_hinges_of_frames_are_those_of_sketches() {
    let Damped { k, d, c } = DAMPED;
    let first = Hinge::new().stiffness_rz(k).damping_rz(d).kelvin_voigt_time(c);
    let (mut frame, hinge) = framed([first, Hinge::new().damping_rz(2.0 * d).stiffness_x(40.0 * k)]);
    assert!(frame.build().is_err());
    let built = frame.build_damped().unwrap();
    let [one, other] = [eigenvalues(&DAMPED.build().unwrap()), eigenvalues(&built)];
    for (one, other) in one.iter().zip(&other) {
        assert!((one - other).norm() < 1e-12 * other.norm(), "{one} {other}");
    }
    let root = built.first_eigenvalues::<3>().unwrap()[2];
    let derivatives = built.sensitivity(&root).unwrap();
    assert!(derivatives.of(hinge, "damping_rz").unwrap().norm() > 0.0);
    frame.replace(hinge, Hinge::new().loss_factor(0.1));
    assert!(frame.build_damped().unwrap_err().to_string().contains("would be rigid"));
}
