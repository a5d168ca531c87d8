//! Rules of models in space, and words of other programs: what is told, behind the token that it is about.

mod other_programs;

use super::super::{input, place};
use crate::expand::expand_checked;

/// What all beams below have that are not at fault.
const STEEL: &str = "
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }";

/// The model is refused with these messages, each behind the token that it is about, and with no others.
#[track_caller]
fn assert_told(model: &str, expected: &str) {
    let text = if model.contains("struct M") { model.to_owned() } else { format!("{STEEL}{model}") };
    let lines: Vec<&str> = text.lines().collect();
    let errors = expand_checked(input(&text)).expect_err("this model is accepted");
    let told = errors.into_iter().map(|error| {
        let (line, columns) = place(&error);
        format!("{}: {error}", &lines[line - 1][columns])
    });
    let expected: Vec<&str> = expected.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    assert_eq!(told.collect::<Vec<_>>(), expected);
}

#[test]
fn a_beam_in_space_says_all_that_it_lacks() {
    assert_told(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0, 0.0);",
        "
        beam 1: `beam 1` lacks `torsional_stiffness` and `polar_inertia_per_length`: a beam in space stretches, turns about its axis and bends both ways; for a bar, `bar`",
    );
}

#[test]
fn one_plane_of_bending_is_not_enough() {
    assert_told(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0, 0.0)
            -> beam 1 { axial_stiffness: l, torsional_stiffness: l, bending_stiffness_y: l, mass_per_length: l,
                polar_inertia_per_length: l }
            -> conn a at (l, 0.0, 0.0);",
        "
        beam 1: `beam 1` lacks `bending_stiffness_z`: a beam in space stretches, turns about its axis and bends both ways; for a bar, `bar`",
    );
}

#[test]
fn a_name_without_index_stands_for_both() {
    assert_told(
        "
        struct M { l: f64 }
        section steel { axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, bending_stiffness_y: l,
                mass_per_length: l, polar_inertia_per_length: l }
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
        -> beam 2 { axial_stiffness: l, torsional_stiffness: l, bending_stiffness_z: l, bending_stiffness: l,
                mass_per_length: l, polar_inertia_per_length: l, shear_stiffness_y: l, shear_stiffness: l }
            -> conn b at (l, l, 0.0);",
        "
        bending_stiffness_y: `beam 1` gives `bending_stiffness` for both planes, and `bending_stiffness_y` for one: remove one of the two
        bending_stiffness_z: `beam 2` gives `bending_stiffness` for both planes, and `bending_stiffness_z` for one: remove one of the two
        shear_stiffness_y: `beam 2` gives `shear_stiffness` for both planes, and `shear_stiffness_y` for one: remove one of the two",
    );
}

#[test]
fn pins_and_sliders_are_of_the_plane() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0) -> pin 2 {}
            -> beam 3 { ..steel } -> conn b at (l, l, 0.0) -> slider 4 { along: (1.0, 0.0, 0.0) }
            -> beam 5 { ..steel } -> fixed at (l, l, l);",
        "
        pin: `pin` is a joint of the plane: take `revolute_joint { axis: (..) }` or `ball_joint {}`
        slider: `slider` is a joint of the plane: take `prismatic_joint { axis: (..) }`",
    );
}

#[test]
fn hinges_that_would_be_rigid() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0) -> hinge 2 {}
            -> beam 3 { ..steel } -> conn b at (l, l, 0.0);",
        "
        hinge 2: `hinge 2` names no freedom that gives way, so it would be rigid: write `ball_joint 2 {}`, which lets rotations go, or name a stiffness",
    );
}

#[test]
fn bodies_levers_and_tapered_beams() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
            -> body 2 { mass: l, inertia: l } -> conn b at (l, l, 0.0);
        conn a -> lever 3 { length: l } -> conn c at (l, l, l);
        conn a -> tapered_beam 4 { bending_stiffness: l, mass_per_length: l } -> conn d at (l, l, 2.0 * l);",
        "
        body: `body` has its points by offsets, which places replace: take `rigid_body`
        lever: `lever` is `rigid_link` now: write `rigid_link 3 {}`
        tapered_beam: `tapered_beam` bends in one plane: take `beam`",
    );
}

#[test]
fn supports_say_which_way() {
    assert_told(
        "
        roller at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> guided at (l, 0.0, 0.0);",
        "
        roller: say which way: `roller normal (0.0, 0.0, 1.0)` holds one direction, `roller along (1.0, 0.0, 0.0)` leaves one
        guided: say which way: `guided normal (0.0, 0.0, 1.0)` holds one direction, `guided along (1.0, 0.0, 0.0)` leaves one",
    );
}

#[test]
fn directions_have_three_parts() {
    assert_told(
        "
        struct M { l: f64 }
        section steel { axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l,
                polar_inertia_per_length: l, up: (0.0, 1.0) }
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
            -> rigid_body 2 { mass: l, inertia: l, centre: (l, 0.0) };
        conn b at (l, l) <- beam 3 { ..steel } <- conn a;
        conn a <- along (1.0, 0.0) <- spring 4 { stiffness: l } <- fixed;
        conn a -> point_mass 5 { mass: l, inertia: (l, l) };",
        "
        (l, l): the place of `conn b` has two coordinates, that of `fixed` three: all points of a model have equally many
        up: `up` has three parts in space, which are written as a tuple, `up: (dx, dy, dz)`
        l: `inertia` is a tensor in space: `inertia: (xx, yy, zz)`, or with `xy, yz, zx`
        (l, 0.0): `centre` has three parts in space, which are written as a tuple, `centre: (x, y, z)`
        (l, l): `inertia` is a tensor in space: `inertia: (xx, yy, zz)`, or with `xy, yz, zx`
        (1.0, 0.0): a direction in space has three parts, `along (dx, dy, dz)`",
    );
}

#[test]
fn paths_that_turn_act_about_axes() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0);
        conn a <- torsion_spring 2 { stiffness: l } <- fixed;
        conn a <- along (0.0, 0.0, 1.0) <- torsion_spring 3 { stiffness: l } <- fixed;
        conn a <- about (0.0, 0.0, 1.0) <- spring 4 { stiffness: l } <- fixed;
        conn a <- spring 5 { stiffness: l } <- fixed;",
        "
        <-: a path that turns acts about an axis: `conn a <- about (0.0, 0.0, 1.0) <- ..`
        along: a path that turns acts about an axis: `conn a <- about (0.0, 0.0, 1.0) <- ..`
        about: a path that moves acts along a direction: write `along` in the place of `about`
        <-: the direction of `spring 5` is unknown, since its path meets one point with a place: say it, `conn a <- along (dx, dy, dz) <- ..`",
    );
}

#[test]
fn points_that_nothing_ties() {
    assert_told(
        "
        struct M { l: f64 }
        pinned at (0.0, 0.0, 0.0) -> spring 1 { stiffness: l } -> conn a at (l, 0.0, 0.0)
            -> spring 2 { stiffness: l } -> pinned at (l, l, 0.0);",
        "
        conn a: `conn a` moves freely in directions of which no path is: hold it, give it members or mass, or leave it without a place",
    );
}

#[test]
fn words_of_space_in_the_plane() {
    assert_told(
        "
        struct M { l: f64 }
        section steel { axial_stiffness: l, bending_stiffness: l, mass_per_length: l, torsional_stiffness: l, up: (0.0,
                0.0, 1.0) }
        fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0) -> ball_joint 2 {}
            -> beam 3 { bending_stiffness_y: l, axial_stiffness: l, mass_per_length: l } -> conn b at (l, l)
            -> revolute_joint 4 { axis: (0.0, 0.0, 1.0) }
            -> beam 5 { bending_stiffness: l, axial_stiffness: l, mass_per_length: l } -> fixed at (3.0, 3.0);
        conn a <- about (0.0, 0.0, 1.0) <- torsion_spring 6 { stiffness: l } <- fixed;
        conn a <- held(z, rx);",
        "
        torsional_stiffness: `beam 1` has no parameter `torsional_stiffness`: it has that in space alone, so remove it
        up: `beam 1` has no parameter `up`: it has that in space alone, so remove it
        ball_joint: `ball_joint` is a joint of space: take `pin`
        bending_stiffness_y: `beam` has no parameter `bending_stiffness_y`: did you mean `bending_stiffness`?
        revolute_joint: `revolute_joint` is a joint of space: take `pin`
        z: `z` is no freedom of this model: a point has `x`, `y` and `rz`
        rx: `rx` is no freedom of this model: a point has `x`, `y` and `rz`
        about: `about` needs three coordinates: a path that turns does so about z here, so remove it",
    );
}

#[test]
fn joints_lack_their_axis() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0) -> revolute_joint 2 {}
            -> beam 3 { ..steel } -> conn b at (l, l, 0.0) -> ball_joint 4 { axis: (1.0, 0.0, 0.0) }
            -> beam 5 { ..steel } -> conn c at (l, l, l) -> prismatic_joint 6 { axis: 1.0 } -> beam 7 { ..steel }
            -> fixed at (3.0, 3.0, 3.0);",
        "
        revolute_joint 2: `revolute_joint 2` lacks `axis`
        axis: `ball_joint` has no parameter `axis`: it has none, so remove it
        1.0: `axis` has three parts in space, which are written as a tuple, `axis: (dx, dy, dz)`",
    );
}

#[test]
fn a_support_moves_one_way() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel }
            -> roller at (l, 0.0, 0.0) normal (0.0, 0.0, 1.0) along (1.0, 0.0, 0.0);
        roller at (l, l, 0.0) about (0.0, 0.0, 1.0) -> beam 2 { ..steel }
            -> roller at (l, l, l) normal (1.0, 0.0);",
        "
        along: `roller` has its direction already: remove this `along`
        about: `about` is the axis of a path that turns: a support has `along` or `normal`, or names what it holds, `held(x, rz)`
        (1.0, 0.0): a direction in space has three parts, `normal (dx, dy, dz)`",
    );
}

#[test]
fn hinges_of_the_plane() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
            -> hinge 2 { stiffness_theta: l, kx: l, along: (1.0, 0.0, 0.0) } -> beam 3 { ..steel }
            -> conn b at (l, l, 0.0);",
        "
        stiffness_theta: `hinge` has no parameter `stiffness_theta`: write `stiffness_rz: l`
        kx: `hinge` has no parameter `kx`: did you mean `stiffness_x`?
        along: `hinge` has no parameter `along`: did you mean `axis`?",
    );
}

#[test]
fn a_body_alone_is_no_model() {
    assert_told(
        "
        struct M { l: f64 }
        free at (0.0, 0.0, 0.0) -> rigid_body 1 { mass: l, inertia: (l, l, l), centre: (0.0, 0.0, l) };",
        "
        M: no element of this model has two ends: a model has a beam, a spring or a joint, and a body alone has nothing to compute",
    );
}

#[test]
fn a_joint_of_space_wants_places_with_three_coordinates() {
    assert_told(
        "
        struct M { l: f64 }
        fixed -> ball_joint 1 {} -> beam 2 { length: l, bending_stiffness: l, mass_per_length: l } -> free",
        "
        ball_joint: `ball_joint` stands in models whose points have places: say where they are, `conn a at (x, y, z)`",
    );
}
