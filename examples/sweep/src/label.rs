//! What the metadata of a part say of it.

use crate::error::PartError;
use crate::model;
use crate::shard::Shard;
use parquet::file::metadata::KeyValue;
use parquet::file::reader::{FileReader, SerializedFileReader};
use std::fs::File;
use std::path::Path;

const MODELS: &str = "models";
const SHARDS: &str = "shards";

/// What tells the parts of one sweep from those of another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Number of models of the whole sweep.
    pub models: u64,
    /// Number of parts.
    pub shards: u64,
    /// Hash of the model, see [`model::hash`].
    pub model: u64,
    /// Version of the program.
    pub version: String,
}

impl Label {
    /// The label of the sweep of this program, over so many models in so many parts.
    pub fn new(models: u64, shards: u64) -> Self {
        Label { models, shards, model: model::hash(), version: env!("CARGO_PKG_VERSION").to_owned() }
    }

    fn of_sweep(&self) -> [(&'static str, String); 4] {
        [
            (MODELS, self.models.to_string()),
            (SHARDS, self.shards.to_string()),
            ("model", format!("{:016x}", self.model)),
            ("version", self.version.clone()),
        ]
    }

    fn of_shard(&self, shard: Shard) -> [(&'static str, String); 2] {
        let models = shard.models(self.models);
        [("shard", shard.index().to_string()), ("range", format!("{}..{}", models.start, models.end))]
    }

    /// The metadata of a part.
    pub(crate) fn metadata(&self, shard: Shard) -> Vec<KeyValue> {
        let entries = self.of_sweep().into_iter().chain(self.of_shard(shard));
        entries.map(|(key, value)| KeyValue::new(key.to_owned(), value)).collect()
    }

    /// Holds a file to be a part of this sweep, of that shard if one is given.
    ///
    /// # Errors
    /// It is of another sweep or shard, or cannot be read.
    pub(crate) fn check(&self, path: &Path, shard: Option<Shard>) -> Result<(), PartError> {
        let found = Found::of(path)?;
        let of_shard = shard.map(|shard| self.of_shard(shard));
        for (key, expected) in self.of_sweep().into_iter().chain(of_shard.into_iter().flatten()) {
            let found = found.value(key);
            if found != expected {
                return Err(PartError::OtherSweep { path: path.to_owned(), key, found, expected });
            }
        }
        Ok(())
    }

    /// The label of the sweep of this program that has as many models and parts as a file says.
    ///
    /// # Errors
    /// It says nothing of them, or cannot be read.
    pub(crate) fn sized_as(path: &Path) -> Result<Self, PartError> {
        let found = Found::of(path)?;
        let number = |key| {
            let found = found.value(key);
            found.parse().map_err(|_| PartError::BadLabel { path: path.to_owned(), key, found })
        };
        Ok(Label::new(number(MODELS)?, number(SHARDS)?))
    }
}

/// The metadata of a file.
struct Found(Vec<KeyValue>);

impl Found {
    fn of(path: &Path) -> Result<Self, PartError> {
        let file = File::open(path).map_err(|source| PartError::File { path: path.to_owned(), source })?;
        let reader = SerializedFileReader::new(file);
        let reader = reader.map_err(|source| PartError::Table { path: path.to_owned(), source })?;
        Ok(Found(reader.metadata().file_metadata().key_value_metadata().cloned().unwrap_or_default()))
    }

    /// The value of a key, empty where there is none.
    fn value(&self, key: &str) -> String {
        self.0.iter().find(|entry| entry.key == key).and_then(|entry| entry.value.clone()).unwrap_or_default()
    }
}
