//! Kinds of subspaces, known to the compiler in branch-free loops over lanes.

use crate::number::Scalar;
use crate::subspace::{Line, Plane, Subspace};
use mstmm_plan::{Space, Support};

/// The kind of the subspaces in all lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Tip(Support, Space),
    Grounded(Space),
    Springs { y: bool, theta: bool },
    Line(Space),
    Plane,
    OnPin,
}

impl Kind {
    pub(crate) fn of<S>(subspace: &Subspace<S>) -> Self {
        match subspace {
            Subspace::Tip(support, space) => Kind::Tip(*support, *space),
            Subspace::Grounded(_, space) => Kind::Grounded(*space),
            Subspace::Springs { y, theta } => Kind::Springs { y: y.is_some(), theta: theta.is_some() },
            Subspace::Line(_, space) => Kind::Line(*space),
            Subspace::Plane(_) => Kind::Plane,
            Subspace::OnPin(_) => Kind::OnPin,
        }
    }

    /// Number of columns for its numbers.
    #[inline(always)]
    pub(crate) fn columns(self) -> usize {
        match self {
            Kind::Tip(..) => 0,
            Kind::Grounded(_) => 1,
            Kind::Springs { .. } | Kind::Line(_) => 2,
            Kind::Plane | Kind::OnPin => 5,
        }
    }

    /// Space of the state.
    pub(crate) fn space(self) -> Space {
        match self {
            Kind::Tip(_, space) | Kind::Grounded(space) | Kind::Line(space) => space,
            Kind::Springs { .. } | Kind::Plane | Kind::OnPin => Space::Bending,
        }
    }

    /// The subspace of this kind with given numbers.
    #[inline(always)]
    pub(crate) fn subspace<S: Scalar>(self, numbers: impl Fn(usize) -> S, exponent: i32) -> Subspace<S> {
        let plane = || Plane::unscaled([numbers(0), numbers(1), numbers(2), numbers(3), numbers(4)], exponent);
        match self {
            Kind::Tip(support, space) => Subspace::Tip(support, space),
            Kind::Grounded(space) => Subspace::Grounded(numbers(0), space),
            Kind::Springs { y, theta } => {
                Subspace::Springs { y: y.then(|| numbers(0)), theta: theta.then(|| numbers(1)) }
            }
            Kind::Line(space) => Subspace::Line(Line { y: numbers(0), q: numbers(1), exponent }, space),
            Kind::Plane => Subspace::Plane(plane()),
            Kind::OnPin => Subspace::OnPin(plane()),
        }
    }
}

/// The numbers of a subspace, with zeros behind them, and its exponent.
#[inline(always)]
pub(crate) fn numbers<S: Scalar>(subspace: Subspace<S>) -> ([S; 5], i32) {
    let zero = S::zero();
    match subspace {
        Subspace::Tip(..) => ([zero; 5], 0),
        Subspace::Grounded(k, _) => ([k, zero, zero, zero, zero], 0),
        Subspace::Springs { y, theta } => ([y.unwrap_or_default(), theta.unwrap_or_default(), zero, zero, zero], 0),
        Subspace::Line(Line { y, q, exponent }, _) => ([y, q, zero, zero, zero], exponent),
        Subspace::Plane(plane) | Subspace::OnPin(plane) => {
            ([plane.y_theta, plane.y_m, plane.w, plane.theta_q, plane.m_q], plane.exponent)
        }
    }
}
