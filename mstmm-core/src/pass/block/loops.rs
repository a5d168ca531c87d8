//! Loops over the lanes: in straight-line code first, then alone for each lane in which that does not hold.

use crate::model::state::{Space, Support};
use crate::number::branch_free::Straight;
use crate::number::columns::InColumns;
use crate::number::scalar::Branches;
use crate::pass::block::WIDTH;
use crate::pass::block::counters::Tallies;
use crate::pass::block::kinds::{Shape, numbers};
use crate::pass::block::lanes::{Lanes, is_fit};
use crate::subspace::minors::subspace::Subspace;

/// What is done to the subspace of each lane.
pub(crate) trait Act<S: InColumns, C>: Straightly<S, C, false> + Straightly<S, C, true> {
    /// Whether there are series for short waves.
    const HAS_SERIES: bool = false;

    /// Which formulas suit most lanes; `All` where none of straight-line code does.
    fn branches(&self) -> Branches {
        Branches::Waves
    }

    /// The kinds of subspaces that are worth a loop of their own, a bit for each of [`KINDS`].
    const SUITS: u32;

    /// In a lane of its own.
    fn alone(&self, lane: usize, input: Subspace<S>, tally: &mut C) -> Subspace<S>;
}

/// The same in straight-line code, on subspaces whose exponents are left out: all that is done to them is to add others.
pub(crate) trait Straightly<S: InColumns, C, const SERIES: bool>: Copy {
    /// The exponent of what else takes part.
    #[inline(always)]
    fn other_exponent(&self, _lane: usize) -> i32 {
        0
    }

    /// In one of many lanes: marked `#[inline(always)]`, as all that it calls.
    fn straight(
        &self,
        lane: usize,
        input: Subspace<Straight<S, SERIES>>,
        tally: &mut C,
    ) -> Subspace<Straight<S, SERIES>>;
}

/// Kinds for which there are loops in straight-line code, by their number.
pub(crate) const KINDS: [Shape; 17] = {
    use Space::{Bending, Rotation, Translation};
    use Support::{Fixed, Free, Guided, Pinned};
    [
        Shape::Plane,
        Shape::OnPin,
        Shape::Tip(Fixed, Bending),
        Shape::Tip(Pinned, Bending),
        Shape::Tip(Guided, Bending),
        Shape::Tip(Free, Bending),
        Shape::Springs { y: true, theta: true },
        Shape::Springs { y: true, theta: false },
        Shape::Springs { y: false, theta: true },
        Shape::Line(Translation),
        Shape::Grounded(Translation),
        Shape::Tip(Fixed, Translation),
        Shape::Tip(Free, Translation),
        Shape::Line(Rotation),
        Shape::Grounded(Rotation),
        Shape::Tip(Fixed, Rotation),
        Shape::Tip(Free, Rotation),
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

/// The number of a kind in [`KINDS`]; not a search, which would take as long as the loop.
#[inline]
fn kind_of(shape: Shape) -> Option<usize> {
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
        Space::Bending | Space::Planar => None,
    };
    match shape {
        Shape::Plane => Some(PLANE),
        Shape::OnPin => Some(1),
        Shape::Tip(support, Space::Bending) => behind_bending_tip(support),
        Shape::Springs { y: true, theta: true } => Some(SPRINGS),
        Shape::Springs { y: true, theta: false } => Some(SPRING),
        Shape::Springs { y: false, theta: true } => Some(TURN_SPRING),
        Shape::Springs { y: false, theta: false } => None,
        Shape::Line(space) => of_path(0, space),
        Shape::Grounded(space) => of_path(1, space),
        Shape::Tip(Fixed, space) => of_path(2, space),
        Shape::Tip(Free, space) => of_path(3, space),
        Shape::Tip(..) => None,
    }
}

/// Acts on all lanes.
pub(crate) fn act<S: InColumns, C: Copy, A: Act<S, C>>(
    act: &A,
    input: &Lanes<S>,
    output: &mut Lanes<S>,
    tallies: &mut Tallies<C>,
) {
    match act.branches() {
        _ if !input.is_fit => alone_everywhere::<S, C, A>(act, input, output, tallies),
        Branches::All => alone_everywhere::<S, C, A>(act, input, output, tallies),
        Branches::Waves => in_straight_line::<S, C, A, false>(act, input, output, tallies),
        Branches::Series if const { A::HAS_SERIES } => in_straight_line::<S, C, A, true>(act, input, output, tallies),
        Branches::Series => alone_everywhere::<S, C, A>(act, input, output, tallies),
    }
}

fn in_straight_line<S: InColumns, C: Copy, A: Act<S, C> + Straightly<S, C, SERIES>, const SERIES: bool>(
    act: &A,
    input: &Lanes<S>,
    output: &mut Lanes<S>,
    tallies: &mut Tallies<C>,
) {
    macro_rules! kinds {
        ($($kind:literal)*) => {
            match kind_of(input.shape) {
                $(Some($kind) if const { A::SUITS >> $kind & 1 == 1 } => {
                    straight::<S, C, A, SERIES, $kind>(act, input, output, tallies)
                })*
                _ => alone_everywhere::<S, C, A>(act, input, output, tallies),
            }
        };
    }
    kinds!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);
}

fn alone_everywhere<S: InColumns, C: Copy, A: Act<S, C>>(
    act: &A,
    input: &Lanes<S>,
    output: &mut Lanes<S>,
    tallies: &mut Tallies<C>,
) {
    for (lane, tally) in tallies.heard_mut().iter_mut().enumerate() {
        let subspace = act.alone(lane, input.lane(lane), tally);
        if lane == 0 {
            output.begin(Shape::of(&subspace));
        }
        output.set(lane, subspace);
    }
}

fn straight<S: InColumns, C: Copy, A: Act<S, C> + Straightly<S, C, SERIES>, const SERIES: bool, const KIND: usize>(
    act: &A,
    input: &Lanes<S>,
    output: &mut Lanes<S>,
    tallies: &mut Tallies<C>,
) {
    let (heard, hearing) = tallies.both();
    let are_good = widest(StraightLoop::<S, C, A, SERIES, KIND> { act, input, output, heard, hearing });
    if !are_good {
        for lane in 0..WIDTH {
            if !is_fit(&output.lane(lane)) {
                hearing[lane] = heard[lane];
                output.set(lane, act.alone(lane, input.lane(lane), &mut hearing[lane]));
            }
        }
    }
    tallies.have_heard();
}

/// A loop in straight-line code.
struct StraightLoop<'a, S: InColumns, C, A, const SERIES: bool, const KIND: usize> {
    act: &'a A,
    input: &'a Lanes<S>,
    output: &'a mut Lanes<S>,
    heard: &'a [C; WIDTH],
    hearing: &'a mut [C; WIDTH],
}

impl<S: InColumns, C: Copy, A: Straightly<S, C, SERIES>, const SERIES: bool, const KIND: usize> Task
    for StraightLoop<'_, S, C, A, SERIES, KIND>
{
    /// Whether no number is NaN.
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let StraightLoop { act, input, output, heard, hearing } = self;
        let mut unheard = heard[0];
        let first = act.straight(0, input.known(KINDS[KIND], 0, Straight::<S, SERIES>), &mut unheard);
        output.begin(Shape::of(&first));
        let Lanes { columns, exponents, .. } = output;
        let are_good = each_lane::<S, C, A, SERIES, KIND>(*act, input, columns, exponents, heard, hearing);
        add_exponents::<S, C, A, SERIES>(*act, input, exponents);
        are_good
    }
}

/// Adds the exponents of what took part; what it writes is an argument of its own.
#[inline(always)]
fn add_exponents<S: InColumns, C, A: Straightly<S, C, SERIES>, const SERIES: bool>(
    act: A,
    input: &Lanes<S>,
    exponents: &mut [i32; WIDTH],
) {
    for (lane, exponent) in exponents.iter_mut().enumerate() {
        let before = input.exponents[lane].saturating_add(act.other_exponent(lane));
        *exponent = exponent.saturating_add(before);
    }
}

/// The loop itself, in which exponents are those that the act adds. What it writes are arguments of their own: then the compiler
/// knows that they are apart.
#[inline(always)]
fn each_lane<S: InColumns, C: Copy, A: Straightly<S, C, SERIES>, const SERIES: bool, const KIND: usize>(
    act: A,
    input: &Lanes<S>,
    columns: &mut [S::Columns<WIDTH>; 5],
    own_exponents: &mut [i32; WIDTH],
    heard: &[C; WIDTH],
    hearing: &mut [C; WIDTH],
) -> bool {
    let mut are_good = true;
    for lane in 0..WIDTH {
        let before = input.known(KINDS[KIND], lane, Straight::<S, SERIES>);
        let mut tally = heard[lane];
        let after = act.straight(lane, before, &mut tally);
        hearing[lane] = tally;
        are_good &= is_fit(&after);
        let used = Shape::of(&after).columns();
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

/// A loop; without `std` nobody can ask for the instruction sets of the machine.
#[cfg(not(feature = "std"))]
pub(crate) trait Task {
    /// What comes of it.
    type Output;
    /// Runs it.
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
        for (number, shape) in KINDS.into_iter().enumerate() {
            assert_eq!(kind_of(shape), Some(number), "{shape:?}");
        }
        assert_eq!(KINDS[LINE], Shape::Line(Space::Translation));
        assert_eq!(KINDS[GROUNDED_TURN], Shape::Grounded(Space::Rotation));
        assert_eq!(kind_of(Shape::Springs { y: false, theta: false }), None);
    }
}
