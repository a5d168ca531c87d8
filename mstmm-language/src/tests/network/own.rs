//! Elements of the user's own between places: what rustc is asked about them.

use super::super::input;
use super::assert_refused;
use crate::diagnostics::Errors;
use crate::expand::{located, network, read};
use crate::skeleton::Skeleton;
use expect_test::{Expect, expect};
use std::fmt::Write;

/// The text of a skeleton, and what is wrong if elements have the states that are said.
#[track_caller]
fn check(model: &str, text: Expect) {
    let mut errors = Errors::default();
    let mut model = read(input(model), &mut errors).unwrap();
    let dimension = located(&mut model, &mut errors);
    let network = network(&model, dimension, errors).unwrap();
    let mut shown = Skeleton::of(&network).to_string();
    for suspicion in &network.suspicions {
        let of: Vec<String> = suspicion.of.iter().map(|(element, space)| format!("{element} of {space}")).collect();
        write!(shown, "\n{}: {}", of.join(", "), suspicion.message).unwrap();
    }
    text.assert_eq(&shown);
}

/// A path with an element of the language has its motion; elsewhere the freedoms of its points are those of the type.
#[test]
fn rustc_alone_knows_the_motion_of_a_path_of_own_elements() {
    check(
        "
        struct M { k: f64 }
        fixed at (0.0, 0.0) -> own::Cable 1 { k } -> conn a at (1.0, 0.0) -> beam 2 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k }
            -> fixed at (2.0, 0.0);
        conn a <- own::Cable 3 { k } <- conn u <- own::Cable 4 { k } <- fixed;
        conn a -> spring 5 { stiffness: k } -> own::Cable 6 { k } -> conn b at (1.0, 1.0) -> pinned;
        ",
        expect![[r#"
            # Size

            ```text
            nodes 7, members 6
            the rest, and each ? below, depends on elements that only the compiler knows
            ```

            # Nodes

            In the order of their elimination, with the motions that supports leave, the members that begin there,
            and the number of variables that are left behind each. Points at rest leave with their members.

            ```text
            conn u                ?          ?   Cable 3, Cable 4
            conn a                x y rz     ?   beam 2, Cable 1, spring 5
            the end of spring 5   x          ?   Cable 6
            ```
            Cable 3 of rotation, Cable 4 of translation: `Cable 3` turns and `Cable 4` moves, so they share no motion: join them at a connection with a place
            Cable 3 of translation, Cable 4 of rotation: `Cable 4` turns and `Cable 3` moves, so they share no motion: join them at a connection with a place
            Cable 3 of translation: the direction of `Cable 3` is unknown, since its path meets one point with a place: say it, `conn a <- along (dx, dy) <- ..`
            Cable 6 of rotation: `Cable 6` turns and `spring 5` moves, so they share no motion: join them at a connection with a place"#]],
    );
}

#[test]
fn the_parts_of_an_own_element_are_checked() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed at (0.0, 0.0) -> own::Cable 1 { k, k } -> conn a at (1.0, 0.0) <- own::Cable 2 <- fixed at (2.0, 0.0);
                                                 ^ `Cable 1` gives `k` a second time: remove one of the two
                                                                                ^^^^^^^^^^^^ `Cable 2` lacks
                                                                                | its parameters in braces,
                                                                                | `Cable 2 { name: value, ..
                                                                                | }`
        ",
    );
}
