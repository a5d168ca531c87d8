//! Shapes, responses and sensitivities by stiffnesses beside those by minors: a beam in a line with and without places.
#![expect(clippy::unwrap_used, reason = "the models are right")]

use mstmm::prelude::*;

system! {
    /// By minors: three beams, a spring under the first joint, a hinge at the second one, a mass at the tip.
    #[derive(Clone, Copy, Debug)]
    struct Tree { a: f64, b: f64, c: f64, ei: f64, m: f64, k: f64, turn: f64, mass: f64, inertia: f64 }
    fixed -> beam 1 { length: a, bending_stiffness: ei, mass_per_length: m } -> conn 2
        -> beam 3 { length: b, bending_stiffness: 2.0 * ei, mass_per_length: m }
        -> hinge 4 { stiffness_y: k, stiffness_rz: turn }
        -> beam 5 { length: c, bending_stiffness: ei, mass_per_length: 3.0 * m }
        -> point_mass 6 { mass, inertia } -> free;
    conn 2 <- spring 7 { stiffness: k } <- fixed;
}

system! {
    /// By stiffnesses.
    #[derive(Clone, Copy, Debug)]
    struct Line { a: f64, b: f64, c: f64, ei: f64, m: f64, k: f64, turn: f64, mass: f64, inertia: f64 }
    fixed at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: m } -> conn 2 at a
        -> beam 3 { bending_stiffness: 2.0 * ei, mass_per_length: m } -> conn p at a + b
        -> hinge 4 { stiffness_y: k, stiffness_rz: turn } -> conn q
        -> beam 5 { bending_stiffness: ei, mass_per_length: 3.0 * m } -> conn tip at a + b + c;
    conn tip -> point_mass 6 { mass, inertia };
    conn 2 <- spring 7 { stiffness: k } <- fixed;
}

fn both() -> (TreeSystem, LineSystem) {
    let (a, b, c, ei, m, k, turn, mass, inertia) = (0.8, 1.3, 0.6, 30.0, 0.9, 700.0, 45.0, 0.4, 0.07);
    let tree = Tree { a, b, c, ei, m, k, turn, mass, inertia };
    (tree.build().unwrap(), Line { a, b, c, ei, m, k, turn, mass, inertia }.build().unwrap())
}

fn close(one: f64, other: f64, size: f64, what: &str) {
    assert!((one - other).abs() <= 1e-11 * size, "{what}: {one} by minors, {other} by stiffnesses");
}

#[test]
fn shapes_by_charts_are_those_by_minors() {
    let (tree, line) = both();
    let roots = [tree.first_frequencies::<40>().unwrap(), line.first_frequencies::<40>().unwrap()];
    for (root, other) in roots[0].iter().zip(roots[1].iter()) {
        // places of points are sums of lengths, which are rounded
        let room = 4.0 * f64::EPSILON * root.omega;
        assert!(root.lower <= other.upper + room && other.lower <= root.upper + room, "{root:?} {other:?}");
        let (shape, other) = (tree.mode_shape(root).unwrap(), line.mode_shape(other).unwrap());
        let inner = shape.state(Tree::beam_3.output());
        let tip = shape.state(Tree::beam_5.output());
        // the sign of a shape is free
        let entry = |entry| other.value(entry).unwrap();
        let sign =
            (inner.y * entry(Line::conn_p.displacement_y()) + tip.y * entry(Line::conn_tip.displacement_y())).signum();
        let entry = |entry| sign * other.value(entry).unwrap();
        let (z, largest) = ((root.omega * (0.9_f64 / 30.0).sqrt()).sqrt(), 3.0);
        close(inner.y, entry(Line::conn_p.displacement_y()), largest, "deflection");
        close(tip.y, entry(Line::conn_tip.displacement_y()), largest, "deflection of the tip");
        close(tip.theta, entry(Line::conn_tip.rotation_z()), largest * z, "rotation of the tip");
        let clamp = shape.state(Tree::beam_1.input());
        close(clamp.m, entry(Line::beam_1.input().moment()), 30.0 * largest * z * z, "moment at the clamp");
        close(clamp.q, entry(Line::beam_1.input().shear()), 30.0 * largest * z.powi(3), "shear at the clamp");
        close(inner.m, entry(Line::beam_3.output().moment()), 60.0 * largest * z * z, "moment at the hinge");
        close(inner.q, entry(Line::beam_3.output().shear()), 60.0 * largest * z.powi(3), "shear at the hinge");
    }
}

#[test]
fn responses_by_charts_are_those_by_minors() {
    let (tree, line) = both();
    for omega in [0.0, 1.7, 23.0, 411.0, 9_000.0] {
        let of_tree = |load, entry| tree.frequency_response(load, entry).unwrap().at(omega).unwrap();
        let of_line = |load, entry| line.frequency_response(load, entry).unwrap().at(omega).unwrap();
        let (tip, end) = (Tree::beam_5.output(), Line::conn_tip);
        let pairs = [
            (of_tree(tip.force(), tip.deflection()), of_line(end.force_y(), end.displacement_y())),
            (of_tree(tip.torque(), Tree::conn_2.rotation()), of_line(end.torque_z(), Line::conn_2.rotation_z())),
            (of_tree(Tree::conn_2.force(), tip.rotation()), of_line(Line::conn_2.force_y(), end.rotation_z())),
            (
                of_tree(tip.force(), Tree::beam_1.input().moment()),
                of_line(end.force_y(), Line::beam_1.input().moment()),
            ),
        ];
        for (one, other) in pairs {
            close(one, other, one.abs().max(1e-9), "response");
        }
        // what acts at one point and is seen at another is the same the other way round
        let [there, back] =
            [of_line(end.force_y(), Line::conn_2.rotation_z()), of_line(Line::conn_2.torque_z(), end.displacement_y())];
        close(there, back, there.abs(), "reciprocity");
    }
}

#[test]
fn sensitivities_by_charts_are_those_by_minors() {
    let (tree, line) = both();
    let roots = [tree.first_frequencies::<6>().unwrap(), line.first_frequencies::<6>().unwrap()];
    for (root, other) in roots[0].iter().zip(roots[1].iter()) {
        let (one, two) = (tree.sensitivity(root).unwrap(), line.sensitivity(other).unwrap());
        for ((name, slope), (_, other)) in one.iter().zip(two.iter()) {
            close(slope, other, slope.abs().max(1e-6 * root.omega), name);
        }
    }
}
