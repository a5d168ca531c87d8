//! What one run of a method is worth.

use serde::Serialize;

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
    /// Median time of all wanted roots, in seconds.
    pub seconds: f64,
    /// Evaluations of Δ or of the matrix, or unknowns of an eigenproblem.
    pub evaluations: u64,
    /// Largest relative error of the wanted roots; infinite where one was not found.
    pub error: f64,
}
