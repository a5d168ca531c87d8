//! Shards have all models of a sweep, each once, and the same answers in any division.

use crate::{folder, rows_of, shard, succeeds};
use sweep::model::model;
use sweep::{Shard, part};

#[test]
fn shards_follow_each_other_and_are_about_equal() {
    for models in [0, 1, 255, 256, 257, 10_000, 123_456_789_012, u64::MAX] {
        for count in [1, 2, 3, 7, 100, 1001] {
            let shards = (0..count).map(|index| Shard::new(index, count).unwrap().models(models));
            let (mut end, mut sizes) = (0, Vec::new());
            for shard in shards {
                assert_eq!(shard.start, end);
                sizes.push(shard.end - shard.start);
                end = shard.end;
            }
            assert_eq!(end, models);
            // whole tasks of 256 models, but for the last one
            let (least, most) = (sizes.iter().min().unwrap(), sizes.iter().max().unwrap());
            assert!(most - least <= 512, "{models} in {count}: {least} to {most}");
        }
    }
    assert!(Shard::new(4, 4).is_none() && Shard::new(0, 0).is_none());
}

/// Oracle: parameters of each model by itself, in order; answers of the sweep that is not divided, to the last bit.
#[test]
fn rows_are_the_same_in_any_division() {
    const MODELS: u64 = 1700;
    let (whole, divided) = (folder(), folder());
    succeeds(shard(MODELS, whole.path(), "0/1"));
    for number in ["2/3", "0/3", "1/3"] {
        succeeds(shard(MODELS, divided.path(), number));
    }
    let whole = rows_of(&whole.path().join(part::name(0)));
    let divided: Vec<_> = (0..3).flat_map(|index| rows_of(&divided.path().join(part::name(index)))).collect();
    assert_eq!(whole.len() as u64, MODELS);
    assert!(whole == divided);
    for (row, index) in whole.iter().zip(0..) {
        for (field, parameter) in row.iter().zip(model(index).values()) {
            assert_eq!(*field, parquet::record::Field::Double(parameter), "{index}");
        }
    }
}
