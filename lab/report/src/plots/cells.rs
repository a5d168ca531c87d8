//! Counts of eigenvalues in rectangles.

use crate::axis::Axis;
use crate::canvas::{Area, Chart, Drawn, TEXT, UNIT, axes, drawing, style};
use crate::data::counts::{Cell, Cells};
use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, INK, QUIET, VERMILION};
use mstmm::prelude::Region;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

const ROOT: Look = Look { hue: VERMILION, marker: Marker::Circle, dash: None };
/// Size in pixels.
const SIZE: (i32, i32) = (400, 420);
/// Least height and width of a rectangle with its number in it, in pixels.
const LEAST: (i32, i32) = (20, 17);

/// The rectangles, those with eigenvalues in colour.
pub(crate) fn svg(cells: &Cells) -> Result<String, ReportError> {
    drawing(SIZE, |area| {
        let of = |pick: fn(&Cell) -> [f64; 2]| {
            let ends = cells.leaves.iter().map(pick);
            ends.fold([f64::INFINITY, -f64::INFINITY], |[low, high], [start, end]| [low.min(start), high.max(end)])
        };
        let [left, right] = of(|cell| [*cell.region.re.start(), *cell.region.re.end()]);
        let [bottom, top] = of(|cell| [*cell.region.im.start(), *cell.region.im.end()]);
        let mut chart = axes(area, &Axis::linear("Re λ [1/s]", left..right), &Axis::linear("Im λ [1/s]", bottom..top))?;
        for cell in &cells.leaves {
            draw(area, &mut chart, cell)?;
        }
        let roots: Vec<_> = cells.roots.iter().map(|root| (root.re, root.im)).collect();
        ROOT.marks(&mut chart, &roots, true)
    })
}

fn draw(area: &Area<'_>, chart: &mut Chart<'_, '_>, cell: &Cell) -> Drawn {
    let Region { re, im } = &cell.region;
    let corners = [(*re.start(), *im.start()), (*re.end(), *im.end())];
    if cell.count > 0 {
        chart.draw_series([Rectangle::new(corners, BLUE.colour().mix(0.25).filled())])?;
    }
    chart.draw_series([Rectangle::new(corners, QUIET.colour().stroke_width(UNIT as u32))])?;
    let [low, high] = corners.map(|corner| chart.backend_coord(&corner));
    if high.0 - low.0 < LEAST.0 * UNIT || low.1 - high.1 < LEAST.1 * UNIT {
        return Ok(());
    }
    let (left, top) = area.get_base_pixel();
    // in a corner, where an eigenvalue hides it least
    let place = (low.0 + 4 * UNIT - left, high.1 + UNIT - top);
    let hue = if cell.count > 0 { INK } else { QUIET };
    area.draw(&Text::new(cell.count.to_string(), place, style(hue, TEXT - 1.0, HPos::Left, VPos::Top)))?;
    Ok(())
}
