//! Forces that move along a track: exact values, closed forms of one span, influence lines by hand, axles, free vibrations, bad input.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{assert_close, number, reference};
use core::f64::consts::PI;
use mstmm::frame::{Frame, Line, Member, OfBeam, Point, Section, Structure};
use mstmm::motion::{MotionError, NotATrack, TrackError};
use mstmm::network::Support;
use mstmm::prelude::*;

const EI: f64 = 5e8;
const M: f64 = 1500.0;

system! {
    /// The bridge of the file: spans of 12 and 8 m, and a point 5 m from its begin.
    struct Bridge {}
    section girder { bending_stiffness: 5e8, mass_per_length: 1500.0 }
    pinned at 0.0 -> beam 1 { ..girder } -> conn at_five at 5.0 -> beam 2 { ..girder } -> conn pier at 12.0 -> beam 3 { ..girder } -> conn end at 20.0;
    pinned -> conn pier;
    pinned -> conn end;
}

/// A span of 20 m in three members, with the points of their ends.
fn span() -> (Structure<Line>, [Point<Line>; 4], [Member<OfBeam>; 3]) {
    let mut frame = Frame::new();
    let points = [0.0, 7.0, 10.0, 20.0].map(|place| frame.point(place));
    frame.hold(points[0], Support::Pinned);
    frame.hold(points[3], Support::Pinned);
    let section = Section::new().bending_stiffness(EI).mass_per_length(M);
    let members = [0, 1, 2].map(|k| frame.member(points[k], points[k + 1], section));
    (frame.build().unwrap(), points, members)
}

/// The six times of the file, with 4 modes and with 12.
#[test]
fn the_bridge_of_the_file() {
    let file = reference("moving_load");
    let bridge = Bridge {}.build().unwrap();
    let members = [Bridge::beam_1, Bridge::beam_2, Bridge::beam_3];
    let roots = bridge.first_frequencies::<12>().unwrap();
    for (root, expected) in roots.iter().zip(file["omega"].as_array().unwrap()) {
        assert_close(root.omega, number(expected), 1e-14);
    }
    let rows = file["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 12);
    for row in rows {
        let listed =
            &roots[..row["N"].as_str().map_or_else(|| row["N"].as_u64().unwrap() as usize, |n| n.parse().unwrap())];
        let time = number(&row["t"]);
        for (entry, name) in
            [(Bridge::conn_at_five.displacement_y(), "deflection"), (Bridge::beam_2.output().moment(), "moment")]
        {
            let load = bridge.moving_load::<12, _>(listed, &members, entry).unwrap();
            let crossing = load.with_damping_ratio(0.01).unwrap().at_speed(30.0).unwrap();
            assert_close(1e5 * crossing.after(time), number(&row[name]), 1e-11);
        }
    }
}

/// Frýba's sum for one span: a mode `sin(nπx/l)` under a force at vt, driven by Ω = nπv/l, as a time of `[0, l/v]` has it or the free vibration after.
fn mode_of_span(n: usize, speed: f64, time: f64) -> f64 {
    let (length, n) = (20.0, n as f64);
    let (omega, drive) = ((n * PI / length).powi(2) * (EI / M).sqrt(), n * PI * speed / length);
    let during = |t: f64| {
        if (omega - drive).abs() < 1e-9 * omega {
            return [
                ((omega * t).sin() - omega * t * (omega * t).cos()) / (2.0 * omega * omega),
                t * (omega * t).sin() / 2.0,
            ];
        }
        let factor = 1.0 / (omega * omega - drive * drive);
        [
            factor * ((drive * t).sin() - drive / omega * (omega * t).sin()),
            factor * drive * ((drive * t).cos() - (omega * t).cos()),
        ]
    };
    let end = length / speed;
    if time <= end {
        return during(time)[0];
    }
    let ([q, rate], since) = (during(end), omega * (time - end));
    q * since.cos() + rate / omega * since.sin()
}

/// Closed form, below the critical speed, at that of the first and of the third mode, and above; deflection and moment at the middle.
#[test]
fn one_span_is_the_sum_of_fryba() {
    let (bridge, points, members) = span();
    let roots = bridge.first_frequencies::<4>().unwrap();
    let critical = PI / 20.0 * (EI / M).sqrt();
    for speed in [0.1, 0.5, 1.0, 1.7, 3.0].map(|part| part * critical) {
        for part in [0.02, 0.3, 0.35, 0.5, 0.77, 1.0, 1.01, 1.9, 30.0] {
            let time = part * 20.0 / speed;
            for (entry, is_moment) in [(points[2].displacement_y(), false), (members[1].output().moment(), true)] {
                let load = bridge.moving_load::<4, _>(&roots, &members, entry).unwrap();
                let mut expected = 0.0;
                let x = 20.0 * part.min(2.0 - part);
                if part <= 1.0 {
                    // half of the load at the middle, as a lever has it; the deflection at the middle, of the nearer half
                    let near = x.min(20.0 - x);
                    expected = if is_moment { -near / 2.0 } else { near * (1200.0 - 4.0 * near * near) / 48.0 / EI };
                    assert_close(load.influence(20.0 * part) + 1.0, expected + 1.0, 1e-12);
                }
                let size = load.influence(10.0).abs();
                for n in 1..=4 {
                    let wave = n as f64 * PI / 20.0;
                    let value =
                        2.0 / (M * 20.0) * (wave * 10.0).sin() * if is_moment { -EI * wave * wave } else { 1.0 };
                    let at_rest = if part <= 1.0 { (wave * 20.0 * part).sin() / (wave.powi(4) * EI / M) } else { 0.0 };
                    expected += value * (mode_of_span(n, speed, time) - at_rest);
                }
                let found = load.at_speed(speed).unwrap().after(time);
                assert!((found - expected).abs() < 1e-10 * size, "{speed} {part} {is_moment}: {found} {expected}");
            }
        }
    }
}

/// The largest deflection beside that at rest, which for one mode at the critical speed is π/2 when the force leaves.
#[test]
fn the_first_mode_at_its_critical_speed_is_amplified_by_half_of_pi() {
    let (bridge, points, members) = span();
    let roots = bridge.first_frequencies::<1>().unwrap();
    let load = bridge.moving_load::<1, _>(&roots, &members, points[2].displacement_y()).unwrap();
    let crossing = load.at_speed(PI / 20.0 * (EI / M).sqrt()).unwrap();
    // 2 F l³/(π⁴ EI) is what the mode has at rest
    let at_rest = 2.0 * 20.0_f64.powi(3) / (PI.powi(4) * EI);
    assert_close(crossing.after(crossing.duration()) / at_rest, PI / 2.0, 1e-9);
}

/// A force that creeps has the influence line, whose moment at the pier is that of three moments by Clapeyron, and whose reactions are those of levers.
#[test]
fn a_creeping_force_has_the_influence_line() {
    let bridge = Bridge {}.build().unwrap();
    let members = [Bridge::beam_1, Bridge::beam_2, Bridge::beam_3];
    let roots = bridge.first_frequencies::<3>().unwrap();
    let load = |entry| bridge.moving_load::<3, _>(&roots, &members, entry).unwrap();
    let (moment, reaction) = (load(Bridge::beam_2.output().moment()), load(Bridge::conn_end.reaction_y()));
    let (shear, deflection) = (load(Bridge::beam_1.output().shear()), load(Bridge::conn_at_five.displacement_y()));
    for x in [0.0, 1.0, 4.9, 5.0, 7.3, 12.0, 12.5, 19.0, 20.0] {
        let (own, length) = if x <= 12.0 { (x, 12.0) } else { (20.0 - x, 8.0) };
        let at_pier = own * (length * length - own * own) / (2.0 * length * 20.0);
        // a force upwards is held down
        let at_end = at_pier / 8.0 - if x <= 12.0 { 0.0 } else { (x - 12.0) / 8.0 };
        let at_begin = at_pier / 12.0 - if x <= 12.0 { (12.0 - x) / 12.0 } else { 0.0 };
        // Q = M' before the section at 5 m, before which the force stands or not
        let at_five = at_begin + if x <= 5.0 { 1.0 } else { 0.0 };
        assert!((moment.influence(x) - at_pier).abs() < 1e-11, "{x}: {} {at_pier}", moment.influence(x));
        assert!((reaction.influence(x) - at_end).abs() < 1e-11, "{x}: {} {at_end}", reaction.influence(x));
        assert!((shear.influence(x) - at_five).abs() < 1e-11, "{x}: {} {at_five}", shear.influence(x));
        for load in [&moment, &reaction, &shear, &deflection] {
            let size = (0..=40).map(|k| load.influence(f64::from(k) / 2.0).abs()).fold(0.0, f64::max);
            let crossing = load.with_damping_ratio(0.2).unwrap().at_speed(1e-7).unwrap();
            assert!((crossing.after(x * 1e7) - load.influence(x)).abs() < 1e-7 * size);
            assert_eq!(crossing.influence(x), load.influence(x));
        }
    }
    for (place, point) in [(5.0, Bridge::conn_at_five), (12.0, Bridge::conn_pier), (20.0, Bridge::conn_end)] {
        let at_rest = bridge.frequency_response(point.force_y(), Bridge::conn_at_five.displacement_y()).unwrap();
        assert!((deflection.influence(place) - at_rest.at(0.0).unwrap()).abs() < 1e-20);
    }
    assert_eq!((deflection.influence(-0.1), deflection.influence(20.1)), (0.0, 0.0));
    assert!(deflection.influence(f64::NAN).is_nan());
}

/// A bridge that is turned has the same moments under the same crossing: the force acts across its members.
#[test]
fn a_turned_bridge_is_the_same_bridge() {
    let bridge = Bridge {}.build().unwrap();
    let roots = bridge.first_frequencies::<5>().unwrap();
    let moment = Bridge::beam_2.output().moment();
    let members = [Bridge::beam_1, Bridge::beam_2, Bridge::beam_3];
    let straight = bridge.moving_load::<5, _>(&roots, &members, moment).unwrap().at_speed(30.0).unwrap();
    for [along, across] in [[1.0, 0.0], [0.6, 0.8], [0.0, -1.0], [-1.0, 0.0]] {
        let mut frame = Frame::new();
        let points = [0.0, 5.0, 12.0, 20.0].map(|place| frame.point([along * place, across * place]));
        for held in [0, 2, 3] {
            frame.hold(points[held], Support::Pinned);
        }
        let girder = Section::new().axial_stiffness(1e14).bending_stiffness(EI).mass_per_length(M);
        let members = [0, 1, 2].map(|k| frame.member(points[k], points[k + 1], girder));
        let turned = frame.build().unwrap();
        let roots = turned.first_frequencies::<5>().unwrap();
        let load = turned.moving_load::<5, _>(&roots, &members, members[1].output().moment()).unwrap();
        let crossing = load.at_speed(30.0).unwrap();
        for time in [0.07, 0.3, 0.41, 0.6, 0.9] {
            assert_close(crossing.after(time), straight.after(time), 1e-9);
        }
    }
}

/// Axles are sums of forces, each at its own time, and an envelope is that of samples, with the ends of the crossing among them.
#[test]
fn axles_are_sums() {
    let (bridge, points, members) = span();
    let roots = bridge.first_frequencies::<4>().unwrap();
    let load = bridge.moving_load::<4, _>(&roots, &members, points[2].displacement_y()).unwrap();
    let crossing = load.with_damping_ratios(&[0.01, 0.02, 0.03, 0.04]).unwrap().at_speed(25.0).unwrap();
    let axles = [(0.0, -6e4), (3.6, -11e4), (-2.0, 1e4)];
    for time in [-0.1, 0.05, 0.3, 0.8, 0.9, 2.0] {
        let each = axles.map(|(offset, force)| force * crossing.after(time - offset / 25.0));
        assert_close(crossing.axles(&axles, time) + 1.0, each.iter().sum::<f64>() + 1.0, 1e-15);
    }
    let [begin, end] = [-2.0 / 25.0, (3.6 + 20.0) / 25.0];
    let samples: Vec<f64> =
        (0..=64).map(|k| crossing.axles(&axles, begin + (end - begin) / 64.0 * f64::from(k))).collect();
    let [least, largest] = crossing.envelope(&axles, 64);
    let [low, high] =
        [samples.iter().copied().fold(f64::MAX, f64::min), samples.iter().copied().fold(f64::MIN, f64::max)];
    assert!((least - low).abs() < 1e-9 * -low && (largest - high).abs() < 1e-9 * -low);
    assert!(least < -5e-2 * 1e-1 && largest > 0.0);
    assert_eq!(crossing.envelope(&[], 10), [0.0; 2]);
    assert_eq!(crossing.envelope(&axles, 0), crossing.envelope(&axles, 1));
    assert!(crossing.envelope(&[(f64::NAN, 1.0), (0.0, 1.0)], 8).iter().all(|value| value.is_nan()));
    assert_eq!(crossing.speed(), 25.0);
}

/// Beyond the track modes vibrate freely: one mode decays by `e^{-ζωT}` in a period; before it nothing moves.
#[test]
fn what_has_left_vibrates_freely() {
    let (bridge, points, members) = span();
    let roots = bridge.first_frequencies::<1>().unwrap();
    let load = bridge.moving_load::<1, _>(&roots, &members, points[2].displacement_y()).unwrap();
    let crossing = load.with_damping_ratio(0.05).unwrap().at_speed(60.0).unwrap();
    let period = 2.0 * PI / (roots[0].omega * (1.0 - 0.05_f64.powi(2)).sqrt());
    let [one, next] = [0.4, 0.4 + period].map(|time| crossing.after(time));
    assert_close(next / one, (-0.05 * roots[0].omega * period).exp(), 1e-10);
    assert_eq!((crossing.after(-1e-9), crossing.duration()), (0.0, 1.0 / 3.0));
    assert!(crossing.after(f64::NAN).is_nan());
    // no step where it leaves: both ends are held
    let end = crossing.duration();
    assert!((crossing.after(end * (1.0 + 1e-12)) - crossing.after(end)).abs() < 1e-9 * one.abs());
}

system! {
    /// Members that are no track: askew, tapered, behind a gap; and a stiffer one that is.
    struct Yard { shear: f64 }
    section girder { axial_stiffness: 1e10, bending_stiffness: 5e8, mass_per_length: 1500.0 }
    fixed at (0.0, 0.0) -> beam 1 { ..girder } -> conn b at (5.0, 0.0) -> beam 2 { ..girder } -> conn c at (9.0, 1.0) -> fixed;
    conn b -> beam 3 { ..girder, shear_stiffness: shear } -> conn d at (8.0, 0.0) -> fixed;
    conn c -> beam 4 { ..girder } -> conn e at (9.0, 4.0) -> fixed;
}

system! {
    /// A wedge.
    struct Wedge {}
    fixed at 0.0 -> tapered_beam 1 { bending_stiffness: 3.0, mass_per_length: 2.0, height_taper: 0.5 } -> conn tip at 2.0;
}

system! {
    /// A beam in space.
    struct Boom {}
    fixed at (0.0, 0.0, 0.0) -> beam 1 {
        axial_stiffness: 1e7, bending_stiffness_y: 3e3, bending_stiffness_z: 2e3, torsional_stiffness: 1e3, mass_per_length: 2.0,
        polar_inertia_per_length: 0.01, up: (0.0, 0.0, 1.0)
    } -> conn tip at (2.0, 0.0, 0.0);
}

/// A tapered beam has no wave numbers, and in space a track has two directions across it.
#[test]
fn what_no_load_moves_along_is_refused() {
    let wedge = Wedge {}.build().unwrap();
    let refused =
        wedge.moving_load::<1, _>(&[], &[Wedge::tapered_beam_1], Wedge::conn_tip.displacement_y()).unwrap_err();
    assert_eq!(refused, TrackError::NoWaves { place: 0 });
    assert!(refused.to_string().contains("member 0 of the list has no wave numbers"));
    let boom = Boom {}.build().unwrap();
    let refused = boom.moving_load::<1, _>(&[], &[Boom::beam_1], Boom::conn_tip.displacement_y()).unwrap_err();
    assert_eq!(refused, TrackError::NotATrack { place: 0, reason: NotATrack::NotAcross });
}

/// What is no track, and what is not asked well.
#[test]
fn wrong_tracks_and_questions_are_errors() {
    let yard = Yard { shear: 1e9 }.build().unwrap();
    let roots = yard.first_frequencies::<3>().unwrap();
    let entry = Yard::conn_b.displacement_y();
    let apart = |place| TrackError::NotATrack { place, reason: NotATrack::Apart };
    let of =
        |members: &[mstmm::motion::MemberLabel<_, ()>; 2]| yard.moving_load::<3, _>(&roots, members, entry).map(|_| ());
    let [one, two, three, four] = [
        Yard::beam_1.of_any_type(),
        Yard::beam_2.of_any_type(),
        Yard::beam_3.of_any_type(),
        Yard::beam_4.of_any_type(),
    ];
    assert_eq!(of(&[one, three]), Ok(()));
    assert_eq!(of(&[three, one]), Err(apart(1)));
    assert_eq!(of(&[one, one]), Err(apart(1)));
    assert_eq!(of(&[one, four]), Err(apart(1)));
    assert_eq!(of(&[one, two]), Err(TrackError::NotATrack { place: 1, reason: NotATrack::Turned }));
    assert!(of(&[one, two]).unwrap_err().to_string().contains("another direction"));
    let none: [mstmm::motion::MemberLabel<_, ()>; 0] = [];
    assert_eq!(yard.moving_load::<3, _>(&roots, &none, entry).unwrap_err(), TrackError::NoMembers);
    let few = yard.moving_load::<2, _>(&roots, &[one], entry).unwrap_err();
    assert_eq!(few, TrackError::Motion(MotionError::Capacity { capacity: 2 }));
    let mut wrong = roots[0];
    wrong.omega *= 1.01;
    assert!(matches!(
        yard.moving_load::<2, _>(&[wrong], &[one], entry).unwrap_err(),
        TrackError::Motion(MotionError::NotARoot { .. } | MotionError::Unresolved { .. })
    ));
    wrong.omega = 0.0;
    let at_rest = yard.moving_load::<2, _>(&[wrong], &[one], entry).unwrap_err();
    assert_eq!(at_rest, TrackError::Motion(MotionError::ZeroFrequency));
    let not_held = yard.moving_load::<3, _>(&roots, &[one], Yard::conn_b.reaction_y()).unwrap_err();
    assert!(matches!(not_held, TrackError::Motion(MotionError::NotHeld { .. })));
    let load = yard.moving_load::<3, _>(&roots, &[one], entry).unwrap();
    for speed in [0.0, -3.0, f64::INFINITY] {
        assert_eq!(load.at_speed(speed).unwrap_err(), TrackError::Speed { speed });
    }
    assert!(load.at_speed(f64::NAN).unwrap_err().to_string().contains("NaN m/s"));
    assert_eq!(load.with_damping_ratio(1.0).unwrap_err(), MotionError::DampingRatio { ratio: 1.0 });
    assert_eq!(load.with_damping_ratios(&[0.1]).unwrap_err(), MotionError::DampingRatios { given: 1, needed: 3 });
    // no modes at all: the influence line alone
    let still = yard.moving_load::<0, _>(&[], &[one], entry).unwrap();
    assert_eq!(still.at_speed(2.0).unwrap().after(1.25), still.influence(2.5));
}
