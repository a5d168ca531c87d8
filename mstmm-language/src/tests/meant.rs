//! Messages that name what was meant: words of other programs, elements of another path, habits of Rust.

use super::{assert_refused, messages};

#[test]
fn supports_are_known_by_their_names_elsewhere() {
    assert_refused(
        "
        struct M { k: f64 }
        clamped -> spring 1 { stiffness: k } -> mass 2 { mass: k } -> conn 3 -> hinged;
        ^^^^^^^ `clamped` is not a support: did you mean `fixed`?
                                                                                ^^^^^^ `hinged` is not a
                                                                                | support: did you mean
                                                                                | `pinned`?
        ",
    );
    let located = "struct M { l: f64 } clamped at (0.0, 0.0) -> pin 1 -> fixed at (l, 0.0);";
    assert!(messages(located).contains("`clamped` is not a support: did you mean `fixed`?"), "{}", messages(located));
}

/// In a model with places and in one without, a word may mean different elements.
#[test]
fn elements_are_known_by_their_names_elsewhere() {
    let path = |word: &str| format!("struct M {{ l: f64 }} fixed -> {word} 1 {{ length: l }} -> free;");
    for (word, meant) in [("euler_beam", "beam"), ("link", "rigid_link"), ("corner", "conn"), ("dashpot", "damper")] {
        let found = messages(&path(word));
        assert!(found.contains(&format!("`{word}` is not an element: did you mean `{meant}`?")), "{found}");
    }
    let frame = |word: &str| format!("struct M {{ l: f64 }} fixed at (0.0, 0.0) -> {word} 1 {{}} -> free at (l, 0.0);");
    for (word, meant) in [("euler_beam", "beam"), ("column", "beam"), ("link", "rigid_link")] {
        let found = messages(&frame(word));
        assert!(found.contains(&format!("`{word}` is not an element: did you mean `{meant}`?")), "{found}");
    }
}

/// The macro knows the states of its own elements, so that a misfit is an error like others, several at once.
#[test]
fn states_that_do_not_fit_are_errors_of_the_language() {
    assert_refused(
        "
        struct M { l: f64 }
        pinned -> spring 1 { stiffness: l } -> beam 2 { length: l, bending_stiffness: l, mass_per_length: l } -> free;
        ^^^^^^ a translation path ends in `fixed` or `free` only
                                            ^^ an arrow joins equal states only: put a connection with a free
                                            | tip between these two elements, `-> conn .. ->` and `free ->
                                            | conn ..`
        ",
    );
    let own = "struct M { l: f64 } fixed -> beam 1 { length: l, bending_stiffness: l, mass_per_length: l } -> a::B 2 {} -> pinned;";
    assert!(messages(own).is_empty(), "{}", messages(own));
}

#[test]
fn a_mass_on_a_beam_is_a_point_mass() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed -> beam 1 { length: l, bending_stiffness: l, mass_per_length: l } -> mass 2 { mass: l } -> free;
                                                                                   ^^^^^^ `beam 1` bends, and
                                                                                   | `mass 2` stands in a path
                                                                                   | of one motion: write
                                                                                   | `point_mass 2 { mass,
                                                                                   | inertia }`
        ",
    );
    assert_refused(
        "
        struct M { l: f64 }
        free -> inertia disk { inertia: l } -> beam 1 { length: l, bending_stiffness: l, mass_per_length: l } -> free;
                ^^^^^^^^^^^^ `beam 1` bends, and `inertia disk` stands in a path of one motion: write
                | `point_mass disk { mass, inertia }`
        ",
    );
}

#[test]
fn a_spring_and_a_dashpot_side_by_side_are_one_element() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> spring 1 { stiffness: k } -> conn 2 -> spring 3 { stiffness: k } -> conn 4 -> free;
        conn 2 -> damper 5 { damping: k } -> conn 4;
               ^^ `conn 2` leads by a spring and a dashpot to the same connection: write both as one, `spring`
               | with `damping`
        ",
    );
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> torsion_spring 1 { stiffness: k } -> conn 2 -> torsion_damper 3 { damping: k } -> conn 4 -> free;
        conn 2 -> torsion_spring 5 { stiffness: k } -> conn 4;
               ^^ `conn 2` leads by a spring and a dashpot to the same connection: write both as one,
               | `torsion_spring` with `damping`
        ",
    );
}

#[test]
fn a_field_is_written_without_self() {
    assert_refused(
        "
        struct M { length: f64, k: f64 }
        let half = 0.5 * self.length;
                         ^^^^^^^^^^^ a field is written by its name alone, `length`, without `self`
        fixed -> spring 1 { stiffness: self.k } -> mass 2 { mass: of(self) } -> free;
                                       ^^^^^^ a field is written by its name alone, `k`, without `self`
                                                                     ^^^^ there is no `self` here: fields are
                                                                     | written by their names, `length`
        ",
    );
    // a path of a module is none
    let path = "struct M { k: f64 } fixed -> spring 1 { stiffness: self::twice(1.0) } -> mass 2 { mass: k } -> free;";
    assert_eq!(messages(path), "");
}

#[test]
fn an_array_as_a_field_is_one_mistake() {
    assert_refused(
        "
        struct M { l: [f64; 3], k: f64 }
                      ^^^^^^^^ a field of a model is an `f64`: compute anything else in a `let` line
        fixed -> spring 1 { stiffness: l[0] * k } -> free
        ",
    );
}
