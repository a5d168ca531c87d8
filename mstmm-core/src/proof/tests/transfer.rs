//! The numbers of every element against its transfer matrix, which no proof reads.
//!
//! Springs hold both ends of an element. At a frequency its transfer matrix tells the stiffness of the last spring at which the whole is
//! singular. There, and nowhere else, the proof has to count one more. A wrong number of `member_numbers`, or of the stiffness that the proof
//! makes of it, puts the step of the count elsewhere.

use crate::element::{BodyNumbers, Exact, MatrixOf, MemberNumbers, OwnPart, TransferMatrix};
use crate::model::{MemberPlane, Spot, StateSpace};
use crate::number::{Parameter, Scalar};
use crate::proof::prover::Prover;
use crate::proof::tests::random::Random;
use crate::proof::visit::{MemberEnd, NodeNumbers, Visited, Visitor};
use crate::{Coordinate, DoubleDouble, Freedoms, Space, Support};
use core::ops::Index;
use std::vec::Vec;

/// Relative bound of the rounding of a transfer matrix beside the terms of the determinant.
const ROUNDED: f64 = 1e-27;

/// Relative distance from the singular spring beyond which a step says too little: the next word of a parameter is as far.
const SHARP: f64 = 1e-19;

/// An element between springs to the ground.
pub(super) struct Sprung {
    space: Space,
    numbers: MemberNumbers,
    /// Levers before and behind the element, in a bending path.
    levers: [DoubleDouble; 2],
    /// Where the far end stands, of an element of a frame, and the vector along it.
    far: [Exact; 3],
    along: [Exact; 3],
    /// The springs of both ends, in the order of the displacements.
    springs: [Vec<DoubleDouble>; 2],
}

impl Visited for Sprung {
    fn visit(&self, visitor: &mut dyn Visitor) {
        if self.space.is(Space::Planar) { self.visit_frame(visitor) } else { self.visit_tree(visitor) }
    }

    fn spot(&self, place: usize) -> Spot {
        Spot::Step(place)
    }

    fn own_part(&self, _: usize, _: [f64; 2]) -> Option<OwnPart> {
        None
    }
}

impl Sprung {
    /// Joins springs to the paths that have come so far; returns the next step.
    fn join(&self, [mut step, end]: [usize; 2], mut inputs: Vec<usize>, visitor: &mut dyn Visitor) -> usize {
        for (coordinate, spring) in self.space.displacements().iter().zip(&self.springs[end]) {
            let (space, freedom) = match coordinate {
                Coordinate::Theta => (Space::Rotation, 2),
                _ => (Space::Translation, 0),
            };
            visitor.tip(step, Support::Fixed);
            visitor.element(step + 1, step, space, &MemberNumbers::Spring(freedom, spring.words()));
            inputs.push(step + 1);
            step += 2;
        }
        visitor.connection(step, &inputs, (end == 0).then_some(self.space));
        step + 1
    }

    fn visit_tree(&self, visitor: &mut dyn Visitor) {
        visitor.tip(0, Support::Free);
        let lever = |end: usize| {
            MemberNumbers::Body(BodyNumbers { output_x: self.levers[end].words(), ..BodyNumbers::default() })
        };
        let mut step = self.join([1, 0], [0].into(), visitor);
        if self.space.is(Space::Bending) {
            visitor.element(step, step - 1, self.space, &lever(0));
            visitor.element(step + 1, step, self.space, &self.numbers);
            visitor.element(step + 2, step + 1, self.space, &lever(1));
            step += 2;
        } else {
            visitor.element(step, step - 1, self.space, &self.numbers);
        }
        let last = self.join([step + 1, 1], [step].into(), visitor);
        visitor.root(last - 1, Support::Free);
    }

    fn visit_frame(&self, visitor: &mut dyn Visitor) {
        let near = [[0.0; 2]; 3];
        let node = |index, place, free| NodeNumbers { index, place, free, skew: None };
        let ends = [node(1, near, Freedoms::PLANE), node(2, self.far, Freedoms::PLANE)];
        let end_at = |node: NodeNumbers, along| MemberEnd { node, place: node.place, along, released: Freedoms::NONE };
        let own_axes = matches!(self.numbers, MemberNumbers::Joint(..)).then_some(self.along);
        let [c, s, z] = self.along;
        let across = [s.map(|part| -part), c, z];
        let springs = |end: usize, visitor: &mut dyn Visitor| {
            let ground = node(0, ends[end].place, Freedoms::NONE);
            let spring_axes = [(0, Some(self.along)), (0, Some(across)), (2, None)];
            for ((freedom, along), spring) in spring_axes.into_iter().zip(&self.springs[end]) {
                let numbers = MemberNumbers::Spring(freedom, spring.words());
                visitor.member(
                    (0, Freedoms::PLANE, MemberPlane::Structure),
                    &numbers,
                    &[end_at(ground, along), end_at(ends[end], along)],
                    ends[end].index,
                );
            }
        };
        springs(0, visitor);
        let member = (0, Freedoms::PLANE, MemberPlane::Structure);
        visitor.member(member, &self.numbers, &ends.map(|node| end_at(node, own_axes)), 1);
        visitor.leave(1);
        springs(1, visitor);
        visitor.leave(2);
    }
}

/// A determinant, and the sum of the sizes of its terms.
fn determinant(rows: &[Vec<[DoubleDouble; 2]>]) -> [DoubleDouble; 2] {
    let zero = DoubleDouble::from_f64(0.0);
    let Some((first, others)) = rows.split_first() else { return [DoubleDouble::from_f64(1.0); 2] };
    let mut sums = [zero; 2];
    for (column, [entry, size]) in first.iter().enumerate() {
        let without = |row: &Vec<[DoubleDouble; 2]>| {
            let kept = row.iter().enumerate().filter(|(other, _)| *other != column);
            kept.map(|(_, entry)| *entry).collect()
        };
        let [minor, sizes] = determinant(&others.iter().map(without).collect::<Vec<_>>());
        let product = *entry * minor;
        sums = [if column % 2 == 0 { sums[0] + product } else { sums[0] - product }, sums[1] + *size * sizes];
    }
    sums
}

/// The sign of the force of a spring to the ground in a state: a moment turns with the rotation, a shear force against the displacement.
fn sign(coordinate: Coordinate) -> DoubleDouble {
    DoubleDouble::from_f64(if coordinate == Coordinate::Theta { 1.0 } else { -1.0 })
}

/// The stiffness of a spring at the output end at which the whole is singular, and a relative bound of its rounding.
fn singular(
    u: &[Vec<DoubleDouble>],
    space: Space,
    springs: &[Vec<DoubleDouble>; 2],
    last: usize,
) -> (DoubleDouble, f64) {
    let (coordinates, displacements) = (space.coordinates(), space.displacements());
    let place = |coordinate: Coordinate| coordinates.iter().position(|own| *own == coordinate).unwrap();
    // an entry of the state at the output end, where a displacement of the input end is 1, and the sum of the sizes of its terms
    let entry = |row: Coordinate, column: usize| {
        let displacement = displacements[column];
        let force = sign(displacement) * springs[0][column];
        let parts = [(displacement, DoubleDouble::from_f64(1.0)), (displacement.dual(), force)];
        let terms = parts.map(|(coordinate, part)| u[place(row)][place(coordinate)] * part);
        [terms[0] + terms[1], Parameter::abs(terms[0]) + Parameter::abs(terms[1])]
    };
    let row_of = |row: Coordinate| (0..displacements.len()).map(|column| entry(row, column)).collect::<Vec<_>>();
    let balance = |end: usize| {
        let (forces, moved) = (row_of(displacements[end].dual()), row_of(displacements[end]));
        let spring = sign(displacements[end]) * springs[1][end];
        let sums = forces.iter().zip(&moved).map(|([force, size], [displacement, other])| {
            [*force + spring * *displacement, *size + Parameter::abs(spring) * *other]
        });
        sums.collect::<Vec<_>>()
    };
    let of = |own: Vec<[DoubleDouble; 2]>| {
        let row = |end: usize| if end == last { own.clone() } else { balance(end) };
        determinant(&(0..displacements.len()).map(row).collect::<Vec<_>>())
    };
    let [[forces, sizes], [moved, others]] =
        [displacements[last].dual(), displacements[last]].map(|coordinate| of(row_of(coordinate)));
    let spring = -forces / (sign(displacements[last]) * moved);
    let rounded = sizes.to_f64() / forces.to_f64().abs() + others.to_f64() / moved.to_f64().abs();
    (spring, rounded * ROUNDED)
}

/// A transfer matrix between levers.
fn behind_levers(u: &[Vec<DoubleDouble>], levers: [DoubleDouble; 2]) -> Vec<Vec<DoubleDouble>> {
    let mut u = u.to_vec();
    for row in &mut u {
        let [y, _, m, _] = row[..] else { continue };
        row[1] += y * levers[0];
        row[3] += m * levers[0];
    }
    for column in 0..u.len() {
        let [moved, turned] = [1, 3].map(|row| levers[1] * u[row][column]);
        u[0][column] += moved;
        u[2][column] += turned;
    }
    u
}

/// The minor of a transfer matrix that vanishes where the element vibrates with both ends held.
fn held_minor(u: &[Vec<DoubleDouble>], space: Space) -> f64 {
    let place = |coordinate: &Coordinate| space.coordinates().iter().position(|own| own == coordinate).unwrap();
    let row = |row: &Coordinate| {
        let force = |column: &Coordinate| [u[place(row)][place(&column.dual())]; 2];
        space.displacements().iter().map(force).collect::<Vec<_>>()
    };
    determinant(&space.displacements().iter().map(row).collect::<Vec<_>>())[0].to_f64()
}

/// A frequency beside one at which the element vibrates with both ends held, above ω, if there is one not far away.
pub(super) fn beside_pole(
    random: &mut Random,
    space: Space,
    omega: f64,
    rows: impl Fn(f64) -> Vec<Vec<DoubleDouble>>,
) -> f64 {
    let minor = |omega: f64| held_minor(&rows(omega), space);
    let (mut lower, mut upper, sign) = (omega, omega, minor(omega));
    while minor(upper) * sign > 0.0 {
        (lower, upper) = (upper, 1.2 * upper);
        if upper > 20.0 * omega {
            return omega;
        }
    }
    for _ in 0..60 {
        let middle = lower + 0.5 * (upper - lower);
        if minor(middle) * sign > 0.0 { lower = middle } else { upper = middle }
    }
    let away = 10f64.powf(-1.0 - 15.0 * random.unit());
    upper * if random.below(2) == 0 { 1.0 + away } else { 1.0 - away }
}

/// What was seen of an element.
#[derive(Default)]
pub(super) struct Seen {
    pub(super) tried: usize,
    /// Springs known so sharply that a step tells the words of parameters.
    pub(super) sharp: usize,
    /// Sharp ones whose counts are decided and differ by one.
    pub(super) stepped: usize,
    /// Others, with what was counted on both sides.
    pub(super) wrong: Vec<[[Option<u64>; 2]; 2]>,
}

/// Holds an element to its transfer matrix at one frequency, between random springs.
pub(super) fn step(
    random: &mut Random,
    (space, numbers): (Space, MemberNumbers),
    u: &[Vec<DoubleDouble>],
    (length, omega): (DoubleDouble, f64),
    seen: &mut Seen,
) {
    let freedoms = space.displacements().len();
    let mut springs = [0, 1].map(|_| {
        // a joint adds a stiffness of its own, which a spring of the opposite sign may cancel
        let is_joint = matches!(numbers, MemberNumbers::Joint(..));
        let sized = |size: f64| if is_joint { size.abs() } else { size };
        let size = |_| DoubleDouble::from_f64(sized(random.any_size(1.0)));
        (0..freedoms).map(size).collect::<Vec<_>>()
    });
    let last = seen.tried % freedoms;
    let levers = [0, 1].map(|_| DoubleDouble::from_f64(if random.below(2) == 0 { 0.0 } else { random.signed() }));
    let u = if space.is(Space::Bending) { &behind_levers(u, levers) } else { u };
    let (spring, distance) = singular(u, space, &springs, last);
    seen.tried += 1;
    // the side of a triangle of 3, 4 and 5: places of a frame are exact, but for a rounding of the last word
    let is_joint = matches!(numbers, MemberNumbers::Joint(..));
    let fifth = length / DoubleDouble::from_f64(5.0);
    let part = |side: f64| (fifth * DoubleDouble::from_f64(if is_joint { 0.0 } else { side })).words();
    if !(distance < SHARP && spring.to_f64().abs() < 1e30 && spring.to_f64().abs() > 1e-30) {
        return;
    }
    seen.sharp += 1;
    let counts = [-1.0, 1.0].map(|side| {
        let off = Parameter::abs(spring) * DoubleDouble::from_f64(side * distance);
        springs[1][last] = spring + off;
        let along = [[3.0, 0.0], [4.0, 0.0], [0.0; 2]];
        let sprung =
            Sprung { space, numbers, levers, far: [part(3.0), part(4.0), [0.0; 2]], along, springs: springs.clone() };
        Prover::new(&sprung).bounds(omega, 1.0)
    });
    match counts {
        [[Some(a), Some(b)], [Some(c), Some(d)]] if a == b && c == d && a == c + 1 => seen.stepped += 1,
        _ => seen.wrong.push(counts),
    }
}

/// The rows of a transfer matrix.
pub(super) fn rows<E>(built: &E::Built, omega: f64) -> Vec<Vec<DoubleDouble>>
where
    E: TransferMatrix<DoubleDouble>,
    MatrixOf<E, DoubleDouble>: Index<(usize, usize), Output = DoubleDouble>,
{
    let size = <E::State as StateSpace>::SPACE.size();
    let u = E::transfer_matrix(built, DoubleDouble::from_f64(omega));
    (0..size).map(|i| (0..size).map(|j| u[(i, j)]).collect()).collect()
}
