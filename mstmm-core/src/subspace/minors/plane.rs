//! Planes of the bending state, each given by its 2×2 minors (Plücker coordinates).

use crate::number::Scalar;
use mstmm_plan::{Freedoms, Space, Support};

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

    /// The plane whose minors are a function of the freedoms that each takes the forces of; w belongs to none of them.
    #[inline(always)]
    fn by_forces(minor: impl Fn(Freedoms) -> S, w: S, exponent: i32) -> Self {
        let (neither, y, theta, both) = (Freedoms::NONE, Freedoms::Y, Freedoms::RZ, Space::Bending);
        Plane::unscaled([minor(neither), minor(theta), w, minor(y), minor(both)], exponent)
    }

    /// The minor of the forces of some freedoms and the displacements of the others.
    #[inline(always)]
    pub(crate) fn minor(&self, forces: Freedoms) -> S {
        match forces {
            Freedoms::NONE => self.y_theta,
            Freedoms::RZ => self.y_m,
            Freedoms::Y => self.theta_q,
            _ => self.m_q,
        }
    }

    /// The plane that a support leaves: the forces of what it holds and the displacements of the rest are arbitrary.
    #[inline(always)]
    pub(crate) fn of_tip(support: Support) -> Self {
        let held = support.holds().intersection(Space::Bending);
        Plane::by_forces(|forces| if forces.is(held) { S::one() } else { S::zero() }, S::zero(), 0)
    }

    /// The minor that vanishes where the plane meets the boundary condition of a support: of what is zero there.
    #[inline(always)]
    pub(crate) fn minor_at(&self, support: Support) -> S {
        self.minor(Space::Bending.without(support.holds()))
    }

    /// Holds the point by a support: joins the support's own plane, most of whose minors are zero.
    #[inline(always)]
    pub(crate) fn held(&self, support: Support) -> Self {
        let held = support.holds().intersection(Space::Bending);
        let minor = |forces: Freedoms| {
            if forces.contains(held) { self.minor(forces.without(held)) } else { S::zero() }
        };
        Plane::by_forces(minor, if held.is_empty() { self.w } else { S::zero() }, self.exponent)
    }
}
