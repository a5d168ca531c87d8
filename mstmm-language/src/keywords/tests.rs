//! The rows of the keywords are those of the core, and of the documentation.

use super::*;
use mstmm_core::elements::{ELEMENTS as OF_CORE, Row, STRETCHING};
use mstmm_plan::Space;
use std::collections::BTreeSet;

const DIMENSIONS: [Dimension; 3] = [Dimension::Line, Dimension::Plane, Dimension::Space];

fn sorted<'a>(names: impl IntoIterator<Item = &'a str>) -> BTreeSet<&'a str> {
    names.into_iter().collect()
}

/// A type has the parameters that its keyword requires, its own, and no others, as fields of their names or of others.
#[test]
fn each_type_of_a_keyword_is_one_of_the_core_with_its_state_and_parameters() {
    for keyword in ELEMENTS {
        assert!(!keyword.types.is_empty(), "{}", keyword.name);
        for row in keyword.types {
            let of_core = OF_CORE.iter().find(|of_core| of_core.name == row.name);
            let of_core = of_core.unwrap_or_else(|| panic!("no `{}` in the core", row.name));
            let fields = keyword.required.iter().chain(row.parameters).map(|name| row.field(name));
            let along = keyword.stretches().then_some(AXIAL_STIFFNESS);
            let expected = of_core.parameters.iter().copied().chain(along);
            assert_eq!(sorted(fields), sorted(expected), "{} {}", keyword.name, row.name);
            if keyword.stretches() {
                assert!(STRETCHING.contains(&row.name), "{} {}", keyword.name, row.name);
                assert_eq!(keyword.space, Space::Planar, "{}", keyword.name);
            } else {
                assert_eq!(keyword.space, of_core.space, "{}", keyword.name);
            }
        }
    }
}

#[test]
fn each_element_of_the_core_has_a_keyword() {
    let types = || ELEMENTS.iter().flat_map(|keyword| keyword.types).map(|row| row.name);
    let without: Vec<&Row> = OF_CORE.iter().filter(|row| types().all(|name| name != row.name)).collect();
    assert!(without.is_empty(), "{without:?}");
}

/// All sets of the optional parameters: nothing that is named is lost, and no type before the one that is taken has it all.
#[test]
fn each_set_of_optional_parameters_selects_the_cheapest_type_that_has_them() {
    for keyword in ELEMENTS {
        let one_of =
            if keyword.one_of.is_empty() { vec![None] } else { keyword.one_of.iter().copied().map(Some).collect() };
        for (set, one) in
            (0..1_usize << keyword.optional.len()).flat_map(|set| one_of.iter().map(move |one| (set, *one)))
        {
            let optional = keyword.optional.iter().enumerate();
            let chosen = optional.filter(|(index, _)| set >> index & 1 == 1).map(|(_, name)| *name);
            let named: BTreeSet<&str> = chosen.chain(one).collect();
            // what spins has no loss factor, of which a rule speaks
            let spins = SPIN.iter().any(|name| named.contains(name));
            if spins && named.contains("loss_factor") {
                continue;
            }
            let has_all = |row: &&TypeRow| named.iter().all(|name| row.parameters.contains(name));
            let taken = keyword.type_with(|name| named.contains(name));
            assert!(has_all(&taken), "{} with {named:?} is {}", keyword.name, taken.name);
            let before = keyword.types.iter().take_while(|row| row.name != taken.name).find(has_all);
            assert_eq!(before, None, "{} with {named:?}", keyword.name);
        }
    }
}

/// What a beam is with some of its parameters, along a line and in the plane.
#[test]
fn the_parameters_of_a_beam_select_its_type() {
    for (named, of_line) in [
        (&[][..], "Beam"),
        (&["rotary_inertia"], "RayleighBeam"),
        (&["axial_force"], "BeamColumn"),
        (&["foundation_shear_stiffness"], "FoundationBeam"),
        (&["shear_stiffness"], "TimoshenkoBeam"),
        (&["shear_stiffness", "rotary_inertia"], "TimoshenkoBeam"),
        (&["rotary_inertia", "axial_force"], "GeneralBeam"),
        (&["shear_stiffness", "foundation_stiffness"], "GeneralBeam"),
        (&["loss_factor"], "DampedBeam"),
        (&["shear_stiffness", "axial_force", "external_damping"], "DampedBeam"),
    ] {
        let taken = |dimension| element_of("beam", dimension).unwrap().type_with(|name| named.contains(&name)).name;
        assert_eq!(taken(Dimension::Line), of_line, "{named:?}");
        assert_eq!(taken(Dimension::Plane), of_line, "{named:?}");
    }
    for (named, of_line) in [
        (&["rotary_inertia", "polar_inertia_per_length", "speed"][..], "SpinningBeam"),
        (&["rotary_inertia", "polar_inertia_per_length", "speed", "external_damping"], "DampedSpinningBeam"),
    ] {
        let taken = element_of("beam", Dimension::Line).unwrap().type_with(|name| named.contains(&name)).name;
        assert_eq!(taken, of_line, "{named:?}");
    }
}

/// A type of which a parameter is left out is as if it were not there: rigid, or zero.
#[test]
fn what_is_not_named_is_neutral() {
    for keyword in ELEMENTS {
        for name in keyword.types.iter().flat_map(|row| row.parameters) {
            let is_rigid = name.contains("stiffness") && !name.contains("foundation") && !name.contains("cross");
            assert_eq!(neutral(name) == f64::INFINITY, is_rigid, "{} {name}", keyword.name);
        }
    }
}

/// The cells of the first table row in a section that begin with a keyword and go on with a state, or with anything.
fn row_of<'g>(section: &'g str, keyword: &str, second: Option<&str>) -> Option<&'g str> {
    let quoted = format!("`{keyword}`");
    section.lines().filter(|line| line.starts_with('|')).find(|row| {
        let mut cells = row.split('|').skip(1).map(str::trim);
        cells.next().is_some_and(|cell| cell.contains(&quoted))
            && second.is_none_or(|second| cells.next() == Some(second))
    })
}

#[test]
fn the_grammar_says_which_elements_have_damping() {
    let grammar = include_str!("../../../docs/grammar.md");
    let (_, section) = grammar.split_once("### Damping of materials").unwrap();
    for keyword in ELEMENTS.iter().filter(|row| row.optional.iter().any(|name| DAMPING.contains(name))) {
        let row = row_of(section, keyword.name, None);
        let row =
            row.unwrap_or_else(|| panic!("no row for {} in the table of damping in docs/grammar.md", keyword.name));
        for parameter in DAMPING {
            let is_there = row.contains(&format!("`{parameter}`"));
            assert_eq!(is_there, keyword.optional.contains(parameter), "{parameter} in docs/grammar.md: {row}");
        }
    }
}

#[test]
fn the_grammar_has_a_row_for_each_element() {
    let grammar = include_str!("../../../docs/grammar.md");
    let (_, section) = grammar.split_once("## Elements").unwrap();
    for keyword in ELEMENTS {
        let (name, space) = (keyword.name, keyword.space.to_string());
        let row = row_of(section, name, Some(&space));
        let row =
            row.unwrap_or_else(|| panic!("no row for {name}, {space}, in the table of elements in docs/grammar.md"));
        let of_damping = |name: &&&str| !DAMPING.contains(name);
        for parameter in keyword.required.iter().chain(keyword.optional).chain(keyword.one_of).filter(of_damping) {
            assert!(row.contains(&format!("`{parameter}`")), "no `{parameter}` in docs/grammar.md: {row}");
        }
    }
}

/// A word of models with locations has a row, and is right in one dimension at least unless another one is to be taken.
#[test]
fn each_keyword_is_known_in_models_with_locations() {
    for keyword in ELEMENTS {
        assert!(located_of(keyword.name).is_some(), "no row for {} in LOCATED", keyword.name);
    }
    for row in LOCATED {
        let is_right = DIMENSIONS.map(|dimension| row.instead(dimension).is_none());
        assert_eq!(is_right == [false; 3], row.role == Role::Unknown, "{}", row.name);
        for dimension in DIMENSIONS.into_iter().filter(|of| row.instead(*of).is_none()) {
            let [required, _] = row.parameters(dimension);
            assert!(!(row.spans_places() && required.contains(&"length")), "{}", row.name);
            let instead = row.instead(dimension).map(located_of);
            assert!(instead.is_none_or(|instead| instead.is_some()), "{}", row.name);
        }
    }
}

#[test]
fn the_grammar_has_a_row_for_each_element_of_models_with_locations() {
    let grammar = include_str!("../../../docs/grammar.md");
    let (_, section) = grammar.split_once("### Elements of located models").unwrap();
    for row in LOCATED.iter().filter(|row| !matches!(row.role, Role::Unknown | Role::Path)) {
        for dimension in DIMENSIONS.into_iter().filter(|of| row.instead(*of).is_none()) {
            let parameters = row.parameters(dimension).concat();
            let start = format!("| `{}` |", row.name);
            let has_all = |line: &&str| {
                let of_damping = |name: &&&str| !DAMPING.contains(name);
                line.starts_with(&start)
                    && parameters.iter().filter(of_damping).all(|name| line.contains(&format!("`{name}`")))
            };
            let found = section.lines().find(has_all);
            assert!(found.is_some(), "no row for {} with {parameters:?} in docs/grammar.md", row.name);
        }
    }
}

#[test]
fn a_slip_of_the_pen_finds_its_keyword() {
    let elements = || ELEMENTS.iter().map(|element| element.name);
    assert_eq!(nearest(elements(), "baem"), Some("beam"));
    assert_eq!(nearest(elements(), "torsionspring"), Some("torsion_spring"));
    assert_eq!(nearest(elements(), "quux"), None);
}

/// What stands for an old word is a word, and has the parameters that have another name there; the old word is none.
#[test]
fn the_new_form_of_an_old_word_is_one_of_its_new_word() {
    for word in OLD_WORDS {
        assert!(ELEMENTS.iter().all(|row| row.name != word.name) && located_of(word.name).is_none(), "{}", word.name);
        let rows = || ELEMENTS.iter().filter(|row| row.name == word.new);
        assert!(rows().next().is_some(), "no {} for {}", word.new, word.name);
        for (old, _) in word.renamed {
            let written = word.parameter(old, "x").unwrap();
            let (name, _) = written.split_once(':').unwrap();
            assert!(has_somewhere(word.new, name), "{} {written}", word.name);
        }
    }
    assert_eq!(
        old_word("general_beam").unwrap().parameter("shear_flexibility", "f"),
        Some("shear_stiffness: 1.0 / (f)".to_owned())
    );
    assert_eq!(old_word("general_beam").unwrap().parameter("axial_force", "0.0"), None);
    assert_eq!(old_word("shear_hinge").unwrap().parameter("stiffness", "0.0"), Some("stiffness_y: 0.0".to_owned()));
}
