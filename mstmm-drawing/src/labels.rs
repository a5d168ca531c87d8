//! Places for labels, where they cover neither each other nor what is drawn; a line leads from those that stand far from what they name.

use crate::ink::Ink;
use crate::room::{Area, Room, Shell, strokes};
use crate::vector::{Vector, between, direction, distance, plus, turned};

/// Size of letters, and the width of one as a part of it: a bound for the fonts of the style sheet.
pub(crate) const SIZE: f64 = 13.0;
const WIDTH: f64 = 0.62;

/// Distance of a label from its place.
const GAP: f64 = 5.0;

/// Directions that are tried, and how much farther each round is.
const DIRECTIONS: u32 = 24;
const FARTHER: f64 = 6.0;
const ROUNDS: u32 = 40;

/// Places along a line beside which its label may stand, as parts of its length.
const PLACES: [f64; 7] = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8];

/// What the next place along a line costs, a direction that is not across it, and a line to the label, each beside a round.
const SLID: f64 = 0.4;
const TURNED: f64 = 1.5;
const LED: f64 = 5.0;

/// Distance from which on a line leads to a label of a point or a value, and to one across a symbol; the least length of that line.
const FAR: f64 = 18.0;
const FAR_ACROSS: f64 = 24.0;
const SHORTEST: f64 = 9.0;

/// By how much a label is nearer to what it names than to all else of its kind.
const NEARER: f64 = 1.0;

/// What a label names.
#[derive(Clone, Debug)]
pub(crate) enum Subject {
    /// A place.
    Point(Vector),
    /// A line between two places.
    Line([Vector; 2]),
    /// What has room inside, with places there.
    Shell(Shell, Vec<Vector>),
}

/// A label that is to be placed.
#[derive(Clone, Debug)]
pub(crate) struct Wanted {
    pub(crate) text: String,
    /// The class in the style sheet.
    pub(crate) class: &'static str,
    /// What the source calls the whole.
    pub(crate) title: String,
    pub(crate) subject: Subject,
}

/// A label with the middle of its box.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    pub(crate) wanted: Wanted,
    pub(crate) middle: Vector,
    /// The line that leads to it, where it stands far away.
    pub(crate) leader: Option<[Vector; 2]>,
}

impl Subject {
    /// The line that it is, a place as one without length.
    fn line(&self) -> [Vector; 2] {
        match self {
            Subject::Point(at) => [*at; 2],
            Subject::Line(ends) => *ends,
            Subject::Shell(_, places) => [places[0]; 2],
        }
    }

    /// The places beside which its label may stand, and the directions from there, each with what it costs.
    fn sides(&self) -> (Vec<Vector>, Vec<(Vector, f64)>) {
        let [from, to] = self.line();
        // upwards to the right first
        let angle = |step: u32| std::f64::consts::TAU * (f64::from(step) / f64::from(DIRECTIONS) + 0.125);
        let around = (0..DIRECTIONS).map(|step| ([angle(step).cos(), -angle(step).sin()], 0.02 * f64::from(step)));
        let Some(along) = direction(plus(to, from, -1.0)) else { return (vec![from], around.collect()) };
        let [x, y] = turned(along);
        // upwards first, or to the right of an upright line
        let sign = if y < -1e-9 || y.abs() <= 1e-9 && x > 0.0 { 1.0 } else { -1.0 };
        let across = [([sign * x, sign * y], 0.0), ([-sign * x, -sign * y], 0.02)];
        let others = around.map(|(way, cost)| (way, TURNED + cost));
        (PLACES.map(|part| between(from, to, part)).into(), across.into_iter().chain(others).collect())
    }
}

/// A bound for the width of a text in letters of some size. Letters from Hangul on may be as wide as they are high.
pub(crate) fn width_of(text: &str, size: f64) -> f64 {
    text.chars().map(|letter| if letter < '\u{1100}' { WIDTH * size } else { size }).sum()
}

/// Half of the box of a text.
fn half_of(text: &str) -> Vector {
    [0.5 * width_of(text, SIZE) + 1.0, 0.5 * SIZE]
}

/// The box of a placed label: its corners.
pub(crate) fn corners(label: &Placed) -> [Vector; 2] {
    let half = half_of(&label.wanted.text);
    [plus(label.middle, half, -1.0), plus(label.middle, half, 1.0)]
}

/// Whether nothing is drawn or written in a box, by its middle and half of its sides.
pub(crate) fn is_free(middle: Vector, half: Vector, inks: &[Ink], labels: &[Placed]) -> bool {
    let area = Area { middle, half };
    let is_apart = |label: &Placed| {
        let text = Area { middle: label.middle, half: half_of(&label.wanted.text) };
        !text.covers(&area) && label.leader.is_none_or(|leader| !area.is_crossed(leader, 1.0))
    };
    let mut drawn = inks.iter().flat_map(strokes);
    labels.iter().all(is_apart) && !drawn.any(|(line, thickness)| area.is_crossed(line, thickness))
}

/// Labels while they are placed.
struct Placing<'a> {
    wanted: &'a [Wanted],
    room: Room,
    areas: Vec<Area>,
    leaders: Vec<[Vector; 2]>,
}

/// Where a label may stand.
struct Candidate {
    cost: f64,
    area: Area,
    leader: Option<[Vector; 2]>,
}

/// Places labels one after the other. One without room within all rounds is left out, and that of a joint where it has none beside it.
pub(crate) fn placed(wanted: Vec<Wanted>, inks: &[Ink]) -> Vec<Placed> {
    let mut placing = Placing { wanted: &wanted, room: Room::of(inks), areas: Vec::new(), leaders: Vec::new() };
    let mut found = Vec::new();
    for (index, label) in wanted.iter().enumerate() {
        let best = placing.best(index).filter(|best| label.class != "joint" || best.leader.is_none());
        let Some(Candidate { area, leader, .. }) = best else { continue };
        placing.areas.push(area);
        placing.leaders.extend(leader);
        found.push(Placed { wanted: label.clone(), middle: area.middle, leader });
    }
    found
}

impl Placing<'_> {
    /// The best place of a label; none where there is no room within all rounds.
    fn best(&self, index: usize) -> Option<Candidate> {
        let label = &self.wanted[index];
        let half = half_of(&label.text);
        if let Subject::Shell(shell, places) = &label.subject {
            let mut inside = places.iter().map(|middle| Area { middle: *middle, half });
            if let Some(area) = inside.find(|area| self.is_apart(area) && self.room.is_free_in(area, shell)) {
                return Some(Candidate { cost: 0.0, area, leader: None });
            }
        }
        let (places, ways) = label.subject.sides();
        let mut best: Option<Candidate> = None;
        for round in (0..ROUNDS).map(f64::from) {
            let least = best.as_ref().map_or(f64::INFINITY, |best| best.cost);
            if round >= least {
                break;
            }
            for (slid, at) in places.iter().enumerate() {
                for (way, turned) in &ways {
                    let cost = round + SLID * slid as f64 + turned;
                    let reach = GAP + FARTHER * round + way[0].abs() * half[0] + way[1].abs() * half[1];
                    let area = Area { middle: plus(*at, *way, reach), half };
                    let least = best.as_ref().map_or(f64::INFINITY, |best| best.cost);
                    if cost < least && self.is_apart(&area) && self.room.is_free(&area) {
                        best = self.led(index, *at, area, cost).filter(|own| own.cost < least).or(best);
                    }
                }
            }
        }
        best
    }

    /// A place with a line to it where it is far away or another of the same class is nearer; none where that line has no room.
    fn led(&self, index: usize, at: Vector, area: Area, cost: f64) -> Option<Candidate> {
        let label = &self.wanted[index];
        let own = area.distance(label.subject.line());
        let is_near = |other: &Wanted| area.distance(other.subject.line()) < own + NEARER;
        let mut others = self.wanted.iter().enumerate().filter(|(k, other)| *k != index && other.class == label.class);
        let far = if matches!(label.class, "point" | "value") { FAR } else { FAR_ACROSS };
        if own < far && !others.any(|(_, other)| is_near(other)) {
            return Some(Candidate { cost, area, leader: None });
        }
        let leader = [at, area.nearest(at)];
        let is_clear = self.areas.iter().all(|other| !other.is_crossed(leader, 1.0));
        let leads = distance(leader[0], leader[1]) >= SHORTEST && is_clear;
        leads.then_some(Candidate { cost: cost + LED, area, leader: Some(leader) })
    }

    /// Whether a box is apart from all labels and from the lines that lead to them.
    fn is_apart(&self, area: &Area) -> bool {
        !self.areas.iter().any(|other| other.covers(area))
            && !self.leaders.iter().any(|leader| area.is_crossed(*leader, 1.0))
    }
}
