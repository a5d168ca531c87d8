//! Frames in space from all sides: where things are, and what hides what.

use crate::reading::Picture;
use crate::space_frames::{joints, mast, row, tube};
use mstmm::frame::{Frame, Space, Structure};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, DrawingError, View};

/// Half of the last digit of a path, on the paper.
const DIGIT: f64 = 0.0101;

/// The longest piece of a member on the paper.
const PIECE: f64 = 26.0;

/// The picture of a frame from a side.
fn seen(frame: &Structure<Space>, view: View) -> Picture {
    Picture::of(Drawing::of(frame).unwrap().view(view).unwrap())
}

/// The model turned until its side is in front, and tilted until its top is seen: to the right and upwards, and how far to the back.
fn turned([x, y, z]: [f64; 3], azimuth: f64, elevation: f64) -> [f64; 3] {
    let turn = -(azimuth + 90.0).to_radians();
    let [right, back] = [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
    let tilt = elevation.to_radians();
    [right, z * tilt.cos() + back * tilt.sin(), back * tilt.cos() - z * tilt.sin()]
}

#[test]
fn points_are_where_a_turned_model_has_them() {
    let views = [
        (View::front(), [-90.0, 0.0]),
        (View::side(), [0.0, 0.0]),
        (View::plan(), [-90.0, 90.0]),
        (View::isometric(), [-45.0, (0.5_f64.sqrt()).atan().to_degrees()]),
        (View::of(200.0, -35.0), [200.0, -35.0]),
        (View::default(), [315.0, (1.0_f64 / 3.0).sqrt().asin().to_degrees()]),
    ];
    for frame in [row(), joints(), mast()] {
        let sketch = FrameAnalysis::sketch(&frame);
        for (view, [azimuth, elevation]) in views {
            let picture = seen(&frame, view);
            let shown = picture.shown("model");
            let points: Vec<_> = shown.iter().filter(|shown| shown.kind == "point").collect();
            let mut count = 0;
            for point in sketch.points() {
                let name = point.name.to_string();
                let drawn = points.iter().find(|shown| shown.name == name).unwrap();
                let [x, y] = picture.in_model(drawn.at.unwrap());
                let [right, up, _] = turned(point.position, azimuth, elevation);
                assert!((x - right).abs() < 1e-9 && (y - up).abs() < 1e-9, "{name}: {x}, {y} and {right}, {up}");
                count += 1;
            }
            assert_eq!(count, points.len());
        }
    }
}

/// A chain of beams between places, all held.
fn chain(places: &[[f64; 3]]) -> (Structure<Space>, Vec<[[f64; 3]; 2]>) {
    let mut frame = Frame::new();
    let points: Vec<_> = places.iter().map(|place| frame.point(*place)).collect();
    for point in &points {
        frame.hold(*point, Support::Fixed);
    }
    for pair in points.windows(2) {
        frame.member(pair[0], pair[1], tube());
    }
    (frame.build().unwrap(), places.windows(2).map(|pair| [pair[0], pair[1]]).collect())
}

/// A chain to and fro between many places.
fn crossing() -> (Structure<Space>, Vec<[[f64; 3]; 2]>) {
    // the digits of multiples of the golden section are spread evenly
    let number = |k: usize| 4.0 * (k as f64 * 0.618_033_988_75).fract();
    let place = |k: usize| [0, 7, 11].map(|shift| number((k + shift) * (k + 2 * shift + 1)));
    chain(&(0..28).map(place).collect::<Vec<_>>())
}

/// Three beams, each above the next one at one corner of a triangle, so that none is above all others; two beams join them.
fn woven() -> (Structure<Space>, Vec<[[f64; 3]; 2]>) {
    let corners = [[0.0, 0.0], [4.0, 0.0], [2.0, 3.0]];
    let along = |k: usize| {
        let ([x, y], [u, v]) = (corners[k % 3], corners[(k + 1) % 3]);
        [-0.6, 1.6].map(|part| [x + part * (u - x), y + part * (v - y), part - 0.5])
    };
    chain(&(0..3).flat_map(along).collect::<Vec<_>>())
}

/// Where two lines on the paper cross, as parts of both.
fn crossing_of([a, b]: [[f64; 3]; 2], [c, d]: [[f64; 3]; 2]) -> Option<[f64; 2]> {
    let [u, v, w] = [(a, b), (c, d), (a, c)].map(|(from, to)| [to[0] - from[0], to[1] - from[1]]);
    let area = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let parts = [area(w, v) / area(u, v), area(w, u) / area(u, v)];
    parts.iter().all(|part| (0.0..=1.0).contains(part)).then_some(parts)
}

/// Whether a line leads through a place.
fn leads_through(line: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    line.windows(2).any(|pair| {
        let [along, to] = [[pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]], [x - pair[0][0], y - pair[0][1]]];
        let length = along[0].hypot(along[1]);
        let part = (along[0] * to[0] + along[1] * to[1]) / (length * length);
        (-1e-3..=1.001).contains(&part) && (along[0] * to[1] - along[1] * to[0]).abs() / length < 0.1
    })
}

/// Where two beams cross on the paper that which is nearer is drawn later, with paper around it. Gives how often that is.
fn check_depth((frame, beams): &(Structure<Space>, Vec<[[f64; 3]; 2]>), views: &[[f64; 2]]) -> usize {
    let mut count = 0;
    for &[azimuth, elevation] in views {
        let picture = seen(frame, View::of(azimuth, elevation));
        let scale = picture.number("data-scale");
        let shown = picture.shown("model");
        let places: Vec<_> = beams.iter().map(|beam| beam.map(|place| turned(place, azimuth, elevation))).collect();
        let on_paper = |line: usize, part: f64| {
            let [from, to] = places[line];
            [0, 1, 2].map(|k| scale * (from[k] + part * (to[k] - from[k])))
        };
        let origin = picture.in_model([0.0, 0.0]);
        for (one, other) in (0..beams.len()).flat_map(|one| (0..one).map(move |other| (one, other))) {
            let Some(parts) = crossing_of(places[one], places[other]) else { continue };
            let [[x, y, depth], [.., behind]] = [on_paper(one, parts[0]), on_paper(other, parts[1])];
            let at = [x - scale * origin[0], scale * origin[1] - y];
            let ends = [(one, 0.0), (one, 1.0), (other, 0.0), (other, 1.0)].map(|(line, part)| on_paper(line, part));
            let is_clear = ends.iter().all(|end| (end[0] - x).hypot(end[1] - y) > 62.0);
            if !is_clear || (depth - behind).abs() < PIECE {
                continue;
            }
            let (near, far) = if depth < behind { (one, other) } else { (other, one) };
            let drawn = |beam: usize, halos: bool| {
                let name = format!("member {beam}");
                let through = |shown: &crate::reading::Shown| shown.lines(halos).any(|line| leads_through(line, at));
                shown.iter().rposition(|shown| shown.name == name && through(shown)).unwrap()
            };
            assert!(drawn(near, false) > drawn(far, false), "{near} is nearer than {far} at {at:?}");
            assert!(drawn(near, true) > drawn(far, false), "{near} has no paper around it at {at:?}");
            count += 1;
        }
    }
    count
}

#[test]
fn what_is_near_hides_what_is_far() {
    let count = check_depth(&crossing(), &[[-45.0, 35.0], [-90.0, 0.0], [135.0, -20.0], [10.0, 80.0]]);
    assert!(count > 30, "{count} crossings");
    // from above, and from below
    assert_eq!(check_depth(&woven(), &[[-90.0, 90.0], [-90.0, -90.0]]), 6);
}

/// The pieces of a beam are on its line and cover it.
#[test]
fn pieces_make_the_whole_member() {
    let (frame, beams) = crossing();
    let picture = seen(&frame, View::front());
    let shown = picture.shown("model");
    let (scale, [left, top]) = (picture.number("data-scale"), picture.in_model([0.0, 0.0]));
    for (index, [from, to]) in beams.iter().enumerate() {
        let name = format!("member {index}");
        let pieces: Vec<_> =
            shown.iter().filter(|shown| shown.name == name).flat_map(|shown| shown.lines(false)).collect();
        let part = |point: &[f64; 2]| {
            let [x, z] = [left + point[0] / scale - from[0], top - point[1] / scale - from[2]];
            let [u, w] = [to[0] - from[0], to[2] - from[2]];
            let beside = (x * w - z * u).abs() / u.hypot(w) * scale;
            assert!(beside < DIGIT, "{name}: {beside}");
            (x * u + z * w) / (u * u + w * w)
        };
        let mut parts: Vec<[f64; 2]> =
            pieces.iter().map(|piece| [part(&piece[0]), part(&piece[piece.len() - 1])]).collect();
        parts.sort_by(|one, other| one[0].total_cmp(&other[0]));
        assert!(parts[0][0].abs() < 1e-3, "{name}");
        let end = parts.iter().fold(0.0, |end: f64, [start, next]| {
            assert!(*start <= end + 1e-3, "{name}: nothing from {end} to {start}");
            end.max(*next)
        });
        assert!((end - 1.0).abs() < 1e-3, "{name}");
    }
}

#[test]
fn a_triad_shows_the_axes_and_covers_no_label() {
    for frame in [row(), joints(), mast(), crossing().0] {
        for [azimuth, elevation] in [[-45.0, 35.0], [-90.0, 0.0], [0.0, 0.0], [-90.0, 90.0], [100.0, 20.0]] {
            let picture = seen(&frame, View::of(azimuth, elevation));
            let labels = picture.labels();
            let (axes, others): (Vec<_>, Vec<_>) = labels.iter().partition(|label| label.class == "axis");
            let axes = ["x", "y", "z"].map(|name| axes.iter().find(|axis| axis.text == name).unwrap().at);
            let [left, top, width, height] = picture.view_box();
            for [x, y] in axes {
                assert!(x > left && x < left + width && y > top && y < top + height);
                assert!(others.iter().all(|other| (other.at[0] - x).abs() > 8.0 || (other.at[1] - y).abs() > 13.0));
            }
            // between two axes that are seen, the names differ as their directions do
            let ways = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| turned(axis, azimuth, elevation));
            let is_seen = |k: usize| ways[k][0].hypot(ways[k][1]) > 0.2;
            for (one, other) in
                [(0, 1), (1, 2), (2, 0)].into_iter().filter(|(one, other)| is_seen(*one) && is_seen(*other))
            {
                let [x, y] = [0, 1].map(|k| axes[one][k] - axes[other][k]);
                let [right, up] = [0, 1].map(|k| 36.0 * (ways[one][k] - ways[other][k]));
                assert!((x - right).abs() < 0.02 && (y + up).abs() < 0.02, "{x}, {y} and {right}, {up}");
            }
        }
    }
}

#[test]
fn a_view_without_a_direction_is_an_error() {
    let frame = mast();
    for (azimuth, elevation) in [(f64::NAN, 0.0), (0.0, f64::INFINITY)] {
        let error = Drawing::of(&frame).unwrap().view(View::of(azimuth, elevation)).unwrap_err();
        assert!(matches!(error, DrawingError::View { .. }), "{error}");
        let text = error.to_string();
        assert!(
            text.contains(&format!("azimuth {azimuth}")) && text.contains(&format!("elevation {elevation}")),
            "{text}"
        );
    }
}

#[test]
fn a_model_of_the_plane_stays_as_it_is() {
    let portal = crate::frames::portal();
    let drawing = || Drawing::of(&portal).unwrap();
    assert_eq!(drawing().view(View::plan()).unwrap().to_string(), drawing().to_string());
}

/// A cantilever of some length from a place, along a direction.
fn cantilever(place: [f64; 3], [x, y, z]: [f64; 3], length: f64) -> Structure<Space> {
    let mut frame = Frame::new();
    let tip = [place[0] + length * x, place[1] + length * y, place[2] + length * z];
    let [foot, tip] = [place, tip].map(|place| frame.point(place));
    frame.member(foot, tip, tube());
    frame.hold(foot, Support::Fixed);
    frame.build().unwrap()
}

#[test]
fn models_of_all_sizes_fill_the_same_paper_from_all_sides() {
    let width = |length: f64, view: View| seen(&cantilever([0.0; 3], [0.6, 0.0, 0.8], length), view).number("width");
    for view in [View::isometric(), View::front(), View::of(30.0, -50.0)] {
        let usual = width(1.0, view);
        for exponent in [-9, -3, 3, 9] {
            assert_eq!(width(10.0_f64.powi(exponent), view), usual);
        }
    }
}

/// A member that leads to the reader is seen as a point, and its place and its size do not matter.
#[test]
fn a_member_along_the_sight_is_a_point() {
    for (direction, view) in
        [([0.0, 0.0, 1.0], View::plan()), ([0.0, 1.0, 0.0], View::front()), ([1.0, 0.0, 0.0], View::side())]
    {
        for (place, length) in [([0.0; 3], 1.0), ([1e3, -2e3, 5e2], 1e-2), ([1.0, 2.0, 3.0], 1e6)] {
            let picture = seen(&cantilever(place, direction, length), view);
            let shown = picture.shown("model");
            let all: Vec<[f64; 2]> = shown.iter().flat_map(|shown| shown.paths.concat()).collect();
            let [x, y] = all[0];
            assert!(all.iter().all(|[u, v]| (x - u).abs() < 0.1 && (y - v).abs() < 0.1), "{all:?}");
            assert!(picture.number("width") < 300.0);
        }
    }
}
