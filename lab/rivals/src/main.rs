//! Runs every method on every scene and prints Markdown tables: `cargo run --release -p rivals`.
//!
//! With a path behind `--` the runs are written there as well, as JSON, or as CSV if it ends so.

use rivals::factors::factors;
use rivals::{Error, runs};
use std::fs::File;
use std::io::Write;

type Failure = Box<dyn core::error::Error>;

/// A time in µs, or a dash.
fn microseconds(seconds: Option<f64>) -> String {
    seconds.map_or("-".to_owned(), |seconds| format!("{:.1}", seconds * 1e6))
}

fn print(runs: &[rivals::Run]) {
    println!("| scene | method | knob | setting | time [µs] | evaluations | error |\n|---|---|---|---|---|---|---|");
    for run in runs {
        let rivals::Run { scene, method, knob, setting, evaluations, error, .. } = run;
        let time = run.seconds * 1e6;
        println!("| {scene} | {method} | {knob} | {setting} | {time:.1} | {evaluations} | {error:.1e} |");
    }
    println!(
        "\n| scene | method | certified [µs] | to 1e-6 [µs] | to 1e-12 [µs] | factor | of rounds | wins | C++ [µs] |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for factor in factors(runs) {
        println!(
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            factor.scene,
            factor.method,
            microseconds(factor.certified_seconds),
            microseconds(factor.seconds),
            microseconds(factor.seconds_to_all_digits),
            factor.factor.map_or("-".to_owned(), |factor| format!("{factor:.2}")),
            factor.spread.map_or("-".to_owned(), |[least, most]| format!("{least:.2} .. {most:.2}")),
            if factor.wins { "yes" } else { "" },
            microseconds(factor.cpp_seconds),
        );
    }
}

fn write(runs: &[rivals::Run], path: &str) -> Result<(), Failure> {
    let mut file = File::create(path)?;
    if path.ends_with(".csv") {
        runs::to_csv(runs, file)?
    } else {
        write!(file, "{}", runs::to_json(runs)?)?
    }
    Ok(())
}

fn main() -> Result<(), Failure> {
    let all: Result<_, Error> = runs::all(|label, done, total| eprint!("\r{done:4} of {total} {label:60}"));
    let runs = all?;
    eprintln!();
    print(&runs);
    std::env::args().nth(1).map_or(Ok(()), |path| write(&runs, &path))
}
