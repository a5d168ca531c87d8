//! |Δ| over ω, with the roots marked.

use crate::axis::Axis;
use crate::canvas::{Drawn, UNIT, axes, panel};
use crate::data::landscapes::Landscape;
use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, VERMILION};
use plotters::prelude::*;

const ROOT: Look = Look { hue: VERMILION, marker: Marker::Wedge, dash: None };
/// Room below the samples, where the roots are marked, as a share of their height.
const ROOM: f64 = 0.08;

/// The panel of an example.
pub(crate) fn svg(landscape: &Landscape) -> Result<String, ReportError> {
    panel(|area| -> Drawn {
        let logarithms = || landscape.samples.iter().map(|sample| sample.1).filter(|value| value.is_finite());
        let (low, high) = logarithms().fold((f64::INFINITY, -f64::INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let room = ROOM * (high - low);
        let most = landscape.samples.iter().map(|sample| sample.0).fold(0.0, f64::max);
        let x = Axis::linear("ω [rad/s]", 0.0..most);
        let y = Axis::logarithmic("|Δ|, SI units", 10f64.powf(low - room)..10f64.powf(high));
        let mut chart = axes(area, &x, &y)?;
        let curve = landscape.samples.iter().map(|&(omega, value)| (omega, value.max(low)));
        chart.draw_series(LineSeries::new(curve, BLUE.colour().stroke_width(3 * UNIT as u32 / 2)))?;
        let bottom = chart.y_range().start + room.max(0.04 * (chart.y_range().end - chart.y_range().start));
        ROOT.marks(&mut chart, &landscape.roots.iter().map(|&root| (root, bottom)).collect::<Vec<_>>(), true)
    })
}
