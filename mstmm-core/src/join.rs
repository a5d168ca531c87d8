//! Connections: joining subspaces, holding a point by a support, widening and narrowing.

use crate::count::Tally;
use crate::scalar::Scalar;
use crate::state::{Space, Support};
use crate::subspace::{Line, Plane, Subspace};

impl<S: Scalar> Plane<S> {
    /// Joins a grounded stiffness of a translation or rotation path.
    #[inline(always)]
    pub(crate) fn with_stiffness(self, k: S, space: Space) -> Self {
        let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = self;
        let minors = if space.is(Space::Translation) {
            [y_theta, y_m, w, theta_q + k * y_theta, m_q + k * y_m]
        } else {
            [y_theta, y_m + k * y_theta, w, theta_q, m_q + k * theta_q]
        };
        Plane::new(minors, exponent)
    }

    /// Joins a line of a translation or rotation path.
    #[inline(always)]
    pub(crate) fn with_line(self, Line { y, q, exponent }: Line<S>, space: Space) -> Self {
        let Plane { y_theta, y_m, w, theta_q, m_q, .. } = self;
        let minors = if space.is(Space::Translation) {
            [y * y_theta, y * y_m, y * w, y * theta_q - q * y_theta, y * m_q - q * y_m]
        } else {
            [y * y_theta, y * y_m - q * y_theta, y * w, y * theta_q, y * m_q - q * theta_q]
        };
        Plane::new(minors, self.exponent + exponent)
    }

    /// Joins another plane.
    #[inline(always)]
    pub(crate) fn with_plane(self, r: Plane<S>) -> Self {
        let p = self;
        let ww = p.w * r.w;
        let minors = [
            p.y_theta * r.y_theta,
            p.y_m * r.y_theta + p.y_theta * r.y_m,
            p.w * r.y_theta + p.y_theta * r.w,
            p.theta_q * r.y_theta + p.y_theta * r.theta_q,
            p.m_q * r.y_theta + p.y_theta * r.m_q - (ww + ww) + p.y_m * r.theta_q + r.y_m * p.theta_q,
        ];
        Plane::new(minors, p.exponent + r.exponent)
    }

    /// Holds the point by a support: joins the support's own plane, most of whose minors are zero.
    #[inline(always)]
    fn held(self, support: Support) -> Self {
        let zero = S::zero();
        let minors = match support {
            Support::Free | Support::Roller => return self,
            Support::Pinned => [zero, zero, zero, self.y_theta, self.y_m],
            Support::Guided => [zero, self.y_theta, zero, zero, self.theta_q],
            Support::Fixed => [zero, zero, zero, zero, self.y_theta],
        };
        Plane::unscaled(minors, self.exponent)
    }
}

impl<S: Scalar> Line<S> {
    /// Joins another line of the same space.
    #[inline(always)]
    fn with_line(self, other: Line<S>) -> Self {
        Line::new(self.y * other.y, self.q * other.y + self.y * other.q, self.exponent + other.exponent)
    }

    /// Joins a grounded stiffness of the same space.
    #[inline(always)]
    fn with_stiffness(self, k: S) -> Self {
        Line::new(self.y, self.q - k * self.y, self.exponent)
    }
}

/// Joins two subspaces that are no supports.
#[inline(always)]
fn joined<S: Scalar>(a: Subspace<S>, b: Subspace<S>) -> Subspace<S> {
    use Subspace::{Grounded, Line as OfLine, Plane as OfPlane};
    match (a, b) {
        (OfPlane(p), OfPlane(r)) => OfPlane(p.with_plane(r)),
        (OfPlane(p), Grounded(k, space)) | (Grounded(k, space), OfPlane(p)) => OfPlane(p.with_stiffness(k, space)),
        (OfPlane(p), OfLine(line, space)) | (OfLine(line, space), OfPlane(p)) => OfPlane(p.with_line(line, space)),
        (a, Grounded(k, space)) if !a.space().is(space) => OfPlane(a.plane().with_stiffness(k, space)),
        (a, OfLine(line, space)) if !a.space().is(space) => OfPlane(a.plane().with_line(line, space)),
        (Grounded(j, space), Grounded(k, _)) => Grounded(j + k, space),
        (OfLine(line, space), Grounded(k, _)) | (Grounded(k, _), OfLine(line, space)) => {
            OfLine(line.with_stiffness(k), space)
        }
        _ => OfLine(a.line().with_line(b.line()), a.space()),
    }
}

/// The connection of several inputs, supports among them, to an output that goes on as `output`; `None` at the root.
///
/// Paths are joined first. If the output is wider, they are joined to its free state; then supports hold the point; if
/// the output is narrower, what does not go on has no force.
#[inline(always)]
pub fn connection<S: Scalar, C: Tally<S>>(inputs: &[Subspace<S>], output: Option<Space>, tally: &mut C) -> Subspace<S> {
    let mut sum = None;
    for &input in inputs {
        if !matches!(input, Subspace::Tip(..)) {
            sum = Some(match sum {
                None => input,
                Some(sum) => joined(sum, input),
            });
        }
    }
    let wide = matches!(output, Some(Space::Bending));
    let mut sum = match sum {
        // the graph has refused connections of supports alone, but for `free` and one that goes on wider
        None => return inputs[0],
        Some(sum) if wide => Subspace::Plane(sum.plane()),
        Some(sum) => sum,
    };
    for &input in inputs {
        if let Subspace::Tip(support, _) = input {
            sum = held(sum, support);
        }
    }
    match (sum, output) {
        (Subspace::Plane(plane), Some(space @ (Space::Translation | Space::Rotation))) => {
            tally.narrowing(&plane, space);
            Subspace::Line(narrowed(plane, space), space)
        }
        _ => sum,
    }
}

/// Holds a point by a support.
#[inline(always)]
fn held<S: Scalar>(subspace: Subspace<S>, support: Support) -> Subspace<S> {
    match subspace {
        Subspace::Plane(plane) => Subspace::Plane(plane.held(support)),
        _ if support != Support::Fixed => subspace,
        _ => {
            let line = subspace.line();
            Subspace::Line(Line { y: S::zero(), q: line.y, exponent: line.exponent }, subspace.space())
        }
    }
}

/// What goes on of a bending path whose moment (into a translation) or shear force (into a rotation) is zero.
#[inline(always)]
fn narrowed<S: Scalar>(plane: Plane<S>, space: Space) -> Line<S> {
    if space.is(Space::Translation) {
        Line { y: plane.y_m, q: -plane.m_q, exponent: plane.exponent }
    } else {
        Line { y: plane.theta_q, q: -plane.m_q, exponent: plane.exponent }
    }
}

#[cfg(test)]
mod tests;
