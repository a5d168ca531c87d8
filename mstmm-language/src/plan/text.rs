//! The plan as text: equation, unknowns, steps and paths. The documentation of the built system shows it.

use super::{Plan, Step};
use crate::keywords::State;
use std::fmt::{Display, Formatter, Result};

/// Number of steps up to which the main transfer equation is written out: one term per tip, as long as its way to the root.
const LONGEST_IN_FULL: usize = 24;

const NOTATION: &str = "\
`s0` is the state behind step 0 below, `U` the transfer matrix of an element. Where paths meet, the first gives the
displacements, and each its forces: `F` takes the forces of a state alone. `P` takes of a state what goes on to fewer.";

impl Display for Plan<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let states = self.states();
        writeln!(f, "# Equation\n\n{NOTATION}\n\n```text")?;
        match states.iter().copied().collect::<Option<Vec<State>>>() {
            Some(states) => self.write_equation(&states, f)?,
            None => writeln!(f, "U_all z_all = 0; its size `N` depends on elements that only the compiler knows")?,
        }
        writeln!(f, "```\n\n# Steps\n\n```text")?;
        for (index, state) in states.iter().enumerate() {
            writeln!(f, "{}", self.step_line(index, *state).trim_end())?;
        }
        writeln!(f, "```\n\n# Paths\n\n```text")?;
        self.write_paths(f)?;
        write!(f, "```")
    }
}

impl Plan<'_> {
    /// The size of the overall equation, its unknowns, the main transfer equation and the geometrical equations.
    fn write_equation(&self, states: &[State], f: &mut Formatter<'_>) -> Result {
        let root = self.steps.len() - 1;
        let unknowns = self.all_unknowns(states);
        let equations: Vec<String> = (0..=root).flat_map(|step| self.geometrical_equations(step, states)).collect();
        let (size, main) = (unknowns.len(), states[root].size());
        writeln!(
            f,
            "U_all z_all = 0, {size} x {size}: {main} rows of the main transfer equation, geometrical equations: {}",
            equations.len()
        )?;
        writeln!(f, "z_all = [{}]", unknowns.join(", "))?;
        if self.steps.len() <= LONGEST_IN_FULL {
            let paths: Vec<String> = self.tips(root, states).into_iter().map(|tip| self.product(tip, states)).collect();
            writeln!(f, "s{root} = {}", paths.join("\n    + "))?;
        }
        equations.iter().try_for_each(|equation| writeln!(f, "{equation}"))
    }

    /// Width of the overall matrix, if the macro knows the states of all elements.
    pub(crate) fn size(&self) -> Option<usize> {
        let states: Vec<State> = self.states().into_iter().collect::<Option<_>>()?;
        Some(self.all_unknowns(&states).len())
    }

    /// The unknown entries at all boundaries, by columns.
    fn all_unknowns(&self, states: &[State]) -> Vec<String> {
        let root = self.steps.len() - 1;
        let boundaries = self.tips(root, states).into_iter().chain([root]);
        boundaries.flat_map(|boundary| self.unknowns(boundary, states)).collect()
    }

    /// The tips upstream of a step in the order of their columns.
    fn tips(&self, step: usize, states: &[State]) -> Vec<usize> {
        let mut tips = Vec::new();
        let mut pending = vec![step];
        while let Some(step) = pending.pop() {
            if matches!(self.steps[step], Step::Tip(_)) {
                tips.push(step);
            }
            pending.extend(self.sorted_inputs(step, states).into_iter().rev());
        }
        tips
    }

    /// The unknown entries of the state at a boundary.
    fn unknowns(&self, boundary: usize, states: &[State]) -> Vec<String> {
        let (Step::Tip(support) | Step::Root { support, .. }) = &self.steps[boundary] else { return Vec::new() };
        let unknowns = states[boundary].unknowns(&support.to_string()).unwrap_or_default();
        unknowns.into_iter().map(|entry| format!("{entry}(s{boundary})")).collect()
    }

    /// What a connection demands: its inputs have the displacements of the first, and what does not go on has no force.
    fn geometrical_equations(&self, step: usize, states: &[State]) -> Vec<String> {
        let mut equations = Vec::new();
        if !matches!(self.steps[step], Step::Connection { .. }) {
            return equations;
        }
        let inputs = self.sorted_inputs(step, states);
        for other in &inputs[1..] {
            for entry in states[*other].displacements() {
                equations.push(format!("{entry}(s{other}) = {entry}(s{})", inputs[0]));
            }
        }
        let kept = self.forces_that_go_on(step, states);
        for force in states[step].forces().iter().filter(|force| !kept.contains(force)) {
            equations.push(format!("{force}(s{step}) = 0"));
        }
        equations
    }

    /// The forces of the state to which a connection leads on.
    fn forces_that_go_on(&self, step: usize, states: &[State]) -> &'static [&'static str] {
        match self.downstream(step).map(|next| (next, &self.steps[next])) {
            Some((next, Step::Element { .. })) => states[next].forces(),
            _ => states[step].forces(),
        }
    }

    /// The way of a tip's state to the root, `U(body 2) U(beam 1) s0`.
    fn product(&self, tip: usize, states: &[State]) -> String {
        let mut product = format!("s{tip}");
        let mut step = tip;
        while let Some(next) = self.downstream(step) {
            match &self.steps[next] {
                Step::Element { element, .. } => {
                    let narrows = states[next].size() < states[step].size();
                    product = format!("U({element}) {}{product}", if narrows { "P " } else { "" });
                }
                Step::Connection { .. } if self.sorted_inputs(next, states)[0] != step => {
                    product = format!("F {product}");
                }
                _ => {}
            }
            step = next;
        }
        product
    }

    /// `s4 = conn 2 (s1, s3)` with the state behind it.
    fn step_line(&self, index: usize, state: Option<State>) -> String {
        let inputs: Vec<String> = self.steps[index].inputs().iter().map(|input| format!("s{input}")).collect();
        let from = if inputs.is_empty() { String::new() } else { format!(" ({})", inputs.join(", ")) };
        let mut notes = Vec::new();
        if let Some(state) = state {
            notes.push(format!("{state:?}").to_lowercase());
        }
        if let Step::Element { element, evaluated, .. } = &self.steps[index] {
            let twin = self.elements[*evaluated];
            if !std::ptr::eq(*element, twin) {
                notes.push(format!("evaluated as {twin}"));
            }
        }
        format!("{:4} = {:32}{}", format!("s{index}"), self.name(index) + &from, notes.join(", "))
    }

    /// How the user calls a step.
    fn name(&self, index: usize) -> String {
        match &self.steps[index] {
            Step::Tip(support) => support.to_string(),
            Step::Element { element, .. } => element.to_string(),
            Step::Connection { connection, .. } => connection.to_string(),
            Step::Root { support, .. } => format!("{support}, the root"),
        }
    }

    /// The way from each tip, as in a sketch, up to what another one has led over.
    fn write_paths(&self, f: &mut Formatter<'_>) -> Result {
        let mut is_written = vec![false; self.steps.len()];
        for tip in (0..self.steps.len()).filter(|&step| matches!(self.steps[step], Step::Tip(_))) {
            let mut step = tip;
            write!(f, "{}", self.name(step))?;
            while let Some(next) = self.downstream(step).filter(|_| !is_written[step]) {
                is_written[step] = true;
                step = next;
                write!(f, " -> {}", self.name(step))?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}
