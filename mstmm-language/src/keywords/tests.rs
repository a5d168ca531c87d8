use super::*;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use syn::{Fields, ImplItem, Item, ItemImpl, Type};

/// What the core itself says of its elements: each file declares a struct of parameters and implements `Element` for it.
struct OfCore {
    type_name: String,
    state: String,
    parameters: Vec<String>,
}

fn folder_of_elements() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../mstmm-core/src/elements")
}

fn elements_of_core() -> Vec<OfCore> {
    mstmm_core::elements::NAMES.iter().map(|name| element_of_core(name)).collect()
}

/// The file of an element, without its extension.
fn file_of(name: &str) -> String {
    let letters = name.chars().flat_map(|letter| [letter.is_uppercase().then_some('_'), letter.to_lowercase().next()]);
    let file = letters.flatten().collect::<String>();
    file.trim_start_matches('_').to_owned()
}

fn element_of_core(name: &str) -> OfCore {
    let source = std::fs::read_to_string(folder_of_elements().join(format!("{}.rs", file_of(name)))).unwrap();
    let items = syn::parse_file(&source).unwrap().items;
    let parameters = items.iter().find_map(|item| parameters_of(item, name)).unwrap();
    let state = items.iter().find_map(state_of).unwrap();
    OfCore { type_name: name.to_owned(), state, parameters }
}

/// The fields of the struct of this name.
fn parameters_of(item: &Item, name: &str) -> Option<Vec<String>> {
    let Item::Struct(item) = item else { return None };
    let Fields::Named(fields) = &item.fields else { return None };
    let names = fields.named.iter().map(|field| field.ident.as_ref().unwrap().to_string());
    (item.ident == name).then(|| names.collect())
}

/// `type State = ..` of `impl Element`.
fn state_of(item: &Item) -> Option<String> {
    let Item::Impl(ItemImpl { trait_: Some((path, _)), items, .. }) = item else { return None };
    let is_element = path.segments.last().is_some_and(|segment| segment.ident == "Element");
    items.iter().filter(|_| is_element).find_map(|item| match item {
        ImplItem::Type(item) if item.ident == "State" => match &item.ty {
            Type::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        },
        _ => None,
    })
}

#[test]
fn each_element_of_the_core_has_one_keyword_with_its_state_and_parameters() {
    let mut of_core = elements_of_core();
    let mut keywords: Vec<&Keyword> = ELEMENTS.iter().collect();
    of_core.sort_by(|a, b| a.type_name.cmp(&b.type_name));
    keywords.sort_by_key(|keyword| keyword.type_name);
    let rows: Vec<&str> = keywords.iter().map(|keyword| keyword.type_name).collect();
    let names: Vec<&str> = of_core.iter().map(|element| element.type_name.as_str()).collect();
    assert_eq!(rows, names, "rows of keywords.rs, and of elements/mod.rs in the core");
    for (keyword, of_core) in keywords.iter().zip(of_core) {
        assert_eq!(keyword.space.to_string(), of_core.state.to_lowercase(), "{}", keyword.name);
        assert_eq!(keyword.parameters, of_core.parameters, "{}", keyword.name);
    }
}

/// A file without a row is not even compiled.
#[test]
fn each_file_of_an_element_has_its_row_in_the_core() {
    let entries = std::fs::read_dir(folder_of_elements()).unwrap().map(|entry| entry.unwrap().path());
    let files: BTreeSet<String> = entries
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .filter(|file| !["mod", "laws", "any"].contains(&file.as_str()))
        .collect();
    let rows = mstmm_core::elements::NAMES.iter().map(|name| file_of(name)).collect();
    assert_eq!(files, rows, "files in elements/ of the core, and rows of elements/mod.rs");
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

#[test]
fn a_slip_of_the_pen_finds_its_keyword() {
    let elements = || ELEMENTS.iter().map(|element| element.name);
    assert_eq!(nearest(elements(), "baem"), Some("beam"));
    assert_eq!(nearest(elements(), "springdamper"), Some("spring_damper"));
    assert_eq!(nearest(elements(), "quux"), None);
}
