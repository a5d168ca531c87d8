//! A resolved plan: where each step stands in it and in `U_all`.

use crate::freedom::Freedoms;
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
