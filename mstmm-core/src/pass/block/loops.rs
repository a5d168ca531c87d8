//! Loops over the lanes: branch-free first, then alone for each lane in which branch-free formulas do not hold.

use crate::number::{BranchFree, Branches, InColumns};
use crate::pass::block::WIDTH;
use crate::pass::block::counters::Counters;
use crate::pass::block::kinds::{Kind, numbers};
use crate::pass::block::lanes::{Lanes, is_fit};
use crate::subspace::Subspace;
use mstmm_plan::{Space, Support};

/// An operation on the subspace of each lane.
pub(crate) trait LaneOp<S: InColumns, C>: BranchFreeOp<S, C, false> + BranchFreeOp<S, C, true> {
    /// Whether there are series for short waves.
    const HAS_SERIES: bool = false;

    /// The formulas that suit most lanes; `All` where no branch-free ones do.
    fn branches(&self) -> Branches {
        Branches::Waves
    }

    /// The kinds of subspaces that are worth a loop of their own, a bit for each of [`KINDS`].
    const SUITS: u32;

    /// The operation in a lane that is evaluated alone.
    fn fallback(&self, lane: usize, input: Subspace<S>, counter: &mut C) -> Subspace<S>;
}

/// An operation over branch-free numbers. Exponents of subspaces are left out, since they are only added.
pub(crate) trait BranchFreeOp<S: InColumns, C, const SERIES: bool>: Copy {
    /// The exponent of the other subspace, if there is one.
    #[inline(always)]
    fn other_exponent(&self, _lane: usize) -> i32 {
        0
    }

    /// The operation in one of many lanes. It and all functions that it calls are `#[inline(always)]`.
    fn straight(
        &self,
        lane: usize,
        input: Subspace<BranchFree<S, SERIES>>,
        counter: &mut C,
    ) -> Subspace<BranchFree<S, SERIES>>;
}

/// Kinds for which there are branch-free loops, by their number.
pub(crate) const KINDS: [Kind; 17] = {
    use Support::{Fixed, Free, Guided, Pinned};
    [
        Kind::Plane,
        Kind::OnPin,
        Kind::Tip(Fixed, Space::Bending),
        Kind::Tip(Pinned, Space::Bending),
        Kind::Tip(Guided, Space::Bending),
        Kind::Tip(Free, Space::Bending),
        Kind::Springs { y: true, theta: true },
        Kind::Springs { y: true, theta: false },
        Kind::Springs { y: false, theta: true },
        Kind::Line(Space::Translation),
        Kind::Grounded(Space::Translation),
        Kind::Tip(Fixed, Space::Translation),
        Kind::Tip(Free, Space::Translation),
        Kind::Line(Space::Rotation),
        Kind::Grounded(Space::Rotation),
        Kind::Tip(Fixed, Space::Rotation),
        Kind::Tip(Free, Space::Rotation),
    ]
};

/// The kinds of subspaces of a bending state; of a translation; of a rotation.
pub(crate) const BENDING: u32 = 0b1_1111_1111;
pub(crate) const TRANSLATION: u32 = 0b1111 << LINE;
pub(crate) const ROTATION: u32 = 0b1111 << TURN;

/// The numbers of some kinds.
pub(crate) const PLANE: usize = 0;
pub(crate) const SPRINGS: usize = 6;
pub(crate) const SPRING: usize = 7;
pub(crate) const TURN_SPRING: usize = 8;
pub(crate) const LINE: usize = 9;
pub(crate) const GROUNDED: usize = 10;
pub(crate) const TURN: usize = 13;
pub(crate) const GROUNDED_TURN: usize = 14;

/// The number of a kind in [`KINDS`], without a search, which would take as long as the loop.
#[inline]
fn kind_of(kind: Kind) -> Option<usize> {
    use Support::{Fixed, Free, Guided, Pinned};
    let behind_bending_tip = |support| match support {
        Fixed => Some(2),
        Pinned => Some(3),
        Guided => Some(4),
        Free => Some(5),
        Support::Roller => None,
    };
    let of_path = |place: usize, space| match space {
        Space::Translation => Some(LINE + place),
        Space::Rotation => Some(TURN + place),
        _ => None,
    };
    match kind {
        Kind::Plane => Some(PLANE),
        Kind::OnPin => Some(1),
        Kind::Tip(support, Space::Bending) => behind_bending_tip(support),
        Kind::Springs { y: true, theta: true } => Some(SPRINGS),
        Kind::Springs { y: true, theta: false } => Some(SPRING),
        Kind::Springs { y: false, theta: true } => Some(TURN_SPRING),
        Kind::Springs { y: false, theta: false } => None,
        Kind::Line(space) => of_path(0, space),
        Kind::Grounded(space) => of_path(1, space),
        Kind::Tip(Fixed, space) => of_path(2, space),
        Kind::Tip(Free, space) => of_path(3, space),
        Kind::Tip(..) => None,
    }
}

/// Applies an operation to all lanes.
pub(crate) fn act<S: InColumns, C: Copy, A: LaneOp<S, C>>(
    act: &A,
    input: &Lanes<S>,
    output: &mut Lanes<S>,
    counters: &mut Counters<C>,
) {
    match act.branches() {
        _ if !input.is_fit => fallback_everywhere::<S, C, A>(act, input, output, counters),
        Branches::All => fallback_everywhere::<S, C, A>(act, input, output, counters),
        Branches::Waves => in_straight_line::<S, C, A, false>(act, input, output, counters),
        Branches::Series if const { A::HAS_SERIES } => in_straight_line::<S, C, A, true>(act, input, output, counters),
        Branches::Series => fallback_everywhere::<S, C, A>(act, input, output, counters),
    }
}

fn in_straight_line<S: InColumns, C: Copy, A: LaneOp<S, C> + BranchFreeOp<S, C, SERIES>, const SERIES: bool>(
    act: &A,
    input: &Lanes<S>,
    output: &mut Lanes<S>,
    counters: &mut Counters<C>,
) {
    macro_rules! kinds {
        ($($kind:literal)*) => {
            match kind_of(input.kind) {
                $(Some($kind) if const { A::SUITS >> $kind & 1 == 1 } => {
                    straight::<S, C, A, SERIES, $kind>(act, input, output, counters)
                })*
                _ => fallback_everywhere::<S, C, A>(act, input, output, counters),
            }
        };
    }
    kinds!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);
}

fn fallback_everywhere<S: InColumns, C: Copy, A: LaneOp<S, C>>(
    act: &A,
    input: &Lanes<S>,
    output: &mut Lanes<S>,
    counters: &mut Counters<C>,
) {
    for (lane, counter) in counters.committed_mut().iter_mut().enumerate() {
        let subspace = act.fallback(lane, input.lane(lane), counter);
        if lane == 0 {
            output.begin(Kind::of(&subspace));
        }
        output.set(lane, subspace);
    }
}

fn straight<
    S: InColumns,
    C: Copy,
    A: LaneOp<S, C> + BranchFreeOp<S, C, SERIES>,
    const SERIES: bool,
    const KIND: usize,
>(
    act: &A,
    input: &Lanes<S>,
    output: &mut Lanes<S>,
    counters: &mut Counters<C>,
) {
    let (committed, pending) = counters.both();
    let are_good = widest(BranchFreeLoop::<S, C, A, SERIES, KIND> { act, input, output, committed, pending });
    if !are_good {
        for lane in 0..WIDTH {
            if !is_fit(&output.lane(lane)) {
                pending[lane] = committed[lane];
                output.set(lane, act.fallback(lane, input.lane(lane), &mut pending[lane]));
            }
        }
    }
    counters.commit();
}

/// A branch-free loop.
struct BranchFreeLoop<'a, S: InColumns, C, A, const SERIES: bool, const KIND: usize> {
    act: &'a A,
    input: &'a Lanes<S>,
    output: &'a mut Lanes<S>,
    committed: &'a [C; WIDTH],
    pending: &'a mut [C; WIDTH],
}

impl<S: InColumns, C: Copy, A: BranchFreeOp<S, C, SERIES>, const SERIES: bool, const KIND: usize> Task
    for BranchFreeLoop<'_, S, C, A, SERIES, KIND>
{
    /// Whether no number is NaN.
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let BranchFreeLoop { act, input, output, committed, pending } = self;
        let mut unused = committed[0];
        let first = act.straight(0, input.known(KINDS[KIND], 0, BranchFree::<S, SERIES>), &mut unused);
        output.begin(Kind::of(&first));
        let Lanes { columns, exponents, .. } = output;
        let are_good = each_lane::<S, C, A, SERIES, KIND>(*act, input, columns, exponents, committed, pending);
        add_exponents::<S, C, A, SERIES>(*act, input, exponents);
        are_good
    }
}

/// Adds the exponents of the subspaces that took part. `exponents` is a separate argument, as in [`each_lane`].
#[inline(always)]
fn add_exponents<S: InColumns, C, A: BranchFreeOp<S, C, SERIES>, const SERIES: bool>(
    act: A,
    input: &Lanes<S>,
    exponents: &mut [i32; WIDTH],
) {
    for (lane, exponent) in exponents.iter_mut().enumerate() {
        let before = input.exponents[lane].saturating_add(act.other_exponent(lane));
        *exponent = exponent.saturating_add(before);
    }
}

/// The body of a branch-free loop; exponents are those that the operation adds. Outputs are separate arguments, so that the
/// compiler knows that they do not overlap.
#[inline(always)]
fn each_lane<S: InColumns, C: Copy, A: BranchFreeOp<S, C, SERIES>, const SERIES: bool, const KIND: usize>(
    act: A,
    input: &Lanes<S>,
    columns: &mut [S::Columns<WIDTH>; 5],
    own_exponents: &mut [i32; WIDTH],
    committed: &[C; WIDTH],
    pending: &mut [C; WIDTH],
) -> bool {
    let mut are_good = true;
    for lane in 0..WIDTH {
        let before = input.known(KINDS[KIND], lane, BranchFree::<S, SERIES>);
        let mut counter = committed[lane];
        let after = act.straight(lane, before, &mut counter);
        pending[lane] = counter;
        are_good &= is_fit(&after);
        let used = Kind::of(&after).columns();
        let (entries, exponent) = numbers(after);
        for column in 0..5 {
            if column < used {
                entries[column].0.put(&mut columns[column], lane);
            }
        }
        own_exponents[lane] = exponent;
    }
    are_good
}

#[cfg(feature = "std")]
pub(crate) use mstmm_lanes::{Task, run as widest};

/// A loop. Without `std` the instruction sets of the machine cannot be detected.
#[cfg(not(feature = "std"))]
pub(crate) trait Task {
    /// The result of the loop.
    type Output;
    /// Runs the loop.
    fn run(self) -> Self::Output;
}

#[cfg(not(feature = "std"))]
pub(crate) fn widest<L: Task>(task: L) -> L::Output {
    task.run()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_have_the_numbers_of_their_places() {
        for (number, kind) in KINDS.into_iter().enumerate() {
            assert_eq!(kind_of(kind), Some(number), "{kind:?}");
        }
        assert_eq!(KINDS[LINE], Kind::Line(Space::Translation));
        assert_eq!(KINDS[GROUNDED_TURN], Kind::Grounded(Space::Rotation));
        assert_eq!(kind_of(Kind::Springs { y: false, theta: false }), None);
    }
}
