//! Error against run time: a panel for each scene.

use super::curves::{self, Curve};
use crate::axis::Axis;
use crate::canvas::{Area, Drawn, panel, picture};
use crate::error::ReportError;
use crate::method::METHODS;
use crate::scene::note;
use rivals::Run;

/// Errors below half an eps are rounding of the exact value itself.
const LEAST_ERROR: f64 = 1e-16;

/// Coordinate of runs that lose a root, two decades above the largest errors.
const LOST: f64 = 3.0;

/// The scenes in the order of the runs.
pub(crate) fn scenes(runs: &[Run]) -> Vec<&str> {
    let mut scenes: Vec<&str> = Vec::new();
    for run in runs {
        if !scenes.contains(&run.scene.as_str()) {
            scenes.push(&run.scene);
        }
    }
    scenes
}

/// The panel of a scene.
pub(crate) fn svg(runs: &[Run], scene: &str) -> Result<String, ReportError> {
    panel(|area| draw(area, runs, scene))
}

/// Panels of scenes side by side, as a file of its own.
pub(crate) fn file(runs: &[Run], [left, right]: [&str; 2]) -> Result<String, ReportError> {
    let title = |scene: &str| format!("{scene}: {}", note(scene));
    picture([(&title(left), &|area| draw(area, runs, left)), (&title(right), &|area| draw(area, runs, right))])
}

fn draw(area: &Area, runs: &[Run], scene: &str) -> Drawn {
    let runs: Vec<&Run> = runs.iter().filter(|run| run.scene == scene).collect();
    let time = Axis::over("time [s]", runs.iter().map(|run| run.seconds));
    let error = Axis::logarithmic("relative error", 0.1 * LEAST_ERROR..10.0).with_name(LOST, "lost");
    let mut list = Vec::new();
    for method in METHODS {
        let own = || runs.iter().filter(|run| run.method == method.name);
        let place = |run: &&&Run| (time.place(run.seconds), error.place(run.error.max(LEAST_ERROR)));
        let points: Vec<_> = own().filter(|run| run.error.is_finite()).map(|run| place(&run)).collect();
        let failures: Vec<_> = own().filter(|run| !run.error.is_finite()).map(|run| place(&run)).collect();
        if !(points.is_empty() && failures.is_empty()) {
            list.push(Curve { label: method.label.to_owned(), look: method.look, points, failures });
        }
    }
    curves::draw(area, &time, &error, &list)
}
