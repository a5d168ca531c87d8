//! Prints the portal's figures here and in programs of finite elements, and writes them to `target/frames_beside.json`.
//!
//! `cargo run --release -p frames_beside`; with `-- --record` it replaces the figures of the repository, too.

use frames_beside::{Figures, measure};
use std::error::Error;
use std::path::Path;
use std::{env, fs};

/// The root of the repository.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Comments between which the table stands in the guide.
const MARKERS: [&str; 2] = ["<!-- portal -->\n", "<!-- end of portal -->"];

fn record(figures: &Figures, json: &str) -> Result<(), Box<dyn Error>> {
    fs::write(Path::new(ROOT).join("lab/frames_beside/recorded.json"), json)?;
    let page = Path::new(ROOT).join("docs/guide/finite_elements.md");
    let text = fs::read_to_string(&page)?;
    let [start, end] = MARKERS;
    let (before, rest) = text.split_once(start).ok_or("the page has no marker")?;
    let (_, after) = rest.split_once(end).ok_or("the page has no second marker")?;
    fs::write(page, format!("{before}{start}\n{}\n{}\n\n{end}{after}", figures.markdown(), figures.origin()))?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let options: Vec<String> = env::args().skip(1).collect();
    if options.iter().any(|option| option != "--record") {
        return Err("usage: frames_beside [--record]".into());
    }
    let (figures, missing) = measure()?;
    println!("{}", figures.markdown());
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
