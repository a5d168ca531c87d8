//! The examples of the paper: solves all five systems with the paper's own search settings and compares.
//!
//! The one exception is the range of Table 2, which is printed too short to hold its last two roots.
//!
//! `cargo run --release --example paper` prints a table for each example, with `-- --json` one JSON object for each
//! value. The exit code is 0 if every printed root was found.

use std::process::ExitCode;

mod report;

use paper::{Example, Failure, Solved, examples, solve};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let show = match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        [] => report::table,
        ["--json"] => report::json_lines,
        _ => {
            eprintln!("usage: paper [--json]");
            return ExitCode::from(2);
        }
    };
    match run(show) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Solves and shows every example.
fn run(show: fn(&Example, &Solved) -> String) -> Result<ExitCode, Failure> {
    let mut code = ExitCode::SUCCESS;
    for example in examples()? {
        let solved = solve(&example)?;
        println!("{}", show(&example, &solved).trim_end());
        for sentence in report::missing(&example, &solved) {
            eprintln!("{sentence}");
            code = ExitCode::FAILURE;
        }
    }
    Ok(code)
}
