//! What can go wrong with parts of a sweep.

use parquet::errors::ParquetError;
use std::io;
use std::path::PathBuf;

/// Why there is no part, or none that can be taken.
#[derive(Debug, thiserror::Error)]
pub enum PartError {
    /// A shard that is none.
    #[error("--shard is \"{0}\", but must be I/N with I from 0 to N - 1, or slurm")]
    BadShard(String),
    /// A variable that Slurm gives to each task of an array is not there.
    #[error("--shard slurm: there is no {name}; is this a task of an array, sbatch --array?")]
    NoVariable {
        /// Its name.
        name: &'static str,
    },
    /// A variable of Slurm is not a number.
    #[error("--shard slurm: {name} is \"{value}\", but must be a whole number")]
    BadVariable {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: String,
    },
    /// The tasks of an array are not all shards of a sweep.
    #[error(
        "--shard slurm: task {index} is one of {count}, the last of which is {last}, not {count} - 1: these may be some shards of more; \
         write --shard $SLURM_ARRAY_TASK_ID/N, with N for their number"
    )]
    PartialArray {
        /// The task.
        index: u64,
        /// Number of tasks.
        count: u64,
        /// The last task.
        last: u64,
    },
    /// There is no such folder.
    #[error("there is no folder {}; make it where all machines see it", .0.display())]
    NoFolder(PathBuf),
    /// A folder without any part.
    #[error("{} has no part yet, so that nobody can tell how many there should be", .0.display())]
    NoParts(PathBuf),
    /// A part of another sweep.
    #[error("{} is of another sweep: {key} is \"{found}\", not \"{expected}\"", .path.display())]
    OtherSweep {
        /// The part.
        path: PathBuf,
        /// What differs.
        key: &'static str,
        /// Its value there.
        found: String,
        /// Its value here.
        expected: String,
    },
    /// A part whose place among the parts cannot be.
    #[error("{}: {key} is \"{found}\", but must be a whole number", .path.display())]
    BadLabel {
        /// The part.
        path: PathBuf,
        /// What is no number.
        key: &'static str,
        /// Its value.
        found: String,
    },
    /// A file cannot be written or read.
    #[error("{}: {source}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A file is no table, or cannot become one.
    #[error("{}: {source}", .path.display())]
    Table {
        /// The file.
        path: PathBuf,
        /// Why.
        source: ParquetError,
    },
}
