//! Messages about joints and rigid bodies.

use super::assert_refused;

#[test]
fn a_joint_stands_beside_a_place() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0) -> rigid_body 2 { mass: l, inertia: l, centre: (l, l) }
            -> pin 3 {} -> rigid_body 4 { mass: l, inertia: l, centre: (l, l) };
               ^^^^^ `pin 3` stands at no place: put a connection beside it, `-> conn a at (x, y) -> pin 3`
        ",
    );
}

#[test]
fn a_rigid_body_has_its_parameters_once() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> rigid_body 1 { mass: l, inertia: l, centre: (l, l) } -> conn a at (l, 0.0);
        rigid_body 1 { mass: l, inertia: l, centre: (l, l) } -> conn b at (l, l);
        ^^^^^^^^^^^^ `rigid_body 1` has its parameters already: name it again without braces, `rigid_body 1`
        conn a -> rigid_body 2 -> conn b;
                  ^^^^^^^^^^^^ `rigid_body 2` lacks its parameters, at one of its mentions: `rigid_body 2 {
                  | mass, inertia, centre: (x, y) }`
        rigid_body 2 -> conn c at (0.0, 2.0);
        ",
    );
}

#[test]
fn parts_of_directions_and_places_are_as_many_as_coordinates() {
    assert_refused(
        "
        struct M { l: f64, centre: f64 }
        fixed at (0.0, 0.0) -> rigid_body 1 { mass: l, inertia: l, centre } -> conn a at (l, 0.0);
                                                                   ^^^^^^ `centre` has two parts in the plane,
                                                                   | which are written as a tuple, `centre:
                                                                   | (x, y)`
        conn a -> slider 2 { along: (1.0, 0.0, 0.0) } -> fixed;
                                    ^^^^^^^^^^^^^^^ `along` has two parts in the plane, which are written as a
                                    | tuple, `along: (dx, dy)`
        conn a -> rigid_body 3 { mass: l, inertia: l, centre: l } -> conn b at (1.0, 1.0);
                                                              ^ `centre` has two parts in the plane, which are
                                                              | written as a tuple, `centre: (x, y)`
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        fixed at 0.0 -> rigid_body 1 { mass: l, inertia: l, centre: (l, 0.0) } -> conn a at l;
                                                                    ^^^^^^^^ `centre` is one number where
                                                                    | points have one coordinate: `centre: x`
        conn a -> slider 2 { along: 1.0 } -> fixed;
                  ^^^^^^ `slider` moves in the plane, but points have one coordinate here: take `hinge`
        ",
    );
}
