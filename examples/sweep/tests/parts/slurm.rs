//! The shard of a task of a Slurm array.

use crate::{bytes, folder, names, refused, shard, succeeds};
use std::path::Path;
use std::process::Command;
use sweep::part;

/// The program as a task of an array: its own number, their number, the last.
fn task(folder: &Path, values: [&str; 3]) -> Command {
    let mut command = shard(1000, folder, "slurm");
    for (name, value) in ["ID", "COUNT", "MAX"].iter().zip(values) {
        command.env(format!("SLURM_ARRAY_TASK_{name}"), value);
    }
    command
}

#[test]
fn a_task_has_the_shard_of_its_number() {
    let (by_slurm, by_hand) = (folder(), folder());
    succeeds(task(by_slurm.path(), ["2", "3", "2"]));
    succeeds(shard(1000, by_hand.path(), "2/3"));
    assert_eq!(names(by_slurm.path()), [part::name(2)]);
    assert!(bytes(by_slurm.path(), 2) == bytes(by_hand.path(), 2));
}

#[test]
fn variables_that_are_missing_or_no_numbers() {
    let folder = folder();
    for name in ["ID", "COUNT", "MAX"] {
        let name = format!("SLURM_ARRAY_TASK_{name}");
        let mut without = task(folder.path(), ["2", "3", "2"]);
        without.env_remove(&name);
        assert_eq!(
            refused(without, folder.path()),
            format!("sweep: --shard slurm: there is no {name}; is this a task of an array, sbatch --array?\n")
        );
        let mut wrong = task(folder.path(), ["2", "3", "2"]);
        wrong.env(&name, "two");
        assert_eq!(
            refused(wrong, folder.path()),
            format!("sweep: --shard slurm: {name} is \"two\", but must be a whole number\n")
        );
    }
    assert!(names(folder.path()).is_empty());
}

/// What is left of an array, submitted again, has fewer tasks than the sweep has shards.
#[test]
fn a_part_of_an_array() {
    let folder = folder();
    for values in [["7", "4", "9"], ["1", "2", "2"], ["4", "3", "4"], ["0", "0", "0"]] {
        let [task_id, count, last] = values;
        assert_eq!(
            refused(task(folder.path(), values), folder.path()),
            format!(
                "sweep: --shard slurm: task {task_id} is one of {count}, the last of which is {last}, not {count} - 1: \
                 these may be some shards of more; write --shard $SLURM_ARRAY_TASK_ID/N, with N for their number\n"
            )
        );
    }
    assert!(names(folder.path()).is_empty());
}
