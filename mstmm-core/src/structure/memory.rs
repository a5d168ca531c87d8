//! Memory of the caller's for the elimination of a structure, and the numbers that it is compiled for.

use crate::model::EndMotion;
use crate::number::Scalar;
use crate::number::compiled::for_compiled_numbers;
use crate::structure::chart::{Chart, JoinedEnd, MOST_FREEDOMS};
use crate::structure::factor::{Factor, LOADS, NodeUnknowns, Row, Unknown};
use crate::structure::member::{MemberLoad, MemberStiffness};
use crate::structure::total::Total;

/// Memory for a structure of so many nodes, of whose unknowns up to `W` are there at once. At each node no more than these leave, and each has no
/// more beside it.
#[derive(Debug)]
pub(crate) struct FactorRoom<S, const W: usize, const NODES: usize> {
    entries: [[S; W]; W],
    unknowns: [Unknown<S>; W],
    rows: [[Row<S>; W]; NODES],
    numbers: [[[S; W]; W]; NODES],
    beside: [[[u32; W]; W]; NODES],
    values: [[[S; LOADS]; W]; NODES],
}

impl<S: Scalar, const W: usize, const NODES: usize> FactorRoom<S, W, NODES> {
    /// Memory without a structure.
    pub(crate) fn new() -> Self {
        let zero = S::zero();
        FactorRoom {
            entries: [[zero; W]; W],
            unknowns: [Unknown::none(); W],
            rows: [[Row::none(); W]; NODES],
            numbers: [[[zero; W]; W]; NODES],
            beside: [[[0; W]; W]; NODES],
            values: [[[zero; LOADS]; W]; NODES],
        }
    }

    /// The factor of a structure that nothing has joined.
    pub(crate) fn factor(&mut self, keeps_rows: bool) -> Factor<'_, S> {
        Factor {
            entries: self.entries.as_flattened_mut(),
            unknowns: &mut self.unknowns,
            width: 0,
            rows: self.rows.as_flattened_mut(),
            numbers: self.numbers.as_flattened_mut().as_flattened_mut(),
            beside: self.beside.as_flattened_mut().as_flattened_mut(),
            row_count: 0,
            number_count: 0,
            values: self.values.as_flattened_mut(),
            entered: 0,
            everywhere: None,
            node: 0,
            vanished_at: None,
            is_full: false,
            works: [S::zero(); LOADS],
            total: Total::new(),
            keeps_rows,
        }
    }
}

/// A number in which structures are eliminated, compiled with this library, once, and not with each model.
#[diagnostic::on_unimplemented(
    message = "a structure cannot be solved with `{Self}`",
    note = "its elimination is compiled for `f64`, `f32` and `DoubleDouble`, for complex and dual numbers of these"
)]
pub trait StructureScalar: Scalar {
    /// Lets the motions of a node enter.
    #[doc(hidden)]
    fn enter(factor: &mut Factor<'_, Self>, motions: usize) -> NodeUnknowns;

    /// Makes a member of its chart, and adds it.
    #[doc(hidden)]
    fn join(
        factor: &mut Factor<'_, Self>,
        member: &mut MemberStiffness<Self>,
        chart: &Chart<Self>,
        ends: (&[JoinedEnd<Self>; 2], [&NodeUnknowns; 2]),
        load: &MemberLoad<Self>,
    );

    /// Takes up a node with its body and the forces on its motions, and lets these leave.
    #[doc(hidden)]
    fn take_up(
        factor: &mut Factor<'_, Self>,
        node: &NodeUnknowns,
        body: &Option<[[Self; MOST_FREEDOMS]; MOST_FREEDOMS]>,
        forces: &[Self; MOST_FREEDOMS],
    );

    /// Lets all unknowns leave that are left.
    #[doc(hidden)]
    fn leave_all(factor: &mut Factor<'_, Self>);

    /// Finds the values of all unknowns, which have left.
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
    ($($number:ty, $zero:expr;)*) => {$(
        impl StructureScalar for $number {
            fn enter(factor: &mut Factor<'_, Self>, motions: usize) -> NodeUnknowns {
                factor.enter_node(motions)
            }

            fn join(
                factor: &mut Factor<'_, Self>,
                member: &mut MemberStiffness<Self>,
                chart: &Chart<Self>,
                (ends, nodes): (&[JoinedEnd<Self>; 2], [&NodeUnknowns; 2]),
                load: &MemberLoad<Self>,
            ) {
                member.set(chart, ends, load);
                factor.join(member, nodes);
            }

            fn take_up(
                factor: &mut Factor<'_, Self>,
                node: &NodeUnknowns,
                body: &Option<[[Self; MOST_FREEDOMS]; MOST_FREEDOMS]>,
                forces: &[Self; MOST_FREEDOMS],
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
    fn enter(_factor: &mut Factor<'_, Self>, _motions: usize) -> NodeUnknowns {
        NodeUnknowns { has_entered: true, ..NodeUnknowns::NONE }
    }

    fn join(
        _factor: &mut Factor<'_, Self>,
        _member: &mut MemberStiffness<Self>,
        _chart: &Chart<Self>,
        _ends: (&[JoinedEnd<Self>; 2], [&NodeUnknowns; 2]),
        _load: &MemberLoad<Self>,
    ) {
    }

    fn take_up(
        _factor: &mut Factor<'_, Self>,
        _node: &NodeUnknowns,
        _body: &Option<[[Self; MOST_FREEDOMS]; MOST_FREEDOMS]>,
        _forces: &[Self; MOST_FREEDOMS],
    ) {
    }

    fn leave_all(factor: &mut Factor<'_, Self>) {
        factor.total = Total::unknown();
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
