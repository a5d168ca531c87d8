//! Strings between two places: they move across themselves against their tension, and stretch.

use super::{assert_near, eigenvalues, frequencies};
use core::f64::consts::PI;
use mstmm::frame::{Frame, Section, TautString};
use mstmm::network::Support;
use mstmm::prelude::*;

system! {
    /// A string between two points at rest, on springs all along it.
    struct Held { ea: f64, h: f64, m: f64, k: f64 }
    pinned at (0.0, 0.0) -> string 1 { axial_stiffness: ea, tension: h, mass_per_length: m, foundation_stiffness: k } -> pinned at (3.0, 4.0);
}

/// Closed form: `√((H (nπ/l)² + k)/m)` across, `nπ/l √(EA/m)` along.
#[test]
fn a_string_between_points_at_rest_has_sines() {
    let Held { ea, h, m, k } = Held { ea: 7.0, h: 2.0, m: 1.5, k: 0.3 };
    let system = Held { ea, h, m, k }.build().unwrap();
    let wave = |n: u32| f64::from(n) * PI / 5.0;
    let across = (1..40).map(|n| ((h * wave(n).powi(2) + k) / m).sqrt());
    let mut expected: Vec<f64> = across.chain((1..40).map(|n| wave(n) * (ea / m).sqrt())).collect();
    expected.sort_by(f64::total_cmp);
    assert_near(&expected[..6], &frequencies(&system)[..6], 1e-15);
    assert!(system.frequencies(40).unwrap().iter().all(|root| root.is_proven));
    assert_eq!(system.count_below(0.5 * (expected[20] + expected[21])), Ok(21));
}

system! {
    /// A mast between two guys, whose heads it carries.
    struct Mast { l: f64, ea: f64, h: f64, m: f64 }
    section guy { axial_stiffness: ea, tension: h, mass_per_length: m }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e3, bending_stiffness: 60.0, mass_per_length: 3.0 } -> conn head at (0.2 * l, l);
    pinned at (-0.8 * l, 0.0) -> string 2 { ..guy } -> conn head -> string 3 { ..guy } -> pinned at (1.5 * l, -0.1 * l);
    conn head -> point_mass 4 { mass: 2.0 };
}

system! {
    /// The same with bars in tension that hardly bend.
    struct Barred { l: f64, ea: f64, h: f64, m: f64, ei: f64 }
    section guy { axial_stiffness: ea, axial_force: h, mass_per_length: m, bending_stiffness: ei }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e3, bending_stiffness: 60.0, mass_per_length: 3.0 } -> conn head at (0.2 * l, l);
    pinned at (-0.8 * l, 0.0) -> bar 2 { ..guy } -> conn head -> bar 3 { ..guy } -> pinned at (1.5 * l, -0.1 * l);
    conn head -> point_mass 4 { mass: 2.0 };
}

const MAST: Mast = Mast { l: 2.5, ea: 800.0, h: 40.0, m: 0.2 };

/// Oracle: beams under an axial force whose bending stiffness, `EI (nπ/l)²` beside H, is less than 1e-5.
#[test]
fn strings_are_bars_in_tension_that_do_not_bend() {
    let Mast { l, ea, h, m } = MAST;
    let (strings, bars) = (MAST.build().unwrap(), Barred { l, ea, h, m, ei: 1e-5 }.build().unwrap());
    assert_near(&frequencies(&bars), &frequencies(&strings), 1e-5);
    let root = strings.frequencies(5).unwrap()[4];
    let other = bars.frequencies(5).unwrap()[4];
    let (shape, barred) = (strings.mode_shape(&root).unwrap(), bars.mode_shape(&other).unwrap());
    let length = l * f64::hypot(1.0, 1.0);
    let sign = |one: f64, other: f64| if one * other < 0.0 { -1.0 } else { 1.0 };
    let one = shape.along(Mast::string_2, 0.37 * length).unwrap();
    let bar = barred.along(Barred::bar_2, 0.37 * length).unwrap();
    let turned = sign(one.displacement_x, bar.displacement_x);
    for (one, other) in [
        (one.displacement_x, bar.displacement_x),
        (one.displacement_y, bar.displacement_y),
        (one.axial_force, bar.axial_force),
    ] {
        assert!((one - turned * other).abs() < 1e-4 * (1.0 + other.abs()), "{one} {other}");
    }
    let of_members =
        [shape.energy_shares(Mast::beam_1), shape.energy_shares(Mast::string_2), shape.energy_shares(Mast::string_3)];
    let shares = of_members.into_iter().chain([shape.body_shares(Mast::conn_head)]).map(Result::unwrap);
    let [strain, kinetic] = shares.fold([0.0; 2], |sum, share| [sum[0] + share.strain, sum[1] + share.kinetic]);
    assert!((strain - 1.0).abs() < 1e-13 && (kinetic - 1.0).abs() < 1e-13, "{strain} {kinetic}");
}

/// However little a bar in tension bends, its energies take no longer: its short waves decay a million times along it, beside its ends.
#[test]
fn energies_of_a_bar_that_hardly_bends_are_those_of_a_string() {
    let Mast { l, ea, h, m } = MAST;
    let (strings, bars) = (MAST.build().unwrap(), Barred { l, ea, h, m, ei: 1e-10 }.build().unwrap());
    let [root, other] = [strings.frequencies(4).unwrap()[3], bars.frequencies(4).unwrap()[3]];
    let (shape, barred) = (strings.mode_shape(&root).unwrap(), bars.mode_shape(&other).unwrap());
    let (one, bar) = (shape.energy_shares(Mast::string_3).unwrap(), barred.energy_shares(Barred::bar_3).unwrap());
    assert!((one.strain - bar.strain).abs() < 1e-5 && (one.kinetic - bar.kinetic).abs() < 1e-5, "{one:?} {bar:?}");
    assert_eq!(shape.nodes(Mast::string_3).unwrap(), barred.nodes(Barred::bar_3).unwrap());
    let largest = |shape: [f64; 2]| f64::hypot(shape[0], shape[1]);
    let [one, other] = [
        shape.with_unit_deflection().unwrap().node(1).unwrap(),
        barred.with_unit_deflection().unwrap().node(1).unwrap(),
    ];
    assert!((largest([one[0], one[1]]) - largest([other[0], other[1]])).abs() < 1e-5, "{one:?} {other:?}");
}

#[test]
fn sensitivities_of_strings_are_differences() {
    let root = |mast: Mast| mast.build().unwrap().frequencies(4).unwrap()[3];
    let found = MAST.build().unwrap();
    let derivatives = found.sensitivity(&root(MAST)).unwrap();
    type Field = fn(&mut Mast) -> &mut f64;
    let fields: [(&str, Field); 4] =
        [("l", |mast| &mut mast.l), ("ea", |mast| &mut mast.ea), ("h", |mast| &mut mast.h), ("m", |mast| &mut mast.m)];
    for ((name, field), (of, derivative)) in fields.into_iter().zip(derivatives.iter()) {
        assert_eq!(name, of);
        let moved = |part: f64| {
            let mut mast = MAST;
            *field(&mut mast) *= 1.0 + part;
            root(mast).omega
        };
        let mut mast = MAST;
        let value = *field(&mut mast);
        let difference = (moved(1e-6) - moved(-1e-6)) / (2e-6 * value);
        assert!((derivative - difference).abs() < 1e-7 * (1.0 + difference.abs()), "{name}: {derivative} {difference}");
    }
}

/// A string turns nothing at its ends.
#[test]
fn ends_of_strings_have_no_rotation() {
    let mast = MAST.build().unwrap();
    let sway = Mast::conn_head.displacement_x();
    assert!(mast.frequency_response(Mast::string_2.output().torque_z(), sway).is_err());
    assert!(mast.frequency_response(Mast::conn_head.force_x(), Mast::string_2.output().rotation_z()).is_err());
    assert!(mast.frequency_response(Mast::conn_head.force_x(), Mast::beam_1.output().rotation_z()).is_ok());
}

/// A determinant beside that of the proof: its sign changes at the same frequencies.
#[test]
fn the_overall_matrix_of_strings_is_singular_at_their_frequencies() {
    let mast = MAST.build().unwrap();
    for root in mast.frequencies(6).unwrap().iter() {
        let [below, above] = [1.0 - 1e-7, 1.0 + 1e-7].map(|part| mast.overall_determinant(root.omega * part).value());
        assert!(below * above < 0.0, "{below} {above} about {}", root.omega);
    }
}

#[test]
fn strings_of_frames_are_those_of_sketches() {
    let Mast { l, ea, h, m } = MAST;
    let guy = Section::new().axial_stiffness(ea).tension(h).mass_per_length(m);
    let mut frame = Frame::new();
    let places = [[0.0, 0.0], [0.2 * l, l], [-0.8 * l, 0.0], [1.5 * l, -0.1 * l]];
    let [foot, head, left, right] = places.map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.hold(left, Support::Pinned);
    frame.hold(right, Support::Pinned);
    frame.member(foot, head, Section::new().axial_stiffness(4e3).bending_stiffness(60.0).mass_per_length(3.0));
    frame.member(left, head, TautString(guy));
    frame.member(head, right, TautString(guy));
    frame.mass(head, 2.0);
    assert_near(&frequencies(&MAST.build().unwrap()), &frequencies(&frame.build().unwrap()), 1e-14);
    frame.member(left, right, TautString(guy.loss_factor(0.1)));
    let error = frame.build().unwrap_err().to_string();
    assert!(error.contains("a string has no `loss_factor`"), "{error}");
}

system! {
    /// A string in a medium.
    struct Damped { h: f64, c: f64 }
    pinned at (0.0, 0.0) -> string 1 { axial_stiffness: 70.0, tension: h, mass_per_length: 1.5, external_damping: c } -> pinned at (3.0, 4.0);
}

/// Closed form: `m λ² + c λ + H (nπ/l)² = 0`, and with EA along it.
#[test]
fn strings_are_damped_by_a_medium() {
    let (h, c, m) = (20.0, 0.1, 1.5);
    let found = eigenvalues(&Damped { h, c }.build().unwrap());
    let of = |stiffness: f64, n: u32| {
        let decay = 0.5 * c / m;
        Complex::new(-decay, (stiffness * (f64::from(n) * PI / 5.0).powi(2) / m - decay * decay).sqrt())
    };
    let mut expected: Vec<Complex<f64>> = (1..9).flat_map(|n| [of(h, n), of(70.0, n)]).collect();
    expected.sort_by(|one, other| one.im.total_cmp(&other.im));
    for (one, other) in expected.iter().zip(&found) {
        assert!((one - other).norm() < 1e-13 * one.norm(), "{one} {other}");
    }
}

system! {
    /// A string across a gap, with a joint at a quarter.
    struct Gap { h: f64 }
    section wire { axial_stiffness: 70.0, tension: h, mass_per_length: 1.5 }
    pinned at (0.0, 0.0) -> string 1 { ..wire } -> conn quarter at (1.0, 0.0) -> string 2 { ..wire } -> pinned at (4.0, 0.0);
}

/// Closed form: under `w` per length it hangs through by `w x (l - x)/(2H)`, under a force by `F x (l - x)/(H l)`.
#[test]
fn a_string_hangs_as_a_parabola() {
    let h = 20.0;
    let gap = Gap { h }.build().unwrap();
    let load = gap.frequency_response(Gap::string_2.uniform_load_y(), Gap::conn_quarter.displacement_y()).unwrap();
    // the load is on the longer part alone: by the influence line of the point
    let expected = (1.0 / (h * 4.0)) * (3.0 * 3.0 / 2.0);
    assert!((load.at(0.0).unwrap() - expected).abs() < 1e-15, "{} {expected}", load.at(0.0).unwrap());
    let states = load.states(0.0).unwrap();
    let middle = states.along(Gap::string_2, 1.5).unwrap().displacement_y;
    // the line between its ends, and the parabola of its own length
    let hanging = 0.5 * expected + 1.5 * 1.5 / (2.0 * h);
    assert!((middle - hanging).abs() < 1e-15, "{middle} {hanging}");
    let force = gap.frequency_response(Gap::conn_quarter.force_y(), Gap::conn_quarter.displacement_y()).unwrap();
    assert!((force.at(0.0).unwrap() - 3.0 / (h * 4.0)).abs() < 1e-15);
}
