//! Connections of a block: the sum of several paths in each lane.

use crate::model::state::{Space, Support};
use crate::number::columns::InColumns;
use crate::pass::block::WIDTH;
use crate::pass::block::counters::Tallies;
use crate::pass::block::kinds::Shape;
use crate::pass::block::lane_ops::{FIXED, GUIDED, Hold, Join, Moderate, Narrow, PINNED, Widen, joined_alone};
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::{Act, GROUNDED, GROUNDED_TURN, LINE, PLANE, SPRING, SPRINGS, TURN, TURN_SPRING, act};
use crate::subspace::count::{Tally, Untallied};

/// The connection of the inputs in some places, supports among them, to an output that goes on as `output`: what
/// [`connection`](crate::subspace::minors::join::connection) does in each lane. Returns the place of the sum: one of the two free ones, or that of
/// the only path where nothing is done to it.
pub(crate) fn connection<S: InColumns, C: Tally<S> + Copy>(
    lanes: &mut [Lanes<S>],
    inputs: impl Iterator<Item = usize> + Clone,
    output: Option<Space>,
    free: [usize; 2],
    tallies: &mut Tallies<C>,
) -> usize {
    let nobody = &mut Tallies::<Untallied>::new();
    let (mut first, mut joins) = (None, 0);
    let mut sum = Sum { lanes, free, place: free[0] };
    for path in inputs.clone() {
        if matches!(sum.lanes[path].shape, Shape::Tip(..)) {
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
        // supports alone hold what goes on
        sum.lanes[free[0]].become_tip(Support::Free, output.unwrap_or(Space::Bending));
    } else if joins == 0 && !matches!(sum.shape(), Shape::Springs { .. } | Shape::Grounded(_)) {
        // springs are never shifted
        sum.act(&Moderate(()), nobody);
    }
    if sum.goes_on_otherwise(output) {
        sum.act(&Widen(output), nobody);
    }
    for input in inputs {
        match sum.lanes[input].shape {
            Shape::Tip(Support::Fixed, _) => sum.act(&Hold::<FIXED>, nobody),
            Shape::Tip(Support::Pinned, _) => sum.act(&Hold::<PINNED>, nobody),
            Shape::Tip(Support::Guided, _) => sum.act(&Hold::<GUIDED>, nobody),
            _ => {}
        }
    }
    if sum.goes_on_otherwise(output) {
        sum.act(&Narrow(output), tallies);
    }
    sum.place
}

/// A sum of paths, in a place; what is done to it goes to a free one.
struct Sum<'a, S: InColumns> {
    lanes: &'a mut [Lanes<S>],
    free: [usize; 2],
    place: usize,
}

impl<S: InColumns> Sum<'_, S> {
    fn shape(&self) -> Shape {
        self.lanes[self.place].shape
    }

    /// Whether the connection goes on in another state.
    fn goes_on_otherwise(&self, output: Option<Space>) -> bool {
        output.is_some_and(|output| !output.is(self.shape().space()))
    }

    /// The free place in which it is not.
    fn next(&self) -> usize {
        let [first, second] = self.free;
        if self.place == first { second } else { first }
    }

    /// Joins a path.
    fn join(&mut self, path: usize) {
        let to = self.next();
        if let Ok([sum, other, output]) = self.lanes.get_disjoint_mut([self.place, path, to]) {
            join(sum, other, output);
        }
        self.place = to;
    }

    /// Acts on it.
    fn act<C: Copy, A: Act<S, C>>(&mut self, task: &A, tallies: &mut Tallies<C>) {
        let to = self.next();
        if let Ok([sum, output]) = self.lanes.get_disjoint_mut([self.place, to]) {
            act(task, sum, output, tallies);
        }
        self.place = to;
    }
}

/// Joins a path to another.
fn join<S: InColumns>(input: &Lanes<S>, other: &Lanes<S>, output: &mut Lanes<S>) {
    let nobody = &mut Tallies::<Untallied>::new();
    match other.shape {
        Shape::Plane => act(&Join::<S, PLANE>(other), input, output, nobody),
        Shape::Line(Space::Translation) => act(&Join::<S, LINE>(other), input, output, nobody),
        Shape::Grounded(Space::Translation) => act(&Join::<S, GROUNDED>(other), input, output, nobody),
        Shape::Line(_) => act(&Join::<S, TURN>(other), input, output, nobody),
        Shape::Grounded(_) => act(&Join::<S, GROUNDED_TURN>(other), input, output, nobody),
        Shape::Springs { y: true, theta: true } => act(&Join::<S, SPRINGS>(other), input, output, nobody),
        Shape::Springs { y: true, .. } => act(&Join::<S, SPRING>(other), input, output, nobody),
        Shape::Springs { theta: true, .. } => act(&Join::<S, TURN_SPRING>(other), input, output, nobody),
        _ => {
            for lane in 0..WIDTH {
                let sum = joined_alone(input.lane(lane), other.lane(lane));
                if lane == 0 {
                    output.begin(Shape::of(&sum));
                }
                output.set(lane, sum);
            }
        }
    }
}
