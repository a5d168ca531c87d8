//! The two levers of a rigid body: planes seen from both far ends.

use crate::elements::shared::arm::{Arm, terms_of_y_m};
use crate::number::{Frequency, Parameter, Scalar, Size, Truth, may_be_lost};
use crate::subspace::{Plane, RootCounter};

/// The two levers of a body, to its output end and to its mass centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Levers<T> {
    pub(super) output: Arm<T>,
    pub(super) centre: Arm<T>,
    /// The length of the longer one.
    reach: T,
}

impl<T: Parameter> Levers<T> {
    pub(super) fn new(output: Arm<T>, centre: Arm<T>) -> Self {
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
        let may_be_lost = may_be_lost(terms, ends[0][0]) | may_be_lost(terms, ends[1][0]);
        if may_be_lost.any() { self.settled(p, beside.sizes(p), counter) } else { ends }
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
