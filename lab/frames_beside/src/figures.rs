//! What was measured, and how it is shown.

use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// The first ten frequencies in hertz, as `exact.py` prints them.
pub const EXACT: [f64; 10] = [
    8.847_247_104_326_761,
    22.577_532_998_392_974,
    56.215_456_215_102_26,
    63.278_934_044_831_494,
    84.624_347_516_839_43,
    142.096_274_498_924_5,
    185.530_915_451_481_7,
    189.059_992_335_205_98,
    241.970_271_279_498_35,
    293.017_986_484_081_87,
];

/// Elements per member in the summary.
const SUMMARY_MESH: usize = 16;

/// One way to the ten frequencies.
#[derive(Clone, Debug, Deserialize, Serialize, PartialEq)]
pub struct Run {
    /// Elements for each member of the portal; one where members are exact.
    pub elements: usize,
    /// Time for one model and its ten frequencies, the least of some rounds, in seconds.
    pub seconds: f64,
    /// The ten frequencies, in hertz.
    pub hertz: Vec<f64>,
}

impl Run {
    /// The largest relative error of the ten frequencies.
    pub fn error(&self) -> f64 {
        self.hertz.iter().zip(EXACT).map(|(hertz, exact)| (hertz / exact - 1.0).abs()).fold(0.0, f64::max)
    }
}

/// The runs of a program.
#[derive(Clone, Debug, Deserialize, Serialize, PartialEq)]
pub struct Program {
    /// Its name.
    pub program: String,
    /// Its version.
    pub version: String,
    /// Day of the measurement, and the version of Python; none for this library.
    pub date: Option<String>,
    /// The version of Python that ran it.
    pub python: Option<String>,
    /// One per mesh, the coarsest first.
    pub runs: Vec<Run>,
}

/// The runs of all programs, of one machine and hour.
#[derive(Clone, Debug, Deserialize, Serialize, PartialEq)]
pub struct Figures {
    /// This library first.
    pub programs: Vec<Program>,
}

impl Figures {
    /// Those of the repository, `recorded.json`.
    ///
    /// # Errors
    /// Where the file is not as it should be.
    pub fn recorded() -> Result<Self, serde_json::Error> {
        serde_json::from_str(include_str!("../recorded.json"))
    }

    /// A table in Markdown, a row for each run, and its origin.
    pub fn table(&self) -> String {
        self.rows(|_| true)
    }

    /// The table without all meshes but one.
    pub fn summary(&self) -> String {
        self.rows(|run| [1, SUMMARY_MESH].contains(&run.elements))
    }

    fn rows(&self, is_shown: impl Fn(&Run) -> bool) -> String {
        let mut table =
            "| program | elements per member | time | largest relative error of ten |\n|---|---|---|---|\n".to_owned();
        for program in &self.programs {
            for run in program.runs.iter().filter(|run| is_shown(run)) {
                let (elements, time, error) = (run.elements, shown_time(run.seconds), run.error());
                let _ =
                    writeln!(table, "| {} {} | {elements} | {time} | {error:.0e} |", program.program, program.version);
            }
        }
        let _ = writeln!(table, "\n{}", self.origin());
        table
    }

    /// When and with what the figures were taken, in a sentence.
    pub fn origin(&self) -> String {
        let find =
            |part: fn(&Program) -> Option<&String>| self.programs.iter().find_map(part).map_or("?", String::as_str);
        format!(
            "Recorded on {} with Python {}.",
            find(|program| program.date.as_ref()),
            find(|program| program.python.as_ref())
        )
    }
}

/// A time with its unit, to three digits.
fn shown_time(seconds: f64) -> String {
    let (value, unit) = match seconds {
        ..1e-3 => (seconds * 1e6, "µs"),
        ..1.0 => (seconds * 1e3, "ms"),
        _ => (seconds, "s"),
    };
    let digits = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.digits$} {unit}")
}
