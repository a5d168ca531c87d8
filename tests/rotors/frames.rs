//! Rotors at run time beside those of sketches.
#![expect(clippy::panic, clippy::unwrap_used, reason = "a rotor that is refused fails the test")]

use crate::numbers::Random;
use crate::polynomial_elements::Shafts;
use crate::shafts::{Between, Loose, Numbers, Overhung, Spools, Topology};
use mstmm::Complex;
use mstmm::elements::{CrossCoupledSpring, Disc, Spring, TorsionSpring, TorsionSpringDamper};
use mstmm::frame::{BuildErrors, Frame, Ground, Line, Mistake, Point, RotorStructure, Section};
use mstmm::motion::MotionError;
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm::search::{Rotor, SearchError, SpeedError, campbell, critical_speeds, stability_threshold};

/// A length that sums have exactly.
fn short(length: f64) -> f64 {
    (length * 1024.0).round() / 1024.0
}

/// The frame of stations.
fn frame_of(shafts: &Shafts) -> Frame<Line> {
    let mut places = vec![None; shafts.stations];
    for member in &shafts.members {
        let from = places[member.ends[0]].unwrap_or(0.0);
        places[member.ends[0]] = Some(from);
        places[member.ends[1]] = Some(from + member.length);
    }
    let mut frame = Frame::new();
    let points: Vec<Point<Line>> = places.into_iter().map(|place| frame.point(place.unwrap_or(0.0))).collect();
    for member in &shafts.members {
        let section = Section::new()
            .bending_stiffness(member.bending_stiffness)
            .mass_per_length(member.mass)
            .shear_stiffness(member.shear_stiffness)
            .rotary_inertia(member.rotary_inertia)
            .polar_inertia_per_length(member.polar_inertia)
            .speed(member.speed);
        frame.member(points[member.ends[0]], points[member.ends[1]], section);
    }
    for disc in &shafts.discs {
        let crate::polynomial_elements::Disc { station, mass, inertia, polar_inertia, speed } = *disc;
        frame.body([points[station]], Disc { mass, inertia, polar_inertia, speed });
    }
    for &(from, to, stiffness) in &shafts.springs {
        match to {
            Some(to) => {
                frame.member(points[from], points[to], Spring { stiffness });
            }
            None => {
                frame.member(points[from], Ground, Spring { stiffness });
            }
        }
    }
    for &(from, stiffness) in &shafts.torsion_springs {
        frame.member(points[from], Ground, TorsionSpring { stiffness });
    }
    for (station, point) in points.iter().enumerate() {
        let [deflection, rotation] = [0, 1].map(|freedom| shafts.held.contains(&(2 * station + freedom)));
        match (deflection, rotation) {
            (true, true) => frame.hold(*point, Support::Fixed),
            (true, false) => frame.hold(*point, Support::Pinned),
            _ => {}
        }
    }
    frame
}

/// Numbers whose lengths sum exactly, and the speed of whose second spool is no rounded product.
fn numbers(random: &mut Random) -> Numbers {
    let mut numbers = Numbers::random(random);
    numbers.ratio = random.pick([-1.0, -0.5, 0.5, 2.0]);
    for part in &mut numbers.parts {
        part.length = short(part.length);
    }
    numbers
}

/// The first frequencies of both whirls of a frame are those of the sketch, all proven, and so are its critical speeds.
fn beside_sketch<M: Topology>(random: &mut Random, is_held: bool) {
    let numbers = numbers(random);
    let speed = 10f64.powf(2.5 * random.unit() - 1.0);
    let sketch = M::rotor(numbers, speed);
    let frame = frame_of(&M::shafts(&numbers, speed)).build_rotor();
    let frame = frame.unwrap_or_else(|error| panic!("{numbers:?}: {error}"));
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let expected = sketch.whirl(whirl).first_frequencies::<6>().unwrap();
        let found = frame.whirl(whirl).first_frequencies::<6>();
        let found = found.unwrap_or_else(|error| panic!("{numbers:?} {whirl:?}: {error}"));
        for (own, expected) in found.iter().zip(expected.iter()) {
            assert!(own.is_proven && own.index == expected.index, "{whirl:?}: {own:?} {expected:?}");
            assert!(own.lower <= expected.upper && expected.lower <= own.upper, "{whirl:?}: {own:?} {expected:?}");
        }
    }
    if is_held {
        let whirl = if random.chance(0.5) { Whirl::Forward } else { Whirl::Backward };
        let expected = critical_speeds::<64, _>(0.0..=40.0, whirl, 1.0, |speed| Ok(M::rotor(numbers, speed))).unwrap();
        let build = |speed: f64| frame_of(&M::shafts(&numbers, speed)).build_rotor();
        let found = critical_speeds::<64, _>(0.0..=40.0, whirl, 1.0, build).unwrap();
        assert_eq!(found.len(), expected.len(), "{numbers:?}");
        for (own, expected) in found.iter().zip(expected.iter()) {
            assert!(
                own.is_proven && own.lower <= expected.upper && expected.lower <= own.upper,
                "{own:?} {expected:?}"
            );
        }
    }
}

fn compare(rounds: usize) {
    let mut random = Random(370);
    for _ in 0..rounds {
        beside_sketch::<Between>(&mut random, true);
        beside_sketch::<Overhung>(&mut random, true);
        beside_sketch::<Loose>(&mut random, false);
        beside_sketch::<Spools>(&mut random, true);
    }
}

#[test]
fn frames_have_the_proven_frequencies_of_sketches() {
    compare(6);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_frames_have_the_proven_frequencies_of_sketches() {
    compare(250);
}

system! {
    /// A damped rotor with a seal.
    #[derive(Clone, Copy)]
    struct Sketch { speed: f64, time: f64, cross: f64, damping: f64 }
    section s {
        length: 0.5, bending_stiffness: 40.0, mass_per_length: 2.0, shear_stiffness: 9e3, rotary_inertia: 0.02,
        polar_inertia_per_length: 0.05, speed
    }
    free -> conn a -> beam 1 { ..s, kelvin_voigt_time: time, external_damping: 0.3 } -> disc 2 { mass: 3.0, inertia: 0.05, polar_inertia: 0.08, speed }
         -> beam 3 { ..s } -> conn b -> free;
    fixed -> spring 4 { stiffness: 4e3, damping, cross_stiffness: cross, cross_damping: 0.5 } -> conn a;
    fixed -> spring 5 { stiffness: 5e3 } -> conn b;
    fixed -> torsion_spring 6 { stiffness: 20.0, damping: 0.1 } -> conn b;
}

const SKETCH: Sketch = Sketch { speed: 60.0, time: 1e-4, cross: 300.0, damping: 20.0 };

/// The same as a frame, its points, its shafts, its disc and its seal.
struct Built {
    frame: Frame<Line>,
    points: [Point<Line>; 3],
}

fn built(Sketch { speed, time, cross, damping }: Sketch) -> Built {
    let mut frame = Frame::new();
    let points = [0.0, 0.5, 1.0].map(|x| frame.point(x));
    let shaft = Section::new().bending_stiffness(40.0).mass_per_length(2.0).shear_stiffness(9e3);
    let shaft = shaft.rotary_inertia(0.02).polar_inertia_per_length(0.05).speed(speed);
    frame.member(points[0], points[1], shaft.kelvin_voigt_time(time).external_damping(0.3));
    frame.member(points[1], points[2], shaft);
    frame.body([points[1]], Disc { mass: 3.0, inertia: 0.05, polar_inertia: 0.08, speed });
    let [loss_factor, kelvin_voigt_time] = [0.0; 2];
    let seal = CrossCoupledSpring {
        stiffness: 4e3,
        loss_factor,
        kelvin_voigt_time,
        damping,
        cross_stiffness: cross,
        cross_damping: 0.5,
    };
    frame.member(points[0], Ground, seal);
    frame.member(points[2], Ground, Spring { stiffness: 5e3 });
    frame.member(points[2], Ground, TorsionSpringDamper { stiffness: 20.0, damping: 0.1 });
    Built { frame, points }
}

#[track_caller]
fn assert_close(found: Complex<f64>, expected: Complex<f64>, tolerance: f64) {
    let error = (found - expected).norm() / expected.norm();
    assert!(error <= tolerance, "{found} instead of {expected}: {error:e}");
}

/// Eigenvalues of both whirls, their shapes, responses, unbalance and orbits.
#[test]
fn damped_frames_have_the_answers_of_sketches() {
    let sketch = SKETCH.build().unwrap();
    let Built { frame, points: [a, middle, b] } = built(SKETCH);
    let rotor = frame.build_damped_rotor().unwrap();
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let (own, other) = (rotor.whirl(whirl), sketch.whirl(whirl));
        let roots = own.first_eigenvalues::<4>().unwrap();
        for (root, expected) in roots.iter().zip(other.first_eigenvalues::<4>().unwrap().iter()) {
            assert!(root.is_proven, "{root:?}");
            assert_close(root.lambda, expected.lambda, 1e-13);
            let (shape, other_shape) = (own.mode_shape(root).unwrap(), other.mode_shape(expected).unwrap());
            // a shape is known up to its sign
            let square = shape.motion_of(middle).unwrap()[1].powi(2);
            assert_close(square, other_shape.state(Sketch::disc_2.output()).y.powi(2), 1e-11);
            assert_close(shape.modal_mass(), Complex::ONE, 1e-12);
        }
        for x in [Complex::new(0.0, 30.0), Complex::new(0.0, 60.0), Complex::new(-3.0, 200.0)] {
            let found = own.frequency_response(a.force_y(), b.rotation_z()).unwrap().at(x).unwrap();
            let expected = other.frequency_response(Sketch::conn_a.force(), Sketch::conn_b.rotation()).unwrap();
            assert_close(found, expected.at(x).unwrap(), 1e-13);
        }
    }
    let size = Complex::from_polar(2e-4, 0.4);
    let found = rotor.whirl(Whirl::Forward).unbalance(60.0, &[(middle.force_y(), size)], a.displacement_y()).unwrap();
    let load = Sketch::disc_2.output().force();
    let expected = sketch.whirl(Whirl::Forward).unbalance(60.0, &[(load, size)], Sketch::conn_a.deflection()).unwrap();
    assert_close(found, expected, 1e-13);
    let found = rotor.orbit(middle.force_y(), a.displacement_y(), 45.0).unwrap();
    let expected = sketch.orbit(load, Sketch::conn_a.deflection(), 45.0).unwrap();
    assert_close(found.forward, expected.forward, 1e-13);
    assert_close(found.backward, expected.backward, 1e-13);
    // a rotor that is damped is not built without
    let errors = frame.build_rotor().unwrap_err();
    assert!(errors.iter().all(|error| error.mistake == Mistake::DampedRotor) && errors.len() == 3, "{errors}");
}

/// Sensitivities to what spins, by names, beside differences of eigenvalues.
#[test]
fn sensitivities_are_slopes() {
    let speed = 60.0;
    let shaft = |scale: [f64; 4]| {
        let mut frame = Frame::new();
        let points = [0.0, 0.5, 1.0].map(|x| frame.point(x));
        let section = Section::new().bending_stiffness(40.0).mass_per_length(2.0).rotary_inertia(0.02);
        let section = section.polar_inertia_per_length(0.05 * scale[0]).speed(speed * scale[1]);
        let first = frame.member(points[0], points[1], section);
        frame.member(points[1], points[2], section.polar_inertia_per_length(0.05).speed(speed));
        let (polar_inertia, own) = (0.08 * scale[2], speed * scale[3]);
        let disc = frame.body([points[1]], Disc { mass: 3.0, inertia: 0.05, polar_inertia, speed: own });
        frame.hold(points[0], Support::Pinned);
        frame.hold(points[2], Support::Pinned);
        (frame.build_rotor().unwrap(), first, disc)
    };
    let (rotor, first, disc) = shaft([1.0; 4]);
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let roots = rotor.whirl(whirl).first_frequencies::<4>().unwrap();
        for (place, root) in roots.iter().enumerate() {
            let slopes = rotor.whirl(whirl).sensitivity(root).unwrap();
            let found = [
                slopes.of(first, "polar_inertia_per_length").unwrap() * 0.05,
                slopes.of(first, "speed").unwrap() * speed,
                slopes.of(disc, "polar_inertia").unwrap() * 0.08,
                slopes.of(disc, "speed").unwrap() * speed,
            ];
            for (parameter, slope) in found.into_iter().enumerate() {
                let at = |step: f64| {
                    let mut scale = [1.0; 4];
                    scale[parameter] += step;
                    shaft(scale).0.whirl(whirl).first_frequencies::<4>().unwrap()[place].omega
                };
                // of fourth order
                let (near, far) = (at(1e-3) - at(-1e-3), at(2e-3) - at(-2e-3));
                let expected = (8.0 * near - far) / 12e-3;
                let error = (slope - expected).abs() / root.omega;
                assert!(error < 1e-11, "{whirl:?} {} {parameter}: {slope} instead of {expected}", root.index);
            }
            assert!(matches!(slopes.of(first, "loss_factor"), Err(MotionError::NoSuchParameter)));
        }
    }
}

/// Diagrams and thresholds of frames, whose errors are those of frames.
#[test]
fn searches_over_speeds_take_frames() {
    let build = |speed: f64| built(Sketch { speed, ..SKETCH }).frame.build_damped_rotor();
    let region = Region { re: 0.0..=40.0, im: 1.0..=400.0 };
    let own = stability_threshold(1.0..=4e3, Whirl::Forward, region.clone(), build).unwrap();
    let other =
        stability_threshold(1.0..=4e3, Whirl::Forward, region, |speed| Sketch { speed, ..SKETCH }.build()).unwrap();
    match (own, other) {
        (Some(own), Some(other)) => assert!((own.speed / other.speed - 1.0).abs() < 1e-10, "{own:?} {other:?}"),
        (own, other) => panic!("{own:?} {other:?}"),
    }
    let plain = |speed: f64| -> Result<Rotor<RotorStructure>, BuildErrors> {
        let mut frame = Frame::new();
        let [left, right] = [0.0, 1.0].map(|x| frame.point(x));
        let section = Section::new().bending_stiffness(40.0).mass_per_length(2.0).rotary_inertia(0.02);
        frame.member(left, right, section.polar_inertia_per_length(0.05).speed(speed));
        for end in [left, right] {
            frame.hold(end, Support::Pinned);
        }
        frame.build_rotor()
    };
    for at in campbell::<3, _>([0.0, 40.0, 90.0], plain) {
        let at = at.unwrap();
        for (list, sign) in [(at.forward, 1.0), (at.backward, -1.0)] {
            for (j, root) in list.iter().enumerate() {
                // EI κ⁴ - ω² (m + rκ²) + ωΩ r_p κ² = 0
                let square = ((j + 1) as f64 * core::f64::consts::PI).powi(2);
                let (a, b) = (2.0 + 0.02 * square, sign * at.speed * 0.05 * square);
                let expected = (b + (b * b + 4.0 * a * 40.0 * square * square).sqrt()) / (2.0 * a);
                assert!(root.is_proven && (root.omega / expected - 1.0).abs() < 1e-14, "{root:?} {expected}");
            }
        }
    }
    let refused = critical_speeds::<8, _>(0.0..=10.0, Whirl::Forward, 1.0, |speed| plain(speed / 0.0));
    assert!(matches!(refused, Err(SpeedError::Parameter { .. })), "{refused:?}");
}

/// What is added to a frame of two points.
type Addition<'a> = dyn Fn(&mut Frame<Line>, [Point<Line>; 2]) + 'a;

/// What is wrong is said at its part.
#[test]
fn mistakes_are_told() {
    let mistakes = |add: &Addition<'_>| {
        let mut frame = Frame::new();
        let points = [0.0, 1.0].map(|x| frame.point(x));
        add(&mut frame, points);
        frame.hold(points[0], Support::Fixed);
        let errors = frame.build_damped_rotor().err().map_or_else(Vec::new, |errors| errors.to_vec());
        errors.iter().map(std::string::ToString::to_string).collect::<Vec<String>>()
    };
    let plain = Section::new().bending_stiffness(40.0).mass_per_length(2.0);
    let shaft = plain.rotary_inertia(0.02).polar_inertia_per_length(0.05).speed(30.0);
    let of = |section: Section| {
        mistakes(&|frame, [from, to]| {
            frame.member(from, to, section);
        })
    };
    assert_eq!(of(shaft), [""; 0]);
    let missing = |parameter: &str| {
        let rule = "a shaft that spins names `rotary_inertia`, `polar_inertia_per_length` and `speed`";
        format!("member 0: `{parameter}` is missing: {rule}")
    };
    assert_eq!(of(plain.rotary_inertia(0.1).speed(30.0)), [missing("polar_inertia_per_length")]);
    assert_eq!(of(plain.speed(30.0)), [missing("rotary_inertia")]);
    assert_eq!(of(plain.polar_inertia_per_length(0.1).speed(3.0)), [missing("rotary_inertia")]);
    assert_eq!(of(shaft.loss_factor(0.1)), ["member 0: a beam that spins has no `loss_factor`"]);
    assert_eq!(of(shaft.speed(f64::NAN)), ["member 0: speed is NaN, but must be a finite number"]);
    let with_disc = |disc: Disc<f64>| {
        mistakes(&|frame, [from, to]| {
            frame.member(from, to, shaft);
            let body = frame.body([to], disc);
            frame.name(body, "fan");
        })
    };
    let disc = Disc { mass: 1.0, inertia: 0.1, polar_inertia: 0.2, speed: 30.0 };
    assert_eq!(with_disc(disc), [""; 0]);
    assert_eq!(
        with_disc(Disc { polar_inertia: -1.0, ..disc }),
        ["body \"fan\": polar_inertia is -1, but must be zero or positive, and finite"]
    );
    assert_eq!(
        with_disc(Disc { mass: -1.0, ..disc }),
        ["body \"fan\": mass and inertia must be zero or positive, and finite like the mass centre"]
    );
    // a rotor is not built as a frame that stands, nor in the plane
    let Built { frame, .. } = built(SKETCH);
    let told = frame.build_damped().unwrap_err().to_string();
    assert!(told.contains("member 0: it belongs to a rotor: `build_rotor()` has both whirls"), "{told}");
    let mut plane = Frame::new();
    let [left, right] = [[0.0, 0.0], [1.0, 0.0]].map(|place| plane.point(place));
    plane.member(left, right, shaft.axial_stiffness(1e6));
    plane.hold(left, Support::Fixed);
    assert!(plane.build().unwrap_err().to_string().contains("a beam in the plane has no `polar_inertia_per_length`"));
    let mut space = Frame::new();
    let [left, right] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]].map(|place| space.point(place));
    space.member(left, right, shaft.axial_stiffness(1e6).torsional_stiffness(10.0));
    space.hold(left, Support::Fixed);
    assert!(space.build().unwrap_err().to_string().contains("a beam in space has no `speed`"));
}

/// Shapes at rest, and what is not asked of a rotor itself.
#[test]
fn rotors_at_rest_are_as_those_of_sketches() {
    let mut frame = Frame::new();
    let [left, right] = [0.0, 1.0].map(|x| frame.point(x));
    let section = Section::new().bending_stiffness(40.0).mass_per_length(2.0).rotary_inertia(0.02);
    frame.member(left, right, section.polar_inertia_per_length(0.05).speed(30.0));
    frame.body([left], Disc { mass: 1.0, inertia: 0.05, polar_inertia: 0.08, speed: 30.0 });
    let rotor = frame.build_rotor().unwrap();
    for (whirl, modes) in [(Whirl::Forward, 1), (Whirl::Backward, 2)] {
        let found = rotor.whirl(whirl).first_frequencies::<2>().unwrap();
        assert_eq!((found[0].omega, found[0].multiplicity), (0.0, modes), "{found:?}");
        assert!(matches!(rotor.whirl(whirl).mode_shapes::<2, _>(&found[0]).err(), Some(MotionError::ZeroFrequency)));
    }
    let refused = critical_speeds::<8, _>(0.0..=10.0, Whirl::Forward, 1.0, |_| frame.build_rotor());
    assert!(matches!(refused, Err(SpeedError::Search(SearchError::Zero { .. }))), "{refused:?}");
}
