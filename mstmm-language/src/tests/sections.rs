//! Sections: parameters that elements share.

use super::{assert_refused, expanded, messages};

#[test]
fn elements_take_the_parameters_that_they_do_not_name() {
    let code = expanded(
        "
        struct M { l: f64, ei: f64, m: f64 }
        let half = 0.5 * l;
        section steel { bending_stiffness: 2.0 * ei, mass_per_length: m }
        section long { length: l }
        fixed -> beam 1 { length: half, ..steel } -> beam 2 { ..steel, ..long, mass_per_length: 3.0 } -> free
        ",
    );
    // each expression stands once among the numbers, once among those with derivatives, and once among those over a box
    assert_eq!(code.matches("2.0 * ei").count(), 3, "{code}");
    assert!(code.contains("let _section_steel_bending_stiffness : :: core :: primitive :: f64 = 2.0 * ei ;"), "{code}");
    assert_eq!(code.matches("number : :: core :: primitive :: f64 = _section_steel_bending_stiffness").count(), 2);
    assert_eq!(code.matches("number : :: core :: primitive :: f64 = _section_steel_mass_per_length").count(), 1);
    assert_eq!(code.matches("number : :: core :: primitive :: f64 = _section_long_length").count(), 1);
}

/// Equal elements are evaluated once, and so are those that take the same section.
#[test]
fn elements_of_one_section_are_the_same() {
    let code = expanded(
        "
        struct M { l: f64, k: f64 }
        section piece { length: l, bending_stiffness: k, mass_per_length: k }
        fixed -> beam 1 { ..piece } -> beam 2 { ..piece } -> free
        ",
    );
    assert!(code.contains("element_1") && !code.contains("element_2"), "{code}");
}

#[test]
fn parameters_of_sections_are_those_of_their_elements() {
    assert_refused(
        "
        struct M { k: f64 }
        section steel { bending_stiffness: k, mass_per_length: k, torsional_stiffness: k }
                                                                  ^^^^^^^^^^^^^^^^^^^ `beam 1` has no
                                                                  | parameter `torsional_stiffness`: it has
                                                                  | that in space alone, so remove it
        fixed -> beam 1 { ..steel } -> beam 2 { ..steel, length: k } -> free;
                 ^^^^^^ `beam 1` lacks `length`
        ",
    );
}

#[test]
fn two_sections_do_not_give_one_parameter() {
    assert_refused(
        "
        struct M { k: f64 }
        section thick { bending_stiffness: k, mass_per_length: k }
        section heavy { mass_per_length: 2.0 * k }
        fixed -> beam 1 { length: k, ..thick, ..heavy } -> free;
                                                ^^^^^ sections `thick` and `heavy` both give
                                                | `mass_per_length`: name it in `beam 1` itself, which then
                                                | wins
        ",
    );
    expanded(
        "
        struct M { k: f64 }
        section thick { bending_stiffness: k, mass_per_length: k }
        section heavy { mass_per_length: 2.0 * k }
        fixed -> beam 1 { length: k, ..thick, ..heavy, mass_per_length: k } -> free;
        ",
    );
}

#[test]
fn sections_are_known_and_written_once() {
    assert_refused(
        "
        struct M { k: f64 }
        section stiff { stiffness: k, stiffness: 2.0 }
                                      ^^^^^^^^^ section `stiff` gives `stiffness` a second time: remove one of
                                      | the two
        section stiff { stiffness: k }
                ^^^^^ there is a section `stiff` already: give this one another name
        fixed -> spring 1 { ..stif } -> mass 2 { ..heavy, mass: k } -> free;
                              ^^^^ there is no section `stif`: did you mean `stiff`?
                                                   ^^^^^ there is no section `heavy`: there are `stiff` and
                                                   | `stiff`
        ",
    );
    let none = messages("struct M; fixed -> spring 1 { ..soft, stiffness: 1.0 } -> free");
    assert_eq!(none, "there is no section `soft`: write `section soft { .. }` behind the `let` lines");
}

#[test]
fn sections_stand_between_let_lines_and_paths() {
    assert_refused(
        "
        struct M { k: f64 }
        section stiff { stiffness: k }
        let half = 0.5 * k;
        ^^^ `let` lines stand between the struct and the first path: move this one up
        fixed -> spring 1 { ..stiff } -> free;
        section late { stiffness: k }
        ^^^^^^^ sections stand between the `let` lines and the first path: move this one up
        ",
    );
    assert_refused(
        "
        struct M { k: f64 }
        section { stiffness: k }
        ^^^^^^^ a section has a name and parameters, `section steel { bending_stiffness: ei, .. }`
        section other;
                ^^^^^ a section has a name and parameters, `section steel { bending_stiffness: ei, .. }`
        section both { ..other }
                         ^^^^^ a section takes no other one: write `..other` in the elements that have both
        fixed -> spring 1 { stiffness: k } -> free;
        ",
    );
}

/// rustc tells of what is deprecated; the words are ours.
#[test]
fn a_section_that_no_element_has_is_a_warning() {
    let code = expanded(
        "struct M { k: f64 } section soft { stiffness: k } section _spare { mass: k } fixed -> spring 1 { stiffness: k } -> free",
    );
    assert!(code.contains("no element has section `soft`: remove it, or write `..soft` in an element"), "{code}");
    assert!(!code.contains("no element has section `_spare`"), "{code}");
}

/// Models with places, and elements of the user's own, whose names rustc checks.
#[test]
fn sections_stand_in_all_models_and_elements() {
    let code = expanded(
        "
        struct M { l: f64, k: f64 }
        section steel { axial_stiffness: k, bending_stiffness: k, mass_per_length: k }
        section rope { tension: k }
        fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0);
        conn a -> own::Cable 2 { ..rope } -> fixed at (l, l);
        ",
    );
    assert!(code.contains("tension : number"), "{code}");
}
