//! Messages about keywords and parameters of models with places.

use super::assert_refused;

#[test]
fn each_dimension_has_its_keywords() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0)
                               ^^^^^^ `beam 1` lacks `axial_stiffness`: in the plane a beam stretches, too; a
                               | large number is one that hardly does
            -> body 2 { mass: l, inertia: l, output_x: l, centre_x: l } -> conn b at (l, l)
               ^^^^ `body` has its points by offsets, which places replace: take `rigid_body`
            -> elastic_hinge 3 { stiffness_y: l, stiffness_theta: l } -> fixed;
               ^^^^^^^^^^^^^ `elastic_hinge` is `hinge` now: write `hinge 3 { stiffness_y: l, stiffness_rz: l
               | }`
        conn b -> planar_body 4 { } -> fixed;
                  ^^^^^^^^^^^ `planar_body` has its points by offsets, which places replace: take
                  | `rigid_body`, whose `inertia` is about its mass centre
        conn a -> spatial_beam 5 { } -> plnar_beam 7 { } -> pin8 -> conn b;
                  ^^^^^^^^^^^^ `spatial_beam` is not an element: did you mean `beam`?
                                        ^^^^^^^^^^ `plnar_beam` is not an element: did you mean `beam`?
                                                            ^^^^ `pin8` is not a support: put a space before
                                                            | the label, `pin 8`
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        fixed at 0.0 -> planar_beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at l
                        ^^^^^^^^^^^ `planar_beam` is `beam` now: write `beam 1 { bending_stiffness: l,
                        | mass_per_length: l }`
            -> planar_hinge 2 { stiffness_x: l, stiffness_y: l, stiffness_theta: l } -> fixed;
               ^^^^^^^^^^^^ `planar_hinge` is `hinge` now: write `hinge 2 { stiffness_y: l, stiffness_rz: l }`
        ",
    );
}

#[test]
fn a_parameter_of_another_dimension_is_removed() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at 0.0 -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at l
                                 ^^^^^^^^^^^^^^^ `beam` has no parameter `axial_stiffness`: it has that in the
                                 | plane alone, so remove it
            -> hinge 2 { stiffness_x: l, stiffness_rz: l } -> fixed;
                         ^^^^^^^^^^^ `hinge` has no parameter `stiffness_x`: it has that in the plane alone,
                         | so remove it
        ",
    );
}

/// A tapered beam bends alone.
#[test]
fn tapered_beams_stand_on_lines() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> tapered_beam 1 { bending_stiffness: l, mass_per_length: l, height_taper: 0.5 } -> conn a at (l, l);
                               ^^^^^^^^^^^^ `tapered_beam` does not stretch, so it stands where points have
                               | one coordinate: take `beam`
        fixed at (l, 0.0) -> tapered_beam 2 { length: l, bending_stiffness: l, mass_per_length: l } -> conn a;
                             ^^^^^^^^^^^^ `tapered_beam` does not stretch, so it stands where points have one
                             | coordinate: take `beam`
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        fixed at 0.0 -> tapered_beam 1 { length: l, bending_stiffness: l, mass_per_length: l } -> conn a at l;
                                         ^^^^^^ `tapered_beam 1` takes no `length`, which follows from the
                                         | places of its ends: remove it
        ",
    );
}

/// A bar of a truss stands between places of the plane alone.
#[test]
fn bars_stand_in_trusses() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at 0.0 -> bar 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at l;
                        ^^^ `bar` moves in the plane, but points have one coordinate here: take `beam`
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        fixed -> bar 1 { length: l, axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> free;
                 ^^^ `bar` stands in models whose points have places: say where they are, `conn a at (x, y)`
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        pinned at (0.0, 0.0) -> bar 1 { axial_stiffness: l, mass_per_length: l, bendig_stiffness: l } -> conn a at (l, l)
                                                                                ^^^^^^^^^^^^^^^^ `bar` has no
                                                                                | parameter
                                                                                | `bendig_stiffness`: did you
                                                                                | mean `bending_stiffness`?
            -> truss 2 { axial_stiffness: l } -> pinned at (2.0 * l, 0.0);
               ^^^^^ `truss` is not an element: did you mean `bar`?
        ",
    );
}

#[test]
fn a_length_follows_from_places() {
    assert_refused(
        "
        struct M { length: f64, ea: f64 }
        fixed at (0.0, 0.0) -> beam 1 { length, axial_stiffness: ea, bending_stiffness: ea, mass_per_length: ea }
                                        ^^^^^^ `beam 1` takes no `length`, which follows from the places of
                                        | its ends: remove it
            -> conn a at (length, 0.0) -> beam 2 { axial: ea, bending_stiffness: ea, mass_per_length: ea }
                                                   ^^^^^ `beam` has no parameter `axial`: did you mean
                                                   | `axial_stiffness`?
            -> conn b at (length, ea) -> point_mass 3 { inertia: ea } -> pin 4 -> fixed;
                                         ^^^^^^^^^^^^ `point_mass 3` lacks `mass`
                                                                         ^^^^^ `pin 4` lacks its braces, `pin
                                                                         | 4 {}`
        ",
    );
}

#[test]
fn labels_are_checked() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn 1 at (l, 0.0) -> beam 02 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
                                          ^^ `02` is not a label: a label is a name or a decimal number
                                          | without leading zero or suffix, such as `arm` or `12`
            -> conn b at (l, l) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
                                        ^ label `1` is taken by `beam 1`: elements share one set of labels,
                                        | and an element is written once
            -> fixed at (0.0, l);
        ",
    );
}

/// A line that cannot be read hides what is wrong with the graph, and nothing else.
#[test]
fn words_are_shown_beside_lines_that_cannot_be_read() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { length: l } -> conn a;
                                        ^^^^^^ `beam 1` takes no `length`, which follows from the places of
                                        | its ends: remove it
        conn a at -> conn b;
               ^^ `at` says where a point is: write its coordinates behind, `at (x, y)`
        ",
    );
}

/// Without a place, a model is a tree of paths.
#[test]
fn words_of_models_with_places_need_places() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed -> beam 1 { length: l, axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> rigid_body 2 { } -> pin 3 { } -> roller along (1.0, 0.0);
               ^^^^^^^^^^ `rigid_body` stands in models whose points have places: say where they are, `conn a
               | at (x, y)`
                                   ^^^ `pin` stands in models whose points have places: say where they are,
                                   | `conn a at (x, y)`
                                                       ^^^^^ `along` stands in models whose points have
                                                       | places: say where they are, `conn a at (x, y)`
        free -> mass 6 { mass: l } -> conn 4 -> along (1.0, 0.0) -> spring 5 { stiffness: l }
                                                ^^^^^ `along` stands in models whose points have places: say
                                                | where they are, `conn a at (x, y)`
            -> held(x);
               ^^^^ `held` stands in models whose points have places: say where they are, `conn a at (x, y)`
        ",
    );
}

/// Formulas of places are formulas of the fields like any others.
#[test]
fn places_have_derivatives() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (table(l), 0.0) <- roller along (1.0, l as f32 as f64);
                          ^^^^^ `table` has no derivative that mstmm knows: write the formula here, or mark
                          | `l` with `#[no_sensitivity]`
                                                                 ^^ a cast has no derivative that mstmm knows:
                                                                 | write the formula without it, or mark `l`
                                                                 | with `#[no_sensitivity]`
        conn a <- along (l % 2.0, 1.0) <- spring 2 { stiffness: l } <- fixed;
                           ^ `%` has no derivative that mstmm knows: write the formula without it, or mark `l`
                           | with `#[no_sensitivity]`
        conn a -> rigid_body 3 { mass: l, inertia: l, centre: (table(l), 0.0) };
                                                               ^^^^^ `table` has no derivative that mstmm
                                                               | knows: write the formula here, or mark `l`
                                                               | with `#[no_sensitivity]`
        ",
    );
}

/// Words of one type have others in their place between places, too.
#[test]
fn joints_of_paths_have_others_instead() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> rotational_hinge 1 { stiffness: l } -> conn a at (l, 0.0)
                               ^^^^^^^^^^^^^^^^ `rotational_hinge` is `hinge` now: write `hinge 1 {
                               | stiffness_rz: l }`
            -> shear_hinge 2 { stiffness: l } -> lever 3 { output_x: l } -> fixed;
               ^^^^^^^^^^^ `shear_hinge` is `hinge` now: write `hinge 2 { stiffness_y: l }`
                                                 ^^^^^ `lever` is `rigid_link` now: write `rigid_link 3 {}`
        ",
    );
}
