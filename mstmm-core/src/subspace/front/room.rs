//! The memory of fronts, and the numbers that fronts are compiled for.

use crate::number::{Scalar, for_compiled_numbers};
use crate::subspace::front::chart::{Chart, JoinedEnd, MOST_FREEDOMS};
use crate::subspace::front::eliminate::Choice;
use crate::subspace::front::fronts::{FrontNode, Fronts};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::objects::{Objects, Start};
use crate::subspace::front::target::Target;
use crate::subspace::front::total::Total;
use crate::subspace::front::triangle::row;
use crate::subspace::front::variable::Variable;

/// Memory for fronts of up to `W` variables at once.
#[derive(Debug)]
pub struct FrontRoom<S, const W: usize> {
    /// The triangles of objects, which have a variable less than all together, and of a front.
    triangles: [[S; W]; W],
    /// Rows of pivots, and these divided by them.
    pivots: [[S; W]; 4],
    variables: [[Variable; W]; 2],
    rows: [[S; MOST_FREEDOMS]; W],
    targets: [Target; W],
    sizes: [[f64; W]; 3],
    starts: [Start; W],
}

impl<S: Copy, const W: usize> FrontRoom<S, W> {
    /// Memory that is filled with a number.
    const fn filled_with(number: S) -> Self {
        FrontRoom {
            triangles: [[number; W]; W],
            pivots: [[number; W]; 4],
            variables: [[Variable::DISPLACEMENT; W]; 2],
            rows: [[number; MOST_FREEDOMS]; W],
            targets: [Target::NONE; W],
            sizes: [[0.0; W]; 3],
            starts: [Start::FIRST; W],
        }
    }
}

impl<S: Scalar, const W: usize> FrontRoom<S, W> {
    /// Fronts without objects, given how pivots are chosen and whether errors are to be carried along.
    pub(crate) fn fronts(&mut self, choice: Choice, carries_errors: bool) -> Fronts<'_, S> {
        let (objects, front) = self.triangles.as_flattened_mut().split_at_mut(row(W - 1));
        let [one, other, solved, other_solved] = &mut self.pivots;
        let [waiting, variables] = &mut self.variables;
        let [waiting_errors, errors, terms] = &mut self.sizes;
        Fronts {
            objects: Objects {
                entries: objects,
                variables: waiting,
                rows: &mut self.rows,
                errors: waiting_errors,
                starts: &mut self.starts,
                count: 0,
            },
            front: Front {
                entries: front,
                pivots: [one, other],
                solved: [solved, other_solved],
                variables,
                terms,
                errors,
                boundary: 0,
                count: 0,
            },
            targets: &mut self.targets,
            total: Total::new(carries_errors),
            choice,
        }
    }
}

impl<S: Scalar> Fronts<'_, S> {
    /// Joins the last objects at a node, eliminates it, and leaves its front as an object.
    #[inline(always)]
    fn take_up(&mut self, node: &FrontNode<S>) {
        let from = self.objects.count - node.objects;
        self.total.node = node.index;
        self.join(node, from);
        self.front.eliminate(self.choice, &mut self.total);
        let shift = self.front.balance();
        self.objects.replace_last(from, node.index, &self.front, shift);
    }
}

/// A number whose fronts are compiled with this library, once, and not with each model.
#[diagnostic::on_unimplemented(
    message = "a network cannot be evaluated with `{Self}`",
    note = "its fronts are compiled for `f64`, `f32` and `DoubleDouble`, for complex and dual numbers of these"
)]
pub trait FrontScalar: Scalar {
    /// What a function does with memory for fronts; none in lanes, whose pivots would differ.
    #[doc(hidden)]
    fn in_memory<const W: usize, R>(work: impl FnOnce(&mut FrontRoom<Self, W>) -> R) -> Option<R>;

    /// Adds a member by its chart. Returns the number of objects that were added.
    #[doc(hidden)]
    fn push_chart(fronts: &mut Fronts<'_, Self>, chart: &Chart<Self>, ends: &[JoinedEnd<Self>; 2]) -> usize;

    /// Eliminates a node.
    #[doc(hidden)]
    fn eliminate(fronts: &mut Fronts<'_, Self>, node: &FrontNode<Self>);
}

/// Compiles fronts of numbers, given the zero of each: a constant, since memory is filled with it in one go.
macro_rules! compiled {
    ($($number:ty, $zero:expr;)*) => {$(
        impl FrontScalar for $number {
            #[inline]
            fn in_memory<const W: usize, R>(work: impl FnOnce(&mut FrontRoom<Self, W>) -> R) -> Option<R> {
                let mut room = const { FrontRoom::<$number, W>::filled_with($zero) };
                Some(work(&mut room))
            }

            fn push_chart(fronts: &mut Fronts<'_, Self>, chart: &Chart<Self>, ends: &[JoinedEnd<Self>; 2]) -> usize {
                fronts.objects.push_chart(chart, ends, &mut fronts.total)
            }

            fn eliminate(fronts: &mut Fronts<'_, Self>, node: &FrontNode<Self>) {
                fronts.take_up(node);
            }
        }
    )*};
}

for_compiled_numbers!(compiled);

/// Fronts have no lanes.
#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
impl<V: crate::number::lanes::Waving> FrontScalar for mstmm_lanes::Lanes<V> {
    fn in_memory<const W: usize, R>(_work: impl FnOnce(&mut FrontRoom<Self, W>) -> R) -> Option<R> {
        None
    }

    fn push_chart(_fronts: &mut Fronts<'_, Self>, _chart: &Chart<Self>, _ends: &[JoinedEnd<Self>; 2]) -> usize {
        0
    }

    fn eliminate(_fronts: &mut Fronts<'_, Self>, _node: &FrontNode<Self>) {}
}
