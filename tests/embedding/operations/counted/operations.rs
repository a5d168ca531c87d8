//! Numbers of operations.

use core::fmt;
use core::ops::{Add, Mul};

/// How many operations of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Operations {
    pub(crate) multiplications: usize,
    /// Subtractions as well.
    pub(crate) additions: usize,
    pub(crate) divisions: usize,
    pub(crate) square_roots: usize,
    pub(crate) sines: usize,
    pub(crate) cosines: usize,
    pub(crate) exponentials: usize,
}

const NONE: Operations = Operations {
    multiplications: 0,
    additions: 0,
    divisions: 0,
    square_roots: 0,
    sines: 0,
    cosines: 0,
    exponentials: 0,
};
pub(crate) const MUL: Operations = Operations { multiplications: 1, ..NONE };
pub(crate) const ADD: Operations = Operations { additions: 1, ..NONE };
pub(crate) const DIV: Operations = Operations { divisions: 1, ..NONE };
pub(crate) const SQRT: Operations = Operations { square_roots: 1, ..NONE };
pub(crate) const SIN: Operations = Operations { sines: 1, ..NONE };
pub(crate) const COS: Operations = Operations { cosines: 1, ..NONE };
pub(crate) const EXP: Operations = Operations { exponentials: 1, ..NONE };

impl Operations {
    /// In the order of the table's columns.
    fn columns(&self) -> [usize; 7] {
        let Operations { multiplications, additions, divisions, square_roots, sines, cosines, exponentials } = *self;
        [multiplications, additions, divisions, square_roots, sines, cosines, exponentials]
    }

    /// All together.
    pub(crate) fn total(&self) -> usize {
        self.columns().iter().sum()
    }

    /// Square roots, sines, cosines and exponentials alone.
    pub(crate) fn functions(self) -> Self {
        Operations { multiplications: 0, additions: 0, divisions: 0, ..self }
    }
}

impl Add for Operations {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Operations {
            multiplications: self.multiplications + other.multiplications,
            additions: self.additions + other.additions,
            divisions: self.divisions + other.divisions,
            square_roots: self.square_roots + other.square_roots,
            sines: self.sines + other.sines,
            cosines: self.cosines + other.cosines,
            exponentials: self.exponentials + other.exponentials,
        }
    }
}

impl Mul<Operations> for usize {
    type Output = Operations;
    fn mul(self, operations: Operations) -> Operations {
        (0..self).fold(NONE, |sum, _| sum + operations)
    }
}

/// Cells of a table: `| 3 | 2 | ..`.
impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.columns().iter().try_for_each(|number| write!(f, " {number} |"))
    }
}
