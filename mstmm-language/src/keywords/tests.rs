use super::*;
use std::path::Path;
use syn::{Fields, ImplItem, Item, ItemImpl, Type};

/// What the core itself says of its elements: each file declares a struct of parameters and implements `Element` for it.
struct OfCore {
    type_name: String,
    state: String,
    parameters: Vec<String>,
}

fn elements_of_core() -> Vec<OfCore> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../mstmm-core/src/elements");
    mstmm_core::elements::NAMES.iter().map(|name| element_of_core(&folder, name)).collect()
}

fn element_of_core(folder: &Path, name: &str) -> OfCore {
    let letters = name.chars().flat_map(|letter| [letter.is_uppercase().then_some('_'), letter.to_lowercase().next()]);
    let file = letters.flatten().collect::<String>();
    let source = std::fs::read_to_string(folder.join(format!("{}.rs", file.trim_start_matches('_')))).unwrap();
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
    assert_eq!(keywords.len(), of_core.len());
    for (keyword, of_core) in keywords.iter().zip(of_core) {
        assert_eq!(keyword.type_name, of_core.type_name);
        assert_eq!(format!("{:?}", keyword.state), of_core.state, "{}", keyword.name);
        assert_eq!(keyword.parameters, of_core.parameters, "{}", keyword.name);
    }
}

#[test]
fn a_slip_of_the_pen_finds_its_keyword() {
    let elements = || ELEMENTS.iter().map(|element| element.name);
    assert_eq!(nearest(elements(), "baem"), Some("beam"));
    assert_eq!(nearest(elements(), "springdamper"), Some("spring_damper"));
    assert_eq!(nearest(elements(), "quux"), None);
}
