//! A frame member by member: a node has up to six variables, from the first member that knows it until it leaves.

use crate::element::{Exact, MemberNumbers, OwnPart, SpinNumbers};
use crate::model::{MemberPlane, Skew};
use crate::proof::axes::{Axes, Vector, difference_of, direction, directions, dot, part_across};
use crate::proof::ball::Ball;
use crate::proof::join::{Failure, Join};
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::row::Row;
use crate::proof::visit::{MemberEnd, NodeNumbers};
use mstmm_plan::Freedoms;

/// Most nodes that are in the front at once.
const MOST_NODES: usize = 64;

/// Most variables of a node of a structure in the plane, and twice as many.
pub(crate) const IN_PLANE: usize = Freedoms::SINGLE.len();
pub(crate) const TWICE_IN_PLANE: usize = 2 * IN_PLANE;

/// Most variables of a node of a structure in space, and twice as many.
#[cfg(feature = "std")]
pub(crate) const IN_SPACE: usize = Freedoms::EACH.len();
#[cfg(feature = "std")]
pub(crate) const TWICE_IN_SPACE: usize = 2 * IN_SPACE;

/// A node whose variables are in the front.
#[derive(Clone, Copy, Debug)]
struct Present<const M: usize> {
    index: usize,
    /// The variables of its displacements and rotations; of one that moves along directions the first are these.
    variables: [Option<usize>; M],
}

/// The nodes that are in the front, each with up to `M` variables. A row of two nodes has `TWO` terms.
#[derive(Debug)]
pub(crate) struct Nodes<const M: usize, const TWO: usize> {
    present: [Present<M>; MOST_NODES],
    count: usize,
    /// Forces of rigid joints, each with the node behind which it leaves.
    ties: [(usize, usize); MOST_NODES],
    tie_count: usize,
}

/// Displacements along and across a member and rotations of its ends: how many there are.
const LOCAL: usize = 3;

/// A place that is tied to a node: the variables of that, the directions of the first ones if they are skew, and the vector to the place.
struct Tied<N: Number, const M: usize> {
    variables: [Option<usize>; M],
    skew: Option<[Vector<N>; 2]>,
    offset: Vector<N>,
}

/// The places of displacements along x, y and z, and of rotations about them, among the variables of a node.
const DISPLACEMENTS: [usize; 3] = [0, 1, 3];
const ROTATIONS: [usize; 3] = [4, 5, 2];

impl<N: Level<Word = f64, Alone = N>, const M: usize> Tied<N, M> {
    /// The variable at a place.
    fn variable(&self, place: usize) -> Option<Row<N, 1>> {
        self.variables.get(place).copied().flatten().map(Row::of)
    }

    /// Puts the displacement in a direction e into a row: of a rotation about an axis of the offset o it is the part of `o × e` there.
    fn displace(&self, direction: &Vector<N>, row: &mut Row<N, M>) {
        match &self.skew {
            Some(vectors) => {
                for (place, vector) in vectors.iter().enumerate() {
                    self.variable(place).iter().for_each(|own| row.add(own, dot(vector, direction)));
                }
            }
            None => {
                for (place, part) in DISPLACEMENTS.into_iter().zip(direction) {
                    self.variable(place).iter().for_each(|own| row.add(own, *part));
                }
            }
        }
        for (axis, place) in ROTATIONS.into_iter().enumerate() {
            self.variable(place).iter().for_each(|own| row.add(own, part_across(&self.offset, direction, axis)));
        }
    }

    /// Puts the rotation about an axis into a row.
    fn turn(&self, axis: &Vector<N>, row: &mut Row<N, M>) {
        for (place, part) in ROTATIONS.into_iter().zip(axis) {
            self.variable(place).iter().for_each(|own| row.add(own, *part));
        }
    }
}

impl<const M: usize, const TWO: usize> Nodes<M, TWO> {
    /// No node.
    pub(crate) fn new() -> Self {
        let nobody = Present { index: 0, variables: [None; M] };
        Nodes { present: [nobody; MOST_NODES], count: 0, ties: [(0, 0); MOST_NODES], tie_count: 0 }
    }

    /// The variables of a node, which enter with the first part that knows it.
    fn variables<J: Join>(&mut self, node: &NodeNumbers, joining: &mut J) -> [Option<usize>; M] {
        if let Some(present) = self.present[..self.count].iter().find(|present| present.index == node.index) {
            return present.variables;
        }
        if self.count == MOST_NODES {
            joining.fail(Failure::Full);
            return [None; M];
        }
        let mut variables = [None; M];
        let of_skew = match node.skew {
            None => 0,
            Some(Skew::Along(_)) => 1,
            Some(Skew::Normal(_)) => 2,
        };
        for (place, (variable, freedom)) in variables.iter_mut().zip(Freedoms::EACH).enumerate() {
            if place < of_skew || node.free.contains(freedom) {
                *variable = Some(joining.enter());
            }
        }
        // a node that does not move is eliminated by nobody
        if variables != [None; M] {
            self.present[self.count] = Present { index: node.index, variables };
            self.count += 1;
        }
        variables
    }

    /// A place that is tied to a node.
    fn tied<J: Join>(&mut self, node: &NodeNumbers, place: [Exact; 3], joining: &mut J) -> Tied<J::Alone, M> {
        Tied {
            variables: self.variables(node, joining),
            skew: node.skew.map(directions),
            offset: difference_of(node.place, place),
        }
    }

    /// Displacements along and across a member and the rotation at one of its ends, as far as they are wanted. What an end does not share with
    /// its node is a variable of its own, which leaves when the member has joined.
    #[inline(never)]
    fn local<J: Join>(
        &mut self,
        end: &MemberEnd,
        axes: &Axes<J::Alone>,
        wanted: Freedoms,
        own: &mut Released,
        joining: &mut J,
    ) -> [Row<J::Alone, M>; LOCAL] {
        let tied = self.tied(&end.node, end.place, joining);
        let mut rows = [Row::none(); LOCAL];
        for (row, freedom) in rows.iter_mut().zip(Freedoms::SINGLE).filter(|(_, freedom)| wanted.contains(*freedom)) {
            if end.released.contains(freedom) {
                let variable = joining.enter();
                own.list[own.count] = variable;
                own.count += 1;
                *row = Row::of(variable);
            } else if freedom.is(Freedoms::RZ) {
                tied.turn(&axes.normal, row);
            } else {
                tied.displace(if freedom.is(Freedoms::X) { &axes.along } else { &axes.across }, row);
            }
        }
        rows
    }

    /// The axes of a member, and its length, if it has these from its places.
    fn axes<N: Level<Word = f64, Alone = N>>(ends: &[MemberEnd; 2], plane: &MemberPlane<Exact>) -> (Axes<N>, Ball<N>) {
        let (along, length) = direction(difference_of(ends[0].place, ends[1].place));
        (Axes::new(plane, along), length)
    }

    /// Displacements along and across a member and the rotation at one of its ends, which has axes of its own if it has a direction.
    #[inline(always)]
    fn end<J: Join>(
        &mut self,
        end: &MemberEnd,
        (axes, plane): (&Axes<J::Alone>, &MemberPlane<Exact>),
        wanted: Freedoms,
        own: &mut Released,
        joining: &mut J,
    ) -> [Row<J::Alone, M>; LOCAL] {
        match end.along.filter(|_| !turns_in_plane(wanted, plane)) {
            Some([x, y, z]) => {
                let along = direction([Ball::of_pair(x), Ball::of_pair(y), Ball::of_pair(z)]).0;
                self.local(end, &Axes::new(plane, along), wanted, own, joining)
            }
            None => self.local(end, axes, wanted, own, joining),
        }
    }

    /// A member joins.
    #[inline(never)]
    pub(crate) fn member<J: Join>(
        &mut self,
        (numbers, own_part): (&MemberNumbers, Option<OwnPart>),
        (freedoms, plane): (Freedoms, MemberPlane<Exact>),
        ends: &[MemberEnd; 2],
        next: usize,
        joining: &mut J,
    ) {
        let mut own = Released { list: [0; 2 * LOCAL], count: 0 };
        let wanted = if own_part.is_some() { freedoms } else { freedoms_of(numbers) };
        let has_axes = !turns_in_plane(wanted, &plane) && ends.iter().any(|end| end.along.is_none());
        let (axes, length) = if has_axes { Self::axes(ends, &plane) } else { (Axes::of_structure(), Ball::of(0.0)) };
        let first = self.end(&ends[0], (&axes, &plane), wanted, &mut own, joining);
        let second = self.end(&ends[1], (&axes, &plane), wanted, &mut own, joining);
        let (numbers, damping) = numbers.parted();
        let bent = || [first[1].terms(), first[2].terms(), second[1].terms(), second[2].terms()];
        match &numbers {
            MemberNumbers::Other if own_part.is_some() => {
                let freedom = if freedoms.is(Freedoms::RZ) { 2 } else { 0 };
                self.own(own_part, [&first[freedom], &second[freedom]], last_of(ends, next), joining);
            }
            MemberNumbers::Beam(beam) => {
                if let Some(line) = beam.longitudinal() {
                    joining.add_line((&line, &damping), length, [first[0].terms(), second[0].terms()]);
                }
                joining.add_bending((beam, &damping, &SpinNumbers::NONE), length, bent());
            }
            MemberNumbers::SpinningBeam(beam, spin) => joining.add_bending((beam, &damping, spin), length, bent()),
            MemberNumbers::Tapered(beam) => joining.add_tapered(beam, length, bent()),
            MemberNumbers::String(lines) => {
                for (line, freedom) in lines.iter().zip([0, 1]) {
                    let ends = [first[freedom].terms(), second[freedom].terms()];
                    joining.add_line((line, &damping), length, ends);
                }
            }
            MemberNumbers::LineBetween(freedom, line) => {
                let ends = [first[*freedom].terms(), second[*freedom].terms()];
                joining.add_line((line, &damping), length, ends);
            }
            MemberNumbers::Line(freedom, line) => {
                let ends = [first[*freedom].terms(), second[*freedom].terms()];
                joining.add_line((line, &damping), Ball::of_pair(line.length), ends);
            }
            MemberNumbers::Spring(freedom, stiffness) => {
                joining.add_spring::<M, TWO>((stiffness, &damping), [&first[*freedom], &second[*freedom]]);
            }
            MemberNumbers::Gyroscope(spin) => {
                joining.add_spin(spin, gap::<J, M, TWO>([&first[2], &second[2]], Ball::of(1.0)).terms());
            }
            MemberNumbers::Joint(rigid, elastic) => {
                for (index, (freedom, stiffness)) in Freedoms::SINGLE.into_iter().zip(elastic).enumerate() {
                    if *stiffness != [0.0; 2] {
                        joining.add_spring::<M, TWO>((stiffness, &damping), [&first[index], &second[index]]);
                    }
                    if rigid.contains(freedom) {
                        let gap = gap::<J, M, TWO>([&first[index], &second[index]], Ball::of(1.0));
                        self.tie(gap, last_of(ends, next), joining);
                    }
                }
            }
            _ => joining.fail(Failure::NotInNumbers),
        }
        own.list[..own.count].iter().for_each(|variable| joining.leave(*variable));
    }

    /// An element that is known by its stiffness at this frequency alone, over the displacements of its ends.
    fn own<J: Join>(&mut self, part: Option<OwnPart>, rows: [&Row<J::Alone, M>; 2], last: usize, joining: &mut J) {
        match part {
            Some(OwnPart::Stiffness { stiffness, held }) => {
                joining.add_counted(stiffness, held, rows.map(|row| row.terms()));
            }
            Some(OwnPart::Tie { ratio, stiffness }) => {
                self.tie(gap::<J, M, TWO>(rows, Ball::of_pair(ratio)), last, joining);
                joining.add_term(Ball::of_pair(stiffness), rows[0].terms());
            }
            None => {}
        }
    }

    /// A rigid joint: its force is a variable, which leaves with the last of its nodes.
    #[inline(never)]
    fn tie<J: Join>(&mut self, gap: Row<J::Alone, TWO>, last: usize, joining: &mut J) {
        let force = joining.add_tie(gap.terms());
        if self.tie_count == MOST_NODES {
            joining.fail(Failure::Full);
            return;
        }
        self.ties[self.tie_count] = (force, last);
        self.tie_count += 1;
    }

    /// A body moves with a node.
    pub(crate) fn body<J: Join>(
        &mut self,
        node: &NodeNumbers,
        (mass, inertia): (Exact, &[Exact; 6]),
        centre: [Exact; 3],
        joining: &mut J,
    ) {
        let tied = self.tied(node, centre, joining);
        let axes = Axes::of_structure();
        let (mut displacements, mut rotations) = ([Row::none(); 3], [Row::none(); 3]);
        for (axis, direction) in [&axes.along, &axes.across, &axes.normal].into_iter().enumerate() {
            tied.displace(direction, &mut displacements[axis]);
            tied.turn(direction, &mut rotations[axis]);
        }
        displacements.iter().for_each(|row| joining.add_mass(mass, row.terms()));
        let [xx, yy, zz, products @ ..] = inertia;
        if products.iter().all(|product| *product == [0.0; 2]) {
            for (moment, row) in [xx, yy, zz].into_iter().zip(&rotations) {
                joining.add_mass(*moment, row.terms());
            }
            return;
        }
        let [xy, yz, zx] = products;
        let entries = [xx, xy, yy, zx, yz, zz].map(|entry| Ball::of_pair(*entry));
        joining.add_tensor(entries, rotations.each_ref().map(|row| row.terms()));
    }

    /// The variables of a node leave, and what waits behind them.
    #[inline(never)]
    pub(crate) fn leave<J: Join>(&mut self, node: usize, joining: &mut J) {
        let place = self.present[..self.count].iter().position(|present| present.index == node);
        if let Some(place) = place {
            for variable in self.present[place].variables.into_iter().flatten() {
                joining.leave(variable);
            }
            self.count -= 1;
            self.present.swap(place, self.count);
        }
        joining.leave_behind();
        let mut kept = 0;
        for k in 0..self.tie_count {
            let (force, last) = self.ties[k];
            if last == node {
                joining.leave(force);
            } else {
                self.ties[kept] = self.ties[k];
                kept += 1;
            }
        }
        self.tie_count = kept;
    }
}

/// What a displacement is more than another one times a ratio.
fn gap<J: Join, const M: usize, const TWO: usize>(
    rows: [&Row<J::Alone, M>; 2],
    ratio: Ball<J::Alone>,
) -> Row<J::Alone, TWO> {
    let mut gap = rows[1].widened::<TWO>();
    gap.add(rows[0], -ratio);
    gap
}

/// Whether a member turns about z of a plane structure: then it needs no axes.
fn turns_in_plane(wanted: Freedoms, plane: &MemberPlane<Exact>) -> bool {
    wanted.is(Freedoms::RZ) && *plane == MemberPlane::Structure
}

/// Variables of a member's own.
struct Released {
    list: [usize; 2 * LOCAL],
    count: usize,
}

/// The node of a member that leaves last, given the one that leaves next; a node without displacements is not eliminated.
fn last_of(ends: &[MemberEnd; 2], next: usize) -> usize {
    let moves = |node: &NodeNumbers| node.skew.is_some() || !node.free.is_empty();
    let other = ends.iter().map(|end| &end.node).find(|node| node.index != next && moves(node));
    other.map_or(next, |node| node.index)
}

/// The freedoms in which a member acts, in its own axes.
fn freedoms_of(numbers: &MemberNumbers) -> Freedoms {
    match &numbers.parted().0 {
        MemberNumbers::Beam(beam) if beam.axial_stiffness == [0.0; 2] => Freedoms::Y.union(Freedoms::RZ),
        MemberNumbers::Tapered(_) | MemberNumbers::SpinningBeam(..) => Freedoms::Y.union(Freedoms::RZ),
        MemberNumbers::Beam(_) => Freedoms::PLANE,
        MemberNumbers::String(_) => Freedoms::X.union(Freedoms::Y),
        MemberNumbers::Line(freedom, _)
        | MemberNumbers::LineBetween(freedom, _)
        | MemberNumbers::Spring(freedom, _) => Freedoms::SINGLE[*freedom],
        MemberNumbers::Gyroscope(_) => Freedoms::RZ,
        MemberNumbers::Joint(rigid, elastic) => {
            let elastic = Freedoms::SINGLE.into_iter().zip(elastic).filter(|(_, stiffness)| **stiffness != [0.0; 2]);
            elastic.fold(*rigid, |sum, (freedom, _)| sum.union(freedom))
        }
        _ => Freedoms::PLANE,
    }
}
