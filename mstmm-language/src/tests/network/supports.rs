//! Messages about supports.

use super::assert_refused;

#[test]
fn a_point_has_one_support() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0) <- roller;
        conn a <- held(rz);
                  ^^^^ `held` is a second support of `conn a`, which `roller` holds: one support says all that
                  | is held, such as `held(x, rz)`
        fixed -> pinned;
              ^^ this arrow joins two supports, `fixed` and `pinned`: put an element between them
        ",
    );
}

#[test]
fn held_names_freedoms_that_there_are() {
    assert_refused(
        "
        struct M { l: f64 }
        held(x, y, z) at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
                   ^ `z` is no freedom of this model: a point has `x`, `y` and `rz`
            -> conn c at (l, 0.0) <- held(x, y, x);
                                                ^ `x` is held already: remove one of the two
        conn c -> beam 4 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a;
        held() at (0.0, l) -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a;
        ^^^^ `held()` holds nothing: name its freedoms, or write `free`
        conn a at (l, l) -> spring 3 { stiffness: l } -> conn b at (l, 0.0);
        held(x, rz) along (1.0, 0.0) -> conn a;
                    ^^^^^ `held` takes no `along`, since its freedoms are those of the axes: a skew support is
                    | `roller along (dx, dy)`
        held(x, rz) -> conn b;
                ^^ no element at `conn b` has the freedom `rz`: remove it
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        held(x, y) at 0.0 -> beam 1 { bending_stiffness: l, mass_per_length: l }
             ^ `x` is no freedom of this model: a point has `y` and `rz`
            -> roller at l;
               ^^^^^^ `roller` holds nothing along a line that `pinned` does not: write `pinned`
        ",
    );
}

#[test]
fn some_supports_have_directions() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) along (1.0, 0.0) -> beam 1
                            ^^^^^ `fixed` is alike in all directions: remove `along`, which `roller` and
                            | `guided` take
            { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0);
        pinned along (1.0, 0.0) -> conn a;
               ^^^^^ `pinned` is alike in all directions: remove `along`, which `roller` and `guided` take
        roller at (0.0, l) along l -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
                                 ^ a direction of the plane has two parts, `along (dx, dy)`
            -> conn a -> beam 3 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> guided at (l, l) along (1.0, 0.0, 0.0);
                                      ^^^^^^^^^^^^^^^ a direction of the plane has two parts, `along (dx, dy)`
        ",
    );
}

#[test]
fn a_path_of_one_motion_is_held_or_free() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0);
        conn a <- along (1.0, 0.0) <- spring 2 { stiffness: l } <- pinned;
                                                                   ^^^^^^ `pinned` is no support of a path of
                                                                   | springs, dampers and masses: its one
                                                                   | motion is held by `fixed`, or `free`
        conn a <- along (0.0, 1.0) <- spring 3 { stiffness: l } <- conn u <- held(x);
                                                                             ^^^^ `held` is no support of a
                                                                             | path of springs, dampers and
                                                                             | masses: its one motion is held
                                                                             | by `fixed`, or `free`
        ",
    );
}

#[test]
fn supports_have_known_names() {
    assert_refused(
        "
        struct M { l: f64 }
        fixd at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        ^^^^ `fixd` is not a support: did you mean `fixed`?
            -> wall at (l, 0.0);
               ^^^^ `wall` is not a support: the supports are `fixed`, `pinned`, `free`, `guided`, `roller`
               | and `held`
        ",
    );
}
