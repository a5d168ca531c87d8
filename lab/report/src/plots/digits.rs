//! Digits kept by the determinant and by planes.

use super::curves::{self, Curve};
use crate::axis::Axis;
use crate::canvas::{Area, Drawn, panel, picture};
use crate::data::digits::{Digits, OverStiffness};
use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, GREEN, ORANGE};

const PLANES: Look = Look { hue: BLUE, marker: Marker::Circle, dash: None };
const DETERMINANT: Look = Look { hue: ORANGE, marker: Marker::Square, dash: Some(6) };
const HARMLESS: Look = Look { hue: GREEN, marker: Marker::Diamond, dash: Some(3) };

/// Name and look of a curve, and of which digits.
type Series<'a> = (&'static str, Look, &'a [Digits], fn(&Digits) -> Option<f64>);

/// Digits against mode number.
pub(crate) fn over_modes(rows: &[Digits]) -> Result<String, ReportError> {
    panel(|area| of_modes(area, rows))
}

/// Digits against the ratio of stiffnesses.
pub(crate) fn over_stiffness(rows: &OverStiffness) -> Result<String, ReportError> {
    panel(|area| of_ratios(area, rows))
}

/// Both side by side, as a file of its own.
pub(crate) fn file(modes: &[Digits], stiffness: &OverStiffness) -> Result<String, ReportError> {
    picture([
        ("Modes of a fixed-pinned beam", &|area| of_modes(area, modes)),
        ("Ratio of stiffnesses", &|area| of_ratios(area, stiffness)),
    ])
}

fn of_modes(area: &Area<'_>, rows: &[Digits]) -> Drawn {
    let by_planes: Series<'_> = ("planes", PLANES, rows, |row| Some(row.planes));
    draw(area, "mode number", &[by_planes, ("determinant", DETERMINANT, rows, |row| row.determinant)])
}

fn of_ratios(area: &Area<'_>, OverStiffness { tip_spring, spans }: &OverStiffness) -> Drawn {
    let series: [Series<'_>; 3] = [
        ("planes, spans", PLANES, spans, |row| Some(row.planes)),
        ("determinant, spans", DETERMINANT, spans, |row| row.determinant),
        ("determinant, tip spring", HARMLESS, tip_spring, |row| row.determinant),
    ];
    draw(area, "ratio of stiffnesses", &series)
}

fn draw(area: &Area<'_>, title: &'static str, series: &[Series<'_>]) -> Drawn {
    let x = Axis::over(title, series.iter().flat_map(|(_, _, rows, _)| rows.iter().map(|row| row.at)));
    let y = Axis::linear("correct decimal digits", 0.0..18.0);
    let curve = |&(label, look, rows, digits): &Series<'_>| {
        let kept = rows.iter().filter_map(|row| digits(row).map(|digits| (x.place(row.at), digits)));
        let lost = rows.iter().filter(|row| digits(row).is_none()).map(|row| (x.place(row.at), 0.0));
        Curve { label: label.to_owned(), look, points: kept.collect(), failures: lost.collect() }
    };
    curves::draw(area, &x, &y, &series.iter().map(curve).collect::<Vec<_>>())
}
