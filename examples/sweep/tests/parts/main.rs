//! Parts of a sweep, as several processes write them into one folder.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod check;
mod division;
mod interrupted;
mod refused;
mod slurm;
mod table;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use sweep::part;
use tempfile::TempDir;

/// An empty folder, which goes with the test.
fn folder() -> TempDir {
    tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap()
}

/// The program, outside of Slurm.
fn sweep(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sweep"));
    for name in ["ID", "COUNT", "MAX"] {
        command.env_remove(format!("SLURM_ARRAY_TASK_{name}"));
    }
    command.args(arguments);
    command
}

/// The program over so many models, for one shard.
fn shard(models: u64, folder: &Path, shard: &str) -> Command {
    sweep(&[&models.to_string(), "--out", folder.to_str().unwrap(), "--shard", shard])
}

/// A program that runs, silently.
fn starts(mut command: Command) -> Child {
    command.stdout(Stdio::null()).spawn().unwrap()
}

/// What a program prints that succeeds.
fn succeeds(mut command: Command) -> String {
    let Output { status, stdout, stderr } = command.output().unwrap();
    assert!(status.success(), "{command:?}: {}", String::from_utf8_lossy(&stderr));
    String::from_utf8(stdout).unwrap()
}

/// The message of a program that is refused, without the path of a folder.
fn refused(mut command: Command, folder: &Path) -> String {
    let Output { status, stdout, stderr } = command.output().unwrap();
    assert_eq!(status.code(), Some(2), "{command:?}: {}", String::from_utf8_lossy(&stdout));
    String::from_utf8(stderr).unwrap().replace(folder.to_str().unwrap(), "FOLDER")
}

/// The bytes of a part.
fn bytes(folder: &Path, index: u64) -> Vec<u8> {
    fs::read(folder.join(part::name(index))).unwrap()
}

/// Names in a folder, in order.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// The rows of a file, each with its columns.
fn rows_of(file: &Path) -> Vec<Vec<Field>> {
    let reader = SerializedFileReader::new(File::open(file).unwrap()).unwrap();
    let rows = reader.get_row_iter(None).unwrap().map(Result::unwrap);
    rows.map(|row| row.into_columns().into_iter().map(|(_, field)| field).collect()).collect()
}
