//! Curves with markers and a label beside each.

use crate::axis::Axis;
use crate::canvas::{Area, Chart, Drawn, UNIT, axes};
use crate::marker::Look;
use crate::palette::INK;
use crate::placement::{Frame, Placement, write};

/// A curve in coordinates of its axes.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub(crate) label: String,
    pub(crate) look: Look,
    /// Results, joined by a line.
    pub(crate) points: Vec<(f64, f64)>,
    /// Where there is no result: not joined, and hollow.
    pub(crate) failures: Vec<(f64, f64)>,
}

/// Draws curves with labels where they hide least.
pub(crate) fn draw(area: &Area, x: &Axis, y: &Axis, curves: &[Curve]) -> Drawn {
    let mut chart = axes(area, x, y)?;
    // the last are the least important: the first are drawn over them
    for curve in curves.iter().rev() {
        curve.look.line(&mut chart, &curve.points)?;
    }
    for curve in curves.iter().rev() {
        curve.look.marks(&mut chart, &curve.failures, false)?;
        curve.look.marks(&mut chart, &curve.points, true)?;
    }
    labels(area, &chart, curves)
}

fn labels(area: &Area, chart: &Chart, curves: &[Curve]) -> Drawn {
    let (columns, rows) = chart.plotting_area().get_pixel_range();
    let within = Frame {
        left: columns.start + 3 * UNIT,
        top: rows.start + 3 * UNIT,
        right: columns.end - 3 * UNIT,
        bottom: rows.end - 3 * UNIT,
    };
    let mut placement = Placement::new(within);
    let places = |points: &[(f64, f64)]| points.iter().map(|point| chart.backend_coord(point)).collect::<Vec<_>>();
    for curve in curves {
        placement.avoid(&places(&curve.points));
        for failure in places(&curve.failures) {
            placement.avoid(&[failure]);
        }
    }
    for curve in curves {
        // the end of a curve is where one looks for its name
        let mut near = places(&curve.points);
        near.reverse();
        near.extend(places(&curve.failures));
        if let Some(frame) = placement.find(&curve.label, &near) {
            write(area, frame, &curve.label, INK)?;
        }
    }
    Ok(())
}
