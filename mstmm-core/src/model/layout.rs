//! Where everything stands in `U_all`: the plan of a tree of transfer paths, resolved into spaces, columns and rows.
//!
//! The macro emits the tree as a constant list of [`Step`]s; [`Layout::new`] resolves it, also in a constant. What a
//! state space is worth, only the element types know, so it is settled here and not in the macro.

mod checks;
#[cfg(test)]
mod tests;

use crate::model::state::{Space, Support};
use mstmm_plan::WIDEST;

/// A step of the plan; a step refers to earlier ones by index.
#[derive(Clone, Copy, Debug)]
pub enum Step<'a> {
    /// A boundary from which a path starts.
    Tip(Support),
    /// An element, its input step, and the space of its states.
    Element(usize, Space),
    /// A connection of the paths that end in these steps, in the order of the source.
    Connection(&'a [usize]),
    /// The boundary in which all paths end: always the last step.
    Root(usize, Support),
}

/// A step with its place in `U_all`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// Space of the state behind the step.
    pub(crate) space: Space,
    /// First column of the unknowns upstream of the step.
    pub(crate) first_column: usize,
    /// Number of unknowns upstream of the step, its own included.
    pub(crate) columns: usize,
    /// First row of the geometrical equations upstream of the step.
    pub(crate) first_row: usize,
    /// Number of those rows, its own (the last of them) included.
    pub(crate) rows: usize,
}

/// The resolved plan of a scene with `STEPS` steps.
#[derive(Clone, Copy, Debug)]
pub struct Layout<'a, const STEPS: usize> {
    pub(crate) steps: [Step<'a>; STEPS],
    pub(crate) places: [Place; STEPS],
    /// The step that takes each as input.
    downstream: [usize; STEPS],
    /// The inputs of all connections, one connection after the other, each widest state first.
    inputs: [usize; STEPS],
    /// Where the inputs of each connection begin in that list.
    first_input: [usize; STEPS],
}

/// A resolved plan of any number of steps.
#[derive(Clone, Copy, Debug)]
pub struct Scheme<'a> {
    pub(crate) steps: &'a [Step<'a>],
    places: &'a [Place],
    downstream: &'a [usize],
}

impl<'a> Scheme<'a> {
    /// Number of steps.
    pub(crate) fn len(&self) -> usize {
        self.steps.len()
    }

    /// Space of a step: of the widest state at a connection, of a support that of its neighbour.
    pub(crate) fn space(&self, step: usize) -> Space {
        self.places[step].space
    }

    /// The step that takes another as input.
    pub(crate) fn downstream(&self, step: usize) -> usize {
        self.downstream[step]
    }

    /// Space of the element to which a step leads; `None` if it leads to a connection or to the root.
    pub(crate) fn output(&self, step: usize) -> Option<Space> {
        match self.steps[self.downstream[step]] {
            Step::Element(_, space) => Some(space),
            _ => None,
        }
    }

    /// Space of the state behind a step: that with which a path goes on.
    pub(crate) fn behind(&self, step: usize) -> Space {
        match self.steps[step] {
            Step::Connection(_) => self.output(step).unwrap_or(self.space(step)),
            _ => self.space(step),
        }
    }
}

impl<'a, const STEPS: usize> Layout<'a, STEPS> {
    /// The plan without its number of steps in the type.
    pub const fn scheme(&'a self) -> Scheme<'a> {
        Scheme { steps: &self.steps, places: &self.places, downstream: &self.downstream }
    }

    /// Resolves a plan.
    ///
    /// Inputs of a connection are taken by widest state first, then in source order; columns by tips, depth first
    /// from the root, the root's own last; below the rows of the main transfer equation the geometrical equations,
    /// those of upstream connections first.
    pub const fn new(steps: [Step<'a>; STEPS]) -> Self {
        let nowhere = Place { space: Space::Translation, first_column: 0, columns: 0, first_row: 0, rows: 0 };
        let none = [0; STEPS];
        let mut layout = Layout { steps, places: [nowhere; STEPS], downstream: none, inputs: none, first_input: none };
        layout.link();
        layout.resolve_spaces();
        layout.sort_inputs();
        layout.count();
        layout.place();
        layout
    }

    /// Number of unknowns at the boundaries: the width of `U_all`.
    pub const fn size(&self) -> usize {
        self.places[STEPS - 1].columns
    }

    /// Space of the state behind a step.
    pub const fn space(&self, step: usize) -> Space {
        self.places[step].space
    }

    /// Space of the element to which a step leads; `None` if it leads to a connection or to the root.
    pub const fn output(&self, step: usize) -> Option<Space> {
        match self.steps[self.downstream[step]] {
            Step::Element(_, space) => Some(space),
            _ => None,
        }
    }

    /// Notes for each step the one that takes it as input.
    const fn link(&mut self) {
        let mut i = 0;
        while i < STEPS {
            match self.steps[i] {
                Step::Tip(_) => {}
                Step::Element(input, _) | Step::Root(input, _) => self.downstream[input] = i,
                Step::Connection(inputs) => {
                    let mut k = 0;
                    while k < inputs.len() {
                        self.downstream[inputs[k]] = i;
                        k += 1;
                    }
                }
            }
            i += 1;
        }
    }

    /// Elements have the space of their type, connections the widest of their neighbours, supports adopt theirs.
    ///
    /// A connection behind a connection takes the state of that one and has no say in it: it may be the wider of the two.
    const fn resolve_spaces(&mut self) {
        let mut i = 0;
        while i < STEPS {
            match self.steps[i] {
                Step::Element(_, space) => self.places[i].space = space,
                Step::Connection(_) => {
                    if let Some(space) = self.widest_neighbour(i) {
                        self.places[i].space = space;
                    }
                }
                Step::Root(input, _) => self.places[i].space = self.places[input].space,
                Step::Tip(_) => {}
            }
            i += 1;
        }
        i = 0;
        while i < STEPS {
            if let Step::Tip(_) = self.steps[i] {
                self.places[i].space = self.places[self.downstream[i]].space;
            }
            i += 1;
        }
    }

    /// The widest space among the neighbours of a connection that are not supports; `None` if they cannot meet there
    /// or if there are none.
    const fn widest_neighbour(&self, connection: usize) -> Option<Space> {
        let Step::Connection(inputs) = self.steps[connection] else { return None };
        let mut widest = match self.steps[self.downstream[connection]] {
            Step::Element(_, space) => Some(space),
            _ => None,
        };
        let mut k = 0;
        while k < inputs.len() {
            if !matches!(self.steps[inputs[k]], Step::Tip(_)) {
                let space = self.places[inputs[k]].space;
                widest = match widest {
                    None => Some(space),
                    Some(other) => match space.join(other) {
                        None => return None,
                        joined => joined,
                    },
                };
            }
            k += 1;
        }
        widest
    }

    /// Sorts the inputs of each connection once, a pass per size of state: sorting by comparison would let the compiler
    /// take a constant with a hundred inputs for an endless loop.
    const fn sort_inputs(&mut self) {
        let mut i = 0;
        let mut end = 0;
        while i < STEPS {
            self.first_input[i] = end;
            if let Step::Connection(inputs) = self.steps[i] {
                let mut size = WIDEST;
                while size > 0 {
                    let mut k = 0;
                    while k < inputs.len() {
                        if self.places[inputs[k]].space.size() == size {
                            self.inputs[end] = inputs[k];
                            end += 1;
                        }
                        k += 1;
                    }
                    size -= 2;
                }
            }
            i += 1;
        }
    }

    /// Counts unknowns and geometrical equations from the tips to the root.
    const fn count(&mut self) {
        let mut i = 0;
        while i < STEPS {
            let own = self.places[i].space.size() / 2;
            let (columns, rows) = match self.steps[i] {
                Step::Tip(_) => (own, 0),
                Step::Element(input, _) => (self.places[input].columns, self.places[input].rows),
                Step::Root(input, _) => (self.places[input].columns + own, self.places[input].rows),
                Step::Connection(_) => {
                    let inputs = self.inputs(i);
                    let (mut columns, mut rows) = (0, self.forces_left_behind(i));
                    let mut k = 0;
                    while k < inputs.len() {
                        let place = self.places[inputs[k]];
                        columns += place.columns;
                        rows += place.rows;
                        if k > 0 {
                            rows += place.space.size() / 2;
                        }
                        k += 1;
                    }
                    (columns, rows)
                }
            };
            self.places[i].columns = columns;
            self.places[i].rows = rows;
            i += 1;
        }
    }

    /// Hands out columns and rows from the root to the tips.
    const fn place(&mut self) {
        let mut i = STEPS;
        while i > 0 {
            i -= 1;
            let (mut column, mut row) = (self.places[i].first_column, self.places[i].first_row);
            match self.steps[i] {
                Step::Tip(_) => {}
                Step::Root(input, _) => self.places[input].first_row = self.places[i].space.size(),
                Step::Element(input, _) => {
                    self.places[input].first_column = column;
                    self.places[input].first_row = row;
                }
                Step::Connection(inputs) => {
                    let mut k = 0;
                    while k < inputs.len() {
                        let input = self.inputs[self.first_input[i] + k];
                        self.places[input].first_column = column;
                        self.places[input].first_row = row;
                        column += self.places[input].columns;
                        row += self.places[input].rows;
                        k += 1;
                    }
                }
            }
        }
    }

    /// Whether a connection leads on to fewer states than it has.
    pub(crate) const fn narrows(&self, connection: usize) -> bool {
        match self.steps[self.downstream[connection]] {
            Step::Element(_, output) => !output.is(self.places[connection].space),
            _ => false,
        }
    }

    /// Number of forces left behind by a connection that leads on to fewer states: one equation each.
    pub(crate) const fn forces_left_behind(&self, connection: usize) -> usize {
        match self.steps[self.downstream[connection]] {
            // a wrong scene may lead on to more states: its check says so, and not this subtraction
            Step::Element(_, output) => self.places[connection].space.size().saturating_sub(output.size()) / 2,
            _ => 0,
        }
    }

    /// The inputs of a connection, widest state first, then in source order; empty for any other step.
    pub(crate) const fn inputs(&self, connection: usize) -> &[usize] {
        let Step::Connection(inputs) = self.steps[connection] else { return &[] };
        self.inputs.split_at(self.first_input[connection]).1.split_at(inputs.len()).0
    }
}
