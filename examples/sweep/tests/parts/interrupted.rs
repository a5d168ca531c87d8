//! Whatever is killed, the same commands again end with the bytes of one run.

use crate::{bytes, folder, names, shard, starts, succeeds};
use std::path::Path;
use std::time::{Duration, Instant};
use std::{fs, thread};
use sweep::part;

/// So many that a shard takes a second or more.
const MODELS: u64 = if cfg!(debug_assertions) { 1 << 13 } else { 1 << 21 };

/// Waits until the temporary file of the first shard is there.
fn wait_for_temporary(folder: &Path) {
    let begin = Instant::now();
    while !names(folder).iter().any(|name| name.starts_with(".part-000000.")) {
        assert!(begin.elapsed() < Duration::from_secs(60), "nothing is written: {:?}", names(folder));
        thread::sleep(Duration::from_millis(1));
    }
}

#[test]
fn a_shard_that_was_killed_is_solved_by_the_same_command() {
    let (one_run, interrupted) = (folder(), folder());
    let (one_run, interrupted) = (one_run.path(), interrupted.path());
    for number in ["0/2", "1/2"] {
        succeeds(shard(MODELS, one_run, number));
    }

    let mut killed = starts(shard(MODELS, interrupted, "0/2"));
    wait_for_temporary(interrupted);
    killed.kill().unwrap();
    assert!(!killed.wait().unwrap().success(), "it had ended before");
    succeeds(shard(MODELS, interrupted, "1/2"));
    let left = names(interrupted);
    assert_eq!(left.len(), 2, "{left:?}");
    assert!(left[0].starts_with(".part-000000.") && left[1] == part::name(1), "{left:?}");

    let written = fs::metadata(interrupted.join(part::name(1))).unwrap().modified().unwrap();
    let first = succeeds(shard(MODELS, interrupted, "0/2"));
    assert!(first.starts_with(&format!("{0} of {0} models", MODELS / 2)), "{first}");
    let second = succeeds(shard(MODELS, interrupted, "1/2"));
    assert_eq!(second, format!("{} is there already\n", interrupted.join(part::name(1)).display()));
    assert_eq!(fs::metadata(interrupted.join(part::name(1))).unwrap().modified().unwrap(), written);
    for index in 0..2 {
        assert!(bytes(interrupted, index) == bytes(one_run, index), "part {index} differs");
    }
    assert_eq!(names(interrupted), [left[0].clone(), part::name(0), part::name(1)]);
}

/// As where a scheduler takes a machine for dead that is not.
#[test]
fn two_processes_with_one_shard_leave_one_part() {
    let (alone, both) = (folder(), folder());
    succeeds(shard(2048, alone.path(), "1/4"));
    let processes: Vec<_> = (0..2).map(|_| starts(shard(2048, both.path(), "1/4"))).collect();
    for mut process in processes {
        assert!(process.wait().unwrap().success());
    }
    assert_eq!(names(both.path()), [part::name(1)]);
    assert!(bytes(both.path(), 1) == bytes(alone.path(), 1));
}
