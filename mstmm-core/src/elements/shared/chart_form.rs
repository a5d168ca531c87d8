//! The form of a member over some of its variables, and how it enters the chart.

use crate::number::{Scalar, Scaled, power_of_two};
use crate::structure::Chart;

/// A matrix over `N` variables, by its lower triangle of `ENTRIES`, in units in which the member has neither stiffness nor length.
pub(crate) struct Form<S: Scalar, const N: usize, const ENTRIES: usize> {
    /// The triangle, row after row.
    pub(crate) entries: [S; ENTRIES],
    /// Whether each variable is a force.
    pub(crate) forces: [bool; N],
    pub(crate) product: Scaled<S>,
    pub(crate) below: S::Size,
}

/// The factors of entries: a row of a displacement has the root of the stiffness, that of a rotation also the length, and rows of
/// forces have the inverse.
pub(crate) struct Factors<S> {
    stiffness: [S; 3],
    lengths: [S; 5],
}

/// What a row has of the factors: the root of the stiffness or its inverse, a length or its inverse or none, and a power of two.
#[derive(Clone, Copy)]
struct OfRow {
    stiffness: i32,
    length: i32,
    power: f64,
}

impl<S: Scalar> Factors<S> {
    pub(crate) fn new(stiffness: S, length: S) -> Self {
        let inverse = S::one() / length;
        Factors {
            stiffness: [S::one() / stiffness, S::one(), stiffness],
            lengths: [inverse * inverse, inverse, S::one(), length, length * length],
        }
    }

    /// The entry of two rows with their factors.
    #[inline]
    fn times(&self, entry: S, one: OfRow, other: OfRow) -> S {
        let (stiffness, length) = ((one.stiffness + other.stiffness) / 2, one.length + other.length);
        let factor = self.stiffness[(1 + stiffness) as usize] * self.lengths[(2 + length) as usize];
        (entry * factor).scaled(one.power * other.power)
    }
}

impl<S: Scalar, const N: usize, const ENTRIES: usize> Form<S, N, ENTRIES> {
    /// Enters the form into the chart of the member, at places that ascend.
    #[inline]
    pub(crate) fn enter(self, chart: &mut Chart<S>, places: [usize; N], rotations: [bool; N], factors: &Factors<S>) {
        let mut rows = [OfRow { stiffness: 1, length: 0, power: 1.0 }; N];
        for (k, row) in rows.iter_mut().enumerate() {
            let sign = if self.forces[k] { -1 } else { 1 };
            *row = OfRow {
                stiffness: sign,
                length: if rotations[k] { sign } else { 0 },
                power: power_of_two(sign * chart.units.of(rotations[k])),
            };
            chart.forces |= u32::from(self.forces[k]) << places[k];
        }
        let mut entries = self.entries.into_iter();
        for (row, one) in rows.iter().enumerate() {
            for (column, (other, entry)) in rows[..=row].iter().zip(&mut entries).enumerate() {
                chart.set(places[row], places[column], factors.times(entry, *one, *other));
            }
        }
        chart.product = chart.product.product(self.product);
        chart.below = chart.below + self.below;
    }
}
