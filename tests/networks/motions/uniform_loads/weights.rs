//! The weight of frames: what supports carry, what falls freely, and the motion of all supports.

use super::assert_close;
use mstmm::motion::PlaneLoad;
use mstmm::prelude::*;

system! {
    /// A frame with a body, a mass, a hinge and springs, on one clamp.
    struct Crane { c: f64 }
    fixed -> conn g at (0.0, 0.0) -> beam 1 {
        axial_stiffness: 60.0, bending_stiffness: 3.0, mass_per_length: 0.9, shear_stiffness: 40.0, rotary_inertia: 0.01
    } -> conn a at (0.3, 1.5) -> pin 2 {} -> beam 3 { axial_stiffness: 50.0, bending_stiffness: 1.0, mass_per_length: 0.4 }
        -> conn b at (1.6, 1.8);
    conn a -> spring 4 { stiffness: 6.0, damping: c } -> conn b;
    conn g -> spring 5 { stiffness: 2.0 } -> conn d at (0.9, 0.7);
    conn d -> beam 6 { axial_stiffness: 50.0, bending_stiffness: 1.0, mass_per_length: 0.4 } -> conn b;
    conn b -> rigid_body 7 { mass: 0.7, inertia: 0.05, centre: (1.9, 1.5) };
    conn d -> point_mass 8 { mass: 0.3 };
}

/// The motion of the only support, seen from it, is that under the weight in the field `-λ²`: displacements less 1 and all forces.
#[test]
fn a_weight_is_the_acceleration_of_the_ground() {
    let system = Crane { c: 0.2 }.build().unwrap();
    let foot = Crane::beam_1.input();
    for lambda in [(0.0, 0.05), (-0.02, 0.7), (0.0, 3.0), (0.3, 40.0), (0.0, 2e3)] {
        let lambda = Complex::new(lambda.0, lambda.1);
        let field = -lambda * lambda;
        let ways = [
            (PlaneLoad::self_weight_x(), Crane::conn_g.motion_x(), [1.0, 0.0]),
            (PlaneLoad::self_weight_y(), Crane::conn_g.motion_y(), [0.0, 1.0]),
        ];
        for (weight, motion, [x, y]) in ways {
            let entries = [
                (Crane::conn_b.displacement_x(), x),
                (Crane::conn_b.displacement_y(), y),
                (Crane::conn_a.displacement_y(), y),
                (Crane::conn_d.displacement_x(), x),
                (Crane::conn_b.rotation_z(), 0.0),
                (foot.moment(), 0.0),
                (foot.shear(), 0.0),
                (foot.axial_force(), 0.0),
                (Crane::spring_5.input().axial_force(), 0.0),
                (Crane::beam_6.output().moment(), 0.0),
            ];
            for (number, (entry, ground)) in entries.into_iter().enumerate() {
                let own = system.frequency_response(weight, entry).unwrap().at(lambda).unwrap() * field;
                let moved = system.frequency_response(motion, entry).unwrap().at(lambda).unwrap() - ground;
                let size = 1e-11 * (moved.norm() + 1.0 + lambda.norm());
                assert!((own - moved).norm() <= size, "{number} at {lambda}: {own} is not {moved}");
            }
        }
    }
}

/// At rest the clamp carries the total weight, and its moment.
#[test]
fn the_clamp_carries_the_weight() {
    let system = Crane { c: 0.2 }.build().unwrap();
    let long = |x: f64, y: f64| x.hypot(y);
    let weights = [
        (0.9 * long(0.3, 1.5), 0.15, 0.75),
        (0.4 * long(1.3, 0.3), 0.95, 1.65),
        (0.4 * long(0.7, 1.1), 1.25, 1.25),
        (0.7, 1.9, 1.5),
        (0.3, 0.9, 0.7),
    ];
    let total: f64 = weights.iter().map(|(weight, ..)| weight).sum();
    let foot = Crane::conn_g;
    let at = |weight, entry| system.frequency_response(weight, entry).unwrap().at(Complex::new(0.0, 0.0)).unwrap().re;
    assert_close(at(PlaneLoad::self_weight_y(), foot.reaction_y()), -total, 1e-12);
    assert_close(at(PlaneLoad::self_weight_y(), foot.reaction_x()), 0.0, 1e-12);
    let moment: f64 = weights.iter().map(|(weight, x, _)| weight * x).sum();
    assert_close(at(PlaneLoad::self_weight_y(), foot.reaction_z()), -moment, 1e-12);
    assert_close(at(PlaneLoad::self_weight_x(), foot.reaction_x()), -total, 1e-12);
    let moment: f64 = weights.iter().map(|(weight, _, y)| weight * y).sum();
    assert_close(at(PlaneLoad::self_weight_x(), foot.reaction_z()), moment, 1e-12);
}

system! {
    /// A ring in the air with a body, pins and a spring across it.
    struct Ring { m: f64 }
    conn a at (0.0, 0.0) -> beam 1 { axial_stiffness: 60.0, bending_stiffness: 3.0, mass_per_length: m } -> conn b at (1.0, 0.2)
        -> beam 2 { axial_stiffness: 60.0, bending_stiffness: 3.0, mass_per_length: 2.0 * m, rotary_inertia: 0.01 }
        -> conn c at (0.7, 1.3) -> pin 3 {} -> beam 4 { axial_stiffness: 60.0, bending_stiffness: 3.0, mass_per_length: m } -> conn a;
    conn b -> rigid_body 5 { mass: 0.5, inertia: 0.2, centre: (1.3, 0.1) };
    conn a -> spring 6 { stiffness: 4.0 } -> conn c;
}

/// What falls freely falls as one, without forces, at any frequency.
#[test]
fn what_falls_freely_falls_as_one() {
    let system = Ring { m: 0.4 }.build().unwrap();
    for omega in [0.05_f64, 0.6, 3.0, 27.0, 900.0] {
        let falls = -1.0 / (omega * omega);
        let size = 1e-11 * (1.0 + falls.abs());
        for (weight, axis) in [(PlaneLoad::self_weight_x(), 0), (PlaneLoad::self_weight_y(), 1)] {
            let states =
                system.frequency_response(weight, Ring::conn_a.displacement_x()).unwrap().states(omega).unwrap();
            for point in [Ring::conn_a, Ring::conn_b, Ring::conn_c] {
                let moved = [point.displacement_x(), point.displacement_y()].map(|entry| states.value(entry).unwrap());
                assert_close(moved[axis], falls, size);
                assert_close(moved[1 - axis], 0.0, size);
                assert_close(states.value(point.rotation_z()).unwrap(), 0.0, size);
            }
            for part in [0.0, 0.3, 0.8] {
                let inside = states.along(Ring::beam_2, part).unwrap();
                assert_close([inside.displacement_x, inside.displacement_y][axis], falls, size);
                assert_close(inside.moment, 0.0, size * (1.0 + omega));
                assert_close(inside.shear, 0.0, size * (1.0 + omega) * (1.0 + omega).sqrt());
            }
        }
    }
}
