//! Pieces of what is drawn in space, those that are far first, each with paper around it.

use crate::figure::Figure;
use crate::ink::{Ink, Pen};
use crate::kind::Kind;
use crate::outline::Outline;
use crate::pose::Pose;
use crate::scene::Scene;
use crate::solid::Solid;
use crate::supports::directions_at;
use crate::vector::{Vector, between, direction, distance, dot, plus, turned};
use crate::write::{POINT, rank};

/// The longest piece of a line, in units of the paper.
const PIECE: f64 = 26.0;

/// How far from another line its halo begins, and at most from an end, where lines meet at small angles.
const CLEAR: f64 = 7.0;
const MOST_TRIM: f64 = 60.0;

/// How far a piece goes on below the next one, so that no paper shows between both.
const OVERLAP: f64 = 1.0;

/// A piece of a part, or a point.
pub(crate) struct Piece<'a> {
    pub(crate) name: &'a str,
    pub(crate) word: &'static str,
    /// How near it is, and how far above others at one place.
    order: (f64, u8),
    /// Where a point is.
    pub(crate) at: Option<Vector>,
    /// What is drawn of it at some moments.
    pub(crate) moments: Vec<Vec<Ink>>,
}

/// The pieces of all parts at some moments, those that are far first.
pub(crate) fn pieces<'a, M>(figure: &'a Figure<M>, scene: &Scene, poses: &[Pose]) -> Vec<Piece<'a>> {
    sorted((0..figure.parts.len()).flat_map(|part| pieces_of(figure, scene, part, poses)).collect())
}

/// The pieces of all parts at rest and the points that have names, those that are far first.
pub(crate) fn at_rest<'a, M>(figure: &'a Figure<M>, scene: &Scene) -> Vec<Piece<'a>> {
    let mut all = pieces(figure, scene, &[Pose::at_rest(figure)]);
    all.extend(figure.anchors.iter().enumerate().filter_map(|(index, anchor)| {
        let dot = vec![vec![Ink::new(Pen::Dot, Outline::Disc(anchor.at, POINT))]];
        let (name, order) = (anchor.name.as_deref()?, (at_anchor(scene, index), 1));
        Some(Piece { name, word: "point", order, at: Some(anchor.at), moments: dot })
    }));
    sorted(all)
}

fn sorted(mut all: Vec<Piece<'_>>) -> Vec<Piece<'_>> {
    all.sort_by(|Piece { order: (one, below), .. }, Piece { order: (other, above), .. }| {
        one.total_cmp(other).then(below.cmp(above))
    });
    all
}

/// How near what stands at an anchor is drawn: above the pieces of lines that meet there.
fn at_anchor(scene: &Scene, anchor: usize) -> f64 {
    scene.depths[anchor] + PIECE
}

/// The pieces of a part.
fn pieces_of<'a, M>(figure: &'a Figure<M>, scene: &Scene, index: usize, poses: &[Pose]) -> Vec<Piece<'a>> {
    let part = &figure.parts[index];
    let (first, last) = (part.ends[0], part.ends[part.ends.len() - 1]);
    let moments: Vec<Vec<Ink>> = poses.iter().map(|pose| pose.inks(figure, index)).collect();
    let order = rank(part.kind);
    let piece =
        |depth: f64, moments| Piece { name: &part.name, word: part.word, order: (depth, order), at: None, moments };
    let strokes: Vec<[usize; 2]> = match part.kind {
        // lines from the mass centre to what it ties
        Kind::Solid(Solid::Body) => part.ends[..part.ends.len() - 1].iter().map(|end| [last, *end]).collect(),
        kind if kind.is_line() => vec![[first, last]],
        kind if kind.is_at_a_point() => return vec![piece(at_anchor(scene, last), moments)],
        _ => {
            let room = Room::of(figure, scene, [first, last]);
            let halo = |pose: &Pose| room.halo(&pose.line([first, last]), Pen::WideHalo, [0.0, 1.0]);
            let both = poses.iter().zip(moments).map(|(pose, inks)| halo(pose).into_iter().chain(inks).collect());
            return vec![piece(room.depth(0.5), both.collect())];
        }
    };
    let mut pieces = Vec::new();
    for (stroke, ends) in strokes.into_iter().enumerate() {
        let room = Room::of(figure, scene, ends);
        for [start, end] in room.parts() {
            let cut = moments.iter().map(|inks| room.piece(&inks[0], stroke, [start, end])).collect();
            pieces.push(piece(room.depth(0.5 * (start + end)), cut));
        }
    }
    let others: Vec<Vec<Ink>> = moments.into_iter().map(|inks| inks.into_iter().skip(1).collect()).collect();
    if others.iter().any(|inks| !inks.is_empty()) {
        pieces.push(piece(at_anchor(scene, last), others));
    }
    pieces
}

/// Where a line is at rest.
struct Room {
    /// How near its ends are.
    depths: [f64; 2],
    /// Its length on the paper.
    length: f64,
    /// How far from its ends, where other lines meet it, there is no paper around it.
    trims: [f64; 2],
}

impl Room {
    fn of<M>(figure: &Figure<M>, scene: &Scene, ends: [usize; 2]) -> Self {
        let [from, to] = ends.map(|end| figure.anchors[end].at);
        let way = direction(plus(to, from, -1.0)).unwrap_or_default();
        let trims = [(from, 1.0), (to, -1.0)].map(|(at, sign)| {
            let reach = |other: Vector| {
                let [along, aside] = [sign * dot(way, other), dot(turned(way), other).abs()];
                // none of itself
                if along < 0.0 || aside < 1e-3 { CLEAR } else { (CLEAR / aside).min(MOST_TRIM) }
            };
            directions_at(figure, at).into_iter().map(reach).fold(CLEAR, f64::max)
        });
        Room { depths: ends.map(|end| scene.depths[end]), length: distance(from, to), trims }
    }

    /// How near a part of it is.
    fn depth(&self, part: f64) -> f64 {
        self.depths[0] + part * (self.depths[1] - self.depths[0])
    }

    /// From where to where its pieces are, as parts of its length.
    fn parts(&self) -> impl Iterator<Item = [f64; 2]> + use<> {
        let reach = self.length.hypot(self.depths[1] - self.depths[0]);
        let count = (reach / PIECE).ceil().max(1.0) as u32;
        (0..count).map(move |k| [k, k + 1].map(|k| f64::from(k) / f64::from(count)))
    }

    /// A piece of one of the lines of a pen, with paper around it.
    fn piece(&self, ink: &Ink, line: usize, [start, end]: [f64; 2]) -> Vec<Ink> {
        let Outline::Lines(lines) = &ink.outline else { return vec![ink.clone()] };
        let pen = if ink.pen == Pen::Beam { Pen::WideHalo } else { Pen::Halo };
        let over = if self.length > OVERLAP { OVERLAP / self.length } else { 0.0 };
        let own = cut(&lines[line], [(start - over).max(0.0), (end + over).min(1.0)]);
        let halo = self.halo(&lines[line], pen, [start, end]);
        halo.into_iter().chain([Ink::new(ink.pen, Outline::line(own))]).collect()
    }

    /// Paper around a piece, but where other lines meet it.
    fn halo(&self, line: &[Vector], pen: Pen, [start, end]: [f64; 2]) -> Option<Ink> {
        let [first, last] = self.trims.map(|trim| trim / self.length);
        let part = [start.max(first), end.min(1.0 - last)];
        (part[0] < part[1]).then(|| Ink::new(pen, Outline::line(cut(line, part))))
    }
}

/// What of a line is between two parts of it; of two lines with as many corners it has as many.
fn cut(line: &[Vector], part: [f64; 2]) -> Vec<Vector> {
    let Some(last) = line.len().checked_sub(2) else { return line.to_vec() };
    let [(from, first), (to, behind)] = part.map(|part| {
        let place = part * (last + 1) as f64;
        let corner = (place as usize).min(last);
        (between(line[corner], line[corner + 1], place - corner as f64), corner + 1)
    });
    [&[from], &line[first..behind], &[to]].concat()
}
