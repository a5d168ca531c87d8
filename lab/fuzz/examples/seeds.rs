//! Writes the models of the tests as first inputs of the target `text`, which hardly comes by a whole model itself.

#[path = "../../../mstmm-language/tests/support/written_models.rs"]
mod written_models;

use std::{fs, io};

fn main() -> io::Result<()> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/corpus/text");
    fs::create_dir_all(folder)?;
    for (number, model) in written_models::written_models().iter().enumerate() {
        fs::write(format!("{folder}/{number}"), model.to_string())?;
    }
    Ok(())
}
