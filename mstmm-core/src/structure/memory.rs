//! Memory of the caller's for the elimination of a structure, and the numbers that it is compiled for.

use crate::model::EndMotion;
use crate::number::Scalar;
use crate::number::compiled::for_compiled_numbers;
use crate::structure::factor::{Factor, LOADS, NodeUnknowns, Row, Unknown};
use crate::structure::member::{MemberLoad, MemberStiffness};
use crate::subspace::{Chart, JoinedEnd, MOST_FREEDOMS};

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
    pub(crate) fn factor(&mut self) -> Factor<'_, S> {
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

    /// Finds the values of all unknowns.
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
