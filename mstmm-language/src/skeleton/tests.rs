//! The skeletons of networks, as the documentation of built systems shows them.

use super::Skeleton;
use crate::diagnostics::Errors;
use crate::expand::{located, network, read};
use expect_test::{Expect, expect};

#[track_caller]
fn check(model: &str, text: Expect) {
    let tokens = |text: &str| text.parse::<proc_macro2::TokenStream>().unwrap();
    let mut errors = Errors::default();
    let mut model = read(tokens("(mstmm)").into_iter().chain(tokens(model)).collect(), &mut errors).unwrap();
    let dimension = located(&mut model, &mut errors);
    text.assert_eq(&Skeleton::of(&network(&model, dimension, errors).unwrap()).to_string());
}

/// Two storeys: the girders close loops between the columns, and the brace closes one more.
#[test]
fn loops_and_the_members_that_close_them() {
    check(
        "
        struct Tower { k: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> conn a at (0.0, 1.0)
            -> beam 2 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> conn b at (0.0, 2.0)
            -> beam 3 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> conn c at (1.0, 2.0)
            <- beam 4 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } <- conn d at (1.0, 1.0)
            <- beam 5 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } <- pinned at (1.0, 0.0);
        conn a -> beam 6 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> conn d;
        conn a -> spring brace { stiffness: k } -> conn c;
        ",
        expect![[r#"
            # Size

            ```text
            nodes 6, members 7, unknowns at once 21
            closed loops 2, cut at beam 6, spring brace
            unknowns of the overall transfer equation 14, root pinned at beam 5
            ```

            # Nodes

            In the order of their elimination, with the motions that supports leave, the members that begin there,
            and the number of variables that are left behind each. Points at rest leave with their members.

            ```text
            pinned at beam 5   rz         3   beam 5
            conn d             x y rz     6   beam 4, beam 6
            conn a             x y rz     7   beam 1, beam 2, spring brace
            conn c             x y rz     6   beam 3
            conn b             x y rz     0
            ```"#]],
    );
}

/// A path with motions of its own, a body on two supports, joints in series and a skew support.
#[test]
fn nodes_that_are_no_points() {
    check(
        "
        struct M { k: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> conn a at (1.0, 0.0)
            -> rigid_body 2 { mass: k, inertia: k, centre: (1.5, 0.0) } -> conn b at (2.0, 0.0) <- held(x);
        rigid_body 2 <- conn c at (1.5, -1.0) <- roller along (1.0, 1.0);
        conn b -> slider 3 { along: (1.0, 0.0) } -> pin 4 {}
            -> beam 5 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> guided at (3.0, 0.0) along (0.0, 1.0);
        conn a <- along (0.0, 1.0) <- spring 6 { stiffness: k } <- mass 7 { mass: k } <- conn u <- damper 8 { damping: k } <- fixed;
        conn u -> along (1.0, 0.0) -> conn b;
        ",
        expect![[r#"
            # Size

            ```text
            nodes 8, members 8, unknowns at once 11
            closed loops 1, cut at spring 6
            unknowns of the overall transfer equation 18, root roller at conn c
            ```

            # Nodes

            In the order of their elimination, with the motions that supports leave, the members that begin there,
            and the number of variables that are left behind each. Points at rest leave with their members.

            ```text
            guided at beam 5        along      3   beam 5
            the point at beam 5     x y rz     2   pin 4
            the point at slider 3   x y rz     2   slider 3
            rigid_body 2            y rz       2   roller at conn c, beam 1, conn u, spring 6
            conn u                  x          0   damper 8
            ```"#]],
    );
}
