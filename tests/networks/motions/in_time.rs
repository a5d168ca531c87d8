//! Motions in time: superposed modes beside steps of Runge and Kutta, responses at frequencies, the sums of trees.
#![expect(clippy::unwrap_used, reason = "the models are right")]

use mstmm::motion::{MotionError, PlaneEntry, PlaneLoad};
use mstmm::prelude::*;

system! {
    /// Two masses between springs at angles: four freedoms, so that four modes are all.
    struct Masses { k: f64, stiff: f64, light: f64, heavy: f64 }
    fixed at (0.0, 0.0) -> spring 1 { stiffness: k } -> conn a at (1.0, 1.0) -> spring 2 { stiffness: stiff } -> conn b at (2.5, 1.2)
        -> spring 3 { stiffness: k } -> conn ground at (4.0, 0.0) <- pinned;
    conn a -> point_mass 4 { mass: light };
    conn b -> point_mass 5 { mass: heavy };
    conn a -> spring 6 { stiffness: k } -> conn top at (0.5, 3.0) <- fixed;
    conn b -> spring 7 { stiffness: k } -> conn wall at (5.0, 2.5) <- fixed;
}

const MASSES: Masses = Masses { k: 40.0, stiff: 300.0, light: 1.0, heavy: 2.5 };

/// The springs by their ends, a and b before the points on the ground, with their stiffnesses.
fn springs() -> [(usize, usize, f64); 5] {
    let Masses { k, stiff, .. } = MASSES;
    [(2, 0, k), (0, 1, stiff), (1, 3, k), (0, 4, k), (1, 5, k)]
}

const PLACES: [[f64; 2]; 6] = [[1.0, 1.0], [2.5, 1.2], [0.0, 0.0], [4.0, 0.0], [0.5, 3.0], [5.0, 2.5]];

/// Accelerations of both masses under a force on one of them, with the point on the ground at the right moved along x.
fn accelerations(at: &[[f64; 2]; 2], force_x: f64, ground_x: f64) -> [[f64; 2]; 2] {
    let moved = |point: usize| match point {
        0 | 1 => at[point],
        3 => [ground_x, 0.0],
        _ => [0.0; 2],
    };
    let mut forces = [[force_x, 0.0], [0.0; 2]];
    for (from, to, stiffness) in springs() {
        let [dx, dy] = [PLACES[to][0] - PLACES[from][0], PLACES[to][1] - PLACES[from][1]];
        let [c, s] = [dx / dx.hypot(dy), dy / dx.hypot(dy)];
        let ([x, y], [u, v]) = (moved(from), moved(to));
        let pull = stiffness * (c * (u - x) + s * (v - y));
        for (point, sign) in [(from, pull), (to, -pull)] {
            if point < 2 {
                forces[point] = [forces[point][0] + sign * c, forces[point][1] + sign * s];
            }
        }
    }
    let masses = [MASSES.light, MASSES.heavy];
    [0, 1].map(|point| forces[point].map(|force| force / masses[point]))
}

/// The displacements of b along x under a sudden load, at times of so many steps.
fn by_runge_kutta(force_x: f64, ground_x: f64, steps: [usize; 4]) -> [f64; 4] {
    let h = 1e-4;
    let (mut at, mut rate) = ([[0.0; 2]; 2], [[0.0; 2]; 2]);
    let plus = |one: [[f64; 2]; 2], other: [[f64; 2]; 2], factor: f64| {
        [0, 1].map(|point| [0, 1].map(|k| one[point][k] + factor * other[point][k]))
    };
    let mut found = Vec::new();
    for step in 0..=steps[3] {
        if steps.contains(&step) {
            found.push(at[1][0]);
        }
        let slope = |at: [[f64; 2]; 2]| accelerations(&at, force_x, ground_x);
        let (k1, l1) = (rate, slope(at));
        let (k2, l2) = (plus(rate, l1, h / 2.0), slope(plus(at, k1, h / 2.0)));
        let (k3, l3) = (plus(rate, l2, h / 2.0), slope(plus(at, k2, h / 2.0)));
        let (k4, l4) = (plus(rate, l3, h), slope(plus(at, k3, h)));
        at = plus(plus(plus(plus(at, k1, h / 6.0), k2, h / 3.0), k3, h / 3.0), k4, h / 6.0);
        rate = plus(plus(plus(plus(rate, l1, h / 6.0), l2, h / 3.0), l3, h / 3.0), l4, h / 6.0);
    }
    found.try_into().unwrap()
}

#[test]
fn superposed_modes_move_as_steps_in_time_do() {
    let system = MASSES.build().unwrap();
    let roots = system.first_frequencies::<4>().unwrap();
    let entry = Masses::conn_b.displacement_x();
    let steps = [1000, 7321, 20_000, 51_234];
    let mut worst = 0.0_f64;
    for (load, force_x, ground_x) in [(Masses::conn_a.force_x(), 1.0, 0.0), (Masses::conn_ground.motion_x(), 0.0, 1.0)]
    {
        let response = system.modal_response::<4, _>(&roots, load, entry).unwrap();
        let at_rest = system.frequency_response(load, entry).unwrap().at(0.0).unwrap();
        assert!((response.static_value().unwrap() / at_rest - 1.0).abs() < 1e-12);
        for (step, expected) in steps.into_iter().zip(by_runge_kutta(force_x, ground_x, steps)) {
            let off = (response.to_step(step as f64 * 1e-4) - expected).abs() / at_rest.abs();
            assert!(off < 1e-10, "{step}: {off:e}");
            worst = worst.max(off);
        }
    }
    println!("steps of two masses, worst {worst:.1e} of the deflection at rest");
}

system! {
    /// A portal frame.
    struct Portal { height: f64, span: f64, ea: f64, ei: f64, m: f64 }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
        <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- conn foot at (span, 0.0) <- fixed;
}

const PORTAL: Portal = Portal { height: 2.0, span: 3.0, ea: 4e8, ei: 1e6, m: 20.0 };

#[test]
fn superposed_modes_are_at_rest_what_the_frame_is_at_rest() {
    let system = PORTAL.build().unwrap();
    let roots = system.first_frequencies::<40>().unwrap();
    let girder = Portal::beam_2;
    let loads: [PlaneLoad<Portal>; 3] =
        [Portal::conn_b.force_x(), girder.input().torque_z(), Portal::conn_foot.motion_y()];
    let entries: [PlaneEntry<Portal>; 2] = [Portal::conn_c.displacement_x(), girder.output().moment()];
    for load in loads {
        for entry in entries {
            let response = system.modal_response::<40, _>(&roots, load, entry).unwrap();
            let at_rest = system.frequency_response(load, entry).unwrap().at(0.0).unwrap();
            let off = (response.static_value().unwrap() - at_rest).abs();
            assert!(off < 1e-10 * at_rest.abs(), "{load:?} {entry:?}");
        }
    }
    let reaction = system.modal_response::<40, _>(&roots, loads[2], Portal::conn_foot.reaction_x());
    assert_eq!(reaction.err(), Some(MotionError::NotModal));
}

system! {
    struct Tree { length: f64, ei: f64, m: f64 }
    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m } -> free;
}

system! {
    struct Inclined { length: f64, ei: f64, m: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e9 * ei, bending_stiffness: ei, mass_per_length: m }
        -> conn tip at (0.6 * length, 0.8 * length) <- free;
}

/// A cantilever at an angle moves across itself as the tree does: `sin`, `cos` of its angle apart.
#[test]
fn a_frame_moves_in_time_as_a_tree_does() {
    let (length, ei, m) = (1.5, 2.0, 0.5);
    let (tree, frame) = (Tree { length, ei, m }.build().unwrap(), Inclined { length, ei, m }.build().unwrap());
    let of_tree = tree
        .modal_response::<6, _>(
            &tree.first_frequencies::<6>().unwrap(),
            Tree::beam_1.output().torque(),
            Tree::beam_1.output().deflection(),
        )
        .unwrap();
    let roots = frame.first_frequencies::<6>().unwrap();
    let (load, entry) = (Inclined::conn_tip.torque_z(), Inclined::conn_tip.displacement_x());
    let of_frame = frame.modal_response::<6, _>(&roots, load, entry).unwrap();
    for time in [0.0, 0.3, 1.1, 7.7] {
        let [found, expected] = [of_frame.to_step(time), -0.8 * of_tree.to_step(time)];
        assert!((found - expected).abs() < 1e-10, "{time}: {found} {expected}");
        let [found, expected] = [of_frame.to_impulse(time), -0.8 * of_tree.to_impulse(time)];
        assert!((found - expected).abs() < 1e-10, "{time}: {found} {expected}");
    }
}

#[test]
fn curves_of_frames_are_exact_between_their_samples() {
    let system = PORTAL.build().unwrap();
    let roots = system.first_frequencies::<4>().unwrap();
    let response = system.frequency_response(Portal::conn_b.force_x(), Portal::conn_b.displacement_x()).unwrap();
    let last = 0.9 * roots[0].omega;
    let curve = response.curve::<200, f64>(0.0..=last, &roots, 1e-3).unwrap();
    for pair in curve.windows(2) {
        let middle = 0.5 * (pair[0].omega + pair[1].omega);
        let line = 0.5 * (pair[0].value + pair[1].value);
        let off = (response.at(middle).unwrap() - line).abs();
        assert!(off < 2e-3 * pair[1].value.abs(), "{middle}: {off:e}");
    }
    let reversed = response.curve::<200, f64>(last..=0.0, &roots, 1e-3);
    assert_eq!(reversed.err(), Some(MotionError::Range { start: last, end: 0.0 }));
    let short = response.curve::<10, f64>(0.0..=last, &roots, 1e-3);
    assert_eq!(short.err(), Some(MotionError::Capacity { capacity: 10 }));
}

system! {
    /// The same frame without supports.
    struct Free { height: f64, span: f64, ea: f64, ei: f64, m: f64 }
    free at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
        <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- free at (span, 0.0);
}

/// A force along x on the middle of a straight free beam takes half of its mass on each side: the axial force beside it is a half.
#[test]
fn forces_at_rest_of_a_free_frame_are_those_of_its_inertia() {
    let Portal { height, span, ea, ei, m } = PORTAL;
    let system = Free { height, span, ea, ei, m }.build().unwrap();
    let girder = Free::beam_2;
    let response = system.frequency_response(Free::conn_b.force_y(), Free::conn_b.displacement_y()).unwrap();
    assert_eq!(response.at(0.0), Err(MotionError::Resonance { frequency: 0.0 }));
    // a frame that accelerates along x and turns about its mass centre
    let mass = m * (2.0 * height + span);
    let centre_y = (2.0 * m * height * (height / 2.0) + m * span * height) / mass;
    let leg = m * height.powi(3) / 12.0 + m * height * ((span / 2.0).powi(2) + (centre_y - height / 2.0).powi(2));
    let inertia = 2.0 * leg + m * span.powi(3) / 12.0 + m * span * (height - centre_y).powi(2);
    // a force of 1 along x at the corner: acceleration and angular acceleration
    let (a, alpha) = (1.0 / mass, -(height - centre_y) / inertia);
    // the second leg is pulled by the girder: force = mass times the acceleration of its middle
    let expected = m * height * (a - alpha * (height / 2.0 - centre_y));
    let axial = system.frequency_response(Free::conn_b.force_x(), girder.output().axial_force()).unwrap();
    let found = axial.at(0.0).unwrap();
    assert!((found + expected).abs() < 1e-9 * expected.abs(), "{found} {expected}");
}
