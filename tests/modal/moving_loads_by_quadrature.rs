//! Forces that move along beams of all parameters, strings and floors of springs, against the quadrature of each mode.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use mstmm::elements::Spring;
use mstmm::frame::{Frame, Ground, Section, TautString};
use mstmm::motion::{MemberLabel, MovingNetwork, PlaneEntry, TrackError};
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;
use mstmm::search::NaturalFrequency;

/// Pieces of a member in which Gauss's rule integrates.
const PIECES: u32 = 200;

/// Places and weights of Gauss's rule of five points on `[-1, 1]`.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// A mode of a ratio under a function of time, by Duhamel's integral in parts that are smooth.
fn duhamel(omega: f64, ratio: f64, time: f64, parts: &[[f64; 2]], force: impl Fn(usize, f64) -> f64) -> f64 {
    let damped = omega * (1.0 - ratio * ratio).sqrt();
    let mut sum = 0.0;
    for (part, [begin, end]) in parts.iter().enumerate() {
        let half = 0.5 * (end.min(time) - begin) / f64::from(PIECES);
        // a part that the force has not reached
        if half <= 0.0 {
            continue;
        }
        for piece in 0..PIECES {
            for (place, weight) in GAUSS {
                let at = begin + half * (f64::from(2 * piece + 1) + place);
                let back = time - at;
                sum += half * weight * force(part, at) * (-ratio * omega * back).exp() * (damped * back).sin() / damped;
            }
        }
    }
    sum
}

/// A load and the entry that it works with.
type Pair<M> = (PlaneLoad<M>, PlaneEntry<M>);

/// Compares a crossing with the quadrature of its modes, beside influence lines as motions under the loads that work with the entries.
#[track_caller]
fn assert_crossing<Y, E, const M: usize>(
    system: &Y,
    roots: &[NaturalFrequency],
    (members, lengths): ([MemberLabel<Y::Model, E>; M], [f64; M]),
    pairs: &[Pair<Y::Model>],
    speed: f64,
) where
    Y: FrameAnalysis<Parameter = f64> + MovingNetwork<f64>,
{
    let (ratio, mut begin) = (0.02, 0.0);
    let parts = lengths.map(|length| {
        let own = begin / speed;
        begin += length;
        [own, begin / speed]
    });
    let mut shapes = Vec::new();
    for root in roots {
        let all = system.mode_shapes::<4, f64>(root).unwrap();
        shapes.extend(all.iter().map(|shape| (root.omega, shape.clone())));
    }
    for share in [0.03, 0.31, 0.72, 1.0, 1.4] {
        let time = share * begin / speed;
        let on = parts.iter().position(|part| time <= part[1]);
        let on = on.map(|on| (members[on], ((time - parts[on][0]) * speed).min(lengths[on])));
        // each mode, less what it has at rest
        let of_modes: Vec<_> = shapes
            .iter()
            .map(|(omega, shape)| {
                let across = |part: usize, at: f64| {
                    let x = ((at - parts[part][0]) * speed).clamp(0.0, lengths[part]);
                    shape.along(members[part], x).unwrap().displacement_y
                };
                let followed = on.map_or(0.0, |(on, x)| shape.along(on, x).unwrap().displacement_y / (omega * omega));
                duhamel(*omega, ratio, time, &parts, across) - followed
            })
            .collect();
        for (load, entry) in pairs {
            let crossing = system.moving_load::<12, M>(roots, &members, *entry).unwrap();
            let crossing = crossing.with_damping_ratio(ratio).unwrap().at_speed(speed).unwrap();
            let at_rest = system.frequency_response(*load, *entry).unwrap().states(0.0).unwrap();
            let size = (1..32).map(|k| crossing.influence(begin * f64::from(k) / 32.0).abs()).fold(0.0, f64::max);
            let mut expected = on.map_or(0.0, |(on, x)| at_rest.along(on, x).unwrap().displacement_y);
            for ((_, shape), own) in shapes.iter().zip(&of_modes) {
                expected += shape.value(*entry).unwrap() * own;
            }
            let found = crossing.after(time);
            assert!((found - expected).abs() < 1e-10 * size, "{speed} m/s, {share}: {found} {expected} of {size}");
        }
    }
}

/// Two spans of a section with damping, for a deflection and for the moment at the pier.
#[track_caller]
fn assert_two_spans(section: Section, speeds: &[f64]) {
    let mut frame = Frame::new();
    let points = [0.0, 4.0, 12.0, 20.0].map(|place| frame.point(place));
    for held in [0, 2, 3] {
        frame.hold(points[held], Support::Pinned);
    }
    let members = [0, 1, 2].map(|k| frame.member(points[k], points[k + 1], section));
    let bridge = frame.build().unwrap();
    let roots = bridge.first_frequencies::<6>().unwrap();
    let pier = members[1].output();
    for speed in speeds {
        let track = (members, [4.0, 8.0, 8.0]);
        let pairs = [(points[1].force_y(), points[1].displacement_y()), (pier.kink(), pier.moment())];
        assert_crossing(&bridge, &roots, track, &pairs, *speed);
    }
}

#[test]
fn two_spans_of_all_kinds_of_beams() {
    let plain = Section::new().bending_stiffness(5e8).mass_per_length(1500.0);
    assert_two_spans(plain, &[30.0, 400.0]);
    assert_two_spans(plain.shear_stiffness(3e7).rotary_inertia(2500.0), &[30.0]);
    assert_two_spans(plain.axial_force(6e7), &[30.0]);
    assert_two_spans(plain.axial_force(-2e7).rotary_inertia(900.0), &[30.0]);
    assert_two_spans(plain.foundation_stiffness(4e6), &[30.0]);
    assert_two_spans(plain.foundation_stiffness(4e8).foundation_shear_stiffness(1e7), &[30.0]);
    assert_two_spans(plain.foundation_stiffness(4e6).axial_force(-3e7).shear_stiffness(1e9), &[30.0]);
}

/// A beam that floats on springs all along: its first two modes are those of a rigid body, where all wave numbers vanish at one frequency.
#[test]
fn a_beam_that_floats() {
    let mut frame = Frame::new();
    let points = [0.0, 6.0, 15.0].map(|place| frame.point(place));
    let section = Section::new().bending_stiffness(2e7).mass_per_length(800.0).foundation_stiffness(3e6);
    let members = [0, 1].map(|k| frame.member(points[k], points[k + 1], section));
    let floor = frame.build().unwrap();
    let roots = floor.first_frequencies::<4>().unwrap();
    assert!((roots[0].omega - (3e6_f64 / 800.0).sqrt()).abs() < 1e-9);
    for speed in [10.0, 90.0] {
        let pairs = [(points[1].force_y(), points[1].displacement_y())];
        assert_crossing(&floor, &roots, (members, [6.0, 9.0]), &pairs, speed);
    }
}

/// A strong tension on soft springs: beside a short wave the other pair is as long as nothing, and in higher modes it is not.
#[test]
fn a_taut_strip_on_soft_springs() {
    let mut frame = Frame::new();
    let points = [0.0, 2.0, 5.0].map(|place| frame.point(place));
    for end in [0, 2] {
        frame.member(points[end], Ground, Spring { stiffness: 2e3 });
    }
    let section = Section::new().bending_stiffness(50.0).mass_per_length(3.0).axial_force(4e4);
    let members = [0, 1].map(|k| frame.member(points[k], points[k + 1], section));
    let strip = frame.build().unwrap();
    let roots = strip.first_frequencies::<5>().unwrap();
    for speed in [2.0, 60.0] {
        let pairs = [(points[1].force_y(), points[1].displacement_y())];
        assert_crossing(&strip, &roots, (members, [2.0, 3.0]), &pairs, speed);
    }
}

/// A string of the plane, along which a force moves slower and faster than its waves.
#[test]
fn a_string() {
    let mut frame = Frame::new();
    let points = [[0.0, 0.0], [2.0, 0.0], [5.0, 0.0]].map(|place| frame.point(place));
    frame.hold(points[0], Support::Pinned);
    frame.hold(points[2], Support::Pinned);
    frame.hold(points[1], Freedoms::X);
    let wire = Section::new().tension(5e3).axial_stiffness(2e9).mass_per_length(2.0);
    let members = [0, 1].map(|k| frame.member(points[k], points[k + 1], TautString(wire)));
    let string = frame.build().unwrap();
    let roots = string.first_frequencies::<5>().unwrap();
    for speed in [5.0, 30.0, 80.0] {
        let pairs = [(points[1].force_y(), points[1].displacement_y())];
        assert_crossing(&string, &roots, (members, [2.0, 3.0]), &pairs, speed);
    }
}

/// A tension beside a foundation whose wave numbers coincide at rest is refused, and one beside it is not.
#[test]
fn wave_numbers_that_coincide_are_refused() {
    let load = |factor: f64| {
        let mut frame = Frame::new();
        let [left, right] = [0.0, 30.0].map(|place| frame.point(place));
        frame.hold(left, Support::Pinned);
        frame.hold(right, Support::Pinned);
        let tension = factor * 2.0 * (1e5_f64 * 4e4).sqrt();
        let section = Section::new().bending_stiffness(4e4).mass_per_length(20.0).foundation_stiffness(1e5);
        let beam = frame.member(left, right, section.axial_force(tension));
        let beams = frame.build().unwrap();
        let roots = beams.first_frequencies::<2>().unwrap();
        beams.moving_load::<2, _>(&roots, &[beam], right.rotation_z()).map(|load| load.influence(29.0))
    };
    let refused = load(1.0).unwrap_err();
    assert_eq!(refused, TrackError::Coincide { place: 0, frequency: 0.0 });
    assert!(refused.to_string().contains("member 0 of the list coincide at 0 rad/s"));
    // on both sides it is a smooth function of the tension
    let [below, above] = [0.99, 1.01].map(|factor| load(factor).unwrap());
    assert!((below / above - 1.0).abs() < 0.02 && below != above);
}
