//! Digits kept by the determinant and by planes.

use super::curves::{self, Curve};
use crate::axis::Axis;
use crate::canvas::{Area, Drawn, panel, picture};
use crate::data::digits::Digits;
use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, ORANGE};

const PLANES: Look = Look { hue: BLUE, marker: Marker::Circle, dash: None };
const DETERMINANT: Look = Look { hue: ORANGE, marker: Marker::Square, dash: Some(6) };

/// Digits against mode number.
pub(crate) fn over_modes(rows: &[Digits]) -> Result<String, ReportError> {
    panel(|area| draw(area, "mode number", rows))
}

/// Digits against the ratio of stiffnesses.
pub(crate) fn over_stiffness(rows: &[Digits]) -> Result<String, ReportError> {
    panel(|area| draw(area, "tip spring / (EI/l³)", rows))
}

/// Both side by side, as a file of its own.
pub(crate) fn file(modes: &[Digits], stiffness: &[Digits]) -> Result<String, ReportError> {
    picture([
        ("Modes of a fixed-pinned beam", &|area| draw(area, "mode number", modes)),
        ("Tip spring of a cantilever", &|area| draw(area, "tip spring / (EI/l³)", stiffness)),
    ])
}

fn draw(area: &Area, title: &'static str, rows: &[Digits]) -> Drawn {
    let x = Axis::over(title, rows.iter().map(|row| row.at));
    let y = Axis::linear("correct decimal digits", 0.0..18.0);
    let planes = rows.iter().map(|row| (x.place(row.at), row.planes)).collect();
    let kept = rows.iter().filter_map(|row| row.determinant.map(|digits| (x.place(row.at), digits)));
    let lost = rows.iter().filter(|row| row.determinant.is_none()).map(|row| (x.place(row.at), 0.0));
    let determinant =
        Curve { label: "determinant".to_owned(), look: DETERMINANT, points: kept.collect(), failures: lost.collect() };
    let planes = Curve { label: "planes".to_owned(), look: PLANES, points: planes, failures: Vec::new() };
    curves::draw(area, &x, &y, &[planes, determinant])
}
