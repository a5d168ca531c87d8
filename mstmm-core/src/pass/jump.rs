//! Jumps as sources of motions: one entry of the state behind a point differs from that before it.
//!
//! The boundary conditions upstream of the point leave a plane P of the state there, those downstream a plane R. A jump f between
//! states of both is `f = z_R - z_P` with `z_P = P R* f/Δ`, where `R*` has the dual minors of R. Δ = 0 where P and R meet, at a
//! root. There `P R* f` is the motion of the system itself for any f.

use crate::number::{Scalar, Scaled};
use crate::pass::both_ways::Passes;
use crate::pass::tree::Tree;
use crate::subspace::{Covector, NoCount, Plane, Subspace};
use mstmm_plan::{Coordinate, Space};

/// The upstream and the downstream subspace at a point, both as subspaces of paths that arrive there.
pub(crate) struct Meeting<S> {
    pub(crate) upstream: Subspace<S>,
    pub(crate) downstream: Subspace<S>,
    /// Space of the state at the point.
    pub(crate) space: Space,
}

/// The covectors of a jump, times Δ.
pub(crate) struct Jump<S> {
    /// The covector of the upstream subspace.
    pub(crate) upstream: Covector<S>,
    /// The covector of the downstream subspace, in the frame of a path that arrives from there.
    pub(crate) downstream: Covector<S>,
}

impl<S: Scalar, Y: Tree<S> + ?Sized> Passes<'_, Y, S> {
    /// The subspaces that meet behind a step.
    pub(crate) fn meeting(&self, step: usize) -> Meeting<S> {
        Meeting {
            upstream: self.upstream.as_ref()[step],
            downstream: self.downstream.as_ref()[step].mirrored(),
            space: self.system.scheme().behind(step),
        }
    }
}

impl<S: Scalar> Meeting<S> {
    /// Δ at a point. Up to its sign and a power of two it does not depend on the point.
    pub(crate) fn delta(&self) -> Scaled<S> {
        let Meeting { upstream, downstream, space } = *self;
        if space.is(Space::Bending) {
            let (p, r) = (upstream.plane(), downstream.plane());
            let value = match (upstream, downstream) {
                (_, Subspace::Tip(support, _)) => p.minor_at(support),
                (Subspace::Tip(support, _), _) => r.minor_at(support),
                _ => p.m_q_with(&r, &mut NoCount),
            };
            return Scaled::new(value, i64::from(p.exponent) + i64::from(r.exponent));
        }
        let (p, r) = (upstream.line(), downstream.line());
        Scaled::new(-(p.q * r.y + p.y * r.q), i64::from(p.exponent) + i64::from(r.exponent))
    }

    /// The covectors of a jump by 1 in one entry.
    pub(crate) fn jump(&self, coordinate: Coordinate) -> Jump<S> {
        let Meeting { upstream, downstream, space } = *self;
        let is_force = coordinate.is_force();
        let (upstream, downstream) = if space.is(Space::Bending) {
            let (p, r) = (upstream.plane(), downstream.plane());
            let sign = if is_force { S::one() } else { -S::one() };
            (dual(&r, coordinate), dual(&p, coordinate).times(sign, 0))
        } else {
            let (p, r) = (upstream.line(), downstream.line());
            // the force of a line in rotation is -M
            let sign = if coordinate == Coordinate::M { -S::one() } else { S::one() };
            if is_force {
                (Covector::Line(r.y * sign, r.exponent), Covector::Line(p.y * sign, p.exponent))
            } else {
                (Covector::Line(r.q, r.exponent), Covector::Line(-p.q, p.exponent))
            }
        };
        Jump { upstream, downstream: downstream.mirrored(space) }
    }

    /// The square of an entry of the motion that a jump in the dual entry causes there, times Δ.
    pub(crate) fn square(&self, coordinate: Coordinate) -> Scaled<S> {
        let Meeting { upstream, downstream, space } = *self;
        let (value, exponents) = if space.is(Space::Bending) {
            let (p, r) = (upstream.plane(), downstream.plane());
            let value = match coordinate {
                Coordinate::Theta => p.y_theta * r.theta_q + p.theta_q * r.y_theta,
                Coordinate::M => p.y_m * r.m_q + p.m_q * r.y_m,
                Coordinate::Q => p.theta_q * r.m_q + p.m_q * r.theta_q,
                _ => p.y_theta * r.y_m + p.y_m * r.y_theta,
            };
            (value, [p.exponent, r.exponent])
        } else {
            let (p, r) = (upstream.line(), downstream.line());
            (if coordinate.is_force() { p.q * r.q } else { p.y * r.y }, [p.exponent, r.exponent])
        };
        Scaled::new(value, exponents.map(i64::from).iter().sum())
    }
}

/// `R* e`: the column of the dual minors for one entry.
fn dual<S: Scalar>(plane: &Plane<S>, coordinate: Coordinate) -> Covector<S> {
    let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = *plane;
    let zero = S::zero();
    let entries = match coordinate {
        Coordinate::Theta => [m_q, zero, w, -y_m],
        Coordinate::M => [theta_q, -w, zero, -y_theta],
        Coordinate::Q => [-w, y_m, y_theta, zero],
        _ => [zero, -m_q, -theta_q, w],
    };
    Covector::Plane(entries, exponent)
}
