//! Δ in each lane, where the last subspaces meet the root.

use crate::number::{BranchFree, InColumns, Scaled};
use crate::pass::block::WIDTH;
use crate::pass::block::counters::{Counters, Unwrapped};
use crate::pass::block::kinds::Kind;
use crate::pass::block::lane_ops::{FIXED, FREE, GUIDED, PINNED};
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::{KINDS, LINE, PLANE, TURN, Task, widest};
use crate::subspace::{Connecting, RootCounter};
use mstmm_plan::{Space, Support};

/// A number with an exponent of its own in each lane.
pub(crate) struct Values<S: InColumns> {
    mantissas: S::Columns<WIDTH>,
    exponents: [i64; WIDTH],
}

impl<S: InColumns> Values<S> {
    /// Values of zero.
    pub(crate) fn new() -> Self {
        Values { mantissas: S::zero().columns(), exponents: [0; WIDTH] }
    }

    /// The value in a lane.
    #[inline(always)]
    pub(crate) fn lane(&self, lane: usize) -> Scaled<S> {
        Scaled::normalised(S::get(&self.mantissas, lane), self.exponents[lane])
    }

    fn set(&mut self, lane: usize, value: Scaled<S>) {
        value.mantissa().put(&mut self.mantissas, lane);
        self.exponents[lane] = value.exponent();
    }
}

/// Δ where the last subspaces meet the support of the root. Planes and lines may be out of range, since nothing is multiplied.
pub(crate) fn at_root<S: InColumns, C: RootCounter<S> + Copy>(
    last: &Lanes<S>,
    support: Support,
    counters: &mut Counters<C>,
    values: &mut Values<S>,
) {
    match (last.kind, support) {
        (Kind::Plane, Support::Fixed) => straight::<S, C, PLANE, FIXED>(last, counters, values),
        (Kind::Plane, Support::Pinned) => straight::<S, C, PLANE, PINNED>(last, counters, values),
        (Kind::Plane, Support::Guided) => straight::<S, C, PLANE, GUIDED>(last, counters, values),
        (Kind::Plane, Support::Free) => straight::<S, C, PLANE, FREE>(last, counters, values),
        (Kind::Line(Space::Translation), Support::Fixed) => straight::<S, C, LINE, FIXED>(last, counters, values),
        (Kind::Line(Space::Translation), Support::Free) => straight::<S, C, LINE, FREE>(last, counters, values),
        (Kind::Line(Space::Rotation), Support::Fixed) => straight::<S, C, TURN, FIXED>(last, counters, values),
        (Kind::Line(Space::Rotation), Support::Free) => straight::<S, C, TURN, FREE>(last, counters, values),
        _ => fallback_everywhere(last, support, counters, values),
    }
}

fn fallback_everywhere<S: InColumns, C: RootCounter<S>>(
    last: &Lanes<S>,
    support: Support,
    counters: &mut Counters<C>,
    values: &mut Values<S>,
) {
    for (lane, counter) in counters.committed_mut().iter_mut().enumerate() {
        values.set(lane, last.lane(lane).at_root(support, counter));
    }
}

fn straight<S: InColumns, C: RootCounter<S> + Copy, const KIND: usize, const SUPPORT: usize>(
    last: &Lanes<S>,
    counters: &mut Counters<C>,
    values: &mut Values<S>,
) {
    let (committed, pending) = counters.both();
    let are_good = widest(RootLoop::<S, C, KIND, SUPPORT> { last, values, committed, pending });
    if !are_good {
        for lane in 0..WIDTH {
            if S::get(&values.mantissas, lane).size().is_nan() {
                pending[lane] = committed[lane];
                values.set(lane, last.lane(lane).at_root(Support::ALL[SUPPORT], &mut pending[lane]));
            }
        }
    }
    counters.commit();
}

/// The branch-free loop over the lanes.
struct RootLoop<'a, S: InColumns, C, const KIND: usize, const SUPPORT: usize> {
    last: &'a Lanes<S>,
    values: &'a mut Values<S>,
    committed: &'a [C; WIDTH],
    pending: &'a mut [C; WIDTH],
}

impl<S: InColumns, C: RootCounter<S> + Copy, const KIND: usize, const SUPPORT: usize> Task
    for RootLoop<'_, S, C, KIND, SUPPORT>
{
    /// Whether no number is NaN.
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let RootLoop { last, values, committed, pending } = self;
        let Values { mantissas, exponents } = values;
        each_lane::<S, C, KIND, SUPPORT>(last, mantissas, exponents, committed, pending)
    }
}

/// The body of the loop; outputs are separate arguments, as in that of a step.
#[inline(always)]
fn each_lane<S: InColumns, C: RootCounter<S> + Copy, const KIND: usize, const SUPPORT: usize>(
    last: &Lanes<S>,
    mantissas: &mut S::Columns<WIDTH>,
    exponents: &mut [i64; WIDTH],
    committed: &[C; WIDTH],
    pending: &mut [C; WIDTH],
) -> bool {
    let mut are_good = true;
    for lane in 0..WIDTH {
        let mut counter = committed[lane];
        let subspace = last.known(KINDS[KIND], lane, BranchFree::<S, false>);
        let value = subspace.at_root(Support::ALL[SUPPORT], &mut Unwrapped(&mut counter));
        pending[lane] = counter;
        let mantissa = value.mantissa().0;
        are_good &= !mantissa.size().is_nan();
        mantissa.put(mantissas, lane);
        exponents[lane] = value.exponent().saturating_add(i64::from(last.exponents[lane]));
    }
    are_good
}
