//! Sketches with one coordinate against trees of the same beams.

use super::{assert_near, eigenvalues, frequencies};
use crate::overall::{LOW, Report, double, largest_difference, quotient};
use mstmm::number::DoubleDouble;
use mstmm::prelude::*;

mod trees {
    use mstmm::prelude::*;

    system! {
        /// Two spans with an oscillator between them, a hinge, and a body at the end.
        pub(super) struct Spans { pub(super) l: f64, pub(super) ei: f64, pub(super) m: f64, pub(super) k: f64, pub(super) mass: f64 }

        fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> conn 2
            -> beam 3 { length: 2.0 * l, bending_stiffness: ei, mass_per_length: 2.0 * m }
            -> hinge 4 { stiffness_y: k, stiffness_rz: 0.3 * k } -> beam 5 { length: l, bending_stiffness: ei, mass_per_length: m }
            -> body 6 { mass, inertia_about_input: 0.125 + mass * 0.0625, output_x: 0.5, centre_x: 0.25 } -> conn 7 -> free;
        conn 2 <- spring 8 { stiffness: k } <- mass 9 { mass } <- spring 10 { stiffness: 0.5 * k } <- fixed;
        conn 2 <- torsion_spring 11 { stiffness: k } <- inertia 12 { inertia: 0.2 * mass } <- free;
        conn 7 <- spring 13 { stiffness: k } <- fixed;
    }

    system! {
        /// A beam on a damper, with a damped absorber.
        pub(super) struct Damped { pub(super) l: f64, pub(super) k: f64, pub(super) c: f64 }

        pinned -> beam 1 { length: l, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
            -> beam 3 { length: 0.5 * l, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 4
            -> beam 5 { length: l, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
        conn 2 <- damper 6 { damping: c } <- fixed;
        conn 4 <- spring 7 { stiffness: k, damping: c } <- mass 8 { mass: 0.3 } <- free;
    }
}

mod sketches {
    use mstmm::prelude::*;

    system! {
        pub(super) struct Spans { pub(super) l: f64, pub(super) ei: f64, pub(super) m: f64, pub(super) k: f64, pub(super) mass: f64 }

        fixed at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: m } -> conn 2 at l
            -> beam 3 { bending_stiffness: ei, mass_per_length: 2.0 * m }
            -> conn h at 3.0 * l -> hinge 4 { stiffness_y: k, stiffness_rz: 0.3 * k }
            -> beam 5 { bending_stiffness: ei, mass_per_length: m } -> conn e at 4.0 * l
            -> rigid_body 6 { mass, inertia: 0.125, centre: 4.0 * l + 0.25 } -> conn 7 at 4.0 * l + 0.5;
        conn 2 <- spring 8 { stiffness: k } <- mass 9 { mass } <- spring 10 { stiffness: 0.5 * k } <- fixed;
        conn 2 <- torsion_spring 11 { stiffness: k } <- inertia 12 { inertia: 0.2 * mass } <- free;
        conn 7 <- spring 13 { stiffness: k } <- fixed;
    }

    system! {
        /// The arrows of beams do not lead in one direction.
        pub(super) struct Damped { pub(super) l: f64, pub(super) k: f64, pub(super) c: f64 }

        pinned at 0.0 -> beam 1 { bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2 at l
            <- beam 3 { bending_stiffness: 1.0, mass_per_length: 1.0 } <- conn 4 at 1.5 * l;
        conn 4 -> beam 5 { bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned at 2.5 * l;
        conn 2 <- damper 6 { damping: c } <- fixed;
        conn 4 <- spring 7 { stiffness: k, damping: c } <- mass 8 { mass: 0.3 } <- free;
    }
}

mod waves {
    use mstmm::prelude::*;

    system! {
        /// A cantilever that hangs on a string, with a mass and a rod in soil behind it, and a shaft with a flywheel.
        pub(super) struct Tree { pub(super) l: f64, pub(super) h: f64, pub(super) k: f64, pub(super) gj: f64 }

        fixed -> beam 1 { length: l, bending_stiffness: 30.0, mass_per_length: 2.0 } -> conn 2
            -> beam 3 { length: 2.0 * l, bending_stiffness: 30.0, mass_per_length: 2.0 } -> free;
        conn 2 <- string 4 { length: 0.8, tension: h, mass_per_length: 0.3, foundation_stiffness: k } <- mass 5 { mass: 0.2 }
            <- rod 6 { length: 0.5, axial_stiffness: 2.0 * h, mass_per_length: 0.5, foundation_stiffness: 0.0 } <- fixed;
        conn 2 <- shaft 7 { length: 1.1, torsional_stiffness: gj, inertia_per_length: 0.1 } <- inertia 8 { inertia: 0.04 } <- free;
    }

    system! {
        pub(super) struct Line { pub(super) l: f64, pub(super) h: f64, pub(super) k: f64, pub(super) gj: f64 }

        fixed at 0.0 -> beam 1 { bending_stiffness: 30.0, mass_per_length: 2.0 } -> conn 2 at l
            -> beam 3 { bending_stiffness: 30.0, mass_per_length: 2.0 } -> conn tip at 3.0 * l;
        conn 2 <- string 4 { length: 0.8, tension: h, mass_per_length: 0.3, foundation_stiffness: k } <- mass 5 { mass: 0.2 }
            <- rod 6 { length: 0.5, axial_stiffness: 2.0 * h, mass_per_length: 0.5, foundation_stiffness: 0.0 } <- fixed;
        conn 2 <- shaft 7 { length: 1.1, torsional_stiffness: gj, inertia_per_length: 0.1 } <- inertia 8 { inertia: 0.04 } <- free;
    }
}

/// By minors and by stiffnesses, below the cut-on of the string and above.
#[test]
fn paths_with_waves_have_the_frequencies_and_shapes_of_their_tree() {
    for k in [0.0, 4.0, 3e4] {
        let (l, h, gj) = (1.5, 25.0, 6.0);
        let tree = waves::Tree { l, h, k, gj }.build().unwrap();
        let line = waves::Line { l, h, k, gj }.build().unwrap();
        assert_near(&frequencies(&line), &frequencies(&tree), 1e-13);
        let roots = [tree.first_frequencies::<20>().unwrap(), line.first_frequencies::<20>().unwrap()];
        for (root, other) in roots[0].iter().zip(&roots[1]) {
            let (shape, other) = (tree.mode_shape(root).unwrap(), line.mode_shape(other).unwrap());
            let tip = shape.state(waves::Tree::beam_3.output());
            let theirs = other.value(waves::Line::conn_tip.displacement_y()).unwrap();
            let sign = (tip.y * theirs).signum();
            let near = |one: f64, other: f64, scale: f64| {
                assert!(
                    (one - sign * other).abs() <= 1e-10 * scale,
                    "{one} by minors, {other} by stiffnesses at {root}"
                );
            };
            near(tip.y, theirs, 3.0);
            for part in [0.2, 0.7] {
                // a path has its motion as x
                let inside = shape.along(waves::Tree::string_4, 0.8 * part).unwrap();
                let theirs = other.along(waves::Line::string_4, 0.8 * part).unwrap();
                near(inside.y, theirs.displacement_x, 6.0 * (1.0 + root.omega));
                let inside = shape.along(waves::Tree::shaft_7, 1.1 * part).unwrap();
                let theirs = other.along(waves::Line::shaft_7, 1.1 * part).unwrap();
                near(inside.theta, theirs.rotation_z, 6.0 * (1.0 + root.omega));
                near(inside.m, theirs.moment, 36.0 * (1.0 + root.omega));
            }
        }
    }
}

#[test]
fn a_line_has_the_frequencies_of_its_tree() {
    let (l, ei, m, k, mass) = (1.5, 30.0, 2.0, 40.0, 3.0);
    let tree = trees::Spans { l, ei, m, k, mass }.build().unwrap();
    let sketch = sketches::Spans { l, ei, m, k, mass }.build().unwrap();
    assert_near(&frequencies(&sketch), &frequencies(&tree), 1e-13);
}

#[test]
fn a_damped_line_has_the_eigenvalues_of_its_tree() {
    let (l, k, c) = (1.5, 2.0, 0.4);
    let tree = trees::Damped { l, k, c }.build().unwrap();
    let sketch = sketches::Damped { l, k, c }.build().unwrap();
    let region = || Region { re: -3.0..=0.5, im: -1.0..=30.0 };
    assert_eq!(sketch.count_in(region()), tree.count_in(region()));
    for (one, other) in eigenvalues(&sketch).iter().zip(eigenvalues(&tree)) {
        assert!((one - other).norm() < 1e-11 * other.norm(), "{one} and {other}");
    }
}

/// The overall matrices differ in their unknowns, where the body of the tree is a node, and their determinants in nothing but a constant.
#[test]
fn a_line_has_the_overall_determinant_of_its_tree() {
    let mut report = Report::default();
    let (l, ei, m, k, mass) = (1.5, 30.0, 2.0, 40.0, 3.0);
    let tree = trees::Spans { l, ei, m, k, mass }.build_as::<DoubleDouble>().unwrap();
    let sketch = sketches::Spans { l, ei, m, k, mass }.build_as::<DoubleDouble>().unwrap();
    let constant =
        LOW.map(|omega| quotient(sketch.overall_determinant(double(omega)), tree.overall_determinant(double(omega))));
    report.add("spans", LOW[0], (sketches::SpansSystem::N, largest_difference(&constant)));
    let (l, k, c) = (1.5, 2.0, 0.4);
    let tree = trees::Damped { l, k, c }.build_as::<DoubleDouble>().unwrap();
    let sketch = sketches::Damped { l, k, c }.build_as::<DoubleDouble>().unwrap();
    let constant = LOW.map(|part| {
        let lambda = Complex::new(double(0.2 - 0.3 * part), double(part));
        quotient(sketch.overall_determinant(lambda), tree.overall_determinant(lambda))
    });
    report.add("damped", LOW[0], (sketches::DampedSystem::N, largest_difference(&constant)));
    report.judge();
}

system! {
    /// Two beams with a pin over the support between them.
    struct PinnedSpans { length: f64 }

    pinned at 0.0 -> beam 1 { bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn middle at length <- pinned;
    conn middle -> pin 2 {} -> beam 3 { bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned at 2.0 * length;
}

/// Closed form: each span moves by itself, `ω = (n π/l)²`.
#[test]
fn a_pin_over_a_support_parts_two_spans() {
    let system = PinnedSpans { length: 1.0 }.build().unwrap();
    for (mode, found) in (1_u8..).zip(&system.first_frequencies::<6>().unwrap()) {
        let exact = (f64::from(mode) * std::f64::consts::PI).powi(2);
        assert_eq!(found.multiplicity, 2);
        assert!((found.omega - exact).abs() <= 1e-14 * exact, "{found}");
    }
}
