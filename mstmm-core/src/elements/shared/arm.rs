//! Arms of levers and rigid bodies: exact differences of lengths, and planes seen from the far end.

use crate::number::{Frequency, Parameter, ROUNDINGS, Scalar, Size, Truth, may_be_lost};
use crate::subspace::{Plane, Remainder, RootCounter};

/// A length and its rounding error.
#[derive(Clone, Copy, Debug)]
pub struct Arm<T> {
    pub(crate) length: T,
    rest: T,
}

impl<T: Parameter> Arm<T> {
    /// An arm of a length.
    pub(crate) fn new(length: T) -> Self {
        Arm { length, rest: T::zero() }
    }

    /// The arm from one point to another, given their coordinates.
    pub(crate) fn between(from: T, to: T) -> Self {
        let [length, rest] = to.difference(from);
        Arm { length, rest }
    }

    /// The product with the arm; in extended precision with its rounding error, too.
    #[inline(always)]
    pub(crate) fn times<S: Frequency<T>>(self, value: S) -> S {
        if S::IS_EXTENDED {
            return value * (S::from_parameter(self.length) + S::from_parameter(self.rest));
        }
        value * self.length
    }

    /// `p_YM` and `w` of a plane at the far end.
    #[inline(always)]
    pub(crate) fn far_end<S: Frequency<T>>(self, p: &Plane<S>) -> [S; 2] {
        let moved = self.times(p.theta_q);
        [p.y_m + self.times(p.w + p.w + moved), p.w + moved]
    }

    /// A plane at the far end of a lever without mass, where `p_YM` is added to nothing. It has the same p_YΘ, p_ΘQ and p_MQ.
    #[inline(always)]
    pub(crate) fn carried<S: Frequency<T>, C: RootCounter<S>>(self, p: &Plane<S>, counter: &mut C) -> Plane<S> {
        let [mut y_m, mut w] = self.far_end(p);
        if C::WATCHES && may_be_lost(terms_of_y_m(p, S::from_parameter(self.length).size()), y_m).any() {
            [y_m, w] = self.settled(p, S::Size::of(0.0), counter);
        }
        Plane::new([p.y_theta, y_m, w, p.theta_q, p.m_q], p.exponent)
    }

    /// `p_YM` and `w` at the far end where `p_YM` may cancel: by chance, or since levers lead back to the place from which they came
    /// and leave rounding. In extended precision `p_YM` then follows from the other minors, `p_YM p_ΘQ = w² + p_YΘ p_MQ`.
    #[cold]
    pub(crate) fn settled<S: Frequency<T>, C: RootCounter<S>>(
        self,
        p: &Plane<S>,
        beside: S::Size,
        counter: &mut C,
    ) -> [S; 2] {
        let [y_m, w] = self.far_end(p);
        let (arm, theta_q) = (S::from_parameter(self.length).size(), p.theta_q.size());
        let product = p.y_theta * p.m_q;
        let plain = |units: f64| terms_of_y_m(p, arm) * S::Size::of(units * S::EPSILON);
        let by_others = |units: f64| {
            let units = S::Size::of(units * S::EPSILON);
            let of_w = (p.w.size() + theta_q * arm) * units;
            let of_squares = (w.size() * w.size() + product.size()) * units;
            (of_w * (w.size() + w.size() + of_w) + of_squares) / theta_q
        };
        let is_by_others = S::IS_EXTENDED && by_others(1.0).is_below(plain(1.0)).all();
        let (y_m, [rounding, bound]) = if is_by_others {
            ((w * w + product) / p.theta_q, [by_others(1.0), by_others(ROUNDINGS)])
        } else {
            (y_m, [plain(1.0), plain(ROUNDINGS)])
        };
        // a chance zero of p_YM does not count beside `w²/p_ΘQ`, a length squared in the same unit
        let size = y_m.size().or_larger(beside).or_larger(w.size() * w.size() / theta_q);
        let is_nothing = Remainder { size, whole: size, rounding, bound }.tell(counter);
        if is_nothing.all() && S::IS_EXTENDED { [S::zero(); 2] } else { [y_m, w] }
    }
}

/// The sizes of the terms of `p_YM` at the far end of an arm.
#[inline(always)]
pub(crate) fn terms_of_y_m<S: Scalar>(p: &Plane<S>, arm: S::Size) -> S::Size {
    p.y_m.size() + (p.w.size() + p.w.size() + p.theta_q.size() * arm) * arm
}
