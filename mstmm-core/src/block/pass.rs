//! The plane method over a block: a walker that keeps what is open in columns.

use super::acts::{FIXED, GUIDED, Hold, Join, Moderate, Narrow, PINNED, Through, Widen};
use super::lanes::{Frequencies, Lanes};
use super::loops::{Act, GROUNDED, GROUNDED_TURN, LINE, PLANE, SPRING, SPRINGS, TURN, TURN_SPRING, Task, act, widest};
use super::root::{Values, at_root};
use super::shapes::Shape;
use super::tally::Tallies;
use super::walk::{Walk, Walker};
use super::{Straight, WIDTH};
use crate::at::At;
use crate::count::{Tally, Untallied};
use crate::element::PlaneStep;
use crate::join::{joined, moderated};
use crate::scalar::{Frequency, InColumns};
use crate::state::{Space, Support};
use core::marker::PhantomData;

/// Paths that may be open at once: branches within branches.
const OPEN: usize = 12;

/// The pass at the frequencies of a block.
pub(super) struct BlockPass<S: InColumns, C> {
    at: Frequencies<S>,
    /// What is open in the first places, what is being made in the next.
    lanes: [Lanes<S>; OPEN + 1],
    /// Where each open path is; behind them the free places.
    places: [usize; OPEN + 1],
    open: usize,
    /// Whether too many paths were open, or lanes differ in kind.
    is_lost: bool,
    pub(super) tallies: Tallies<C>,
    pub(super) values: Values<S>,
}

/// The powers of frequencies, in straight-line code.
struct Powers<'a, S: InColumns, T> {
    of: &'a [S; WIDTH],
    to: &'a mut Frequencies<S>,
    parameter: PhantomData<T>,
}

impl<T, S: Frequency<T> + InColumns> Task for Powers<'_, S, T>
where
    Straight<S, false>: Frequency<T>,
{
    /// Whether all frequencies have a root in straight-line code.
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let mut are_good = true;
        for lane in 0..WIDTH {
            let at = At::new::<T>(Straight::<S, false>(self.of[lane]), true);
            are_good &= !at.powers[0].0.size().is_nan();
            self.to.set(lane, at, |number| number.0);
        }
        are_good
    }
}

impl<S: InColumns, C: Tally<S> + Copy + Default> BlockPass<S, C> {
    /// Room for passes, one after the other.
    pub(super) fn new() -> Self {
        BlockPass {
            at: Frequencies::new(),
            lanes: [Lanes::new(); OPEN + 1],
            places: core::array::from_fn(|place| place),
            open: 0,
            is_lost: false,
            tallies: Tallies::new(),
            values: Values::new(),
        }
    }

    /// Δ at the frequencies of a block, and what the tallies hear; the last frequency fills the lanes that remain. Returns whether
    /// there were any, and no more paths open at once than there is room for.
    pub(super) fn run<T, Y>(&mut self, system: &Y, frequencies: &[S]) -> bool
    where
        S: Frequency<T> + InColumns,
        Straight<S, false>: Frequency<T>,
        Y: Walk<S> + ?Sized,
    {
        let Some(&last) = frequencies.last() else { return false };
        let filled: [S; WIDTH];
        let all = match frequencies.first_chunk() {
            Some(all) => all,
            None => {
                filled = core::array::from_fn(|lane| frequencies.get(lane).copied().unwrap_or(last));
                &filled
            }
        };
        if !widest(Powers::<S, T> { of: all, to: &mut self.at, parameter: PhantomData }) {
            self.take_roots_alone::<T>(all);
        }
        (self.open, self.is_lost) = (0, false);
        self.tallies.heard_mut().fill(C::default());
        system.walk(self);
        !self.is_lost
    }

    /// Sets the frequencies of which straight-line code has no root.
    #[cold]
    fn take_roots_alone<T>(&mut self, all: &[S; WIDTH])
    where
        S: Frequency<T>,
    {
        for (lane, &x) in all.iter().enumerate() {
            if self.at.lane(lane, |number| number).powers[0].size().is_nan() {
                self.at.set(lane, At::new::<T>(x, true), |number| number);
            }
        }
    }

    /// Acts on the last open path; nobody counts.
    fn act<A: Act<S, Untallied>>(&mut self, task: &A) {
        act_on_last(task, &mut self.lanes, &mut self.places, self.open, &mut Tallies::new());
    }

    /// The same, heard by the tallies.
    fn act_heard<A: Act<S, C>>(&mut self, task: &A) {
        act_on_last(task, &mut self.lanes, &mut self.places, self.open, &mut self.tallies);
    }
}

/// Acts on the last of the open paths.
fn act_on_last<S: InColumns, C: Copy, A: Act<S, C>>(
    task: &A,
    lanes: &mut [Lanes<S>; OPEN + 1],
    places: &mut [usize; OPEN + 1],
    open: usize,
    tallies: &mut Tallies<C>,
) {
    let [top, free] = [places[open - 1], places[open]];
    let Ok([input, output]) = lanes.get_disjoint_mut([top, free]) else { return };
    act(task, input, output, tallies);
    places.swap(open - 1, open);
}

impl<S: InColumns, C: Tally<S> + Copy + Default> Walker<S> for BlockPass<S, C> {
    fn tip(&mut self, support: Support, space: Space) {
        self.is_lost |= self.open == OPEN;
        if !self.is_lost {
            self.lanes[self.places[self.open]].become_tip(support, space);
            self.open += 1;
        }
    }

    fn element<E>(&mut self, built: &E::Built)
    where
        E: PlaneStep<S> + PlaneStep<Straight<S, false>> + PlaneStep<Straight<S, true>>,
    {
        if !self.is_lost {
            let through = Through::<E, S> { built, at: &self.at };
            act_on_last(&through, &mut self.lanes, &mut self.places, self.open, &mut self.tallies);
            self.is_lost |= !self.lanes[self.places[self.open - 1]].is_uniform;
        }
    }

    fn connection(&mut self, inputs: &[usize], output: Option<Space>) {
        if self.is_lost {
            return;
        }
        let top = self.open;
        let mut spare = self.places[top];
        let (mut sum, mut paths) = (None, 0);
        let (mut supports, mut held) = ([Support::Free; OPEN], 0);
        for &input in inputs {
            let path = self.places[top - 1 - input];
            self.is_lost |= !self.lanes[path].is_uniform;
            match (self.lanes[path].shape, sum) {
                (Shape::Tip(support, _), _) => {
                    supports[held] = support;
                    held += 1;
                    continue;
                }
                (_, None) => sum = Some(path),
                (_, Some(first)) => {
                    self.join(first, path, spare);
                    (sum, spare) = (Some(spare), first);
                }
            }
            paths += 1;
        }
        // what is left of the inputs is free again
        let base = top - inputs.len();
        let sum = sum.unwrap_or_else(|| {
            // supports alone hold what goes on
            self.lanes[spare].become_tip(Support::Free, output.unwrap_or(Space::Bending));
            spare
        });
        if let Some(place) = self.places[base..=top].iter().position(|place| *place == sum) {
            self.places.swap(base, base + place);
        }
        self.open = base + 1;
        // springs are never shifted
        if paths == 1 && matches!(self.lanes[sum].shape, Shape::Plane | Shape::OnPin | Shape::Line(_)) {
            self.act(&Moderate(()));
        }
        self.go_on(&supports[..held], output);
    }

    fn root(&mut self, support: Support) {
        if self.is_lost {
            return;
        }
        let last = &self.lanes[self.places[self.open - 1]];
        at_root(last, support, &mut self.tallies, &mut self.values);
    }
}

impl<S: InColumns, C: Tally<S> + Copy + Default> BlockPass<S, C> {
    /// Joins a path to another.
    fn join(&mut self, first: usize, path: usize, to: usize) {
        let Ok([input, other, output]) = self.lanes.get_disjoint_mut([first, path, to]) else { return };
        let (input, other): (&_, &_) = (input, other);
        let tallies = &mut Tallies::new();
        match other.shape {
            Shape::Plane => act(&Join::<S, PLANE>(other), input, output, tallies),
            Shape::Line(Space::Translation) => act(&Join::<S, LINE>(other), input, output, tallies),
            Shape::Grounded(Space::Translation) => act(&Join::<S, GROUNDED>(other), input, output, tallies),
            Shape::Line(_) => act(&Join::<S, TURN>(other), input, output, tallies),
            Shape::Grounded(_) => act(&Join::<S, GROUNDED_TURN>(other), input, output, tallies),
            Shape::Springs { y: true, theta: true } => act(&Join::<S, SPRINGS>(other), input, output, tallies),
            Shape::Springs { y: true, .. } => act(&Join::<S, SPRING>(other), input, output, tallies),
            Shape::Springs { theta: true, .. } => act(&Join::<S, TURN_SPRING>(other), input, output, tallies),
            _ => {
                for lane in 0..WIDTH {
                    let sum = joined(moderated(input.lane(lane)), moderated(other.lane(lane)));
                    if lane == 0 {
                        output.begin(Shape::of(&sum));
                    }
                    output.set(lane, sum);
                }
            }
        }
    }

    /// The end of a connection: the sum is widened, held by supports, and narrowed.
    fn go_on(&mut self, supports: &[Support], output: Option<Space>) {
        let own = self.lanes[self.places[self.open - 1]].shape.space();
        if output.is_some_and(|output| !output.is(own)) {
            self.act(&Widen(output));
        }
        for support in supports {
            match *support {
                Support::Fixed => self.act(&Hold::<FIXED>),
                Support::Pinned => self.act(&Hold::<PINNED>),
                Support::Guided => self.act(&Hold::<GUIDED>),
                Support::Free | Support::Roller => {}
            }
        }
        let own = self.lanes[self.places[self.open - 1]].shape.space();
        if output.is_some_and(|output| !output.is(own)) {
            self.act_heard(&Narrow(output));
        }
    }
}
