//! A sweep: the first frequencies of many models, on all cores of one machine or in shards on many, into Parquet files.

pub mod check;
mod error;
mod label;
pub mod model;
pub mod part;
mod shard;
mod solve;
pub mod table;
mod whole_file;

pub use error::PartError;
pub use label::Label;
pub use shard::Shard;
pub use solve::{Row, rows};
