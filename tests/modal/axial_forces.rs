//! Axial forces from loads: values of the file, closed forms, the same forces as parameters, and what is refused.

use crate::models::{assert_close, number, reference};
use crate::numbers::Random;
use crate::random;
use mstmm::frame::{Bar, Frame, Plane, Section, Space, TautString};
use mstmm::motion::AxialForceError;
use mstmm::network::{Freedoms, Support};
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;
use mstmm::search::critical_loads;

system! {
    /// The portal of the file, whose members bear axial forces.
    pub(crate) struct Portal { left: f64, girder: f64, right: f64 }
    section steel { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 }
    conn a at (0.0, 0.0) -> beam 1 { axial_force: left, ..steel } -> conn b at (0.0, 3.0);
    conn b -> beam 2 { axial_force: girder, ..steel } -> conn c at (4.0, 3.0) -> beam 3 { axial_force: right, ..steel } -> conn d at (4.0, 0.0);
    fixed -> conn a;
    pinned -> conn d;
    conn b -> point_mass 4 { mass: 100.0 };
}

/// The loads of the file.
pub(crate) fn dead() -> [(PlaneLoad<Portal>, f64); 3] {
    [(Portal::conn_b.force_y(), -2e5), (Portal::conn_c.force_y(), -2e5), (Portal::beam_2.uniform_load_y(), -1e4)]
}

impl Portal {
    pub(crate) fn unloaded() -> Self {
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
