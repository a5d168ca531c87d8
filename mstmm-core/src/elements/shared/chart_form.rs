//! The form of a member over some of its variables, and how it enters the chart.

use crate::number::{Scalar, Scaled};
use crate::subspace::Chart;

/// A matrix over `N` variables in units in which the member has neither stiffness nor length.
pub(crate) struct Form<S: Scalar, const N: usize> {
    pub(crate) entries: [[S; N]; N],
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

impl<S: Scalar> Factors<S> {
    pub(crate) fn new(stiffness: S, length: S) -> Self {
        let inverse = S::one() / length;
        Factors {
            stiffness: [S::one() / stiffness, S::one(), stiffness],
            lengths: [inverse * inverse, inverse, S::one(), length, length * length],
        }
    }

    /// The factor of an entry, given of both variables whether they are forces and whether they are rotations.
    fn of(&self, one: (bool, bool), other: (bool, bool)) -> S {
        let sign = |is_force: bool| if is_force { -1 } else { 1 };
        let power = |(is_force, is_rotation): (bool, bool)| if is_rotation { sign(is_force) } else { 0 };
        let stiffness = (sign(one.0) + sign(other.0)) / 2;
        self.stiffness[(1 + stiffness) as usize] * self.lengths[(2 + power(one) + power(other)) as usize]
    }
}

impl<S: Scalar, const N: usize> Form<S, N> {
    /// Enters the form into the chart of the member.
    pub(crate) fn enter(self, chart: &mut Chart<S>, places: [usize; N], rotations: [bool; N], factors: &Factors<S>) {
        let kind = |k: usize| (self.forces[k], rotations[k]);
        let shift = |k: usize| {
            let unit = chart.units.of(kind(k).1);
            if self.forces[k] { -unit } else { unit }
        };
        for row in 0..N {
            for column in row..N {
                let entry = self.entries[row][column] * factors.of(kind(row), kind(column));
                let entry = entry.times_power_of_two(shift(row) + shift(column));
                chart.entries[places[row]][places[column]] = entry;
                chart.entries[places[column]][places[row]] = entry;
            }
        }
        for (place, is_force) in places.into_iter().zip(self.forces) {
            chart.forces |= u32::from(is_force) << place;
        }
        chart.product = chart.product.product(self.product);
        chart.below = chart.below + self.below;
    }
}
