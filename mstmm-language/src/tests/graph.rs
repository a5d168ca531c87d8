//! Messages about the graph.

use super::{assert_refused, expanded};

#[test]
fn elements_share_one_set_of_labels() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> mass 1 { mass: 1.0 } -> free;
                                                     ^ label `1` is taken by `spring 1`: elements share one
                                                     | set of labels, and an element is written once
        fixed -> spring arm { stiffness: 1.0 } -> conn arm -> mass arm { mass: 1.0 } -> free;
                                                                   ^^^ label `arm` is taken by `spring arm`:
                                                                   | elements share one set of labels, and an
                                                                   | element is written once
        ",
    );
}

/// Both sets may have the same names, of models with places, too.
#[test]
fn connections_have_a_set_of_labels_of_their_own() {
    let tree =
        "struct M; fixed -> beam a { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a -> free";
    let located = "struct M; fixed at 0.0 -> beam a { bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a at 1.0";
    for model in [tree, located] {
        let code = expanded(model);
        assert!(code.contains("const conn_a :") && code.contains("const beam_a :"), "{code}");
    }
}

#[test]
fn a_support_ends_a_path() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> pinned -> spring 2 { stiffness: 1.0 } -> free;
                                                ^^^^^^ `pinned` stands in the middle of a path, but a support
                                                | ends one: hold a point in between by a connection, `support
                                                | -> conn ..`
        ",
    );
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> pinned <- spring 2 { stiffness: 1.0 } <- free;
                                                ^^^^^^ `pinned` stands in the middle of a path, but a support
                                                | ends one: hold a point in between by a connection, `support
                                                | -> conn ..`
        ",
    );
}

#[test]
fn a_support_holds_something() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> free;
        pinned;
        ^^^^^^ `pinned` holds nothing: join it to an element or a connection by an arrow
        ",
    );
}

#[test]
fn an_element_has_one_input_and_one_output() {
    assert_refused(
        "
        struct M;
        spring 1 { stiffness: 1.0 };
        ^^^^^^^^ `spring 1` is joined to nothing: begin and end its path with a support or a connection
        spring 2 { stiffness: 1.0 } -> free;
        ^^^^^^^^ `spring 2` has no input: begin its path with a support or a connection
        fixed -> spring 3 { stiffness: 1.0 };
                 ^^^^^^^^ `spring 3` has no output: end its path with a support or a connection
        fixed -> spring 4 { stiffness: 1.0 } <- fixed;
                                             ^^ `spring 4` has two inputs, but one arrow leads in and the
                                             | other on to the root: turn one of them round
        free <- spring 5 { stiffness: 1.0 } -> free;
                                            ^^ `spring 5` has two outputs, but every arrow leads to the one
                                            | root: turn the arrows of one of the two paths round
        ",
    );
}

#[test]
fn a_connection_has_inputs_and_one_output() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> conn 2 <- spring 3 { stiffness: 1.0 } <- fixed;
                                                ^^^^^^ `conn 2` has no output: lead it on to the root
        conn 4 -> spring 5 { stiffness: 1.0 } -> free;
        ^^^^^^ `conn 4` has no input: let paths end in it
        conn six;
        ^^^^^^^^ `conn six` has no output: lead it on to the root
        ",
    );
}

/// A beam over three supports, the middle one drawn as if it were another root.
#[test]
fn a_connection_has_one_output() {
    assert_refused(
        "
        struct M;
        pinned -> mass 1 { mass: 1.000 } -> conn 2 -> mass 3 { mass: 1.000 } -> pinned;
        conn 2 -> pinned;
               ^^ `conn 2` has two outputs, but every arrow leads to the one root: turn the arrows of one of
               | the two paths round
        ",
    );
}

#[test]
fn two_ways_between_two_connections_are_a_loop() {
    assert_refused(
        "
        struct Frame;
        fixed -> mass 1 { mass: 1.000 } -> conn 2 -> mass 3 { mass: 1.000 } -> conn 4 -> free;
        conn 2 -> mass 5 { mass: 1.000 } -> conn 4;
               ^^ `conn 2` has two outputs, and this one is part of a closed loop: a model without places is a
               | tree of paths; cut the loop open, or give its connections and supports places, `at (x, y)`
        ",
    );
    assert_refused(
        "
        struct Frame;
        fixed -> mass 1 { mass: 1.000 } -> conn 2 -> mass 3 { mass: 1.000 } -> conn 2 -> free;
                                                  ^^ `conn 2` has two outputs, and this one is part of a
                                                  | closed loop: a model without places is a tree of paths;
                                                  | cut the loop open, or give its connections and supports
                                                  | places, `at (x, y)`
        ",
    );
}

#[test]
fn arrows_that_come_back_are_a_loop() {
    assert_refused(
        "
        struct M;
        fixed -> mass 1 { mass: 1.000 } -> free;
        fixed -> mass 2 { mass: 1.000 } -> conn 3 -> mass 4 { mass: 1.000 } -> conn 5 -> mass 6 { mass: 1.000 } -> conn 3;
                                           ^^^^^^ `conn 3` does not lead to the root, but round in a loop of
                                           | arrows back to itself: turn one of them to a support
        ",
    );
    assert_refused(
        "
        struct M;
        conn 1 -> mass 2 { mass: 1.000 } -> conn 1;
        ^^^^^^ `conn 1` does not lead to the root, but round in a loop of arrows back to itself: turn one of
        | them to a support
        ",
    );
}

#[test]
fn a_connection_is_not_joined_to_itself() {
    assert_refused(
        "
        struct M;
        fixed -> mass 1 { mass: 1.000 } -> conn 2 -> conn 2 -> free;
                                                  ^^ `conn 2` is joined to itself: lead this arrow on to an
                                                  | element or to the root
        ",
    );
}

#[test]
fn a_connection_joins_elements() {
    assert_refused(
        "
        struct M;
        fixed -> mass 1 { mass: 1.000 } -> conn 2 -> free;
        pinned -> conn 3 <- free;
                  ^^^^^^ `conn 3` joins no element: let the path of an element end in it
        conn 3 -> conn 2;
        ",
    );
}

#[test]
fn a_model_is_one_tree() {
    assert_refused(
        "
        struct M;
        fixed -> mass 1 { mass: 1.000 } -> free;
        fixed -> mass 2 { mass: 1.000 } -> pinned;
                                           ^^^^^^ `pinned` is a second root: no path joins this part of the
                                           | model to the first; a model is one tree
        fixed -> mass 3 { mass: 1.000 } -> guided;
                                           ^^^^^^ `guided` is a second root: no path joins this part of the
                                           | model to the first; a model is one tree
        ",
    );
}

/// What is wrong at one end of a model does not hide what is wrong at another.
#[test]
fn faulty_ends_loops_and_roots_are_shown_together() {
    assert_refused(
        "
        struct M;
        fixed -> mass 1 { mass: 1.000 } -> conn 2;
                                           ^^^^^^ `conn 2` has no output: lead it on to the root
        fixed -> mass 3 { mass: 1.000 } -> free;
        fixed -> mass 4 { mass: 1.000 } -> pinned;
                                           ^^^^^^ `pinned` is a second root: no path joins this part of the
                                           | model to the first; a model is one tree
        fixed -> mass 5 { mass: 1.000 } -> conn 6 -> mass 7 { mass: 1.000 } -> conn 6;
                                           ^^^^^^ `conn 6` does not lead to the root, but round in a loop of
                                           | arrows back to itself: turn one of them to a support
        ",
    );
}
