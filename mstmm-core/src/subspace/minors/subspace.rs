//! Subspaces of states that the boundary conditions upstream of a point allow there.
//!
//! A tip leaves half of the entries of a state free. Elements and connections map such a subspace to another of half the
//! dimension; at the root, Δ = 0 where it meets the root's boundary condition. A line of a two-entry state is given by
//! one of its vectors, a plane of the bending state by its 2×2 minors (Plücker coordinates).

use crate::number::Scalar;
use crate::subspace::minors::line::Line;
use crate::subspace::minors::plane::Plane;
use mstmm_plan::{Space, Support};

/// The subspace of states that the boundary conditions upstream of a point allow there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Subspace<S> {
    /// The boundary itself: half of the entries are zero.
    Tip(Support, Space),
    /// `q = -k y`, never scaled: a grounded spring, a free mass, or several of them at one point.
    Grounded(S, Space),
    /// `Q = -k_y Y` and `M = k_θ Θ` in a bending path, never scaled: a grounded hinge, a free point mass, or grounded springs
    /// at the free end of a beam. A spring that is missing is known to be zero when the code is compiled.
    Springs {
        /// Stiffness against deflection.
        y: Option<S>,
        /// Stiffness against rotation.
        theta: Option<S>,
    },
    /// A line of a translation or rotation path.
    Line(Line<S>, Space),
    /// A plane of a bending path.
    Plane(Plane<S>),
    /// A plane where a pin holds the point: only p_ΘQ and p_MQ are not zero.
    OnPin(Plane<S>),
}

impl<S: Scalar> Subspace<S> {
    /// The subspace of a translation or rotation path as a line.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn line(self) -> Line<S> {
        let (one, zero) = (S::one(), S::zero());
        match self {
            Subspace::Tip(support, space) if support.holds().contains(space) => Line { y: zero, q: one, exponent: 0 },
            Subspace::Grounded(k, _) => Line::new(one, -k, 0),
            Subspace::Line(line, _) => line,
            Subspace::Tip(..) | Subspace::Plane(_) | Subspace::OnPin(_) | Subspace::Springs { .. } => {
                Line { y: one, q: zero, exponent: 0 }
            }
        }
    }

    /// The subspace of a bending path as a plane; a line is joined to the free plane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn plane(self) -> Plane<S> {
        match self {
            Subspace::Plane(plane) | Subspace::OnPin(plane) => plane,
            Subspace::Tip(support, _) => Plane::of_tip(support),
            Subspace::Grounded(k, space) => Plane::of_tip(Support::Free).with_stiffness(k, space),
            Subspace::Springs { y, theta } => {
                let product = if let (Some(y), Some(theta)) = (y, theta) { y * theta } else { S::zero() };
                Plane::new([S::one(), theta.unwrap_or_default(), S::zero(), y.unwrap_or_default(), product], 0)
            }
            Subspace::Line(line, space) => Plane::of_tip(Support::Free).with_line(line, space),
        }
    }

    /// Space of the state in which this is a subspace.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn space(&self) -> Space {
        match self {
            Subspace::Tip(_, space) | Subspace::Grounded(_, space) | Subspace::Line(_, space) => *space,
            Subspace::Plane(_) | Subspace::OnPin(_) | Subspace::Springs { .. } => Space::Bending,
        }
    }
}
