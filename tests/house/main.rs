//! The house holds: rooms import in one order, files not in circles, neither files nor functions grow too long, and links of documents lead
//! somewhere.
#![expect(clippy::unwrap_used, reason = "sources are there and parse")]

mod documents;
mod source;

use documents::{documents, root, target};
use source::Source;
use std::collections::BTreeSet;
use std::path::Path;

/// Lines beyond which a file says too much.
const LONGEST_FILE: usize = 400;

/// Lines beyond which a function does too much.
const LONGEST_FUNCTION: usize = 60;

/// The rooms of the core from the ground up, each with what it may import: rooms, or single files of a room.
const ORDER: &[(&str, &[&str])] = &[
    ("number", &[]),
    ("model", &["number"]),
    ("sections", &["number", "model/error"]),
    ("subspace", &["number", "model"]),
    ("structure", &["number", "model"]),
    ("element", &["number", "model", "subspace", "structure"]),
    ("elements", &["number", "model", "subspace", "structure", "element"]),
    ("proof", &["number", "model", "element/member_numbers"]),
    ("pass", &["number", "model", "subspace", "structure", "element", "proof/visit"]),
    (
        "search",
        &[
            "number",
            "model",
            "subspace/count",
            "pass/characteristic",
            "pass/formulas",
            "pass/searched",
            "pass/at_once",
            "pass/side_by_side",
            "proof",
            "element/member_numbers",
        ],
    ),
    ("frame", &["number", "model", "structure", "subspace", "element", "elements", "proof/visit", "pass"]),
    ("answer", &["number", "model", "subspace/count", "element", "pass", "search", "frame"]),
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

#[test]
fn links_of_documents_lead_somewhere() {
    let documents = documents();
    let mut dead = Vec::new();
    for document in &documents {
        for link in &document.links {
            let Some((path, anchor)) = target(document, link) else { continue };
            let other = documents.iter().find(|other| other.path == path);
            let is_there = match anchor {
                Some(anchor) => other.is_some_and(|other| other.anchors.contains(anchor)),
                None => root().join(&path).exists(),
            };
            // a link of a page of the book to what is not in the book is dead there
            let is_in_book = !document.path.starts_with("docs") || path.starts_with("docs");
            if !is_there || !is_in_book {
                dead.push(format!("{}: {link}", document.path.display()));
            }
        }
    }
    assert!(dead.is_empty(), "{dead:#?}");
}

/// Each file that ARCHITECTURE.md names is there: below the root, or below the core.
#[test]
fn files_of_the_architecture_are_there() {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let named = text.lines().flat_map(|line| line.split('`').skip(1).step_by(2));
    let named = named.filter(|path| (path.contains(".rs") || path.ends_with('/')) && !path.contains('<'));
    let files: Vec<String> = named.flat_map(with_braces).collect();
    assert!(files.len() > 100, "{files:?}");
    let is_there = |file: &&String| ["", "mstmm-core/src"].iter().any(|room| root().join(room).join(file).exists());
    let missing: Vec<&String> = files.iter().filter(|file| !is_there(file)).collect();
    assert!(missing.is_empty(), "{missing:#?}");
}

/// The paths that a path with `{a, b}` in it stands for.
fn with_braces(path: &str) -> Vec<String> {
    let Some((before, (names, after))) =
        path.split_once('{').and_then(|(before, rest)| Some((before, rest.split_once('}')?)))
    else {
        return vec![path.to_owned()];
    };
    names.split(',').flat_map(|name| with_braces(&format!("{before}{}{after}", name.trim()))).collect()
}

/// Each page of docs is a chapter, and the models of the guide are compiled.
#[test]
fn the_book_has_all_pages() {
    let documents = documents();
    let of_docs = |path: &Path| path.starts_with("docs") && !path.ends_with("SUMMARY.md");
    let pages: BTreeSet<&Path> =
        documents.iter().map(|page| page.path.as_path()).filter(|path| of_docs(path)).collect();
    let summary = documents.iter().find(|page| page.path.ends_with("SUMMARY.md")).unwrap();
    let chapters: Vec<_> =
        summary.links.iter().filter_map(|link| target(summary, link)).map(|(path, _)| path).collect();
    assert_eq!(chapters.iter().map(|path| path.as_path()).collect::<BTreeSet<_>>(), pages);
    assert_eq!(chapters.len(), pages.len());

    let compiled = std::fs::read_to_string(root().join("tests/guide/src/lib.rs")).unwrap();
    for page in documents.iter().filter(|page| page.path.starts_with("docs/guide") && page.text.contains("```rust")) {
        let path = page.path.to_str().unwrap().replace('\\', "/");
        assert!(compiled.contains(&format!("\"../../../{path}\"")), "{path} is not compiled");
    }
}

/// An example that a document tells to run has a source: a file, a folder with a main file, or one in a package of its own.
#[test]
fn examples_that_documents_run_are_there() {
    let places = |name: &str| {
        [
            format!("{name}.rs"),
            format!("{name}/main.rs"),
            format!("{name}/{name}.rs"),
            format!("{name}/examples/{name}/main.rs"),
        ]
    };
    let mut seen = 0;
    let mut missing = Vec::new();
    for document in documents() {
        for named in document.text.split("--example ").skip(1) {
            let name: String = named.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            // `--example <name>` stands for any
            if name.is_empty() {
                continue;
            }
            seen += 1;
            let is_there = |folder: &str| places(&name).iter().any(|place| root().join(folder).join(place).exists());
            if !["examples", "mstmm-drawing/examples", "lab/fuzz/examples"].into_iter().any(is_there) {
                missing.push(format!("{}: {name}", document.path.display()));
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
    assert!(seen > 1, "no document names an example");
}
