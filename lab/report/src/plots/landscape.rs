//! |Δ| over its trend, with the roots marked.

use crate::axis::Axis;
use crate::canvas::{Drawn, UNIT, axes, panel};
use crate::data::landscapes::Landscape;
use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, VERMILION};
use plotters::prelude::*;

const ROOT: Look = Look { hue: VERMILION, marker: Marker::Wedge, dash: None };
/// Exponents of ten between which |Δ| is shown: a pit has no bottom, and all are cut at the same depth.
const SHOWN: [i32; 2] = [-4, 1];
/// Height of the marks above the lower edge.
const ABOVE: f64 = 0.25;

/// The panel of an example.
pub(crate) fn svg(landscape: &Landscape) -> Result<String, ReportError> {
    panel(|area| -> Drawn {
        let most = landscape.samples.iter().map(|sample| sample.0).fold(0.0, f64::max);
        let [low, high] = SHOWN.map(f64::from);
        let x = Axis::linear("ω [rad/s]", 0.0..most);
        let y = Axis::logarithmic("|Δ| / trend", 10f64.powf(low)..10f64.powf(high));
        let mut chart = axes(area, &x, &y)?;
        let curve = landscape.samples.iter().map(|&(omega, value)| (omega, value.clamp(low, high)));
        chart.draw_series(LineSeries::new(curve, BLUE.colour().stroke_width(3 * UNIT as u32 / 2)))?;
        let marks = landscape.roots.iter().map(|&root| (root, low + ABOVE));
        ROOT.marks(&mut chart, &marks.collect::<Vec<_>>(), true)
    })
}
