//! Where everything stands in `U_all`: the plan of a tree of transfer paths, resolved into spaces, columns and rows.
//!
//! The macro emits the tree as a constant list of [`Step`]s; [`Layout::new`] resolves it, also in a constant. What a
//! state space is worth, only the element types know, so it is settled here and not in the macro.

use crate::state::{Space, Support};

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
    downstream: [usize; STEPS],
}

impl<'a, const STEPS: usize> Layout<'a, STEPS> {
    /// Resolves a plan.
    ///
    /// Inputs of a connection are taken by widest state first, then in source order; columns by tips, depth first
    /// from the root, the root's own last; below the rows of the main transfer equation the geometrical equations,
    /// those of upstream connections first.
    pub const fn new(steps: [Step<'a>; STEPS]) -> Self {
        let nowhere = Place { space: Space::Translation, first_column: 0, columns: 0, first_row: 0, rows: 0 };
        let mut layout = Layout { steps, places: [nowhere; STEPS], downstream: [0; STEPS] };
        layout.link();
        layout.resolve_spaces();
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

    /// Counts unknowns and geometrical equations from the tips to the root.
    const fn count(&mut self) {
        let mut i = 0;
        while i < STEPS {
            let own = self.places[i].space.size() / 2;
            let (columns, rows) = match self.steps[i] {
                Step::Tip(_) => (own, 0),
                Step::Element(input, _) => (self.places[input].columns, self.places[input].rows),
                Step::Root(input, _) => (self.places[input].columns + own, self.places[input].rows),
                Step::Connection(inputs) => {
                    let (mut columns, mut rows) = (0, 0);
                    let mut k = 0;
                    while k < inputs.len() {
                        let place = self.places[inputs[k]];
                        columns += place.columns;
                        rows += place.rows;
                        if k != self.input(i, 0) {
                            rows += place.space.size() / 2;
                        }
                        k += 1;
                    }
                    (columns, rows + self.forces_left_behind(i))
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
                        let input = inputs[self.input(i, k)];
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
            Step::Element(_, output) => (self.places[connection].space.size() - output.size()) / 2,
            _ => 0,
        }
    }

    /// Position in the source order of the `rank`-th input of a connection, widest state first.
    pub(crate) const fn input(&self, connection: usize, rank: usize) -> usize {
        let Step::Connection(inputs) = self.steps[connection] else { return 0 };
        let mut candidate = 0;
        while candidate < inputs.len() {
            let size = self.places[inputs[candidate]].space.size();
            let mut before = 0;
            let mut other = 0;
            while other < inputs.len() {
                let other_size = self.places[inputs[other]].space.size();
                if other_size > size || (other_size == size && other < candidate) {
                    before += 1;
                }
                other += 1;
            }
            if before == rank {
                return candidate;
            }
            candidate += 1;
        }
        0
    }
}

/// Checks for constants: the macro emits each at the user's token, and a failing one is a compile error there.
impl<const STEPS: usize> Layout<'_, STEPS> {
    /// A support must exist in the space of the state to which it belongs.
    #[allow(clippy::panic)]
    pub const fn check_support(&self, step: usize) {
        let (Step::Tip(support) | Step::Root(_, support)) = self.steps[step] else { return };
        let space = self.places[step].space;
        if support.unknowns(space).is_none() {
            panic!(
                "{}",
                match space {
                    Space::Translation => "a translation path ends in `fixed` or `free` only",
                    Space::Rotation => "a rotation path ends in `fixed` or `free` only",
                    Space::Bending => "a bending path ends in `fixed`, `pinned`, `free` or `guided`",
                    Space::Planar => "a planar path ends in `fixed`, `pinned`, `free`, `guided` or `roller`",
                }
            );
        }
    }

    /// An arrow between two elements needs equal states on both sides.
    #[allow(clippy::panic)]
    pub const fn check_arrow(&self, step: usize) {
        let Step::Element(input, space) = self.steps[step] else { return };
        if matches!(self.steps[input], Step::Element(..)) && !self.places[input].space.is(space) {
            panic!("an arrow joins equal states only: put a connection `conn` between these two elements");
        }
    }

    /// The states around a connection must be able to meet there, and its widest input must fill its output.
    #[allow(clippy::panic)]
    pub const fn check_connection(&self, step: usize) {
        let Step::Connection(inputs) = self.steps[step] else { return };
        let Some(space) = self.widest_neighbour(step) else {
            panic!("a connection joins elements: either all planar, or none of them, and not supports alone");
        };
        let widest_input = self.places[inputs[self.input(step, 0)]].space;
        if !widest_input.is(space) {
            panic!(
                "the output of this connection has more states than any input: give it a free tip, `free -> conn ..`"
            );
        }
        if inputs.len() == 1 && !self.narrows(step) {
            panic!(
                "a connection with one input must lead on to fewer states, as from a beam to a spring; else write the \
                 arrow from element to element"
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Space::{Bending, Translation};

    /// Section 4.4 of the paper, with the spring-mass written before the beam it hangs on.
    const TWO_SPANS: Layout<'_, 11> = Layout::new([
        Step::Tip(Support::Free),
        Step::Element(0, Translation),
        Step::Element(1, Translation),
        Step::Tip(Support::Pinned),
        Step::Tip(Support::Pinned),
        Step::Element(4, Bending),
        Step::Connection(&[3, 5]),
        Step::Element(6, Bending),
        Step::Connection(&[2, 7]),
        Step::Element(8, Bending),
        Step::Root(9, Support::Pinned),
    ]);

    #[test]
    fn the_widest_input_comes_first_whatever_the_source_order() {
        assert_eq!(TWO_SPANS.size(), 7);
        assert_eq!(TWO_SPANS.places[2].first_column, 4, "the spring-mass stands behind the four beam columns");
        assert_eq!(TWO_SPANS.places[3].first_column, 0, "equal states keep the source order");
        assert_eq!(TWO_SPANS.places[4].first_column, 2);
    }

    #[test]
    fn geometrical_equations_follow_the_main_equation_from_the_tips_down() {
        assert_eq!((TWO_SPANS.places[6].first_row, TWO_SPANS.places[6].rows), (4, 2));
        assert_eq!((TWO_SPANS.places[8].first_row, TWO_SPANS.places[8].rows), (4, 3));
    }

    #[test]
    fn supports_adopt_the_state_of_what_they_hold() {
        assert_eq!(TWO_SPANS.places[0].space, Translation);
        assert_eq!(TWO_SPANS.places[3].space, Bending);
    }
}
