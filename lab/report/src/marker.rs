//! Markers and lines of the series of a plot, different in shape as well as in colour.

use crate::axis::Axis;
use crate::canvas::{Chart, Drawn, UNIT, drawing};
use crate::error::ReportError;
use crate::palette::{Hue, PAPER};
use plotters::prelude::*;
use plotters::style::ShapeStyle;

/// Half the size of a marker in units.
const HALF: i32 = 4 * UNIT + UNIT / 2;

/// Shape of a marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Marker {
    Circle,
    Square,
    Triangle,
    Diamond,
    Wedge,
    Cross,
}

impl Marker {
    /// Corners of the outline in units from its centre.
    fn corners(self) -> Vec<(i32, i32)> {
        let (h, k) = (HALF, HALF / 3);
        match self {
            Marker::Circle => (0..24)
                .map(|n| (f64::from(n) * std::f64::consts::TAU / 24.0).sin_cos())
                .map(|(sin, cos)| ((f64::from(h) * cos) as i32, (f64::from(h) * sin) as i32))
                .collect(),
            Marker::Square => {
                vec![(-h, -h), (h, -h), (h, h), (-h, h)].into_iter().map(|(x, y)| (x * 7 / 8, y * 7 / 8)).collect()
            }
            Marker::Triangle => vec![(0, -h * 6 / 5), (h * 6 / 5, h), (-h * 6 / 5, h)],
            Marker::Diamond => vec![(0, -h * 5 / 4), (h * 5 / 4, 0), (0, h * 5 / 4), (-h * 5 / 4, 0)],
            Marker::Wedge => vec![(0, h * 6 / 5), (h * 6 / 5, -h), (-h * 6 / 5, -h)],
            Marker::Cross => {
                let arm = vec![(0, k), (h - k, h), (h, h - k), (k, 0)];
                (0..4)
                    .scan(arm, |arm, _| {
                        let now = arm.clone();
                        *arm = arm.iter().map(|&(x, y)| (y, -x)).collect();
                        Some(now)
                    })
                    .flatten()
                    .collect()
            }
        }
    }
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Look {
    pub(crate) hue: Hue,
    pub(crate) marker: Marker,
    /// Length of dashes in pixels, none of an unbroken line.
    pub(crate) dash: Option<i32>,
}

impl Look {
    /// Draws a marker at each point, filled or, where something is amiss, hollow.
    pub(crate) fn marks(self, chart: &mut Chart, points: &[(f64, f64)], is_filled: bool) -> Drawn {
        let colour = self.hue.colour();
        let fill = if is_filled { colour } else { PAPER.colour() };
        chart.draw_series(points.iter().map(|&point| {
            let mut outline = self.marker.corners();
            let inside = Polygon::new(outline.clone(), fill.filled());
            outline.extend(outline.first().copied());
            // the rim parts markers that lie on each other
            let rim = if is_filled { PAPER.colour() } else { colour };
            EmptyElement::at(point) + inside + PathElement::new(outline, rim.stroke_width(UNIT as u32))
        }))?;
        Ok(())
    }

    /// Draws a dot at each point, for many points on a line.
    pub(crate) fn dots(self, chart: &mut Chart, points: &[(f64, f64)]) -> Drawn {
        let colour = self.hue.colour();
        chart.draw_series(points.iter().map(|&point| Circle::new(point, 2 * UNIT, colour.filled())))?;
        Ok(())
    }

    /// Draws the line through points.
    pub(crate) fn line(self, chart: &mut Chart, points: &[(f64, f64)]) -> Drawn {
        let style: ShapeStyle = self.hue.colour().stroke_width(2 * UNIT as u32);
        let points = points.iter().copied();
        match self.dash {
            None => chart.draw_series(LineSeries::new(points, style))?,
            Some(dash) => chart.draw_series(DashedLineSeries::new(points, dash * UNIT, 4 * UNIT, style))?,
        };
        Ok(())
    }

    /// A drawing of the look for a legend.
    pub(crate) fn sample(self) -> Result<String, ReportError> {
        drawing((40, 16), |area| {
            let unit = || Axis::linear("", 0.0..1.0);
            let mut chart = ChartBuilder::on(area).build_cartesian_2d(unit(), unit())?;
            self.line(&mut chart, &[(0.0, 0.5), (1.0, 0.5)])?;
            self.marks(&mut chart, &[(0.5, 0.5)], true)
        })
    }
}
