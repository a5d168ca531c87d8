//! Lower triangles of symmetric matrices, row after row.

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
