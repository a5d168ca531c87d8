//! Lower triangles of symmetric matrices, row after row.

use crate::number::{Scalar, Size};

/// Where a row begins.
#[inline(always)]
pub(crate) const fn row(row: usize) -> usize {
    row * (row + 1) / 2
}

/// Where an entry stands, or its mirror image.
#[inline(always)]
pub(crate) const fn place(row_of: usize, column: usize) -> usize {
    if column <= row_of { row(row_of) + column } else { row(column) + row_of }
}

/// The size of the largest of some entries; those that are not numbers do not count.
#[inline(always)]
pub(crate) fn largest<S: Scalar>(entries: &[S]) -> f64 {
    let mut largest = 0.0;
    for entry in entries {
        let size = entry.size().first();
        largest = if size > largest { size } else { largest };
    }
    largest
}
