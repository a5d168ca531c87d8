//! Motions of frames in space: closed forms, motions between ends, equilibrium, sensitivities.

use crate::random::random_model;
use mstmm::frame::{Frame, Hinge, Point, PointMass, RigidBody, Section, Space, Tensor};
use mstmm::motion::PlaneLoad;
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;
use mstmm::search::critical_loads;

const STEEL: Section = Section::new()
    .axial_stiffness(4e6)
    .bending_stiffness_y(3e4)
    .bending_stiffness_z(1e4)
    .torsional_stiffness(2e4)
    .mass_per_length(20.0)
    .polar_inertia_per_length(0.5);

fn points<const N: usize>(frame: &mut Frame<Space>, places: [[f64; 3]; N]) -> [Point<Space>; N] {
    places.map(|place| frame.point(place))
}

/// Oracle: the tip of a cantilever under forces, a moment and a torque, and under loads along it, `y = F l³/3EI`, `q l⁴/8EI`.
#[test]
fn a_cantilever_at_rest_has_its_closed_forms() {
    let (length, [y, z, torsion]) = (2.0_f64, [1e4, 3e4, 2e4]);
    let mut frame = Frame::new();
    let [foot, tip] = points(&mut frame, [[0.0; 3], [length, 0.0, 0.0]]);
    frame.hold(foot, Support::Fixed);
    let beam = frame.member(foot, tip, STEEL);
    let cantilever = frame.build().unwrap();
    let at_rest = |load, entry| cantilever.frequency_response(load, entry).unwrap().at(0.0).unwrap();
    let cubed = length.powi(3) / 3.0;
    let near = |own: f64, exact: f64| assert!((own - exact).abs() <= 1e-14 * exact.abs(), "{own} {exact}");
    near(at_rest(tip.force_y(), tip.displacement_y()), cubed / y);
    near(at_rest(tip.force_z(), tip.displacement_z()), cubed / z);
    near(at_rest(tip.force_z(), tip.rotation_y()), -length * length / 2.0 / z);
    near(at_rest(tip.torque_x(), tip.rotation_x()), length / torsion);
    near(at_rest(tip.force_x(), tip.displacement_x()), length / 4e6);
    near(at_rest(beam.uniform_load_z(), tip.displacement_z()), length.powi(4) / 8.0 / z);
    near(at_rest(beam.uniform_load_y(), tip.displacement_y()), length.powi(4) / 8.0 / y);
    near(at_rest(beam.uniform_load_x(), tip.displacement_x()), length * length / 2.0 / 4e6);
    near(at_rest(PlaneLoad::self_weight_z(), foot.reaction_z()), -40.0);
    near(at_rest(PlaneLoad::self_weight_z(), foot.reaction_torque_y()), 40.0 * length / 2.0);
    // internal forces at the foot: M = EI Θ', Q = M' of the plane, of z with the signs of the right hand
    near(at_rest(tip.force_y(), beam.input().moment_z()), length);
    near(at_rest(tip.force_y(), beam.input().shear_y()), -1.0);
    near(at_rest(tip.force_z(), beam.input().moment_y()), -length);
    near(at_rest(tip.force_z(), beam.input().shear_z()), -1.0);
    near(at_rest(tip.torque_x(), beam.input().torque()), 1.0);
    near(at_rest(tip.force_x(), beam.input().axial_force()), 1.0);
}

/// Oracle: Euler's column, `N = -π² EI/4l²` of the weaker plane.
#[test]
fn a_column_buckles_in_its_weaker_plane() {
    let length = 2.0;
    let column = |load: f64| {
        let mut frame = Frame::new();
        let [foot, tip] = points(&mut frame, [[0.0; 3], [0.0, 0.0, length]]);
        frame.hold(foot, Support::Fixed);
        frame.member(foot, tip, STEEL.axial_force(-load).up([1.0, 0.0, 0.0]));
        Ok(frame.build().unwrap())
    };
    let euler = std::f64::consts::PI.powi(2) / (4.0 * length * length);
    let found = critical_loads::<2, _>(0.0..=3e4, column).unwrap();
    for (own, stiffness) in found.iter().zip([1e4, 3e4]) {
        assert!((own.factor / (euler * stiffness) - 1.0).abs() < 1e-14, "{own:?}");
    }
    assert_eq!(found.len(), 2);
}

/// The motion between the ends of a member goes over into that of its ends.
#[test]
fn motions_inside_meet_those_of_the_ends() {
    let mut compared = 0;
    for seed in 0..40 {
        let model = random_model(seed, 1.0);
        let (frame, points, members) = model.frame_and_members();
        let structure = frame.build().unwrap();
        let load = points[1].force_z();
        let states = structure.frequency_response(load, points[1].displacement_z()).unwrap().states(0.7).unwrap();
        let beams = model.beams.iter().zip(&members).filter(|(beam, _)| !beam.is_bar && beam.released.is_empty());
        for (beam, member) in beams {
            let [from, to] = beam.ends.map(|end| model.places[end]);
            let length = (0..3).map(|k| (to[k] - from[k]).powi(2)).sum::<f64>().sqrt();
            for (end, at) in [(0, 0.0), (1, length)] {
                let (inside, point) = (states.along(*member, at).unwrap(), points[beam.ends[end]]);
                let own = if end == 0 { member.input() } else { member.output() };
                let value = |entry| states.value(entry).unwrap_or_default();
                let pairs = [
                    (inside.displacement_x, value(point.displacement_x())),
                    (inside.displacement_y, value(point.displacement_y())),
                    (inside.displacement_z, value(point.displacement_z())),
                    (inside.rotation_x, value(point.rotation_x())),
                    (inside.rotation_y, value(point.rotation_y())),
                    (inside.rotation_z, value(point.rotation_z())),
                    (inside.axial_force, value(own.axial_force())),
                    (inside.shear, value(own.shear_y())),
                    (inside.shear_z, value(own.shear_z())),
                    (inside.moment, value(own.moment_z())),
                    (inside.moment_y, value(own.moment_y())),
                    (inside.torque, value(own.torque())),
                    (value(own.displacement_z()), value(point.displacement_z())),
                    (value(own.rotation_x()), value(point.rotation_x())),
                ];
                let largest = pairs.iter().fold(1e-3, |sum: f64, (_, own)| sum.max(own.abs()));
                for (place, (one, other)) in pairs.into_iter().enumerate() {
                    assert!((one - other).abs() <= 1e-10 * largest, "{seed} {place}: {one} {other} of {largest}");
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
}

/// Oracle: differences. Besides, stiffnesses together change ω by `ω/2`, and inertias by as much the other way.
#[test]
fn sensitivities_are_slopes() {
    const INERTIAS: [&str; 3] = ["mass_per_length", "polar_inertia_per_length", "rotary_inertia_z"];
    for seed in 0..6 {
        let model = random_model(seed, 1.0).beams_alone();
        let (frame, _, members) = model.frame_and_members();
        let structure = frame.build().unwrap();
        let roots = structure.frequencies(4).unwrap();
        let Some(root) = roots.iter().find(|root| root.multiplicity == 1 && root.omega > 0.0) else { continue };
        let sensitivities = structure.sensitivity(root).unwrap();
        let mut sums = [0.0; 2];
        for (beam, member) in model.beams.iter().zip(&members) {
            assert!(sensitivities.of(*member, "length").is_err() && sensitivities.of(*member, "tension").is_err());
            for &(name, value) in &beam.named {
                let is_inertia = INERTIAS.contains(&name);
                let slope = sensitivities.of(*member, name).unwrap();
                sums[usize::from(is_inertia)] += slope * value;
                let changed = |factor: f64| {
                    let mut other = frame.clone();
                    let section = beam.section(Some((name, value * factor)));
                    if beam.is_bar {
                        other.replace(*member, mstmm::frame::Bar(section));
                    } else {
                        other.replace(*member, section);
                    }
                    let found = other.build().unwrap().frequencies(4).unwrap();
                    found.iter().find(|own| own.index == root.index).unwrap().omega
                };
                let difference = (changed(1.0 + 1e-5) - changed(1.0 - 1e-5)) / 2e-5;
                let error = (slope * value - difference).abs();
                assert!(error <= 1e-8 * root.omega, "{seed} {name}: {} {difference}", slope * value);
            }
        }
        for (sum, half) in sums.into_iter().zip([0.5, -0.5]) {
            assert!((sum / root.omega - half).abs() < 1e-12, "{seed}: {sums:?} of {}", root.omega);
        }
    }
}

/// Oracle: a beam in the air, whose ends have no forces: with unit modal mass its tips move by `2/√(ml)`.
#[test]
fn a_free_beam_has_its_shapes() {
    let length = 2.0;
    let mut frame = Frame::new();
    let [from, to] = points(&mut frame, [[0.0; 3], [length, 0.0, 0.0]]);
    frame.member(from, to, STEEL);
    let beam = frame.build().unwrap();
    let roots = beam.frequencies(12).unwrap();
    assert_eq!((roots[0].multiplicity, roots[0].omega), (6, 0.0));
    let mut bent = 0;
    for root in roots.iter().filter(|root| root.omega > 0.0) {
        let shape = beam.mode_shape(root).unwrap();
        let [y, z] = [from.displacement_y(), from.displacement_z()].map(|entry| shape.value(entry).unwrap().abs());
        if y.max(z) > 0.1 {
            assert!((y.max(z) - 2.0 / (20.0 * length).sqrt()).abs() < 1e-13, "{y} {z}");
            bent += 1;
        }
    }
    assert!(bent >= 3, "{bent}");
}

/// What a mass is about an axis is a moment of inertia, and along a direction a mass.
#[test]
fn masses_in_directions_are_those_of_bodies() {
    let cantilever = |add: &dyn Fn(&mut Frame<Space>, Point<Space>)| {
        let mut frame = Frame::new();
        let [foot, tip] = points(&mut frame, [[0.0; 3], [2.0, 0.0, 0.0]]);
        frame.hold(foot, Support::Fixed);
        frame.member(foot, tip, STEEL);
        add(&mut frame, tip);
        frame.build().unwrap().frequencies(6).unwrap().iter().map(|root| root.omega).collect::<Vec<_>>()
    };
    let inertia = |moments| PointMass { mass: 0.0, inertia: Tensor::principal(moments) };
    for (axis, moments) in [([0.0, 0.0, 2.0], [0.0, 0.0, 3.0]), ([1.0, 0.0, 0.0], [3.0, 0.0, 0.0])] {
        let about = cantilever(&|frame, tip| frame.mass(tip.about(axis), 3.0));
        let body = cantilever(&|frame, tip| _ = frame.body([tip], inertia(moments)));
        assert!(about.iter().zip(&body).all(|(one, other)| (one / other - 1.0).abs() < 1e-13), "{about:?} {body:?}");
    }
    let along = cantilever(&|frame, tip| {
        for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
            frame.mass(tip.along(axis), 3.0);
        }
    });
    let body = cantilever(&|frame, tip| _ = frame.body([tip], PointMass { mass: 3.0, inertia: Tensor::default() }));
    assert!(along.iter().zip(&body).all(|(one, other)| (one / other - 1.0).abs() < 1e-13), "{along:?} {body:?}");
}

/// A joint has the direction that one of its ends names.
#[test]
fn a_joint_has_one_axis() {
    let first = |named: [bool; 2]| {
        let mut frame = Frame::new();
        let [foot, one, two, tip] = points(&mut frame, [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 2.0, 0.5]]);
        frame.hold(foot, Support::Fixed);
        frame.member(foot, one, STEEL);
        frame.member(two, tip, STEEL);
        let axis = [0.3, 1.0, 0.5];
        let ends = [0, 1].map(|k| if named[k] { [one, two][k].along(axis) } else { [one, two][k].into() });
        frame.member(ends[0], ends[1], Hinge::new().stiffness_rx(1e3));
        let structure = frame.build().unwrap();
        structure.frequency_response(foot.motion_x(), tip.displacement_x()).unwrap().at(0.0).unwrap()
    };
    for named in [[true, true], [true, false], [false, true]] {
        assert!((first(named) - 1.0).abs() < 1e-13);
    }
}

/// Oracle: differences of the entries of a tensor, each of which stands twice off the diagonal.
#[test]
fn sensitivities_to_bodies_are_slopes() {
    const NAMES: [&str; 6] = ["inertia_xx", "inertia_yy", "inertia_zz", "inertia_xy", "inertia_yz", "inertia_zx"];
    let entries = [3.0, 4.0, 5.0, 0.4, -0.3, 0.6];
    let engine = |mass: f64, entries: [f64; 6]| {
        let mut frame = Frame::new();
        let [foot, knee, tip] = points(&mut frame, [[0.0; 3], [1.0, 0.7, 0.2], [1.5, 0.9, 1.4]]);
        frame.hold(foot, Support::Fixed);
        frame.member(foot, knee, STEEL.up([0.3, 0.2, 0.8]));
        frame.member(knee, tip, STEEL.up([0.9, 0.2, 0.1]));
        let body = frame.body([tip], RigidBody { mass, inertia: Tensor::new(entries), centre: [1.6, 1.2, 1.5] });
        (frame, body)
    };
    let (frame, body) = engine(30.0, entries);
    let structure = frame.build().unwrap();
    for (place, root) in structure.frequencies(6).unwrap().iter().enumerate() {
        let sensitivities = structure.sensitivity(root).unwrap();
        let difference = |changed: &dyn Fn(f64) -> Frame<Space>| {
            let omega = |step: f64| changed(step).build().unwrap().frequencies(6).unwrap()[place].omega;
            (omega(1e-5) - omega(-1e-5)) / 2e-5
        };
        let by_mass = difference(&|step| engine(30.0 + step, entries).0);
        assert!((sensitivities.of(body, "mass").unwrap() - by_mass).abs() < 1e-7 * root.omega, "{place}: {by_mass}");
        for (entry, name) in NAMES.into_iter().enumerate() {
            let by_entry = difference(&|step| {
                let mut own = entries;
                own[entry] += step;
                engine(30.0, own).0
            });
            let own = sensitivities.of(body, name).unwrap();
            assert!((own - by_entry).abs() < 1e-7 * root.omega, "{place} {name}: {own} {by_entry}");
        }
        assert!(sensitivities.of(body, "inertia").is_err());
    }
}

/// A member whose both ends let go of its rotation has no torsion, and one that supports let turn has a motion at rest.
#[test]
fn what_turns_freely_about_itself_has_no_torsion() {
    let between = |released: Freedoms, held: Freedoms| {
        let mut frame = Frame::new();
        let [from, to] = points(&mut frame, [[0.0; 3], [2.0, 0.0, 0.0]]);
        frame.hold(from, held);
        frame.hold(to, held);
        let shaft = frame.member(from.releasing(released), to.releasing(released), STEEL);
        (frame.build().unwrap(), shaft, to)
    };
    let all_but_spin = Freedoms::SPACE.without(Freedoms::RX);
    let (released, shaft, to) = between(Freedoms::RX, Freedoms::SPACE);
    assert!(released.frequencies(1).unwrap()[0].omega > 0.0);
    assert!(released.frequency_response(to.motion_y(), shaft.input().torque()).is_err());
    let (turning, shaft, to) = between(Freedoms::NONE, all_but_spin);
    assert_eq!(turning.frequencies(1).unwrap()[0].omega, 0.0);
    assert!(turning.frequency_response(to.torque_x(), shaft.input().torque()).is_ok());
    // bending is the same, and the shaft has roots between free ends besides, π/l √(GJ/ρI)
    let spin = std::f64::consts::PI / 2.0 * (2e4_f64 / 0.5).sqrt();
    let has_spin = |structure: &mstmm::frame::Structure<Space>| {
        let found = structure.frequencies(8).unwrap();
        found.iter().any(|root| (root.omega / spin - 1.0).abs() < 1e-12)
    };
    assert!(has_spin(&turning) && !has_spin(&released));
}
