//! What is missing is what an array should do again.

use crate::{folder, refused, shard, succeeds, sweep};
use std::fs;
use std::path::Path;
use std::process::Command;
use sweep::check::array;
use sweep::part;

fn check(folder: &Path) -> Command {
    sweep(&["--check", folder.to_str().unwrap()])
}

#[test]
fn missing_shards_are_an_array() {
    let folder = folder();
    assert_eq!(
        refused(check(folder.path()), folder.path()),
        "sweep: FOLDER has no part yet, so that nobody can tell how many there should be\n"
    );
    for index in [0, 1, 2, 4, 5, 6, 10, 11] {
        succeeds(shard(3000, folder.path(), &format!("{index}/12")));
    }
    // what was killed is no part
    fs::write(folder.path().join(".part-000003.17.abc"), "half").unwrap();
    let output = check(folder.path()).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(String::from_utf8(output.stdout).unwrap(), "--array=3,7-9\n");

    for index in [3, 7, 8, 9] {
        succeeds(shard(3000, folder.path(), &format!("{index}/12")));
    }
    assert_eq!(succeeds(check(folder.path())), "");
}

#[test]
fn parts_of_two_sweeps_are_refused() {
    let (folder, other) = (folder(), folder());
    succeeds(shard(1000, folder.path(), "0/2"));
    succeeds(shard(1000, other.path(), "3/4"));
    fs::copy(other.path().join(part::name(3)), folder.path().join(part::name(3))).unwrap();
    assert_eq!(
        refused(check(folder.path()), folder.path()),
        "sweep: FOLDER/part-000003.parquet is of another sweep: shards is \"4\", not \"2\"\n"
    );
}

#[test]
fn runs_of_numbers_are_short() {
    assert_eq!(array(&[]), "");
    assert_eq!(array(&[4]), "4");
    assert_eq!(array(&[0, 1]), "0-1");
    assert_eq!(array(&[0, 2, 3, 4, 9, 11, 12]), "0,2-4,9,11-12");
}
