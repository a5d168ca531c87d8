//! Accelerations of the ground and of supports, rates, and what begins under a load.

use crate::models::{Cantilever, Portal, assert_close, number, oscillator, reference};
use mstmm::Complex;
use mstmm::elements::{Damper, Spring};
use mstmm::frame::{Frame, Section};
use mstmm::motion::MotionError;
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;

type C = Complex<f64>;

/// A record on the cantilever: deflection, velocity, absolute acceleration and moment at the clamp as the file has them.
#[test]
fn a_record_moves_the_cantilever_as_the_file_says() {
    let part = reference("base_acceleration");
    let numbers = |name: &str| -> Vec<f64> { part[name].as_array().unwrap().iter().map(number).collect() };
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<4>().unwrap();
    let ground = Load::base_acceleration(Direction::y());
    let of = |entry| {
        let response = cantilever.modal_response::<4, _>(&roots, ground, entry).unwrap();
        response.with_damping_ratios(&numbers("ratios")).unwrap()
    };
    let (tip, moment) = (of(Cantilever::conn_tip.deflection()), of(Cantilever::beam_1.input().moment()));
    let dt = number(&part["dt"]);
    let mut histories = [tip, tip.absolute().unwrap(), moment].map(|response| response.history(dt).unwrap());
    let mut accelerations = tip.absolute().unwrap().acceleration().unwrap().history(dt).unwrap();
    let (record, rows) = (numbers("a_g"), part["rows"].as_array().unwrap().clone());
    assert_eq!(record.len(), rows.len());
    for (sample, row) in record.iter().zip(&rows) {
        let [relative, absolute, moment] = histories.each_mut().map(|history| history.next_motion(*sample));
        let close = |found: f64, name: &str, size: f64| {
            let error = (found - number(&row[name])).abs();
            assert!(error < 1e-13 * size, "{name}: {found} instead of {}", row[name]);
        };
        close(relative.value, "relative_deflection", 3e-3);
        close(relative.rate, "relative_velocity", 0.06);
        close(absolute.acceleration, "absolute_acceleration", 3.0);
        close(moment.value.abs() * number(&row["base_moment"]).signum(), "base_moment", 2.0);
        // the same by the response of the acceleration; the ground moves as its acceleration integrated twice
        close(accelerations.next(*sample), "absolute_acceleration", 3.0);
        assert!((absolute.acceleration - relative.acceleration - sample).abs() < 1e-13);
    }
    assert_eq!(
        cantilever
            .modal_response::<4, _>(&roots, Load::self_weight(), Cantilever::conn_tip.deflection())
            .unwrap()
            .absolute()
            .unwrap_err(),
        MotionError::NotOfGround
    );
    // internal forces have no part of the ground
    assert_eq!(moment.absolute().unwrap().to_step(0.3), moment.to_step(0.3));
}

#[test]
fn a_force_that_is_taken_away_releases_the_cantilever() {
    let part = reference("release");
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<4>().unwrap();
    let tip = Cantilever::conn_tip;
    let response = cantilever.modal_response::<4, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let response = response.with_damping_ratios(&[0.02, 0.015, 0.03, 0.04]).unwrap();
    let force = number(&part["force"]);
    let rows: Vec<f64> = part["rows"].as_array().unwrap().iter().map(|row| number(&row["deflection"])).collect();
    assert_close(response.static_value().unwrap() * force, rows[0], 1e-14);
    for (time, row) in [0.01, 0.05, 0.3].into_iter().zip(&rows[1..]) {
        assert_close(force * response.to_release(time).unwrap(), *row, 1e-13);
    }
    assert_eq!(response.to_release(-1.0), response.static_value());
    // sample by sample: at rest under the force, and released by a sample of zero
    let mut history = response.history(0.01).unwrap().under(force).unwrap();
    assert_close(history.next(force), rows[0], 1e-14);
    assert_close(history.next(force), rows[0], 1e-13);
    let mut released = response.history(0.01).unwrap().under(force).unwrap();
    assert_close(released.next(0.0) + force * response.to_step(0.0), rows[0], 1e-13);
    for step in 1..40 {
        let time = 0.01 * f64::from(step);
        let expected = force * response.to_release(time).unwrap();
        assert!((released.next(0.0) - expected).abs() < 1e-12 * rows[0], "{time}");
    }
}

/// The ground under all supports moves them as one support would: exactly, of the same frame with one foot.
#[test]
fn an_acceleration_of_the_ground_is_that_of_the_only_support() {
    let mut frame = Frame::new();
    let [foot, corner, tip] = [[0.0, 0.0], [0.0, 2.0], [1.0, 2.5]].map(|place| frame.point(place));
    let steel =
        Section::new().axial_stiffness(4e6).bending_stiffness(1e4).mass_per_length(20.0).kelvin_voigt_time(1e-4);
    frame.hold(foot, Support::Fixed);
    frame.member(foot, corner, steel);
    frame.member(corner, tip, steel);
    frame.mass(tip, 30.0);
    let crane = frame.build_damped().unwrap();
    let pairs = [
        (Direction::x(), foot.motion_x(), tip.displacement_x(), 1.0),
        (Direction::y(), foot.motion_y(), tip.displacement_x(), 0.0),
        (Direction::y(), foot.motion_y(), corner.displacement_y(), 1.0),
    ];
    for (direction, motion, entry, along) in pairs {
        let relative = crane.frequency_response(PlaneLoad::base_acceleration(direction), entry).unwrap();
        let moved = crane.frequency_response(motion, entry).unwrap();
        for lambda in [C::new(0.0, 3.0), C::new(-1.0, 20.0), C::new(0.5, 140.0)] {
            let square = lambda * lambda;
            let expected = moved.at(lambda).unwrap() - along;
            assert_close(relative.at(lambda).unwrap() * square, expected, 1e-11);
        }
    }
    // as sums over modes, with ratios, from the acceleration of the support
    let still = Section::new().axial_stiffness(4e6).bending_stiffness(1e4).mass_per_length(20.0);
    let mut frame = Frame::new();
    let [foot, tip] = [[0.0, 0.0], [0.0, 2.0]].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.member(foot, tip, still);
    let mast = frame.build().unwrap();
    let roots = mast.first_frequencies::<6>().unwrap();
    let entry = tip.displacement_x();
    let ratios = [0.02, 0.1, 0.03, 0.0, 0.01, 0.3];
    let sum = |load| mast.modal_response::<8, _>(&roots, load, entry).unwrap().with_damping_ratios(&ratios).unwrap();
    let by_ground = sum(PlaneLoad::base_acceleration(Direction::x())).absolute().unwrap();
    let by_support = sum(foot.motion_x()).from_acceleration().unwrap();
    let (mut one, mut other) = (by_ground.history(0.01).unwrap(), by_support.history(0.01).unwrap());
    let residual = by_ground.to_step(0.0);
    for sample in [0.0, 1.0, 2.0, -3.0, 0.5, 0.0, 0.0, 1.5] {
        let (one, other) = (one.next_motion(sample), other.next_motion(sample));
        assert!((one.value - residual * sample - other.value).abs() < 1e-14);
        assert!((one.acceleration - other.acceleration).abs() < 1e-10);
    }
    let forced = sum(tip.force_x());
    assert_eq!(forced.from_acceleration().unwrap_err(), MotionError::NoSupportMotion);
    assert_eq!(sum(foot.motion_x()).acceleration().unwrap_err(), MotionError::AtOnce);
}

/// One mass on a spring and a dashpot to a foot that shakes: `(1 + 2iζx)/(1 - x² + 2iζx)` in space, and the acceleration by the square of λ.
#[test]
fn one_mass_on_a_foot_that_shakes() {
    let (k, m, ratio) = (900.0, 4.0, 0.05);
    let (mut frame, [foot, mass]) = oscillator(k, m);
    let system = frame.build().unwrap();
    let roots = system.first_frequencies::<1>().unwrap();
    let ground = PlaneLoad::base_acceleration(Direction::x());
    let response = system.modal_response::<2, _>(&roots, ground, mass.displacement_x()).unwrap();
    let damped = response.with_damping_ratio(ratio).unwrap();
    let omega = (k / m).sqrt();
    for x in [0.1, 0.9, 1.0, 1.1, 4.0] {
        let lambda = C::new(0.0, x * omega);
        let drag = C::new(0.0, 2.0 * ratio * x);
        let below = drag + (1.0 - x * x);
        assert_close(damped.at(lambda).unwrap(), -1.0 / (below * omega * omega), 1e-13);
        let absolute = damped.absolute().unwrap();
        assert_close(absolute.at(lambda).unwrap() * lambda * lambda, (drag + 1.0) / below, 1e-12);
        assert_close(absolute.acceleration().unwrap().at(lambda).unwrap(), (drag + 1.0) / below, 1e-12);
        assert_close(damped.rate().unwrap().at(lambda).unwrap(), -lambda / (below * omega * omega), 1e-12);
        assert_close(absolute.rate().unwrap().at(lambda).unwrap() * lambda, (drag + 1.0) / below, 1e-12);
    }
    // with a dashpot beside the spring instead of a ratio
    frame.member(foot.along([1.0, 0.0]), mass.along([1.0, 0.0]), Damper { damping: 2.0 * ratio * (k * m).sqrt() });
    let dashpot = frame.build_damped().unwrap();
    let eigenvalues = dashpot.first_eigenvalues::<1>().unwrap();
    let by_dashpot = dashpot.modal_response::<2, _>(&eigenvalues, ground, mass.displacement_x()).unwrap();
    let motion = dashpot.modal_response::<4, _>(&eigenvalues, foot.motion_x(), mass.displacement_x()).unwrap();
    let (mut one, mut other) = (damped.history(0.02).unwrap(), by_dashpot.history(0.02).unwrap());
    let mut third = motion.from_acceleration().unwrap().history(0.02).unwrap();
    let mut absolute = damped.absolute().unwrap().history(0.02).unwrap();
    for sample in [1.0, -2.0, 0.3, 4.0, 0.0] {
        let (one, other) = (one.next_motion(sample), other.next_motion(sample));
        assert!((one.value - other.value).abs() < 1e-14 && (one.rate - other.rate).abs() < 1e-13);
        assert!((one.acceleration - other.acceleration).abs() < 1e-12);
        let (absolute, third) = (absolute.next_motion(sample), third.next_motion(sample));
        assert!((absolute.value - third.value).abs() < 1e-13, "{absolute:?} {third:?}");
        assert!((absolute.rate - third.rate).abs() < 1e-12, "{absolute:?} {third:?}");
    }
}

/// A frame on two supports, of which none moves beside the other: reactions of the feet under a slow acceleration are those of the weight.
#[test]
fn slow_accelerations_are_weights() {
    let portal = Portal {}.build().unwrap();
    for (direction, weight) in
        [(Direction::x(), PlaneLoad::self_weight_x()), (Direction::y(), PlaneLoad::self_weight_y())]
    {
        for entry in [Portal::conn_a.reaction_x(), Portal::conn_b.displacement_x(), Portal::beam_2.input().moment()] {
            let at = |load, omega| portal.frequency_response(load, entry).unwrap().at(omega).unwrap();
            for omega in [0.0, 30.0] {
                assert_eq!(at(PlaneLoad::base_acceleration(direction), omega), -at(weight, omega));
            }
        }
    }
    let cantilever = Cantilever {}.build().unwrap();
    let tip = Cantilever::conn_tip.deflection();
    let exact = |load| cantilever.frequency_response(load, tip).unwrap().at(12.0).unwrap();
    assert_eq!(exact(Load::base_acceleration(Direction::y())), -exact(Load::self_weight()));
    let along = cantilever.frequency_response(Load::base_acceleration(Direction::x()), tip).unwrap();
    assert_eq!(along.at(12.0), Err(MotionError::NoSuchFreedom { freedom: Freedoms::X }));
}

/// A dashpot that is not on the foot that moves: closed form `k/(mλ² + cλ + k)`, by the motion of the foot and by its acceleration.
#[test]
fn a_dashpot_beside_the_foot_that_moves() {
    let (k, c, m) = (900.0, 30.0, 4.0);
    let (mut frame, [foot, mass]) = oscillator(k, m);
    let other = frame.point([2.0, 0.0]);
    frame.hold(other, Support::Fixed);
    frame.member(mass.along([1.0, 0.0]), other.along([1.0, 0.0]), Damper { damping: c });
    let system = frame.build_damped().unwrap();
    let eigenvalues = system.first_eigenvalues::<1>().unwrap();
    let motion = system.modal_response::<4, _>(&eigenvalues, foot.motion_x(), mass.displacement_x()).unwrap();
    let by_acceleration = motion.from_acceleration().unwrap();
    for omega in [0.5, 15.0, 40.0] {
        let lambda = C::new(0.0, omega);
        let expected = k / (m * lambda * lambda + c * lambda + k);
        assert_close(motion.at(lambda).unwrap(), expected, 1e-13);
        assert_close(by_acceleration.at(lambda).unwrap() * lambda * lambda, expected, 1e-12);
        assert_close(motion.rate().unwrap().at(lambda).unwrap(), lambda * expected, 1e-13);
    }
    // long after a pulse the foot has a speed, behind which the mass stays by that of the dashpot over the spring
    let mut history = by_acceleration.history(0.05).unwrap();
    let mut last = 0.0;
    for step in 0..=400 {
        last = history.next(if step <= 20 { 1.0 - (f64::from(step) - 10.0).abs() / 10.0 } else { 0.0 });
    }
    let (speed, gone) = (0.5, 0.5 * (20.0 - 0.5));
    assert!((last - (gone - c / k * speed)).abs() < 1e-12, "{last}");
}

/// A point without mass between a spring and a dashpot: its velocity follows a force at once, and its acceleration the rate of the force.
#[test]
fn a_point_without_mass_on_a_dashpot() {
    let (k, c) = (50.0, 4.0);
    let mut frame = Frame::new();
    let [foot, point, mass] = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    let along = |point: mstmm::frame::Point<mstmm::frame::Plane>| point.along([1.0, 0.0]);
    frame.member(along(foot), along(point), Spring { stiffness: k });
    frame.member(along(point), along(mass), Damper { damping: c });
    frame.member(along(mass), along(foot), Spring { stiffness: 2.0 * k });
    frame.mass(mass, 1.5);
    for point in [point, mass] {
        frame.hold(point, Freedoms::Y);
    }
    let system = frame.build_damped().unwrap();
    let eigenvalues = system.first_eigenvalues::<2>().unwrap();
    let response = system.modal_response::<4, _>(&eigenvalues, point.force_x(), point.displacement_x()).unwrap();
    let (rate, acceleration) = (response.rate().unwrap(), response.acceleration().unwrap());
    for omega in [0.3, 2.0, 20.0] {
        let lambda = C::new(0.0, omega);
        let drag = c * lambda;
        let below = 1.5 * lambda * lambda + 2.0 * k + drag;
        let expected = below / ((k + drag) * below - drag * drag);
        assert_close(response.at(lambda).unwrap(), expected, 1e-12);
        assert_close(rate.at(lambda).unwrap(), lambda * expected, 1e-12);
        assert_close(acceleration.at(lambda).unwrap(), lambda * lambda * expected, 1e-11);
    }
    let (mut whole, mut of_rate, mut of_acceleration) =
        (response.history(0.03).unwrap(), rate.history(0.03).unwrap(), acceleration.history(0.03).unwrap());
    for sample in [0.0, 1.0, 3.0, -2.0, 0.0, 0.5] {
        let motion = whole.next_motion(sample);
        assert!((motion.rate - of_rate.next(sample)).abs() < 1e-13);
        assert!((motion.acceleration - of_acceleration.next(sample)).abs() < 1e-11);
    }
    // the rate of a mass that a dashpot alone holds: 1/c under a constant force
    let mut frame = Frame::new();
    let [foot, mass] = [[0.0, 0.0], [1.0, 0.0]].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.member(along(foot), along(mass), Damper { damping: c });
    frame.mass(mass, 3.0);
    frame.hold(mass, Freedoms::Y);
    let dragged = frame.build_damped().unwrap();
    let eigenvalues = dragged.first_eigenvalues::<2>().unwrap();
    let response = dragged.modal_response::<4, _>(&eigenvalues, mass.force_x(), mass.displacement_x()).unwrap();
    let rate = response.rate().unwrap();
    assert_close(rate.static_value().unwrap(), 1.0 / c, 1e-12);
    assert_close(rate.at(C::new(0.0, 0.7)).unwrap(), 1.0 / C::new(c, 3.0 * 0.7), 1e-12);
}

#[test]
fn damping_comes_before_rates() {
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let tip = Cantilever::conn_tip;
    let response = cantilever.modal_response::<4, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let damping = mstmm::search::ProportionalDamping::new(0.3, 1e-3, 0.0).unwrap();
    for derived in [response.rate().unwrap(), response.acceleration().unwrap()] {
        assert_eq!(derived.with_damping_ratio(0.1).unwrap_err(), MotionError::Derived);
        assert_eq!(derived.with_damping(&damping).unwrap_err(), MotionError::Derived);
    }
    let slipped =
        cantilever.modal_response::<4, _>(&roots, Cantilever::beam_1.input().slip(), tip.deflection()).unwrap();
    assert_eq!(slipped.from_acceleration().unwrap().with_damping(&damping).unwrap_err(), MotionError::Derived);
    // in this order it is the derivative of the damped response
    let damped = response.with_damping(&damping).unwrap();
    let lambda = C::new(0.0, 30.0);
    let late = damped.rate().unwrap().at(lambda).unwrap() - lambda * damped.at(lambda).unwrap();
    assert!(late.norm() < 1e-3 * damped.at(lambda).unwrap().norm() * 30.0, "{late}");
}
