//! Shards of a sweep.

use crate::error::PartError;
use crate::solve::TASK;
use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// A shard of a sweep: one of so many, about equal ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Shard {
    /// The only shard of a sweep that is not divided.
    pub const WHOLE: Self = Shard { index: 0, count: 1 };

    /// Shard `index` of `count`, counted from zero, if there is one.
    pub fn new(index: u64, count: u64) -> Option<Self> {
        (index < count).then_some(Shard { index, count })
    }

    /// Its number, from zero.
    pub fn index(self) -> u64 {
        self.index
    }

    /// The number of shards.
    pub fn count(self) -> u64 {
        self.count
    }

    /// Its models, of a sweep of so many: whole tasks, in order. It has none where there are more shards than tasks.
    pub fn models(self, models: u64) -> Range<u64> {
        let tasks = u128::from(models.div_ceil(TASK));
        // no more than the number of tasks, which is a `u64`
        let from = |index: u64| (tasks * u128::from(index) / u128::from(self.count)) as u64;
        let start = |index: u64| from(index).saturating_mul(TASK).min(models);
        start(self.index)..start(self.index + 1)
    }

    /// The shard of a task of a Slurm array, whose tasks are all shards, from the variables of its environment.
    ///
    /// # Errors
    /// There is no such variable, it is not a number, or the array is a part of another one: it does not say how many shards there are.
    pub fn of_slurm(variable: impl Fn(&str) -> Option<String>) -> Result<Self, PartError> {
        let number = |name: &'static str| {
            let value = variable(name).ok_or(PartError::NoVariable { name })?;
            value.parse::<u64>().map_err(|_| PartError::BadVariable { name, value })
        };
        let (index, count) = (number("SLURM_ARRAY_TASK_ID")?, number("SLURM_ARRAY_TASK_COUNT")?);
        let last = number("SLURM_ARRAY_TASK_MAX")?;
        // as many tasks as there are numbers from 0 to the last
        let shard = Shard::new(index, count).filter(|_| last == count - 1);
        shard.ok_or(PartError::PartialArray { index, count, last })
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = PartError;

    fn from_str(text: &str) -> Result<Self, PartError> {
        let numbers = text.split_once('/').and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)));
        numbers.and_then(|(index, count)| Shard::new(index, count)).ok_or_else(|| PartError::BadShard(text.to_owned()))
    }
}
