//! Places for labels beside the curves that they name.

use crate::canvas::{Area, Drawn, TEXT, UNIT, style};
use crate::palette::Hue;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

/// Room of a character, as a share of the size of its font: more than most need, and of wide ones.
const CHARACTER: f64 = 0.6;
const WIDE_CHARACTER: f64 = 0.95;
/// Room of a line of text, as a share of the size of its font.
const LINE: f64 = 1.25;
/// Distance of a label from its point in units.
const GAP: i32 = 7 * UNIT;
/// Distance of the dots by which lines are seen, in units.
const DOTS: f64 = 3.0 * UNIT as f64;

/// Left, top, right and bottom in units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Frame {
    pub(crate) left: i32,
    pub(crate) top: i32,
    pub(crate) right: i32,
    pub(crate) bottom: i32,
}

impl Frame {
    fn meets(&self, other: &Frame) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    fn holds(&self, (x, y): (i32, i32)) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    fn is_inside(&self, outer: &Frame) -> bool {
        outer.holds((self.left, self.top)) && outer.holds((self.right, self.bottom))
    }
}

/// What is taken, and what is still free.
#[derive(Debug)]
pub(crate) struct Placement {
    within: Frame,
    labels: Vec<Frame>,
    dots: Vec<(i32, i32)>,
}

impl Placement {
    /// Nothing is taken yet.
    pub(crate) fn new(within: Frame) -> Self {
        Placement { within, labels: Vec::new(), dots: Vec::new() }
    }

    /// A polyline with markers that labels should not cross.
    pub(crate) fn avoid(&mut self, points: &[(i32, i32)]) {
        let around = [(0, 0), (1, 0), (0, 1), (-1, 0), (0, -1)].map(|(x, y)| (x * GAP / 2, y * GAP / 2));
        self.dots.extend(points.iter().flat_map(|&(x, y)| around.map(|(dx, dy)| (x + dx, y + dy))));
        for pair in points.windows(2) {
            let [(x, y), (dx, dy)] = [pair[0], (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1)];
            let steps = (f64::from(dx).hypot(f64::from(dy)) / DOTS).ceil().max(1.0) as i32;
            self.dots.extend((0..steps).map(|step| (x + dx * step / steps, y + dy * step / steps)));
        }
    }

    /// The place for a text near one of the points that hides least; none where other labels are everywhere.
    pub(crate) fn find(&mut self, text: &str, near: &[(i32, i32)]) -> Option<Frame> {
        let size = TEXT * f64::from(UNIT);
        let room = |letter| if "mwMW".contains(letter) { WIDE_CHARACTER } else { CHARACTER };
        let (width, height) = ((size * text.chars().map(room).sum::<f64>()) as i32, (LINE * size) as i32);
        let points = [GAP, 3 * GAP].into_iter().flat_map(|gap| near.iter().map(move |&point| (gap, point)));
        let places = points.flat_map(|(gap, (x, y))| {
            let beside = [x + gap, x - gap - width, x - width / 2];
            let above = [y - height / 2, y - gap - height, y + gap];
            let corners = [(0, 0), (1, 0), (2, 1), (2, 2), (0, 1), (0, 2), (1, 1), (1, 2)];
            corners.map(|(column, row)| (beside[column], above[row]))
        });
        let frames = places.map(|(left, top)| Frame { left, top, right: left + width, bottom: top + height });
        let free = frames.filter(|frame| frame.is_inside(&self.within) && !self.labels.iter().any(|l| l.meets(frame)));
        let best = free.min_by_key(|frame| self.dots.iter().filter(|&&dot| frame.holds(dot)).count())?;
        self.labels.push(best);
        Some(best)
    }
}

/// Writes a label into its place.
pub(crate) fn write(area: &Area, frame: Frame, text: &str, hue: Hue) -> Drawn {
    let (x, y) = area.get_base_pixel();
    let place = ((frame.left + frame.right) / 2 - x, (frame.top + frame.bottom) / 2 - y);
    area.draw(&Text::new(text, place, style(hue, TEXT, HPos::Center, VPos::Center)))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const WITHIN: Frame = Frame { left: 0, top: 0, right: 4000, bottom: 2000 };

    #[test]
    fn labels_of_one_point_do_not_meet() {
        let mut placement = Placement::new(WITHIN);
        let frames: Vec<_> = (0..4).filter_map(|_| placement.find("label", &[(2000, 1000)])).collect();
        assert_eq!(frames.len(), 4);
        for (n, frame) in frames.iter().enumerate() {
            assert!(frame.is_inside(&WITHIN) && !frames[n + 1..].iter().any(|other| other.meets(frame)));
        }
    }

    #[test]
    fn labels_keep_off_curves() {
        let mut placement = Placement::new(WITHIN);
        let curve = [(0, 1000), (4000, 1000)];
        placement.avoid(&curve);
        let frame = placement.find("label", &curve[..1]).unwrap();
        assert!(!(frame.top..frame.bottom).contains(&1000));
    }

    #[test]
    fn where_labels_are_everywhere_there_is_no_place() {
        let mut placement = Placement::new(Frame { right: 300, ..WITHIN });
        assert_eq!(placement.find("label", &[(100, 100)]), None);
    }
}
