//! Where the points of a tree are on the paper: bending paths run along x, translation and rotation paths hang across them, paths that lie
//! side by side have lanes.

use crate::kind::Kind;
use crate::path_places::HANGING;
use crate::vector::Vector;
use std::collections::{BTreeMap, VecDeque};

/// Distance of parallel paths.
const LANE: f64 = 74.0;

/// Length of an element without extent in a path that runs along x.
const IN_LINE: f64 = 78.0;

/// Distance of elements that hang at one point, beyond the first two.
const BESIDE: f64 = 44.0;

/// How an element leads from its input place to its output place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Way {
    /// Along x, by a way in metres.
    Along(Vector),
    /// Along x, by a length of the drawing.
    InLine,
    /// Across x.
    Hangs,
    /// It has no extent.
    Stays,
}

/// An element between two places.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge {
    pub(crate) ends: [usize; 2],
    pub(crate) way: Way,
}

/// A place: metres of the model, and what the drawing adds on the paper.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TreePlace {
    pub(crate) metres: Vector,
    pub(crate) shift: Vector,
    /// The side to which it hangs: below is 1.
    side: f64,
}

/// The places of a tree, and by how much each edge is beside them.
pub(crate) struct TreePlaces {
    pub(crate) places: Vec<TreePlace>,
    pub(crate) lanes: Vec<f64>,
}

/// The way of an element, by its kind and its extent.
pub(crate) fn way_of(kind: Kind, extent: Vector, is_in_line: bool, joins_ground: bool) -> Way {
    let reaches = extent != [0.0; 2];
    match kind {
        Kind::Rod if !is_in_line => Way::Hangs,
        Kind::ElasticHinge if joins_ground => Way::Hangs,
        _ if reaches => Way::Along(extent),
        _ if kind.is_at_a_point() || matches!(kind, Kind::Body | Kind::Lever | Kind::Beam { .. }) => Way::Stays,
        _ if is_in_line => Way::InLine,
        _ => Way::Hangs,
    }
}

/// Finds the places, given whether each has a support.
pub(crate) fn places(edges: &[Edge], held: &[bool]) -> TreePlaces {
    let mut found = TreePlaces { places: vec![TreePlace::default(); held.len()], lanes: vec![0.0; edges.len()] };
    let start = edges.iter().find(|edge| matches!(edge.way, Way::Along(_))).or(edges.first());
    let mut queue = VecDeque::from_iter(start.map(|edge| edge.ends[0]));
    let mut known: Vec<bool> = vec![false; held.len()];
    if let Some(&start) = queue.front() {
        known[start] = true;
    }
    // how many elements leave a place to a side
    let mut left: BTreeMap<(usize, i8), usize> = BTreeMap::new();
    let mut arrived: Vec<bool> = vec![false; edges.len()];
    while let Some(from) = queue.pop_front() {
        for (index, edge) in edges.iter().enumerate().filter(|(_, edge)| edge.ends.contains(&from)) {
            let is_forwards = edge.ends[0] == from;
            let to = edge.ends[usize::from(is_forwards)];
            if std::mem::replace(&mut arrived[index], true) || known[to] {
                continue;
            }
            let (place, lane) = beyond(&found.places[from], (from, held[from]), edge.way, is_forwards, &mut left);
            (found.places[to], found.lanes[index], known[to]) = (place, lane, true);
            queue.push_back(to);
        }
    }
    found
}

/// The place at the other end of an element, and its lane.
fn beyond(
    from: &TreePlace,
    (index, is_held): (usize, bool),
    way: Way,
    is_forwards: bool,
    left: &mut BTreeMap<(usize, i8), usize>,
) -> (TreePlace, f64) {
    let sign = if is_forwards { 1.0 } else { -1.0 };
    let mut to = *from;
    let mut count = |side: i8| {
        let count = left.entry((index, side)).or_default();
        std::mem::replace(count, *count + 1) as f64
    };
    match way {
        Way::Stays => (to, 0.0),
        Way::Along(_) | Way::InLine => {
            if let Way::Along(metres) = way {
                to.metres = [from.metres[0] + sign * metres[0], from.metres[1] + sign * metres[1]];
            } else {
                to.shift[0] += sign * IN_LINE;
            }
            to.side = 0.0;
            let lane = -LANE * count(sign as i8);
            to.shift[1] += lane;
            (to, lane)
        }
        Way::Hangs if from.side != 0.0 => {
            to.shift[1] += from.side * HANGING;
            (to, 0.0)
        }
        Way::Hangs => {
            let number = count(0) + f64::from(u8::from(is_held));
            to.side = if number % 2.0 == 0.0 { 1.0 } else { -1.0 };
            to.shift = [from.shift[0] + BESIDE * (number / 2.0).floor(), from.shift[1] + to.side * HANGING];
            (to, 0.0)
        }
    }
}
