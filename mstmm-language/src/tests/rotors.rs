//! Rotors: what spins names all that it needs, and stands in a line of paths.

use super::{assert_refused, expanded};

/// Naming a speed selects the type, and makes a rotor of the model.
#[test]
fn naming_a_speed_makes_a_rotor() {
    let shaft =
        "length: l, bending_stiffness: k, mass_per_length: k, rotary_inertia: k, polar_inertia_per_length: k, speed: k";
    for (paths, spins) in [
        (format!("fixed -> beam 1 {{ {shaft} }} -> free"), "SpinningBeam"),
        (format!("fixed -> beam 1 {{ {shaft}, kelvin_voigt_time: k }} -> free"), "DampedSpinningBeam"),
        ("pinned -> disc 1 { mass: k, inertia: k, polar_inertia: k, speed: l } -> free".to_owned(), "Disc"),
        ("fixed -> spring 1 { stiffness: k, cross_stiffness: l } -> free".to_owned(), "CrossCoupledSpring"),
    ] {
        let code = expanded(&format!("struct M {{ l: f64, k: f64 }} {paths}"));
        assert!(code.contains(&format!("elements :: {spins}")), "{code}");
        for part in ["SPINS : bool = true", "Spinning for MSystem", "Rotor < MSystem", "Numbered for M"] {
            assert!(code.contains(part), "no {part} in {code}");
        }
        // neither a model of sweeps nor of boxes
        assert!(!code.contains("Model for M") && !code.contains("Formulas for M"), "{code}");
    }
    let stator =
        expanded("struct M { l: f64, k: f64 } pinned -> disc 1 { mass: k, inertia: k, polar_inertia: l } -> free");
    assert!(
        stator.contains("elements :: Disc") && stator.contains("Model for M") && !stator.contains("Rotor"),
        "{stator}"
    );
}

#[test]
fn a_shaft_that_spins_names_its_speed_and_both_inertias() {
    assert_refused(
        "
        struct M { l: f64, k: f64 }
        section s { length: l, bending_stiffness: k, mass_per_length: k }
        free -> beam 1 { ..s, rotary_inertia: k, speed: k } -> conn a;
                                                 ^^^^^ `beam 1` names `speed` and lacks
                                                 | `polar_inertia_per_length`: a beam that spins has all
                                                 | three, one that does not has neither a polar inertia nor a
                                                 | speed
        fixed -> spring 2 { stiffness: k } -> conn a;
        conn a -> beam 3 { ..s, polar_inertia_per_length: k } -> conn b;
                                ^^^^^^^^^^^^^^^^^^^^^^^^ `beam 3` names `polar_inertia_per_length` and lacks
                                | `rotary_inertia` and `speed`: a beam that spins has all three, one that does
                                | not has neither a polar inertia nor a speed
        fixed -> spring 4 { stiffness: k } -> conn b;
        conn b -> beam 5 { ..s, loss_factor: k,
                                ^^^^^^^^^^^ `beam 5` has no `loss_factor` beside `speed`: the loss of a shaft
                                | changes its sign where it whirls at its speed: name `kelvin_voigt_time`,
                                | which turns with it
            rotary_inertia: k, polar_inertia_per_length: k, speed: k }
            -> tapered_beam 6 { ..s, speed: k }
                                     ^^^^^ `tapered_beam` has no parameter `speed`: a `beam` and a `disc`
                                     | spin, in a line of paths without places: that of a blade about its hub
                                     | is `rotation_speed`
            -> disk 7 { mass: k, inertia: k, ip: k, omega: k }
               ^^^^ `disk` is not an element: did you mean `disc`?
            -> disc 8 { mass: k, id: k,
                                 ^^ `disc` has no parameter `id`: did you mean `inertia`?
                ip: k,
                ^^ `disc` has no parameter `ip`: did you mean `polar_inertia`?
                omega: k } -> free;
                ^^^^^ `disc` has no parameter `omega`: did you mean `speed`?
        ",
    );
}

#[test]
fn what_spins_stands_in_a_line_of_paths() {
    assert_refused(
        "
        struct M { l: f64, k: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k, rotary_inertia: k,
            polar_inertia_per_length: k, speed: k } -> conn a at (l, 0.0);
            ^^^^^^^^^^^^^^^^^^^^^^^^ `beam` has no parameter `polar_inertia_per_length`: a `beam` and a `disc`
            | spin, in a line of paths without places
                                         ^^^^^ `beam` has no parameter `speed`: a `beam` and a `disc` spin, in
                                         | a line of paths without places
        conn a <- disc 2 { mass: k, inertia: k, polar_inertia: k, speed: k } <- free;
                  ^^^^ `disc` spins, which nothing with places does: take `point_mass`
        fixed -> spring 3 { stiffness: k, cross_stiffness: k } -> along (0.0, 1.0) -> conn a;
                                          ^^^^^^^^^^^^^^^ `spring` has no parameter `cross_stiffness`: it is
                                          | that of a seal beside a rotor, in a line of paths without places
        ",
    );
    assert_refused(
        "
        struct M { l: f64, k: f64 }
        fixed at 0.0 -> beam 1 { bending_stiffness: k, mass_per_length: k, rotary_inertia: k,
            polar_inertia_per_length: k, speed: k } -> conn a at l;
            ^^^^^^^^^^^^^^^^^^^^^^^^ `beam` has no parameter `polar_inertia_per_length`: a `beam` and a `disc`
            | spin, in a line of paths without places
                                         ^^^^^ `beam` has no parameter `speed`: a `beam` and a `disc` spin, in
                                         | a line of paths without places
        ",
    );
    assert_refused(
        "
        struct M { l: f64, k: f64 }
        fixed at (0.0, 0.0, 0.0) -> beam 1 { axial_stiffness: k, torsional_stiffness: k, bending_stiffness: k, mass_per_length: k,
            rotary_inertia: k, polar_inertia_per_length: k, speed: k } -> conn a at (l, 0.0, 0.0);
                                                            ^^^^^ `beam` has no parameter `speed`: a `beam`
                                                            | and a `disc` spin, in a line of paths without
                                                            | places
        ",
    );
}

/// What bearings of rotors are called elsewhere.
#[test]
fn words_of_other_programs_find_theirs() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> bearing 1 { kxx: k } -> conn a;
                 ^^^^^^^ `bearing` is not an element: did you mean `spring`?
        fixed -> spring 2 { stiffness: k, stiffness_y: k } -> conn a;
                                          ^^^^^^^^^^^ `spring` has no parameter `stiffness_y`: it is alike in
                                          | all directions across a shaft: write `stiffness`
        fixed -> spring 3 { stiffness: k, kxy: k } -> conn a;
                                          ^^^ `spring` has no parameter `kxy`: did you mean `cross_stiffness`?
        conn a -> rotor 4 { mass: k } -> free;
                  ^^^^^ `rotor` is not an element: did you mean `disc`?
        ",
    );
}
