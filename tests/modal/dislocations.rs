//! Dislocations: influence lines, motions of supports, and that each works its internal force.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{self, Cantilever, Portal, assert_close};
use mstmm::Complex;
use mstmm::elements::{Spring, TorsionSpring};
use mstmm::frame::{Frame, Section};
use mstmm::motion::{MotionError, PlaneEntry};
use mstmm::network::Support;
use mstmm::prelude::*;

type C = Complex<f64>;

system! {
    /// Two spans with a cantilevered end and a spring path.
    #[derive(Clone, Copy)]
    struct Spans {}
    fixed -> beam 1 { length: 1.5, bending_stiffness: 3.0, mass_per_length: 0.7 } -> conn a
        -> beam 2 { length: 1.1, bending_stiffness: 2.0, mass_per_length: 0.5, shear_stiffness: 40.0 } -> hinge 3 { stiffness_rz: 1.7 }
        -> beam 4 { length: 0.6, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn b -> pinned;
    fixed -> spring 5 { stiffness: 9.0 } -> mass 6 { mass: 0.2 } -> spring 7 { stiffness: 7.0 } -> conn a;
}

/// Betti: what one load does to the entry that another one works with is what that one does to the entry of the first.
#[test]
fn loads_and_dislocations_of_trees_are_reciprocal() {
    let spans = Spans {}.build().unwrap();
    let points =
        [Spans::beam_1.input(), Spans::conn_a, Spans::beam_2.output(), Spans::hinge_3.output(), Spans::beam_4.output()];
    let mut pairs = Vec::new();
    for (place, point) in points.into_iter().enumerate() {
        pairs.extend([(place, point.kink(), point.moment()), (place, point.slip(), point.shear())]);
        pairs.extend([(place, point.force(), point.deflection()), (place, point.torque(), point.rotation())]);
    }
    let line = [Spans::spring_5.input(), Spans::mass_6.output(), Spans::spring_7.output()];
    for (place, point) in (10..).zip(line) {
        pairs.extend([(place, point.slip(), point.shear()), (place, point.force(), point.deflection())]);
    }
    for lambda in [C::new(0.0, 0.0), C::new(0.0, 1.7), C::new(-0.3, 9.0), C::new(0.2, 60.0)] {
        for (one, other) in pairs.iter().flat_map(|one| pairs.iter().map(move |other| (one, other))) {
            // where a load acts an entry jumps, and has two values
            if one.0 == other.0 {
                continue;
            }
            let at = |load, entry| spans.frequency_response(load, entry).unwrap().at(lambda).unwrap();
            let (found, expected) = (at(one.1, other.2), at(other.1, one.2));
            let size = (at(one.1, one.2).norm() * at(other.1, other.2).norm()).sqrt().max(found.norm());
            assert!((found - expected).norm() <= 1e-12 * size, "{:?} {:?} at {lambda}: {found} {expected}", one, other);
        }
    }
}

/// Beside a root the response of an entry to the load that works with it is the square of the entry, positive below the root.
#[test]
fn dislocations_of_trees_work_internal_forces() {
    let spans = Spans {}.build().unwrap();
    for root in &spans.first_frequencies::<5>().unwrap() {
        let shape = spans.mode_shape(root).unwrap();
        for point in [Spans::conn_a, Spans::beam_1.input(), Spans::beam_4.input()] {
            for (load, entry, state) in [
                (point.kink(), point.moment(), shape.state(point).m),
                (point.slip(), point.shear(), shape.state(point).q),
            ] {
                assert_eq!(shape.work(load).unwrap(), state);
                if state.abs() < 1e-3 {
                    continue;
                }
                let below = root.omega * (1.0 - 1e-10);
                let response = spans.frequency_response(load, entry).unwrap().at(below).unwrap();
                assert_close(response * (root.omega - below) * (root.omega + below), state * state, 1e-4);
            }
        }
    }
    let line = Spans::spring_7.output();
    assert!(spans.frequency_response(line.kink(), line.shear()).is_err());
}

/// A jump at a held end is the motion of the support: of the same model between places, with a support that moves.
#[test]
fn a_slip_at_a_held_end_is_the_motion_of_its_support() {
    let cantilever = Cantilever {}.build().unwrap();
    let (clamp, tip) = (Cantilever::beam_1.input(), Cantilever::conn_tip);
    let (same, [foot, end], _) = models::cantilever();
    for omega in [0.0, 5.0, 20.0, 400.0] {
        let moved = same.frequency_response(foot.motion_y(), end.displacement_y()).unwrap().at(omega).unwrap();
        let slipped = cantilever.frequency_response(clamp.slip(), tip.deflection()).unwrap().at(omega).unwrap();
        assert_close(-slipped, moved, 1e-12);
        let turned = same.frequency_response(foot.motion_z(), end.displacement_y()).unwrap().at(omega).unwrap();
        let kinked = cantilever.frequency_response(clamp.kink(), tip.deflection()).unwrap().at(omega).unwrap();
        assert_close(kinked, turned, 1e-12);
    }
    // as a sum over modes with ratios, which damp relative to the support
    let (roots, same_roots) = (cantilever.first_frequencies::<5>().unwrap(), same.first_frequencies::<5>().unwrap());
    let one = cantilever.modal_response::<5, _>(&roots, clamp.slip(), tip.deflection()).unwrap();
    let other = same.modal_response::<5, _>(&same_roots, foot.motion_y(), end.displacement_y()).unwrap();
    let [one, other] = [one.with_damping_ratio(0.1).unwrap(), other.with_damping_ratio(0.1).unwrap()];
    for omega in [0.0, 5.0, 20.0, 400.0] {
        let lambda = C::new(0.0, omega);
        assert_close(-one.at(lambda).unwrap(), other.at(lambda).unwrap(), 1e-10);
    }
    let ground = cantilever.modal_response::<5, _>(&roots, clamp.slip(), tip.deflection()).unwrap();
    assert!(ground.from_acceleration().is_ok());
}

/// Betti in the plane and in space, with members that stand askew; and that each works its internal force.
#[test]
fn dislocations_of_frames_are_reciprocal_and_work_internal_forces() {
    let portal = Portal {}.build().unwrap();
    let mut pairs = vec![
        (Portal::conn_b.force_x(), Portal::conn_b.displacement_x()),
        (Portal::conn_c.force_y(), Portal::conn_c.displacement_y()),
        (Portal::conn_c.torque_z(), Portal::conn_c.rotation_z()),
    ];
    for end in [Portal::beam_1.input(), Portal::beam_2.input(), Portal::beam_2.output(), Portal::beam_3.input()] {
        pairs.extend([(end.kink(), end.moment()), (end.slip(), end.shear()), (end.stretch(), end.axial_force())]);
    }
    let roots = portal.first_frequencies::<3>().unwrap();
    assert_reciprocal(&portal, &pairs, &[C::new(0.0, 0.0), C::new(0.0, 50.0), C::new(-3.0, 300.0)], 1e-11);
    for root in &roots {
        let shape = portal.mode_shape(root).unwrap();
        for (load, entry) in &pairs {
            let (work, value) = (shape.work(*load).unwrap(), shape.value(*entry).unwrap());
            assert!((work - value).abs() <= 1e-12 * value.abs(), "{work} {value}");
            if value.abs() > 1e-2 {
                let below = root.omega * (1.0 - 1e-9);
                let response = portal.frequency_response(*load, *entry).unwrap().at(below).unwrap();
                let by_root = response * (root.omega.powi(2) - below.powi(2));
                assert!((by_root - value * value).abs() < 1e-2 * value * value, "{by_root} {value} {load:?}");
            }
        }
    }
}

/// A load and the entry that it works with.
type Pair<M> = (PlaneLoad<M>, PlaneEntry<M>);

#[track_caller]
fn assert_reciprocal<Y>(system: &Y, pairs: &[Pair<Y::Model>], at: &[C], tolerance: f64)
where
    Y: FrameAnalysis<Parameter = f64> + mstmm::motion::MovingNetwork<C>,
{
    for lambda in at {
        for (one, other) in pairs.iter().flat_map(|one| pairs.iter().map(move |other| (one, other))) {
            let at = |load, entry| system.frequency_response(load, entry).unwrap().at(*lambda).unwrap();
            let (found, expected) = (at(one.0, other.1), at(other.0, one.1));
            let size = (at(one.0, one.1).norm() * at(other.0, other.1).norm()).sqrt().max(found.norm());
            assert!((found - expected).norm() <= tolerance * size, "{one:?} {other:?} at {lambda}: {found} {expected}");
        }
    }
}

#[test]
fn dislocations_in_space_are_reciprocal() {
    let mut frame = Frame::new();
    let [foot, corner, tip] = [[0.0, 0.0, 0.0], [0.3, 2.0, 0.4], [1.4, 2.5, 1.1]].map(|place| frame.point(place));
    let tube = Section::new()
        .axial_stiffness(600.0)
        .torsional_stiffness(1.3)
        .bending_stiffness_y(2.0)
        .bending_stiffness_z(3.0);
    let tube = tube.mass_per_length(0.9).polar_inertia_per_length(0.01);
    frame.hold(foot, Support::Fixed);
    let first = frame.member(foot, corner, tube);
    let second = frame.member(corner, tip, tube);
    frame.member(tip.along([0.2, 1.0, 0.3]), foot.along([0.2, 1.0, 0.3]), Spring { stiffness: 5.0 });
    frame.member(tip.about([0.2, 1.0, 0.3]), foot.about([0.2, 1.0, 0.3]), TorsionSpring { stiffness: 0.7 });
    let system = frame.build().unwrap();
    let mut pairs = vec![(tip.force_z(), tip.displacement_z()), (corner.force_x(), corner.displacement_x())];
    for end in [first.input(), second.input(), second.output()] {
        pairs.extend([(end.kink(), end.moment()), (end.slip(), end.shear()), (end.stretch(), end.axial_force())]);
        pairs.extend([(end.kink_y(), end.moment_y()), (end.slip_z(), end.shear_z()), (end.twist(), end.torque())]);
    }
    assert_reciprocal(&system, &pairs, &[C::new(0.0, 0.0), C::new(0.0, 1.3), C::new(-0.3, 30.0)], 1e-11);
    let root = system.first_frequencies::<1>().unwrap()[0];
    let shape = system.mode_shape(&root).unwrap();
    for (load, entry) in pairs {
        assert_close(shape.work(load).unwrap(), shape.value(entry).unwrap(), 1e-12);
    }
}

/// At rest the motion under a kink is the influence line of the moment: of the middle support of two equal spans `-x (l² - x²)/(4 l²)`.
#[test]
fn a_kink_at_rest_has_the_influence_line() {
    let mut frame = Frame::new();
    let (l, cuts) = (2.0, [0.0, 0.5, 1.3, 2.0, 4.0]);
    let points = cuts.map(|x| frame.point([x, 0.0]));
    let steel = Section::new().axial_stiffness(1e3).bending_stiffness(5.0).mass_per_length(1.0);
    let members: Vec<_> = points.windows(2).map(|pair| frame.member(pair[0], pair[1], steel)).collect();
    frame.hold(points[0], Support::Pinned);
    frame.hold(points[3], Support::Roller);
    frame.hold(points[4], Support::Roller);
    let beam = frame.build().unwrap();
    let kink = members[3].input().kink();
    for (x, point) in cuts.into_iter().zip(points).take(3) {
        let line = beam.frequency_response(kink, point.displacement_y()).unwrap().at(0.0).unwrap();
        // a load downwards bends the beam up over the support
        let expected = x * (l * l - x * x) / (4.0 * l * l);
        assert!((line.abs() - expected).abs() < 1e-13, "{x}: {line} {expected}");
        let moment = beam.frequency_response(point.force_y(), members[3].input().moment()).unwrap().at(0.0).unwrap();
        assert!((line - moment).abs() < 1e-13);
    }
    let other = Portal::beam_1.input().kink();
    let missing = mstmm::motion::MemberLabel::<Portal, ()>::member(9).input().kink();
    let portal = Portal {}.build().unwrap();
    assert!(portal.frequency_response(other, Portal::conn_b.displacement_x()).is_ok());
    let refused = portal.frequency_response(missing, Portal::conn_b.displacement_x()).map(|_| ());
    assert_eq!(refused, Err(MotionError::NoSuchPoint { index: 9 }));
}
