//! A network with its order of elimination.

use crate::element::{
    MemberChart, MemberElement, MemberMatrix, MemberNumbers, MemberTransfer, MemberVisit, VisitMember,
};
use crate::model::{FrequencyEstimates, Spot, is_size_of_direction};
use crate::number::{Frequency, FrequencyPowers, InLanes, Parameter, Scaled, Single};
use crate::pass::characteristic::{Characteristic, System};
use crate::pass::network::error::NetworkError;
use crate::pass::network::evaluate::{in_factor, network_pass};
use crate::pass::network::member::{End, Member, Placement, is_finite};
use crate::pass::network::node::{Motions, Node};
use crate::pass::network::overall::PlacedTransfers;
use crate::pass::network::placed::{Placed, PlacedCharts, PlacedMotions};
use crate::pass::network::stiffness::{StiffnessModel, StiffnessRoom};
use crate::pass::network::visit::visit_network;
use crate::pass::searched::{ComplexPasses, RealPasses, Spectrum, Undamped};
use crate::proof::visit::Visitor;
use crate::structure::Chart;
use crate::structure::{Factor, StructureScalar};
use crate::subspace::RootCounter;
use core::array;
use core::fmt::Debug;
use mstmm_plan::{Freedoms, NetworkOrder, OrderRoom};

/// The points of networks, by their indices.
#[derive(Clone, Copy, Debug)]
pub enum InNetwork {}

/// Memory for a network of up to `NODES` nodes and `MEMBERS` members: some 200 bytes per node, some 720 per member.
#[derive(Clone, Debug)]
pub struct NetworkRoom<E: MemberElement, const NODES: usize, const MEMBERS: usize> {
    members: [Option<E::Built>; MEMBERS],
    kinds: [&'static str; MEMBERS],
    placements: [Placement<E::Parameter>; MEMBERS],
    motions: [Motions<E::Parameter>; NODES],
    stiffness: StiffnessRoom<NODES, MEMBERS>,
    order: OrderRoom<NODES, MEMBERS>,
}

impl<E: MemberElement, const NODES: usize, const MEMBERS: usize> NetworkRoom<E, NODES, MEMBERS> {
    /// Memory without a network.
    #[allow(clippy::new_without_default, reason = "an array of any length has no default")]
    pub fn new() -> Self {
        NetworkRoom {
            members: [const { None }; MEMBERS],
            kinds: [""; MEMBERS],
            placements: [Placement::nowhere(); MEMBERS],
            motions: [Motions::none(); NODES],
            stiffness: StiffnessRoom::new(),
            order: OrderRoom::EMPTY,
        }
    }
}

/// A plane structure of beams, springs and dampers between nodes, at any angle, with any number of closed loops.
///
/// Nodes are eliminated one after the other; `WIDTH` is the largest number of unknowns at once, the motions of nodes and what members have
/// of their own. An evaluation takes a stack of `2 WIDTH²` numbers and some 100 bytes per unknown: 8 bytes a number of `f64`, 16 with
/// its slope, and each twice as much in extended precision, where the search of a doubtful result has 32. Searches for natural frequencies take
/// up to 60 kB more. A motion takes `WIDTH²` numbers more for each of `NODES` nodes. With `std` memory of more than 64 kB is taken from the heap.
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
/// let portal = Network::<_, 16, _, _>::new(&nodes, &members, &mut room)?;
/// let found = portal.first_frequencies::<2>().unwrap();
/// assert!((found[0].omega - 178.832186592728532).abs() < 1e-12);
/// # Ok::<(), mstmm_core::NetworkError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Network<'a, E: MemberElement, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> {
    pub(super) nodes: &'a [Node<E::Parameter>],
    motions: &'a [Motions<E::Parameter>],
    members: &'a [Option<E::Built>],
    /// What each member is.
    pub(super) kinds: &'a [&'static str],
    placements: &'a [Placement<E::Parameter>],
    /// Nodes and members in numbers, for searches at many frequencies at once.
    stiffness: Option<StiffnessModel<'a>>,
    /// The members in numbers.
    numbers: &'a [MemberNumbers],
    order: NetworkOrder<'a>,
}

impl<'a, E: MemberElement, const WIDTH: usize, const NODES: usize, const MEMBERS: usize>
    Network<'a, E, WIDTH, NODES, MEMBERS>
{
    /// Builds a network in memory of the caller's.
    ///
    /// # Errors
    /// [`NetworkError`] for what cannot be built, and for a room or a `WIDTH` that is too small.
    pub fn new(
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
            room.stiffness.set_node(index, node, &room.motions[index]);
        }
        for (index, member) in members.iter().enumerate() {
            let (built, placement) = built(index, member, nodes, &room.motions)?;
            room.stiffness.set_member(index, E::member_numbers(&built), &placement);
            (room.members[index], room.placements[index]) = (Some(built), placement);
            room.kinds[index] = member.element.name();
        }
        let pairs = members.iter().map(|member| [member.ends[0].node, member.ends[1].node]);
        let motions = &room.motions;
        if let Some(node) = room.order.fill(sizes.0, |node| motions[node].count == 0, pairs) {
            return Err(NetworkError::Apart { node });
        }
        let NetworkRoom { members: built, kinds, placements, motions, stiffness, order } = room;
        let order = order.order(sizes.0, sizes.1);
        stiffness.arrange(&order);
        let network = Network {
            nodes,
            motions: &motions[..sizes.0],
            members: &built[..sizes.1],
            kinds: &kinds[..sizes.1],
            placements: &placements[..sizes.1],
            stiffness: stiffness.model(&order),
            numbers: stiffness.numbers(),
            order,
        };
        let motions: [usize; NODES] =
            array::from_fn(|node| network.motions.get(node).map_or(0, |of_node| of_node.count));
        let freedoms: [usize; MEMBERS] =
            array::from_fn(|member| network.placements.get(member).map_or(0, |placement| placement.freedoms.count()));
        match network.order.width(&motions, &freedoms) {
            needed if needed > WIDTH => Err(NetworkError::Width { needed }),
            _ => Ok(network),
        }
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
        Some(direction) if !is_direction(direction) => fail("its direction is zero, not finite or beyond 1e±70"),
        Some(_) if node.held.contains(Freedoms::X) || node.held.contains(Freedoms::Y) => {
            fail("it moves along a direction, and x or y is held as well: hold rz at most")
        }
        _ => Ok(()),
    }
}

/// Whether a vector has a direction.
fn is_direction<T: Parameter>(vector: [T; 2]) -> bool {
    let size = vector.iter().map(|part| part.to_f64().abs()).fold(0.0, f64::max);
    is_finite(vector) && is_size_of_direction(size)
}

/// Builds a member.
fn built<E: MemberElement>(
    index: usize,
    member: &Member<E>,
    nodes: &[Node<E::Parameter>],
    motions: &[Motions<E::Parameter>],
) -> Result<(E::Built, Placement<E::Parameter>), NetworkError> {
    let Member { mut ends, element } = *member;
    if let Some(end) = ends.iter().find(|end| end.node >= nodes.len()) {
        return Err(NetworkError::NoSuchNode { member: index, node: end.node });
    }
    let freedoms = element.freedoms();
    let acts_along = freedoms.is(Freedoms::X) || element.is_joint();
    let mut directions = ends.iter().filter_map(|end| end.along);
    if directions.any(|direction| !acts_along || !is_direction(direction)) {
        return Err(NetworkError::Direction { member: index });
    }
    if element.is_joint() {
        ends = ends.map(End::in_axes);
    }
    let [from, to] = &ends;
    let placement = Placement::new(
        freedoms,
        [from, to],
        [&nodes[from.node], &nodes[to.node]],
        [&motions[from.node], &motions[to.node]],
    );
    let length = placement.own_length();
    if element.is_joint() && length.to_f64() > 0.0 {
        return Err(NetworkError::TwoPlaces { member: index, nodes: [from.node, to.node] });
    }
    let have_directions = ends.iter().all(|end| end.along.is_some());
    if !(length.to_f64() > 0.0 || have_directions || freedoms.is(Freedoms::RZ)) {
        return Err(NetworkError::SamePlace { member: index, nodes: [from.node, to.node] });
    }
    let built = element.build(length).map_err(|error| NetworkError::Parameter {
        member: index,
        element: element.name(),
        error,
    })?;
    Ok((built, placement))
}

impl<E: MemberElement, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> System
    for Network<'_, E, WIDTH, NODES, MEMBERS>
{
    type Parameter = E::Parameter;

    const HAS_PHASES: bool = false;
    const IS_NETWORK: bool = true;
    const MAY_BUCKLE: bool = E::MAY_BUCKLE;

    fn in_numbers(&self) -> Option<StiffnessModel<'_>> {
        self.stiffness
    }

    fn name_parts(&self, visitor: &mut dyn Visitor) {
        visit_network(self, &|member| self.numbers[member], visitor);
    }

    fn spot_of(&self, place: usize) -> Spot {
        self.spot(place)
    }

    fn may_buckle(&self) -> bool {
        E::MAY_BUCKLE && self.members.iter().flatten().any(E::may_buckle)
    }

    fn frequency_estimates(&self) -> FrequencyEstimates {
        let mut estimates = FrequencyEstimates::default();
        for member in self.members.iter().flatten() {
            E::estimate(member, &mut estimates);
        }
        for node in self.nodes {
            node.estimate(&mut estimates);
        }
        estimates.finish();
        estimates
    }
}

impl<E: MemberElement, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> Placed
    for Network<'_, E, WIDTH, NODES, MEMBERS>
{
    type Model = InNetwork;

    fn node(&self, node: usize) -> (&Node<E::Parameter>, &Motions<E::Parameter>) {
        (&self.nodes[node], &self.motions[node])
    }

    fn sizes(&self) -> [usize; 2] {
        [self.nodes.len(), self.members.len()]
    }

    fn place(&self, place: usize) -> [E::Parameter; 2] {
        self.nodes[place].position
    }

    fn placement(&self, member: usize) -> &Placement<E::Parameter> {
        &self.placements[member]
    }

    fn order(&self) -> NetworkOrder<'_> {
        self.order
    }

    type PerNode<V: Copy + Debug> = [V; NODES];
    type PerMember<V: Copy + Debug> = [V; MEMBERS];

    fn per_node<V: Copy + Debug>(value: V) -> [V; NODES] {
        [value; NODES]
    }

    fn per_member<V: Copy + Debug>(value: V) -> [V; MEMBERS] {
        [value; MEMBERS]
    }

    fn in_factor<S: StructureScalar, R>(&self, work: impl FnOnce(Factor<'_, S>) -> R) -> R {
        in_factor::<WIDTH, NODES, S, R>(self, work)
    }
}

impl<E, S, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> PlacedCharts<S>
    for Network<'_, E, WIDTH, NODES, MEMBERS>
where
    E: MemberChart<S>,
    S: Frequency<E::Parameter>,
{
    fn chart(&self, member: usize, at: &FrequencyPowers<S>, length: S) -> Option<Chart<S>> {
        Some(E::chart(self.members[member].as_ref()?, at, length))
    }
}

impl<E, S, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> PlacedMotions<S>
    for Network<'_, E, WIDTH, NODES, MEMBERS>
where
    E: MemberVisit<S>,
    S: Frequency<E::Parameter>,
{
    fn visit_member<V: VisitMember<S>>(&self, member: usize, visitor: V) -> Option<V::Output> {
        Some(E::visit(self.members[member].as_ref()?, visitor))
    }
}

impl<E, S, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> PlacedTransfers<S>
    for Network<'_, E, WIDTH, NODES, MEMBERS>
where
    E: MemberMatrix<S>,
    S: Frequency<E::Parameter> + Single,
{
    fn transfer(&self, member: usize, x: S) -> Option<MemberTransfer<S>> {
        Some(E::transfer(self.members[member].as_ref()?, x))
    }
}

impl<E, S, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> Characteristic<S>
    for Network<'_, E, WIDTH, NODES, MEMBERS>
where
    E: MemberChart<S>,
    S: Frequency<E::Parameter> + StructureScalar,
{
    fn pass<C: RootCounter<S>>(&self, x: S, counter: &mut C) -> Scaled<S> {
        network_pass::<WIDTH, _, _, _>(self, x, counter)
    }
}

impl<E, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> Undamped for Network<'_, E, WIDTH, NODES, MEMBERS>
where
    E: MemberElement<Parameter: InLanes>,
    Self: RealPasses,
{
}

impl<E, const WIDTH: usize, const NODES: usize, const MEMBERS: usize> Spectrum for Network<'_, E, WIDTH, NODES, MEMBERS>
where
    E: MemberElement,
    Self: ComplexPasses,
{
}
