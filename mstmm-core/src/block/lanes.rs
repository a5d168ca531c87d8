//! Subspaces and frequencies of all lanes, a column for each number.

use super::WIDTH;
use super::shapes::{Shape, numbers};
use crate::at::At;
use crate::scalar::{InColumns, Scalar, is_moderate};
use crate::state::{Space, Support};
use crate::subspace::{Plane, Subspace};

/// A subspace in each lane, all of one kind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lanes<S: InColumns> {
    pub(super) shape: Shape,
    pub(super) columns: [S::Columns<WIDTH>; 5],
    pub(super) exponents: [i32; WIDTH],
    /// Whether every lane is of that kind; an element of one's own may decide otherwise in each.
    pub(super) is_uniform: bool,
    /// Whether every lane is in the range in which nothing is shifted.
    pub(super) is_fit: bool,
}

impl<S: InColumns> Lanes<S> {
    /// Room for them.
    pub(super) fn new() -> Self {
        let shape = Shape::Tip(Support::Free, Space::Bending);
        let columns = [S::zero().columns(); 5];
        Lanes { shape, columns, exponents: [0; WIDTH], is_uniform: true, is_fit: true }
    }

    /// The same support in all lanes; it has no numbers.
    pub(super) fn become_tip(&mut self, support: Support, space: Space) {
        self.begin(Shape::Tip(support, space));
        self.exponents = [0; WIDTH];
    }

    /// Subspaces of a kind are going to be set.
    #[inline(always)]
    pub(super) fn begin(&mut self, shape: Shape) {
        (self.shape, self.is_uniform, self.is_fit) = (shape, true, true);
    }

    /// The subspace in a lane.
    pub(super) fn lane(&self, lane: usize) -> Subspace<S> {
        self.of_kind(self.shape, lane)
    }

    /// The same where the kind is known to the compiler.
    #[inline(always)]
    pub(super) fn of_kind(&self, shape: Shape, lane: usize) -> Subspace<S> {
        shape.subspace(|column| S::get(&self.columns[column], lane), self.exponents[lane])
    }

    /// The same over another scalar, without its exponent.
    #[inline(always)]
    pub(super) fn known<X: Scalar>(&self, shape: Shape, lane: usize, number: impl Fn(S) -> X) -> Subspace<X> {
        shape.subspace(|column| number(S::get(&self.columns[column], lane)), 0)
    }

    /// Sets the subspace in a lane.
    pub(super) fn set(&mut self, lane: usize, subspace: Subspace<S>) {
        self.is_uniform &= Shape::of(&subspace) == self.shape;
        self.is_fit &= is_fit(&subspace);
        let (entries, exponent) = numbers(subspace);
        for (column, entry) in self.columns.iter_mut().zip(entries) {
            entry.put(column, lane);
        }
        self.exponents[lane] = exponent;
    }
}

/// Whether a subspace is where straight-line code may take it up: all its numbers are numbers, and neither it nor what a join
/// makes of it would be shifted into another range.
#[inline(always)]
pub(super) fn is_fit<S: Scalar>(subspace: &Subspace<S>) -> bool {
    match subspace {
        Subspace::Tip(..) => true,
        Subspace::Grounded(k, _) => is_moderate(1.0 + k.size()),
        Subspace::Springs { y, theta } => {
            let size = |stiffness: &Option<S>| stiffness.map_or(0.0, Scalar::size);
            let (y, theta) = (size(y), size(theta));
            is_moderate((1.0 + y) + (theta + y * theta))
        }
        Subspace::Line(line, _) => is_moderate(line.y.size() + line.q.size()),
        Subspace::Plane(plane) | Subspace::OnPin(plane) => {
            let Plane { y_theta, y_m, w, theta_q, m_q, .. } = *plane;
            // the third minor is between the others, but for what is not a number
            is_moderate((y_theta.size() + y_m.size()) + (theta_q.size() + m_q.size())) & !w.size().is_nan()
        }
    }
}

/// The frequencies of a block with their powers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frequencies<S: InColumns> {
    x: S::Columns<WIDTH>,
    powers: [S::Columns<WIDTH>; 9],
}

impl<S: InColumns> Frequencies<S> {
    /// Room for them.
    pub(super) fn new() -> Self {
        Frequencies { x: S::zero().columns(), powers: [S::zero().columns(); 9] }
    }

    /// Sets the frequency in a lane, from another scalar.
    #[inline(always)]
    pub(super) fn set<X>(&mut self, lane: usize, at: At<X>, number: impl Fn(X) -> S) {
        let At { x, lambda_squared, powers: [s, s2, s3, s4], inverse_powers: [i, i2, i3, i4] } = at;
        number(x).put(&mut self.x, lane);
        for (column, power) in self.powers.iter_mut().zip([lambda_squared, s, s2, s3, s4, i, i2, i3, i4]) {
            number(power).put(column, lane);
        }
    }

    /// The frequency in a lane, over another scalar.
    #[inline(always)]
    pub(super) fn lane<X>(&self, lane: usize, number: impl Fn(S) -> X) -> At<X> {
        let power = |column: usize| number(S::get(&self.powers[column], lane));
        At {
            x: number(S::get(&self.x, lane)),
            lambda_squared: power(0),
            powers: [power(1), power(2), power(3), power(4)],
            inverse_powers: [power(5), power(6), power(7), power(8)],
        }
    }
}
