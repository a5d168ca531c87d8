//! Covectors: they pick a state out of a subspace, and go against the transfer direction where states may not.

use crate::scalar::Scalar;
use crate::scaled::binary_exponent;
use crate::state::{Coordinate, Space, State, Support};
use crate::subspace::{Line, Plane, Subspace};

/// Picks the state `z_i = Σ_j p_ij η_j` out of a plane with the minors `p_ij`, or `t l` out of a line.
///
/// Against the transfer direction covectors go through elements and connections by products and sums alone, while states
/// would have to be divided out of them, and would lose what decays beside what grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Covector<S> {
    /// Entries for Y, Θ, M, Q, and a power of two that multiplies all.
    Plane([S; 4], i32),
    /// The factor t of a line, and its power of two.
    Line(S, i32),
}

/// A state with a power of two of its own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScaledState<S> {
    pub(crate) state: State<S>,
    pub(crate) exponent: i32,
}

impl<S: Scalar> ScaledState<S> {
    pub(crate) fn zero() -> Self {
        ScaledState { state: State::default(), exponent: 0 }
    }

    /// Exponent of its largest entry, of whatever unit; `None` for a state of zeros.
    pub(crate) fn magnitude(&self) -> Option<i32> {
        let size = self.state.size();
        (size > 0.0).then(|| binary_exponent(size).saturating_add(self.exponent))
    }

    /// The plain state times `2^shift`.
    pub(crate) fn shifted(&self, shift: i32) -> State<S> {
        self.state.map(|entry| entry.times_power_of_two(self.exponent.saturating_add(shift)))
    }

    /// The state seen against the x-axis: slope and shear force change their signs.
    pub(crate) fn backwards(self) -> Self {
        ScaledState { state: self.state.backwards(), ..self }
    }
}

impl<S: Scalar> State<S> {
    /// Each entry through one function.
    pub(crate) fn map<R>(self, f: impl Fn(S) -> R) -> State<R> {
        State { y: f(self.y), theta: f(self.theta), m: f(self.m), q: f(self.q) }
    }

    /// Seen against the x-axis: slope and shear force change their signs.
    pub(crate) fn backwards(self) -> Self {
        State { theta: -self.theta, q: -self.q, ..self }
    }

    /// Size of the largest entry, of whatever unit.
    pub(crate) fn size(&self) -> f64 {
        self.y.size().max(self.theta.size()).max(self.m.size()).max(self.q.size())
    }

    /// The state plus another times a factor.
    pub(crate) fn plus(self, other: State<S>, factor: S) -> Self {
        State {
            y: self.y + other.y * factor,
            theta: self.theta + other.theta * factor,
            m: self.m + other.m * factor,
            q: self.q + other.q * factor,
        }
    }

    /// An entry; X and Qx are those of planar states, and zero here.
    pub(crate) fn entry(&self, coordinate: Coordinate) -> S {
        match coordinate {
            Coordinate::Y => self.y,
            Coordinate::Theta => self.theta,
            Coordinate::M => self.m,
            Coordinate::Q => self.q,
            Coordinate::X | Coordinate::Qx => S::zero(),
        }
    }
}

impl<S: Scalar> Covector<S> {
    /// The entries of a plane's covector; none of a line's, which has no plane.
    pub(crate) fn entries(self) -> ([S; 4], i32) {
        match self {
            Covector::Plane(entries, exponent) => (entries, exponent),
            Covector::Line(_, exponent) => ([S::zero(); 4], exponent),
        }
    }

    /// The same with entries near 1 and the rest in the exponent.
    pub(crate) fn moderated(self) -> Self {
        match self {
            Covector::Plane(entries, exponent) => {
                let size = entries.iter().fold(0.0_f64, |size, entry| size.max(entry.size()));
                let shift = binary_exponent(size);
                Covector::Plane(entries.map(|entry| entry.times_power_of_two(-shift)), exponent.saturating_add(shift))
            }
            Covector::Line(t, exponent) => {
                let shift = binary_exponent(t.size());
                Covector::Line(t.times_power_of_two(-shift), exponent.saturating_add(shift))
            }
        }
    }

    /// The same times a number.
    pub(crate) fn times(self, factor: S, shift: i32) -> Self {
        match self {
            Covector::Plane(entries, exponent) => {
                Covector::Plane(entries.map(|entry| entry * factor), exponent.saturating_add(shift))
            }
            Covector::Line(t, exponent) => Covector::Line(t * factor, exponent.saturating_add(shift)),
        }
    }

    /// The covector of the same subspace seen against the x-axis (see [`Subspace::mirrored`]), and back again.
    pub(crate) fn mirrored(self, space: Space) -> Self {
        match self {
            Covector::Plane([y, theta, m, q], exponent) => Covector::Plane([-y, theta, m, -q], exponent),
            Covector::Line(t, exponent) if space.is(Space::Rotation) => Covector::Line(-t, exponent),
            Covector::Line(..) => self,
        }
    }

    /// The state that it picks out of a subspace.
    pub(crate) fn pick(self, subspace: &Subspace<S>) -> ScaledState<S> {
        let entry = |coordinate| self.pick_entry(subspace, coordinate);
        let ((y, exponent), (theta, _), (m, _), (q, _)) =
            (entry(Coordinate::Y), entry(Coordinate::Theta), entry(Coordinate::M), entry(Coordinate::Q));
        ScaledState { state: State { y, theta, m, q }, exponent }
    }

    /// One entry of that state, and the power of two that multiplies all.
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
    pub(crate) fn beside(self, others: &Plane<S>) -> Self {
        let ([y, theta, m, q], exponent) = self.entries();
        let s = others;
        let entries = [
            s.y_theta * y - s.w * m - s.theta_q * q,
            s.y_theta * theta + s.y_m * m + s.w * q,
            s.y_theta * m,
            s.y_theta * q,
        ];
        Covector::Plane(entries, exponent.saturating_add(s.exponent)).moderated()
    }
}

/// `z_i = Σ_j p_ij η_j`
fn of_plane<S: Scalar>([y, theta, m, q]: [S; 4], p: &Plane<S>, coordinate: Coordinate) -> S {
    match coordinate {
        Coordinate::Y => p.y_theta * theta + p.y_m * m + p.w * q,
        Coordinate::Theta => p.w * m + p.theta_q * q - p.y_theta * y,
        Coordinate::M => p.m_q * q - p.y_m * y - p.w * theta,
        Coordinate::Q => -(p.w * y + p.theta_q * theta + p.m_q * m),
        Coordinate::X | Coordinate::Qx => S::zero(),
    }
}

/// The same for the plane that a support leaves.
fn of_tip<S: Scalar>([y, theta, m, q]: [S; 4], support: Support, coordinate: Coordinate) -> S {
    match (support, coordinate) {
        (Support::Fixed, Coordinate::M) | (Support::Pinned, Coordinate::Theta) => q,
        (Support::Fixed, Coordinate::Q) => -m,
        (Support::Pinned, Coordinate::Q) => -theta,
        (Support::Guided, Coordinate::Y) => m,
        (Support::Guided, Coordinate::M) | (Support::Free, Coordinate::Theta) => -y,
        (Support::Free, Coordinate::Y) => theta,
        _ => S::zero(),
    }
}

impl<S: Scalar> Subspace<S> {
    /// What the boundary conditions downstream of a point leave of the state there, seen from the other side: in the frame
    /// of a path that arrives from there, given in that of one that leads there, or back.
    pub(crate) fn mirrored(self) -> Self {
        match self {
            Subspace::Plane(plane) => Subspace::Plane(Plane { w: -plane.w, ..plane }),
            Subspace::OnPin(plane) => Subspace::OnPin(Plane { w: -plane.w, ..plane }),
            Subspace::Tip(..) | Subspace::Grounded(..) | Subspace::Springs { .. } | Subspace::Line(..) => self,
        }
    }
}
