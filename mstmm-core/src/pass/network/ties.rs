//! Rigid joints by rows: what such a joint ties is one motion of both nodes, and its forces follow from the equilibrium of one of them.
//!
//! A node hangs on another one by a joint if all that the joint ties are motions of both nodes alone, as where a pin joins a beam to a point.
//! Nodes that hang on others form trees. What hangs on a node at rest rests in what the joint ties.

use crate::element::MemberNumbers;
use crate::model::EndMotion;
use crate::number::{Frequency, FrequencyPowers, Real, Scalar};
use crate::pass::network::loading::Loading;
use crate::pass::network::motions::{Motions, NONE, Shared};
use crate::pass::network::placed::Placed;
use crate::pass::network::placement::Placement;
use crate::pass::network::vector::Six;
use crate::structure::{MOST_MOTIONS, MemberStiffness};
use mstmm_plan::Freedoms;

/// Finds the joints by which nodes hang on others.
pub(super) fn tie<T: Real>(motions: &mut [Motions<T>], placements: &mut [Placement<T>], numbers: &[MemberNumbers]) {
    for (member, numbers) in numbers.iter().enumerate().take(placements.len()) {
        let MemberNumbers::Joint(rigid, _) = numbers else { continue };
        if rigid.contains(placements[member].freedoms) && !placements[member].is_tie {
            let nodes = [0, 1].map(|end| placements[member].node_of(end));
            let leaf = [1, 0].into_iter().find(|end| may_hang(motions, placements, [nodes[*end], nodes[1 - *end]]));
            let Some(leaf) = leaf else { continue };
            placements[member].is_tie = hang(motions, &placements[member], member, leaf);
        }
    }
    for node in 0..motions.len() {
        for motion in 0..motions[node].count {
            motions[node].shared[motion] = owner(motions, node, motion);
        }
    }
}

/// Whether a node that hangs on none can hang on another one, which does not hang on it.
fn may_hang<T: Real>(motions: &[Motions<T>], placements: &[Placement<T>], [leaf, mut root]: [usize; 2]) -> bool {
    if motions[leaf].count == 0 || motions[leaf].hangs_by != NONE {
        return false;
    }
    while root != leaf && motions[root].hangs_by != NONE {
        let nodes = [0, 1].map(|end| placements[motions[root].hangs_by as usize].node_of(end));
        root = if nodes[0] == root { nodes[1] } else { nodes[0] };
    }
    root != leaf
}

/// Lets the node of an end hang on that of the other one, if what the joint ties are motions of both. Returns whether it does.
fn hang<T: Real>(motions: &mut [Motions<T>], placement: &Placement<T>, member: usize, leaf: usize) -> bool {
    let [own, other] = [leaf, 1 - leaf].map(|end| placement.node_of(end));
    let Some(shared) = shares(placement, leaf, motions[other].count == 0, other) else { return false };
    (motions[own].shared, motions[own].hangs_by) = (shared, member as u32);
    true
}

/// What each motion of the node of an end is, if what the joint ties are motions of both nodes alone.
pub(super) fn shares<T: Real>(
    placement: &Placement<T>,
    leaf: usize,
    rests: bool,
    other: usize,
) -> Option<[Shared; MOST_MOTIONS]> {
    let rows = placement.rows();
    let mut shared = [Shared::Own; MOST_MOTIONS];
    for (freedom, _) in each_of(placement.freedoms) {
        let (motion, coefficient) = single(&rows[leaf][freedom])?;
        shared[motion] = if rests {
            Shared::AtRest
        } else {
            match single(&rows[1 - leaf][freedom]) {
                Some((with, same)) if same == coefficient => Shared::With { node: other as u32, motion: with as u8 },
                _ => return None,
            }
        };
    }
    Some(shared)
}

/// The freedoms of a set, with their indices.
fn each_of(freedoms: Freedoms) -> impl Iterator<Item = (usize, Freedoms)> {
    Freedoms::SINGLE.into_iter().enumerate().filter(move |(_, kind)| freedoms.contains(*kind))
}

/// The one motion of a row, with its coefficient, if that is 1 or -1.
fn single<T: Real>(row: &Six<T>) -> Option<(usize, T)> {
    let mut parts = row.iter().enumerate().filter(|(_, part)| !part.vanishes());
    let (motion, part) = parts.next()?;
    (parts.next().is_none() && part.abs() == T::one()).then_some((motion, *part))
}

/// The motion that a motion of a node is.
fn owner<T: Real>(motions: &[Motions<T>], node: usize, motion: usize) -> Shared {
    let mut last = motions[node].shared[motion];
    while let Shared::With { node, motion } = last {
        match motions[node as usize].shared[motion as usize] {
            Shared::Own => break,
            next => last = next,
        }
    }
    last
}

/// What is known of a network under a load: its members, and the values of the motions of its nodes.
pub(super) struct Solved<'a, S: Scalar> {
    pub(super) stiffnesses: &'a [MemberStiffness<S>],
    pub(super) loading: &'a Loading<'a, S>,
    pub(super) at: &'a FrequencyPowers<S>,
}

/// The joint by which a node hangs on another one: its member, which of its ends is the node, and the other node.
#[derive(Clone, Copy)]
pub(super) struct Tie {
    pub(super) member: usize,
    pub(super) leaf: usize,
    pub(super) root: usize,
}

/// The joint by which a node hangs, if it hangs on another one.
fn tie_of<Y: Placed>(network: &Y, node: usize) -> Option<Tie> {
    let tie = network.node(node).1.hangs_by;
    (tie != NONE).then(|| {
        let placement = network.placement(tie as usize);
        let leaf = usize::from(placement.node_of(1) == node);
        Tie { member: tie as usize, leaf, root: placement.node_of(1 - leaf) }
    })
}

/// Goes to all nodes with the joints by which they hang. A node follows all nodes that hang on it.
pub(super) fn from_leaves<Y: Placed>(network: &Y, mut each: impl FnMut(usize, Option<Tie>)) {
    let count = network.sizes()[0];
    // how many hang on each node
    let mut waiting = network.per_node(0);
    let waiting = waiting.as_mut();
    for node in 0..count {
        if let Some(tie) = tie_of(network, node) {
            waiting[tie.root] += 1;
        }
    }
    for first in 0..count {
        let mut node = first;
        // each node is left but once: it hangs on none then
        while waiting[node] == 0 {
            waiting[node] = NONE;
            let tie = tie_of(network, node);
            each(node, tie);
            let Some(Tie { root, .. }) = tie else { break };
            waiting[root] -= 1;
            node = root;
        }
    }
}

/// Finds the motions of the joints by which nodes hang on others, given the motions of all other members.
///
/// `values` has the values of the motions of each node.
pub(super) fn joints<Y, S>(
    network: &Y,
    solved: &Solved<'_, S>,
    values: impl Fn(usize) -> Six<S>,
    members: &mut [[EndMotion<S>; 2]],
) where
    Y: Placed,
    S: Frequency<Y::Parameter>,
{
    if (0..network.sizes()[0]).all(|node| network.node(node).1.hangs_by == NONE) {
        return;
    }
    from_leaves(network, |node, tie| {
        if let Some(Tie { member, leaf, .. }) = tie {
            members[member] = of_joint(network, solved, (node, &values(node)), (member, leaf), members);
        }
    });
}

/// The motion of a joint by which a node hangs on another one.
fn of_joint<Y, S>(
    network: &Y,
    Solved { stiffnesses, loading, at }: &Solved<'_, S>,
    (node, values): (usize, &Six<S>),
    (tie, leaf): (usize, usize),
    members: &[[EndMotion<S>; 2]],
) -> [EndMotion<S>; 2]
where
    Y: Placed,
    S: Frequency<Y::Parameter>,
{
    let (body, motions) = network.node(node);
    let order = network.order();
    // what the joint has to take of the load on each motion
    let mut rest = loading.on_node(network, node, at);
    if let Some(body) = motions.body(body, at.lambda_squared) {
        for (rest, row) in rest.iter_mut().zip(body) {
            for (entry, value) in row.into_iter().zip(values) {
                *rest -= entry * *value;
            }
        }
    }
    for &end in order.incidence.ends(node) {
        let [member, end] = [end / 2, end % 2];
        let placement = network.placement(member);
        if member == tie || placement.rests(end) {
            continue;
        }
        let own = placement.rows()[end].map(|row| row.map(S::from_parameter));
        let rows = if placement.is_tie { &own } else { &stiffnesses[member].rows[end] };
        // where a member has no freedom it has no axis either
        for (freedom, _) in each_of(placement.freedoms) {
            let force = members[member][end].forces[freedom];
            for (rest, part) in rest.iter_mut().zip(rows[freedom]).filter(|(_, part)| !part.is_constant_zero()) {
                *rest -= force.times_real(part);
            }
        }
    }
    let placement = network.placement(tie);
    let rows = placement.rows();
    let mut ends = [EndMotion::at_rest(); 2];
    for (freedom, _) in each_of(placement.freedoms) {
        if let Some((motion, coefficient)) = single(&rows[leaf][freedom]) {
            let [force, displacement] = [rest[motion] * coefficient, values[motion] * coefficient];
            ends.iter_mut().for_each(|end| end.displacements[freedom] = displacement);
            (ends[leaf].forces[freedom], ends[1 - leaf].forces[freedom]) = (force, -force);
        }
    }
    ends
}
