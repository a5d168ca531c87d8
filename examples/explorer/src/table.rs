//! Tables of numbers that the page reads in place.

use crate::problem::Problem;
use core::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};

/// Rows of numbers, one after the other. Its numbers are atomic so that a table may be a static without unsafe code: on WebAssembly
/// their loads and stores are plain ones, and in memory they are numbers of 64 bits.
#[derive(Debug)]
pub struct Table<const CAP: usize> {
    length: AtomicUsize,
    numbers: [AtomicU64; CAP],
}

impl<const CAP: usize> Table<CAP> {
    /// An empty table.
    pub const fn new() -> Self {
        Table { length: AtomicUsize::new(0), numbers: [const { AtomicU64::new(0) }; CAP] }
    }

    /// Forgets all rows.
    pub fn clear(&self) {
        self.length.store(0, Relaxed);
    }

    /// Adds a row.
    ///
    /// # Errors
    /// [`Problem::Full`] where the table has no room for it.
    pub fn push(&self, row: &[f64]) -> Result<(), Problem> {
        let length = self.length();
        let room = self.numbers.get(length..length + row.len()).ok_or(Problem::Full { capacity: CAP })?;
        for (place, number) in room.iter().zip(row) {
            place.store(number.to_bits(), Relaxed);
        }
        self.length.store(length + row.len(), Relaxed);
        Ok(())
    }

    /// How many numbers its rows have together.
    pub fn length(&self) -> usize {
        self.length.load(Relaxed)
    }

    /// The numbers, row after row.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.numbers.iter().take(self.length()).map(|number| f64::from_bits(number.load(Relaxed)))
    }

    /// Where the first number is.
    pub fn start(&self) -> *const f64 {
        self.numbers.as_ptr().cast()
    }
}

impl<const CAP: usize> Default for Table<CAP> {
    fn default() -> Self {
        Table::new()
    }
}
