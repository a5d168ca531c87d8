//! Cost against size, with the exponents of growth.

use super::curves::{self, Curve};
use crate::axis::Axis;
use crate::canvas::{Area, Drawn, panel};
use crate::error::ReportError;
use crate::growth::{OverElements, OverRoots, Point, exponent, leap};
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, GREEN, ORANGE};

const SEARCH: Look = Look { hue: BLUE, marker: Marker::Circle, dash: None };
const EVALUATION: Look = Look { hue: GREEN, marker: Marker::Diamond, dash: Some(7) };
const OTHER: Look = Look { hue: ORANGE, marker: Marker::Square, dash: Some(3) };

type Series<'a> = (&'a str, Look, &'a [Point]);

/// Costs against the number of elements.
pub(crate) fn over_elements(costs: &OverElements) -> Result<String, ReportError> {
    let series = [("search", SEARCH, costs.search.as_slice()), ("evaluation", EVALUATION, &costs.evaluation)];
    panel(|area| draw(area, ["number of beams", "time [s]"], &series))
}

/// Cost of a root against its mode number.
pub(crate) fn over_roots(costs: &OverRoots) -> Result<String, ReportError> {
    let OverRoots { pinned, cantilever, alone } = costs;
    let series: [Series<'_>; 3] =
        [("pinned", SEARCH, pinned), ("one alone", EVALUATION, alone), ("cantilever", OTHER, cantilever)];
    panel(|area| draw(area, ["mode number", "time per root [s]"], &series))
}

/// Costs of a building against its number of storeys.
pub(crate) fn over_storeys(costs: &OverElements) -> Result<String, ReportError> {
    let series = [("ten frequencies", SEARCH, costs.search.as_slice()), ("evaluation", EVALUATION, &costs.evaluation)];
    panel(|area| draw(area, ["storeys", "time [s]"], &series))
}

/// A name with the exponent of growth, where there is one.
fn label(name: &str, points: &[Point]) -> String {
    let power = exponent(points);
    if leap(points).is_some() || power.is_nan() { name.to_owned() } else { format!("{name}: exponent {power:.2}") }
}

fn draw(area: &Area, [size, time]: [&'static str; 2], series: &[Series<'_>]) -> Drawn {
    let all = || series.iter().flat_map(|(_, _, points)| points.iter());
    let x = Axis::over(size, all().map(|point| point.size as f64));
    let y = Axis::over(time, all().map(|point| point.seconds));
    let curve = |&(name, look, points): &Series<'_>| Curve {
        label: label(name, points),
        look,
        points: points.iter().map(|point| (x.place(point.size as f64), y.place(point.seconds))).collect(),
        failures: Vec::new(),
    };
    curves::draw(area, &x, &y, &series.iter().map(curve).collect::<Vec<_>>())
}
