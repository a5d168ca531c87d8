//! What one run of a method is worth.

use serde::Serialize;

/// Rounds in which every run is timed.
pub const ROUNDS: usize = 5;

/// A method at one setting of its knob, on one scene: what it costs and what its roots are worth.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Run {
    /// The scene: "4.1a", "4.2", .., "mode 100", "close pair", "stiff".
    pub scene: String,
    /// The method: "certified search", "plain method", "scan for minima", "Hermite elements", "p-version elements",
    /// "contour integral".
    pub method: String,
    /// What the knob sets, with its unit: "tolerance", "elements per beam", "degree", "quadrature nodes"; "certificate" for the
    /// certified search, which has none.
    pub knob: String,
    /// Its setting.
    pub setting: f64,
    /// Time of all wanted roots, in seconds: the median over the rounds.
    pub seconds: f64,
    /// The median time in each round, in seconds. A round is one pass over all runs: what slows the machine for a while is in one round
    /// of each, and cancels from ratios of the same round.
    pub rounds: [f64; ROUNDS],
    /// Evaluations of Δ or of the matrix, or unknowns of an eigenproblem.
    pub evaluations: u64,
    /// Largest relative error of the wanted roots; infinite where one was not found.
    pub error: f64,
}

/// The median of times or ratios.
pub(crate) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The least and the most of some values.
pub(crate) fn span(values: &[f64]) -> [f64; 2] {
    values.iter().fold([f64::INFINITY, 0.0], |[least, most], &value| [least.min(value), most.max(value)])
}
