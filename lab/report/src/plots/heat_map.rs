//! |Δ| over the complex plane: filled contours, with the eigenvalues marked.

use crate::axis::{Axis, power_of_ten};
use crate::canvas::{Area, Chart, Drawn, TEXT, UNIT, axes, drawing, style};
use crate::data::landscapes::HeatMap;
use crate::error::ReportError;
use crate::palette::QUIET;
use contour::ContourBuilder;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

/// Levels of colour.
const LEVELS: i32 = 20;
/// Size in pixels: both axes have the same scale, so that pits are round.
const SIZE: (i32, i32) = (400, 500);
/// Exponents of ten between which |Δ| is shown: pits have no bottom.
const SHOWN: [i32; 2] = [-2, 2];
/// Size of the scale of colours in pixels.
const SCALE: (i32, i32) = (90, 10);

/// The panel of the damped example.
pub(crate) fn svg(map: &HeatMap) -> Result<String, ReportError> {
    drawing(SIZE, |area| -> Drawn {
        let x = Axis::linear("Re λ [1/s]", *map.re.start()..*map.re.end());
        let y = Axis::linear("Im λ [1/s]", *map.im.start()..*map.im.end());
        let mut chart = axes(area, &x, &y)?;
        let [low, high] = SHOWN.map(f64::from);
        fill(&mut chart, map, low, high)?;
        let [re, im] = &map.searched;
        let corners = [(*re.start(), *im.start()), (*re.end(), *im.end())];
        chart.draw_series([Rectangle::new(corners, WHITE.stroke_width(UNIT as u32))])?;
        chart.draw_series(map.roots.iter().map(|root| {
            let ring = |radius: i32, colour: RGBColor| Circle::new((0, 0), radius, colour.filled());
            EmptyElement::at((root.re, root.im)) + ring(5 * UNIT, BLACK) + ring(4 * UNIT, WHITE)
        }))?;
        scale(area, low, high)
    })
}

/// Paints from the highest level down. |Δ| over its trend has no maximum but at the edge, so that what lies below a level has no
/// holes.
fn fill(chart: &mut Chart, map: &HeatMap, low: f64, high: f64) -> Drawn {
    let (columns, rows) = (map.columns, map.values.len() / map.columns);
    let step = |start: f64, end: f64, count: usize| (end - start) / (count - 1) as f64;
    let (dx, dy) = (step(*map.re.start(), *map.re.end(), columns), step(*map.im.start(), *map.im.end(), rows));
    let level = |n: i32| low + (high - low) * f64::from(n) / f64::from(LEVELS);
    chart.draw_series([Rectangle::new(
        [(*map.re.start(), *map.im.start()), (*map.re.end(), *map.im.end())],
        colour(LEVELS - 1).filled(),
    )])?;
    // contours are of what lies above a threshold
    let depths: Vec<f64> = map.values.iter().map(|value| -value.max(low)).collect();
    for n in (1..LEVELS).rev() {
        // a sample is the middle of its cell
        let builder = ContourBuilder::new(columns, rows, true)
            .x_origin(*map.re.start() - dx / 2.0)
            .y_origin(*map.im.start() - dy / 2.0)
            .x_step(dx)
            .y_step(dy);
        for contour in builder.contours(&depths, &[-level(n)])? {
            let into = |value: f64, range: &std::ops::RangeInclusive<f64>| value.clamp(*range.start(), *range.end());
            chart.draw_series(contour.geometry().iter().map(|polygon| {
                let corners = polygon.exterior().coords().map(|place| (into(place.x, &map.re), into(place.y, &map.im)));
                Polygon::new(corners.collect::<Vec<_>>(), colour(n - 1).filled())
            }))?;
        }
    }
    Ok(())
}

/// Colour of the values between a level and the next.
fn colour(level: i32) -> RGBColor {
    ViridisRGB.get_color(f64::from(level) / f64::from(LEVELS - 1))
}

/// Which colour is which |Δ|.
fn scale(area: &Area, low: f64, high: f64) -> Drawn {
    let [left, right] = [low, high].map(|value| power_of_ten(value.round() as i32));
    // in the line of the title of the upright axis
    let (end, top) = ((SIZE.0 - 24) * UNIT - 5 * TEXT as i32 * UNIT / 2, 6 * UNIT);
    let (start, bottom) = (end - SCALE.0 * UNIT, top + SCALE.1 * UNIT);
    for n in 0..LEVELS {
        let edge = |n: i32| start + (end - start) * n / LEVELS;
        area.draw(&Rectangle::new([(edge(n), top), (edge(n + 1), bottom)], colour(n).filled()))?;
    }
    let middle = (top + bottom) / 2;
    let text = |horizontal| style(QUIET, TEXT - 1.0, horizontal, VPos::Center);
    area.draw(&Text::new(left, (start - 5 * UNIT, middle), text(HPos::Right)))?;
    area.draw(&Text::new(right, (end + 5 * UNIT, middle), text(HPos::Left)))?;
    Ok(())
}
