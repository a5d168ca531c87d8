//! The rows of the keywords are those of the core, and of the documentation.

use super::*;
use mstmm_core::elements::{ELEMENTS as OF_CORE, Row};

#[test]
fn each_element_of_the_core_has_one_keyword_with_its_state_and_parameters() {
    let is_variant =
        |row: &&Row| ELEMENTS.iter().filter_map(|row| row.variant).any(|variant| variant.type_name == row.name);
    let mut of_core: Vec<&Row> = OF_CORE.iter().filter(|row| !is_variant(row)).collect();
    let mut keywords: Vec<&Keyword> = ELEMENTS.iter().collect();
    of_core.sort_by_key(|row| row.name);
    keywords.sort_by_key(|keyword| keyword.type_name);
    let rows: Vec<&str> = keywords.iter().map(|keyword| keyword.type_name).collect();
    let names: Vec<&str> = of_core.iter().map(|row| row.name).collect();
    assert_eq!(rows, names, "rows of keywords.rs, and of elements/mod.rs in the core");
    for (keyword, of_core) in keywords.iter().zip(of_core) {
        assert_eq!(keyword.space, of_core.space, "{}", keyword.name);
        assert_eq!(keyword.parameters, of_core.parameters, "{}", keyword.name);
        assert!(keyword.optional.iter().all(|name| keyword.parameters.contains(name)), "{}", keyword.name);
    }
}

/// Another type has the parameters of the keyword, those that select it, and others that are zero.
#[test]
fn each_type_that_parameters_select_is_one_of_the_core() {
    for (keyword, variant) in ELEMENTS.iter().filter_map(|row| Some((row, row.variant?))) {
        let of_core = OF_CORE.iter().find(|row| row.name == variant.type_name);
        let of_core = of_core.unwrap_or_else(|| panic!("no `{}` in the core", variant.type_name));
        let parts = [keyword.parameters, variant.parameters, variant.absent];
        let mut parameters: Vec<&str> = parts.concat();
        let mut expected = of_core.parameters.to_vec();
        parameters.sort_unstable();
        expected.sort_unstable();
        assert_eq!(parameters, expected, "{}", keyword.name);
        assert_eq!(keyword.space, of_core.space, "{}", keyword.name);
    }
}

#[test]
fn the_grammar_says_which_elements_have_damping() {
    let grammar = include_str!("../../../docs/grammar.md");
    let (_, section) = grammar.split_once("### Damping of materials").unwrap();
    let is_damped = |variant: &Variant| variant.parameters.iter().all(|name| DAMPING.contains(name));
    for (keyword, damped) in ELEMENTS.iter().filter_map(|row| Some((row, row.variant.filter(is_damped)?))) {
        let quoted = format!("`{}`", keyword.name);
        let row = section.lines().find(|line| line.starts_with('|') && line.contains(&quoted));
        let row = row.unwrap_or_else(|| panic!("no row for {quoted} in the table of damping in docs/grammar.md"));
        for parameter in DAMPING {
            let is_there = row.contains(&format!("`{parameter}`"));
            assert_eq!(is_there, damped.parameters.contains(parameter), "{parameter} in docs/grammar.md: {row}");
        }
    }
}

#[test]
fn the_grammar_has_a_row_for_each_element() {
    let grammar = include_str!("../../../docs/grammar.md");
    for keyword in ELEMENTS {
        let quoted = format!("`{}`", keyword.name);
        let names_it = |row: &&str| row.split('|').nth(1).is_some_and(|cell| cell.contains(&quoted));
        let row = grammar.lines().filter(|line| line.starts_with('|')).find(names_it);
        let row = row.unwrap_or_else(|| panic!("no row for {quoted} in the table of elements in docs/grammar.md"));
        assert_eq!(row.split('|').nth(2).unwrap().trim(), keyword.space.to_string(), "{row}");
        for parameter in keyword.parameters {
            assert!(row.contains(&format!("`{parameter}`")), "no `{parameter}` in docs/grammar.md: {row}");
        }
    }
}

/// The rows of models with locations, `beam` without the length that follows from its points.
#[test]
fn each_keyword_is_known_in_models_with_locations() {
    for keyword in ELEMENTS {
        let row = located_of(keyword.name).unwrap_or_else(|| panic!("no row for {} in LOCATED", keyword.name));
        if row.role == Role::Unknown {
            continue;
        }
        let expected = keyword.parameters.iter().filter(|name| row.role != Role::Member || **name != "length");
        assert!(row.parameters.iter().eq(expected), "{}", keyword.name);
    }
    for row in LOCATED {
        let is_right = [Dimension::Line, Dimension::Plane].map(|dimension| row.instead(dimension).is_none());
        assert_eq!(is_right == [false, false], row.role == Role::Unknown, "{}", row.name);
        assert!(row.optional.iter().all(|name| row.parameters.contains(name)), "{}", row.name);
        assert!(row.vector.is_none_or(|name| row.parameters.contains(&name)), "{}", row.name);
    }
}

#[test]
fn the_grammar_has_a_row_for_each_element_of_models_with_locations() {
    let grammar = include_str!("../../../docs/grammar.md");
    let (_, section) = grammar.split_once("### Elements of located models").unwrap();
    let right = LOCATED.iter().filter(|row| !matches!(row.role, Role::Unknown | Role::Path));
    for row in right {
        let start = format!("| `{}` |", row.name);
        let line = section.lines().find(|line| line.starts_with(&start));
        let line = line.unwrap_or_else(|| panic!("no row for {} in docs/grammar.md", row.name));
        for parameter in row.parameters {
            assert!(line.contains(&format!("`{parameter}`")), "no `{parameter}` in docs/grammar.md: {line}");
        }
    }
}

#[test]
fn a_slip_of_the_pen_finds_its_keyword() {
    let elements = || ELEMENTS.iter().map(|element| element.name);
    assert_eq!(nearest(elements(), "baem"), Some("beam"));
    assert_eq!(nearest(elements(), "springdamper"), Some("spring_damper"));
    assert_eq!(nearest(elements(), "quux"), None);
}
