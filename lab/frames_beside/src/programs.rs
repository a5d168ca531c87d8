//! The programs that are measured.

use crate::figures::{Figures, Program, Run};
use crate::portal::hertz;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// The variable that names the interpreter, `python3` if it is not set.
pub const PYTHON: &str = "PYTHON";

/// Scripts of the programs.
const SCRIPTS: [&str; 2] = ["portal_opensees", "portal_pynite"];

/// Elements per member.
const MESHES: [&str; 4] = ["4", "16", "64", "128"];

/// Rounds of this library's measurement.
const ROUNDS: usize = 400;

/// What `measure.py` ends with where a program is not there.
const NOT_THERE: i32 = 3;

/// Why a measurement failed.
#[derive(Debug, thiserror::Error)]
pub enum BesideError {
    /// The portal has no frequencies here.
    #[error("the portal: {0}")]
    Here(#[from] Box<dyn std::error::Error>),
    /// A script failed.
    #[error("measure.py {script}: {message}")]
    Script {
        /// Its name.
        script: &'static str,
        /// What it wrote.
        message: String,
    },
    /// A script wrote something else than runs.
    #[error("what measure.py wrote: {0}")]
    Output(#[from] serde_json::Error),
}

/// A program that is not on this machine, with what it would take.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing(pub String);

/// The runs of this library.
///
/// # Errors
/// [`BesideError::Here`].
pub fn here() -> Result<Program, BesideError> {
    let mut seconds = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        std::hint::black_box(hertz()?);
        seconds = seconds.min(start.elapsed().as_secs_f64());
    }
    let run = Run { elements: 1, seconds, hertz: hertz()? };
    let version = env!("CARGO_PKG_VERSION").to_owned();
    Ok(Program { program: "mstmm".to_owned(), version, date: None, python: None, runs: vec![run] })
}

/// The runs of a script, or what is missing for it.
fn elsewhere(script: &'static str) -> Result<Result<Program, Missing>, BesideError> {
    let python = std::env::var(PYTHON).unwrap_or("python3".to_owned());
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("measure.py");
    let output = match Command::new(&python).arg(file).arg(script).args(MESHES).output() {
        Ok(output) => output,
        Err(error) => return Ok(Err(Missing(format!("{python}: {error}")))),
    };
    let message = || String::from_utf8_lossy(&output.stderr).trim().to_owned();
    match output.status.code() {
        Some(0) => Ok(Ok(serde_json::from_slice(&output.stdout)?)),
        Some(NOT_THERE) => Ok(Err(Missing(message()))),
        _ => Err(BesideError::Script { script, message: message() }),
    }
}

/// All runs of this machine, and what it has not.
///
/// # Errors
/// [`BesideError`].
pub fn measure() -> Result<(Figures, Vec<Missing>), BesideError> {
    let (mut programs, mut missing) = (vec![here()?], Vec::new());
    for script in SCRIPTS {
        match elsewhere(script)? {
            Ok(program) => programs.push(program),
            Err(program) => missing.push(program),
        }
    }
    Ok((Figures { programs }, missing))
}
