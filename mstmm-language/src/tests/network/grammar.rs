//! Messages of the parser about places, directions and what supports hold.

use super::{assert_refused, described};

#[test]
fn a_place_and_a_direction_have_coordinates() {
    assert_refused(
        "
        struct M { l: f64 }
        fixed at -> beam 1 { } -> conn a at (l, 0.0);
              ^^ `at` says where a point is: write its coordinates behind, `at (x, y)`
        conn a <- along <- spring 2 { stiffness: l } <- fixed;
                  ^^^^^ `along` says in which direction: write its parts behind, `along (dx, dy)`
        conn a <- roller along;
                         ^^^^^ `along` says in which direction: write its parts behind, `along (dx, dy)`
        conn a at 2.0 * -> spring 3 { stiffness: l } -> fixed;
                      ^ unexpected end of input, expected an expression
        conn a at;
               ^^ `at` says where a point is: write its coordinates behind, `at (x, y)`
        ",
    );
}

#[test]
fn suffixes_stand_once_and_in_order() {
    assert_refused(
        "
        struct M { l: f64 }
        conn a at (0.0, 0.0) at (1.0, 0.0) -> spring 1 { stiffness: l } -> fixed;
                             ^^ `conn a` has its place already: remove this `at`
        roller along (1.0, 0.0) at (0.0, 0.0) -> conn a;
                                ^^ the place of `roller` stands before its direction: `roller at .. along ..`
        roller at (0.0, 0.0) along (1.0, 0.0) at (0.0, 1.0) -> conn a;
                                              ^^ `roller` has its place already: remove this `at`
        guided at (0.0, 0.0) along (1.0, 0.0) along (0.0, 1.0) -> conn a;
                                              ^^^^^ `guided` has its direction already: remove this `along`
        ",
    );
}

#[test]
fn words_behind_a_node_are_known() {
    assert_refused(
        "
        struct M { l: f64 }
        conn a att (0.0, 0.0) -> spring 1 { stiffness: l } -> fixed;
               ^^^ `att` says nothing of `conn a`: did you mean `at`?
        conn a on (0.0, 0.0) -> spring 2 { stiffness: l } -> fixed;
               ^^ `on` says nothing of `conn a`: its place is written `conn a at (x, y)`
        roller alnog (1.0, 0.0) -> conn a;
               ^^^^^ `alnog` says nothing of `roller`: did you mean `along`?
        ",
    );
}

#[test]
fn a_direction_stands_in_the_middle_of_an_arrow() {
    assert_refused(
        "
        struct M { l: f64 }
        along (1.0, 0.0) -> spring 1 { stiffness: l } -> fixed;
        ^^^^^ `along` stands between a connection and the path that acts on it, `conn a <- along (dx, dy) <-
        | ..`
        conn a at (0.0, 0.0) <- along (1.0, 0.0);
                                ^^^^^ `along` stands between a connection and the path that acts on it, `conn
                                | a <- along (dx, dy) <- ..`
        conn a <- along (1.0, 0.0) -> spring 2 { stiffness: l } -> fixed;
                                   ^^ the arrows on both sides of `along` are one: turn one of them round, so
                                   | that both point one way
        conn a <- along (1.0, 0.0) <- along (0.0, 1.0) <- spring 3 { stiffness: l } <- fixed;
                                      ^^^^^ the path has its direction already: remove this `along`
        conn a along (1.0, 0.0) <- spring 4 { stiffness: l } <- fixed;
               ^^^^^ `along` directs the path that acts on a connection: write it between arrows, `conn a <-
               | along (dx, dy) <- ..`
        conn a <- spring 5 { stiffness: l } along (1.0, 0.0) <- fixed;
                                            ^^^^^ `along` directs the path that acts on a connection: write it
                                            | between arrows, `conn a <- along (dx, dy) <- ..`
        conn a -> at (1.0, 0.0) -> spring 6 { stiffness: l } -> fixed;
                  ^^ `at` stands behind a connection or a support, whose place it says: remove the arrow
                  | between
        ",
    );
}

#[test]
fn an_arrow_is_missing_behind_a_place() {
    assert_refused(
        "
        struct M { l: f64 }
        conn a at (0.0, 0.0) beam 1 { } -> conn b at (l, 0.0);
                             ^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before
                             | it with `;`
        conn a at l < -l -> spring 2 { stiffness: l } -> fixed
        conn b at (l, 0.0) -> spring 3 { stiffness: l } -> fixed;
        ^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
        ",
    );
}

#[test]
fn held_names_freedoms() {
    assert_refused(
        "
        struct M { l: f64 }
        conn a at (0.0, 0.0) <- held;
                                ^^^^ `held` names in parentheses what it holds, such as `held(x, rz)`
        conn a <- held { x };
                  ^^^^ `held` names in parentheses what it holds, such as `held(x, rz)`
        conn a <- held(1);
                       ^ expected a freedom, such as `x`, `y` or `rz`
        conn a <- held(x y);
                         ^ expected `,` between freedoms
        ",
    );
}

/// The tokens are cut at the arrow before they are parsed: `0.3 * l <- beam` would compare.
#[test]
fn a_place_ends_at_an_arrow() {
    let model = |place: &str| {
        format!(
            "struct M {{ l: f64 }} fixed at 0.0 -> beam 1 {{ bending_stiffness: l, mass_per_length: l }} -> conn a at {place}
             <- beam 2 {{ bending_stiffness: l, mass_per_length: l }} <- fixed at l"
        )
    };
    for place in ["0.3 * l", "-l", "f(|a| -> f64 { a })", "if l < -1.0 { l } else { 2.0 }", "A { l }.l", "{ l } as f64"]
    {
        let network = described(&model(place));
        assert!(network.contains("place 1: "), "{place}: {network}");
    }
}
