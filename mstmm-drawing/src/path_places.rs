//! Places for paths of one motion in a frame, which have none of their own: on the line between the points on which they act, or beside one.

use crate::figure::{Figure, Moves};
use crate::kind::Kind;
use crate::loose::Loose;
use crate::vector::{Vector, between, direction, distance, dot, plus, turned};

/// Length of an element that hangs at a point.
pub(crate) const HANGING: f64 = 52.0;

/// Distance of a path from a beam beside it.
const ASIDE: f64 = 30.0;

/// Where a path acts on a point.
struct Contact {
    /// The anchor of the point.
    point: usize,
    /// The anchor of the path.
    path: usize,
    /// How many elements are between both.
    distance: usize,
    along: Option<Vector>,
}

/// Places all loose anchors, given the direction of each part.
pub(crate) fn place_paths<M>(figure: &mut Figure<M>, loose: &[Loose], directions: &[Option<Vector>]) {
    let mut left: Vec<usize> = loose.iter().filter(|loose| !loose.rests).map(|loose| loose.anchor).collect();
    let grounds: Vec<usize> = loose.iter().filter(|loose| loose.rests).map(|loose| loose.anchor).collect();
    let is_loose = |anchor: usize| loose.iter().any(|loose| loose.anchor == anchor);
    while let Some(&first) = left.first() {
        let distances = distances(figure, first, &|anchor| left.contains(&anchor));
        let path: Vec<usize> = (0..distances.len()).filter(|&anchor| distances[anchor].is_some()).collect();
        left.retain(|anchor| !path.contains(anchor));
        let contacts = contacts(figure, &path, directions, &is_loose);
        let is_grounded = ends_at(figure, &path).any(|anchor| grounds.contains(&anchor));
        place_path(figure, &path, &contacts, is_grounded);
    }
    place_grounds(figure, &grounds, directions);
}

/// The two anchors of each part that leads from one to another.
fn links<M>(figure: &Figure<M>) -> impl Iterator<Item = (usize, [usize; 2], usize)> + '_ {
    let parts = figure.parts.iter().enumerate().filter(|(_, part)| !part.kind.is_body());
    parts.map(|(index, part)| (index, [part.ends[0], part.ends[1]], usize::from(part.kind != Kind::Tie)))
}

/// The anchors at the ends of parts of a path.
fn ends_at<'a, M>(figure: &'a Figure<M>, path: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
    links(figure).filter(|(_, ends, _)| ends.iter().any(|end| path.contains(end))).flat_map(|(_, ends, _)| ends)
}

/// The number of elements from an anchor to each one of its path.
fn distances<M>(figure: &Figure<M>, from: usize, is_in: &dyn Fn(usize) -> bool) -> Vec<Option<usize>> {
    let mut distances = vec![None; figure.anchors.len()];
    distances[from] = Some(0);
    // as often as there are parts, no way is longer
    for _ in 0..figure.parts.len() {
        for (_, [a, b], length) in links(figure) {
            for (from, to) in [(a, b), (b, a)] {
                let Some(known) = distances[from] else { continue };
                if is_in(to) && distances[to].is_none_or(|distance| distance > known + length) {
                    distances[to] = Some(known + length);
                }
            }
        }
    }
    distances
}

/// Where a path acts on points.
fn contacts<M>(
    figure: &Figure<M>,
    path: &[usize],
    directions: &[Option<Vector>],
    is_loose: &dyn Fn(usize) -> bool,
) -> Vec<Contact> {
    let mut contacts = Vec::new();
    for (part, [a, b], distance) in links(figure) {
        for (point, own) in [(a, b), (b, a)] {
            if path.contains(&own) && !is_loose(point) {
                let along = directions.get(part).copied().flatten();
                contacts.push(Contact { point, path: own, distance, along });
            }
        }
    }
    contacts
}

/// Places the anchors of a path.
fn place_path<M>(figure: &mut Figure<M>, path: &[usize], contacts: &[Contact], is_grounded: bool) {
    let Some(first) = contacts.first() else { return };
    let is_in = |anchor: usize| path.contains(&anchor);
    let from = |contact: &Contact| distances(figure, contact.path, &is_in);
    let (near, start) = (from(first), figure.anchors[first.point].at);
    let at: Vec<Vector> = match contacts {
        [_, second] if distance(start, figure.anchors[second.point].at) > HANGING / 2.0 => {
            let (far, end) = (from(second), figure.anchors[second.point].at);
            let aside = aside(figure, start, end);
            path.iter()
                .map(|&anchor| {
                    let [a, b] = [(&near, first), (&far, second)]
                        .map(|(all, contact)| all[anchor].unwrap_or(0) + contact.distance);
                    plus(between(start, end, a as f64 / (a + b).max(1) as f64), aside, 1.0)
                })
                .collect()
        }
        _ => {
            let way = way_off(figure, first, is_grounded);
            let steps = |anchor: usize| near[anchor].unwrap_or(0) + first.distance;
            let outside = outside(figure, first.point, way);
            path.iter().map(|&anchor| plus(start, way, outside + HANGING * steps(anchor) as f64)).collect()
        }
    };
    let along = first.along.map(|[x, y]| [x, -y, 0.0]);
    for (&anchor, at) in path.iter().zip(at) {
        figure.anchors[anchor].at = at;
        if let Moves::Path { node, .. } = figure.anchors[anchor].moves {
            figure.anchors[anchor].moves = Moves::Path { node, along: along.unwrap_or([0.0; 3]) };
        }
    }
}

/// The way by which a path between two places is beside a beam that joins them, too.
fn aside<M>(figure: &Figure<M>, start: Vector, end: Vector) -> Vector {
    let is_at = |anchor: usize, place: Vector| distance(figure.anchors[anchor].at, place) < 1e-6;
    let joins = |ends: &[usize]| {
        (is_at(ends[0], start) && is_at(ends[1], end)) || (is_at(ends[0], end) && is_at(ends[1], start))
    };
    let has_beam = figure.parts.iter().any(|part| matches!(part.kind, Kind::Beam { .. }) && joins(&part.ends));
    let across = direction(plus(end, start, -1.0)).map(turned).filter(|_| has_beam);
    across.map_or([0.0; 2], |[x, y]| [ASIDE * x, ASIDE * y])
}

/// How far a body reaches from one of its points along a way.
fn outside<M>(figure: &Figure<M>, point: usize, way: Vector) -> f64 {
    let bodies = figure.parts.iter().filter(|part| part.kind.is_body() && part.ends.contains(&point));
    let ends =
        bodies.flat_map(|body| &body.ends).map(|end| plus(figure.anchors[*end].at, figure.anchors[point].at, -1.0));
    ends.map(|end| dot(end, way)).fold(0.0, f64::max)
}

/// The way from a point in which its path stands beside it: down to the ground, up to a mass.
fn way_off<M>(figure: &Figure<M>, contact: &Contact, is_grounded: bool) -> Vector {
    let way = contact.along.unwrap_or([0.0, 1.0]);
    let back = [-way[0], -way[1]];
    let towards = if is_grounded { [0.0, 1.0] } else { [0.0, -1.0] };
    let lean = dot(way, towards);
    if lean.abs() > 0.3 {
        return if lean > 0.0 { way } else { back };
    }
    // away from the middle of all
    let count = figure.anchors.len() as f64;
    let middle = figure.anchors.iter().fold([0.0; 2], |sum, anchor| plus(sum, anchor.at, 1.0 / count));
    let outwards = plus(figure.anchors[contact.point].at, middle, -1.0);
    if dot(way, outwards) >= 0.0 { way } else { back }
}

/// Places the ends at the ground, each behind the element that leads to it.
fn place_grounds<M>(figure: &mut Figure<M>, grounds: &[usize], directions: &[Option<Vector>]) {
    let links: Vec<_> = links(figure).collect();
    for &ground in grounds {
        let Some(&(part, ends, _)) = links.iter().find(|(_, ends, _)| ends.contains(&ground)) else { continue };
        let other = if ends[0] == ground { ends[1] } else { ends[0] };
        // a path goes on in its direction, away from where it comes from
        let before =
            links.iter().find(|(index, next, _)| *index != part && next.contains(&other) && is_path(figure, other));
        let before = before.map(|(_, next, _)| if next[0] == other { next[1] } else { next[0] });
        let way = before.and_then(|before| direction(plus(figure.anchors[other].at, figure.anchors[before].at, -1.0)));
        let way = way.unwrap_or_else(|| {
            let along = directions.get(part).copied().flatten();
            way_off(figure, &Contact { point: other, path: ground, distance: 1, along }, true)
        });
        figure.anchors[ground].at = plus(figure.anchors[other].at, way, HANGING);
        let name = format!("ground of {}", figure.parts[part].name);
        figure.supports.push(crate::figure::Support { name, anchor: ground, holds: crate::figure::Holds::All });
    }
}

fn is_path<M>(figure: &Figure<M>, anchor: usize) -> bool {
    matches!(figure.anchors[anchor].moves, Moves::Path { .. })
}
