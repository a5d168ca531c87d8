//! Messages about places: how many coordinates they have, who needs one, and that none is said twice.

use super::assert_refused;

#[test]
fn all_points_have_equally_many_coordinates() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at l -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
                         ^ the place of `conn a` has one coordinate, that of `fixed` two: all points of a
                         | model have equally many, and those of several are tuples where they stand
            -> fixed at (l, l, l);
                        ^^^^^^^^^ the place of `fixed` has three coordinates, that of `fixed` two: all points
                        | of a model have equally many
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        fixed at 0.0 -> beam 1 { bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0);
                         ^^^^^^^^ the place of `conn a` has two coordinates, that of `fixed` one: all points
                         | of a model have equally many
        ",
    );
}

#[test]
fn a_place_has_one_to_three_coordinates() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0,) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
                 ^^^^^^ a tuple of one is no place: a point has two coordinates, `at (x, y)`, or three, `at
                 | (x, y, z)`; one is written without parentheses, `at x`
            -> conn a at (l, 0.0, 0.0, l) -> beam 2
                         ^^^^^^^^^^^^^^^^ a tuple of four is no place: a point has two coordinates, `at (x,
                         | y)`, or three, `at (x, y, z)`; one is written without parentheses, `at x`
            { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> fixed at ();
                        ^^ a tuple of none is no place: a point has two coordinates, `at (x, y)`, or three,
                        | `at (x, y, z)`; one is written without parentheses, `at x`
        ",
    );
}

#[test]
fn a_place_is_said_once() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0);
                      ^^ the place of `conn a` is said here first
        conn a at (l, 0.0) -> spring 2 { stiffness: l } -> conn b at (l, l) <- fixed;
               ^^ the place of `conn a` is said already: `at` stands at one mention of a point, so remove this
               | one
        ",
    );
}

#[test]
fn a_support_takes_the_place_of_its_connection() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> conn a -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
              ^^ `fixed` is at the place of `conn a`, which it holds: write `at` behind `conn a` alone
            -> conn b at (l, 0.0) <- pinned at (l, 0.0);
                                            ^^ `pinned` is at the place of `conn b`, which it holds: write
                                            | `at` behind `conn b` alone
        ",
    );
}

#[test]
fn a_joint_has_no_extent() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0) -> pin 2 {} -> conn b at (l, 0.0)
                                                        ^^ `conn b` is at the place of `conn a`, since `pin 2`
                                                        | has no extent: remove this `at`
            -> beam 3 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> fixed at (l, l);
        ",
    );
}

#[test]
fn an_element_with_extent_has_places_at_both_ends() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0);
        ^^^^^ `fixed` has no place, which `beam 1` needs there: write `fixed at (x, y)`
        conn a -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn b;
               ^^^^^^ `conn b` has no place, which `beam 2` needs there: write `conn b at (x, y)`
        conn b -> spring 3 { stiffness: l } -> conn c at (0.0, l) <- fixed;
        conn c -> rigid_body 4 { mass: l, inertia: l, centre: (l, l) } <- conn d;
                                                                          ^^^^^^ `conn d` has no place, which
                                                                          | `rigid_body 4` needs there: write
                                                                          | `conn d at (x, y)`
        conn d <- pinned;
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> pin 2 {} -> beam 3 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
               ^^^^^ `pin 2` stands at no place: put a connection beside it, `-> conn a at (x, y) -> pin 2`
            -> point_mass 4 { mass: l } -> beam 5
               ^^^^^^^^^^^^ `point_mass 4` stands at no place: put a connection beside it, `-> conn a at (x,
               | y) -> point_mass 4`
            { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> fixed at (l, l);
        ",
    );
}

#[test]
fn elements_with_extent_meet_at_a_connection() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            ^^ `beam 1` and `beam 2` meet at a point that has no place: put a connection between them, `->
            | conn a at (x, y) ->`
            -> rigid_body 3 { mass: l, inertia: l, centre: (l, l) } -> spring 4 { stiffness: l } -> conn a at (l, l) <- fixed;
            ^^ `beam 2` and `rigid_body 3` meet at a point that has no place: put a connection between them,
            | `-> conn a at (x, y) ->`
                                                                    ^^ `rigid_body 3` and `spring 4` meet at a
                                                                    | point that has no place: put a
                                                                    | connection between them, `-> conn a at
                                                                    | (x, y) ->`
        ",
    );
}

#[test]
fn an_arrow_has_no_extent() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0) -> conn b at (l, l)
                                  ^^ `conn a` and `conn b` have a place each, and an arrow has no extent: put
                                  | an element between them
            <- beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } <- fixed at (0.0, l);
        ",
    );
}

#[test]
fn an_element_leads_from_one_point_to_another() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0);
        conn a -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn b;
                  ^^^^^^ `beam 2` begins and ends at one place: lead it from one point to another
        conn a -> pin 3 {} -> conn b;
        conn a -> slider 4 { along: (1.0, 0.0) } -> conn a;
                  ^^^^^^^^ `slider 4` joins a point to itself: give its other side a connection of its own
        conn a -> along (1.0, 0.0) -> spring 5 { stiffness: l } -> conn u -> spring 6 { stiffness: l } -> conn u;
                                                                             ^^^^^^^^ `spring 6` joins a point
                                                                             | to itself: lead it from one
                                                                             | point to another
        ",
    );
}

/// A connection beside one with a place is no point of its own, unless a path of one motion begins there.
#[test]
fn an_arrow_to_a_point_with_a_place_is_that_point() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0) -> conn b
                                     ^^^^^^ `conn b` is at the place of `conn a`, since an arrow has no
                                     | extent: write `conn a` in both paths
            -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> fixed at (l, l);
        conn a <- along (1.0, 0.0) <- conn u -> spring 3 { stiffness: l } -> fixed;
        conn a -> spring 4 { stiffness: l };
                  ^^^^^^^^ `spring 4` has no output: end its path with a support or a connection
        fixed -> conn c -> conn d;
                 ^^^^^^ `conn c` joins no element: let the path of an element end in it
        ",
    );
}

#[test]
fn an_element_has_no_place() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 
            { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } at (l, 0.0) -> conn a at (l, 0.0);
                                                                             ^^ `beam 1` has no place of its
                                                                             | own: points have places, so
                                                                             | write `at` behind the
                                                                             | connections around it
        ",
    );
}

#[test]
fn a_model_is_one_structure() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0);
        fixed at (0.0, l) -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
                             ^^^^^^ no path joins `beam 2` to what is written before it: a model is one
                             | structure, so name a connection of it here
            -> conn b at (l, l);
        conn c at (0.0, 2.0);
        ^^^^^^ `conn c` is joined to nothing: let the path of an element end in it
        ",
    );
}

#[test]
fn arrows_say_input_and_output() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            <- conn a at (l, 0.0) <- pin 2 {} -> conn b;
            ^^ `beam 1` has two inputs, but one end of an element is its input and the other its output: turn
            | one of the arrows round
                                              ^^ `pin 2` has two outputs, but one end of an element is its
                                              | input and the other its output: turn one of the arrows round
                                     ^^^^^ `pin 2` joins a point to itself: give its other side a connection
                                     | of its own
        conn b -> beam 3 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l };
                  ^^^^^^ `beam 3` has no output: end its path with a support or a connection
        rigid_body 4 { mass: l, inertia: l, centre: (l, l) };
        ^^^^^^^^^^^^ `rigid_body 4` is joined to nothing: lead an arrow to it from a connection with a place
        conn b -> conn b;
               ^^ `conn b` is joined to itself: lead this arrow on to an element
        conn c at (1.0, 1.0) <- pinned;
        ^^^^^^ `conn c` joins no element: let the path of an element end in it
        pinned at (0.0, 1.0);
        ^^^^^^ `pinned` holds nothing: join it to an element or a connection by an arrow
        conn a -> pinned at (0.0, 1.0) -> conn b;
                  ^^^^^^ `pinned` stands in the middle of a path, but a support ends one: hold a point in
                  | between by a connection, `support -> conn ..`
                         ^^ `pinned` is at the place of `conn a`, which it holds: write `at` behind `conn a`
                         | alone
        ",
    );
}
