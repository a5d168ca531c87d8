//! The plan as text: equation, unknowns, steps and paths. The documentation of the built system shows it.

use super::{Plan, Step, is_known};
use mstmm_plan::Scheme;
use std::fmt::{Display, Formatter, Result};

/// Number of steps up to which the main transfer equation is written out: one term per tip, as long as its way to the root.
const LONGEST_IN_FULL: usize = 24;

const NOTATION: &str = "\
`s0` is the state behind step 0 below, `U` the transfer matrix of an element. Where paths meet, the first gives the
displacements, and each its forces: `F` takes the forces of a state alone. `P` takes of a state what goes on to fewer.";

impl Display for Plan<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        self.resolved(|scheme| Text { plan: self, scheme }.write(f))
    }
}

/// A plan and what follows from it.
struct Text<'p> {
    plan: &'p Plan<'p>,
    scheme: Scheme<'p>,
}

impl Text<'_> {
    fn write(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "# Equation\n\n{NOTATION}\n\n```text")?;
        if is_known(self.scheme) {
            self.write_equation(f)?;
        } else {
            writeln!(f, "U_all z_all = 0; its size `N` depends on elements that only the compiler knows")?;
        }
        writeln!(f, "```\n\n# Steps\n\n```text")?;
        for step in 0..=self.root() {
            writeln!(f, "{}", self.step_line(step).trim_end())?;
        }
        writeln!(f, "```\n\n# Paths\n\n```text")?;
        self.write_paths(f)?;
        write!(f, "```")
    }

    /// The last step.
    fn root(&self) -> usize {
        self.scheme.len() - 1
    }

    /// The steps from which paths start.
    fn tips(&self) -> impl Iterator<Item = usize> {
        (0..self.root()).filter(|&step| matches!(self.plan.steps[step], Step::Tip(_)))
    }

    /// The size of the overall equation, its unknowns, the main transfer equation and the geometrical equations.
    fn write_equation(&self, f: &mut Formatter<'_>) -> Result {
        let root = self.root();
        let mut tips: Vec<usize> = self.tips().collect();
        tips.sort_by_key(|&tip| self.scheme.places[tip].first_column);
        let unknowns: Vec<String> = tips.iter().chain([&root]).flat_map(|&boundary| self.unknowns(boundary)).collect();
        let equations: Vec<String> = (0..=root).flat_map(|step| self.geometrical_equations(step)).collect();
        let (size, main) = (self.scheme.size(), self.scheme.space(root).size());
        writeln!(
            f,
            "U_all z_all = 0, {size} x {size}: {main} rows of the main transfer equation, geometrical equations: {}",
            equations.len()
        )?;
        writeln!(f, "z_all = [{}]", unknowns.join(", "))?;
        if self.scheme.len() <= LONGEST_IN_FULL {
            let paths: Vec<String> = tips.into_iter().map(|tip| self.product(tip)).collect();
            writeln!(f, "s{root} = {}", paths.join("\n    + "))?;
        }
        equations.iter().try_for_each(|equation| writeln!(f, "{equation}"))
    }

    /// The unknown entries of the state at a boundary.
    fn unknowns(&self, boundary: usize) -> Vec<String> {
        let Some(support) = self.scheme.steps[boundary].support() else { return Vec::new() };
        let space = self.scheme.space(boundary);
        support.unknowns(space).map(|entry| format!("{}(s{boundary})", entry.symbol(space))).collect()
    }

    /// What a connection demands: its inputs have the displacements of the first, and what does not go on has no force.
    fn geometrical_equations(&self, step: usize) -> Vec<String> {
        let [first, others @ ..] = self.scheme.inputs(step) else { return Vec::new() };
        let mut equations = Vec::new();
        for other in others {
            let space = self.scheme.space(*other);
            for entry in space.displacements().iter().map(|entry| entry.symbol(space)) {
                equations.push(format!("{entry}(s{other}) = {entry}(s{first})"));
            }
        }
        for force in self.scheme.left_behind(step).forces() {
            equations.push(format!("{}(s{step}) = 0", force.symbol(self.scheme.space(step))));
        }
        equations
    }

    /// The way of a tip's state to the root, `U(body 2) U(beam 1) s0`.
    fn product(&self, tip: usize) -> String {
        let mut product = format!("s{tip}");
        let mut step = tip;
        while step != self.root() {
            let next = self.scheme.downstream(step);
            match &self.plan.steps[next] {
                Step::Element { element, .. } => {
                    let narrows = !self.scheme.left_behind(step).is_empty();
                    product = format!("U({element}) {}{product}", if narrows { "P " } else { "" });
                }
                Step::Connection { .. } if self.scheme.inputs(next)[0] != step => {
                    product = format!("F {product}");
                }
                _ => {}
            }
            step = next;
        }
        product
    }

    /// `s4 = conn 2 (s1, s3)` with the state behind it.
    fn step_line(&self, step: usize) -> String {
        let inputs: Vec<String> = self.scheme.steps[step].inputs().iter().map(|input| format!("s{input}")).collect();
        let from = if inputs.is_empty() { String::new() } else { format!(" ({})", inputs.join(", ")) };
        let mut notes = vec![self.scheme.space(step).to_string()];
        if let Step::Element { element, evaluated, .. } = &self.plan.steps[step] {
            let twin = self.plan.elements[*evaluated];
            if !std::ptr::eq(*element, twin) {
                notes.push(format!("evaluated as {twin}"));
            }
        }
        notes.retain(|note| !note.is_empty());
        format!("{:4} = {:32}{}", format!("s{step}"), self.name(step) + &from, notes.join(", "))
    }

    /// How the user calls a step.
    fn name(&self, step: usize) -> String {
        match &self.plan.steps[step] {
            Step::Tip(support) => support.to_string(),
            Step::Element { element, .. } => element.to_string(),
            Step::Connection { connection, .. } => connection.to_string(),
            Step::Root { support, .. } => format!("{support}, the root"),
        }
    }

    /// The way from each tip, as in a sketch, up to what another one has led over.
    fn write_paths(&self, f: &mut Formatter<'_>) -> Result {
        let mut is_written = vec![false; self.scheme.len()];
        for tip in self.tips() {
            let mut step = tip;
            write!(f, "{}", self.name(step))?;
            while step != self.root() && !is_written[step] {
                is_written[step] = true;
                step = self.scheme.downstream(step);
                write!(f, " -> {}", self.name(step))?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}
