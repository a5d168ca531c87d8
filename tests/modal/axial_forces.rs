//! Axial forces from loads: values of the file, closed forms, the same forces as parameters, and what is refused.

use crate::models::{assert_close, number, reference};
use crate::numbers::Random;
use crate::random;
use mstmm::elements::{Spring, TorsionSpring};
use mstmm::frame::{Bar, Frame, Hinge, InFrame, Pin, Plane, Point, RigidLink, Section, Space, TautString};
use mstmm::motion::{AxialForceError, MotionError};
use mstmm::network::{Freedoms, Support};
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;
use mstmm::search::{SearchError, Spot, critical_loads};

system! {
    /// The portal of the file, whose members bear axial forces.
    struct Portal { left: f64, girder: f64, right: f64 }
    section steel { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 }
    conn a at (0.0, 0.0) -> beam 1 { axial_force: left, ..steel } -> conn b at (0.0, 3.0);
    conn b -> beam 2 { axial_force: girder, ..steel } -> conn c at (4.0, 3.0) -> beam 3 { axial_force: right, ..steel } -> conn d at (4.0, 0.0);
    fixed -> conn a;
    pinned -> conn d;
    conn b -> point_mass 4 { mass: 100.0 };
}

/// The loads of the file.
fn dead() -> [(PlaneLoad<Portal>, f64); 3] {
    [(Portal::conn_b.force_y(), -2e5), (Portal::conn_c.force_y(), -2e5), (Portal::beam_2.uniform_load_y(), -1e4)]
}

impl Portal {
    fn unloaded() -> Self {
        Portal { left: 0.0, girder: 0.0, right: 0.0 }
    }
}

/// The sum of responses to the loads and to 1 kN beside the corner.
fn under_all(response: impl Fn(PlaneLoad<Portal>) -> f64) -> f64 {
    dead().iter().map(|(load, value)| value * response(*load)).sum::<f64>() + 1e3 * response(Portal::conn_b.force_x())
}

#[test]
fn a_portal_has_the_values_of_the_file() {
    let part = reference("axial_forces")["portal_under_load"].clone();
    let portal = Portal::unloaded().build().unwrap();
    let forces = portal.axial_forces(&dead()).unwrap();
    let members = [forces.get(Portal::beam_1), forces.get(Portal::beam_2), forces.get(Portal::beam_3)];
    for (force, known) in members.into_iter().zip(part["N_first_order"].as_array().unwrap()) {
        assert_close(force.unwrap(), number(known), 1e-15);
    }
    let loaded = portal.with_axial_forces(&forces).unwrap();
    let settled = portal.settled_under(&dead()).unwrap();
    for (system, name) in [(&portal, "omega_unloaded"), (&loaded, "omega_first_order"), (&settled, "omega_settled")] {
        let roots = system.first_frequencies::<4>().unwrap();
        for (root, known) in roots.iter().zip(part[name].as_array().unwrap()) {
            assert_close(root.omega, number(known), 4e-16);
        }
    }
    let factors = critical_loads::<2, _>(0.0..=10.0, |factor| portal.with_axial_forces(&(&forces * factor))).unwrap();
    for (factor, known) in factors.iter().zip(part["critical_factors_of_first_order_N"].as_array().unwrap()) {
        assert_close(factor.factor, number(known), 4e-16);
        assert!(factor.lower <= number(known) && number(known) <= factor.upper);
    }
    for (system, name) in [(&portal, "first_order"), (&loaded, "with_N_first_order")] {
        let at = |load| {
            let response = system.frequency_response(load, Portal::conn_b.displacement_x()).unwrap();
            response.at(0.0).unwrap()
        };
        assert_close(under_all(at), number(&part["sway_of_1_kN"][name]), 4e-15);
    }
    let at = |load| loaded.frequency_response(load, Portal::beam_1.input().moment()).unwrap().at(0.0).unwrap();
    assert_close(under_all(at).abs(), number(&part["sway_of_1_kN"]["foot_moment_with_N"]).abs(), 4e-15);
}

/// The forces have all digits of the numbers of the model.
#[test]
fn a_portal_in_double_double_has_its_digits() {
    let part = reference("axial_forces")["portal_under_load"].clone();
    let portal = Portal::unloaded().build_as::<DoubleDouble>().unwrap();
    let loads = dead().map(|(load, value)| (load, DoubleDouble::from(value)));
    let forces = portal.axial_forces(&loads).unwrap();
    for (member, known) in [Portal::beam_1, Portal::beam_3].into_iter().zip([0, 2]) {
        let known: DoubleDouble = part["N_first_order"][known].as_str().unwrap().parse().unwrap();
        let error = (forces.get(member).unwrap() - known) / known;
        assert!(error.to_f64().abs() < 1e-17, "{error:?}");
    }
    let roots = portal.with_axial_forces(&forces).unwrap().first_frequencies::<1>().unwrap();
    let known: DoubleDouble = part["omega_first_order"][0].as_str().unwrap().parse().unwrap();
    assert!(((roots[0].omega - known) / known).to_f64().abs() < 1e-19);
}

/// Forces are added to those that members have, of one load after the other.
#[test]
fn forces_are_added_to_those_of_parameters() {
    let portal = Portal { left: -1e3, girder: 2e3, right: -5e2 }.build().unwrap();
    let push = portal.axial_forces(&[(Portal::conn_b.force_x(), 3e4)]).unwrap();
    let shrunk = portal.axial_forces(&[(Portal::beam_2.input().stretch(), -2e-3)]).unwrap();
    let twice = portal.with_axial_forces(&push).unwrap().with_axial_forces(&shrunk).unwrap();
    let [left, girder, right] = [
        push.get(Portal::beam_1).unwrap() + shrunk.get(Portal::beam_1).unwrap(),
        push.get(Portal::beam_2).unwrap() + shrunk.get(Portal::beam_2).unwrap(),
        push.get(Portal::beam_3).unwrap() + shrunk.get(Portal::beam_3).unwrap(),
    ];
    let twin = Portal { left: left - 1e3, girder: girder + 2e3, right: right - 5e2 }.build().unwrap();
    let [one, other] = [twice, twin].map(|system| system.first_frequencies::<3>().unwrap());
    for (one, other) in one.iter().zip(other.iter()) {
        assert_close(one.omega, other.omega, 2e-16);
    }
    // what shrinks is stretched by its neighbours
    assert!(shrunk.get(Portal::beam_2).unwrap() > 0.0);
}

/// Closed form: a column under its load P and a load H beside it, `H (tan kl/kl - 1) l/P` with `k² = P/EI`.
#[test]
fn a_column_bends_more_under_its_load() {
    system! {
        struct Column { length: f64, ei: f64 }
        conn foot at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e9, bending_stiffness: ei, mass_per_length: 5.0, axial_force: 0.0 } -> conn top at (0.0, length);
        fixed -> conn foot;
    }
    let (length, ei) = (3.0, 2e5);
    let column = Column { length, ei }.build().unwrap();
    let euler = ei * (core::f64::consts::FRAC_PI_2 / length).powi(2);
    for share in [0.1, 0.5, 0.9, 0.99] {
        let load = share * euler;
        let loaded = column.settled_under(&[(Column::conn_top.force_y(), -load)]).unwrap();
        let response =
            loaded.frequency_response(Column::conn_top.force_x(), Column::conn_top.displacement_x()).unwrap();
        let phase = (load / ei).sqrt() * length;
        assert_close(response.at(0.0).unwrap(), (phase.tan() / phase - 1.0) * length / load, 1e-13 / (1.0 - share));
    }
    let forces = column.axial_forces(&[(Column::conn_top.force_y(), -1.0)]).unwrap();
    let factors =
        critical_loads::<1, _>(0.0..=2.0 * euler, |factor| column.with_axial_forces(&(&forces * factor))).unwrap();
    assert_close(factors[0].factor, euler, 4e-16);
}

/// Closed forms: two bars under a weight, of a truss; each buckles as a pinned column.
#[test]
fn bars_of_a_truss_buckle_by_their_forces() {
    let steel = Section::new().axial_stiffness(3e8).bending_stiffness(4e4).mass_per_length(6.0);
    let mut frame = Frame::<Plane>::new();
    let [left, right, top] = [[0.0, 0.0], [6.0, 0.0], [3.0, 4.0]].map(|place| frame.point(place));
    let bars = [left, right].map(|foot| frame.member(foot, top, Bar(steel)));
    frame.hold(left, Support::Pinned);
    frame.hold(right, Support::Pinned);
    let truss = frame.build().unwrap();
    let forces = truss.axial_forces(&[(top.force_y(), -1e3)]).unwrap();
    for bar in bars {
        assert_close(forces.get(bar).unwrap(), -1e3 / 2.0 / 0.8, 1e-15);
    }
    let critical = 4e4 * (core::f64::consts::PI / 5.0).powi(2) / 625.0;
    let factors =
        critical_loads::<2, _>(0.0..=2.0 * critical, |factor| truss.with_axial_forces(&(&forces * factor))).unwrap();
    assert_eq!(factors.iter().map(|factor| factor.multiplicity).sum::<u64>(), 2);
    for factor in factors.iter() {
        assert_close(factor.factor, critical, 1e-14);
    }
}

/// In space a column buckles in each of its planes, and a string stiffens.
#[test]
fn columns_and_strings_of_space_take_their_forces() {
    let mast = Section::new()
        .axial_stiffness(1e9)
        .bending_stiffness_y(3e5)
        .bending_stiffness_z(1e5)
        .mass_per_length(8.0)
        .torsional_stiffness(1e5)
        .polar_inertia_per_length(0.1);
    let mut frame = Frame::<Space>::new();
    let [foot, top] = [[0.0, 0.0, 0.0], [0.0, 3.0, 4.0]].map(|place| frame.point(place));
    frame.member(foot, top, mast);
    frame.hold(foot, Support::Fixed);
    let column = frame.build().unwrap();
    // along the mast, from its top to its foot
    let loads = [(top.force_y(), -0.6), (top.force_z(), -0.8)];
    let forces = column.axial_forces(&loads).unwrap();
    let euler = |stiffness: f64| stiffness * (core::f64::consts::FRAC_PI_2 / 5.0).powi(2);
    let factors = critical_loads::<2, _>(0.0..=4e4, |factor| column.with_axial_forces(&(&forces * factor))).unwrap();
    for (factor, stiffness) in factors.iter().zip([1e5, 3e5]) {
        assert_close(factor.factor, euler(stiffness), 1e-15);
    }

    let mut frame = Frame::<Space>::new();
    let [left, right] = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(|place| frame.point(place));
    let wire =
        frame.member(left, right, TautString(Section::new().axial_stiffness(2e6).tension(500.0).mass_per_length(0.3)));
    frame.hold(left, Support::Pinned);
    frame.hold(right, Freedoms::X.union(Freedoms::Z));
    let string = frame.build().unwrap();
    let forces = string.axial_forces(&[(right.force_y(), 700.0)]).unwrap();
    assert_close(forces.get(wire).unwrap(), 700.0, 1e-15);
    let root = string.with_axial_forces(&forces).unwrap().frequencies(1).unwrap()[0];
    assert_close(root.omega, core::f64::consts::PI / 2.0 * (1200.0_f64 / 0.3).sqrt(), 1e-15);
    let slack = string.with_axial_forces(&(&forces * -1.0)).unwrap_err();
    assert_eq!((slack.parameter, slack.value), ("tension", -200.0));
}

/// Of random frames under random loads: the structure under its forces is that of sections which name them, to the last bit.
#[test]
fn random_frames_under_forces_are_those_with_parameters() {
    let mut numbers = Random(5);
    let mut compared = 0;
    for seed in 0..60 {
        let random::RandomFrame { frame, points, members } = random::frame(seed, 0.0, || 0.0);
        let structure = frame.build().unwrap();
        let tip = points[points.len() - 2];
        let loads = [(tip.force_x(), numbers.unit() - 0.5), (tip.force_y(), numbers.unit() - 0.5)];
        let forces = match structure.axial_forces(&loads) {
            Ok(forces) => forces,
            Err(AxialForceError::Lever { .. } | AxialForceError::NoAxialForce { .. }) => continue,
            Err(error) => panic!("seed {seed}: {error}"),
        };
        let all: Vec<f64> = members.iter().map(|member| forces.get(*member).unwrap()).collect();
        let twin = random::frame_under(seed, &all).frame.build().unwrap();
        let [one, other] =
            [structure.with_axial_forces(&forces).unwrap(), twin].map(|system| system.frequencies(3).unwrap());
        for (one, other) in one.iter().zip(&other) {
            assert_eq!(one.omega, other.omega, "seed {seed}");
        }
        compared += 1;
    }
    assert!(compared > 20, "{compared}");
}

#[test]
fn what_has_no_parameter_for_its_force_is_refused() {
    system! {
        struct Strut {}
        conn a at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e8, bending_stiffness: 1e5, mass_per_length: 5.0 } -> conn b at (2.0, 0.0);
        fixed -> conn a;
    }
    let strut = Strut {}.build().unwrap();
    let refused = strut.axial_forces(&[(Strut::conn_b.force_x(), 10.0)]).unwrap_err();
    let member = Spot::Named("beam 1");
    assert_eq!(refused, AxialForceError::NoAxialForce { member, name: "beam 1", force: 10.0 });
    assert!(
        refused.to_string().starts_with("beam 1 carries an axial force of 10 N and has no parameter for it: name it")
    );
    // across it there is none
    assert!(strut.axial_forces(&[(Strut::conn_b.force_y(), 10.0)]).is_ok());

    // a spring between two places would turn; in a direction of its own it does not
    let section = Section::new().axial_stiffness(1e8).bending_stiffness(1e5).mass_per_length(5.0);
    let spring = |turns: bool| {
        let mut frame = Frame::<Plane>::new();
        let [a, b, c] = [[0.0, 0.0], [2.0, 0.0], [2.0, -1.0]].map(|place| frame.point(place));
        frame.member(a, b, section);
        frame.hold(a, Support::Pinned);
        frame.hold(c, Support::Fixed);
        let stiffness = 1e4;
        if turns {
            frame.member(b, c, Spring { stiffness });
        } else {
            frame.member(b.along([0.0, 1.0]), c.along([0.0, 1.0]), Spring { stiffness });
        }
        frame.member(a, mstmm::frame::Ground, TorsionSpring { stiffness: 10.0 });
        let structure = frame.build().unwrap();
        structure.axial_forces(&[(b.force_y(), -10.0)]).map(|_| ()).map_err(|error| error.to_string())
    };
    assert!(spring(true).unwrap_err().starts_with("member 1 (Spring) carries an axial force of -"));
    assert_eq!(spring(false), Ok(()));
}

/// A rigid link under its load turns more, and one across its load does not.
#[test]
fn forces_on_levers_of_what_is_rigid_are_refused() {
    let under = |reach: f64, rise: f64| {
        let section = Section::new().axial_stiffness(1e8).bending_stiffness(1e5).mass_per_length(5.0);
        let mut frame = Frame::<Plane>::new();
        let [a, b, c] = [[0.0, 0.0], [0.0, 2.0], [reach, 2.0 + rise]].map(|place| frame.point(place));
        let column = frame.member(a, b, section);
        frame.body([b, c], RigidLink);
        frame.hold(a, Support::Fixed);
        let structure = frame.build().unwrap();
        let forces = structure.axial_forces(&[(c.force_y(), -1e3)]);
        forces.map(|forces| forces.get(column).unwrap())
    };
    assert_close(under(0.5, 0.0).unwrap(), -1e3, 1e-15);
    for rise in [0.3, -0.2] {
        let Err(AxialForceError::Lever { stiffness, .. }) = under(0.5, rise) else { panic!("{:?}", under(0.5, rise)) };
        assert_close(stiffness, -1e3 * rise, 1e-14);
    }
}

fn steel() -> Section {
    Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0)
}

/// What becomes of a column of two pieces under a load at its top, given what joins them.
fn joined(
    join: impl Fn(&mut Frame<Plane>, Point<Plane>, Point<Plane>),
    load: fn(Point<Plane>) -> PlaneLoad<InFrame>,
) -> Result<(), AxialForceError> {
    let mut frame = Frame::<Plane>::new();
    let [foot, one, other, top] = [0.0, 1.5, 1.5, 3.0].map(|height| frame.point([0.0, height]));
    frame.member(foot, one, steel());
    join(&mut frame, one, other);
    frame.member(other, top, steel());
    frame.hold(foot, Support::Fixed);
    frame.build().unwrap().axial_forces(&[(load(top), -1e5)]).map(|_| ())
}

/// What slides across a force turns what it slides on, and a path between two places turns with these.
#[test]
fn slides_and_paths_under_forces_are_refused() {
    let [down, beside] = [|top: Point<Plane>| top.force_y(), |top: Point<Plane>| top.force_x()];
    let hinge = |frame: &mut Frame<Plane>, one, other| _ = frame.member(one, other, Hinge::new().stiffness_x(2e5));
    let refused = joined(hinge, down).unwrap_err();
    assert!(matches!(refused, AxialForceError::Slides { force, .. } if (force / 1e5 - 1.0).abs() < 1e-14), "{refused}");
    assert!(refused.to_string().starts_with("member 1 (joint) slides across a force of"), "{refused}");
    // along its direction it carries the load as a spring does
    assert_eq!(joined(hinge, beside), Ok(()));
    let turning = |frame: &mut Frame<Plane>, one, other| _ = frame.member(one, other, Hinge::new().stiffness_rz(2e5));
    assert_eq!(joined(turning, down), Ok(()));
    let released = |frame: &mut Frame<Plane>, one: Point<Plane>, other: Point<Plane>| {
        let far = frame.point([0.5, 1.5]);
        frame.member(one, other, Pin);
        frame.member(other.releasing(Freedoms::Y), far, steel());
        frame.member(far.along([1.0, 0.0]), one.along([1.0, 0.0]), Spring { stiffness: 1e4 });
        frame.hold(far, Support::Fixed);
    };
    assert!(!matches!(joined(released, down), Err(AxialForceError::Slides { .. })));
    assert!(matches!(joined(released, beside), Err(AxialForceError::Slides { .. })));

    system! {
        struct Strut { k: f64 }
        fixed at (0.0, 0.0) -> spring 1 { stiffness: k } -> mass 2 { mass: 0.1 } -> spring 3 { stiffness: k } -> conn b at (0.0, 1.0);
        conn b -> point_mass 4 { mass: 1.0 };
        conn b -> along (1.0, 0.0) -> spring 5 { stiffness: 100.0 } -> fixed;
    }
    let strut = Strut { k: 1e6 }.build().unwrap();
    let refused = strut.axial_forces(&[(Strut::conn_b.force_y(), -1.0)]).map(|_| ()).unwrap_err();
    assert!(matches!(refused, AxialForceError::NoAxialForce { name: "spring 1", .. }), "{refused}");
}

/// Forces are small only beside the rounding of what carries them; a tiny one changes nothing, and one out of range is told.
#[test]
fn forces_of_all_sizes_are_taken() {
    let steel = |stiffness: f64| {
        Section::new().axial_stiffness(1e3 * stiffness).bending_stiffness(stiffness).mass_per_length(1.0)
    };
    let mut frame = Frame::<Plane>::new();
    let [a, b, c, d] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 2.0]].map(|place| frame.point(place));
    frame.member(a, b, steel(1e9));
    frame.member(a, c, steel(1e9));
    let weak = frame.member(c, d, steel(1e-3));
    frame.hold(a, Support::Fixed);
    let structure = frame.build().unwrap();
    let forces = structure.axial_forces(&[(b.force_x(), 1e9), (d.force_y(), -2e-3)]).unwrap();
    assert_close(forces.get(weak).unwrap(), -2e-3, 1e-15);
    let cancelling =
        structure.axial_forces(&[(b.force_x(), 1e15), (b.force_x(), -1e15), (d.force_y(), -2e-3)]).unwrap();
    assert_close(cancelling.get(weak).unwrap(), -2e-3, 1e-15);

    let mut frame = Frame::<Plane>::new();
    let [foot, tip] = [[0.0, 0.0], [3.0, 4.0]].map(|place| frame.point(place));
    let mast =
        frame.member(foot, tip, Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0));
    frame.hold(foot, Support::Fixed);
    let structure = frame.build().unwrap();
    let sway = |structure: &mstmm::frame::Structure<Plane>| {
        structure.frequency_response(tip.force_x(), tip.displacement_x()).unwrap().at(0.0).unwrap()
    };
    for load in [1e-30, 1e-100, 1e-250] {
        let loaded = structure.settled_under(&[(tip.force_y(), -load)]).unwrap();
        assert_close(sway(&loaded), sway(&structure), 1e-15);
    }
    assert_close(structure.axial_forces(&[(tip.force_y(), -1e155)]).unwrap().get(mast).unwrap(), -0.8e155, 1e-14);
    let infinite = structure.axial_forces(&[(tip.force_y(), f64::INFINITY)]).map(|_| ()).unwrap_err();
    assert_eq!(infinite, AxialForceError::Motion(MotionError::NotFinite { frequency: 0.0 }));

    // a link behind which nothing acts carries rounding alone
    let mut frame = Frame::<Plane>::new();
    let [a, b, c, d] = [[0.0, 0.0], [1.3, 0.7], [1.55, 0.9], [2.3, 1.7]].map(|place| frame.point(place));
    frame.member(a, b, steel(1e6));
    frame.body([b, c], RigidLink);
    frame.member(c, d, steel(1e6));
    frame.hold(a, Support::Fixed);
    assert!(frame.build().unwrap().axial_forces(&[(b.force_y(), 1.0)]).is_ok());
}

#[test]
fn other_mistakes_are_told() {
    let portal = Portal::unloaded().build().unwrap();
    // near the critical load, 2.078 times these, forces do not settle, and beyond it they are those of a structure that falls
    let under = |factor: f64| portal.settled_under(&dead().map(|(load, value)| (load, factor * value)));
    assert!(matches!(under(2.07), Err(AxialForceError::Unsettled { change }) if change > 1.0));
    assert!(under(2.0).unwrap().first_frequencies::<1>().is_ok());
    let fallen = under(3.0).unwrap().first_frequencies::<1>();
    assert!(matches!(fallen, Err(SearchError::Unstable { modes: 1 })), "{fallen:?}");
    // forces of a frame with other members
    let mut frame = Frame::<Plane>::new();
    let section = Section::new().axial_stiffness(1e8).bending_stiffness(1e5).mass_per_length(5.0);
    let [a, b] = [[0.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    frame.member(a, b, section);
    frame.hold(a, Support::Fixed);
    let small = frame.build().unwrap();
    let c = frame.point([3.0, 0.0]);
    frame.member(b, c, section);
    let large = frame.build().unwrap();
    let forces = large.axial_forces(&[(c.force_x(), 5.0)]).unwrap();
    let refused = small.with_axial_forces(&forces).unwrap_err();
    assert_eq!((refused.parameter, refused.value), ("axial_force", 5.0));
    // a pin carries what its members carry
    let mut frame = Frame::<Plane>::new();
    let points = [[0.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    let beside = frame.point([0.0, 0.0]);
    frame.member(points[0], beside, Pin);
    frame.member(beside, points[1], section);
    frame.hold(points[0], Support::Fixed);
    frame.hold(points[1], Support::Roller);
    let pinned = frame.build().unwrap();
    assert!(pinned.axial_forces(&[(points[1].force_x(), -5.0)]).is_ok());
    // what loses energy at rest has no forces at rest
    let lossy = Section::new().axial_stiffness(1e8).bending_stiffness(1e5).mass_per_length(5.0).loss_factor(0.1);
    let mut frame = Frame::<Plane>::new();
    let [a, b] = [[0.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    frame.member(a, b, lossy);
    frame.hold(a, Support::Fixed);
    let refused = frame.build_damped().unwrap().axial_forces(&[(b.force_x(), 1.0)]).map(|_| ()).unwrap_err();
    assert_eq!(refused, AxialForceError::Motion(MotionError::LossFactor));
}
