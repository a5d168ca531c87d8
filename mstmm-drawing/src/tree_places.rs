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

/// How far elements of one path may lie upon each other, and how far those of others in its lane must be apart.
const NEAR: f64 = 1e-3;
const APART: f64 = 24.0;

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

/// How an element begins beside its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beside {
    /// Which of its ends.
    pub(crate) end: usize,
    pub(crate) shift: Vector,
}

/// The places of a tree, and by how much each edge is beside them.
pub(crate) struct TreePlaces {
    pub(crate) places: Vec<TreePlace>,
    pub(crate) beside: Vec<Option<Beside>>,
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

/// Finds the places, given whether each has a support, and the size of a metre on the paper.
pub(crate) fn places(edges: &[Edge], held: &[bool], scale: f64) -> TreePlaces {
    let spots = spots(edges, held.len());
    let is_held = |spot: usize| (0..held.len()).any(|place| spots[place] == spot && held[place]);
    let mut found = TreePlaces { places: vec![TreePlace::default(); held.len()], beside: vec![None; edges.len()] };
    let mut room = Room { scale, taken: Vec::new(), hanging: BTreeMap::new() };
    let start = edges.iter().find(|edge| matches!(edge.way, Way::Along(_))).or(edges.first());
    let mut queue = VecDeque::from_iter(start.map(|edge| edge.ends[0]));
    let mut known: Vec<bool> = vec![false; held.len()];
    queue.iter().for_each(|start| known[*start] = true);
    while let Some(from) = queue.pop_front() {
        for (index, edge) in edges.iter().enumerate().filter(|(_, edge)| edge.ends.contains(&from)) {
            let is_forwards = edge.ends[0] == from;
            let to = edge.ends[usize::from(is_forwards)];
            if std::mem::replace(&mut known[to], true) {
                continue;
            }
            let place = found.places[from];
            let shift;
            (found.places[to], shift) = match edge.way {
                Way::Stays => (place, [0.0; 2]),
                Way::Along(_) | Way::InLine => room.along(place, edge.way, is_forwards),
                Way::Hangs => room.below(place, spots[from], is_held(spots[from])),
            };
            let beside = Beside { end: usize::from(!is_forwards), shift };
            found.beside[index] = Some(beside).filter(|_| shift != [0.0; 2]);
            queue.push_back(to);
        }
    }
    found
}

/// For each place the first one that is at the same spot, since elements between them have no extent.
fn spots(edges: &[Edge], count: usize) -> Vec<usize> {
    let mut spots: Vec<usize> = (0..count).collect();
    for edge in edges.iter().filter(|edge| edge.way == Way::Stays) {
        let [one, other] = edge.ends.map(|end| spots[end]);
        spots.iter_mut().filter(|spot| **spot == one.max(other)).for_each(|spot| *spot = one.min(other));
    }
    spots
}

/// What is left of the paper.
struct Room {
    /// Size of a metre.
    scale: f64,
    /// Where something lies along x: its height, and from where to where.
    taken: Vec<(f64, [f64; 2])>,
    /// How many elements hang at a spot.
    hanging: BTreeMap<usize, u32>,
}

impl Room {
    /// The place at the other end of an element along x, and how far it is beside its beginning: in the first lane that is free.
    fn along(&mut self, from: TreePlace, way: Way, is_forwards: bool) -> (TreePlace, Vector) {
        let sign = if is_forwards { 1.0 } else { -1.0 };
        let mut to = TreePlace { side: 0.0, ..from };
        if let Way::Along(metres) = way {
            to.metres = [from.metres[0] + sign * metres[0], from.metres[1] + sign * metres[1]];
        } else {
            to.shift[0] += sign * IN_LINE;
        }
        let x = |place: &TreePlace| place.shift[0] + self.scale * place.metres[0];
        let [low, high] = [x(&from).min(x(&to)), x(&from).max(x(&to))];
        // a path that goes on may touch what it comes from, one beside it keeps its distance
        let is_taken = |lane: f64| {
            let near = if lane == 0.0 { NEAR } else { -APART };
            let height = from.shift[1] + lane;
            self.taken.iter().any(|(other, [from, to])| *other == height && low + near < *to && *from + near < high)
        };
        let mut lane = 0.0;
        while is_taken(lane) {
            lane -= LANE;
        }
        to.shift[1] += lane;
        self.taken.push((to.shift[1], [low, high]));
        (to, [0.0, lane])
    }

    /// The place at the other end of an element that hangs: below its spot, above it, and then beside these.
    fn below(&mut self, from: TreePlace, spot: usize, is_held: bool) -> (TreePlace, Vector) {
        let (mut to, mut shift) = (from, [0.0; 2]);
        if from.side == 0.0 {
            let count = self.hanging.entry(spot).or_default();
            let number = *count + u32::from(is_held);
            *count += 1;
            to.side = if number.is_multiple_of(2) { 1.0 } else { -1.0 };
            shift[0] = BESIDE * f64::from(number / 2);
        }
        to.shift = [from.shift[0] + shift[0], from.shift[1] + to.side * HANGING];
        (to, shift)
    }
}
