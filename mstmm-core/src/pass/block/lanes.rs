//! The subspaces of all lanes, a column for each number.

use crate::number::{InColumns, Scalar, is_moderate};
use crate::pass::block::WIDTH;
use crate::pass::block::kinds::{Kind, numbers};
use crate::subspace::{Plane, Subspace};
use mstmm_plan::{Space, Support};

/// A subspace in each lane, all of one kind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lanes<S: InColumns> {
    pub(crate) kind: Kind,
    pub(crate) columns: [S::Columns<WIDTH>; 5],
    pub(crate) exponents: [i32; WIDTH],
    /// Whether every lane is of that kind; the step of a user-defined element may return several.
    pub(crate) is_uniform: bool,
    /// Whether every lane is in the range in which nothing is shifted.
    pub(crate) is_fit: bool,
}

impl<S: InColumns> Lanes<S> {
    /// Free tips.
    pub(crate) fn new() -> Self {
        let kind = Kind::Tip(Support::Free, Space::Bending);
        let columns = [S::zero().columns(); 5];
        Lanes { kind, columns, exponents: [0; WIDTH], is_uniform: true, is_fit: true }
    }

    /// Sets a support in all lanes; it has no numbers.
    pub(crate) fn become_tip(&mut self, support: Support, space: Space) {
        self.begin(Kind::Tip(support, space));
        self.exponents = [0; WIDTH];
    }

    /// Begins to set subspaces of a kind.
    #[inline(always)]
    pub(crate) fn begin(&mut self, kind: Kind) {
        (self.kind, self.is_uniform, self.is_fit) = (kind, true, true);
    }

    /// The subspace in a lane.
    pub(crate) fn lane(&self, lane: usize) -> Subspace<S> {
        self.of_kind(self.kind, lane)
    }

    /// The subspace in a lane, of a kind that the compiler knows.
    #[inline(always)]
    pub(crate) fn of_kind(&self, kind: Kind, lane: usize) -> Subspace<S> {
        kind.subspace(|column| S::get(&self.columns[column], lane), self.exponents[lane])
    }

    /// The subspace in a lane over another scalar, without its exponent.
    #[inline(always)]
    pub(crate) fn known<X: Scalar>(&self, kind: Kind, lane: usize, number: impl Fn(S) -> X) -> Subspace<X> {
        kind.subspace(|column| number(S::get(&self.columns[column], lane)), 0)
    }

    /// The subspaces seen from the other side, as [`Subspace::mirrored`].
    pub(crate) fn mirror(&mut self) {
        if let Kind::Plane | Kind::OnPin = self.kind {
            let w = &mut self.columns[2];
            for lane in 0..WIDTH {
                (-S::get(w, lane)).put(w, lane);
            }
        }
    }

    /// Sets the subspace in a lane.
    pub(crate) fn set(&mut self, lane: usize, subspace: Subspace<S>) {
        self.is_uniform &= Kind::of(&subspace) == self.kind;
        self.is_fit &= is_fit(&subspace);
        let (entries, exponent) = numbers(subspace);
        for (column, entry) in self.columns.iter_mut().zip(entries) {
            entry.put(column, lane);
        }
        self.exponents[lane] = exponent;
    }
}

/// Whether a subspace suits branch-free code: none of its numbers is NaN, and neither it nor its joins would be shifted into
/// another range.
#[inline(always)]
pub(crate) fn is_fit<S: Scalar>(subspace: &Subspace<S>) -> bool {
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
            // the third minor is between the others in size, unless it is NaN
            is_moderate((y_theta.size() + y_m.size()) + (theta_q.size() + m_q.size())) & !w.size().is_nan()
        }
    }
}
