//! Messages about paths of springs, dampers and masses, and where they act on points.

use super::assert_refused;

#[test]
fn the_direction_of_a_path_is_known() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0) -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn b at (l, l) -> pin 3 {}
            -> beam 4 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn c at (0.0, l);
        conn a -> spring 5 { stiffness: l } -> fixed;
               ^^ the direction of `spring 5` is unknown, since its path meets one point with a place: say it,
               | `conn a <- along (dx, dy) <- ..`
        conn a -> mass 6 { mass: l } -> free;
               ^^ `mass 6` moves in one direction, and none is said: write `point_mass`, which moves in all
        conn a -> spring 7 { stiffness: l } -> conn u;
        conn b -> spring 8 { stiffness: l } -> conn u;
        conn c -> spring 9 { stiffness: l } -> conn u;
               ^^ this path meets three points with places, and a line leads through two: say `along` at each
               | of them, `conn c <- along (dx, dy) <- ..`
        conn a -> along (1.0, 0.0) -> spring 10 { stiffness: l } -> conn b;
                                                                 ^^ this path says `along` where it meets
                                                                 | other points: say it here too, `conn b <-
                                                                 | along (dx, dy) <- ..`
        conn c -> spring 11 { stiffness: l } -> damper 12 { damping: l } -> conn c;
                                                                         ^^ this path begins and ends at one
                                                                         | place, through which no line leads:
                                                                         | say `along` at both ends
        ",
    );
}

#[test]
fn a_direction_stands_at_a_contact() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> along (1.0, 0.0) -> beam 1
                               ^^^^^ `along` stands where a path of springs, dampers or masses meets a point
                               | with a place: this arrow joins no such two, so remove it
            { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0);
        conn a <- along (1.0, 0.0) <- spring 2 { stiffness: l } <- along (1.0, 0.0) <- mass 3 { mass: l } <- free;
                                                                   ^^^^^ `along` stands where a path of
                                                                   | springs, dampers or masses meets a point
                                                                   | with a place: this arrow joins no such
                                                                   | two, so remove it
        conn a <- along (1.0, 0.0) <- torsion_spring 4 { stiffness: l } <- fixed;
                  ^^^^^ a path of torsion elements turns about z, the one axis of the plane: remove `along`
        conn a <- along l <- spring 5 { stiffness: l } <- fixed;
                        ^ a direction of the plane has two parts, `along (dx, dy)`
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        fixed at 0.0 -> beam 1 { bending_stiffness: l, mass_per_length: l } -> conn a at l;
        conn a <- along (1.0, 0.0) <- spring 2 { stiffness: l } <- fixed;
                  ^^^^^ `along` needs two coordinates: where points have one, paths act across the line, so
                  | remove it
        ",
    );
}

#[test]
fn a_path_has_one_motion() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0);
        conn a -> spring 2 { stiffness: l } -> conn u -> torsion_spring 3 { stiffness: l } -> fixed;
                                                         ^^^^^^^^^^^^^^^^ `torsion_spring 3` turns and `spring
                                                         | 2` moves, so they share no motion: join them at a
                                                         | connection with a place
        ",
    );
}

#[test]
fn a_point_mass_stands_at_a_place_and_a_mass_in_a_path() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0);
        conn a <- along (1.0, 0.0) <- spring 2 { stiffness: l } <- point_mass 3 { mass: l };
                                                                   ^^^^^^^^^^^^ `point_mass 3` stands in a
                                                                   | path, whose points have no places: write
                                                                   | `mass` there, not `point_mass`
        ",
    );
}

#[test]
fn a_point_is_held_across_its_path() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0);
        conn a -> spring 2 { stiffness: l } -> conn b at (l, l);
                                               ^^^^^^ nothing holds `conn b` across the path of `spring 2`:
                                               | remove its place, so that it moves along the path alone, or
                                               | hold it by a support
        conn a -> spring 3 { stiffness: l } -> conn c at (2.0, l) <- free;
                                               ^^^^^^ nothing holds `conn c` across the path of `spring 3`:
                                               | remove its place, so that it moves along the path alone, or
                                               | hold it by a support
        conn a -> spring 4 { stiffness: l } -> free at (3.0, l);
                                               ^^^^ nothing holds `free` across the path of `spring 4`: remove
                                               | its place, so that it moves along the path alone, or hold it
                                               | by a support
        ",
    );
}
