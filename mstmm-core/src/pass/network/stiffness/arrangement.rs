//! Where variables stand in the front, found before any frequency is known: each displacement of a node has a place from the first member that
//! joins there until the node leaves, and then others have it.

use crate::pass::network::stiffness::group::{Group, MOST, Set, members_of};
use crate::pass::network::stiffness::member::StiffnessMember;
use crate::pass::network::stiffness::node::StiffnessNode;
use crate::pass::network::stiffness::numbers::Waving;
use mstmm_plan::NetworkOrder;

/// Beams of which the waves are kept, since structures have many equal ones.
pub(super) const KEPT: usize = 4;

/// The variables that are in the front at a time.
struct Front {
    taken: Set,
    /// To which others each is coupled.
    beside: [Set; MOST],
    width: usize,
}

impl Front {
    /// Takes the first places for variables that stand next to each other; none where the front is full.
    fn take(&mut self, count: usize) -> Option<Group> {
        let first = (0..=MOST - count).find(|&first| self.taken & Group::new(first, count).own() == 0)?;
        let group = Group::new(first, count);
        self.taken |= group.own();
        self.width = self.width.max(first + count);
        Some(group)
    }

    /// Couples variables to each other.
    fn couple(&mut self, set: Set) {
        members_of(set).for_each(|variable| self.beside[variable] |= set);
    }

    /// Lets a group leave: what it was coupled to is coupled then.
    fn leave(&mut self, group: &mut Group) {
        let own = group.own();
        group.beside =
            members_of(own).fold(0, |set, variable| set | core::mem::take(&mut self.beside[variable])) & !own;
        self.couple(group.beside);
        members_of(group.beside).for_each(|variable| self.beside[variable] &= !own);
        self.taken &= !own;
    }
}

/// Finds the places of all variables, and the order in which members join and forces of rigid joints part. Returns the width of the front, unless
/// a member is not known in numbers or the front has no room.
pub(super) fn arrange(
    order: &NetworkOrder<'_>,
    nodes: &mut [StiffnessNode],
    members: &mut [StiffnessMember],
    [joining, parting]: [&mut [u32]; 2],
) -> Option<usize> {
    let mut front = Front { taken: 0, beside: [0; MOST], width: 0 };
    let (mut joined, mut parted) = (0, 0);
    for &node in order.nodes {
        let ends = order.incidence.ends(node);
        for &end in ends.iter().filter(|&&end| order.is_first_at(end, node)) {
            let member = end / 2;
            join(&mut front, nodes, &mut members[member], [0, 1].map(|end| order.incidence.node(2 * member + end)))?;
            joining[joined] = member as u32;
            joined += 1;
        }
        front.leave(&mut nodes[node].group);
        for &end in ends {
            let member = end / 2;
            // a member with both ends here has them in the list twice
            let beyond = order.incidence.beyond(end);
            let is_last = if beyond == node { end % 2 == 0 } else { !order.is_first_at(end, node) };
            if is_last && members[member].tie_count() > 0 {
                front.leave(&mut members[member].seat.ties);
                parting[parted] = member as u32;
                parted += 1;
            }
        }
        (nodes[node].joined, nodes[node].parted) = (joined as u32, parted as u32);
    }
    keep_waves(&joining[..joined], members);
    Some(front.width)
}

/// Lets a member join: its nodes and the forces of a rigid joint enter the front, unless they are there, and are coupled.
fn join(front: &mut Front, nodes: &mut [StiffnessNode], member: &mut StiffnessMember, at: [usize; 2]) -> Option<()> {
    if member.waving == Waving::Other {
        return None;
    }
    for node in at {
        if nodes[node].group == Group::NONE {
            nodes[node].group = front.take(nodes[node].motions)?;
        }
    }
    member.seat.ties = front.take(member.tie_count())?;
    member.seat.nodes = at.map(|node| nodes[node].group);
    front.couple(member.seat.nodes.iter().fold(member.seat.ties.own(), |set, group| set | group.own()));
    Some(())
}

/// Gives each beam the place of the waves of an equal one before, or one of its own, where the first of the beams that are kept was.
fn keep_waves(joining: &[u32], members: &mut [StiffnessMember]) {
    let (mut kept, mut next) = ([Waving::Other; KEPT], 0);
    for &member in joining {
        let member = &mut members[member as usize];
        let place = kept.iter().position(|kept| *kept == member.waving);
        member.seat.is_first = place.is_none();
        member.seat.waves = place.unwrap_or(next) as u8;
        if let (None, Waving::Beam(..)) = (place, &member.waving) {
            kept[next] = member.waving;
            next = (next + 1) % KEPT;
        }
    }
}
