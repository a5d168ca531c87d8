//! Answers of a sketch in which every number has slopes: places, directions, normals, axes, `up`, tensors, releases.

use super::{assert_near, proven};
use mstmm::motion::MotionError;
use mstmm::network::Freedoms;
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;

system! {
    /// A workshop with all that has numbers in space.
    #[derive(Clone, Copy, Debug)]
    pub(super) struct Workshop {
        height: f64, span: f64, depth: f64, ea: f64, gj: f64, ei: f64, weak: f64, m: f64, ip: f64, lean: f64, slope: f64,
        machine: f64, xx: f64, xy: f64, centre: f64, k: f64, k_turn: f64, shear: f64, rotary: f64, mount: f64, wire: f64,
    }
    section steel {
        axial_stiffness: ea, torsional_stiffness: gj, bending_stiffness_y: weak, bending_stiffness_z: ei, mass_per_length: m,
        polar_inertia_per_length: ip,
    }
    section column { up: (1.0, lean, 0.25) }
    fixed -> conn ground at (0.0, 0.0, 0.0)
        -> beam 1 { ..steel, ..column } -> conn a at (0.0, 0.5 * lean, height)
        -> beam 2 { ..steel, shear_stiffness: shear, rotary_inertia: rotary } -> conn b at (span, 0.0, height)
        -> beam 3 { ..steel } -> conn c at (span, depth, height)
        <- beam 4 { ..steel, up: (1.0, 0.0, lean), shear_stiffness_y: shear } <- conn foot at (span, depth, 0.0) <- roller normal (lean, slope, 1.0);
    conn a -> revolute_joint 5 { axis: (1.0, slope, lean) }
        -> beam 6 { ..steel } -> conn d at (0.25, depth, height)
        -> bar 7 { axial_stiffness: ea, bending_stiffness: weak, mass_per_length: m } -> conn wall at (0.0, 2.0 * depth, 0.5) <- pinned;
    conn c -> hinge 8 {
        stiffness_x: mount, stiffness_z: 2.0 * mount, stiffness_ry: k_turn, axis: (slope, 1.0, 0.0), up: (0.0, lean, 1.0),
    } -> rigid_body 9 { mass: machine, inertia: (xx, 4.0, 5.0, xy, 0.3, -0.2), centre: (span, depth + centre, height + 0.3) }
        -> conn e at (span, depth, height + 1.0);
    conn d <- along (0.6, slope, 0.8) <- spring 10 { stiffness: k } <- mass 11 { mass: machine } <- free;
    conn b <- about (lean, 0.0, 1.0) <- torsion_spring 12 { stiffness: k_turn } <- inertia 13 { inertia: xx } <- free;
    conn e -> string 14 { axial_stiffness: wire, tension: 0.01 * wire, mass_per_length: 0.5 } -> conn hook at (span + 1.0, depth, 2.0 * height) <- pinned;
    conn b -> rigid_link 15 {} -> conn f at (span + slope, -1.0, height);
    conn f -> spring 16 { stiffness: k } -> conn d;
}

pub(super) const WORKSHOP: Workshop = Workshop {
    height: 3.0,
    span: 4.0,
    depth: 2.0,
    ea: 4e6,
    gj: 3e5,
    ei: 1e6,
    weak: 4e5,
    m: 20.0,
    ip: 2.5,
    lean: 0.2,
    slope: 0.3,
    machine: 50.0,
    xx: 6.0,
    xy: 0.4,
    centre: 0.125,
    k: 2e5,
    k_turn: 7e4,
    shear: 2e6,
    rotary: 0.75,
    mount: 3e5,
    wire: 5e5,
};

type Field = fn(&mut Workshop) -> &mut f64;

const FIELDS: [(&str, Field); 21] = [
    ("height", |w| &mut w.height),
    ("span", |w| &mut w.span),
    ("depth", |w| &mut w.depth),
    ("ea", |w| &mut w.ea),
    ("gj", |w| &mut w.gj),
    ("ei", |w| &mut w.ei),
    ("weak", |w| &mut w.weak),
    ("m", |w| &mut w.m),
    ("ip", |w| &mut w.ip),
    ("lean", |w| &mut w.lean),
    ("slope", |w| &mut w.slope),
    ("machine", |w| &mut w.machine),
    ("xx", |w| &mut w.xx),
    ("xy", |w| &mut w.xy),
    ("centre", |w| &mut w.centre),
    ("k", |w| &mut w.k),
    ("k_turn", |w| &mut w.k_turn),
    ("shear", |w| &mut w.shear),
    ("rotary", |w| &mut w.rotary),
    ("mount", |w| &mut w.mount),
    ("wire", |w| &mut w.wire),
];

/// The roots of the model with a field changed by some steps, in twice the digits.
fn roots(field: Field, step: f64, steps: f64) -> [DoubleDouble; 5] {
    let mut changed = WORKSHOP;
    *field(&mut changed) += steps * step;
    let found = changed.build_as::<DoubleDouble>().unwrap().first_frequencies::<5>().unwrap();
    [0, 1, 2, 3, 4].map(|mode| found[mode].omega)
}

#[test]
fn sensitivities_to_all_fields_are_central_differences() {
    let system = WORKSHOP.build().unwrap();
    let found = system.first_frequencies::<5>().unwrap();
    let mut worst = 0.0_f64;
    for (name, field) in FIELDS {
        // a power of two, so that the values are what they are meant to be
        let step = 2.0_f64.powi(field(&mut { WORKSHOP }).log2().floor() as i32 - 18);
        let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(|steps| roots(field, step, steps));
        for (mode, root) in found.iter().enumerate() {
            let sensitivity = system.sensitivity(root).unwrap().get(name).unwrap();
            let eight = DoubleDouble::from(8.0);
            let slope = (eight * (above[mode] - below[mode]) - (far_above[mode] - far_below[mode]))
                / DoubleDouble::from(12.0 * step);
            let expected = slope.to_f64();
            let part = (sensitivity - expected).abs() * *field(&mut { WORKSHOP }) / root.omega;
            assert!(part < 1e-10, "mode {mode}, {name}: {sensitivity:e}, by differences {expected:e}");
            worst = worst.max(part);
        }
    }
    println!("{} sensitivities, worst {worst:.1e} of omega/p", 5 * FIELDS.len());
}

#[test]
fn all_is_proven() {
    let found = proven::<20, _>(&WORKSHOP.build().unwrap());
    assert!(found.windows(2).all(|pair| pair[0] <= pair[1]));
    let precise = WORKSHOP.build_as::<DoubleDouble>().unwrap().first_frequencies::<20>().unwrap();
    let often =
        |own: &NaturalFrequency<DoubleDouble>| std::iter::repeat_n(own.omega.to_f64(), own.multiplicity as usize);
    let precise: Vec<_> = precise.iter().flat_map(often).collect();
    assert_near(&found, &precise, 1e-14);
}

/// Oracle: what acts on the structure at rest, and what holds it, are in balance, forces and moments about the origin.
#[test]
fn what_acts_and_what_holds_are_in_balance() {
    let (system, w) = (WORKSHOP.build().unwrap(), WORKSHOP);
    let e = [w.span, w.depth, w.height + 1.0];
    let (conn_e, ground) = (Workshop::conn_e, Workshop::conn_ground);
    let loads = [
        (conn_e.force_x(), [[1.0, 0.0, 0.0], cross(e, [1.0, 0.0, 0.0])]),
        (conn_e.force_y(), [[0.0, 1.0, 0.0], cross(e, [0.0, 1.0, 0.0])]),
        (conn_e.force_z(), [[0.0, 0.0, 1.0], cross(e, [0.0, 0.0, 1.0])]),
        (conn_e.torque_x(), [[0.0; 3], [1.0, 0.0, 0.0]]),
        (conn_e.torque_y(), [[0.0; 3], [0.0, 1.0, 0.0]]),
        (conn_e.torque_z(), [[0.0; 3], [0.0, 0.0, 1.0]]),
    ];
    let supports = [
        (ground, [0.0; 3]),
        (Workshop::conn_foot, [w.span, w.depth, 0.0]),
        (Workshop::conn_wall, [0.0, 2.0 * w.depth, 0.5]),
        (Workshop::conn_hook, [w.span + 1.0, w.depth, 2.0 * w.height]),
    ];
    for (load, mut sum) in loads {
        let at_rest = |entry| system.frequency_response(load, entry).unwrap().at(0.0).unwrap();
        let reactions = supports
            .map(|(point, place)| (place, [point.reaction_x(), point.reaction_y(), point.reaction_z()].map(at_rest)));
        let turning = [ground.reaction_torque_x(), ground.reaction_torque_y(), ground.reaction_torque_z()].map(at_rest);
        for k in 0..3 {
            sum[0][k] += reactions.iter().map(|(_, force)| force[k]).sum::<f64>();
            sum[1][k] += turning[k] + reactions.iter().map(|(place, force)| cross(*place, *force)[k]).sum::<f64>();
        }
        // what balances the tension of the string before anything moves acts at the place to which its end moves
        let moved = [conn_e.displacement_x(), conn_e.displacement_y(), conn_e.displacement_z()].map(at_rest);
        let tension = 0.01 * w.wire / 5.0_f64.sqrt();
        let of_tension = cross(moved, [-tension, 0.0, -2.0 * tension]);
        (0..3).for_each(|k| sum[1][k] += of_tension[k]);
        assert!(sum.as_flattened().iter().all(|rest| rest.abs() < 1e-12), "{sum:?}");
        // across its normal a roller does not hold
        let [x, y, z] = reactions[1].1;
        assert!((x - w.lean * z).abs() < 1e-12 && (y - w.slope * z).abs() < 1e-12);
    }
}

fn cross([x, y, z]: [f64; 3], [u, v, w]: [f64; 3]) -> [f64; 3] {
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

#[test]
fn a_motion_is_asked_for_at_points_that_have_it() {
    let system = WORKSHOP.build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<1>().unwrap()[0]).unwrap();
    let of_bar = shape.value(Workshop::bar_7.input().torque());
    assert_eq!(of_bar, Err(MotionError::NoSuchFreedom { freedom: Freedoms::RX }));
}
