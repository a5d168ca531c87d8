//! What the README shows is what there is.

use std::process::Command;

const README: &str = include_str!("../../README.md");

/// The first model is the example of that name.
#[test]
fn the_first_model() {
    let (_, program) = include_str!("../../examples/readme.rs").split_once("\n\n").unwrap();
    assert!(README.contains(&format!("```rust\n{program}```")), "{program}");
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
