//! What a folder of parts lacks.

use crate::error::PartError;
use crate::label::Label;
use crate::part;
use crate::shard::Shard;
use std::path::Path;

/// Numbers of the shards without a part, in order. How many there should be is what the first part says.
///
/// # Errors
/// There is no folder, it has no part, or one of another sweep.
pub fn missing(folder: &Path) -> Result<Vec<u64>, PartError> {
    let parts = part::all(folder)?;
    let label = Label::sized_as(parts.first().ok_or_else(|| PartError::NoParts(folder.to_owned()))?)?;
    // what is no part of any shard is one of another sweep, too
    parts.iter().try_for_each(|part| label.check(part, None))?;
    let mut missing = Vec::new();
    for shard in (0..label.shards).filter_map(|index| Shard::new(index, label.shards)) {
        let path = folder.join(part::name(shard.index()));
        if parts.binary_search(&path).is_ok() {
            label.check(&path, Some(shard))?;
        } else {
            missing.push(shard.index());
        }
    }
    Ok(missing)
}

/// Numbers in order as schedulers take those of an array: `3,7-9`.
pub fn array(numbers: &[u64]) -> String {
    let runs = numbers.chunk_by(|one, next| one + 1 == *next);
    let runs = runs.filter_map(|run| match run {
        [] => None,
        [one] => Some(one.to_string()),
        [first, .., last] => Some(format!("{first}-{last}")),
    });
    runs.collect::<Vec<_>>().join(",")
}
