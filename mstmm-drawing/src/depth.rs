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
const CLEAR_OF_SUPPORT: f64 = 20.0;
const MOST_TRIM: f64 = 60.0;

/// Half of the width of the widest line with the paper around it, and how wide that paper is beside a beam.
const WIDE: f64 = 6.4;
const PAPER: f64 = 2.7;

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
    /// The line of which it is a piece, and from where to where.
    of: Option<(usize, [f64; 2])>,
}

/// The pieces of all parts at some moments, those that are far first.
pub(crate) fn pieces<'a, M>(figure: &'a Figure<M>, scene: &Scene, poses: &[Pose]) -> Vec<Piece<'a>> {
    Pieces::of(figure, scene, poses).joined()
}

/// The pieces of all parts at rest and the points that have names, those that are far first.
pub(crate) fn at_rest<'a, M>(figure: &'a Figure<M>, scene: &Scene) -> Vec<Piece<'a>> {
    let mut all = Pieces::of(figure, scene, &[Pose::at_rest(figure)]);
    for (index, anchor) in figure.anchors.iter().enumerate() {
        if let Some(name) = &anchor.name {
            let moments = vec![vec![Ink::new(Pen::Dot, Outline::Disc(anchor.at, POINT))]];
            let order = (at_anchor(scene, index), 1);
            all.pieces.push(Piece { name, word: "point", order, at: Some(anchor.at), moments, of: None });
        }
    }
    all.joined()
}

/// How near what stands at an anchor is drawn: above the pieces of lines that meet there.
fn at_anchor(scene: &Scene, anchor: usize) -> f64 {
    scene.depths[anchor] + PIECE
}

/// A line of a part at some moments.
struct Source {
    room: Room,
    pen: Pen,
    width: Option<f64>,
    moments: Vec<Vec<Vector>>,
}

impl Source {
    fn piece(&self, part: [f64; 2]) -> Vec<Vec<Ink>> {
        self.moments.iter().map(|line| self.room.piece((self.pen, self.width), line, part)).collect()
    }
}

/// Pieces and the lines of which they are.
struct Pieces<'a> {
    pieces: Vec<Piece<'a>>,
    sources: Vec<Source>,
}

impl<'a> Pieces<'a> {
    fn of<M>(figure: &'a Figure<M>, scene: &Scene, poses: &[Pose]) -> Self {
        let mut all = Pieces { pieces: Vec::new(), sources: Vec::new() };
        (0..figure.parts.len()).for_each(|part| all.add_part(figure, scene, part, poses));
        all
    }

    fn add_part<M>(&mut self, figure: &'a Figure<M>, scene: &Scene, index: usize, poses: &[Pose]) {
        let part = &figure.parts[index];
        let (first, last) = (part.ends[0], part.ends[part.ends.len() - 1]);
        let mut moments: Vec<Vec<Ink>> = poses.iter().map(|pose| pose.inks(figure, index)).collect();
        let piece = |depth: f64, moments, of| {
            let order = (depth, rank(part.kind));
            Piece { name: &part.name, word: part.word, order, at: None, moments, of }
        };
        let strokes: Vec<[usize; 2]> = match part.kind {
            // lines from the mass centre to what it ties
            Kind::Solid(Solid::Body) => part.ends[..part.ends.len() - 1].iter().map(|end| [last, *end]).collect(),
            kind if kind.is_line() => vec![[first, last]],
            kind if kind.is_at_a_point() => return self.pieces.push(piece(at_anchor(scene, last), moments, None)),
            _ => {
                let room = Room::of(figure, scene, [first, last]);
                for (pose, inks) in poses.iter().zip(&mut moments) {
                    let halo = room.halo(&pose.line([first, last]), Pen::WideHalo, [0.0, 1.0]);
                    inks.splice(0..0, halo);
                }
                return self.pieces.push(piece(room.depth(0.5), moments, None));
            }
        };
        for (stroke, ends) in strokes.into_iter().enumerate() {
            let source = Source {
                room: Room::of(figure, scene, ends),
                pen: moments[0][0].pen,
                width: moments[0][0].width,
                moments: moments.iter().map(|inks| inks[0].outline.line_at(stroke)).collect(),
            };
            let number = self.sources.len();
            self.pieces.extend(source.room.parts().map(|[start, end]| {
                let depth = source.room.depth(0.5 * (start + end));
                piece(depth, source.piece([start, end]), Some((number, [start, end])))
            }));
            self.sources.push(source);
        }
        moments.iter_mut().for_each(|inks| drop(inks.remove(0)));
        if moments.iter().any(|inks| !inks.is_empty()) {
            self.pieces.push(piece(at_anchor(scene, last), moments, None));
        }
    }

    /// All pieces, those that are far first. Neighbours are one, where nothing that is drawn between them is at the place of the second.
    fn joined(mut self) -> Vec<Piece<'a>> {
        let far_first = |one: &Piece<'_>, other: &Piece<'_>| {
            one.order.0.total_cmp(&other.order.0).then(one.order.1.cmp(&other.order.1))
        };
        self.pieces.sort_by(far_first);
        let mut found: Vec<(Piece<'a>, [Vector; 2])> = Vec::new();
        for piece in self.pieces {
            let own = reach(&piece.moments);
            let before =
                piece.of.and_then(|of| Some((found.iter().rposition(|(other, _)| touch(other.of, of))?, of.1)));
            match before.filter(|(at, _)| found[at + 1..].iter().all(|(_, other)| are_apart(other, &own))) {
                Some((at, [start, end])) => {
                    let (run, place) = &mut found[at];
                    *place = [low(place[0], own[0]), high(place[1], own[1])];
                    if let Some((source, [first, last])) = run.of {
                        let whole = [first.min(start), last.max(end)];
                        run.of = Some((source, whole));
                        run.moments = self.sources[source].piece(whole);
                    }
                }
                None => found.push((piece, own)),
            }
        }
        found.into_iter().map(|(piece, _)| piece).collect()
    }
}

/// Whether a piece goes on where another one ends.
fn touch(run: Option<(usize, [f64; 2])>, (source, [start, end]): (usize, [f64; 2])) -> bool {
    run.is_some_and(|(own, [first, last])| own == source && (last == start || end == first))
}

fn low(a: Vector, b: Vector) -> Vector {
    [a[0].min(b[0]), a[1].min(b[1])]
}

fn high(a: Vector, b: Vector) -> Vector {
    [a[0].max(b[0]), a[1].max(b[1])]
}

/// The box around what is drawn at all moments, with its pens.
fn reach(moments: &[Vec<Ink>]) -> [Vector; 2] {
    let points = || moments.iter().flatten().flat_map(|ink| ink.outline.points());
    [
        points().map(|[x, y]| [x - WIDE, y - WIDE]).fold([f64::INFINITY; 2], low),
        points().map(|[x, y]| [x + WIDE, y + WIDE]).fold([f64::NEG_INFINITY; 2], high),
    ]
}

fn are_apart(one: &[Vector; 2], other: &[Vector; 2]) -> bool {
    (0..2).any(|axis| one[1][axis] < other[0][axis] || other[1][axis] < one[0][axis])
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
        let trims = [(ends[0], from, 1.0), (ends[1], to, -1.0)].map(|(end, at, sign)| {
            let is_held = figure.supports.iter().any(|support| support.anchor == end);
            let clear = if is_held { CLEAR_OF_SUPPORT } else { CLEAR };
            let reach = |other: Vector| {
                let [along, aside] = [sign * dot(way, other), dot(turned(way), other).abs()];
                // none of itself
                if along < 0.0 || aside < 1e-3 { CLEAR } else { (CLEAR / aside).min(MOST_TRIM) }
            };
            directions_at(figure, at).into_iter().map(reach).fold(clear, f64::max)
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

    /// A piece of a line, with paper around it.
    fn piece(&self, (pen, width): (Pen, Option<f64>), line: &[Vector], [start, end]: [f64; 2]) -> Vec<Ink> {
        let over = if self.length > OVERLAP { OVERLAP / self.length } else { 0.0 };
        let own = cut(line, [(start - over).max(0.0), (end + over).min(1.0)]);
        let halo = self.halo(line, if pen == Pen::Beam { Pen::WideHalo } else { Pen::Halo }, [start, end]);
        let halo = halo.map(|halo| Ink { width: width.map(|width| width + 2.0 * PAPER), ..halo });
        halo.into_iter().chain([Ink { width, ..Ink::new(pen, Outline::line(own)) }]).collect()
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
