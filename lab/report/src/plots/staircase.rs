//! N(ω) as a staircase, over a range and magnified.

use crate::axis::Axis;
use crate::canvas::{Area, Chart, Drawn, TEXT, UNIT, axes, panel, style};
use crate::data::counts::{Magnified, Staircase};
use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, INK, VERMILION};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

const COUNT: Look = Look { hue: BLUE, marker: Marker::Circle, dash: None };
const ROOT: Look = Look { hue: VERMILION, marker: Marker::Wedge, dash: None };
/// Room above the highest step and below the lowest, in steps.
const ROOM: f64 = 0.7;
/// Least width of an interval in pixels, so that it can be seen.
const LEAST: i32 = 3;

/// N from rest to the last frequency, with the certified frequencies.
pub(crate) fn svg(staircase: &Staircase) -> Result<String, ReportError> {
    panel(|area| {
        let end = staircase.samples.iter().map(|sample| sample.0).fold(0.0, f64::max);
        let x = Axis::linear("ω [rad/s]", 0.0..end);
        let y = steps(staircase.samples.iter().map(|sample| sample.1));
        let mut chart = axes(area, &x, &y)?;
        COUNT.line(&mut chart, &corners(&staircase.samples, |omega| omega))?;
        let marks = staircase.roots.iter().map(|root| (root.root.omega, -0.4));
        ROOT.marks(&mut chart, &marks.collect::<Vec<_>>(), true)
    })
}

/// N around a frequency, each decade of the distance with the same width.
pub(crate) fn magnified(magnified: &Magnified) -> Result<String, ReportError> {
    panel(|area| {
        let x = Axis::magnifying("relative distance from ω", -1, &[-12, -8, -4]);
        let y = steps(magnified.samples.iter().map(|sample| sample.1));
        let mut chart = axes(area, &x, &y)?;
        for ends in &magnified.intervals {
            interval(&mut chart, ends.map(|end| x.place(end)))?;
        }
        let place = |distance| x.place(distance);
        COUNT.line(&mut chart, &corners(&magnified.samples, place))?;
        let points: Vec<_> = magnified.samples.iter().map(|&(at, count)| (place(at), count as f64)).collect();
        COUNT.dots(&mut chart, &points)?;
        name(area, &chart, &x, magnified)
    })
}

/// The axis of counts.
fn steps(counts: impl Iterator<Item = u64>) -> Axis {
    let (least, most) = counts.fold((u64::MAX, 0), |(least, most), count| (least.min(count), most.max(count)));
    let ticks = (least..=most).map(|count| count as f64).collect();
    Axis::linear("N, frequencies below", least as f64 - ROOM..most as f64 + ROOM).with_ticks(ticks)
}

/// The corners of a staircase that steps halfway between two samples.
fn corners(samples: &[(f64, u64)], place: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let mut corners = Vec::new();
    for pair in samples.windows(2) {
        let [(x, count), (next, higher)] = [pair[0], pair[1]].map(|(at, count)| (place(at), count as f64));
        let middle = f64::midpoint(x, next);
        corners.extend([(x, count), (middle, count), (middle, higher), (next, higher)]);
    }
    corners
}

/// A certified interval: a band over the height of the picture.
fn interval(chart: &mut Chart<'_, '_>, [start, end]: [f64; 2]) -> Drawn {
    let rows = chart.y_range();
    let pixels = |x: f64| chart.backend_coord(&(x, rows.start)).0;
    let missing = (LEAST * UNIT - (pixels(end) - pixels(start))).max(0);
    let columns = chart.x_range();
    let scale = (columns.end - columns.start) / f64::from(pixels(columns.end) - pixels(columns.start));
    let half = f64::from(missing) * scale / 2.0;
    let corners = [(start - half, rows.start), (end + half, rows.end)];
    chart.draw_series([Rectangle::new(corners, VERMILION.colour().mix(0.35).filled())])?;
    Ok(())
}

/// Says what the bands are, where there is room: beside a single one, between two.
fn name(area: &Area<'_>, chart: &Chart<'_, '_>, x: &Axis, magnified: &Magnified) -> Drawn {
    let (text, at, gap, anchor) = match magnified.intervals.as_slice() {
        [ends] => ("certified interval", ends[0], -8 * UNIT, HPos::Right),
        _ => ("certified intervals", 0.0, 0, HPos::Center),
    };
    let (left, top) = area.get_base_pixel();
    let (column, row) = chart.backend_coord(&(x.place(at), chart.y_range().end));
    area.draw(&Text::new(text, (column - left + gap, row - top + 4 * UNIT), style(INK, TEXT, anchor, VPos::Top)))?;
    Ok(())
}
