//! Storage of many numbers in columns.

use crate::number::scalar::Scalar;
use core::fmt;

/// A scalar of which many are stored in columns, one per real part, as the lanes of a block are.
pub trait InColumns: Scalar {
    /// Columns of `N` numbers.
    type Columns<const N: usize>: Copy + fmt::Debug;

    /// Columns with this number in every place.
    fn columns<const N: usize>(self) -> Self::Columns<N>;

    /// The number in a place.
    fn get<const N: usize>(columns: &Self::Columns<N>, place: usize) -> Self;

    /// Puts the number in a place.
    fn put<const N: usize>(self, columns: &mut Self::Columns<N>, place: usize);
}
