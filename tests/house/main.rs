//! The house holds: rooms import in one order, files not in circles, and neither files nor functions grow too long.
#![expect(clippy::unwrap_used, clippy::panic, reason = "sources are there and parse")]

mod source;

use source::Source;
use std::collections::BTreeSet;

/// Lines beyond which a file says too much.
const LONGEST_FILE: usize = 400;

/// Lines beyond which a function does too much.
const LONGEST_FUNCTION: usize = 60;

/// The rooms of the core from the ground up, each with what it may import: rooms, or single files of a room.
const ORDER: &[(&str, &[&str])] = &[
    ("number", &[]),
    ("model", &["number"]),
    ("subspace", &["number", "model"]),
    ("element", &["number", "model", "subspace"]),
    ("elements", &["number", "model", "subspace", "element"]),
    ("pass", &["number", "model", "subspace", "element"]),
    ("search", &["number", "model", "subspace/count", "pass/characteristic"]),
    ("answer", &["number", "model", "subspace/count", "element", "pass", "search"]),
];

/// The sources of all crates that are published.
fn sources() -> Vec<Source> {
    ["mstmm-core", "mstmm-lanes", "mstmm-language", "mstmm-macros", "."].map(Source::of).into()
}

fn core() -> Source {
    Source::of("mstmm-core")
}

#[test]
fn rooms_import_in_the_order_of_the_house() {
    let core = core();
    let mut wrong = BTreeSet::new();
    for file in &core.files {
        let Some((room, _)) = file.name.split_once('/') else { continue };
        let (_, allowed) =
            ORDER.iter().find(|(name, _)| *name == room).unwrap_or_else(|| panic!("{room} has no place"));
        for import in core.imports(file) {
            let is_inside = |place: &str| import == place || import.starts_with(&format!("{place}/"));
            if !is_inside(room) && !allowed.iter().any(|place| is_inside(place)) {
                wrong.insert(format!("{} imports {import}", file.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn files_do_not_import_each_other_in_circles() {
    for source in sources() {
        let imports: Vec<(&str, BTreeSet<String>)> =
            source.files.iter().map(|file| (file.name.as_str(), source.imports(file))).collect();
        let mut left: BTreeSet<&str> = imports.iter().map(|(name, _)| *name).collect();
        // what imports nothing that is left, or is imported by nothing that is left, is in no circle
        loop {
            let stands_on =
                |name: &str| imports.iter().filter(move |(other, _)| *other == name).flat_map(|(_, all)| all);
            let imports_some = |name: &str| stands_on(name).any(|import| left.contains(import.as_str()));
            let is_imported = |name: &str| left.iter().any(|other| stands_on(other).any(|import| import == name));
            let held: BTreeSet<&str> =
                left.iter().copied().filter(|name| imports_some(name) && is_imported(name)).collect();
            if held.len() == left.len() {
                break;
            }
            left = held;
        }
        assert!(left.is_empty(), "{}: circles among {left:#?}", source.name);
    }
}

#[test]
fn files_and_functions_are_short() {
    let mut long = Vec::new();
    for source in sources() {
        for file in &source.files {
            if file.lines > LONGEST_FILE {
                long.push(format!("{}/{} has {} lines", source.name, file.name, file.lines));
            }
            for (function, lines) in &file.functions {
                if *lines > LONGEST_FUNCTION {
                    long.push(format!("{}/{}: {function} has {lines} lines", source.name, file.name));
                }
            }
        }
    }
    assert!(long.is_empty(), "{long:#?}");
}
