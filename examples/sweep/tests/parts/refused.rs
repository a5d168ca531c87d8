//! What cannot be right meets an error, with its name and value, and nothing is written.

use crate::{bytes, folder, names, refused, shard, succeeds, sweep};
use indicatif::ProgressBar;
use std::fs;
use std::path::Path;
use sweep::{Label, Shard, model, part, table};

#[test]
fn shards_that_are_none() {
    let folder = folder();
    for wrong in ["5/4", "4/4", "0/0", "-1/4", "1", "1/", "a/4", "1/4/2", "Slurm", ""] {
        let message = refused(shard(1000, folder.path(), wrong), folder.path());
        let expected = format!("sweep: --shard is \"{wrong}\", but must be I/N with I from 0 to N - 1, or slurm\n");
        assert_eq!(message, expected);
    }
    assert!(names(folder.path()).is_empty());
}

#[test]
fn command_lines() {
    let folder = folder();
    let path = folder.path().to_str().unwrap();
    let message = |arguments: &[&str]| refused(sweep(arguments), folder.path());
    assert_eq!(message(&["many"]), "sweep: MODELS is \"many\", but must be a whole number\n");
    assert_eq!(message(&["--shard", "0/2"]), "sweep: --shard 0/2 needs --out FOLDER for its part\n");
    assert_eq!(message(&["--shards", "0/2"]), "sweep: invalid option '--shards'\n");
    assert_eq!(message(&["--out"]), "sweep: missing argument for option '--out'\n");
    assert_eq!(message(&["1000", "2000"]), "sweep: unexpected argument \"2000\"\n");
    assert_eq!(
        message(&["1000", "--check", path]),
        "sweep: --check FOLDER stands alone: what there should be is written in the parts\n"
    );
    assert!(names(folder.path()).is_empty());
}

#[test]
fn folders_that_are_not_there() {
    let folder = folder();
    let inner = folder.path().join("inner");
    let expected = "sweep: there is no folder FOLDER/inner; make it where all machines see it\n";
    assert_eq!(refused(shard(1000, &inner, "0/2"), folder.path()), expected);
    assert_eq!(refused(sweep(&["--check", inner.to_str().unwrap()]), folder.path()), expected);
    assert!(names(folder.path()).is_empty());
}

/// Writes the first of two parts of a sweep with another label, which the program finds instead of its own.
fn write_other(folder: &Path, change: impl Fn(&mut Label)) {
    let mut label = Label::new(512, 2);
    change(&mut label);
    let (path, first) = (folder.join(part::name(0)), Shard::new(0, label.shards).unwrap());
    table::write(&path, &label, first, model::model, &ProgressBar::hidden()).unwrap();
}

/// Its own part, and the first one of others.
#[test]
fn parts_of_other_sweeps() {
    type Change = fn(&mut Label);
    let hash = format!("{:016x}", model::hash());
    let changes: [(Change, String); 4] = [
        (|label| label.models = 1024, "models is \"1024\", not \"512\"".to_owned()),
        (|label| label.shards = 3, "shards is \"3\", not \"2\"".to_owned()),
        (|label| label.model = 0xbad, format!("model is \"0000000000000bad\", not \"{hash}\"")),
        (
            |label| label.version = "0.0.7".to_owned(),
            format!("version is \"0.0.7\", not \"{}\"", env!("CARGO_PKG_VERSION")),
        ),
    ];
    for (change, difference) in changes {
        let folder = folder();
        write_other(folder.path(), change);
        let before = bytes(folder.path(), 0);
        for number in ["0/2", "1/2"] {
            let message = refused(shard(512, folder.path(), number), folder.path());
            assert_eq!(message, format!("sweep: FOLDER/part-000000.parquet is of another sweep: {difference}\n"));
        }
        assert_eq!(names(folder.path()), [part::name(0)]);
        assert!(bytes(folder.path(), 0) == before);
    }
}

#[test]
fn a_part_with_the_name_of_another() {
    let folder = folder();
    succeeds(shard(1000, folder.path(), "1/2"));
    fs::rename(folder.path().join(part::name(1)), folder.path().join(part::name(0))).unwrap();
    let expected = "sweep: FOLDER/part-000000.parquet is of another sweep: shard is \"1\", not \"0\"\n";
    assert_eq!(refused(shard(1000, folder.path(), "0/2"), folder.path()), expected);
    assert_eq!(refused(sweep(&["--check", folder.path().to_str().unwrap()]), folder.path()), expected);
}

#[test]
fn a_part_that_is_no_table() {
    let folder = folder();
    succeeds(shard(1000, folder.path(), "0/2"));
    let mut half = bytes(folder.path(), 0);
    half.truncate(half.len() / 2);
    fs::write(folder.path().join(part::name(0)), half).unwrap();
    for number in ["0/2", "1/2"] {
        let message = refused(shard(1000, folder.path(), number), folder.path());
        assert!(message.starts_with("sweep: FOLDER/part-000000.parquet: Parquet error: "), "{message}");
    }
}
