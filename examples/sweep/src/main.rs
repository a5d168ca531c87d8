//! The command line of the sweep.

use indicatif::ProgressBar;
use lexopt::Arg::{Long, Short, Value};
use lexopt::{Parser, ValueExt};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;
use std::{env, fs};
use sweep::{Label, Shard, check, model, part, table};

const USAGE: &str = "\
Certified frequencies of many models, into Parquet files.

sweep [MODELS]                       all models, a million if not said otherwise, into target/sweep.parquet
sweep [MODELS] --out FOLDER          into FOLDER/part-000000.parquet, unless it is there
sweep [MODELS] --out FOLDER --shard I/N      shard I of N, from 0, into FOLDER/part-00000I.parquet
sweep [MODELS] --out FOLDER --shard slurm    the shard of a task of a Slurm array whose tasks are all shards
sweep --check FOLDER                 the shards without a part, as --array=3,7-9, with status 1; nothing and 0 if there are none";

/// The file of a sweep that is not divided.
const FILE: &str = "target/sweep.parquet";

/// What the program is asked to do.
enum Task {
    Help,
    Check(PathBuf),
    /// One file, as new.
    File {
        models: u64,
    },
    /// A part, unless it is there.
    Part {
        models: u64,
        folder: PathBuf,
        shard: Shard,
    },
}

impl Task {
    fn parse(mut parser: Parser) -> Result<Self, Box<dyn Error>> {
        let (mut models, mut folder, mut shard, mut checked) = (None, None, None, None);
        while let Some(argument) = parser.next()? {
            match argument {
                Short('h') | Long("help") => return Ok(Task::Help),
                Long("out") => folder = Some(PathBuf::from(parser.value()?)),
                Long("check") => checked = Some(PathBuf::from(parser.value()?)),
                Long("shard") => {
                    let text = parser.value()?.string()?;
                    let of_slurm = || Shard::of_slurm(|name| env::var(name).ok());
                    shard = Some(if text == "slurm" { of_slurm() } else { text.parse() }?);
                }
                Value(text) if models.is_none() => {
                    let text = text.string()?;
                    let number =
                        text.parse().map_err(|_| format!("MODELS is \"{text}\", but must be a whole number"))?;
                    models = Some(number);
                }
                other => return Err(other.unexpected().into()),
            }
        }
        let million = models.unwrap_or(1_000_000);
        match (checked, folder, shard, models) {
            (Some(folder), None, None, None) => Ok(Task::Check(folder)),
            (Some(_), ..) => Err("--check FOLDER stands alone: what there should be is written in the parts".into()),
            (None, Some(folder), shard, _) => {
                Ok(Task::Part { models: million, folder, shard: shard.unwrap_or(Shard::WHOLE) })
            }
            (None, None, Some(shard), _) => Err(format!("--shard {shard} needs --out FOLDER for its part").into()),
            (None, None, None, _) => Ok(Task::File { models: million }),
        }
    }

    fn run(self) -> Result<ExitCode, Box<dyn Error>> {
        match self {
            Task::Help => println!("{USAGE}"),
            Task::Check(folder) => {
                let missing = check::missing(&folder)?;
                if !missing.is_empty() {
                    println!("--array={}", check::array(&missing));
                    return Ok(ExitCode::FAILURE);
                }
            }
            Task::File { models } => {
                let path = Path::new(FILE);
                path.parent().map_or(Ok(()), fs::create_dir_all)?;
                solve(path, models, Shard::WHOLE)?;
            }
            Task::Part { models, folder, shard } => {
                match part::find(&folder, &Label::new(models, shard.count()), shard)? {
                    Some(part) => println!("{} is there already", part.display()),
                    None => solve(&folder.join(part::name(shard.index())), models, shard)?,
                }
            }
        }
        Ok(ExitCode::SUCCESS)
    }
}

/// Solves the models of a shard, into a file.
fn solve(path: &Path, models: u64, shard: Shard) -> Result<(), Box<dyn Error>> {
    let (begin, range) = (Instant::now(), shard.models(models));
    let count = range.end - range.start;
    // the bar is shown on a terminal alone
    let progress = ProgressBar::new(count);
    let errors = table::write(path, &Label::new(models, shard.count()), shard, model::model, &progress)?;
    let (seconds, cores) = (begin.elapsed().as_secs_f64(), rayon::current_num_threads());
    println!("{} of {count} models with three certified frequencies each, in {}", count - errors, path.display());
    println!("{seconds:.2} s, {:.0} models per second and core", count as f64 / seconds / cores as f64);
    Ok(())
}

fn main() -> ExitCode {
    Task::parse(Parser::from_env()).and_then(Task::run).unwrap_or_else(|error| {
        eprintln!("sweep: {error}");
        ExitCode::from(2)
    })
}
