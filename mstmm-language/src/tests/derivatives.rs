//! Messages about values that depend on fields and have no derivative, and the formulas of those that have one.

use super::{assert_refused, expanded};

/// The emitted function with the formulas.
fn chain(model: &str) -> String {
    let code = expanded(model);
    let (_, chain) = code.split_once("fn chain").unwrap();
    chain.split_once("chain . finish ()").unwrap().0.to_owned()
}

#[test]
fn functions_of_the_users_own() {
    assert_refused(
        "
        struct M { width: f64, height: f64, #[no_sensitivity] depth: f64 }
        let a = area(width);
                ^^^^ `area` has no derivative that mstmm knows: write the formula here, or mark `width` with
                | `#[no_sensitivity]`
        let sum = width + height * depth;
        let b = 2.0 * shop::area(depth, sum, height);
                      ^^^^^^^^^^ `shop::area` has no derivative that mstmm knows: write the formula here, or
                      | mark `width` and `height` with `#[no_sensitivity]`
        let c = width.frobnicate() + table.look_up(height) + f64::floor(width) + sum.powi(height);
                      ^^^^^^^^^^ `frobnicate` has no derivative that mstmm knows: write the formula here, or
                      | mark `width` with `#[no_sensitivity]`
                                           ^^^^^^^ `look_up` has no derivative that mstmm knows: write the
                                           | formula here, or mark `height` with `#[no_sensitivity]`
                                                             ^^^^^^^^^^ `f64::floor` has no derivative that
                                                             | mstmm knows: write the formula here, or mark
                                                             | `width` with `#[no_sensitivity]`
                                                                                     ^^^^ `powi` has no
                                                                                     | derivative that mstmm
                                                                                     | knows: write the
                                                                                     | formula here, or mark
                                                                                     | `width` and `height`
                                                                                     | with
                                                                                     | `#[no_sensitivity]`
        let d = (|x| x)(width);
                ^^^^^^^ this function has no derivative that mstmm knows: write the formula here, or mark
                | `width` with `#[no_sensitivity]`
        fixed -> spring 1 { stiffness: area(width > 1.0, width) } -> free;
                                       ^^^^ `area` has no derivative that mstmm knows: write the formula here,
                                       | or mark `width` with `#[no_sensitivity]`
        ",
    );
}

#[test]
fn what_a_value_may_not_pass_through() {
    assert_refused(
        "
        struct M { width: f64, height: f64 }
        let a = width as f64;
                      ^^ a cast has no derivative that mstmm knows: write the formula without it, or mark
                      | `width` with `#[no_sensitivity]`
        let b = max!(width, 2.0);
                ^^^ `max!` has no derivative that mstmm knows: write the formula here, or mark `width` with
                | `#[no_sensitivity]`
        let c = |x: f64| x * width;
                ^^^^^^^^^^^^^^^^^^ a closure has no derivative that mstmm knows: write the formula here, or
                | mark `width` with `#[no_sensitivity]`
        let d = &width;
                ^ a reference has no derivative that mstmm knows: write the formula without it, or mark
                | `width` with `#[no_sensitivity]`
        let e = width % 2.0;
                      ^ `%` has no derivative that mstmm knows: write the formula without it, or mark `width`
                      | with `#[no_sensitivity]`
        let f = [width, 2.0];
                ^^^^^^^^^^^^ this expression has no derivative that mstmm knows: write the formula here, or
                | mark `width` with `#[no_sensitivity]`
        let g = Section { width, height: 2.0 };
                ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this expression has no derivative that mstmm knows: write the
                | formula here, or mark `width` with `#[no_sensitivity]`
        let h = { let mut sum = 0.0; for n in 0..3 { sum += height; } sum };
                                     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ this expression has no derivative that
                                     | mstmm knows: write the formula here, or mark `height` with
                                     | `#[no_sensitivity]`
        let i = { let mut sum = 0.0; sum = height; assert!(height > 0.0); sum };
                                     ^^^^^^^^^^^^ this expression has no derivative that mstmm knows: write
                                     | the formula here, or mark `height` with `#[no_sensitivity]`
                                                   ^^^^^^ `assert!` has no derivative that mstmm knows: write
                                                   | the formula here, or mark `height` with
                                                   | `#[no_sensitivity]`
        let j = if (width, 2.0) < (1.0, height) { 1.0 } else { 2.0 };
                                ^ `<` has no derivative that mstmm knows: write the formula without it, or
                                | mark `width` and `height` with `#[no_sensitivity]`
        let k = match height { 1.0 => 2.0, other => other };
                               ^^^ this pattern has no derivative that mstmm knows: bind names and compare in
                               | an `if`, or mark `height` with `#[no_sensitivity]`
        fixed -> spring 1 { stiffness: a } -> free;
        ",
    );
}

/// What does not depend on fields is the user's.
#[test]
fn anything_goes_for_other_values() {
    let code = chain(
        "
        struct M { width: f64, #[no_sensitivity] depth: f64 }
        let a = area(depth) + max!(depth, 1.0) + (2 as f64) + [depth, 2.0][usize::from(width > 1.0)];
        let width_too = { let width = area(depth); area(width) };
        let b = (|depth: f64| depth * a)(2.0) + Section { width: 2.0 }.width % 2.0 + section.width;
        fixed -> spring 1 { stiffness: a * width } -> mass 2 { mass: depth } -> free;
        ",
    );
    assert!(code.contains("let a = area (depth) + max ! (depth , 1.0) + (2 as f64) + [depth , 2.0]"), "{code}");
    assert!(code.contains("let values = (a * width ,)"), "{code}");
}

/// Functions of `mstmm::sections` by the last two names of their paths, and of no other module.
#[test]
fn sections_have_derivatives() {
    let code = chain(
        "
        struct M { outer: f64 }
        let (area, i_y, ..) = sections::tube(outer, 0.5);
        let (k, _) = mstmm::sections::round_shear(1.0, outer);
        let post = sections::box_section(1.0, 2.0, 0.1);
        fixed -> spring 1 { stiffness: area * post.0 * k } -> mass 2 { mass: i_y } -> free;
        ",
    );
    for part in [
        "let (area , i_y , ..) = sections :: tube (outer , chain . constant (0.5)) ;",
        "let (k , _) = mstmm :: sections :: round_shear (chain . constant (1.0) , outer) ;",
        "let post = sections :: box_section (1.0 , 2.0 , 0.1) ;",
    ] {
        assert!(code.contains(part), "{part}: {code}");
    }
    assert_refused(
        "
        struct M { width: f64 }
        let a = profiles::tube(width, 0.5);
                ^^^^^^^^^^^^^^ `profiles::tube` has no derivative that mstmm knows: write the formula here, or
                | mark `width` with `#[no_sensitivity]`
        let b = sections::angle(width, 0.5);
                ^^^^^^^^^^^^^^^ `sections::angle` has no derivative that mstmm knows: write the formula here,
                | or mark `width` with `#[no_sensitivity]`
        let c = sections::tube((width, 0.5));
                ^^^^^^^^^^^^^^ `sections::tube` has no derivative that mstmm knows: give it one number for
                | each size, or mark `width` with `#[no_sensitivity]`
        fixed -> spring 1 { stiffness: a + b } -> free;
        ",
    );
}

/// Integers among numbers are slips, and refused in `build`; once is enough.
#[test]
fn an_integer_is_not_refused_twice() {
    let code = chain(
        "
        struct M { width: f64 }
        let a = 2 * width.max(1);
        fixed -> spring 1 { stiffness: a } -> free;
        ",
    );
    assert!(code.contains("let a = 2.0 * width . max (chain . constant (1.0)) ;"), "{code}");
}

/// Plain numbers become constants where a number with derivatives may stand too, and nowhere else.
#[test]
fn formulas_change_only_where_they_must() {
    let code = chain(
        "
        struct M { width: f64 }
        let (a, b): (f64, u8) = (2.0 * width, 3);
        let c: f64 = if a < 1.0 { 0.5 } else { a.max(2.0) };
        let d: f64 = 2.0;
        fixed -> spring 1 { stiffness: f64::hypot(d, c) } -> free;
        ",
    );
    for part in [
        "let width = chain . variable (self . field_width) ;",
        "let (a , b) : (_ , u8) = (2.0 * width , 3) ;",
        "let c : _ = if a < 1.0 { chain . constant ({ 0.5 }) } else { a . max (chain . constant (2.0)) } ;",
        "let d : f64 = 2.0 ;",
        "let values = ((chain . constant (d)) . hypot (c) ,)",
    ] {
        assert!(code.contains(part), "{part}\n{code}");
    }
}

#[test]
fn a_formula_has_no_other_way_out() {
    assert_refused(
        "
        struct M { width: f64 }
        let a = read()? + (|| read()?)();
                      ^ a formula has a value and no other way out: make what may fail a field, computed
                      | before
        fixed -> spring 1 { stiffness: if width < 0.0 { return } else { a * width } } -> free;
                                                        ^^^^^^ a formula has a value and no other way out:
                                                        | make what may fail a field, computed before
        ",
    );
    expanded(
        "
        struct M { #[no_sensitivity] width: f64 }
        fixed -> spring 1 { stiffness: read(width)? } -> free;
        ",
    );
}

#[test]
fn the_mark_is_about_fields() {
    assert_refused(
        "
        #[no_sensitivity]
        ^^^^^^^^^^^^^^^^^ `#[no_sensitivity]` marks a field: write it in front of the field that is meant
        struct M {
            #[no_sensitivity(always)]
            ^^^^^^^^^^^^^^^^^^^^^^^^^ `#[no_sensitivity]` takes no arguments: a formula takes its field as a
            | plain number
            width: f64,
            #[no_sensitivity = \"always\"]
            ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ `#[no_sensitivity]` takes no arguments: a formula takes its field as
            | a plain number
            height: f64,
        }
        #[no_sensitivity]
        ^ attributes stand in front of the struct and of its fields alone: remove this one
        let a = area(width, height);
        fixed -> spring 1 { stiffness: a, #[no_sensitivity] width } -> free;
                                          ^ expected a parameter, `name: value`, or `name` alone for the value
                                          | of that name
        ",
    );
}

/// The mark is the macro's own, and what is beside it is not.
#[test]
fn the_mark_is_not_emitted() {
    let code = expanded(
        "
        struct M { #[serde(skip)] #[no_sensitivity] /** Width */ width: f64 }
        fixed -> spring 1 { stiffness: area(width) } -> free;
        ",
    );
    assert!(!code.contains("no_sensitivity"), "{code}");
    assert!(code.contains("# [serde (skip)] # [doc = \" Width \"] width : f64"), "{code}");
}
