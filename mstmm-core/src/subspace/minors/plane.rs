//! Planes of the bending state, each given by its 2×2 minors (Plücker coordinates).

use crate::model::state::Support;
use crate::number::scalar::Scalar;

/// A plane of the bending state, with a power of two of its own.
///
/// The minors `p_ab` of two states that span it; `w = p_YQ = p_ΘM`, since reciprocal elements keep it Lagrangian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<S> {
    /// p_YΘ
    pub y_theta: S,
    /// p_YM
    pub y_m: S,
    /// p_YQ = p_ΘM
    pub w: S,
    /// p_ΘQ
    pub theta_q: S,
    /// p_MQ
    pub m_q: S,
    /// Power of two that multiplies all.
    pub exponent: i32,
}

impl<S: Scalar> Plane<S> {
    /// The plane with minors `[p_YΘ, p_YM, w, p_ΘQ, p_MQ]`.
    #[inline(always)]
    pub fn new(minors: [S; 5], exponent: i32) -> Self {
        let size = (minors[0].size() + minors[1].size()) + (minors[3].size() + minors[4].size());
        let (minors, shift) = S::in_range(minors, size);
        Plane::unscaled(minors, exponent.saturating_add(shift))
    }

    /// The plane with given minors, not shifted into the range, for steps that cannot leave it.
    #[inline(always)]
    pub(crate) fn unscaled([y_theta, y_m, w, theta_q, m_q]: [S; 5], exponent: i32) -> Self {
        Plane { y_theta, y_m, w, theta_q, m_q, exponent }
    }

    /// The plane with its minors shifted into the middle of the range.
    #[inline(always)]
    pub(crate) fn in_range(self) -> Self {
        let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = self;
        Plane::new([y_theta, y_m, w, theta_q, m_q], exponent)
    }

    /// The plane that a support leaves.
    #[inline(always)]
    pub(crate) fn of_tip(support: Support) -> Self {
        let minors = match support {
            Support::Free => [1.0, 0.0, 0.0, 0.0, 0.0],
            Support::Guided => [0.0, 1.0, 0.0, 0.0, 0.0],
            Support::Pinned => [0.0, 0.0, 0.0, 1.0, 0.0],
            Support::Fixed => [0.0, 0.0, 0.0, 0.0, 1.0],
            // refused before: the roller is a support of planar states
            Support::Roller => [0.0; 5],
        };
        Plane::unscaled(minors.map(S::from_f64), 0)
    }

    /// The minor that vanishes where the plane meets the boundary condition of a support.
    #[inline(always)]
    pub(crate) fn minor_at(&self, support: Support) -> S {
        match support {
            Support::Fixed => self.y_theta,
            Support::Pinned => self.y_m,
            Support::Guided => self.theta_q,
            Support::Free => self.m_q,
            Support::Roller => S::zero(),
        }
    }
}
