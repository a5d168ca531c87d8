//! The phase of a system: the number of roots below a frequency with a share of the next one.
//!
//! It grows evenly, since the waves of the last beam before the root turn evenly, and is whole at each root. Searches start from it.

use crate::number::{Scalar, Scaled, Size};
use crate::subspace::{Held, Line, Plane, Purpose, RootCounter, WittrickWilliams};
use core::f64::consts::{FRAC_1_PI, FRAC_PI_2};
use mstmm_plan::{Space, Support};

/// The plane behind a beam with its wave a quarter of a turn ahead, given the units of minors and their inverses there.
///
/// At the end of a beam that is long, compared with its waves, the state is that of a wave `sin(βx + θ)` and of an evanescent one
/// `e^{βx}`. In the units of the beam the minors are `p_YΘ = sin θ - cos θ, p_YM = 2 sin θ, w = sin θ + cos θ, p_ΘQ = 2 cos θ,
/// p_MQ = cos θ - sin θ`.
#[inline(always)]
fn quarter_ahead<S: Scalar>(plane: &Plane<S>, [factors, inverses]: &[[S; 4]; 2]) -> Plane<S> {
    let ahead = plane.w * inverses[1];
    let minors = [
        ahead,
        plane.theta_q * inverses[2] * factors[0],
        plane.m_q * inverses[3] * factors[1],
        -(plane.y_m * inverses[0] * factors[2]),
        -(ahead * factors[3]),
    ];
    Plane::unscaled(minors, plane.exponent)
}

/// A counter that also keeps Δ with the wave of the last beam a quarter of a turn ahead.
pub(crate) struct PhaseCounter<S: Scalar> {
    counter: WittrickWilliams<S::Size>,
    purpose: Purpose,
    ahead: Scaled<S>,
    /// Units of minors and their inverses at the wave number of the last beam.
    units: [[S; 4]; 2],
    /// The plane behind that beam.
    end: Plane<S>,
}

impl<S: Scalar> PhaseCounter<S> {
    /// A counter for a purpose.
    #[inline(always)]
    pub(crate) fn new(purpose: Purpose) -> Self {
        let ones = [S::one(); 4];
        PhaseCounter {
            counter: WittrickWilliams::default(),
            purpose,
            ahead: Scaled::new(S::one(), 0),
            units: [ones; 2],
            end: Plane::of_tip(Support::Free),
        }
    }

    /// The counter of roots.
    #[inline(always)]
    pub(crate) fn counter(&self) -> &WittrickWilliams<S::Size> {
        &self.counter
    }

    /// The phase in half turns, given Δ.
    #[inline(always)]
    pub(crate) fn phase(&self, delta: Scaled<S>) -> S::Size {
        self.counter.count() + share(delta.mantissa(), self.ahead.over_power(delta.exponent()))
    }
}

/// The share of the way from the last root to the next one, by the sine and the cosine of a phase.
#[inline(always)]
fn share<S: Scalar>(sine: S, cosine: S) -> S::Size {
    let number = S::Size::of;
    let (x, y) = (sine.size(), cosine.size());
    let is_flat = x.is_below(y);
    let ratio = S::Size::choose(is_flat, x, y) / S::Size::choose(is_flat, y, x);
    let square = ratio * ratio;
    // the arc tangent on [0, 1] to 1e-5: starts need no more
    let [a, b, c, d, e] = [0.999_866, -0.330_299_5, 0.180_141, -0.085_133, 0.020_835_1];
    let series = number(c) + square * (number(d) + square * number(e));
    let angle = ratio * (number(a) + square * (number(b) + square * series));
    let angle = S::Size::choose(is_flat, angle, number(FRAC_PI_2) + angle * number(-1.0)) * number(FRAC_1_PI);
    let is_second = sine.is_negative() ^ cosine.is_negative();
    S::Size::choose(is_second, number(1.0) + angle * number(-1.0), angle)
}

impl<S: Scalar> RootCounter<S> for PhaseCounter<S> {
    const COUNTS: bool = true;

    #[inline(always)]
    fn line(&mut self, before: &Line<S>, after: &Line<S>, held: S::Size, is_negative: S::Truth) {
        if self.purpose != Purpose::Values {
            self.counter.line(before, after, held, is_negative);
        }
    }

    #[inline(always)]
    fn plane(&mut self, before: &Plane<S>, after: &Plane<S>, held: Held<S>) {
        if self.purpose != Purpose::Values {
            if let Some(units) = held.units {
                (self.units, self.end) = (units, *after);
            }
            self.counter.plane(before, after, held);
        }
    }

    #[inline(always)]
    fn narrowing(&mut self, plane: &Plane<S>, space: Space) {
        if self.purpose != Purpose::Values {
            self.counter.narrowing(plane, space);
        }
    }

    /// Δ with the wave of the last beam a quarter of a turn ahead, held by the stiffnesses that were joined behind it.
    #[inline(always)]
    fn plane_root(&mut self, plane: &Plane<S>, support: Support) {
        if self.purpose != Purpose::Values {
            self.counter.plane_root(plane, support);
        }
        if self.purpose != Purpose::Phases {
            return;
        }
        let end = self.end;
        let inverse = S::one() / end.y_theta;
        let k_y = (plane.theta_q - end.theta_q) * inverse;
        let k_theta = (plane.y_m - end.y_m) * inverse;
        let ahead = quarter_ahead(&end, &self.units);
        let ahead = ahead.with_stiffness(k_y, Space::Translation).with_stiffness(k_theta, Space::Rotation);
        self.ahead = Scaled::new(ahead.minor_at(support), i64::from(ahead.exponent));
    }

    #[inline(always)]
    fn turned(&self, before: &Plane<S>) -> Option<Plane<S>> {
        (self.purpose == Purpose::Phases).then(|| quarter_ahead(before, &self.units))
    }

    #[inline(always)]
    fn delta_ahead(&mut self, delta: Scaled<S>) {
        self.ahead = delta;
    }

    #[inline(always)]
    fn line_root(&mut self, line: &Line<S>, support: Support) {
        if self.purpose != Purpose::Values {
            self.counter.line_root(line, support);
        }
        let ahead = if support == Support::Fixed { -line.q } else { line.y };
        self.ahead = Scaled::new(ahead, i64::from(line.exponent));
    }

    #[inline(always)]
    fn eliminated(&mut self, below: S::Size) {
        RootCounter::<S>::eliminated(&mut self.counter, below);
    }
}
