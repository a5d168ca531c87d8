//! Where everything stands in `U_all`: the plan of a tree of transfer paths, resolved into spaces, columns and rows.
//!
//! The macro emits the tree as a constant list of [`Step`]s; [`Layout::new`] resolves it in that constant. What a state space
//! is worth only the element types know, so it is settled there and not in the macro.

use crate::freedom::Freedoms;
use crate::resolve::resolve;
use crate::space::Space;
use crate::step::Step;

/// Where a step stands in the plan and in `U_all`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Space of the step: of the widest state at a connection, of a support that of its neighbour. [`Space::NONE`] where paths
    /// cannot meet, or where it is not known.
    pub space: Space,
    /// The step that takes this one as input; none takes the root.
    pub downstream: usize,
    /// Where the inputs of the step begin in the list of all.
    pub(crate) first_input: usize,
    /// First column of the unknowns upstream of the step.
    pub first_column: usize,
    /// Number of unknowns upstream of the step, its own included.
    pub columns: usize,
    /// First row of the geometrical equations upstream of the step.
    pub first_row: usize,
    /// Number of those rows, its own (the last of them) included.
    pub rows: usize,
}

impl Place {
    /// The place of a step before it is known.
    pub const NOWHERE: Place =
        Place { space: Space::NONE, downstream: 0, first_input: 0, first_column: 0, columns: 0, first_row: 0, rows: 0 };
}

/// A resolved plan, of any number of steps: a view of lists that stand elsewhere.
#[derive(Clone, Copy, Debug)]
pub struct Scheme<'a> {
    /// The steps, in the order of evaluation.
    pub steps: &'a [Step<'a>],
    /// The place of each step.
    pub places: &'a [Place],
    /// The inputs of all steps, one step after the other, each widest state first.
    pub(crate) inputs: &'a [usize],
}

impl<'a> Scheme<'a> {
    /// Resolves a plan, in lists as long as it.
    ///
    /// Inputs of a connection are taken by widest state first, then in source order; columns by tips, depth first
    /// from the root, the root's own last; below the rows of the main transfer equation the geometrical equations,
    /// those of upstream connections first.
    ///
    /// ```
    /// use mstmm_plan::{Place, Scheme, Space, Step, Support};
    /// let steps = [Step::Tip(Support::Fixed), Step::Element(0, Space::Bending), Step::Root(1, Support::Free)];
    /// let (mut places, mut inputs) = ([Place::NOWHERE; 3], [0; 3]);
    /// let scheme = Scheme::resolve(&steps, &mut places, &mut inputs);
    /// assert_eq!(scheme.size(), 4);
    /// assert_eq!(scheme.space(2), Space::Bending);
    /// ```
    pub const fn resolve(steps: &'a [Step<'a>], places: &'a mut [Place], inputs: &'a mut [usize]) -> Self {
        resolve(steps, places, inputs);
        Scheme { steps, places, inputs }
    }

    /// Number of steps.
    #[allow(clippy::len_without_is_empty)] // a plan has a root
    #[inline]
    pub const fn len(&self) -> usize {
        self.steps.len()
    }

    /// Number of unknowns at the boundaries: the width of `U_all`.
    #[inline]
    pub const fn size(&self) -> usize {
        self.places[self.len() - 1].columns
    }

    /// Space of a step: of the widest state at a connection, of a support that of its neighbour.
    #[inline]
    pub const fn space(&self, step: usize) -> Space {
        self.places[step].space
    }

    /// The step that takes another as input.
    #[inline]
    pub const fn downstream(&self, step: usize) -> usize {
        self.places[step].downstream
    }

    /// Space of the element to which a step leads; `None` if it leads to a connection or to the root.
    #[inline]
    pub const fn output(&self, step: usize) -> Option<Space> {
        match self.steps[self.downstream(step)] {
            Step::Element(_, space) => Some(space),
            _ => None,
        }
    }

    /// Space of the state behind a step: that with which a path goes on.
    #[inline]
    pub const fn behind(&self, step: usize) -> Space {
        self.space(step).without(self.left_behind(step))
    }

    /// The inputs of a step, widest state first, then in source order.
    #[inline]
    pub const fn inputs(&self, step: usize) -> &'a [usize] {
        self.inputs.split_at(self.places[step].first_input).1.split_at(self.steps[step].inputs().len()).0
    }

    /// The freedoms that a connection does not lead on, whose forces are zero there: one equation each.
    #[inline]
    pub const fn left_behind(&self, step: usize) -> Freedoms {
        match (self.steps[step], self.output(step)) {
            (Step::Connection(_), Some(output)) => self.space(step).without(output),
            _ => Freedoms::NONE,
        }
    }
}

/// A plan of `STEPS` steps with its places: what a constant holds.
#[derive(Clone, Copy, Debug)]
pub struct Layout<'a, const STEPS: usize> {
    steps: [Step<'a>; STEPS],
    places: [Place; STEPS],
    inputs: [usize; STEPS],
}

impl<'a, const STEPS: usize> Layout<'a, STEPS> {
    /// Resolves a plan, as [`Scheme::resolve`] does.
    pub const fn new(steps: [Step<'a>; STEPS]) -> Self {
        let mut layout = Layout { steps, places: [Place::NOWHERE; STEPS], inputs: [0; STEPS] };
        resolve(&layout.steps, &mut layout.places, &mut layout.inputs);
        layout
    }

    /// The resolved plan.
    #[inline]
    pub const fn scheme(&'a self) -> Scheme<'a> {
        Scheme { steps: &self.steps, places: &self.places, inputs: &self.inputs }
    }
}

#[cfg(test)]
mod tests;
