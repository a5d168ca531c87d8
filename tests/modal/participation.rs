//! Participation of modes: values of the file, and that all modes together have the mass that moves.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{Cantilever, Portal, assert_close, number, reference, three_spokes};
use mstmm::elements::Spring;
use mstmm::elements::TorsionSpring;
use mstmm::frame::{Frame, Hold, Pin, Plane, Point, RigidBody, Roller, Section, Slider, Space, Tensor};
use mstmm::motion::MotionError;
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;

#[test]
fn masses_of_a_cantilever_are_those_of_the_file() {
    let part = reference("participation")["cantilever"].clone();
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<8>().unwrap();
    let participation = cantilever.participation::<8, _>(&roots, Direction::y()).unwrap();
    assert_close(participation.total(), number(&part["moving_mass_y"]), 1e-15);
    let mut sum = 0.0;
    for (mode, known) in part["modes"].as_array().unwrap().iter().enumerate() {
        let factor = participation.factors()[mode];
        assert_eq!(factor.root, mode);
        assert_close(factor.value.abs(), number(&known["participation_y"]).abs(), 1e-12);
        assert_close(participation.effective_mass(mode), number(&known["effective_mass_y"]), 1e-12);
        sum += number(&known["effective_mass_y"]);
        assert_close(participation.cumulative(mode), sum, 1e-13);
    }
    let three = cantilever.participation::<3, _>(&roots[..3], Direction::y()).unwrap();
    assert_close(three.missing(), number(&part["missing_y_after_3"]), 1e-13);
    assert_eq!(three.effective_mass(3), 0.0);
    assert!(matches!(
        cantilever.participation::<2, _>(&roots[..3], Direction::y()),
        Err(MotionError::Capacity { capacity: 2 })
    ));
    let freedom = Freedoms::X;
    assert_eq!(cantilever.moving_mass(Direction::x()), Err(MotionError::NoSuchFreedom { freedom }));
}

#[test]
fn masses_of_a_portal_are_those_of_the_file() {
    let part = reference("participation")["portal"].clone();
    let portal = Portal {}.build().unwrap();
    let roots = portal.first_frequencies::<6>().unwrap();
    let directions = [
        (Direction::x(), "effective_mass_x", "missing_x_after_6"),
        (Direction::y(), "effective_mass_y", "missing_y_after_6"),
    ];
    for (axis, (direction, name, missing)) in directions.into_iter().enumerate() {
        let participation = portal.participation::<6, _>(&roots, direction).unwrap();
        assert_close(participation.total(), number(&part["moving_mass"][axis]), 1e-15);
        for (mode, known) in part["modes"].as_array().unwrap().iter().take(6).enumerate() {
            assert_close(participation.effective_mass(mode), number(&known[name]), 1e-11);
        }
        assert_close(participation.missing(), number(&part[missing]), 1e-12);
    }
    // none of its members moves along z
    assert!(matches!(portal.moving_mass(Direction::z()), Err(MotionError::NoSuchFreedom { .. })));
}

/// Of a double root no choice of the shapes changes the mass; it is the same in all directions where three members are at 120°.
#[test]
fn a_multiple_root_has_one_mass_in_all_directions() {
    let part = reference("participation")["three_spokes"].clone();
    let (system, _) = three_spokes();
    let roots = system.first_frequencies::<14>().unwrap();
    for direction in [Direction::x(), Direction::y()] {
        let participation = system.participation::<16, _>(&roots, direction).unwrap();
        assert_close(participation.total(), number(&part["moving_mass"]), 1e-15);
        for (root, known) in part["roots"].as_array().unwrap().iter().take(6).enumerate() {
            assert_close(roots[root].omega, number(&known["omega"]), 1e-12);
            let mass = number(&known["effective_mass"]["skew"]);
            assert!((participation.effective_mass(root) - mass).abs() < 1e-9, "{root}");
        }
    }
}

/// All modes of bodies on springs have the mass that moves, whatever holds a part of it: the law that no formula of the mass shares.
#[track_caller]
fn assert_all_moves(name: &str, system: &mstmm::frame::Structure<Plane>, modes: usize) {
    let roots = system.frequencies(modes).unwrap();
    assert_eq!(roots.iter().map(|root| root.multiplicity).sum::<u64>(), modes as u64, "{name}");
    for direction in [Direction::x(), Direction::y(), Direction::about([0.4, -0.3])] {
        let participation = system.participation::<16, _>(&roots, direction).unwrap();
        let (total, missing) = (participation.total(), participation.missing());
        assert!(missing.abs() < 1e-11 * total.max(1.0), "{name}: {missing:e} of {total}");
    }
}

/// A spring of some stiffness between two points, along x and along y.
fn springs(frame: &mut Frame<Plane>, from: Point<Plane>, to: Point<Plane>, stiffness: f64) {
    for along in [[1.0, 0.0], [0.2, 1.0]] {
        frame.member(from.along(along), to.along(along), Spring { stiffness });
    }
}

#[test]
fn all_modes_have_the_mass_that_nothing_holds() {
    let body = RigidBody { mass: 3.0, inertia: 0.7, centre: [0.6, 0.3] };
    let supports: [(&str, Option<Hold<Plane>>, usize); 7] = [
        ("free", None, 3),
        ("along x", Some(Freedoms::Y.into()), 2),
        ("without rotation", Some(Freedoms::RZ.into()), 2),
        ("pinned", Some(Support::Pinned.into()), 1),
        ("skew", Some(Roller::along([1.0, 0.5]).into()), 2),
        ("normal", Some(Roller::normal([1.0, 0.5]).into()), 2),
        ("guide", Some(Roller::along([1.0, 0.5]).without_rotation().into()), 1),
    ];
    for (name, hold, modes) in supports {
        let mut frame = Frame::new();
        let [at, arm, ground] = [[0.0, 0.0], [1.0, 0.2], [2.0, 0.0]].map(|place| frame.point(place));
        frame.body([at, arm], body);
        frame.hold(ground, Support::Fixed);
        springs(&mut frame, arm, ground, 50.0);
        frame.member(at.along([0.3, 1.0]), ground.along([0.3, 1.0]), Spring { stiffness: 70.0 });
        if let Some(hold) = hold {
            frame.hold(at, hold);
        }
        assert_all_moves(name, &frame.build().unwrap(), modes);
    }
}

#[test]
fn bodies_that_joints_tie_move_together() {
    // a second body is pinned to the first one, which a support holds in part; a third one hangs on that
    let holds: [(&str, Option<Hold<Plane>>, usize); 3] = [
        ("free", None, 7),
        ("without rotation", Some(Freedoms::RZ.into()), 6),
        ("fixed", Some(Support::Fixed.into()), 4),
    ];
    for (name, hold, modes) in holds {
        let mut frame = Frame::new();
        let [at, pinned, far, last] = [[0.0, 0.0], [0.0, 0.0], [1.0, 0.2], [1.0, 0.2]].map(|place| frame.point(place));
        let ground = frame.point([2.0, 0.0]);
        frame.hold(ground, Support::Fixed);
        frame.body([at], RigidBody { mass: 3.0, inertia: 0.7, centre: [0.6, 0.3] });
        frame.body([pinned], RigidBody { mass: 1.5, inertia: 0.2, centre: [-0.2, 0.5] });
        frame.body([last], RigidBody { mass: 0.5, inertia: 0.1, centre: [1.2, 0.4] });
        frame.member(at, pinned, Pin);
        frame.member(far, last, Pin);
        springs(&mut frame, far, ground, 50.0);
        springs(&mut frame, at, ground, 30.0);
        frame.member(at, ground, TorsionSpring { stiffness: 4.0 });
        frame.member(pinned, ground, TorsionSpring { stiffness: 5.0 });
        frame.member(last, ground, TorsionSpring { stiffness: 6.0 });
        if let Some(hold) = hold {
            frame.hold(at, hold);
        }
        assert_all_moves(name, &frame.build().unwrap(), modes);
    }
}

/// A body that slides along another one, which a support holds along the slide: what both share is eliminated last.
#[test]
fn bodies_that_slide_along_a_held_one_move_in_part() {
    let mut frame = Frame::new();
    let [at, slid, ground] = [[0.0, 0.0], [0.0, 0.0], [2.0, 0.5]].map(|place| frame.point(place));
    frame.body([at], RigidBody { mass: 3.0, inertia: 0.7, centre: [0.6, 0.3] });
    frame.body([slid], RigidBody { mass: 1.5, inertia: 0.2, centre: [-0.2, 0.8] });
    frame.member(at.along([1.0, 0.0]), slid.along([1.0, 0.0]), Slider);
    frame.hold(at, Freedoms::X);
    frame.hold(ground, Support::Fixed);
    springs(&mut frame, slid, ground, 40.0);
    springs(&mut frame, at, ground, 50.0);
    frame.member(at, ground, TorsionSpring { stiffness: 4.0 });
    assert_all_moves("sliding", &frame.build().unwrap(), 3);

    // both are held along x and turn together, each with its mass beside the point where it is held
    let mut frame = Frame::new();
    let [at, beside, ground] = [[0.0, 0.0], [0.0, 0.0], [2.0, 0.5]].map(|place| frame.point(place));
    frame.body([at], RigidBody { mass: 3.0, inertia: 0.7, centre: [0.6, 0.3] });
    frame.body([beside], RigidBody { mass: 1.5, inertia: 0.2, centre: [-0.2, 0.8] });
    frame.member(at.along([1.0, 0.0]), beside.along([1.0, 0.0]), Slider);
    for point in [at, beside] {
        frame.hold(point, Freedoms::X);
    }
    frame.hold(ground, Support::Fixed);
    springs(&mut frame, beside, ground, 40.0);
    springs(&mut frame, at, ground, 50.0);
    frame.member(at, ground, TorsionSpring { stiffness: 4.0 });
    assert_all_moves("turning together", &frame.build().unwrap(), 2);
}

/// A joint that ties a motion of a body to a support in part: how much moves is refused, not guessed; what nothing holds is known.
#[test]
fn bodies_that_are_held_in_part_by_a_joint_are_refused() {
    let frame = |hold: Option<Support>| {
        let mut frame = Frame::new();
        let [at, slid, ground] = [[0.0, 0.0], [0.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
        frame.body([at], RigidBody { mass: 3.0, inertia: 0.7, centre: [0.6, 0.3] });
        frame.member(at.along([1.0, 0.4]), slid.along([1.0, 0.4]), Slider);
        springs(&mut frame, slid, ground, 40.0);
        springs(&mut frame, at, ground, 50.0);
        frame.member(at, ground, TorsionSpring { stiffness: 4.0 });
        frame.hold(ground, Support::Fixed);
        if let Some(hold) = hold {
            frame.hold(slid, hold);
        }
        frame.build().unwrap()
    };
    assert_close(frame(None).moving_mass(Direction::x()).unwrap(), 3.0, 1e-15);
    let refused = frame(Some(Support::Fixed)).moving_mass(Direction::x()).unwrap_err();
    assert!(matches!(refused, MotionError::HeldMass { .. }));
    assert_eq!(
        refused.to_string(),
        "something holds a part of the mass at point 0: how much of it modes can move is not known"
    );
}

system! {
    /// Masses on springs beside a body and a mass that supports hold.
    #[derive(Clone, Copy)]
    struct Resting {}
    fixed -> body 1 { mass: 2.0, inertia: 0.3, output_x: 0.5, centre_x: 0.2 } -> conn a <- spring 2 { stiffness: 30.0 } <- mass 3 { mass: 0.7 }
        <- spring 4 { stiffness: 20.0 } <- mass 5 { mass: 0.4 } <- free;
    pinned -> point_mass 6 { mass: 9.0, inertia: 0.2 } -> hinge 7 { stiffness_y: 60.0, stiffness_rz: 8.0 } -> conn a -> free;
}

system! {
    /// Bodies that a hinge joins, on springs.
    #[derive(Clone, Copy)]
    struct Floating {}
    free -> body 1 { mass: 2.0, inertia: 0.3, output_x: 0.5, centre_x: 0.2 } -> hinge 2 { stiffness_rz: 3.0 } -> conn a
        -> body 3 { mass: 1.2, inertia: 0.1, output_x: 0.4, centre_x: 0.3 } -> rigid_link 4 { output_x: 0.2 } -> conn b -> free;
    fixed -> spring 5 { stiffness: 30.0 } -> conn a;
    fixed -> spring 6 { stiffness: 50.0 } -> mass 7 { mass: 0.4 } -> spring 8 { stiffness: 20.0 } -> conn b;
}

system! {
    /// A body that a support lets turn.
    #[derive(Clone, Copy)]
    struct Turning {}
    pinned -> body 1 { mass: 2.0, inertia: 0.3, output_x: 0.5, centre_x: 0.2 } -> conn a -> free;
    fixed -> spring 2 { stiffness: 30.0 } -> conn a;
}

/// Trees of bodies on springs: all their modes have the mass that nothing holds.
#[test]
fn all_modes_of_trees_have_the_mass_that_nothing_holds() {
    macro_rules! assert_all_moves {
        ($model:expr, $modes:literal, $mass:expr) => {
            let system = $model.build().unwrap();
            let roots = system.first_frequencies::<$modes>().unwrap();
            let participation = system.participation::<$modes, _>(&roots, Direction::y()).unwrap();
            assert_eq!(participation.factors().len(), $modes);
            assert_close(participation.total(), $mass, 1e-15);
            assert!(participation.missing().abs() < 1e-12, "{}", participation.missing());
        };
    }
    // the mass on a support has an inertia that turns, and no part in y
    assert_all_moves!(Resting {}, 3, 1.1);
    assert_all_moves!(Floating {}, 4, 3.6);
    let refused = Turning {}.build().unwrap().moving_mass(Direction::y()).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "something holds a part of the mass at body 1: how much of it modes can move is not known"
    );
}

/// In space: a body that a pin, or a slanted roller, holds at a corner.
#[test]
fn all_modes_of_a_body_in_space_have_the_mass_that_nothing_holds() {
    let holds: [(&str, Hold<Space>, usize); 3] = [
        ("pinned", Freedoms::X.union(Freedoms::Y).union(Freedoms::Z).into(), 3),
        ("along", Roller::along([1.0, 0.5, -0.3]).into(), 4),
        ("normal", Roller::normal([1.0, 0.5, -0.3]).into(), 5),
    ];
    for (name, hold, modes) in holds {
        let mut frame = Frame::new();
        let [at, arm, ground] = [[0.0, 0.0, 0.0], [1.0, 0.2, 0.5], [2.0, 0.0, 1.0]].map(|place| frame.point(place));
        let inertia = Tensor::new([0.7, 0.9, 0.5, 0.1, -0.05, 0.0]);
        frame.body([at, arm], RigidBody { mass: 3.0, inertia, centre: [0.6, 0.3, 0.2] });
        frame.hold(ground, Support::Fixed);
        frame.hold(at, hold);
        for (end, along) in [
            (at, [1.0, 0.0, 0.0]),
            (at, [0.3, 1.0, 0.2]),
            (at, [0.1, 0.3, 1.0]),
            (arm, [1.0, 0.2, 0.0]),
            (arm, [0.0, 1.0, 0.4]),
            (arm, [0.5, 0.0, 1.0]),
        ] {
            frame.member(end.along(along), ground.along(along), Spring { stiffness: 50.0 });
        }
        frame.member(at.about([1.0, 0.4, 0.3]), ground.about([1.0, 0.4, 0.3]), TorsionSpring { stiffness: 7.0 });
        let system = frame.build().unwrap();
        let roots = system.frequencies(modes).unwrap();
        let place = [0.2, -0.4, 0.7];
        let about = [Direction::about_x(place), Direction::about_y(place), Direction::about_z(place)];
        for direction in [Direction::x(), Direction::y(), Direction::z()].into_iter().chain(about) {
            let participation = system.participation::<16, _>(&roots, direction).unwrap();
            assert!(participation.missing().abs() < 1e-11, "{name}: {:e}", participation.missing());
            assert!(participation.total() < 6.0 && participation.total() > 0.1, "{name}: {}", participation.total());
        }
    }
}

/// A joint elsewhere is no reason to refuse; a mass on a spring of a line moves as the line does; what rounding hides is no zero.
#[test]
fn only_bodies_that_are_held_in_part_are_refused() {
    let mut frame = Frame::new();
    let [a, b, behind, c] = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    let steel = Section::new().axial_stiffness(1e4).bending_stiffness(1e3).mass_per_length(20.0);
    frame.hold(a, Support::Fixed);
    frame.hold(b, Freedoms::Y);
    frame.member(a, b, steel);
    frame.member(b, behind, Pin);
    frame.member(behind, c, steel);
    frame.mass(c, 3.0);
    assert_close(frame.build().unwrap().moving_mass(Direction::y()).unwrap(), 43.0, 1e-15);

    let mut line = Frame::new();
    let [foot, tip_of_line] = [0.0, 2.0].map(|place| line.point(place));
    line.hold(foot, Support::Fixed);
    line.member(foot, tip_of_line, Section::new().bending_stiffness(50.0).mass_per_length(1.5));
    line.mass(tip_of_line, 0.5);
    let absorber = line.path_point();
    line.member(tip_of_line, absorber, Spring { stiffness: 3.0 });
    line.mass(absorber, 0.25);
    let damped = line.build().unwrap();
    assert_close(damped.moving_mass(Direction::y()).unwrap(), 3.75, 1e-15);
    let roots = damped.frequencies(30).unwrap();
    let participation = damped.participation::<30, _>(&roots, Direction::y()).unwrap();
    assert!(participation.missing() > 0.0 && participation.missing() < 0.05);
    // that of the same model in the plane, whose path leads along y
    let mut plane = Frame::new();
    let [foot, tip, mass] = [[0.0, 0.0], [2.0, 0.0], [2.0, 0.0]].map(|place| plane.point(place));
    plane.hold(foot, Support::Fixed);
    plane.member(foot, tip, Section::new().axial_stiffness(1e6).bending_stiffness(50.0).mass_per_length(1.5));
    plane.mass(tip, 0.5);
    plane.member(tip.along([0.0, 1.0]), mass.along([0.0, 1.0]), Spring { stiffness: 3.0 });
    plane.mass(mass, 0.25);
    plane.hold(mass, Freedoms::X);
    let twin = plane.build().unwrap();
    for omega in [0.0, 1.0, 7.0] {
        let one = damped
            .frequency_response(PlaneLoad::self_weight_y(), tip_of_line.displacement_y())
            .unwrap()
            .at(omega)
            .unwrap();
        let other =
            twin.frequency_response(PlaneLoad::self_weight_y(), tip.displacement_y()).unwrap().at(omega).unwrap();
        assert_close(one, other, 1e-12);
    }

    let mut frame = Frame::new();
    let at = frame.point([0.0, 0.0]);
    frame.body([at], RigidBody { mass: 3.0, inertia: 0.0, centre: [0.6, 1e-8] });
    frame.hold(at, Freedoms::X);
    let ground = frame.point([0.0, 1.0]);
    frame.hold(ground, Support::Fixed);
    frame.member(at, ground, TorsionSpring { stiffness: 4.0 });
    frame.member(at.along([0.0, 1.0]), ground.along([0.0, 1.0]), Spring { stiffness: 4.0 });
    let refused = frame.build().unwrap().moving_mass(Direction::x());
    assert!(matches!(refused, Err(MotionError::HeldMass { .. })), "{refused:?}");
}
