//! The house holds: rooms import in one order, files not in circles, and neither files nor functions grow too long.
#![expect(clippy::unwrap_used, reason = "sources are there and parse")]

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
    (
        "search",
        &[
            "number",
            "model",
            "subspace/count",
            "pass/characteristic",
            "pass/searched",
            "pass/at_once",
            "pass/side_by_side",
        ],
    ),
    ("answer", &["number", "model", "subspace/count", "element", "pass", "search"]),
];

/// The sources of all crates that are published.
fn sources() -> Vec<Source> {
    ["mstmm-plan", "mstmm-core", "mstmm-drawing", "mstmm-files", "mstmm-lanes", "mstmm-language", "mstmm-macros", "."]
        .map(Source::of)
        .into()
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
        let mut arrows: BTreeSet<(&str, String)> = BTreeSet::new();
        for file in &source.files {
            arrows.extend(source.imports(file).into_iter().map(|import| (file.name.as_str(), import)));
        }
        // an arrow from a file that nothing imports, or to one that imports nothing, is in no circle
        loop {
            let held = |(from, to): &&(&str, String)| {
                arrows.iter().any(|(_, other)| other == from) && arrows.iter().any(|(other, _)| other == to)
            };
            let left: BTreeSet<(&str, String)> = arrows.iter().filter(held).cloned().collect();
            if left.len() == arrows.len() {
                break;
            }
            arrows = left;
        }
        assert!(arrows.is_empty(), "{}: circles among {arrows:#?}", source.name);
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
