//! A network with its order of elimination.

use crate::element::MemberElement;
use crate::model::FrequencyEstimates;
use crate::number::{Parameter, Truth};
use crate::pass::characteristic::System;
use crate::pass::network::error::NetworkError;
use crate::pass::network::member::{BuiltMember, Member, Span, is_finite};
use crate::pass::network::node::{Motions, Node};
use mstmm_plan::{Elimination, Freedoms, Incidence, eliminated_in_order};

/// Memory for a network of up to `NODES` nodes and `MEMBERS` members: some 100 bytes per node, some 300 per member.
#[derive(Clone, Debug)]
pub struct NetworkRoom<E: MemberElement, const NODES: usize, const MEMBERS: usize> {
    members: [Option<BuiltMember<E>>; MEMBERS],
    motions: [Motions<E::Parameter>; NODES],
    pairs: [[usize; 2]; MEMBERS],
    ends: [[usize; 2]; MEMBERS],
    first_end: [usize; NODES],
    order: [usize; NODES],
    ranks: [usize; NODES],
    taken_up: [usize; NODES],
    elimination: [Elimination; NODES],
}

impl<E: MemberElement, const NODES: usize, const MEMBERS: usize> NetworkRoom<E, NODES, MEMBERS> {
    /// Memory without a network.
    #[allow(clippy::new_without_default, reason = "an array of any length has no default")]
    pub fn new() -> Self {
        NetworkRoom {
            members: [const { None }; MEMBERS],
            motions: [Motions::none(); NODES],
            pairs: [[0; 2]; MEMBERS],
            ends: [[0; 2]; MEMBERS],
            first_end: [0; NODES],
            order: [0; NODES],
            ranks: [0; NODES],
            taken_up: [0; NODES],
            elimination: [Elimination::UNKNOWN; NODES],
        }
    }
}

/// A plane structure of beams, springs and dampers between nodes, at any angle, with any number of closed loops.
///
/// Nodes are eliminated one after the other; the members that are cut by then are a front, of which `WIDTH` is the largest number of
/// variables. A search takes a stack of some `40 WIDTH²` bytes, in extended precision of four times as much.
///
/// ```
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{Member, Network, NetworkRoom, Node, Section, Support, UndampedMember};
///
/// // a portal frame: two legs and a girder, clamped feet
/// let nodes = [
///     Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
///     Node::at([0.0, 2.0]),
///     Node::at([2.0, 2.0]),
///     Node::at([2.0, 0.0]).held(Support::Fixed.holds()),
/// ];
/// let section = Section { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 };
/// let members = [[0, 1], [1, 2], [3, 2]].map(|[from, to]| Member::<UndampedMember<f64>>::new(from, to, section));
/// let mut room = NetworkRoom::<_, 4, 3>::new();
/// let portal = Network::<_, 16>::new(&nodes, &members, &mut room)?;
/// let found = portal.first_frequencies::<2>().unwrap();
/// assert!((found[0].omega - 178.832186592728532).abs() < 1e-12);
/// # Ok::<(), mstmm_core::NetworkError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Network<'a, E: MemberElement, const WIDTH: usize> {
    pub(super) nodes: &'a [Node<E::Parameter>],
    pub(super) members: &'a [Option<BuiltMember<E>>],
    pub(super) motions: &'a [Motions<E::Parameter>],
    pub(super) incidence: Incidence<'a>,
    /// The nodes in the order of elimination, and the place of each in it.
    pub(super) order: &'a [usize],
    pub(super) ranks: &'a [usize],
    /// How many fronts each node takes up.
    pub(super) taken_up: &'a [usize],
}

impl<'a, E: MemberElement, const WIDTH: usize> Network<'a, E, WIDTH> {
    /// Builds a network in memory of the caller's.
    ///
    /// # Errors
    /// [`NetworkError`] for what cannot be built, and for a room or a `WIDTH` that is too small.
    pub fn new<const NODES: usize, const MEMBERS: usize>(
        nodes: &'a [Node<E::Parameter>],
        members: &[Member<E>],
        room: &'a mut NetworkRoom<E, NODES, MEMBERS>,
    ) -> Result<Self, NetworkError> {
        if members.is_empty() {
            return Err(NetworkError::Empty);
        }
        let sizes = (nodes.len(), members.len());
        if sizes.0 > NODES || sizes.1 > MEMBERS {
            return Err(NetworkError::Room { nodes: sizes.0, members: sizes.1 });
        }
        for (index, node) in nodes.iter().enumerate() {
            check_node(index, node)?;
            room.motions[index] = Motions::of(node);
        }
        for (index, member) in members.iter().enumerate() {
            room.members[index] = Some(built(index, member, nodes, &room.motions)?);
            room.pairs[index] = [member.ends[0].node, member.ends[1].node];
        }
        let NetworkRoom { members: built, motions, pairs, ends, first_end, order, ranks, taken_up, elimination } = room;
        let (built, motions) = (&built[..sizes.1], &motions[..sizes.0]);
        let (pairs, ends) = (&pairs[..sizes.1], ends[..sizes.1].as_flattened_mut());
        let incidence = Incidence::new(pairs, &mut first_end[..sizes.0], ends);
        let (order, ranks) = (&mut order[..sizes.0], &mut ranks[..sizes.0]);
        let elimination = &mut elimination[..sizes.0];
        elimination.fill(Elimination::UNKNOWN);
        let count = eliminated_in_order(&incidence, elimination, order);
        ranks.fill(usize::MAX);
        for (rank, node) in order[..count].iter().enumerate() {
            ranks[*node] = rank;
            taken_up[*node] = Elimination::taken_up(elimination, *node);
        }
        if let Some(node) = ranks.iter().position(|rank| *rank == usize::MAX) {
            return Err(NetworkError::Apart { node });
        }
        let network = Network { nodes, members: built, motions, incidence, order, ranks, taken_up };
        match network.width() {
            needed if needed > WIDTH => Err(NetworkError::Width { needed }),
            _ => Ok(network),
        }
    }

    /// The members whose first node in the order is this one, and the rest of the ends at it.
    pub(super) fn is_first_at(&self, end: usize, node: usize) -> bool {
        let other = self.incidence.beyond(end);
        self.ranks[other] > self.ranks[node] || (other == node && end.is_multiple_of(2))
    }

    /// The motions of both nodes of a member.
    pub(super) fn motions_of(&self, member: usize) -> [&'a Motions<E::Parameter>; 2] {
        [0, 1].map(|end| &self.motions[self.incidence.node(2 * member + end)])
    }

    /// The number of freedoms of an end of a member.
    pub(super) fn freedoms(&self, end: usize) -> usize {
        self.members[end / 2].as_ref().map_or(0, |member| member.freedoms.count())
    }

    /// The largest number of variables at once, if all of them stay.
    fn width(&self) -> usize {
        let (mut count, mut widest) = (0, 0);
        for &node in self.order {
            let motions = self.motions[node].count;
            let here = self.incidence.ends(node).iter();
            let (mut entering, mut leaving) = (0, 0);
            for &end in here {
                if self.is_first_at(end, node) {
                    entering += 2 * self.freedoms(end);
                }
                leaving += self.freedoms(end);
            }
            widest = widest.max(count + entering + motions);
            count += entering;
            count -= leaving;
        }
        widest
    }
}

/// Checks the numbers of a node.
fn check_node<T: Parameter>(index: usize, node: &Node<T>) -> Result<(), NetworkError> {
    let fail = |problem| Err(NetworkError::InvalidNode { node: index, problem });
    let is_valid = |inertia: T| inertia.to_f64() >= 0.0 && inertia.to_f64().is_finite();
    if !is_finite(node.position) {
        return fail("its place is not finite");
    }
    if !(is_valid(node.mass) && is_valid(node.inertia) && is_finite(node.centre)) {
        return fail("mass and inertia must be zero or positive, and finite like the mass centre");
    }
    match node.along {
        Some(direction) if !is_direction(direction) => fail("its direction is zero or not finite"),
        Some(_) if node.held.contains(Freedoms::X) || node.held.contains(Freedoms::Y) => {
            fail("it moves along a direction, and x or y is held as well: hold rz at most")
        }
        _ => Ok(()),
    }
}

/// Whether a vector has a direction.
fn is_direction<T: Parameter>(vector: [T; 2]) -> bool {
    is_finite(vector) && vector.iter().any(|part| !part.vanishes().all())
}

/// Builds a member.
fn built<E: MemberElement>(
    index: usize,
    member: &Member<E>,
    nodes: &[Node<E::Parameter>],
    motions: &[Motions<E::Parameter>],
) -> Result<BuiltMember<E>, NetworkError> {
    let Member { ends, along, element } = *member;
    if let Some(end) = ends.iter().find(|end| end.node >= nodes.len()) {
        return Err(NetworkError::NoSuchNode { member: index, node: end.node });
    }
    let at_nodes = ends.map(|end| nodes[end.node].position);
    let places = [0, 1].map(|end| ends[end].position.unwrap_or(at_nodes[end]));
    let freedoms = element.freedoms();
    let acts_along = freedoms.is(Freedoms::X);
    if along.is_some_and(|direction| !acts_along || !is_direction(direction)) {
        return Err(NetworkError::Direction { member: index });
    }
    let span = Span::new(places, at_nodes, along, ends.map(|end| &motions[end.node]));
    let has_direction = span.length.to_f64() > 0.0 || along.is_some() || freedoms.is(Freedoms::RZ);
    if !has_direction {
        return Err(NetworkError::SamePlace { member: index, nodes: ends.map(|end| end.node) });
    }
    let built = element.build(span.length).map_err(|error| NetworkError::Parameter {
        member: index,
        element: element.name(),
        error,
    })?;
    Ok(BuiltMember { built, freedoms, released: ends.map(|end| end.released), places, nodes: at_nodes, along, span })
}

impl<E: MemberElement, const WIDTH: usize> System for Network<'_, E, WIDTH> {
    type Parameter = E::Parameter;

    const HAS_PHASES: bool = false;

    fn estimates(&self) -> FrequencyEstimates {
        let mut estimates = FrequencyEstimates::default();
        for member in self.members.iter().flatten() {
            E::estimate(&member.built, &mut estimates);
        }
        for node in self.nodes {
            estimates.mass(node.mass.to_f64());
            estimates.moment_of_inertia(node.inertia.to_f64());
            let offset = [0, 1].map(|k| (node.centre[k] - node.position[k]).to_f64());
            offset.into_iter().for_each(|lever| estimates.lever(lever));
        }
        estimates.finish();
        estimates
    }
}
