//! Prints the portal's figures here and in programs of finite elements, and writes them to `target/frames_beside.json`.
//!
//! `cargo run --release -p frames_beside`; with `-- --record` it replaces the figures of the repository, too.

use frames_beside::{Figures, measure};
use std::error::Error;
use std::path::Path;
use std::{env, fs};

/// The root of the repository.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Comments between which a table stands.
const MARKERS: [&str; 2] = ["<!-- portal -->\n", "<!-- end of portal -->"];

/// The text of a document with another table between its markers.
fn with_table(text: &str, table: &str) -> Result<String, Box<dyn Error>> {
    let [start, end] = MARKERS;
    let (before, rest) = text.split_once(start).ok_or("a document has no marker")?;
    let (_, after) = rest.split_once(end).ok_or("a document has no second marker")?;
    Ok(format!("{before}{start}\n{table}\n{end}{after}"))
}

fn record(figures: &Figures, json: &str) -> Result<(), Box<dyn Error>> {
    fs::write(Path::new(ROOT).join("lab/frames_beside/recorded.json"), json)?;
    for (document, table) in [("README.md", figures.summary()), ("docs/guide/finite_elements.md", figures.table())] {
        let path = Path::new(ROOT).join(document);
        fs::write(&path, with_table(&fs::read_to_string(&path)?, &table)?)?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let options: Vec<String> = env::args().skip(1).collect();
    if options.iter().any(|option| option != "--record") {
        return Err("usage: frames_beside [--record]".into());
    }
    let (figures, missing) = measure()?;
    println!("{}", figures.table());
    for program in &missing {
        println!("skipped: {}", program.0);
    }
    let json = serde_json::to_string_pretty(&figures)? + "\n";
    fs::create_dir_all(Path::new(ROOT).join("target"))?;
    fs::write(Path::new(ROOT).join("target/frames_beside.json"), &json)?;
    if !options.is_empty() {
        if !missing.is_empty() {
            return Err("nothing is recorded without all programs".into());
        }
        record(&figures, &json)?;
    }
    Ok(())
}
