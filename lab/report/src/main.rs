//! Error against run time, and what else there is to see, as a page.
//!
//! `cargo run --release --bin report` writes `target/report/report.html`, or the file whose path is given, with the runs
//! beside it as JSON and CSV. With `--readme` it also replaces the table of
//! `docs/speed.md` and the pictures of that page and of the README.

use indicatif::{ProgressBar, ProgressStyle};
use report::{Extent, Measurements, PICTURES};
use rivals::Run;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

type Failure = Box<dyn Error>;

/// The root of the repository.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// A bar on a terminal, nothing elsewhere.
fn bar() -> Result<ProgressBar, Failure> {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {msg}")?;
    Ok(ProgressBar::new(Measurements::STEPS).with_style(style))
}

fn measure() -> Result<(Vec<Run>, Measurements), Failure> {
    let bar = bar()?;
    let runs = rivals::runs::all(|label, done, total| {
        bar.set_length(total as u64 + Measurements::STEPS);
        bar.set_position(done as u64);
        bar.set_message(label.to_owned());
    })?;
    let measurements = Measurements::take(runs.clone(), &Extent::full(), |label| {
        bar.set_message(label);
        bar.inc(1);
    })?;
    bar.finish_and_clear();
    Ok((runs, measurements))
}

/// Writes the page and the runs beside it.
fn write(path: &Path, runs: &[Run], measurements: &Measurements) -> Result<(), Failure> {
    let folder = path.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(folder)?;
    fs::write(path, report::page(measurements)?)?;
    fs::write(folder.join("runs.json"), rivals::runs::to_json(runs)?)?;
    Ok(rivals::runs::to_csv(runs, fs::File::create(folder.join("runs.csv"))?)?)
}

fn write_readme(runs: &[Run], measurements: &Measurements) -> Result<(), Failure> {
    let (readme, folder) = (Path::new(ROOT).join(report::DOCUMENT), Path::new(ROOT).join("docs/pictures"));
    fs::create_dir_all(&folder)?;
    for (name, picture) in PICTURES.iter().zip(report::pictures(measurements)?) {
        fs::write(folder.join(name), picture)?;
    }
    let text = report::with_table(&fs::read_to_string(&readme)?, &report::markdown(runs))?;
    Ok(fs::write(readme, text)?)
}

fn main() -> Result<(), Failure> {
    let (options, paths): (Vec<String>, Vec<String>) = env::args().skip(1).partition(|text| text.starts_with('-'));
    if options.iter().any(|option| option != "--readme") || paths.len() > 1 {
        return Err("usage: report [--readme] [path of the page]".into());
    }
    let path = paths.first().map_or(PathBuf::from("target/report/report.html"), PathBuf::from);
    let (runs, measurements) = measure()?;
    write(&path, &runs, &measurements)?;
    if !options.is_empty() {
        write_readme(&runs, &measurements)?;
    }
    println!("{}", report::markdown(&runs));
    println!("The page is {}", path.display());
    Ok(())
}
