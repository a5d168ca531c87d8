//! Cost against size, with the exponents of growth.

use super::curves::{self, Curve};
use crate::axis::Axis;
use crate::canvas::{Area, Drawn, panel};
use crate::error::ReportError;
use crate::growth::{OverElements, Point, exponent};
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, GREEN};

const EVALUATION: Look = Look { hue: GREEN, marker: Marker::Diamond, dash: Some(7) };
const SEARCH: Look = Look { hue: BLUE, marker: Marker::Circle, dash: None };

/// Costs against the number of elements.
pub(crate) fn over_elements(costs: &OverElements) -> Result<String, ReportError> {
    let series = [("search", SEARCH, costs.search.as_slice()), ("evaluation", EVALUATION, &costs.evaluation)];
    panel(|area| draw(area, ["number of beams", "time [s]"], &series))
}

/// Cost of a root against the number of roots.
pub(crate) fn over_roots(points: &[Point]) -> Result<String, ReportError> {
    panel(|area| draw(area, ["number of roots", "time per root [s]"], &[("search", SEARCH, points)]))
}

fn draw(area: &Area, [size, time]: [&'static str; 2], series: &[(&str, Look, &[Point])]) -> Drawn {
    let all = || series.iter().flat_map(|(_, _, points)| points.iter());
    let x = Axis::over(size, all().map(|point| point.size as f64));
    let y = Axis::over(time, all().map(|point| point.seconds));
    let curve = |&(name, look, points): &(&str, Look, &[Point])| Curve {
        label: format!("{name}: exponent {:.2}", exponent(points)),
        look,
        points: points.iter().map(|point| (x.place(point.size as f64), y.place(point.seconds))).collect(),
        failures: Vec::new(),
    };
    curves::draw(area, &x, &y, &series.iter().map(curve).collect::<Vec<_>>())
}
