//! Connections: joining subspaces, holding a point by a support, widening and narrowing.

use crate::number::{ROUNDINGS, Scalar, Size, Truth};
use crate::subspace::count::RootCounter;
use crate::subspace::minors::line::Line;
use crate::subspace::minors::plane::Plane;
use crate::subspace::minors::subspace::Subspace;
use crate::subspace::remainder::Remainder;
use mstmm_plan::Space;

impl<S: Scalar> Plane<S> {
    /// Joins a grounded stiffness of a translation or rotation path.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn with_stiffness(self, k: S, space: Space) -> Self {
        let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = self;
        let minors = if space.is(Space::Translation) {
            [y_theta, y_m, w, theta_q + k * y_theta, m_q + k * y_m]
        } else {
            [y_theta, y_m + k * y_theta, w, theta_q, m_q + k * theta_q]
        };
        Plane::unscaled(minors, exponent)
    }

    /// Joins grounded stiffnesses against deflection and rotation.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with_springs(self, y: Option<S>, theta: Option<S>) -> Self {
        let (k_y, k_theta) = match (y, theta) {
            (None, None) => return self,
            (Some(k), None) => return self.with_stiffness(k, Space::Translation),
            (None, Some(k)) => return self.with_stiffness(k, Space::Rotation),
            (Some(k_y), Some(k_theta)) => (k_y, k_theta),
        };
        let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = self;
        let minors = [
            y_theta,
            y_m + k_theta * y_theta,
            w,
            theta_q + k_y * y_theta,
            // in pairs: a short chain of dependent operations
            (m_q + k_y * y_m) + (k_theta * theta_q + (k_y * k_theta) * y_theta),
        ];
        Plane::unscaled(minors, exponent)
    }

    /// Joins a line of a translation or rotation path.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn with_line(self, Line { y, q, exponent }: Line<S>, space: Space) -> Self {
        let Plane { y_theta, y_m, w, theta_q, m_q, .. } = self;
        let minors = if space.is(Space::Translation) {
            [y * y_theta, y * y_m, y * w, y * theta_q - q * y_theta, y * m_q - q * y_m]
        } else {
            [y * y_theta, y * y_m - q * y_theta, y * w, y * theta_q, y * m_q - q * theta_q]
        };
        Plane::unscaled(minors, self.exponent.saturating_add(exponent))
    }

    /// Joins another plane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn with_plane<C: RootCounter<S>>(self, r: Plane<S>, counter: &mut C) -> Self {
        let p = self;
        let minors = [
            p.y_theta * r.y_theta,
            p.y_m * r.y_theta + p.y_theta * r.y_m,
            p.w * r.y_theta + p.y_theta * r.w,
            p.theta_q * r.y_theta + p.y_theta * r.theta_q,
            p.m_q_with(&r, counter),
        ];
        Plane::unscaled(minors, p.exponent.saturating_add(r.exponent))
    }

    /// p_MQ of two joined planes: zero where no forces are needed at the point.
    ///
    /// Its mixed part is `p_YM r_ΘQ + r_YM p_ΘQ - 2 w_p w_r`. Where both planes are near a common clamped frequency or rigid-body mode
    /// these terms cancel. With `w² = p_YM p_ΘQ - p_YΘ p_MQ` of either plane it is, for `skew = p_YM w_r - r_YM w_p`,
    /// `skew²/(p_YM r_YM) + (r_YM/p_YM) p_YΘ p_MQ + (p_YM/r_YM) r_YΘ r_MQ`, in which every part is small itself.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn m_q_with<C: RootCounter<S>>(&self, r: &Plane<S>, counter: &mut C) -> S {
        let ww = self.w * r.w;
        let plain = (self.y_m * r.theta_q + r.y_m * self.theta_q) - (ww + ww);
        let cancels = (plain.size() * S::Size::of(16.0)).is_below(ww.size());
        let is_plain = !cancels | self.y_m.vanishes() | r.y_m.vanishes();
        if S::IN_LANES || is_plain.all() {
            return (self.m_q * r.y_theta + self.y_theta * r.m_q) + plain.valid_if(is_plain);
        }
        self.m_q_by_squares(r, counter)
    }

    /// p_MQ of two joined planes where its mixed part cancels; watches what rounding leaves of it.
    ///
    /// A lever on a pin leaves a plane of a rigid constraint. Where a second lever holds the same displacement, all minors of their sum
    /// vanish but for rounding, which must not be taken for a clamp.
    #[cold]
    fn m_q_by_squares<C: RootCounter<S>>(&self, r: &Plane<S>, counter: &mut C) -> S {
        let p = self;
        let products = [p.y_m * r.w, r.y_m * p.w];
        let skew = products[0] - products[1];
        let ratio = r.y_m / p.y_m;
        let mixed = skew / p.y_m * (skew / r.y_m) + ratio * p.y_theta * p.m_q + r.y_theta * r.m_q / ratio;
        let m_q = (p.m_q * r.y_theta + p.y_theta * r.m_q) + mixed;
        // `w²/p_YΘ` and `p_YM p_ΘQ/p_YΘ` of the sum, in its unit, show whether it is rounding alone
        let nothing = S::Size::of(0.0);
        let y_theta = (p.y_theta * r.y_theta).size();
        let w = (p.w * r.y_theta + p.y_theta * r.w).size();
        let diagonal = (p.y_m * r.y_theta + p.y_theta * r.y_m) * (p.theta_q * r.y_theta + p.y_theta * r.theta_q);
        let beside = (w * w).or_larger(diagonal.size());
        let size = m_q.size();
        let whole = size.or_larger(S::Size::choose(nothing.is_below(beside), beside / y_theta, nothing));
        let rounding = |units: f64| {
            let of_skew = S::Size::of(units * S::EPSILON) * products[0].size();
            of_skew * (skew.size() + skew.size() + of_skew) / (p.y_m * r.y_m).size()
        };
        let remainder = Remainder { size, whole, rounding: rounding(1.0), bound: rounding(ROUNDINGS) };
        S::select(remainder.tell(counter), S::zero(), m_q)
    }
}

impl<S: Scalar> Line<S> {
    /// Joins another line of the same space.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with_line(self, other: Line<S>) -> Self {
        Line {
            y: self.y * other.y,
            q: self.q * other.y + self.y * other.q,
            exponent: self.exponent.saturating_add(other.exponent),
        }
    }

    /// Joins a grounded stiffness of the same space.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with_stiffness(self, k: S) -> Self {
        Line { q: self.q - k * self.y, ..self }
    }
}

/// The stiffness of two springs in parallel, or of one of them.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn in_parallel<S: Scalar>(a: Option<S>, b: Option<S>) -> Option<S> {
    a.zip(b).map(|(a, b)| a + b).or(a).or(b)
}

/// Joins two subspaces that are no supports.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn joined<S: Scalar, C: RootCounter<S>>(a: Subspace<S>, b: Subspace<S>, counter: &mut C) -> Subspace<S> {
    use Subspace::{Grounded, Line as OfLine, Plane as OfPlane, Springs};
    // to other paths a point on a pin is an ordinary plane
    let ordinary = |subspace| if let Subspace::OnPin(plane) = subspace { OfPlane(plane) } else { subspace };
    let (a, b) = (ordinary(a), ordinary(b));
    match (a, b) {
        (Springs { y, theta }, Springs { y: other_y, theta: other_theta }) => {
            Springs { y: in_parallel(y, other_y), theta: in_parallel(theta, other_theta) }
        }
        (Springs { y, theta }, Grounded(k, space)) | (Grounded(k, space), Springs { y, theta }) => {
            if space.is(Space::Translation) {
                Springs { y: in_parallel(y, Some(k)), theta }
            } else {
                Springs { y, theta: in_parallel(theta, Some(k)) }
            }
        }
        (springs @ Springs { .. }, OfLine(line, space)) | (OfLine(line, space), springs @ Springs { .. }) => {
            OfPlane(springs.plane().with_line(line, space))
        }
        (OfPlane(p), Springs { y, theta }) | (Springs { y, theta }, OfPlane(p)) => OfPlane(p.with_springs(y, theta)),
        // planes behind springs and tips are not shifted into the range yet, and here minors are multiplied by minors
        (OfPlane(p), OfPlane(r)) => OfPlane(p.in_range().with_plane(r.in_range(), counter)),
        (OfPlane(p), Grounded(k, space)) | (Grounded(k, space), OfPlane(p)) => OfPlane(p.with_stiffness(k, space)),
        (OfPlane(p), OfLine(line, space)) | (OfLine(line, space), OfPlane(p)) => OfPlane(p.with_line(line, space)),
        (Grounded(k, Space::Translation), Grounded(j, Space::Rotation))
        | (Grounded(j, Space::Rotation), Grounded(k, Space::Translation)) => Springs { y: Some(k), theta: Some(j) },
        (a, Grounded(k, space)) if !a.space().is(space) => OfPlane(a.plane().with_stiffness(k, space)),
        (a, OfLine(line, space)) if !a.space().is(space) => OfPlane(a.plane().with_line(line, space)),
        (Grounded(j, space), Grounded(k, _)) => Grounded(j + k, space),
        (OfLine(line, space), Grounded(k, _)) | (Grounded(k, _), OfLine(line, space)) => {
            OfLine(line.with_stiffness(k), space)
        }
        _ => OfLine(a.line().with_line(b.line()), a.space()),
    }
}

#[cfg(test)]
mod tests;
