//! Factors between the times of methods.

use crate::method::CERTIFIED;
use rivals::Run;

/// The relative error that a run must reach to be compared: that of the paper's searches.
pub(crate) const TARGET: f64 = 1e-6;

/// A rival beside the certified search.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Factor {
    pub(crate) scene: String,
    pub(crate) method: String,
    /// Time of its fastest run that reaches the target, divided by that of the certified search; none if no run does.
    pub(crate) ratio: Option<f64>,
    /// Error of that run.
    pub(crate) error: f64,
}

/// A factor for each rival in each scene.
pub(crate) fn factors(runs: &[Run]) -> Vec<Factor> {
    let mut list: Vec<Factor> = Vec::new();
    for run in runs.iter().filter(|run| run.method != CERTIFIED) {
        if list.iter().any(|factor| factor.scene == run.scene && factor.method == run.method) {
            continue;
        }
        let fastest = |method: &str| {
            let own = runs.iter().filter(|other| other.scene == run.scene && other.method == method);
            own.filter(|run| run.error <= TARGET).min_by(|a, b| a.seconds.total_cmp(&b.seconds))
        };
        let (rival, certified) = (fastest(&run.method), fastest(CERTIFIED));
        let ratio = rival.zip(certified).map(|(rival, certified)| rival.seconds / certified.seconds);
        let error = rival.map_or(f64::INFINITY, |run| run.error);
        list.push(Factor { scene: run.scene.clone(), method: run.method.clone(), ratio, error });
    }
    list
}
