//! Bars: beams with pins at both ends.

use super::{assert_near, eigenvalues, frequencies};
use mstmm::frame::{Bar, Frame, Section};
use mstmm::network::Support;
use mstmm::prelude::*;

system! {
    /// A truss of three bars with a loop and a slender brace, whose lower bar is a beam with pins behind it.
    struct Truss { l: f64, ea: f64, ei: f64, m: f64, load: f64 }
    section steel { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
    pinned -> conn left at (0.0, 0.0) -> bar 1 { ..steel } -> conn top at (l, 1.5 * l) -> bar 2 { ..steel, axial_force: load }
        -> conn foot at (2.0 * l, 0.2 * l);
    conn left -> bar 3 { ..steel } -> conn foot;
    roller -> conn foot;
    conn top -> point_mass 4 { mass: 2.0 * m * l };
}

system! {
    /// The same with beams and pins.
    struct Pinned { l: f64, ea: f64, ei: f64, m: f64, load: f64 }
    section steel { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
    pinned -> conn left at (0.0, 0.0) -> pin 5 {} -> beam 1 { ..steel } -> pin 6 {} -> conn top at (l, 1.5 * l) -> pin 7 {}
        -> beam 2 { ..steel, axial_force: load } -> pin 8 {} -> conn foot at (2.0 * l, 0.2 * l);
    conn left -> pin 9 {} -> beam 3 { ..steel } -> pin 10 {} -> conn foot;
    roller -> conn foot;
    conn top -> point_mass 4 { mass: 2.0 * m * l };
}

const TRUSS: Truss = Truss { l: 1.3, ea: 900.0, ei: 2.0, m: 1.5, load: -3.0 };

fn pinned() -> Pinned {
    let Truss { l, ea, ei, m, load } = TRUSS;
    Pinned { l, ea, ei, m, load }
}

#[test]
fn bars_are_beams_between_pins() {
    let (bars, beams) = (TRUSS.build().unwrap(), pinned().build().unwrap());
    assert_near(&frequencies(&beams), &frequencies(&bars), 1e-14);
    // a pin turns nothing, and is one motion less of its point: 4 of the truss beside those of 6 pins
    let root = bars.frequencies(3).unwrap()[2];
    let shapes = (bars.mode_shape(&root).unwrap(), beams.mode_shape(&root).unwrap());
    for part in [0.0, 0.3, 1.0] {
        let at = part * (TRUSS.l * f64::hypot(1.0, 1.5));
        let (bar, beam) = (shapes.0.along(Truss::bar_1, at).unwrap(), shapes.1.along(Pinned::beam_1, at).unwrap());
        let sign = if bar.displacement_x * beam.displacement_x < 0.0 { -1.0 } else { 1.0 };
        for (one, other) in [
            (bar.displacement_x, beam.displacement_x),
            (bar.displacement_y, beam.displacement_y),
            (bar.rotation_z, beam.rotation_z),
            (bar.axial_force, beam.axial_force),
        ] {
            assert!((one - sign * other).abs() < 1e-12 * (1.0 + other.abs()), "{one} {other} at {part}");
        }
        assert!(part > 0.0 && part < 1.0 || bar.moment.abs() < 1e-12, "{bar:?}");
    }
    let derivatives = (bars.sensitivity(&root).unwrap(), beams.sensitivity(&root).unwrap());
    for ((name, one), (_, other)) in derivatives.0.iter().zip(derivatives.1.iter()) {
        assert!((one - other).abs() < 1e-11 * (1.0 + other.abs()), "{name}: {one} {other}");
    }
}

/// A determinant beside that of pins: the sign of both changes at the same frequencies.
#[test]
fn the_overall_matrix_of_bars_is_singular_at_their_frequencies() {
    let bars = TRUSS.build().unwrap();
    for root in bars.frequencies(4).unwrap().iter() {
        let [below, above] = [1.0 - 1e-7, 1.0 + 1e-7].map(|part| bars.overall_determinant(root.omega * part).value());
        assert!(below * above < 0.0, "{below} {above} about {}", root.omega);
    }
}

system! {
    /// A bar between two points at rest.
    struct Held { ea: f64, ei: f64, m: f64 }
    pinned at (0.0, 0.0) -> bar 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pinned at (3.0, 4.0);
}

/// Closed form: `(nπ/l)² √(EI/m)` across, `nπ/l √(EA/m)` along.
#[test]
fn a_bar_between_points_at_rest_has_sines() {
    use core::f64::consts::PI;
    let (ea, ei, m) = (7.0, 2.0, 1.5);
    let found = frequencies(&Held { ea, ei, m }.build().unwrap());
    let across = (1..20).map(|n| (f64::from(n) * PI / 5.0).powi(2) * (ei / m).sqrt());
    let mut expected: Vec<f64> = across.chain((1..20).map(|n| f64::from(n) * PI / 5.0 * (ea / m).sqrt())).collect();
    expected.sort_by(f64::total_cmp);
    assert_near(&expected[..found.len()], &found, 1e-15);
}

system! {
    /// Two bars with losses of their own.
    struct Lossy { ea: f64, eta: f64 }
    pinned at (0.0, 0.0) -> bar 1 { axial_stiffness: ea, bending_stiffness: 2.0, mass_per_length: 1.5, loss_factor: eta }
        -> conn top at (1.0, 1.5) -> bar 2 { axial_stiffness: ea, bending_stiffness: 2.0, mass_per_length: 1.5, loss_factor: eta }
        -> pinned at (2.0, 0.0);
}

/// Closed form: with one loss factor everywhere λ is `iω √(1 + iη)`.
#[test]
fn bars_have_damping() {
    let undamped = frequencies(&Lossless { ea: 900.0 }.build().unwrap());
    let damped = Lossy { ea: 900.0, eta: 0.02 }.build().unwrap();
    let factor = Complex::new(1.0, 0.02).sqrt() * Complex::<f64>::i();
    for (omega, lambda) in undamped.iter().zip(eigenvalues(&damped)) {
        assert!((factor * omega - lambda).norm() < 1e-13 * omega, "{omega} {lambda}");
    }
}

system! {
    /// The same without losses.
    struct Lossless { ea: f64 }
    pinned at (0.0, 0.0) -> bar 1 { axial_stiffness: ea, bending_stiffness: 2.0, mass_per_length: 1.5 }
        -> conn top at (1.0, 1.5) -> bar 2 { axial_stiffness: ea, bending_stiffness: 2.0, mass_per_length: 1.5 }
        -> pinned at (2.0, 0.0);
}

#[test]
fn bars_of_frames_are_those_of_sketches() {
    let Truss { l, ea, ei, m, load } = TRUSS;
    let steel = Section::new().axial_stiffness(ea).bending_stiffness(ei).mass_per_length(m);
    let mut frame = Frame::new();
    let [left, top, foot] = [[0.0, 0.0], [l, 1.5 * l], [2.0 * l, 0.2 * l]].map(|place| frame.point(place));
    frame.hold(left, Support::Pinned);
    frame.hold(foot, Support::Roller);
    frame.member(left, top, Bar(steel));
    frame.member(top, foot, Bar(steel.axial_force(load)));
    frame.member(left, foot, Bar(steel));
    frame.body([top], mstmm::frame::PointMass { mass: 2.0 * m * l, inertia: 0.0 });
    assert_near(&frequencies(&TRUSS.build().unwrap()), &frequencies(&frame.build().unwrap()), 1e-14);
}

/// A force at the end of a bar is one on its point; a couple there finds nothing that takes it.
#[test]
fn forces_act_at_the_ends_of_bars() {
    let truss = TRUSS.build().unwrap();
    let sway = Truss::conn_top.displacement_x();
    for (at_end, at_point) in [
        (Truss::bar_1.output().force_x(), Truss::conn_top.force_x()),
        (Truss::bar_1.output().force_y(), Truss::conn_top.force_y()),
    ] {
        let [one, other] =
            [at_end, at_point].map(|load| truss.frequency_response(load, sway).unwrap().at(0.7).unwrap());
        assert!((one - other).abs() <= 1e-14 * other.abs(), "{one} {other}");
    }
    assert!(truss.frequency_response(Truss::bar_1.output().torque_z(), sway).is_err());
}

/// An end beside its point turns it: two bars with an arm between them are a mechanism, with a link in name or without.
#[test]
fn an_end_beside_its_point_turns_it() {
    let steel = Section::new().axial_stiffness(900.0).bending_stiffness(2.0).mass_per_length(1.5);
    let build = |has_link: bool| {
        let mut frame = Frame::new();
        let [a, b, c] = [[0.0, 0.0], [1.0, 1.5], [2.0, 0.0]].map(|place| frame.point(place));
        frame.hold(a, Support::Pinned);
        frame.hold(c, Support::Pinned);
        frame.member(a, b.at([1.1, 1.6]), Bar(steel));
        frame.member(b, c, Bar(steel));
        if has_link {
            frame.body([b], mstmm::frame::RigidLink);
        }
        frequencies(&frame.build().unwrap())
    };
    let [plain, linked] = [false, true].map(build);
    assert!(plain[0] == 0.0 && plain[1] > 3.0, "{plain:?}");
    assert_near(&plain, &linked, 1e-14);
}
