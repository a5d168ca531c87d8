//! A frame member by member: a node has up to three variables, from the first member that knows it until it leaves.

use crate::element::{Exact, MemberNumbers, OwnPart};
use crate::proof::ball::Ball;
use crate::proof::join::{Failure, Join};
use crate::proof::row::{Row, TERMS, difference, direction};
use crate::proof::visit::{MemberEnd, NodeNumbers};
use mstmm_plan::Freedoms;

/// Most nodes that are in the front at once.
const MOST_NODES: usize = 64;

/// A node whose variables are in the front.
#[derive(Clone, Copy, Debug)]
struct Present {
    index: usize,
    /// The variables of its displacements along x, or along its direction, and y, and of its rotation.
    variables: [Option<usize>; 3],
}

/// The nodes that are in the front.
#[derive(Debug)]
pub(crate) struct Nodes {
    present: [Present; MOST_NODES],
    count: usize,
    /// Forces of rigid joints, each with the node behind which it leaves.
    ties: [(usize, usize); MOST_NODES],
    tie_count: usize,
}

/// Displacements along and across a member and rotations of its ends: how many there are.
const LOCAL: usize = 3;

/// A displacement of an end: at most three variables of its node.
type EndRow<A> = Row<A, 3>;

/// Cosine and sine of a direction.
type Axis<A> = [Ball<A>; 2];

impl Nodes {
    /// No node.
    pub(crate) fn new() -> Self {
        let nobody = Present { index: 0, variables: [None; 3] };
        Nodes { present: [nobody; MOST_NODES], count: 0, ties: [(0, 0); MOST_NODES], tie_count: 0 }
    }

    /// The variables of a node, which enter with the first part that knows it.
    fn variables<J: Join>(&mut self, node: &NodeNumbers, joining: &mut J) -> [Option<usize>; 3] {
        if let Some(present) = self.present[..self.count].iter().find(|present| present.index == node.index) {
            return present.variables;
        }
        if self.count == MOST_NODES {
            joining.fail(Failure::Full);
            return [None; 3];
        }
        let mut enter = |is_there: bool| is_there.then(|| joining.enter());
        let variables = match node.along {
            Some(_) => [enter(true), None, enter(node.free.contains(Freedoms::RZ))],
            None => Freedoms::SINGLE.map(|freedom| enter(node.free.contains(freedom))),
        };
        // a node that does not move is eliminated by nobody
        if variables != [None; 3] {
            self.present[self.count] = Present { index: node.index, variables };
            self.count += 1;
        }
        variables
    }

    /// Displacements x and y and rotation of a place that is tied to a node.
    #[inline(never)]
    fn motion<J: Join>(&mut self, node: &NodeNumbers, place: [Exact; 2], joining: &mut J) -> [EndRow<J::Alone>; 3] {
        let [first, second, third] = self.variables(node, joining).map(|variable| variable.map(Row::<J::Alone, 1>::of));
        let mut rows = [Row::none(); 3];
        match node.along {
            Some(along) => {
                for (row, part) in rows.iter_mut().zip(along) {
                    first.iter().for_each(|own| row.add(own, Ball::of_pair(part)));
                }
            }
            None => {
                for (row, own) in rows.iter_mut().zip([first, second]) {
                    own.iter().for_each(|own| row.add(own, Ball::of(1.0)));
                }
            }
        }
        if let Some(rotation) = third {
            let [x, y] = [0, 1].map(|k| difference(node.place[k], place[k]));
            rows[0].add(&rotation, -y);
            rows[1].add(&rotation, x);
            rows[2].add(&rotation, Ball::of(1.0));
        }
        rows
    }

    /// Displacements along and across a member, given its axis, and rotation at one of its ends. An end may have an axis of its own. What it does
    /// not share with its node is a variable of its
    /// own, which leaves when the member has joined.
    #[inline(never)]
    fn local<J: Join>(
        &mut self,
        end: &MemberEnd,
        axis: Axis<J::Alone>,
        wanted: Freedoms,
        own: &mut Released,
        joining: &mut J,
    ) -> [EndRow<J::Alone>; LOCAL] {
        let [x, y, rotation] = self.motion(&end.node, end.place, joining);
        let turned = end.along.filter(|_| !wanted.is(Freedoms::RZ));
        let [c, s] = turned.map_or(axis, |along| direction(along.map(Ball::of_pair)).0);
        let mut rows = [Row::none(), Row::none(), rotation];
        rows[0].add(&x, c);
        rows[0].add(&y, s);
        rows[1].add(&x, -s);
        rows[1].add(&y, c);
        for (row, freedom) in rows.iter_mut().zip(Freedoms::SINGLE) {
            if end.released.contains(freedom) && wanted.contains(freedom) {
                let variable = joining.enter();
                own.list[own.count] = variable;
                own.count += 1;
                *row = Row::of(variable);
            }
        }
        rows
    }

    /// A member joins.
    #[inline(never)]
    pub(crate) fn member<J: Join>(
        &mut self,
        (numbers, own_part, freedoms): (&MemberNumbers, Option<OwnPart>, Freedoms),
        ends: &[MemberEnd; 2],
        next: usize,
        joining: &mut J,
    ) {
        let mut own = Released { list: [0; 2 * LOCAL], count: 0 };
        let wanted = if own_part.is_some() { freedoms } else { freedoms_of(numbers) };
        let has_axis = !wanted.is(Freedoms::RZ) && ends.iter().any(|end| end.along.is_none());
        let (axis, length) = if has_axis {
            let [from, to] = [ends[0].place, ends[1].place];
            direction([difference::<J::Alone>(from[0], to[0]), difference(from[1], to[1])])
        } else {
            ([Ball::of(1.0), Ball::of(0.0)], Ball::of(0.0))
        };
        let first = self.local(&ends[0], axis, wanted, &mut own, joining);
        let second = self.local(&ends[1], axis, wanted, &mut own, joining);
        let (numbers, damping) = numbers.parted();
        match &numbers {
            MemberNumbers::Other if own_part.is_some() => {
                let freedom = if freedoms.is(Freedoms::RZ) { 2 } else { 0 };
                self.own(own_part, [&first[freedom], &second[freedom]], last_of(ends, next), joining);
            }
            MemberNumbers::Beam(beam) => {
                if let Some(line) = beam.longitudinal() {
                    joining.add_line((&line, &damping), length, [first[0].terms(), second[0].terms()]);
                }
                let ends = [&first[1], &first[2], &second[1], &second[2]];
                joining.add_bending((beam, &damping), length, ends.map(|row| row.terms()));
            }
            MemberNumbers::Tapered(beam) => {
                let ends = [&first[1], &first[2], &second[1], &second[2]];
                joining.add_tapered(beam, length, ends.map(|row| row.terms()));
            }
            MemberNumbers::String(lines) => {
                for (line, freedom) in lines.iter().zip([0, 1]) {
                    let ends = [first[freedom].terms(), second[freedom].terms()];
                    joining.add_line((line, &damping), length, ends);
                }
            }
            MemberNumbers::Line(freedom, line) => {
                let ends = [first[*freedom].terms(), second[*freedom].terms()];
                joining.add_line((line, &damping), Ball::of_pair(line.length), ends);
            }
            MemberNumbers::Spring(freedom, stiffness) => {
                joining.add_spring((stiffness, &damping), [&first[*freedom], &second[*freedom]]);
            }
            MemberNumbers::Joint(rigid, elastic) => {
                for (index, (freedom, stiffness)) in Freedoms::SINGLE.into_iter().zip(elastic).enumerate() {
                    if *stiffness != [0.0; 2] {
                        joining.add_spring((stiffness, &damping), [&first[index], &second[index]]);
                    }
                    if rigid.contains(freedom) {
                        let gap = gap::<J>([&first[index], &second[index]], Ball::of(1.0));
                        self.tie(gap, last_of(ends, next), joining);
                    }
                }
            }
            _ => joining.fail(Failure::NotInNumbers),
        }
        own.list[..own.count].iter().for_each(|variable| joining.leave(*variable));
    }

    /// An element that is known by its stiffness at this frequency alone, over the displacements of its ends.
    fn own<J: Join>(&mut self, part: Option<OwnPart>, rows: [&EndRow<J::Alone>; 2], last: usize, joining: &mut J) {
        match part {
            Some(OwnPart::Stiffness { stiffness, held }) => {
                joining.add_counted(stiffness, held, rows.map(|row| row.terms()));
            }
            Some(OwnPart::Tie { ratio, stiffness }) => {
                self.tie(gap::<J>(rows, Ball::of_pair(ratio)), last, joining);
                joining.add_term(Ball::of_pair(stiffness), rows[0].terms());
            }
            None => {}
        }
    }

    /// A rigid joint: its force is a variable, which leaves with the last of its nodes.
    #[inline(never)]
    fn tie<J: Join>(&mut self, gap: Row<J::Alone, TERMS>, last: usize, joining: &mut J) {
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
        [mass, inertia]: [Exact; 2],
        centre: [Exact; 2],
        joining: &mut J,
    ) {
        let [x, y, rotation] = self.motion(node, centre, joining);
        for (parameter, row) in [(mass, &x), (mass, &y), (inertia, &rotation)] {
            joining.add_mass(parameter, row.terms());
        }
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
fn gap<J: Join>(rows: [&EndRow<J::Alone>; 2], ratio: Ball<J::Alone>) -> Row<J::Alone, TERMS> {
    let mut gap = rows[1].widened::<{ TERMS }>();
    gap.add(rows[0], -ratio);
    gap
}

/// Variables of a member's own.
struct Released {
    list: [usize; 2 * LOCAL],
    count: usize,
}

/// The node of a member that leaves last, given the one that leaves next; a node without displacements is not eliminated.
fn last_of(ends: &[MemberEnd; 2], next: usize) -> usize {
    let moves = |node: &NodeNumbers| node.along.is_some() || !node.free.is_empty();
    let other = ends.iter().map(|end| &end.node).find(|node| node.index != next && moves(node));
    other.map_or(next, |node| node.index)
}

/// The freedoms in which a member acts, in its own axes.
fn freedoms_of(numbers: &MemberNumbers) -> Freedoms {
    match &numbers.parted().0 {
        MemberNumbers::Beam(beam) if beam.axial_stiffness == [0.0; 2] => Freedoms::Y.union(Freedoms::RZ),
        MemberNumbers::Tapered(_) => Freedoms::Y.union(Freedoms::RZ),
        MemberNumbers::Beam(_) => Freedoms::ALL,
        MemberNumbers::String(_) => Freedoms::X.union(Freedoms::Y),
        MemberNumbers::Line(freedom, _) | MemberNumbers::Spring(freedom, _) => Freedoms::SINGLE[*freedom],
        MemberNumbers::Joint(rigid, elastic) => {
            let elastic = Freedoms::SINGLE.into_iter().zip(elastic).filter(|(_, stiffness)| **stiffness != [0.0; 2]);
            elastic.fold(*rigid, |sum, (freedom, _)| sum.union(freedom))
        }
        _ => Freedoms::ALL,
    }
}
