//! Memory of the caller's for the elimination of a structure, and the numbers that it is compiled for.

use crate::model::EndMotion;
use crate::number::Scalar;
use crate::number::compiled::for_compiled_numbers;
use crate::structure::chart::{Chart, JoinedEnd, MOST_MOTIONS};
use crate::structure::factor::{Factor, LOADS, Row, Unknown};
use crate::structure::member::{MemberLoad, MemberStiffness};
use crate::structure::node_unknowns::{MotionUnknown, NodeUnknowns};
use crate::structure::tape::Tape;
#[cfg(feature = "std")]
use crate::structure::triangle::row;

/// Size of memory \[bytes\] beyond which it is taken from the heap, with `std`: a quarter of a megabyte, since threads may have stacks of little more than one.
#[cfg(feature = "std")]
const LARGE: usize = 1 << 18;

/// Memory for a structure of up to so many nodes, of whose unknowns up to `W` are there at once. At each node no more than these leave, and each
/// has no more beside it.
#[derive(Debug)]
struct FactorRoom<S, const W: usize, const NODES: usize> {
    entries: [[S; W]; W],
    unknowns: [Unknown<S>; W],
    column: [(S, u32); W],
    rows: [[Row<S>; W]; NODES],
    numbers: [[[(S, u32); W]; W]; NODES],
    values: [[[S; LOADS]; W]; NODES],
}

/// What a function does with the factor of a structure that nothing has joined. The factor keeps rows, or has no room for any.
pub(crate) fn in_memory<const W: usize, const NODES: usize, S: Scalar, R>(
    keeps_rows: bool,
    work: impl FnOnce(Factor<'_, S>) -> R,
) -> R {
    #[cfg(feature = "std")]
    if const { size_of::<FactorRoom<S, W, NODES>>() > LARGE } {
        return on_heap(W, keeps_rows, work);
    }
    on_stack::<W, NODES, S, R>(keeps_rows, work)
}

/// What a function does with a factor in memory on the stack.
#[inline(never)]
fn on_stack<const W: usize, const NODES: usize, S: Scalar, R>(
    keeps_rows: bool,
    work: impl FnOnce(Factor<'_, S>) -> R,
) -> R {
    let zero = S::zero();
    let mut room = FactorRoom::<S, W, NODES> {
        entries: [[zero; W]; W],
        unknowns: [Unknown::none(); W],
        column: [(zero, 0); W],
        rows: [[Row::none(); W]; NODES],
        numbers: [[[(zero, 0); W]; W]; NODES],
        values: [[[zero; LOADS]; W]; NODES],
    };
    work(Factor::new(
        (room.entries.as_flattened_mut(), &mut room.unknowns),
        &mut room.column,
        Tape::Slice(room.rows.as_flattened_mut(), 0),
        Tape::Slice(room.numbers.as_flattened_mut().as_flattened_mut(), 0),
        Tape::Slice(room.values.as_flattened_mut(), 0),
        keeps_rows,
    ))
}

/// What a function does with a factor on the heap, of up to so many unknowns at once. What it keeps of them grows.
#[cfg(feature = "std")]
#[inline(never)]
pub(crate) fn on_heap<S: Scalar, R>(width: usize, keeps_rows: bool, work: impl FnOnce(Factor<'_, S>) -> R) -> R {
    use std::vec;
    let zero = S::zero();
    work(Factor::new(
        (&mut vec![zero; row(width)], &mut vec![Unknown::none(); width]),
        &mut vec![(zero, 0); width],
        Tape::Vector(&mut vec![]),
        Tape::Vector(&mut vec![]),
        Tape::Vector(&mut vec![]),
        keeps_rows,
    ))
}

/// What a function does with so many values: of an array on the stack, or if that is large of a vector, with `std`.
pub(crate) fn with_many<V: Copy, A: AsMut<[V]>, R>(
    value: V,
    count: usize,
    array: impl FnOnce(V) -> A,
    work: impl FnOnce(&mut [V]) -> R,
) -> R {
    #[cfg(feature = "std")]
    if const { size_of::<A>() > LARGE } {
        return work(&mut std::vec![value; count]);
    }
    let _ = count;
    in_array(value, array, work)
}

/// What a function does with the values of an array.
#[inline(never)]
fn in_array<V, A: AsMut<[V]>, R>(value: V, array: impl FnOnce(V) -> A, work: impl FnOnce(&mut [V]) -> R) -> R {
    work(array(value).as_mut())
}

/// A number in which structures are eliminated, compiled with this library, once, and not with each model.
#[diagnostic::on_unimplemented(
    message = "a structure cannot be solved with `{Self}`",
    note = "its elimination is compiled for `f64`, `f32` and `DoubleDouble`, for complex and dual numbers of these"
)]
pub trait StructureScalar: Scalar {
    /// Lets a motion of a node enter.
    #[doc(hidden)]
    fn enter(factor: &mut Factor<'_, Self>) -> MotionUnknown;

    /// Makes a member of its chart, and adds it.
    #[doc(hidden)]
    fn join(
        factor: &mut Factor<'_, Self>,
        member: &mut MemberStiffness<Self>,
        chart: &Chart<Self>,
        ends: (&[JoinedEnd<Self>; 2], [&NodeUnknowns; 2]),
        load: Option<MemberLoad<Self>>,
    );

    /// Takes up a node with its body and the forces on its motions, and lets these leave.
    #[doc(hidden)]
    fn take_up(
        factor: &mut Factor<'_, Self>,
        node: &NodeUnknowns,
        body: &Option<[[Self; MOST_MOTIONS]; MOST_MOTIONS]>,
        forces: &[Self; MOST_MOTIONS],
    );

    /// Lets all unknowns leave that are left.
    #[doc(hidden)]
    fn leave_all(factor: &mut Factor<'_, Self>);

    /// Lets all unknowns leave that are left, and finds the values of all.
    #[doc(hidden)]
    fn solve(factor: &mut Factor<'_, Self>);

    /// The motion of both ends of a member under a load.
    #[doc(hidden)]
    fn motion(
        factor: &Factor<'_, Self>,
        member: &MemberStiffness<Self>,
        nodes: [&NodeUnknowns; 2],
        load: usize,
    ) -> [EndMotion<Self>; 2];
}

/// Compiles the elimination of numbers.
macro_rules! compiled {
    ($($number:ty;)*) => {$(
        impl StructureScalar for $number {
            fn enter(factor: &mut Factor<'_, Self>) -> MotionUnknown {
                factor.enter_motion()
            }

            fn join(
                factor: &mut Factor<'_, Self>,
                member: &mut MemberStiffness<Self>,
                chart: &Chart<Self>,
                (ends, nodes): (&[JoinedEnd<Self>; 2], [&NodeUnknowns; 2]),
                load: Option<MemberLoad<Self>>,
            ) {
                member.set(chart, ends, load);
                factor.join(member, nodes);
            }

            fn take_up(
                factor: &mut Factor<'_, Self>,
                node: &NodeUnknowns,
                body: &Option<[[Self; MOST_MOTIONS]; MOST_MOTIONS]>,
                forces: &[Self; MOST_MOTIONS],
            ) {
                factor.take_up(node, body, forces);
            }

            fn leave_all(factor: &mut Factor<'_, Self>) {
                factor.leave_all();
            }

            fn solve(factor: &mut Factor<'_, Self>) {
                factor.solve();
            }

            fn motion(factor: &Factor<'_, Self>, member: &MemberStiffness<Self>, nodes: [&NodeUnknowns; 2], load: usize) -> [EndMotion<Self>; 2] {
                factor.motion(member, nodes, load)
            }
        }
    )*};
}

for_compiled_numbers!(compiled);

/// Numbers in lanes would wait for different pivots: nothing is known of their structures.
#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
impl<V: crate::number::lanes::Waving> StructureScalar for mstmm_lanes::Lanes<V> {
    fn enter(_factor: &mut Factor<'_, Self>) -> MotionUnknown {
        MotionUnknown { number: 0, slot: 0 }
    }

    fn join(
        _factor: &mut Factor<'_, Self>,
        _member: &mut MemberStiffness<Self>,
        _chart: &Chart<Self>,
        _ends: (&[JoinedEnd<Self>; 2], [&NodeUnknowns; 2]),
        _load: Option<MemberLoad<Self>>,
    ) {
    }

    fn take_up(
        _factor: &mut Factor<'_, Self>,
        _node: &NodeUnknowns,
        _body: &Option<[[Self; MOST_MOTIONS]; MOST_MOTIONS]>,
        _forces: &[Self; MOST_MOTIONS],
    ) {
    }

    fn leave_all(factor: &mut Factor<'_, Self>) {
        factor.total = crate::structure::Total::unknown();
    }

    fn solve(_factor: &mut Factor<'_, Self>) {}

    fn motion(
        _factor: &Factor<'_, Self>,
        _member: &MemberStiffness<Self>,
        _nodes: [&NodeUnknowns; 2],
        _load: usize,
    ) -> [EndMotion<Self>; 2] {
        [EndMotion::at_rest(); 2]
    }
}
