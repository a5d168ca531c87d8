//! Writes trees as models of `system!`.

use crate::support::tree::{Part, Tree};
use mstmm::element::Support;
use mstmm::list::ListStep;
use std::fmt::Write;

/// An element as the source of a model.
fn element(part: &Part, label: usize) -> String {
    // a body of lists has its inertia about the input end
    let word = |name: &&'static str| match (part, *name) {
        (Part::Body(_), "inertia") => "inertia_about_input",
        (_, name) => name,
    };
    let parameters: Vec<String> =
        part.named().iter().map(|(name, value)| format!("{}: {value:?}", word(name))).collect();
    format!("{} {label} {{ {} }}", part.keyword(), parameters.join(", "))
}

fn support(support: Support) -> String {
    format!("{support:?}").to_ascii_lowercase()
}

/// The paths of a tree; labels are the indices of the steps.
fn paths(tree: &Tree) -> String {
    let mut open: Vec<String> = Vec::new();
    let mut text = String::new();
    for (label, step) in tree.iter().enumerate() {
        match step {
            ListStep::Tip(tip) => open.push(support(*tip)),
            ListStep::Element(part) => {
                if let Some(path) = open.last_mut() {
                    let _ = write!(path, " -> {}", element(part, label));
                }
            }
            ListStep::Connection(inputs) => {
                for path in open.split_off(open.len() - inputs) {
                    let _ = writeln!(text, "    {path} -> conn {label};");
                }
                open.push(format!("conn {label}"));
            }
            ListStep::Root(root) => {
                let _ = writeln!(text, "    {} -> {};", open.concat(), support(*root));
            }
        }
    }
    text
}

/// A file of models of one kind, each named after the seed of its tree.
pub(crate) fn source(kind: &str, trees: &[(u64, Tree)]) -> String {
    let module = kind.to_ascii_lowercase();
    let mut text = String::from(
        "//! Random trees as models, named after their seeds; `macro_equals_list.rs` says how to write this file again.\n\n\
         use mstmm::prelude::*;\n",
    );
    for (seed, tree) in trees {
        let _ = write!(text, "\nsystem! {{\n    pub(crate) struct {kind}{seed};\n\n{}}}\n", paths(tree));
    }
    let _ = write!(
        text,
        "\n/// Calls a function with the seed and the system of each model.\nmacro_rules! for_each_{module} {{\n    ($check:ident) => {{\n",
    );
    for (seed, _) in trees {
        let _ = writeln!(text, "        $check({seed}, $crate::{module}_models::{kind}{seed}.build());");
    }
    let _ = write!(text, "    }};\n}}\npub(crate) use for_each_{module};\n");
    text
}
