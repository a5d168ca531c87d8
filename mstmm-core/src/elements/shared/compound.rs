//! The steps of beam-like elements on planes, given the second compound of their transfer matrix.

use crate::number::{Scalar, Scaled, Size, Truth};
use crate::subspace::{Connecting, Held, Plane, RootCounter, Subspace};
use mstmm_plan::Support;

/// Units of minors and their inverses: `EI b, EI b², EI b³, EI² b⁴` for p_YM, w, p_ΘQ, p_MQ beside p_YΘ, of a plane whose states
/// have the entries `Y, Θ/b, M/(EI b²), Q/(EI b³)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units<T> {
    pub(crate) factors: [T; 4],
    pub(crate) inverses: [T; 4],
}

impl<T: Scalar> Units<T> {
    #[inline]
    pub(crate) fn new(stiffness: T, b: T) -> Self {
        let first = stiffness * b;
        let second = first * b;
        let factors = [first, second, second * b, second * second];
        let (one, [a, b, c, d]) = (T::one(), factors);
        Units { factors, inverses: [one / a, one / b, one / c, one / d] }
    }

    /// The units as numbers of another type.
    #[inline(always)]
    pub(crate) fn map<S>(self, to: impl Fn(T) -> S) -> Units<S> {
        let Units { factors: [a, b, c, d], inverses: [e, f, g, h] } = self;
        Units { factors: [to(a), to(b), to(c), to(d)], inverses: [to(e), to(f), to(g), to(h)] }
    }
}

impl<T: Scalar> Units<T> {
    /// Whether all units are finite and not zero.
    pub(crate) fn are_in_range(&self) -> bool {
        let mut all = T::Truth::of(true);
        for (&factor, &inverse) in self.factors.iter().zip(&self.inverses) {
            // about 1, unless one of both is out of the range
            all = all & (factor * inverse).size().is_below(T::Size::of(2.0));
        }
        all.all()
    }
}

/// The second compound of the transfer matrix in units in which it has neither l, EI nor β, and those units.
///
/// With `ch, sh, c, s` of z: `a = (1 + ch c)/2, c = ch c, b = (ch s + sh c)/2, f = sh s/2, d = (ch s - sh c)/2,
/// e = (1 - ch c)/2`, all divided by `2^exponent`. For small z, where these cancel, b, f, d, e are their Taylor series divided by
/// z, z², z³, z⁴, the raised ones these series multiplied by z³, z², z, z⁴, and `1/l` replaces β.
#[derive(Clone, Copy, Debug)]
pub struct BendingCoefficients<S> {
    pub(crate) z: S,
    pub(crate) a: S,
    pub(crate) c: S,
    pub(crate) b: S,
    pub(crate) f: S,
    pub(crate) d: S,
    pub(crate) e: S,
    pub(crate) raised_b: S,
    pub(crate) raised_f: S,
    pub(crate) raised_d: S,
    pub(crate) raised_e: S,
    /// `EI b, EI b², EI b³, EI² b⁴`.
    pub(crate) factors: [S; 4],
    /// Their inverses.
    pub(crate) inverses: [S; 4],
    pub(crate) exponent: i32,
}

impl<S: Scalar> BendingCoefficients<S> {
    /// The first coefficients where the truth holds, else the second. Their exponents are equal, unless waves are scaled, which numbers in
    /// lanes never are.
    #[inline(always)]
    pub(crate) fn select(truth: S::Truth, first: Self, second: Self) -> Self {
        let s = |a, b| S::select(truth, a, b);
        let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (first.factors, second.factors);
        let ([c0, c1, c2, c3], [d0, d1, d2, d3]) = (first.inverses, second.inverses);
        BendingCoefficients {
            z: first.z,
            a: s(first.a, second.a),
            c: s(first.c, second.c),
            b: s(first.b, second.b),
            f: s(first.f, second.f),
            d: s(first.d, second.d),
            e: s(first.e, second.e),
            raised_b: s(first.raised_b, second.raised_b),
            raised_f: s(first.raised_f, second.raised_f),
            raised_d: s(first.raised_d, second.raised_d),
            raised_e: s(first.raised_e, second.raised_e),
            factors: [s(a0, b0), s(a1, b1), s(a2, b2), s(a3, b3)],
            inverses: [s(c0, d0), s(c1, d1), s(c2, d2), s(c3, d3)],
            exponent: first.exponent,
        }
    }

    /// Takes a subspace through the element.
    #[inline(always)]
    pub(crate) fn step<C: RootCounter<S>>(&self, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        let after = match input {
            // called where a build is small
            Subspace::Tip(support, _) if S::IN_LANES => self.behind_tip(support),
            Subspace::Tip(support, _) => self.behind_tip_auto_inline(support),
            Subspace::Springs { y, theta } => self.behind_springs(y, theta),
            Subspace::OnPin(plane) => self.behind_pin(&plane).in_range(),
            _ => self.through(&input.plane()).in_range(),
        };
        if C::COUNTS {
            counter.plane(&input.plane(), &after, self.held());
        }
        Subspace::Plane(after)
    }

    /// The count of the beam with both ends clamped: the number i of whole half waves in `z/π`, less one where `1 - ch z cos z`, a
    /// positive multiple of e, has not yet the sign of `(-1)^i`. It is zero where `z⁴ < 0`.
    #[inline(always)]
    fn held(&self) -> Held<S> {
        let BendingCoefficients { z, e, b, .. } = *self;
        let (half_waves, is_odd) = (z.size() * S::Size::of(core::f64::consts::FRAC_1_PI)).whole();
        let is_negative = e.is_negative();
        // one less, but for the beam that is too short for one
        let is_less = (is_odd ^ is_negative) & S::Size::of(0.0).is_below(half_waves);
        let below = half_waves + S::Size::choose(is_less, S::Size::of(-1.0), S::Size::of(0.0));
        let units = Some([self.factors, self.inverses]);
        Held { below, is_negative, stiffness: [self.factors[2] * b, e], units }
    }

    /// Takes a subspace into the root.
    #[inline(always)]
    pub(crate) fn root<C: RootCounter<S>>(&self, input: Subspace<S>, support: Support, counter: &mut C) -> Scaled<S> {
        if C::COUNTS || matches!(input, Subspace::Tip(..)) {
            return self.step(input, counter).at_root(support, counter);
        }
        // not shifted into the range: only one minor is needed
        let plane = match input {
            Subspace::Springs { y, theta } => self.behind_springs(y, theta),
            Subspace::OnPin(plane) => self.behind_pin(&plane),
            _ => self.through(&input.plane()),
        };
        Scaled::new(plane.minor_at(support), i64::from(plane.exponent))
    }

    /// The plane behind the beam, from minors in the units of the coefficients.
    #[inline(always)]
    fn plane(&self, [y_theta, y_m, w, theta_q, m_q]: [S; 5], exponent: i32) -> Plane<S> {
        let factors = self.factors;
        let minors = [y_theta, y_m * factors[0], w * factors[1], theta_q * factors[2], m_q * factors[3]];
        Plane::unscaled(minors, exponent.saturating_add(self.exponent))
    }

    /// Takes a plane through the beam. Sums are formed in pairs, for short chains of dependent additions.
    #[inline(always)]
    fn through(&self, p: &Plane<S>) -> Plane<S> {
        let BendingCoefficients { a, c, b, f, d, e, raised_b, raised_f, raised_d, raised_e, inverses, .. } = *self;
        let (y_theta, y_m, w) = (p.y_theta, p.y_m * inverses[0], p.w * inverses[1]);
        let (theta_q, m_q) = (p.theta_q * inverses[2], p.m_q * inverses[3]);
        let (two_y_m, two_w, two_theta_q) = (y_m + y_m, w + w, theta_q + theta_q);
        let minors = [
            (a * y_theta + b * y_m) + (f * two_w + d * theta_q) + e * m_q,
            (c * y_m - raised_d * y_theta) + (b * two_w + f * two_theta_q) + d * m_q,
            (c * w - raised_f * y_theta) + (b * theta_q - raised_d * y_m) + f * m_q,
            (c * theta_q - raised_b * y_theta) - (raised_f * two_y_m + raised_d * two_w) + b * m_q,
            (a * m_q + raised_e * y_theta) - (raised_b * y_m + raised_f * two_w) - raised_d * theta_q,
        ];
        self.plane(minors, p.exponent)
    }

    /// Takes the plane of a point on a pin through the beam.
    #[inline(always)]
    fn behind_pin(&self, p: &Plane<S>) -> Plane<S> {
        let BendingCoefficients { a, c, b, f, d, e, raised_d, inverses, .. } = *self;
        let (theta_q, m_q) = (p.theta_q * inverses[2], p.m_q * inverses[3]);
        let minors = [
            d * theta_q + e * m_q,
            f * (theta_q + theta_q) + d * m_q,
            b * theta_q + f * m_q,
            c * theta_q + b * m_q,
            a * m_q - raised_d * theta_q,
        ];
        self.plane(minors, p.exponent)
    }

    /// The plane behind a beam that starts at grounded springs; like that behind a tip it is not shifted into the range.
    #[inline(always)]
    fn behind_springs(&self, y: Option<S>, theta: Option<S>) -> Plane<S> {
        let BendingCoefficients { a, c, b, f, d, e, raised_b, raised_f, raised_d, raised_e, inverses, .. } = *self;
        let minors = match (theta.map(|theta| theta * inverses[0]), y.map(|y| y * inverses[2])) {
            (None, None) => [a, -raised_d, -raised_f, -raised_b, raised_e],
            (Some(y_m), None) => [
                a + b * y_m,
                c * y_m - raised_d,
                -(raised_f + raised_d * y_m),
                -(raised_b + raised_f * (y_m + y_m)),
                raised_e - raised_b * y_m,
            ],
            (None, Some(theta_q)) => [
                a + d * theta_q,
                f * (theta_q + theta_q) - raised_d,
                b * theta_q - raised_f,
                c * theta_q - raised_b,
                raised_e - raised_d * theta_q,
            ],
            (Some(y_m), Some(theta_q)) => {
                let m_q = y_m * theta_q;
                [
                    (a + b * y_m) + (d * theta_q + e * m_q),
                    (c * y_m - raised_d) + (f * (theta_q + theta_q) + d * m_q),
                    (b * theta_q - raised_f) + (f * m_q - raised_d * y_m),
                    (c * theta_q - raised_b) + (b * m_q - raised_f * (y_m + y_m)),
                    (a * m_q + raised_e) - (raised_b * y_m + raised_d * theta_q),
                ]
            }
        };
        self.plane(minors, 0)
    }

    /// [`behind_tip`](Self::behind_tip) without forced inlining.
    fn behind_tip_auto_inline(&self, support: Support) -> Plane<S> {
        self.behind_tip(support)
    }

    /// The plane behind a beam that starts at a support: a column of the compound.
    #[inline(always)]
    fn behind_tip(&self, support: Support) -> Plane<S> {
        let BendingCoefficients { a, c, b, f, d, e, raised_b, raised_f, raised_d, .. } = *self;
        let (factor, inverse) = (self.factors, self.inverses);
        let minors = match support {
            Support::Fixed => [e * inverse[3], d * inverse[2], f * inverse[1], b * inverse[0], a],
            Support::Pinned => {
                let length = factor[0] * inverse[1];
                [d * inverse[2], (f + f) * (length * length), b * length, c, -(raised_d * factor[0])]
            }
            Support::Guided => {
                let number = factor[1] * inverse[0];
                [
                    b * inverse[0],
                    c,
                    -(raised_d * number),
                    -((raised_f + raised_f) * (number * number)),
                    -(raised_b * factor[2]),
                ]
            }
            Support::Free => return self.behind_springs(None, None),
            // refused before: the roller is a support of planar states
            Support::Roller => [S::zero(); 5],
        };
        Plane::unscaled(minors, self.exponent)
    }
}
