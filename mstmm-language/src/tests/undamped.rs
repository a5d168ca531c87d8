//! `#[undamped(Name)]`: the model without what damps.

use super::{assert_refused, expanded};

#[test]
fn the_undamped_model_has_a_name() {
    assert_refused(
        "
        #[undamped]
        ^^^^^^^^^^^ write the name of the model without damping, `#[undamped(QuietModel)]`
        struct M { k: f64 }
        fixed -> spring 1 { stiffness: k, damping: 1.0 } -> mass 2 { mass: 1.0 } -> free
        ",
    );
    assert_refused(
        "
        #[undamped(Quiet)]
        #[undamped(Calm)]
        ^^^^^^^^^^^^^^^^^ a model has one undamped model: remove this line
        struct M { k: f64 }
        fixed -> spring 1 { stiffness: k, damping: 1.0 } -> mass 2 { mass: 1.0 } -> free
        ",
    );
}

#[test]
fn a_model_without_damping_has_no_undamped_model() {
    assert_refused(
        "
        #[undamped(Quiet)]
                   ^^^^^ nothing in this model damps: it has natural frequencies itself, so remove
                   | `#[undamped(..)]`
        struct M { k: f64 }
        fixed -> spring 1 { stiffness: k } -> mass 2 { mass: 1.0 } -> free
        ",
    );
}

#[test]
fn the_undamped_model_has_a_name_of_its_own() {
    assert_refused(
        "
        #[undamped(M)]
                   ^ `M` is a type of this model: give the undamped model another name
        struct M { k: f64 }
        fixed -> spring 1 { stiffness: k, damping: 1.0 } -> mass 2 { mass: 1.0 } -> free
        ",
    );
}

#[test]
fn a_hinge_of_two_freedoms_needs_both_stiffnesses() {
    assert_refused(
        "
        #[undamped(Quiet)]
        struct M { k: f64 }
        fixed -> hinge 1 { stiffness_y: k, damping_rz: 1.0 } -> point_mass 2 { mass: 1.0 } -> free
                 ^^^^^^^ `hinge 1` would have no stiffness without its `damping_rz`: name a `stiffness_rz`,
                 | which a hinge of two freedoms needs
        ",
    );
}

/// What is wrong with a model is told once, and not again of the model without damping.
#[test]
fn mistakes_are_told_once() {
    assert_refused(
        "
        #[undamped(Quiet)]
        struct M { k: f64 }
        fixed -> spring 1 { stifness: k, damping: 1.0 } -> mass 2 { mass: 1.0 } -> free
                            ^^^^^^^^ `spring` has no parameter `stifness`: did you mean `stiffness`?
        ",
    );
}

#[test]
fn the_undamped_model_has_the_fields_and_no_damper() {
    let code = expanded(
        "
        #[undamped(Quiet)]
        struct M { k: f64, c: f64 }
        fixed -> spring 1 { stiffness: k, loss_factor: 0.1 } -> mass 2 { mass: 1.0 } -> damper 3 { damping: c } -> fixed
        ",
    );
    let quiet = code.split("struct QuietSystem").nth(1).unwrap();
    assert!(code.contains("struct Quiet { k : f64 , c : f64 }"), "{code}");
    assert!(!quiet.contains("Damp"), "{quiet}");
}
