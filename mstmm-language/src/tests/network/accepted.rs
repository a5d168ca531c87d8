//! Models that are right, and the networks that they describe.

use super::described;
use expect_test::{Expect, expect};

#[track_caller]
fn check(model: &str, network: Expect) {
    network.assert_eq(&described(model));
}

/// The portal frame of the documentation.
#[test]
fn portal_frame() {
    check(
        "
        struct Portal { height: f64, span: f64, ea: f64, ei: f64, m: f64, brace: f64, machine: f64, inertia: f64 }
        fixed at (0.0, 0.0)
            -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
            -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
            -> conn m at (0.5 * span, height)
            -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
            -> pin 4 {} -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
            -> pinned at (span, 0.0);
        conn b -> spring 6 { stiffness: brace } -> conn g at (0.4 * span, 0.0) <- fixed;
        conn m -> rigid_body 7 { mass: machine, inertia, centre: (0.5 * span, height + 0.3) };
        ",
        expect![[r#"
            Plane
            place 0: 0.0, 0.0
            place 1: 0.0, height
            place 2: 0.5 * span, height
            place 3: span, height
            place 4: span, 0.0
            place 5: 0.4 * span, 0.0
            point 0: place 0, moves x y rz
            point 1: conn b, place 1, moves x y rz
            point 2: conn m, place 2, moves x y rz
            point 3: conn c, place 3, moves x y rz
            point 4: place 4, moves x y rz
            point 5: conn g, place 5, moves x y
            point 6: place 3, moves x y rz
            fixed of point 0: holds x y rz
            pinned of point 4: holds x y
            fixed of point 5: holds x y
            beam 1: from point 0 to point 1
            beam 2: from point 1 to point 2
            beam 3: from point 2 to point 3
            beam 5: from point 6 to point 4
            pin 4: from point 3 to point 6 
            rigid_body 7: centre 0.5 * span, height + 0.3, ties points [2]
            path of translation
              motion 0: moves
              motion 1: moves
              spring 6: from motion 0 to motion 1
              motion 0 is that of point 1 from point 1 to point 5
              motion 1 is that of point 5 from point 1 to point 5
        "#]],
    );
}

/// A loop, arrows against each other, a place at a later mention, a body with three points and a free end with a name.
#[test]
fn loops_and_bodies() {
    check(
        "
        struct M { a: f64 }
        conn a -> beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b at (a, 0.0);
        conn a -> beam 2 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b;
        conn b <- beam 3 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } <- free at (a, a);
        conn b -> rigid_body hub { mass: 1.0, inertia: 0.1, centre: (a, -0.1) } <- conn c at (1.5 * a, 0.0);
        rigid_body hub <- pin 5 {} <- conn d at (a, -a);
        conn c -> beam 6 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn e at (2.0, 0.0);
        conn d -> point_mass 7 { mass: 1.0 } <- roller along (1.0, a);
        conn a at (0.0, 0.0) <- held(x, rz);
        ",
        expect![[r#"
            Plane
            place 0: a, 0.0
            place 1: a, a
            place 2: 1.5 * a, 0.0
            place 3: a, - a
            place 4: 2.0, 0.0
            place 5: 0.0, 0.0
            point 0: conn a, place 5, moves x y rz
            point 1: conn b, place 0, moves x y rz
            point 2: place 1, moves x y rz
            point 3: conn c, place 2, moves x y rz
            point 4: conn d, place 3, moves x y
            point 5: conn e, place 4, moves x y rz
            point 6: place 3, moves x y rz
            free of point 2: holds nothing
            roller of point 4: holds across 1.0, a, and nothing
            held of point 0: holds x rz
            beam 1: from point 0 to point 1
            beam 2: from point 0 to point 1
            beam 3: from point 2 to point 1
            beam 6: from point 3 to point 5
            pin 5: from point 4 to point 6 
            rigid_body hub: centre a, - 0.1, ties points [1, 3, 6]
            point_mass 7: at point 4
        "#]],
    );
}

/// Springs between points, with directions of their own, and at joints in series.
#[test]
fn paths_of_one_motion() {
    check(
        "
        struct M { k: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k }
            -> conn a at (1.0, 0.0) -> pin 2 {} -> slider 3 { along: (0.0, 1.0) } -> conn b
            -> beam 4 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> conn c at (2.0, 0.0);
        conn a <- along (0.0, 1.0) <- spring 5 { stiffness: k } <- mass 6 { mass: k } <- conn u;
        conn u <- spring 7 { stiffness: k } <- along (1.0, 0.0) <- conn c;
        conn u <- along (k, 1.0) <- conn b;
        conn u <- damper 8 { damping: k } <- fixed;
        conn c <- torsion_spring 9 { stiffness: k } <- inertia 10 { inertia: k } <- free;
        ",
        expect![[r#"
            Plane
            place 0: 0.0, 0.0
            place 1: 1.0, 0.0
            place 2: 2.0, 0.0
            point 0: place 0, moves x y rz
            point 1: conn a, place 1, moves x y rz
            point 2: conn b, place 1, moves x y rz
            point 3: conn c, place 2, moves x y rz
            point 4: place 1, moves x y rz
            fixed of point 0: holds x y rz
            beam 1: from point 0 to point 1
            beam 4: from point 2 to point 3
            pin 2: from point 1 to point 4 
            slider 3: from point 4 to point 2 0.0, 1.0
            path of translation
              motion 0: conn u, moves
              motion 1: held
              motion 2: moves
              motion 3: moves
              motion 4: moves
              spring 5: from motion 3 to motion 2
              mass 6: from motion 0 to motion 3
              spring 7: from motion 4 to motion 0
              damper 8: from motion 1 to motion 0
              motion 2 is that of point 1 along 0.0, 1.0
              motion 4 is that of point 3 along 1.0, 0.0
              motion 0 is that of point 2 along k, 1.0
            path of rotation
              motion 0: moves
              motion 1: moves
              motion 2: moves
              torsion_spring 9: from motion 2 to motion 1
              inertia 10: from motion 0 to motion 2
              motion 1 is that of point 3 about z
        "#]],
    );
}

/// One coordinate: beams along a line, paths across it.
#[test]
fn a_line() {
    check(
        "
        struct M { l: f64, k: f64 }
        fixed at 0.0 -> beam 1 { bending_stiffness: k, mass_per_length: k } -> conn a at 0.3 * l <- beam 2
            { bending_stiffness: k, mass_per_length: k } <- pinned at { l };
        conn a -> spring 3 { stiffness: k } -> mass 4 { mass: k } -> free;
        conn a -> rigid_body 5 { mass: k, inertia: k, centre: 0.3 * l + 0.1 };
        ",
        expect![[r#"
            Line
            place 0: 0.0
            place 1: 0.3 * l
            place 2: { l }
            point 0: place 0, moves y rz
            point 1: conn a, place 1, moves y rz
            point 2: place 2, moves y rz
            fixed of point 0: holds y rz
            pinned of point 2: holds y
            beam 1: from point 0 to point 1
            beam 2: from point 2 to point 1
            rigid_body 5: centre 0.3 * l + 0.1, ties points [1]
            path of translation
              motion 0: moves
              motion 1: moves
              motion 2: moves
              spring 3: from motion 1 to motion 2
              mass 4: from motion 2 to motion 0
              motion 1 is that of point 1 along y
        "#]],
    );
}
