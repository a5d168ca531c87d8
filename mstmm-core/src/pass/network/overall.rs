//! The overall transfer equation of a network: one unknown after the other along the paths from the tips to the root.

use crate::element::MemberTransfer;
use crate::model::Skew;
use crate::number::{Frequency, Scaled, Single};
use crate::pass::network::frame::Frame;
use crate::pass::network::path_state::{PathState, numbers};
use crate::pass::network::placed::{PerMember, PerNode, Placed, together};
use crate::pass::network::vector::{DISPLACEMENTS, Six, unit, with_axes_across};
use crate::pass::overall::determinant::determinant;
use crate::structure::MOST_MOTIONS;
use core::mem::replace;
use mstmm_plan::{Freedoms, PathNode};
use nalgebra::SMatrix;

/// A network whose members have transfer matrices at a frequency.
pub trait PlacedTransfers<S: Frequency<Self::Parameter>>: Placed {
    /// The transfer matrix of a member, or of a part of one.
    fn transfer(&self, member: usize, x: S) -> Option<MemberTransfer<S>>;
}

/// The overall matrix of a network, given its paths; `N` is the number of their unknowns.
///
/// Rows are the main transfer equation, forces at the root and then displacements, where a member brings them there; forces that are zero
/// where paths leave freedoms behind; geometrical equations. Columns are the states at cuts, by members, and the unknowns of tips from the
/// leaves on, those of the root last.
pub fn overall_matrix<const N: usize, Y, S>(network: &Y, paths: &[PathNode], x: S) -> SMatrix<S, N, N>
where
    Y: PlacedTransfers<S>,
    S: Frequency<Y::Parameter> + Single,
{
    let mut links = network.per_member(Link::none());
    for member in 0..network.sizes()[1] {
        let parts = network.parts_from(member);
        if let Some(link) = links.as_mut().get_mut(member).filter(|_| !parts.is_empty()) {
            *link = Link::new(network, paths, member);
        }
        let is_reversed = links.as_ref().get(member).is_some_and(|link| link.is_reversed);
        for (part, link) in links.as_mut().iter_mut().enumerate().take(parts.end).skip(parts.start) {
            let transfer = network.transfer(part, x).unwrap_or(MemberTransfer::none());
            link.part = network.placement(part).part();
            link.transfer = if is_reversed { transfer.reversed() } else { transfer };
        }
    }
    let mut order = network.per_node(0);
    for (node, path) in paths.iter().enumerate() {
        if let Some(place) = order.as_mut().get_mut(path.rank) {
            *place = node;
        }
    }
    let mut columns = [[S::zero(); N]; N];
    for (unknown, rows) in columns.iter_mut().enumerate() {
        let column = Column {
            network,
            paths,
            links: &links.as_ref()[..network.sizes()[1]],
            nodes: network.per_node(PathState::zero()),
            ends: network.per_member([[S::zero(); MOST_MOTIONS]; 2]),
            lambda_squared: x.lambda_squared(),
            unknown,
            next_unknown: 0,
            rows,
            next_row: 0,
        };
        column.fill(&order.as_ref()[..paths.len()]);
    }
    SMatrix::from(columns)
}

/// The determinant of the overall matrix of a network, times what removes the poles of its members.
pub fn overall_determinant<const N: usize, Y, S>(network: &Y, paths: &[PathNode], x: S) -> Scaled<S>
where
    Y: PlacedTransfers<S>,
    S: Frequency<Y::Parameter> + Single,
{
    let members = (0..network.sizes()[1]).filter_map(|member| network.transfer(member, x)?.denominator);
    members.fold(determinant(overall_matrix::<N, Y, S>(network, paths, x)), Scaled::times)
}

/// A member on its path, with its first part, or a further part of one.
#[derive(Clone, Copy, Debug)]
struct Link<S> {
    nodes: [usize; 2],
    /// The freedoms of the member in its axes, and those that its ends do not share with their nodes.
    freedoms: Freedoms,
    released: [Freedoms; 2],
    frames: [Frame<S>; 2],
    /// The first of its parts, and the one behind its last.
    parts: [usize; 2],
    /// Whether a path goes from its output to its input.
    is_reversed: bool,
    is_cut: bool,
    /// Which part this one is.
    part: usize,
    /// Of the part: from the end by which a path leaves its node, or from the cut at its input.
    transfer: MemberTransfer<S>,
}

impl<S: Single> Link<S> {
    fn none() -> Self {
        Link {
            nodes: [0; 2],
            freedoms: Freedoms::NONE,
            released: [Freedoms::NONE; 2],
            frames: [Frame::of_node(); 2],
            parts: [0; 2],
            is_reversed: false,
            is_cut: false,
            part: 0,
            transfer: MemberTransfer::none(),
        }
    }

    /// The member that begins with a part.
    fn new<Y: PlacedTransfers<S>>(network: &Y, paths: &[PathNode], member: usize) -> Self
    where
        S: Frequency<Y::Parameter>,
    {
        let placement = network.placement(member);
        let nodes = [0, 1].map(|end| placement.node_of(end));
        let [leaves, is_reversed] = [0, 1].map(|end| paths[nodes[end]].leaves_by(2 * member + end));
        let parts = network.parts_from(member);
        Link {
            nodes,
            freedoms: together(network, parts.clone(), |part| part.freedoms),
            released: [0, 1].map(|end| together(network, parts.clone(), |part| part.released_freedoms(end))),
            frames: [0, 1].map(|end| Frame::of(placement, end)),
            is_reversed,
            is_cut: !leaves && !is_reversed,
            parts: [parts.start, parts.end],
            ..Link::none()
        }
    }
}

/// What one unknown causes: the states on all paths, and its column of the matrix.
struct Column<'a, Y: Placed, S: Single> {
    network: &'a Y,
    paths: &'a [PathNode],
    links: &'a [Link<S>],
    nodes: PerNode<Y, PathState<S>>,
    /// The displacements of the ends that arrive at nodes, in their own axes.
    ends: PerMember<Y, [Six<S>; 2]>,
    lambda_squared: S,
    unknown: usize,
    next_unknown: usize,
    rows: &'a mut [S],
    next_row: usize,
}

impl<Y, S> Column<'_, Y, S>
where
    Y: PlacedTransfers<S>,
    S: Frequency<Y::Parameter> + Single,
{
    /// The next unknown: one if it is that of the column.
    fn unknown(&mut self) -> S {
        let is_own = self.next_unknown == self.unknown;
        self.next_unknown += 1;
        if is_own { S::one() } else { S::zero() }
    }

    /// The next entry of the column.
    fn entry(&mut self, entry: S) {
        if let Some(row) = self.rows.get_mut(self.next_row) {
            *row = entry;
        }
        self.next_row += 1;
    }

    /// Goes along all paths, given the nodes from the root on.
    fn fill(mut self, order: &[usize]) {
        if let Some(&root) = order.first() {
            let root = self.paths[root];
            self.next_row = root.freedoms.count() * if root.is_led() { 2 } else { 1 };
        }
        let links = self.links;
        for (member, link) in links.iter().enumerate().filter(|(_, link)| link.is_cut) {
            let mut state = PathState::zero();
            for k in numbers(link.freedoms) {
                state.displacements[k] = self.unknown();
            }
            for k in numbers(link.freedoms) {
                state.forces[k] = self.unknown();
            }
            self.arrive(2 * member, state.opposite());
            self.arrive(2 * member + 1, self.through(link, state));
        }
        for &node in order.iter().rev() {
            self.node(node);
        }
        for end in 0..2 * links.len() {
            self.compare(end);
        }
    }

    /// Takes the paths that have arrived at a node on, with those of its support or its tip.
    fn node(&mut self, node: usize) {
        let path = self.paths[node];
        let mut state = self.nodes.as_ref()[node].of_freedoms(path.freedoms);
        let mut tip = PathState::zero();
        if path.is_boundary() {
            tip = self.tip(node);
            if !path.is_led() {
                state.displacements = tip.displacements;
            }
        }
        self.nodes.as_mut()[node].displacements = state.displacements;
        let momentum = self.network.node(node).0.momentum(state.displacements);
        for (force, momentum) in state.forces.iter_mut().zip(momentum) {
            *force -= self.lambda_squared * momentum;
        }
        let Some(end) = path.leaving() else { return self.root(path, state, tip) };
        for k in numbers(path.freedoms) {
            if path.is_boundary() && path.is_led() {
                self.entry(tip.displacements[k] - state.displacements[k]);
            }
            state.forces[k] += tip.forces[k];
        }
        self.leave(end, path, state);
    }

    /// The unknowns of the support of a node, of the root those of the state there.
    fn tip(&mut self, node: usize) -> PathState<S> {
        let path = self.paths[node];
        let (support, _) = self.network.node(node);
        let mut tip = PathState::zero();
        let mut in_axes = path.freedoms;
        if let Some(skew) = support.skew {
            self.skew_tip(skew, path.freedoms.intersection(Freedoms::DISPLACEMENTS), &mut tip);
            in_axes = in_axes.intersection(Freedoms::ROTATIONS);
        }
        for k in numbers(in_axes.without(support.held)) {
            tip.displacements[k] = self.unknown();
        }
        for k in numbers(in_axes.intersection(support.held)) {
            tip.forces[k] = self.unknown();
        }
        tip
    }

    /// The unknowns of a support that holds along a direction or across it, given the displacements of its node: those that are free, and the forces
    /// of the others.
    fn skew_tip(&mut self, skew: Skew<Y::Parameter>, all: Freedoms, tip: &mut PathState<S>) {
        let (vector, is_held) = match skew {
            Skew::Along(vector) => (vector, false),
            Skew::Normal(vector) => (vector, true),
        };
        let axes = with_axes_across(unit(vector.map(S::from_parameter)), vector);
        for (place, axis) in axes.into_iter().enumerate().take(all.count()) {
            let unknown = self.unknown();
            let moves = (place == 0) != is_held;
            let state = if moves { &mut tip.displacements } else { &mut tip.forces };
            for (part, place) in axis.into_iter().zip(DISPLACEMENTS) {
                state[place] += part * unknown;
            }
        }
    }

    /// Ends all paths at the root, in the first rows: the state there less its own unknowns.
    fn root(&mut self, path: PathNode, state: PathState<S>, own: PathState<S>) {
        let next_row = replace(&mut self.next_row, 0);
        for k in numbers(path.freedoms) {
            self.entry(state.forces[k] - own.forces[k]);
        }
        for k in numbers(path.freedoms).filter(|_| path.is_led()) {
            self.entry(state.displacements[k] - own.displacements[k]);
        }
        self.next_row = next_row;
    }

    /// Takes a state from a node into the end of a member. Forces that the member does not carry are zero.
    fn leave(&mut self, end: usize, path: PathNode, state: PathState<S>) {
        let (links, place) = (self.links, end / 2);
        let link = &links[place];
        let mut state = link.frames[end % 2].at_end(state);
        for k in numbers(path.left_behind(link.freedoms)) {
            self.entry(state.forces[k]);
        }
        state = state.of_freedoms(link.freedoms);
        self.release(end, &mut state);
        self.arrive(end ^ 1, self.through(link, state));
    }

    /// The state behind a member: each part takes on what it has of it.
    fn through(&self, link: &Link<S>, state: PathState<S>) -> PathState<S> {
        let mut behind = PathState::zero();
        for part in self.links.get(link.parts[0]..link.parts[1]).unwrap_or_default() {
            behind.set_part(part.part, part.transfer.of(state.of_part(part.part)));
        }
        behind
    }

    /// Lets the displacements that an end does not share jump; their forces are zero.
    fn release(&mut self, end: usize, state: &mut PathState<S>) {
        for k in numbers(self.links[end / 2].released[end % 2]) {
            let force = replace(&mut state.forces[k], S::zero());
            self.entry(force);
            state.displacements[k] += self.unknown();
        }
    }

    /// Adds the forces of an end to those of its node, and gives that its displacements, if it has them from here.
    fn arrive(&mut self, end: usize, mut state: PathState<S>) {
        self.release(end, &mut state);
        let link = &self.links[end / 2];
        self.ends.as_mut()[end / 2][end % 2] = state.displacements;
        let (state, node) = (link.frames[end % 2].at_node(state), link.nodes[end % 2]);
        let at_node = &mut self.nodes.as_mut()[node];
        if self.paths[node].is_led_by(end) {
            at_node.displacements = state.displacements;
        }
        for (sum, force) in at_node.forces.iter_mut().zip(state.forces) {
            *sum += force;
        }
    }

    /// The geometrical equations of an end that arrives: its displacements are those of its node.
    fn compare(&mut self, end: usize) {
        let link = &self.links[end / 2];
        let node = link.nodes[end % 2];
        let path = self.paths[node];
        if path.leaves_by(end) || path.is_led_by(end) {
            return;
        }
        let own = self.ends.as_ref()[end / 2][end % 2];
        let of_node = link.frames[end % 2].at_end(self.nodes.as_ref()[node]);
        for k in numbers(link.freedoms) {
            self.entry(own[k] - of_node.displacements[k]);
        }
    }
}
