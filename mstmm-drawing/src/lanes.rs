//! Parallel paths of a model with one coordinate, side by side.

use crate::figure::Figure;
use crate::kind::Kind;
use crate::loose::Loose;

/// Distance of two paths.
pub(crate) const LANE: f64 = 96.0;

/// Moves what would lie on something else to a lane below.
pub(crate) fn lay_side_by_side<M>(figure: &mut Figure<M>, loose: &[Loose]) {
    let count = figure.anchors.len();
    let mut group: Vec<usize> = (0..count).collect();
    for part in &figure.parts {
        let couples = matches!(part.kind, Kind::Spring | Kind::Damper | Kind::SpringDamper | Kind::Tie);
        let is_loose = part.ends.iter().any(|end| loose.iter().any(|loose| loose.anchor == *end));
        if couples || is_loose {
            continue;
        }
        for pair in part.ends.windows(2) {
            let [one, other] = [group[pair[0]], group[pair[1]]];
            let least = one.min(other);
            group.iter_mut().filter(|group| **group == one || **group == other).for_each(|group| *group = least);
        }
    }
    let mut lanes: Vec<Vec<[f64; 2]>> = Vec::new();
    for first in 0..count {
        let is_loose = loose.iter().any(|loose| loose.anchor == first);
        if group[first] != first || is_loose {
            continue;
        }
        let xs = (0..count).filter(|&anchor| group[anchor] == first).map(|anchor| figure.anchors[anchor].at[0]);
        let range = xs.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        let is_free = |lane: &Vec<[f64; 2]>| lane.iter().all(|other| other[1] < range[0] || range[1] < other[0]);
        let lane = lanes.iter().position(is_free).unwrap_or(lanes.len());
        if lane == lanes.len() {
            lanes.push(Vec::new());
        }
        lanes[lane].push(range);
        for anchor in (0..count).filter(|&anchor| group[anchor] == first) {
            figure.anchors[anchor].at[1] += LANE * lane as f64;
        }
    }
}
