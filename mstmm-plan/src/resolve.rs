//! Resolves a plan: who takes whom as input, spaces, the order of inputs, numbers of columns and rows, and where these begin.

use crate::scheme::{Place, Scheme};
use crate::space::Space;
use crate::step::Step;

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
}

/// Finds the places of steps and the inputs of each, widest state first.
pub(crate) const fn resolve(steps: &[Step<'_>], places: &mut [Place], inputs: &mut [usize]) {
    link(steps, places);
    let mut i = 0;
    while i < steps.len() {
        places[i].space = space(Scheme { steps, places, inputs }, i);
        i += 1;
    }
    adopt_spaces(steps, places);
    sort_inputs(steps, places, inputs);
    count(steps, places, inputs);
    place(steps, places, inputs);
}

/// Notes for each step the one that takes it as input.
const fn link(steps: &[Step<'_>], places: &mut [Place]) {
    let mut i = 0;
    while i < steps.len() {
        let inputs = steps[i].inputs();
        let mut k = 0;
        while k < inputs.len() {
            places[inputs[k]].downstream = i;
            k += 1;
        }
        i += 1;
    }
}

/// The space of a step whose inputs have theirs: elements have that of their type, connections the widest of their neighbours, the
/// root that of its path.
const fn space(scheme: Scheme<'_>, step: usize) -> Space {
    match scheme.steps[step] {
        Step::Element(_, space) => space,
        Step::Connection(inputs) => match widest_neighbour(scheme, step, inputs) {
            Some(space) => space,
            None => Space::NONE,
        },
        Step::Root(input, _) => scheme.space(input),
        Step::Tip(_) => Space::NONE,
    }
}

/// The widest space among the neighbours of a connection that are not supports; `None` if they cannot meet there or if there
/// are none.
///
/// A connection behind a connection takes the state of that one and has no say in it: it may be the wider of the two.
const fn widest_neighbour(scheme: Scheme<'_>, connection: usize, inputs: &[usize]) -> Option<Space> {
    let mut widest = scheme.output(connection);
    let mut k = 0;
    while k < inputs.len() {
        if !matches!(scheme.steps[inputs[k]], Step::Tip(_)) {
            let space = scheme.space(inputs[k]);
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

/// Tips adopt the space of what they lead to.
const fn adopt_spaces(steps: &[Step<'_>], places: &mut [Place]) {
    let mut i = 0;
    while i < steps.len() {
        if let Step::Tip(_) = steps[i] {
            places[i].space = places[places[i].downstream].space;
        }
        i += 1;
    }
}

/// Sorts the inputs of each step once, a pass per size of state: sorting by comparison would let the compiler take a constant
/// with a hundred inputs for an endless loop.
const fn sort_inputs(steps: &[Step<'_>], places: &mut [Place], sorted: &mut [usize]) {
    let (mut i, mut end) = (0, 0);
    while i < steps.len() {
        places[i].first_input = end;
        let inputs = steps[i].inputs();
        let mut more_than = Space::PLANE.count() + 1;
        while more_than > 0 {
            more_than -= 1;
            let mut k = 0;
            while k < inputs.len() {
                if places[inputs[k]].space.count() == more_than {
                    sorted[end] = inputs[k];
                    end += 1;
                }
                k += 1;
            }
        }
        i += 1;
    }
}

/// Counts unknowns and geometrical equations from the tips to the root.
const fn count(steps: &[Step<'_>], places: &mut [Place], inputs: &[usize]) {
    let mut i = 0;
    while i < steps.len() {
        let scheme = Scheme { steps, places, inputs };
        let mut columns = if steps[i].support().is_some() { scheme.space(i).count() } else { 0 };
        let mut rows = scheme.left_behind(i).count();
        let mut k = 0;
        while k < scheme.inputs(i).len() {
            let input = scheme.places[scheme.inputs(i)[k]];
            columns += input.columns;
            rows += input.rows + if k > 0 { input.space.count() } else { 0 };
            k += 1;
        }
        places[i].columns = columns;
        places[i].rows = rows;
        i += 1;
    }
}

/// Hands out columns and rows from the root to the tips.
const fn place(steps: &[Step<'_>], places: &mut [Place], inputs: &[usize]) {
    let mut i = steps.len();
    while i > 0 {
        i -= 1;
        let Place { mut first_column, mut first_row, .. } = places[i];
        if let Step::Root(..) = steps[i] {
            first_row = places[i].space.size();
        }
        let (first, count) = (places[i].first_input, steps[i].inputs().len());
        let mut k = first;
        while k < first + count {
            let input = &mut places[inputs[k]];
            input.first_column = first_column;
            input.first_row = first_row;
            first_column += input.columns;
            first_row += input.rows;
            k += 1;
        }
    }
}
