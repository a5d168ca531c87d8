//! Numbers that stand in columns.

use crate::number::scalar::Scalar;
use core::fmt;

/// A number of which many stand in columns, each of its real parts in one of its own: what blocks are made of.
pub trait InColumns: Scalar {
    /// So many numbers.
    type Columns<const N: usize>: Copy + fmt::Debug;

    /// The same number everywhere.
    fn columns<const N: usize>(self) -> Self::Columns<N>;

    /// The number in a place.
    fn get<const N: usize>(columns: &Self::Columns<N>, place: usize) -> Self;

    /// Puts the number in a place.
    fn put<const N: usize>(self, columns: &mut Self::Columns<N>, place: usize);
}
