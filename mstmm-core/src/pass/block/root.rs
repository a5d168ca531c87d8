//! Δ in each lane: the last subspaces meet the root.

use crate::model::state::{Space, Support};
use crate::number::branch_free::Straight;
use crate::number::columns::InColumns;
use crate::number::scaled::Scaled;
use crate::pass::block::WIDTH;
use crate::pass::block::counters::{Plainly, Tallies};
use crate::pass::block::kinds::Shape;
use crate::pass::block::lane_ops::{FIXED, FREE, GUIDED, PINNED, SUPPORTS};
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::{KINDS, LINE, PLANE, TURN, Task, widest};
use crate::subspace::count::Tally;

/// A number with an exponent of its own in each lane.
pub(crate) struct Values<S: InColumns> {
    mantissas: S::Columns<WIDTH>,
    exponents: [i64; WIDTH],
}

impl<S: InColumns> Values<S> {
    /// Room for them.
    pub(crate) fn new() -> Self {
        Values { mantissas: S::zero().columns(), exponents: [0; WIDTH] }
    }

    /// That in a lane.
    #[inline(always)]
    pub(crate) fn lane(&self, lane: usize) -> Scaled<S> {
        Scaled::normalised(S::get(&self.mantissas, lane), self.exponents[lane])
    }

    fn set(&mut self, lane: usize, value: Scaled<S>) {
        value.mantissa().put(&mut self.mantissas, lane);
        self.exponents[lane] = value.exponent();
    }
}

/// Δ where the last subspaces meet the support of the root; planes and lines of any range, since nothing is multiplied.
pub(crate) fn at_root<S: InColumns, C: Tally<S> + Copy>(
    last: &Lanes<S>,
    support: Support,
    tallies: &mut Tallies<C>,
    values: &mut Values<S>,
) {
    match (last.shape, support) {
        (Shape::Plane, Support::Fixed) => straight::<S, C, PLANE, FIXED>(last, tallies, values),
        (Shape::Plane, Support::Pinned) => straight::<S, C, PLANE, PINNED>(last, tallies, values),
        (Shape::Plane, Support::Guided) => straight::<S, C, PLANE, GUIDED>(last, tallies, values),
        (Shape::Plane, Support::Free) => straight::<S, C, PLANE, FREE>(last, tallies, values),
        (Shape::Line(Space::Translation), Support::Fixed) => straight::<S, C, LINE, FIXED>(last, tallies, values),
        (Shape::Line(Space::Translation), Support::Free) => straight::<S, C, LINE, FREE>(last, tallies, values),
        (Shape::Line(Space::Rotation), Support::Fixed) => straight::<S, C, TURN, FIXED>(last, tallies, values),
        (Shape::Line(Space::Rotation), Support::Free) => straight::<S, C, TURN, FREE>(last, tallies, values),
        _ => alone_everywhere(last, support, tallies, values),
    }
}

fn alone_everywhere<S: InColumns, C: Tally<S>>(
    last: &Lanes<S>,
    support: Support,
    tallies: &mut Tallies<C>,
    values: &mut Values<S>,
) {
    for (lane, tally) in tallies.heard_mut().iter_mut().enumerate() {
        values.set(lane, last.lane(lane).at_root(support, tally));
    }
}

fn straight<S: InColumns, C: Tally<S> + Copy, const KIND: usize, const SUPPORT: usize>(
    last: &Lanes<S>,
    tallies: &mut Tallies<C>,
    values: &mut Values<S>,
) {
    let (heard, hearing) = tallies.both();
    let are_good = widest(RootLoop::<S, C, KIND, SUPPORT> { last, values, heard, hearing });
    if !are_good {
        for lane in 0..WIDTH {
            if S::get(&values.mantissas, lane).size().is_nan() {
                hearing[lane] = heard[lane];
                values.set(lane, last.lane(lane).at_root(SUPPORTS[SUPPORT], &mut hearing[lane]));
            }
        }
    }
    tallies.have_heard();
}

/// The loop in straight-line code.
struct RootLoop<'a, S: InColumns, C, const KIND: usize, const SUPPORT: usize> {
    last: &'a Lanes<S>,
    values: &'a mut Values<S>,
    heard: &'a [C; WIDTH],
    hearing: &'a mut [C; WIDTH],
}

impl<S: InColumns, C: Tally<S> + Copy, const KIND: usize, const SUPPORT: usize> Task
    for RootLoop<'_, S, C, KIND, SUPPORT>
{
    /// Whether no number is NaN.
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let RootLoop { last, values, heard, hearing } = self;
        let Values { mantissas, exponents } = values;
        each_lane::<S, C, KIND, SUPPORT>(last, mantissas, exponents, heard, hearing)
    }
}

/// The loop itself; what it writes are arguments of their own, as in that of a step.
#[inline(always)]
fn each_lane<S: InColumns, C: Tally<S> + Copy, const KIND: usize, const SUPPORT: usize>(
    last: &Lanes<S>,
    mantissas: &mut S::Columns<WIDTH>,
    exponents: &mut [i64; WIDTH],
    heard: &[C; WIDTH],
    hearing: &mut [C; WIDTH],
) -> bool {
    let mut are_good = true;
    for lane in 0..WIDTH {
        let mut tally = heard[lane];
        let subspace = last.known(KINDS[KIND], lane, Straight::<S, false>);
        let value = subspace.at_root(SUPPORTS[SUPPORT], &mut Plainly(&mut tally));
        hearing[lane] = tally;
        let mantissa = value.mantissa().0;
        are_good &= !mantissa.size().is_nan();
        mantissa.put(mantissas, lane);
        exponents[lane] = value.exponent().saturating_add(i64::from(last.exponents[lane]));
    }
    are_good
}
