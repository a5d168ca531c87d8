//! Messages about what one node or one field shows by itself.

use super::{assert_refused, expanded};

#[test]
fn the_struct_has_named_fields() {
    assert_refused(
        "
        struct M(f64, f64);
                ^^^^^^^^^^ the struct of a model has named fields, `struct Model { length: f64, .. }`
        fixed -> spring 1 { stiffness: 1.0 } -> free
        ",
    );
}

#[test]
fn the_fields_are_numbers() {
    assert_refused(
        "
        struct M { count: usize, name: &'static str, k: f64 }
                          ^^^^^ a field of a model is an `f64`: compute anything else in a `let` line
                                       ^^^^^^^^^^^^ a field of a model is an `f64`: compute anything else in a
                                       | `let` line
        fixed -> spring 1 { stiffness: k } -> free
        ",
    );
}

#[test]
fn the_fields_have_names() {
    assert_refused(
        "
        struct M { _: f64, k: f64 }
                   ^ a field of a model has a name: parameters are written by it
        fixed -> spring 1 { stiffness: k } -> free
        ",
    );
}

#[test]
fn the_struct_is_not_generic() {
    assert_refused(
        "
        struct M<T: Copy> { k: f64 }
                ^^^^^^^^^ the struct of a model takes no generic parameters: its fields are all `f64`
        fixed -> spring 1 { stiffness: k } -> free
        ",
    );
}

#[test]
fn a_condition_is_about_the_whole_model() {
    assert_refused(
        "
        #[derive(Debug)]
        #[cfg(test)]
        ^^^^^^^^^^^^ write `#[cfg(..)]` before `system!`: it is about the whole model
        struct M { k: f64 }
        fixed -> spring 1 { stiffness: k } -> free
        ",
    );
}

/// Else the field would be bound where it is not.
#[test]
fn a_condition_of_a_field_goes_with_it() {
    let code = expanded(
        "
        struct M { #[cfg(feature = \"stiff\")] k: f64, #[cfg(not(feature = \"stiff\"))] k: f64, #[serde(skip)] m: f64 }
        fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free
        ",
    );
    let bindings = "# [cfg (feature = \"stiff\")] let k = self . k ; # [cfg (not (feature = \"stiff\"))] let k = self . k ; \
                    let m = self . m ;";
    assert!(code.contains(bindings), "{code}");
}

#[test]
fn a_model_needs_an_element() {
    assert_refused(
        "
        struct Nothing;
               ^^^^^^^ this model has no element: write a path such as `fixed -> beam 1 { .. } -> free;`
        ",
    );
    assert_refused(
        "
        pub struct NoElement;
                   ^^^^^^^^^ this model has no element: write a path such as `fixed -> beam 1 { .. } -> free;`
        fixed -> free;
        ",
    );
    assert_refused(
        "
        struct NoElement;
               ^^^^^^^^^ this model has no element: write a path such as `fixed -> beam 1 { .. } -> free;`
        fixed -> conn 1 -> free;
        pinned -> conn 1;
        ",
    );
}

#[test]
fn unknown_elements_and_supports_are_shown_together() {
    assert_refused(
        "
        struct M { k: f64 }
        fixd -> baem 1 { length: k } -> conn 2 -> sprin 3 { stiffness: k } -> wall;
        ^^^^ `fixd` is not a support: did you mean `fixed`?
                ^^^^ `baem` is not an element: did you mean `beam`?
                                                  ^^^^^ `sprin` is not an element: did you mean `spring`?
                                                                              ^^^^ `wall` is not a support:
                                                                              | the supports are `fixed`,
                                                                              | `pinned`, `free`, `guided` and
                                                                              | `roller`
        conn 2 <- torsionspring four { stiffness: k } <- fixed;
                  ^^^^^^^^^^^^^ `torsionspring` is not an element: did you mean `torsion_spring`?
        ",
    );
}

/// What is said of the rest of the model does not depend on a word that is not known.
#[test]
fn words_labels_parameters_and_graph_are_shown_together() {
    assert_refused(
        "
        struct M { k: f64, name: String }
                                 ^^^^^^ a field of a model is an `f64`: compute anything else in a `let` line
        fixed -> sprng 1 { stiffness: k } -> conn 2 <- mass 3 { mas: 1.0 } <- free;
                 ^^^^^ `sprng` is not an element: did you mean `spring`?
                                                                ^^^ `mass` has no parameter `mas`: did you
                                                                | mean `mass`?
                                             ^^^^^^ `conn 2` has no output: lead it on to the root
        fixed -> beam 3 { length: k } -> conn 4;
                 ^^^^^^ `beam 3` lacks `bending_stiffness` and `mass_per_length`
                      ^ label `3` is taken by `mass 3`: elements share one set of labels, and an element is
                      | written once
                                         ^^^^^^ `conn 4` has no output: lead it on to the root
        ",
    );
}

/// A line that cannot be read hides what is wrong with the graph, and nothing else.
#[test]
fn words_are_shown_beside_lines_that_cannot_be_read() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: } -> conn 2;
                                       ^ unexpected end of input, expected an expression
        conn 2 <- sprng 3 { stiffness: (1.0 2.0) } <- fixed;
                                            ^^^ expected `,`
        free -> mass 4 { mas: 1.0 } -> conn 2;
                         ^^^ `mass` has no parameter `mas`: did you mean `mass`?
        ",
    );
}

#[test]
fn an_element_has_its_parameters_and_no_others() {
    assert_refused(
        "
        struct M { length: f64, ei: f64 }
        fixed -> beam 1 { lenght: length, bending_stiffness: ei, quux: 1.0 } -> free;
                          ^^^^^^ `beam` has no parameter `lenght`: did you mean `length`?
                                                                 ^^^^ `beam` has no parameter `quux`: it has
                                                                 | `length`, `bending_stiffness`,
                                                                 | `mass_per_length`, `shear_stiffness`,
                                                                 | `rotary_inertia`, `axial_force`,
                                                                 | `foundation_stiffness`,
                                                                 | `foundation_shear_stiffness`,
                                                                 | `loss_factor`, `kelvin_voigt_time`,
                                                                 | `external_damping`,
                                                                 | `polar_inertia_per_length` and `speed`
                 ^^^^^^ `beam 1` lacks `mass_per_length`
        conn 2 <- spring 3 { stiffness: 1.0, stiffness: 2.0 } <- fixed;
                                             ^^^^^^^^^ `spring 3` gives `stiffness` a second time: remove one
                                             | of the two
        free -> mass 4 { r#mass: 1.0 } -> conn 2 -> hinge five { } -> fixed;
                                                    ^^^^^^^^^^ `hinge five` names no freedom that gives way,
                                                    | so it would be rigid: write `stiffness_rz: 0.0`, which
                                                    | lets the rotation go, or another stiffness
                                                                      ^^^^^ `fixed` is a second root: no path
                                                                      | joins this part of the model to the
                                                                      | first; a model is one tree
        ",
    );
}

#[test]
fn damping_belongs_to_some_elements() {
    assert_refused(
        "
        struct M { k: f64, eta: f64 }
        fixed -> spring 1 { stiffness: k, external_damping: eta }
                                          ^^^^^^^^^^^^^^^^ `spring` has no parameter `external_damping`: of
                                          | damping it has `loss_factor` and `kelvin_voigt_time`
        -> mass 2 { mass: 1.0, loss_factor: eta }
                               ^^^^^^^^^^^ `mass` has no parameter `loss_factor`: springs, torsion springs,
                               | uniform beams, rods and shafts have damping of their own, strings an external
                               | one
        -> string 3 { length: 1.0, tension: k, mass_per_length: 1.0, loss_factor: eta }
                                                                     ^^^^^^^^^^^ `string` has no parameter
                                                                     | `loss_factor`: of damping it has
                                                                     | `external_damping`
        -> rod 4 { length: 1.0, axial_stiffness: k, mass_per_length: 1.0, loss_facter: eta } -> free
                                                                          ^^^^^^^^^^^ `rod` has no parameter
                                                                          | `loss_facter`: did you mean
                                                                          | `loss_factor`?
        ",
    );
}

#[test]
fn an_element_needs_a_label_and_parameters() {
    assert_refused(
        "
        struct M;
        fixed -> spring -> conn 2 -> mass 1 -> free;
                 ^^^^^^ `spring` needs a label and parameters, `spring 1 { .. }`
                                     ^^^^^^ `mass 1` lacks its parameters in braces, `mass 1 { name: value, ..
                                     | }`
        fixed -> shop::Rope 3 -> conn 2;
                 ^^^^^^^^^^^^ `Rope 3` lacks its parameters in braces, `Rope 3 { name: value, .. }`
        ",
    );
}

#[test]
fn a_label_stands_apart() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> conn2 -> beam3 -> free;
                                                ^^^^^ `conn2` is not a support: put a space before the label,
                                                | `conn 2`
                                                         ^^^^^ `beam3` is not a support: put a space before
                                                         | the label, `beam 3`
        ",
    );
}

#[test]
fn an_element_is_written_once() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> mass 2 { mass: 1.0 } -> free;
        fixed -> spring 3 { stiffness: 1.0 } -> mass 2;
                                                ^^^^^^ `mass 2` is written a second time: an element is
                                                | written once; let paths meet in a connection, `conn`
        ",
    );
}

#[test]
fn a_support_takes_no_label_and_no_parameters() {
    assert_refused(
        "
        struct M;
        fixed 1 -> spring 2 { stiffness: 1.0 } -> free 3 {};
        ^^^^^ the support `fixed` takes no label and no parameters: write `fixed` alone
                                                  ^^^^ the support `free` takes no label and no parameters:
                                                  | write `free` alone
        fixed wall { } -> conn 4 -> free;
        ^^^^^ the support `fixed` takes no label and no parameters: write `fixed` alone
        ",
    );
    assert_refused(
        "
        struct M;
        fixed wall -> spring 2 { stiffness: 1.0 } -> free {};
              ^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
        ",
    );
}

#[test]
fn a_parameter_is_given_once() {
    assert_refused(
        "
        struct M { stiffness: f64 }
        fixed -> spring 1 { stiffness: 1.0, stiffness } -> mass 2 { mass: 1.0 } -> free;
                                            ^^^^^^^^^ `spring 1` gives `stiffness` a second time: remove one
                                            | of the two
        ",
    );
}

#[test]
fn one_slip_is_one_message() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> spring 1 { k } -> mass 2 { m: 1.0 } -> conn 3 -> free;
                            ^ `spring` has no parameter `k`: did you mean `stiffness`?
                                            ^ `mass` has no parameter `m`: did you mean `mass`?
        fixed -> Cable 4 { tension: k } -> conn 3;
                 ^^^^^ `Cable` is not an element: a type of your own is written with its path, `self::Cable`
        ",
    );
}

/// A word like no other is answered by all of them.
#[test]
fn an_unknown_word_is_shown_all_elements() {
    let message = super::messages("struct M { k: f64 } fixed -> quux 3 { stiffness: k } -> free;");
    for (keyword, ..) in crate::elements() {
        assert!(message.contains(&format!("`{keyword}`")), "{keyword} is not in: {message}");
    }
    assert!(message.contains("or a type of your own by a path with `::`"), "{message}");
}

#[test]
fn what_there_is_not_is_said_with_what_stands_for_it() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> plate 1 { length: k } -> free;
                 ^^^^^ `plate` is not an element: there are lines and rigid bodies, and no plates, shells and
                 | solids
        fixed -> gear 2 { ratio: k } -> free
                 ^^^^ `gear` is not an element: there are no gears: two shafts turn at one rate, or are two
                 | models
        ",
    );
}

#[test]
fn a_sketch_has_no_loops() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> spring 1 { stiffness: k } -> mass 2 { mass: 1.0 } -> free;
        for cell in 0..4 { spring 3 { stiffness: k } }
        ^^^ a sketch has no loops: write each cell, or describe the structure at run time by a `Frame` or a
        | list of steps
        ",
    );
}
