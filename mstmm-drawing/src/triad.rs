//! The axes of space in a corner of a picture.

use crate::labels::{Placed, is_free};
use crate::outline::Outline;
use crate::picture::{MARGIN, Picture, element, path, text, titled};
use crate::vector::{Vector, plus};
use crate::vector3::{Vector3, times};
use crate::view::Sight;
use svg::Node;
use svg::node::element::Element;

/// Length of an axis, and how far from the middle its name is.
const LENGTH: f64 = 26.0;
const NAME: f64 = 36.0;

/// Part of its length below which an axis is seen as a point, and its name stands aside.
const SHORT: f64 = 0.15;

/// Radius of the circle of an axis seen as a point.
const RADIUS: f64 = 4.2;

/// Half of the side of the corner that the triad takes.
const HALF: f64 = 45.0;

const AXES: [(&str, Vector3); 3] = [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])];

/// The axes in the first corner of a picture that is free, else below its first one, which makes it higher.
pub(crate) fn triad(
    sight: &Sight,
    (low, high): (&mut Vector, &mut Vector),
    (picture, labels): (&Picture, &[Placed]),
) -> Element {
    let corner = |[right, below]: [bool; 2]| {
        [
            if right { high[0] - MARGIN - HALF } else { low[0] + MARGIN + HALF },
            if below { high[1] - MARGIN - HALF } else { low[1] + MARGIN + HALF },
        ]
    };
    let corners = [[false, true], [true, true], [false, false], [true, false]].map(corner);
    let is_empty =
        |at: &&Vector| [&picture.inks, &picture.later].iter().all(|inks| is_free(**at, [HALF; 2], inks, labels));
    let at = corners.iter().find(is_empty).copied().unwrap_or_else(|| plus(corners[0], [0.0, 2.0 * HALF], 1.0));
    for axis in 0..2 {
        low[axis] = low[axis].min(at[axis] - HALF - MARGIN);
        high[axis] = high[axis].max(at[axis] + HALF + MARGIN);
    }
    let mut all = element("g", "triad");
    let mut axes = AXES;
    axes.sort_by(|one, other| sight.depth(one.1).total_cmp(&sight.depth(other.1)));
    for (name, axis) in axes {
        let way = sight.way(axis);
        let is_short = way[0].hypot(way[1]) < SHORT;
        let outline = if is_short {
            Outline::Disc(at, RADIUS)
        } else {
            Outline::line(vec![at, plus(at, sight.way(times(axis, LENGTH)), 1.0)])
        };
        all.append(path(if is_short { "hollow" } else { "axis" }, &outline));
        if is_short {
            all.append(path("axis", &mark(at, RADIUS, sight.depth(axis) > 0.0)));
        }
        let place = if is_short { plus(at, [-11.0, 11.0], 1.0) } else { plus(at, way, NAME) };
        all.append(label(name, place));
    }
    all
}

/// What is drawn in the circle of an axis or an arrow seen as a point: a dot if it leads to the reader, else a cross.
pub(crate) fn mark([x, y]: Vector, radius: f64, is_near: bool) -> Outline {
    if is_near {
        return Outline::Disc([x, y], 0.6);
    }
    let half = radius * 0.5_f64.sqrt();
    Outline::Lines(vec![
        vec![[x - half, y - half], [x + half, y + half]],
        vec![[x - half, y + half], [x + half, y - half]],
    ])
}

/// The name of an axis.
fn label(name: &str, place: Vector) -> Element {
    titled(text("axis", place, name), &format!("axis {name}"))
}
