//! Error against time of the portal's frequencies.

use super::curves::{self, Curve};
use crate::axis::Axis;
use crate::canvas::panel;
use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, GREEN, PURPLE};
use frames_beside::Figures;

/// How programs are drawn, in the order of the figures; this library is the first.
const LOOKS: [Look; 3] = [
    Look { hue: BLUE, marker: Marker::Circle, dash: None },
    Look { hue: GREEN, marker: Marker::Diamond, dash: Some(7) },
    Look { hue: PURPLE, marker: Marker::Wedge, dash: Some(3) },
];

/// Errors below half an eps are rounding of the exact value itself.
const LEAST_ERROR: f64 = 1e-16;

/// The panel of all programs.
pub(crate) fn svg(figures: &Figures) -> Result<String, ReportError> {
    let runs = || figures.programs.iter().flat_map(|program| &program.runs);
    let time = Axis::over("time [s]", runs().map(|run| run.seconds));
    let error = Axis::logarithmic("largest relative error of ten", 0.1 * LEAST_ERROR..1.0);
    let curves: Vec<Curve> = figures
        .programs
        .iter()
        .zip(LOOKS)
        .map(|(program, look)| {
            let place = |run: &frames_beside::Run| (time.place(run.seconds), error.place(run.error().max(LEAST_ERROR)));
            let points = program.runs.iter().map(place).collect();
            Curve { label: program.program.clone(), look, points, failures: Vec::new() }
        })
        .collect();
    panel(|area| curves::draw(area, &time, &error, &curves))
}
