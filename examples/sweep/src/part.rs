//! Parts of a sweep: a folder has one file for each shard.

use crate::error::PartError;
use crate::label::Label;
use crate::shard::Shard;
use std::fs;
use std::path::{Path, PathBuf};

/// The name of the part of a shard.
pub fn name(index: u64) -> String {
    format!("part-{index:06}.parquet")
}

/// The part of a shard that is there already, if it is; without it a new one may join the parts of the folder.
///
/// # Errors
/// There is no folder, or it has a part of another sweep.
pub fn find(folder: &Path, label: &Label, shard: Shard) -> Result<Option<PathBuf>, PartError> {
    let (parts, own) = (all(folder)?, folder.join(name(shard.index())));
    if parts.contains(&own) {
        return label.check(&own, Some(shard)).map(|()| Some(own));
    }
    // one of the others is enough: it met another before
    parts.first().map_or(Ok(()), |part| label.check(part, None)).map(|()| None)
}

/// The parts of a folder, in order.
///
/// # Errors
/// There is no folder, or it cannot be read.
pub(crate) fn all(folder: &Path) -> Result<Vec<PathBuf>, PartError> {
    if !folder.is_dir() {
        return Err(PartError::NoFolder(folder.to_owned()));
    }
    let entries = fs::read_dir(folder).and_then(|entries| entries.collect::<Result<Vec<_>, _>>());
    let entries = entries.map_err(|source| PartError::File { path: folder.to_owned(), source })?;
    let names = entries.iter().filter_map(|entry| entry.file_name().into_string().ok());
    let parts = names.filter(|name| name.starts_with("part-") && name.ends_with(".parquet"));
    let mut parts: Vec<_> = parts.map(|name| folder.join(name)).collect();
    parts.sort();
    Ok(parts)
}
