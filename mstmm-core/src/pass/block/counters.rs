//! Counters of a block, and their adapter for branch-free numbers.

use crate::number::{BranchFree, Scalar};
use crate::pass::block::WIDTH;
use crate::subspace::{Held, Line, Plane, RootCounter};
use mstmm_plan::{Space, Support};

/// Two counters in each lane: one as of the last step, and a pending one for the current step. A lane that has to be evaluated alone
/// starts from the first.
pub(crate) struct Counters<C> {
    two: [[C; WIDTH]; 2],
    is_second: bool,
}

impl<C: Copy + Default> Counters<C> {
    /// Counters that have received nothing.
    pub(crate) fn new() -> Self {
        Counters { two: [[C::default(); WIDTH]; 2], is_second: false }
    }
}

impl<C> Counters<C> {
    /// The committed counters, and the pending ones.
    #[inline]
    pub(crate) fn both(&mut self) -> (&[C; WIDTH], &mut [C; WIDTH]) {
        let [first, second] = &mut self.two;
        if self.is_second { (second, first) } else { (first, second) }
    }

    /// Commits the pending counters.
    #[inline]
    pub(crate) fn commit(&mut self) {
        self.is_second = !self.is_second;
    }

    /// The committed counters.
    #[inline]
    pub(crate) fn committed(&self) -> &[C; WIDTH] {
        &self.two[usize::from(self.is_second)]
    }

    /// The committed counters, to be changed.
    #[inline]
    pub(crate) fn committed_mut(&mut self) -> &mut [C; WIDTH] {
        &mut self.two[usize::from(self.is_second)]
    }
}

/// A counter of plain numbers as one of branch-free numbers.
pub(crate) struct Unwrapped<'a, C>(pub(super) &'a mut C);

fn line<S: Scalar, const SERIES: bool>(line: &Line<BranchFree<S, SERIES>>) -> Line<S> {
    Line { y: line.y.0, q: line.q.0, exponent: line.exponent }
}

fn plane<S: Scalar, const SERIES: bool>(plane: &Plane<BranchFree<S, SERIES>>) -> Plane<S> {
    let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = *plane;
    Plane::unscaled([y_theta.0, y_m.0, w.0, theta_q.0, m_q.0], exponent)
}

impl<S: Scalar, C: RootCounter<S>, const SERIES: bool> RootCounter<BranchFree<S, SERIES>> for Unwrapped<'_, C> {
    const COUNTS: bool = C::COUNTS;
    const WATCHES: bool = C::WATCHES;

    #[inline(always)]
    fn cancelled(&mut self, completely: bool) {
        self.0.cancelled(completely);
    }

    #[inline(always)]
    fn looks_at_root(&self) -> bool {
        self.0.looks_at_root()
    }

    #[inline(always)]
    fn root_sum(&mut self, sum: f64, terms: f64) {
        self.0.root_sum(sum, terms);
    }

    #[inline(always)]
    fn line(
        &mut self,
        before: &Line<BranchFree<S, SERIES>>,
        after: &Line<BranchFree<S, SERIES>>,
        held: u64,
        is_negative: bool,
    ) {
        self.0.line(&line(before), &line(after), held, is_negative);
    }

    #[inline(always)]
    fn plane(
        &mut self,
        before: &Plane<BranchFree<S, SERIES>>,
        after: &Plane<BranchFree<S, SERIES>>,
        held: Held<BranchFree<S, SERIES>>,
    ) {
        let Held { below, is_negative, stiffness } = held;
        self.0.plane(&plane(before), &plane(after), Held { below, is_negative, stiffness: stiffness.0 });
    }

    #[inline(always)]
    fn narrowing(&mut self, own: &Plane<BranchFree<S, SERIES>>, space: Space) {
        self.0.narrowing(&plane(own), space);
    }

    #[inline(always)]
    fn plane_root(&mut self, own: &Plane<BranchFree<S, SERIES>>, support: Support) {
        self.0.plane_root(&plane(own), support);
    }

    #[inline(always)]
    fn line_root(&mut self, own: &Line<BranchFree<S, SERIES>>, support: Support) {
        self.0.line_root(&line(own), support);
    }
}
