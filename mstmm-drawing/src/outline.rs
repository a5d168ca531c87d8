//! Lines and areas on the paper, as the paths of the picture.

use crate::vector::Vector;
use std::fmt::Write;

/// A line or an area.
#[derive(Clone, Debug)]
pub(crate) enum Outline {
    /// Lines through points, each on its own.
    Lines(Vec<Vec<Vector>>),
    /// An area within points.
    Area(Vec<Vector>),
    /// A disc with its radius.
    Disc(Vector, f64),
}

impl Outline {
    /// A line through points.
    pub(crate) fn line(points: Vec<Vector>) -> Self {
        Outline::Lines(vec![points])
    }

    /// One of its lines; of an area its corners.
    pub(crate) fn line_at(&self, index: usize) -> Vec<Vector> {
        match self {
            Outline::Lines(lines) => lines.get(index).cloned().unwrap_or_default(),
            area => area.points(),
        }
    }

    /// Its data as the attribute `d` of a path.
    pub(crate) fn data(&self) -> String {
        let mut data = String::new();
        match self {
            Outline::Lines(lines) => lines.iter().for_each(|line| push_points(&mut data, line)),
            Outline::Area(points) => {
                push_points(&mut data, points);
                data.push('Z');
            }
            Outline::Disc([x, y], radius) => {
                let (r, double) = (number(*radius), number(2.0 * radius));
                let from = number(x - radius);
                data = format!("M{from} {}a{r} {r} 0 1 0 {double} 0a{r} {r} 0 1 0 -{double} 0Z", number(*y));
            }
        }
        data
    }

    /// Its corners; of a disc those of the square around it.
    pub(crate) fn points(&self) -> Vec<Vector> {
        match self {
            Outline::Lines(lines) => lines.concat(),
            Outline::Area(points) => points.clone(),
            Outline::Disc([x, y], r) => {
                [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[a, b]| [x + a * r, y + b * r]).into()
            }
        }
    }
}

/// Moves to the first point and draws lines to the others.
fn push_points(data: &mut String, points: &[Vector]) {
    for (index, [x, y]) in points.iter().enumerate() {
        let command = if index == 0 { 'M' } else { 'L' };
        // writing to a string does not fail
        let _ = write!(data, "{command}{} {}", number(*x), number(*y));
    }
}

/// A number with two digits behind the point, as short as it can be.
pub(crate) fn number(value: f64) -> String {
    let rounded = (100.0 * value).round() / 100.0;
    // no negative zero
    (rounded + 0.0).to_string()
}
