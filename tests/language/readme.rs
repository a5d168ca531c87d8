//! What the README shows is what there is.

use mstmm::prelude::*;
use std::process::Command;

#[path = "../../examples/portal.rs"]
#[allow(dead_code, unreachable_pub, reason = "an example of its own")]
mod portal;

const README: &str = include_str!("../../README.md");

/// The first model is the example of that name.
#[test]
fn the_first_model() {
    let (_, program) = include_str!("../../examples/readme.rs").split_once("\n\n").unwrap();
    assert!(README.contains(&format!("```rust\n{program}```")), "{program}");
}

/// The frame of the picture is that of the example `portal`, and has the frequencies that stand beside it.
#[test]
fn the_frame_of_the_picture() {
    let source = include_str!("../../examples/portal.rs");
    let (_, after) = source.split_once("    fixed at (0.0, 0.0)").unwrap();
    let (paths, _) = after.split_once("}\n\n").unwrap();
    assert!(README.contains(&format!("    fixed at (0.0, 0.0){paths}")), "{paths}");
    let roots = portal::steel().build().unwrap().frequencies(5).unwrap();
    let printed: String = roots.iter().map(|root| format!("{:.4} Hz\n", root.hertz())).collect();
    assert!(README.contains(&format!("```text\n{printed}```")), "{printed}");
}

/// It prints what the README says.
#[test]
#[ignore = "long: .ci/long"]
fn what_the_first_model_prints() {
    let run = ["run", "--quiet", "--example", "readme"];
    let output = Command::new(env!("CARGO")).args(run).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    let printed = String::from_utf8(output.stdout).unwrap();
    assert!(README.contains(&format!("```text\n{printed}```")), "{printed}{}", String::from_utf8_lossy(&output.stderr));
}
