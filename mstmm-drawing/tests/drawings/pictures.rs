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
            committed == picture,
            "{name}: `cargo run --release -p mstmm-drawing --example pictures` writes another"
        );
    }
}
