//! Levers of rigid bodies: exact differences of lengths, and planes seen from the far end.

use crate::number::{Frequency, Parameter, ROUNDINGS, Scalar, Size, Truth, largest_loss, may_be_lost};
use crate::subspace::{Plane, Remainder, RootCounter};

/// The two levers of a body, to its output end and to its mass centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Levers<T> {
    pub(super) output: Lever<T>,
    pub(super) centre: Lever<T>,
    /// The length of the longer one.
    reach: T,
}

impl<T: Parameter> Levers<T> {
    pub(super) fn new(output: Lever<T>, centre: Lever<T>) -> Self {
        let [one, other] = [output, centre].map(|lever| lever.length.abs());
        Levers { output, centre, reach: T::select(other.size().is_below(one.size()), one, other) }
    }

    /// `p_YM` and `w` of a plane at the far end of either lever. `beside` has the size, in the unit of `p_YM`, of the number to which
    /// each `p_YM` is added.
    #[inline(always)]
    pub(super) fn far_ends<S: Frequency<T>, C: RootCounter<S>>(
        self,
        p: &Plane<S>,
        beside: &Beside<S>,
        counter: &mut C,
    ) -> [[S; 2]; 2] {
        let levers = [self.output, self.centre];
        let ends = [levers[0].far_end(p), levers[1].far_end(p)];
        if !C::WATCHES {
            return ends;
        }
        let terms = terms_of_y_m(p, S::from_parameter(self.reach).size());
        let is_kept = !(may_be_lost(terms, ends[0][0]) | may_be_lost(terms, ends[1][0]));
        if S::IN_LANES && !is_kept.all() {
            let [first, second] = beside.sizes(p);
            let [[y_m, w], [at_centre, beyond]] = ends;
            let [at_output, at_centre_too] =
                [self.output.is_kept(p, ends[0], first, terms), self.centre.is_kept(p, ends[1], second, terms)];
            return [[y_m.valid_if(at_output), w], [at_centre.valid_if(at_centre_too), beyond]];
        }
        if S::IN_LANES {
            return ends;
        }
        if is_kept.all() { ends } else { self.settled(p, beside.sizes(p), counter) }
    }

    #[cold]
    fn settled<S: Frequency<T>, C: RootCounter<S>>(
        self,
        p: &Plane<S>,
        beside: [S::Size; 2],
        counter: &mut C,
    ) -> [[S; 2]; 2] {
        [self.output.settled(p, beside[0], counter), self.centre.settled(p, beside[1], counter)]
    }
}

/// What is added to `p_YM` at the far ends: the inertia about the output end times `p_YΘ` at that end, `p_MQ` and the turning of the inertia
/// about the mass centre, over `a = mλ²`, at that centre.
pub(super) struct Beside<S> {
    pub(super) inertia: S,
    pub(super) turning: S,
    pub(super) a: S,
}

impl<S: Scalar> Beside<S> {
    /// The sizes of both, in the unit of `p_YM`.
    #[inline(always)]
    fn sizes(&self, p: &Plane<S>) -> [S::Size; 2] {
        [self.inertia.size(), (p.m_q.size() + self.turning.size()) / self.a.size()]
    }
}

/// A length and its rounding error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lever<T> {
    pub(super) length: T,
    rest: T,
}

impl<T: Parameter> Lever<T> {
    /// A lever of a length.
    pub(super) fn new(length: T) -> Self {
        Lever { length, rest: T::zero() }
    }

    /// The lever from one point to another, given their coordinates.
    pub(super) fn between(from: T, to: T) -> Self {
        let [length, rest] = to.difference(from);
        Lever { length, rest }
    }

    /// The product with the lever; in extended precision with its rounding error, too.
    #[inline(always)]
    pub(super) fn times<S: Frequency<T>>(self, value: S) -> S {
        if S::IS_EXTENDED {
            return value * (S::from_parameter(self.length) + S::from_parameter(self.rest));
        }
        value * self.length
    }

    /// `p_YM` and `w` of a plane at the far end.
    #[inline(always)]
    fn far_end<S: Frequency<T>>(self, p: &Plane<S>) -> [S; 2] {
        let moved = self.times(p.theta_q);
        [p.y_m + self.times(p.w + p.w + moved), p.w + moved]
    }

    /// Whether `p_YM` at the far end keeps its digits, compared with what it is added to: a chance zero does not count beside
    /// `w²/p_ΘQ`, a length squared in the same unit.
    #[inline(always)]
    fn is_kept<S: Frequency<T>>(self, p: &Plane<S>, [y_m, w]: [S; 2], beside: S::Size, terms: S::Size) -> S::Truth {
        let size = y_m.size().or_larger(beside).or_larger(w.size() * w.size() / p.theta_q.size());
        !(size * S::Size::of(largest_loss::<S>())).is_below(terms * S::Size::of(S::EPSILON))
    }

    /// `p_YM` and `w` at the far end where `p_YM` may cancel: by chance, or since levers lead back to the place from which they came
    /// and leave rounding. In extended precision `p_YM` then follows from the other minors, `p_YM p_ΘQ = w² + p_YΘ p_MQ`.
    fn settled<S: Frequency<T>, C: RootCounter<S>>(self, p: &Plane<S>, beside: S::Size, counter: &mut C) -> [S; 2] {
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
fn terms_of_y_m<S: Scalar>(p: &Plane<S>, arm: S::Size) -> S::Size {
    p.y_m.size() + (p.w.size() + p.w.size() + p.theta_q.size() * arm) * arm
}
