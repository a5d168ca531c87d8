//! Canvases: drawings as text, and the frame of a plot.

use crate::axis::Axis;
use crate::error::ReportError;
use crate::palette::{GRID, Hue, INK, PAPER, QUIET, dark_rules};
use plotters::chart::ChartContext;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Units of a drawing in a pixel: plotters rounds coordinates to whole units, which is too coarse for pixels.
pub(crate) const UNIT: i32 = 10;
/// Size of a panel in pixels.
pub(crate) const PANEL: (i32, i32) = (400, 290);
/// Size of text in pixels.
pub(crate) const TEXT: f64 = 13.0;
/// plotters writes fonts smaller by this factor than it is told.
const FONT: f64 = 1.24;

/// A drawing, or part of one.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// A plot in its axes.
pub(crate) type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;
/// What drawing gives.
pub(crate) type Drawn = Result<(), ReportError>;

/// A drawing of a size in pixels, as the text of an `svg` element.
pub(crate) fn drawing(size: (i32, i32), draw: impl FnOnce(&Area) -> Drawn) -> Result<String, ReportError> {
    let mut text = String::new();
    {
        let units = [size.0, size.1].map(|pixels| (pixels * UNIT) as u32);
        let area = SVGBackend::with_string(&mut text, units.into()).into_drawing_area();
        draw(&area)?;
        area.present()?;
    }
    Ok(text)
}

/// A drawing of one panel.
pub(crate) fn panel(draw: impl FnOnce(&Area) -> Drawn) -> Result<String, ReportError> {
    drawing(PANEL, draw)
}

/// Height of the title of a panel in a picture, in pixels.
const TITLE: i32 = 26;

/// Room at the left of a picture in pixels.
const EDGE: i32 = 8;

/// A panel with its title.
pub(crate) type Titled<'a> = (&'a str, &'a dyn Fn(&Area) -> Drawn);

/// Two panels as a file of its own, readable on light and dark pages: it brings its background along.
pub(crate) fn picture(panels: [Titled<'_>; 2]) -> Result<String, ReportError> {
    let (width, height) = (2 * PANEL.0, PANEL.1 + TITLE);
    let drawn = drawing((width, height), |area| {
        area.fill(&PAPER.colour())?;
        for (part, (title, draw)) in area.margin(0, 0, EDGE * UNIT, 0).split_evenly((1, 2)).iter().zip(panels) {
            let (head, body) = part.split_vertically(TITLE * UNIT);
            let place = (2 * UNIT, 6 * UNIT);
            head.draw(&Text::new(title, place, style(INK, TEXT + 2.0, HPos::Left, VPos::Top)))?;
            draw(&body)?;
        }
        Ok(())
    })?;
    // the drawing's own head has its size in units
    let (units, body) = ([width * UNIT, height * UNIT], drawn.split_once(">\n").map_or("", |(_, body)| body));
    let head = format!(r#"width="{width}" height="{height}" viewBox="0 0 {} {}""#, units[0], units[1]);
    let style = format!("@media (prefers-color-scheme: dark) {{ {} }}", dark_rules());
    Ok(format!("<svg {head} xmlns=\"http://www.w3.org/2000/svg\">\n<style>{style}</style>\n{body}"))
}

/// Text of a colour and size in pixels, anchored at its place.
pub(crate) fn style(hue: Hue, pixels: f64, horizontal: HPos, vertical: VPos) -> TextStyle<'static> {
    let font = ("sans-serif", pixels * FONT * f64::from(UNIT)).into_font();
    TextStyle { font, color: hue.colour().to_backend_color(), pos: Pos::new(horizontal, vertical) }
}

/// Axes with their titles: that of y above its axis, where it reads without turning one's head.
pub(crate) fn axes<'a, 'b>(area: &'a Area<'b>, x: &Axis, y: &Axis) -> Result<Chart<'a, 'b>, ReportError> {
    let (width, height) = area.dim_in_pixel();
    let title = |hue, horizontal, vertical| style(hue, TEXT, horizontal, vertical);
    area.draw(&Text::new(y.title, (2 * UNIT, 3 * UNIT), title(INK, HPos::Left, VPos::Top)))?;
    let corner = (width as i32 - 24 * UNIT, height as i32 - 3 * UNIT);
    area.draw(&Text::new(x.title, corner, title(INK, HPos::Right, VPos::Bottom)))?;
    let mut chart = ChartBuilder::on(area)
        .margin_top(30 * UNIT)
        .margin_right(24 * UNIT)
        .margin_bottom(18 * UNIT)
        .margin_left(2 * UNIT)
        .x_label_area_size(24 * UNIT)
        .y_label_area_size(48 * UNIT)
        .build_cartesian_2d(x.clone(), y.clone())?;
    chart
        .configure_mesh()
        .axis_style(QUIET.colour().stroke_width(UNIT as u32))
        .bold_line_style(GRID.colour().stroke_width(UNIT as u32))
        .set_all_tick_mark_size(4 * UNIT)
        .label_style(style(QUIET, TEXT - 1.0, HPos::Left, VPos::Top))
        .draw()?;
    Ok(chart)
}
