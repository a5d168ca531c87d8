//! Ranges of frequencies over boxes of tolerances: values of the file, corners and what is between them, and what is no box.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{assert_close, number, reference};
use crate::numbers::Random;
use crate::random::frame;
use mstmm::elements::{Spring, TorsionSpring};
use mstmm::frame::{Frame, RigidBody, Section, Structure, Tensor, Tie};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm::search::{Rotor, ToleranceBox, ToleranceError};

system! {
    /// The portal of the file, with all that its box moves.
    #[derive(Clone, Copy)]
    struct Box {
        column_ea: f64, column_ei: f64, column_m: f64, girder_ea: f64, girder_ei: f64, girder_m: f64, mass: f64
    }
    section column { axial_stiffness: column_ea, bending_stiffness: column_ei, mass_per_length: column_m }
    conn a at (0.0, 0.0) -> beam 1 { ..column } -> conn b at (0.0, 3.0)
        -> beam 2 { axial_stiffness: girder_ea, bending_stiffness: girder_ei, mass_per_length: girder_m } -> conn c at (4.0, 3.0)
        -> beam 3 { ..column } -> conn d at (4.0, 0.0);
    fixed -> conn a;
    pinned -> conn d;
    conn b -> point_mass 4 { mass };
}

/// The portal with each parameter at its end of the box or between them, 0 soft and 1 stiff.
fn portal(shares: [f64; 7]) -> BoxSystem {
    let share = |k: usize| 2.0 * shares[k] - 1.0;
    let up = |k: usize, value: f64| value * (1.0 + 0.05 * share(k));
    let down = |k: usize, value: f64| value * (1.0 - 0.05 * share(k));
    Box {
        column_ea: up(0, 4e8),
        column_ei: up(1, 1e6),
        column_m: down(2, 20.0),
        girder_ea: up(3, 4e8),
        girder_ei: up(4, 1e6),
        girder_m: down(5, 20.0),
        mass: down(6, 100.0),
    }
    .build()
    .unwrap()
}

#[test]
fn ranges_of_a_portal_are_those_of_the_file() {
    let file = reference("ranges")["portal_box"].clone();
    let lot = ToleranceBox::between(portal([0.0; 7]), portal([1.0; 7])).unwrap();
    let ranges = lot.first_frequencies::<6>().unwrap();
    for (number_of, range) in ranges.iter().enumerate() {
        assert_close(range.lowest.omega, number(&file["lowest"][number_of]), 1e-14);
        assert_close(range.highest.omega, number(&file["highest"][number_of]), 1e-14);
        assert!(range.lowest.is_proven && range.highest.is_proven);
    }
    assert_eq!(lot.frequencies(6).unwrap(), ranges.to_vec());
    // none of all corners is outside, and two of them are the ends
    for corner in 0..128_u32 {
        let system = portal(core::array::from_fn(|k| f64::from(corner >> k & 1)));
        let roots = system.first_frequencies::<6>().unwrap();
        for (root, range) in roots.iter().zip(&ranges) {
            assert!(root.omega >= range.lowest.lower && root.omega <= range.highest.upper, "{corner}");
        }
        assert!(ToleranceBox::between(lot.soft().clone(), system.clone()).is_ok());
        assert!(ToleranceBox::between(system, lot.stiff().clone()).is_ok());
    }
    // between the ranges nothing is, and where they meet something is
    for pair in file["free_of"].as_array().unwrap() {
        let (from, to) = (number(&pair[0]), number(&pair[1]));
        assert!(lot.is_free_of(from * (1.0 + 1e-12)..=to * (1.0 - 1e-12)).unwrap());
        assert!(!lot.is_free_of(from * (1.0 - 1e-9)..=to * (1.0 - 1e-12)).unwrap());
        assert!(!lot.is_free_of(from * (1.0 + 1e-12)..=to * (1.0 + 1e-9)).unwrap());
    }
    assert_eq!(lot.count_below(40.0).unwrap(), 0..=1);
    assert_eq!(lot.count_below(50.0).unwrap(), 1..=1);
    assert!(matches!(lot.is_free_of(3.0..=2.0), Err(ToleranceError::Search(_))));
    assert!(matches!(lot.is_free_of(-3.0..=2.0), Err(ToleranceError::Search(_))));
}

#[test]
fn what_is_no_box_says_why() {
    let refused = ToleranceBox::between(portal([1.0; 7]), portal([0.0; 7])).map(|_| ()).unwrap_err();
    let ToleranceError::NotOrdered { parameter, soft, stiff, .. } = refused else { panic!("{refused}") };
    assert!(soft > stiff || parameter.contains("mass"), "{refused}");
    let mut shares = [0.0; 7];
    shares[6] = 1.0;
    let light = portal(shares);
    let refused = ToleranceBox::between(light, portal([0.0; 7])).map(|_| ()).unwrap_err();
    assert!(matches!(refused, ToleranceError::NotOrdered { parameter: "mass", .. }), "{refused}");
    assert!(refused.to_string().contains("`mass` of conn b"), "{refused}");
    let mut shares = [0.0; 7];
    shares[3] = 1.0;
    let refused = ToleranceBox::between(portal(shares), portal([0.0; 7])).map(|_| ()).unwrap_err();
    assert!(refused.to_string().contains("`axial_stiffness` of beam 2 is"), "{refused}");
}

system! {
    /// A cantilever with a body whose mass centre is beside its input end, about which its inertia is given.
    struct Beside { mass: f64, inertia: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> body 2 { mass, inertia_about_input: inertia, output_x: 0.1, centre_x: -0.9 } -> free;
}

system! {
    /// All kinds of elements of a path, each with a share of a tolerance.
    struct Mixed { up: f64, down: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 3.0 * up, mass_per_length: 1.0 * down, shear_stiffness: 50.0 * up, rotary_inertia: 0.01 * down, axial_force: 0.3 * up, foundation_stiffness: 0.2 * up }
        -> hinge 2 { stiffness_rz: 2.0 * up } -> tapered_beam 3 { length: 0.7, bending_stiffness: 2.0 * up, mass_per_length: 0.8 * down, height_taper: 0.4 }
        -> conn a -> body 4 { mass: 0.3 * down, inertia: 0.02 * down, output_x: 0.2, centre_x: 0.1 } -> conn b -> free;
    fixed -> spring 5 { stiffness: 8.0 * up } -> mass 6 { mass: 0.4 * down } -> spring 7 { stiffness: 5.0 * up } -> conn a;
    fixed -> string 8 { length: 0.9, tension: 4.0 * up, mass_per_length: 0.3 * down } -> conn b;
}

/// Trees: what is between both ends of a box lies in its ranges, and a heavier body may be stiffer where its inertia is about its input.
#[test]
fn ranges_of_trees_hold_all_between() {
    let of = |up: f64, down: f64| Mixed { up, down }.build().unwrap();
    let lot = ToleranceBox::between(of(0.9, 1.1), of(1.1, 0.9)).unwrap();
    let ranges = lot.first_frequencies::<12>().unwrap();
    for (up, down) in [(0.9, 0.9), (1.1, 1.1), (1.0, 1.0), (0.93, 1.04), (1.08, 0.91)] {
        for (root, range) in of(up, down).first_frequencies::<12>().unwrap().iter().zip(&ranges) {
            assert!(root.omega > range.lowest.omega && root.omega < range.highest.omega);
        }
    }
    let beside = |mass: f64, inertia: f64| Beside { mass, inertia }.build().unwrap();
    let refused = ToleranceBox::between(beside(1.1, 1.0), beside(1.0, 1.0)).map(|_| ()).unwrap_err();
    assert!(matches!(refused, ToleranceError::NotOrdered { parameter: "inertia_about_input", .. }), "{refused}");
    // the file has why: with the larger mass all frequencies are higher
    let file = reference("ranges")["body_mass_mixed"].clone();
    assert!(file["mass_1_1"][0].as_f64().unwrap() > file["mass_1"][0].as_f64().unwrap());
    assert!(ToleranceBox::between(beside(1.0, 1.1), beside(1.0, 1.0)).is_ok());
}

/// A frame in space whose numbers move with a share, or with shares by a generator.
fn crane(mut share: impl FnMut() -> f64, tilt: f64) -> Structure<mstmm::frame::Space> {
    let mut up = |value: f64| value * (1.0 + 0.1 * share());
    let mut frame = Frame::new();
    let [foot, corner, other, tip] =
        [[0.0, 0.0, 0.0], [0.3, 2.0, 0.4], [0.3, 2.0, 0.4], [1.4, 2.5, 1.1 + tilt]].map(|place| frame.point(place));
    let tube = Section::new().axial_stiffness(up(600.0)).torsional_stiffness(up(1.3)).bending_stiffness_y(up(2.0));
    let tube =
        tube.bending_stiffness_z(up(3.0)).mass_per_length(1.0 / up(1.1)).polar_inertia_per_length(1.0 / up(100.0));
    frame.hold(foot, Support::Fixed);
    frame.member(foot, corner, tube);
    frame.member(corner, other, Tie::ball());
    frame.member(other, tip, tube);
    let mass = 1.0 / up(2.0);
    let scale = 1.0 / up(1.0);
    let inertia = Tensor::new([0.05, 0.06, 0.04, 0.01, -0.005, 0.004].map(|entry| entry * scale));
    frame.body([tip], RigidBody { mass, inertia, centre: [1.5, 2.4, 1.2] });
    for along in [[1.0, 0.0, 0.2], [0.0, 1.0, 0.3], [0.1, 0.0, 1.0]] {
        let stiffness = up(9.0);
        frame.member(tip.along(along), foot.along(along), Spring { stiffness });
    }
    let stiffness = up(0.6);
    frame.member(other.about([0.2, 1.0, 0.3]), foot.about([0.2, 1.0, 0.3]), TorsionSpring { stiffness });
    frame.build().unwrap()
}

#[test]
fn ranges_of_frames_in_space_hold_all_between() {
    let lot = ToleranceBox::between(crane(|| -1.0, 0.0), crane(|| 1.0, 0.0)).unwrap();
    let ranges = lot.frequencies(10).unwrap();
    let mut random = Random(3);
    for _ in 0..12 {
        for (root, range) in crane(|| 2.0 * random.unit() - 1.0, 0.0).frequencies(10).unwrap().iter().zip(&ranges) {
            assert!(root.omega > range.lowest.omega && root.omega < range.highest.omega);
        }
    }
    // another place
    let moved = ToleranceBox::between(crane(|| -1.0, 0.0), crane(|| 1.0, 1e-9)).map(|_| ()).unwrap_err();
    assert!(matches!(moved, ToleranceError::NotAlike { .. }), "{moved}");
}

system! {
    /// Elements of paths, each parameter by itself.
    #[derive(Clone, Copy)]
    struct Each {
        ei: f64, m: f64, kga: f64, inertia: f64, force: f64, foundation: f64, layer: f64, hinge: f64, taper_ei: f64, taper_m: f64, mass: f64,
        body: f64, spring: f64, point: f64, tension: f64, string_m: f64, turn: f64, gj: f64, shaft_m: f64, string_l: f64, shaft_l: f64
    }
    fixed -> beam 1 {
            length: 1.0, bending_stiffness: ei, mass_per_length: m, shear_stiffness: kga, rotary_inertia: inertia, axial_force: force,
            foundation_stiffness: foundation, foundation_shear_stiffness: layer
        } -> hinge 2 { stiffness_rz: hinge } -> tapered_beam 3 { length: 0.7, bending_stiffness: taper_ei, mass_per_length: taper_m, height_taper: 0.4 }
        -> conn a -> body 4 { mass, inertia: body, output_x: 0.2, centre_x: 0.1 } -> conn b -> free;
    fixed -> spring 5 { stiffness: spring } -> mass 6 { mass: point } -> spring 7 { stiffness: 5.0 } -> conn a;
    fixed -> string 8 { length: string_l, tension, mass_per_length: string_m } -> conn b;
    fixed -> torsion_spring 9 { stiffness: turn } -> conn b;
    fixed -> shaft 10 { length: shaft_l, torsional_stiffness: gj, inertia_per_length: shaft_m } -> conn a;
}

/// Each parameter acts as the box takes it to act: by no more than its own change, in one way alone.
#[test]
fn each_parameter_acts_in_its_way() {
    // each with its value and what makes the system softer
    macro_rules! parameters {
        ($($name:ident: $value:literal * $softer:literal),*) => {{
            let stiff = Each { $($name: $value),* };
            (stiff, [$((stringify!($name), Each { $name: $value * $softer, ..stiff })),*])
        }};
    }
    let (stiff, softer) = parameters!(
        ei: 3.0 * 0.9, m: 1.0 * 1.1, kga: 50.0 * 0.9, inertia: 0.05 * 1.1, force: 0.8 * 0.9, foundation: 0.9 * 0.9, layer: 0.7 * 0.9,
        hinge: 2.0 * 0.9, taper_ei: 2.0 * 0.9, taper_m: 0.8 * 1.1, mass: 0.3 * 1.1, body: 0.05 * 1.1, spring: 8.0 * 0.9, point: 0.4 * 1.1,
        tension: 4.0 * 0.9, string_m: 0.3 * 1.1, turn: 0.6 * 0.9, gj: 0.5 * 0.9, shaft_m: 0.04 * 1.1, string_l: 0.9 * 1.1, shaft_l: 0.8 * 1.1
    );
    for (name, softer) in softer {
        let [soft, stiff] = [softer, stiff].map(|model| model.build().unwrap());
        let lot = ToleranceBox::between(soft.clone(), stiff.clone()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let ranges = lot.first_frequencies::<10>().unwrap();
        assert!(ranges.iter().all(|range| range.lowest.lower <= range.highest.upper), "{name}");
        assert!(ranges.iter().any(|range| range.lowest.upper < range.highest.lower * (1.0 - 1e-6)), "{name}");
        let refused = ToleranceBox::between(stiff, soft).map(|_| ()).unwrap_err();
        assert!(matches!(refused, ToleranceError::NotOrdered { .. }), "{name}: {refused}");
    }
}

/// A finite shear stiffness is softer than none, and the speed of a blade is the same in both.
#[test]
fn what_is_rigid_is_stiffest_and_blades_turn_alike() {
    let lot =
        ToleranceBox::between(Sheared { kga: 500.0 }.build().unwrap(), Sheared { kga: f64::INFINITY }.build().unwrap())
            .unwrap();
    assert!(lot.first_frequencies::<4>().unwrap().iter().all(|range| range.lowest.omega < range.highest.omega));
    assert!(ToleranceBox::between(lot.stiff().clone(), lot.soft().clone()).is_err());
    let blade = |m: f64, speed: f64| Blade { m, speed }.build().unwrap();
    assert!(ToleranceBox::between(blade(1.1, 0.0), blade(1.0, 0.0)).is_ok());
    for (soft, stiff, name) in
        [(blade(1.1, 3.0), blade(1.0, 3.0), "mass_per_length"), (blade(1.0, 2.0), blade(1.0, 3.0), "rotation_speed")]
    {
        let refused = ToleranceBox::between(soft, stiff).map(|_| ()).unwrap_err();
        assert!(matches!(refused, ToleranceError::NotOrdered { parameter, .. } if parameter == name), "{refused}");
    }
}

system! {
    struct Sheared { kga: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 3.0, mass_per_length: 1.0, shear_stiffness: kga } -> free
}

system! {
    struct Blade { m: f64, speed: f64 }
    fixed -> tapered_beam 1 { length: 1.0, bending_stiffness: 3.0, mass_per_length: m, height_taper: 0.4, rotation_speed: speed, hub_radius: 0.2, setting_angle: 0.3 } -> free
}

system! {
    /// A shaft with a disc on two springs, whose stiffnesses and masses have tolerances.
    #[derive(Clone, Copy)]
    struct Spindle { up: f64, down: f64, speed: f64 }
    free -> conn a -> beam 1 {
            length: 0.5, bending_stiffness: 6.5e4 * up, mass_per_length: 15.3 * down, rotary_inertia: 2.4e-3 * down, polar_inertia_per_length: 4.8e-3, speed
        } -> disc 2 { mass: 33.0 * down, inertia: 0.18 * down, polar_inertia: 0.32, speed }
        -> beam 3 {
            length: 1.0, bending_stiffness: 6.5e4 * up, mass_per_length: 15.3 * down, rotary_inertia: 2.4e-3 * down, polar_inertia_per_length: 4.8e-3, speed
        } -> conn b -> free;
    fixed -> spring 4 { stiffness: 1e6 * up } -> conn a;
    fixed -> spring 5 { stiffness: 1e6 * up } -> conn b;
}

/// Each whirl of a rotor is a system like others.
#[test]
fn whirls_of_rotors_have_ranges() {
    let of = |up: f64, down: f64, speed: f64| Spindle { up, down, speed }.build().unwrap();
    let (soft, stiff) = (of(0.95, 1.05, 400.0), of(1.05, 0.95, 400.0));
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let lot = ToleranceBox::between(soft.whirl(whirl).clone(), stiff.whirl(whirl).clone()).unwrap();
        let ranges = lot.first_frequencies::<6>().unwrap();
        for (up, down) in [(1.0, 1.0), (0.96, 0.97), (1.04, 1.05), (1.05, 1.05), (0.95, 0.95)] {
            let between = of(up, down, 400.0);
            for (root, range) in between.whirl(whirl).first_frequencies::<6>().unwrap().iter().zip(&ranges) {
                assert!(root.omega > range.lowest.omega && root.omega < range.highest.omega, "{whirl:?} {up} {down}");
            }
        }
    }
    // a higher speed stiffens forward whirl and softens backward whirl
    let faster = of(1.05, 0.95, 401.0);
    let of_both = |soft: &Rotor<_>, stiff: &Rotor<_>, whirl| {
        ToleranceBox::between(soft.clone().into_whirl(whirl), stiff.clone().into_whirl(whirl)).map(|_| ())
    };
    assert!(of_both(&soft, &faster, Whirl::Forward).is_ok());
    let refused = of_both(&soft, &faster, Whirl::Backward);
    assert!(matches!(refused, Err(ToleranceError::NotOrdered { parameter: "speed", .. })), "{refused:?}");
}

/// Corners and samples of boxes around random frames: none outside, and both ends those of the soft and the stiff frame.
fn assert_nothing_is_outside(seeds: core::ops::Range<u64>, corners: usize, samples: usize) {
    let (mut tried, mut seen, mut count) = (0, 0.0, 0.0);
    for seed in seeds {
        let of = |share: &mut dyn FnMut() -> f64| frame(seed, 0.05, share).frame.build().unwrap();
        let (soft, stiff) = (of(&mut || -1.0), of(&mut || 1.0));
        let lot = ToleranceBox::between(soft, stiff).unwrap();
        let ranges = lot.frequencies(6).unwrap();
        assert_eq!(ranges[0].lowest, lot.soft().frequencies(6).unwrap()[0]);
        let mut random = Random(seed + 77);
        let mut extremes = ranges.iter().map(|range| [range.highest.omega, range.lowest.omega]).collect::<Vec<_>>();
        for sample in 0..corners + samples {
            let mut share = || {
                let number = random.unit();
                if sample < corners { if number < 0.5 { -1.0 } else { 1.0 } } else { 2.0 * number - 1.0 }
            };
            let roots = of(&mut share).frequencies(6).unwrap();
            let numbers = roots.iter().flat_map(|root| core::iter::repeat_n(root, root.multiplicity as usize));
            for ((root, range), extreme) in numbers.zip(&ranges).zip(&mut extremes) {
                let is_inside = root.upper >= range.lowest.lower && root.lower <= range.highest.upper;
                assert!(is_inside, "{seed}: {} outside {range:?}", root.omega);
                *extreme = [extreme[0].min(root.omega), extreme[1].max(root.omega)];
            }
            tried += 1;
        }
        for (range, [least, most]) in ranges.iter().zip(extremes) {
            seen += (most - least) / (range.highest.omega - range.lowest.omega);
            count += 1.0;
        }
    }
    println!("{tried} frames, none outside; they see {:.2} of the ranges", seen / count);
}

#[test]
fn corners_of_random_frames_are_inside() {
    assert_nothing_is_outside(0..4, 8, 8);
}

#[test]
#[ignore = "long: .ci/long"]
fn a_thousand_corners_and_samples_of_fifty_frames_are_inside() {
    assert_nothing_is_outside(0..50, 1024, 1000);
}
