//! Connections of a block: the sum of several paths in each lane.

use crate::number::InColumns;
use crate::pass::block::WIDTH;
use crate::pass::block::counters::Counters;
use crate::pass::block::kinds::Kind;
use crate::pass::block::lane_ops::{FIXED, GUIDED, Hold, Join, Narrow, PINNED, Rescale, Widen, joined_fallback};
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::{
    GROUNDED, GROUNDED_TURN, LINE, LaneOp, PLANE, SPRING, SPRINGS, TURN, TURN_SPRING, act,
};
use crate::subspace::{NoCount, RootCounter};
use mstmm_plan::{Space, Support};

/// The connection of the inputs in some places, supports among them, to an output in the space `output`, as
/// [`connection`](crate::subspace::connecting::connection) gives it in each lane. Returns the place of the sum: one of the two
/// free places, or the place of an only path that does not change.
pub(crate) fn connection<S: InColumns, C: RootCounter<S> + Copy>(
    lanes: &mut [Lanes<S>],
    inputs: impl Iterator<Item = usize> + Clone,
    output: Option<Space>,
    free: [usize; 2],
    counters: &mut Counters<C>,
) -> usize {
    let no_count = &mut Counters::<NoCount>::new();
    let (mut first, mut joins) = (None, 0);
    let mut sum = Sum { lanes, free, place: free[0] };
    for path in inputs.clone() {
        if matches!(sum.lanes[path].kind, Kind::Tip(..)) {
            continue;
        }
        if first.is_some() {
            sum.join(path);
            joins += 1;
        } else {
            (first, sum.place) = (Some(path), path);
        }
    }
    if first.is_none() {
        // supports alone hold the output
        sum.lanes[free[0]].become_tip(Support::Free, output.unwrap_or(Space::Bending));
    } else if joins == 0 && !matches!(sum.kind(), Kind::Springs { .. } | Kind::Grounded(_)) {
        // springs are never shifted
        sum.act(&Rescale(()), no_count);
    }
    if sum.goes_on_otherwise(output) {
        sum.act(&Widen(output), no_count);
    }
    for input in inputs {
        match sum.lanes[input].kind {
            Kind::Tip(Support::Fixed, _) => sum.act(&Hold::<FIXED>, no_count),
            Kind::Tip(Support::Pinned, _) => sum.act(&Hold::<PINNED>, no_count),
            Kind::Tip(Support::Guided, _) => sum.act(&Hold::<GUIDED>, no_count),
            _ => {}
        }
    }
    if sum.goes_on_otherwise(output) {
        sum.act(&Narrow(output), counters);
    }
    sum.place
}

/// A sum of paths in a place; the result of an operation goes to a free place.
struct Sum<'a, S: InColumns> {
    lanes: &'a mut [Lanes<S>],
    free: [usize; 2],
    place: usize,
}

impl<S: InColumns> Sum<'_, S> {
    fn kind(&self) -> Kind {
        self.lanes[self.place].kind
    }

    /// Whether the connection goes on in another state.
    fn goes_on_otherwise(&self, output: Option<Space>) -> bool {
        output.is_some_and(|output| !output.is(self.kind().space()))
    }

    /// The free place for the next result.
    fn next(&self) -> usize {
        let [first, second] = self.free;
        if self.place == first { second } else { first }
    }

    /// Joins a path to the sum.
    fn join(&mut self, path: usize) {
        let to = self.next();
        if let Ok([sum, other, output]) = self.lanes.get_disjoint_mut([self.place, path, to]) {
            join(sum, other, output);
        }
        self.place = to;
    }

    /// Applies an operation to the sum.
    fn act<C: Copy, A: LaneOp<S, C>>(&mut self, task: &A, counters: &mut Counters<C>) {
        let to = self.next();
        if let Ok([sum, output]) = self.lanes.get_disjoint_mut([self.place, to]) {
            act(task, sum, output, counters);
        }
        self.place = to;
    }
}

/// Joins a path to another.
fn join<S: InColumns>(input: &Lanes<S>, other: &Lanes<S>, output: &mut Lanes<S>) {
    let no_count = &mut Counters::<NoCount>::new();
    match other.kind {
        Kind::Plane => act(&Join::<S, PLANE>(other), input, output, no_count),
        Kind::Line(Space::Translation) => act(&Join::<S, LINE>(other), input, output, no_count),
        Kind::Grounded(Space::Translation) => act(&Join::<S, GROUNDED>(other), input, output, no_count),
        Kind::Line(_) => act(&Join::<S, TURN>(other), input, output, no_count),
        Kind::Grounded(_) => act(&Join::<S, GROUNDED_TURN>(other), input, output, no_count),
        Kind::Springs { y: true, theta: true } => act(&Join::<S, SPRINGS>(other), input, output, no_count),
        Kind::Springs { y: true, .. } => act(&Join::<S, SPRING>(other), input, output, no_count),
        Kind::Springs { theta: true, .. } => act(&Join::<S, TURN_SPRING>(other), input, output, no_count),
        _ => {
            for lane in 0..WIDTH {
                let sum = joined_fallback(input.lane(lane), other.lane(lane));
                if lane == 0 {
                    output.begin(Kind::of(&sum));
                }
                output.set(lane, sum);
            }
        }
    }
}
