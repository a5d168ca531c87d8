//! Messages of the parser.

use super::{assert_refused, expanded};

#[test]
fn a_model_begins_with_its_struct() {
    assert_refused(
        "
        pub fixed -> spring 1 { stiffness: 1.0 } -> free
            ^^^^^ a model begins with its struct of parameters, `struct Model { length: f64, .. }`
        ",
    );
    assert_refused(
        "
        enum Model { A }
        ^^^^ a model begins with its struct of parameters, `struct Model { length: f64, .. }`
        ",
    );
}

#[test]
fn what_is_missing_at_the_end_is_shown_at_the_last_token() {
    assert_refused(
        "
        pub
          ^ a model begins with its struct of parameters, `struct Model { length: f64, .. }`
        ",
    );
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } ->
                                              ^ expected a support, a connection `conn ..` or an element
        ",
    );
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: } -> free
                                       ^ unexpected end of input, expected an expression
        ",
    );
    assert_refused(
        "
        struct M;
        let k = 1.0
                  ^ expected `;` at the end of the `let` line
        ",
    );
}

#[test]
fn every_line_is_read_before_errors_are_shown() {
    assert_refused(
        "
        struct M;
        let k: f64;
                  ^ expected `=`: a `let` line gives a value a name, `let name = expression;`
        let mass = ;
                   ^ expected an expression
        fixed spring 1 { stiffness } -> conn 2;
              ^^^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
        free -> mass 3 { mass = 1.0 } -> conn 2;
                              ^ expected `:`: a parameter is written `mass: value`
        conn 2 -> free
        ",
    );
}

#[test]
fn let_lines() {
    assert_refused(
        "
        struct M { k: f64 }
        let double;
                  ^ expected `=`: a `let` line gives a value a name, `let name = expression;`
        let Some(half) = Some(k / 2.0) else { return };
                                       ^^^^ a `let` line takes no `else`: its pattern must always match
        let third = k / 3.0
        fixed -> spring 1 { stiffness: k } -> free;
        ^^^^^ expected `;` at the end of the `let` line
        ",
    );
}

#[test]
fn a_let_line_stands_before_the_first_path() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> spring 1 { stiffness } -> mass 2 { mass: 1.0 } -> free;
        let stiffness = 2.0 * k;
        ^^^ `let` lines stand between the struct and the first path: move this one up
        ",
    );
}

/// Any pattern that always matches, as in Rust.
#[test]
fn a_let_line_takes_patterns_and_types() {
    let code = expanded(
        "
        struct M { #[no_sensitivity] k: f64 }
        let (stiffness, mut mass): (f64, f64) = (k, 2.0 * k);
        let Pair { a, b: [c, _] } = pair(k);
        fixed -> spring 1 { stiffness } -> mass 2 { mass: mass + a + c } -> free
        ",
    );
    assert!(code.contains("let (stiffness , mut mass) : (f64 , f64) = (k , 2.0 * k) ;"), "{code}");
    assert!(code.contains("let Pair { a , b : [c , _] } = pair (k) ;"), "{code}");
}

#[test]
fn an_arrow_is_missing() {
    assert_refused(
        "
        struct M;
        fixed - spring 1 { stiffness: 1.0 } => mass 2 { mass: 1.0 } -> free;
              ^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
        fixed -> spring 3 { stiffness: 1.0 } { } -> free;
                                             ^ expected an arrow, `->` or `<-`; where a new path begins, end
                                             | the one before it with `;`
        fixed -> conn 4 spring 5 { stiffness: 1.0 };
                        ^^^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it
                        | with `;`
        ",
    );
}

#[test]
fn a_semicolon_is_missing_between_two_paths() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> conn 2 -> free
        free -> mass 3 { mass: 1.0 } -> conn 2
        ^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
        ",
    );
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> conn 2 -> free
        conn 2 <- mass 3 { mass: 1.0 } <- free
        ^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
        ",
    );
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness: 1.0 } -> conn 2 -> free
        spring 3 { stiffness: 1.0 } -> conn 2
        ^^^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
        ",
    );
}

#[test]
fn a_node_is_missing() {
    assert_refused(
        "
        struct M;
        -> spring 1 { stiffness: 1.0 } -> free;
        ^^ expected a support, a connection `conn ..` or an element
        fixed -> -> spring 2 { stiffness: 1.0 } -> free;
                 ^^ expected a support, a connection `conn ..` or an element
        fixed -> 3 { stiffness: 1.0 } -> free;
                 ^ expected a support, a connection `conn ..` or an element, such as `conn 3`
        fixed -> { stiffness: 1.0 } -> free;
                 ^ expected a support, a connection `conn ..` or an element
        fixed -> spring 4 { stiffness: 1.0 } -> free;;
                                                     ^ there is no path before this `;`: remove it
        ",
    );
}

#[test]
fn a_label_is_missing() {
    assert_refused(
        "
        struct M;
        fixed -> spring { stiffness: 1.0 } -> conn;
                 ^^^^^^ `spring` needs a label, a name or a number: `spring 1 { .. }`
        fixed -> conn -> free;
                 ^^^^ `conn` needs a label, a name or a number: `conn 1`
        fixed -> crate::shop::Rope { length: 1.0 } -> free;
                 ^^^^^^^^^^^^^^^^^ `Rope` needs a label, a name or a number: `Rope 1 { .. }`
        ",
    );
}

#[test]
fn a_label_is_a_name_or_a_plain_number() {
    assert_refused(
        "
        struct M;
        fixed -> spring 01 { stiffness: 1.0 } -> free;
                        ^^ `01` is not a label: a label is a name or a decimal number without leading zero or
                        | suffix, such as `arm` or `12`
        fixed -> spring 1u8 { stiffness: 1.0 } -> free;
                        ^^^ `1u8` is not a label: a label is a name or a decimal number without leading zero
                        | or suffix, such as `arm` or `12`
        fixed -> spring 0x1 { stiffness: 1.0 } -> free;
                        ^^^ `0x1` is not a label: a label is a name or a decimal number without leading zero
                        | or suffix, such as `arm` or `12`
        fixed -> spring 1_000 { stiffness: 1.0 } -> free;
                        ^^^^^ `1_000` is not a label: a label is a name or a decimal number without leading
                        | zero or suffix, such as `arm` or `12`
        fixed -> spring 1.5 { stiffness: 1.0 } -> free;
                        ^^^ `1.5` is not a label: a label is a name or a decimal number without leading zero
                        | or suffix, such as `arm` or `12`
        fixed -> spring 1e3 { stiffness: 1.0 } -> conn 2nd -> free;
                        ^^^ `1e3` is not a label: a label is a name or a decimal number without leading zero
                        | or suffix, such as `arm` or `12`
                                                       ^^^ `2nd` is not a label: a label is a name or a
                                                       | decimal number without leading zero or suffix, such
                                                       | as `arm` or `12`
        fixed -> spring \"arm\" { stiffness: 1.0 } -> conn true -> free;
                        ^^^^^ `\"arm\"` is not a label: a label is a name or a decimal number without leading
                        | zero or suffix, such as `arm` or `12`
                                                         ^^^^ `true` is not a label: a label is a name or a
                                                         | decimal number without leading zero or suffix, such
                                                         | as `arm` or `12`
        ",
    );
}

#[test]
fn a_parameter_is_written_with_a_colon() {
    assert_refused(
        "
        struct M;
        fixed -> spring 1 { stiffness = 1.0 } -> free;
                                      ^ expected `:`: a parameter is written `stiffness: value`
        fixed -> spring 2 { stiffness 1.0 } -> free;
                                      ^^^ expected `:`: a parameter is written `stiffness: value`
        fixed -> spring 3 { .. } -> free;
                            ^^ `..` stands before the name of a section, whose parameters the element takes:
                            | `..steel`
        fixed -> spring 4 { 1.0 } -> free;
                            ^^^ expected a parameter, `name: value`, or `name` alone for the value of that
                            | name
        fixed -> spring 5 { stiffness: 1.0 damping: 2.0 } -> free;
                                           ^^^^^^^ expected `,` between parameters
        fixed -> spring 6 { stiffness: 1.0; damping: 2.0 } -> free;
                                          ^ expected `,` between parameters
        ",
    );
}

#[test]
fn the_path_of_an_element_ends_in_a_type() {
    assert_refused(
        "
        struct M;
        fixed -> self::self 1 { stiffness: 1.0 } -> shop::Self 2 { stiffness: 1.0 } -> free;
                       ^^^^ `self` is no type: the path of an element ends in the name of its type
        ",
    );
}

#[test]
fn slips_between_nodes_have_their_own_advice() {
    assert_refused(
        "
        struct M;
        let = 2.0;
            ^ expected a name: a `let` line gives a value a name, `let name = expression;`
        fixed -> beam1 { length: 1.0 } -> free;
                 ^^^^^ put a space before the label, `beam 1 { .. }`
        fixed -> beam 1 (length, mass) -> free;
                        ^ parameters stand in braces, `{ name: value, .. }`, and nodes between arrows
        fixed -> conn 2 {} -> free;
                        ^ `conn 2` joins paths: it takes no parameters
        pinned(conn 2);
              ^ parameters stand in braces, `{ name: value, .. }`, and nodes between arrows
        fixed -> beam fn {} -> conn _;
                      ^^ `fn` is a word of Rust: give `beam` another label
        fixed -> cable::Cable<f64> 1 {} -> free;
                             ^ the type of an element is written without generic arguments
        fixed -> 2;
                 ^ expected a support, a connection `conn ..` or an element, such as `conn 2`
        fixed -> beam 3 { length bending_stiffness: 1.0 } -> free;
                                 ^^^^^^^^^^^^^^^^^ expected `,` between parameters
        fixed -> beam 3 { length; bending_stiffness } -> free;
                                ^ expected `,` between parameters
        fixed -> spring 4 { stiffness: 1.0 } -> free;;
                                                     ^ there is no path before this `;`: remove it
        ",
    );
    assert_refused(
        "
        struct M {};
                   ^ there is no path before this `;`: remove it
        fixed -> spring 4 { stiffness: 1.0 } -> free
        ",
    );
}
