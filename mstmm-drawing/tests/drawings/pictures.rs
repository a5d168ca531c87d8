//! The pictures of the documents are those that their command writes.

#[path = "../../examples/pictures.rs"]
pub(crate) mod command;

use std::path::Path;

#[test]
fn committed_pictures_are_what_the_command_writes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/pictures");
    for (name, picture) in command::pictures().unwrap() {
        let committed = std::fs::read_to_string(folder.join(format!("{name}.svg"))).unwrap();
        assert!(
            without_phase(&committed) == without_phase(&picture),
            "{name}: `cargo run --release -p mstmm-drawing --example pictures` writes another"
        );
    }
}

/// A picture without the phase by which its mode was turned: the sign that a shape was computed with follows from rounding.
fn without_phase(picture: &str) -> String {
    let Some((before, phase)) = picture.split_once(" data-phase=\"") else { return picture.to_owned() };
    let (_, after) = phase.split_once('"').unwrap();
    format!("{before}{after}")
}
