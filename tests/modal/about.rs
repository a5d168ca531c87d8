//! Participation about axes: values of the file, the moments of reactions, what is refused.

use crate::models::{Cantilever, Portal, assert_close, cantilever, number, reference};
use crate::random;
use mstmm::frame::{Frame, Section, Space};
use mstmm::motion::{MotionError, PlaneEntry};
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;

#[test]
fn inertias_about_points_are_those_of_the_file() {
    let part = reference("participation")["portal"].clone();
    let portal = Portal {}.build().unwrap();
    let roots = portal.first_frequencies::<6>().unwrap();
    let participation = portal.participation::<6, _>(&roots, Direction::about([0.0, 0.0])).unwrap();
    assert_close(participation.total(), number(&part["moving_inertia_about_origin"]), 1e-15);
    for (mode, known) in part["modes"].as_array().unwrap().iter().take(6).enumerate() {
        assert_close(participation.effective_mass(mode), number(&known["effective_inertia_rz_about_A"]), 1e-11);
    }
    assert_close(participation.missing(), number(&part["missing_rz_after_6"]), 1e-12);
    let factors = portal.participations(&roots, Direction::about([0.0, 0.0])).unwrap();
    assert_eq!(factors, participation.factors());

    let part = reference("participation")["cantilever"].clone();
    let (line, ..) = cantilever();
    let roots = line.first_frequencies::<3>().unwrap();
    let participation = line.participation::<3, _>(&roots, Direction::about(0.0)).unwrap();
    assert_close(participation.total(), number(&part["moving_inertia_about_clamp"]), 1e-15);
    for (mode, known) in part["modes"].as_array().unwrap().iter().take(3).enumerate() {
        assert_close(participation.effective_mass(mode), number(&known["effective_inertia_about_clamp"]), 1e-11);
    }
}

/// The law of momentum: what a mode has of it about a point, times ω², is the moment of its reactions about that, with the other sign.
#[test]
fn momentum_about_a_point_is_the_moment_of_reactions() {
    let mut tried = 0;
    for seed in 0..50 {
        let random::RandomFrame { frame, points, members } = random::frame(seed, 0.0, || 0.0);
        let system = frame.build().unwrap();
        // a spring that acts in a direction of its own is no pair of forces along one line
        if system.sketch().members().count() > members.len() {
            continue;
        }
        let places: Vec<[f64; 3]> = system.sketch().points().map(|point| point.position).collect();
        let roots = system.frequencies(6).unwrap();
        let about = [0.7, -1.3];
        let factors = system.participations(&roots, Direction::about(about)).unwrap();
        for factor in factors {
            let root = &roots[factor.root];
            if root.multiplicity > 1 {
                continue;
            }
            let shape = system.mode_shape(root).unwrap();
            let value = |entry: PlaneEntry<_>| match shape.value(entry) {
                Err(MotionError::NotHeld { .. }) => 0.0,
                value => value.unwrap(),
            };
            let mut moments = (0.0, 0.0);
            for (point, place) in points.iter().zip(&places) {
                let [x, y] = [place[0] - about[0], place[1] - about[1]];
                let parts = [x * value(point.reaction_y()), -y * value(point.reaction_x()), value(point.reaction_z())];
                moments.0 += parts.iter().sum::<f64>();
                moments.1 += parts.iter().map(|part| part.abs()).sum::<f64>();
            }
            let rate = -root.omega * root.omega * factor.value;
            assert!((rate - moments.0).abs() < 1e-9 * moments.1, "{seed}: {rate} {}", moments.0);
            tried += 1;
        }
    }
    assert!(tried > 120, "{tried}");
}

/// In space a mast that is bent in both planes and twisted has the inertia of its mass about each axis, and that of its section about its own.
#[test]
fn masts_in_space_turn_about_each_axis() {
    let mut frame = Frame::<Space>::new();
    let [foot, top] = [[1.0, 2.0, 0.0], [1.0, 2.0, 4.0]].map(|place| frame.point(place));
    let mast = Section::new()
        .axial_stiffness(1e8)
        .bending_stiffness(1e6)
        .mass_per_length(3.0)
        .rotary_inertia(0.2)
        .torsional_stiffness(1e5)
        .polar_inertia_per_length(0.5);
    frame.member(foot, top, mast);
    frame.hold(foot, Support::Fixed);
    let system = frame.build().unwrap();
    let about = |direction| system.moving_mass(direction).unwrap();
    // about x and y through the foot: m l³/3 and ρI l; through the origin with the masses beside them
    assert_close(about(Direction::about_x([1.0, 2.0, 0.0])), 64.0 + 0.8, 1e-14);
    assert_close(about(Direction::about_y([0.0, 0.0, 0.0])), 64.0 + 0.8 + 12.0, 1e-14);
    assert_close(about(Direction::about_z([0.0, 0.0, 7.0])), 2.0 + 12.0 * 5.0, 1e-14);
    // all modes have less than all, and more with more modes; twist alone is about its own axis
    let roots = system.frequencies(60).unwrap();
    for (direction, share) in [(Direction::about_x([1.0, 2.0, 0.0]), 0.97), (Direction::about_z([1.0, 2.0, 0.0]), 0.9)]
    {
        let participation = system.participation::<60, _>(&roots, direction).unwrap();
        let found = participation.total() - participation.missing();
        assert!(
            found > share * participation.total() && participation.missing() > 0.0,
            "{found} of {}",
            participation.total()
        );
    }
}

#[test]
fn what_does_not_turn_is_refused() {
    let freedom = Freedoms::RZ;
    // a path without places has no arms
    let cantilever = Cantilever {}.build().unwrap();
    assert_eq!(cantilever.moving_mass(Direction::about(0.0)), Err(MotionError::NoSuchFreedom { freedom }));
    // a ground that turns is no acceleration in a direction
    let portal = Portal {}.build().unwrap();
    let load = PlaneLoad::base_acceleration(Direction::about([0.0, 0.0]));
    let refused = portal.frequency_response(load, Portal::conn_b.displacement_x()).map(|_| ()).unwrap_err();
    assert_eq!(refused, MotionError::NoSuchFreedom { freedom });
    let load = Load::base_acceleration(Direction::about(0.0));
    let refused = cantilever.frequency_response(load, Cantilever::conn_tip.deflection());
    assert!(refused.and_then(|response| response.at(1.0)).is_err());
    // the plane does not turn about x
    let freedom = Freedoms::RX;
    assert_eq!(portal.moving_mass(Direction::about_x([0.0; 3])), Err(MotionError::NoSuchFreedom { freedom }));
}
