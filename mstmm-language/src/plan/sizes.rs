//! States, unknowns and equations of a plan, for its text: what the core works out from the types when it resolves a
//! layout. A test compares the two.

use super::{Plan, Step};
use crate::ast::Element;
use crate::keywords::{State, support_of};

impl State {
    /// Entries of the state vector that are displacements.
    pub(super) fn displacements(self) -> &'static [&'static str] {
        match self {
            State::Translation => &["Y"],
            State::Rotation => &["Θ"],
            State::Bending => &["Y", "Θ"],
            State::Planar => &["X", "Y", "Θ"],
        }
    }

    /// Entries of the state vector that are forces.
    pub(super) fn forces(self) -> &'static [&'static str] {
        match self {
            State::Translation => &["Q"],
            State::Rotation => &["M"],
            State::Bending => &["M", "Q"],
            State::Planar => &["M", "Qx", "Qy"],
        }
    }

    /// Number of entries.
    pub(super) fn size(self) -> usize {
        self.displacements().len() + self.forces().len()
    }

    /// The state in which paths of two states meet, if they can.
    fn join(self, other: State) -> Option<State> {
        match (self, other) {
            (a, b) if a == b => Some(a),
            (State::Planar, _) | (_, State::Planar) => None,
            _ => Some(State::Bending),
        }
    }

    /// The entries that are unknown at a support (Table 1 of the paper); `None` where states like this have no such support.
    pub(super) fn unknowns(self, support: &str) -> Option<Vec<&'static str>> {
        let zeros: &[&str] = match (support_of(support)?, self) {
            ("Fixed", _) => self.displacements(),
            ("Free", _) => self.forces(),
            ("Pinned", State::Bending) => &["Y", "M"],
            ("Guided", State::Bending) => &["Θ", "Q"],
            ("Pinned", State::Planar) => &["X", "Y", "M"],
            ("Guided", State::Planar) => &["X", "Θ", "Qy"],
            ("Roller", State::Planar) => &["Y", "M", "Qx"],
            _ => return None,
        };
        let entries = self.displacements().iter().chain(self.forces()).copied();
        Some(entries.filter(|entry| !zeros.contains(entry)).collect())
    }
}

/// The state at both ends of an element; of a type of the user's own only rustc knows it.
fn state_of(element: &Element) -> Option<State> {
    element.kind.known().map(|known| known.state)
}

impl Plan<'_> {
    /// The state behind each step; `None` where only rustc knows it, or where states do not fit, of which rustc speaks.
    pub(super) fn states(&self) -> Vec<Option<State>> {
        let mut states: Vec<Option<State>> = Vec::new();
        for (index, step) in self.steps.iter().enumerate() {
            states.push(match step {
                Step::Tip(_) => None, // until what it holds is known
                Step::Element { element, .. } => state_of(element),
                Step::Connection { inputs, .. } => self.widest_neighbour(index, inputs, &states),
                Step::Root { input, .. } => states[*input],
            });
        }
        for index in 0..self.steps.len() {
            if let Step::Tip(support) = self.steps[index] {
                let state = self.downstream(index).and_then(|step| states[step]);
                states[index] = state.filter(|state| state.unknowns(&support.to_string()).is_some());
            }
        }
        states
    }

    /// The widest among the states around a connection but those of supports and of a connection behind it.
    fn widest_neighbour(&self, connection: usize, inputs: &[usize], states: &[Option<State>]) -> Option<State> {
        let behind = match &self.steps[self.downstream(connection)?] {
            Step::Element { element, .. } => Some(state_of(element)),
            _ => None,
        };
        let before = inputs.iter().filter(|input| !matches!(self.steps[**input], Step::Tip(_)));
        let mut around = before.map(|input| states[*input]).chain(behind);
        let first = around.next()??;
        around.try_fold(first, |widest, state| widest.join(state?))
    }

    /// The inputs of a step, widest state first, then in source order.
    pub(super) fn sorted_inputs(&self, index: usize, states: &[State]) -> Vec<usize> {
        let mut inputs = self.steps[index].inputs().to_vec();
        inputs.sort_by_key(|input| std::cmp::Reverse(states[*input].size()));
        inputs
    }
}
