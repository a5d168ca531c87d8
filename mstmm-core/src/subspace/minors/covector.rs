//! Covectors: they pick a state out of a subspace, and are transferred against the direction of the pass.

use crate::model::{ScaledState, State};
use crate::number::{Scalar, Size};
use crate::subspace::minors::line::Line;
use crate::subspace::minors::plane::Plane;
use crate::subspace::minors::subspace::Subspace;
use mstmm_plan::{Coordinate, Freedoms, Space, Support};

/// Picks the state `z_i = Σ_j p_ij η_j` out of a plane with the minors `p_ij`, or `t l` out of a line.
///
/// Against the direction of the pass covectors go through elements and connections by products and sums alone. States would need
/// divisions, and decaying waves would lose their digits beside growing ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Covector<S> {
    /// Entries for Y, Θ, M, Q, and a power of two that multiplies all.
    Plane([S; 4], i32),
    /// The factor t of a line, and its power of two.
    Line(S, i32),
}

impl<S: Scalar> Covector<S> {
    /// The entries of a plane's covector; none of a line's, which has no plane.
    #[inline]
    pub(crate) fn entries(self) -> ([S; 4], i32) {
        match self {
            Covector::Plane(entries, exponent) => (entries, exponent),
            Covector::Line(_, exponent) => ([S::zero(); 4], exponent),
        }
    }

    /// The covector with entries near 1 and the rest in the exponent.
    #[inline]
    pub(crate) fn rescaled(self) -> Self {
        match self {
            Covector::Plane(entries, exponent) => {
                let [a, b, c, d] = [entries[0].size(), entries[1].size(), entries[2].size(), entries[3].size()];
                let shift = a.or_larger(b).or_larger(c.or_larger(d)).exponent().unwrap_or(0);
                Covector::Plane(entries.map(|entry| entry.times_power_of_two(-shift)), exponent.saturating_add(shift))
            }
            Covector::Line(t, exponent) => {
                let shift = t.size().exponent().unwrap_or(0);
                Covector::Line(t.times_power_of_two(-shift), exponent.saturating_add(shift))
            }
        }
    }

    /// The covector times `factor · 2^shift`.
    #[inline]
    pub(crate) fn times(self, factor: S, shift: i32) -> Self {
        match self {
            Covector::Plane(entries, exponent) => {
                Covector::Plane(entries.map(|entry| entry * factor), exponent.saturating_add(shift))
            }
            Covector::Line(t, exponent) => Covector::Line(t * factor, exponent.saturating_add(shift)),
        }
    }

    /// The covector of the same subspace seen against the x-axis (see [`Subspace::mirrored`]), and back again.
    #[inline]
    pub(crate) fn mirrored(self, space: Space) -> Self {
        match self {
            Covector::Plane([y, theta, m, q], exponent) => Covector::Plane([-y, theta, m, -q], exponent),
            Covector::Line(t, exponent) if space.is(Space::Rotation) => Covector::Line(-t, exponent),
            Covector::Line(..) => self,
        }
    }

    /// The state that the covector picks out of a subspace.
    #[inline]
    pub(crate) fn pick(self, subspace: &Subspace<S>) -> ScaledState<S> {
        let entry = |coordinate| self.pick_entry(subspace, coordinate);
        let ((y, exponent), (theta, _), (m, _), (q, _)) =
            (entry(Coordinate::Y), entry(Coordinate::Theta), entry(Coordinate::M), entry(Coordinate::Q));
        ScaledState { state: State { y, theta, m, q }, exponent }
    }

    /// One entry of that state, and the power of two that multiplies all.
    #[inline]
    pub(crate) fn pick_entry(self, subspace: &Subspace<S>, coordinate: Coordinate) -> (S, i32) {
        match (self, subspace) {
            (Covector::Plane(entries, exponent), Subspace::Tip(support, _)) => {
                (of_tip(entries, *support, coordinate), exponent)
            }
            (Covector::Plane(entries, exponent), _) => {
                let plane = subspace.plane();
                (of_plane(entries, &plane, coordinate), exponent.saturating_add(plane.exponent))
            }
            (Covector::Line(t, exponent), _) => {
                let Line { y, q, exponent: own } = subspace.line();
                let value = match (coordinate, subspace.space().is(Space::Rotation)) {
                    (Coordinate::Y, false) | (Coordinate::Theta, true) => y * t,
                    (Coordinate::Q, false) => q * t,
                    (Coordinate::M, true) => -(q * t),
                    _ => S::zero(),
                };
                (value, exponent.saturating_add(own))
            }
        }
    }

    /// The covector of one path at a connection, given that of the sum and the sum of all other paths:
    /// `η_k = s_YΘ η + Kᵀ (η_M, η_Q)` with the stiffness `K = [[-w, s_YM], [-s_ΘQ, w]]` of the others, times s_YΘ.
    #[inline]
    pub(crate) fn share_of(self, others: &Plane<S>) -> Self {
        let ([y, theta, m, q], exponent) = self.entries();
        let s = others;
        let entries = [
            s.y_theta * y - s.w * m - s.theta_q * q,
            s.y_theta * theta + s.y_m * m + s.w * q,
            s.y_theta * m,
            s.y_theta * q,
        ];
        Covector::Plane(entries, exponent.saturating_add(s.exponent)).rescaled()
    }
}

/// `z_i = Σ_j p_ij η_j`
#[inline]
fn of_plane<S: Scalar>([y, theta, m, q]: [S; 4], p: &Plane<S>, coordinate: Coordinate) -> S {
    match coordinate {
        Coordinate::Y => p.y_theta * theta + p.y_m * m + p.w * q,
        Coordinate::Theta => p.w * m + p.theta_q * q - p.y_theta * y,
        Coordinate::M => p.m_q * q - p.y_m * y - p.w * theta,
        Coordinate::Q => -(p.w * y + p.theta_q * theta + p.m_q * m),
        Coordinate::X | Coordinate::Qx => S::zero(),
    }
}

/// `z_i = Σ_j p_ij η_j` for the plane that a support leaves. The minor of its two unknowns is 1, so that each unknown is the
/// covector's entry for the other.
#[inline]
fn of_tip<S: Scalar>([y, theta, m, q]: [S; 4], support: Support, coordinate: Coordinate) -> S {
    let of_theta = if support.holds().contains(Freedoms::RZ) { m } else { theta };
    match (coordinate.freedom(), support.holds().contains(Freedoms::Y)) {
        _ if !support.leaves(coordinate) => S::zero(),
        // of both unknowns Y stands before that of Θ, and Q behind it
        (Freedoms::Y, false) => of_theta,
        (Freedoms::Y, true) => -of_theta,
        (Freedoms::RZ, false) => -y,
        (Freedoms::RZ, true) => q,
        _ => S::zero(),
    }
}

impl<S: Scalar> Subspace<S> {
    /// The subspace seen against the x-axis. It takes a downstream subspace from the frame of a path that leads downstream to that of
    /// a path that arrives from there, or back.
    #[inline]
    pub(crate) fn mirrored(self) -> Self {
        match self {
            Subspace::Plane(plane) => Subspace::Plane(Plane { w: -plane.w, ..plane }),
            Subspace::OnPin(plane) => Subspace::OnPin(Plane { w: -plane.w, ..plane }),
            Subspace::Tip(..) | Subspace::Grounded(..) | Subspace::Springs { .. } | Subspace::Line(..) => self,
        }
    }
}
