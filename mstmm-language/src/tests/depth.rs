//! What is nested too deeply for the stack is refused, and the deepest that is not can be expanded.

use super::{assert_refused, input};
use crate::depth;
use crate::expand::expand_checked;

/// Stack of rustc, of which the macro does not have the whole.
const STACK: usize = 7 << 20;

/// Levels of any kind that a model may have.
const ALLOWED: usize = 10;

/// What begins a level of an expression and what ends it.
const EXPRESSIONS: &[(&str, &str)] = &[
    ("(", ")"),
    ("[", "]"),
    ("{", "}"),
    ("f(", ")"),
    ("m!(", ")"),
    ("if a {", "} else { 1 }"),
    ("if let a = ", "{}"),
    ("match 1 { _ => ", "}"),
    ("{ fn f() {", "} }"),
    ("{ const C: u8 = ", "; }"),
    ("!", ""),
    ("& ", ""),
    ("return ", ""),
    ("|a, b| ", ""),
    ("a = ", ""),
    ("a + ", ""),
    ("", ".a"),
    ("", " as u8"),
];

const TYPES: &[(&str, &str)] = &[
    ("A<u8, ", ">"),
    ("*const ", ""),
    ("& ", ""),
    ("fn() -> ", ""),
    ("for<'a, 'b> fn() -> ", ""),
    ("<", " as A>::B"),
    ("(", ")"),
    ("[", "; 1]"),
    ("dyn Fn() -> ", ""),
];

const PATTERNS: &[(&str, &str)] = &[("& ", ""), ("a @ ", ""), ("(", ",)"), ("A { a: ", "}")];

/// Number of kinds in the three tables, and branches.
const KINDS: usize = EXPRESSIONS.len() + TYPES.len() + PATTERNS.len() + 1;

/// So many levels of a kind.
fn nested(kind: usize, depth: usize) -> String {
    let nest = |(open, close): (&str, &str), core: &str| open.repeat(depth) + core + &close.repeat(depth);
    let (types, patterns) = (EXPRESSIONS.len(), EXPRESSIONS.len() + TYPES.len());
    match kind {
        _ if kind < types => nest(EXPRESSIONS[kind], "1"),
        _ if kind < patterns => format!("1 as {}", nest(TYPES[kind - types], "a")),
        _ if kind < KINDS - 1 => format!("match 1 {{ {} => 1 }}", nest(PATTERNS[kind - patterns], "a")),
        _ => nest(("if a {} else ", ""), "{ 1 }"),
    }
}

/// The tokens as a parameter, in a `let` line or before the struct.
fn model(tokens: &str, place: usize) -> String {
    match place {
        0 => format!("struct M; fixed -> spring 1 {{ stiffness: {tokens} }} -> free;"),
        1 => format!("struct M; let k = {tokens}; fixed -> spring 1 {{ stiffness: k }} -> free;"),
        _ => format!("#[a = {{ {tokens} }}] struct M {{ k: f64 }} fixed -> spring 1 {{ stiffness: k }} -> free;"),
    }
}

#[test]
fn what_is_accepted_fits_the_stack() {
    let test = || {
        for (kind, place) in (0..KINDS).flat_map(|kind| (0..3).map(move |place| (kind, place))) {
            let model = |depth| input(&model(&nested(kind, depth), place));
            // the deepest that is accepted lies between
            let (mut accepted, mut refused) = (ALLOWED, 1100);
            assert!(depth::check(model(accepted)).is_ok(), "{}", model(accepted));
            assert!(depth::check(model(refused)).is_err(), "{}", model(accepted));
            while refused - accepted > 1 {
                let depth = accepted.midpoint(refused);
                *(if depth::check(model(depth)).is_ok() { &mut accepted } else { &mut refused }) = depth;
            }
            assert!(expand_checked(model(accepted)).is_ok(), "{}", model(ALLOWED));
        }
    };
    std::thread::Builder::new().stack_size(STACK).spawn(test).unwrap().join().unwrap();
}

/// Behind `at`, braces end no element, and assignments nest to their right.
#[test]
fn a_place_that_lies_too_deep_is_refused() {
    let place = |depth: usize| {
        let text =
            format!("struct M; fixed at {} 1.0 -> spring 1 {{ stiffness: 1.0 }} -> fixed", "a {} = ".repeat(depth));
        super::messages(&text)
    };
    let is_refused = |depth| place(depth).contains("nested too deeply");
    assert!(!is_refused(ALLOWED) && is_refused(100) && is_refused(100_000));
}

/// Long sketches are not deep ones.
#[test]
fn a_model_may_be_long() {
    let beam = |label| format!("-> beam {label} {{ length, bending_stiffness: 1.0, mass_per_length: crate::MASS }}");
    let chain: String = (0..500).map(beam).collect();
    let fields: String = (0..500).map(|field| format!("/// A field\n pub(crate) f{field}: f64,")).collect();
    let model = format!("/// Documented\n struct M {{ {fields} length: f64 }} fixed {chain} -> free;");
    assert!(expand_checked(input(&model)).is_ok());
    let beam = |label| format!("-> beam {label} {{ a, b: c::D }} -> conn c{label} at (length * {label}.0, 0.0)");
    let chain: String = (0..500).map(beam).collect();
    let model = format!("struct M {{ length: f64 }} fixed at (0.0, 0.0) {chain}");
    assert!(!super::messages(&model).contains("too deeply"));
}

#[test]
fn the_token_that_lies_too_deep_is_shown() {
    let (open, close) = ("(".repeat(62), ")".repeat(62));
    assert_refused(&format!(
        "
struct M;
fixed -> spring 1 {{ stiffness: {open}
    (1.0)
    ^ this is too long or nested too deeply: write a part of it in a `let` line of its own
{close} }} -> free;
"
    ));
}
