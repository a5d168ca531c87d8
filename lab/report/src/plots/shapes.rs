//! Mode shapes, one above the other.

use crate::axis::Axis;
use crate::canvas::{Area, Chart, Drawn, PANEL, TEXT, UNIT, axes, drawing, style};
use crate::data::shapes::{Mode, Shapes};
use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, GRID, QUIET, VERMILION};
use mstmm::Complex;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

const SHAPE: Look = Look { hue: BLUE, marker: Marker::Circle, dash: None };
const QUADRATURE: Look = Look { hue: VERMILION, marker: Marker::Diamond, dash: Some(6) };
/// Height of a mode in pixels.
const ROW: i32 = 70;
/// Height of what is around the modes in pixels.
const FRAME: i32 = 80;
/// Half of the height of a row in units of the largest deflection: room for the name.
const HALF: f64 = 1.9;

/// The panel of an example, the first mode on top.
pub(crate) fn svg(shapes: &Shapes) -> Result<String, ReportError> {
    let count = shapes.modes.len();
    let height = FRAME + ROW * count as i32;
    drawing((PANEL.0, height), |area| {
        let places = shapes.modes.iter().flat_map(|mode| mode.outline.iter().map(|point| point.0));
        let x = Axis::linear("x [m]", 0.0..places.fold(0.0, f64::max));
        let y = Axis::linear("deflection / largest", -HALF..HALF * (2.0 * count as f64 - 1.0)).without_ticks();
        let mut chart = axes(area, &x, &y)?;
        for (row, mode) in shapes.modes.iter().enumerate() {
            let base = 2.0 * HALF * (count - 1 - row) as f64;
            draw(area, &mut chart, mode, base, &format!("{}:  {}", row + 1, mode.name))?;
        }
        Ok(())
    })
}

fn draw(area: &Area, chart: &mut Chart, mode: &Mode, base: f64, name: &str) -> Drawn {
    let end = mode.outline.iter().map(|point| point.0).fold(0.0, f64::max);
    chart.draw_series(LineSeries::new([(0.0, base), (end, base)], GRID.colour().stroke_width(UNIT as u32)))?;
    if mode.is_complex() {
        part(chart, mode, base, QUADRATURE, |deflection| deflection.im)?;
    }
    part(chart, mode, base, SHAPE, |deflection| deflection.re)?;
    let (x, y) = chart.backend_coord(&(0.0, base + HALF));
    let (left, top) = area.get_base_pixel();
    let place = (x - left + 6 * UNIT, y - top + UNIT);
    area.draw(&Text::new(name, place, style(QUIET, TEXT - 1.0, HPos::Left, VPos::Top)))?;
    Ok(())
}

fn part(chart: &mut Chart, mode: &Mode, base: f64, look: Look, of: impl Fn(Complex<f64>) -> f64) -> Drawn {
    let points = |list: &[(f64, Complex<f64>)]| list.iter().map(|&(x, y)| (x, base + of(y))).collect::<Vec<_>>();
    look.line(chart, &points(&mode.outline))?;
    look.marks(chart, &points(&mode.masses), true)
}
