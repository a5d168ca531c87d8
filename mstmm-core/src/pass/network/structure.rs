//! A network with its order of elimination.

use crate::element::{
    MemberChart, MemberElement, MemberMatrix, MemberNumbers, MemberTransfer, MemberVisit, VisitMember,
};
#[cfg(feature = "std")]
use crate::element::{MemberEnds, MemberSlopes};
use crate::model::{FrequencyEstimates, MemberPlane, Spot, is_size_of_direction};
use crate::number::{Frequency, FrequencyPowers, InLanes, Parameter, Real, Scalar, Scaled, Single};
use crate::pass::characteristic::{Characteristic, System};
use crate::pass::network::error::NetworkError;
use crate::pass::network::evaluate::network_pass;
use crate::pass::network::member::Member;
#[cfg(feature = "std")]
use crate::pass::network::memory::Vectors;
use crate::pass::network::memory::{Arrays, Memory};
use crate::pass::network::motions::Motions;
use crate::pass::network::node::Node;
use crate::pass::network::order::Order;
use crate::pass::network::overall::PlacedTransfers;
use crate::pass::network::part::Part;
use crate::pass::network::placed::{Placed, PlacedCharts, PlacedMotions};
use crate::pass::network::placed_node::{PlacedNode, XYZ};
use crate::pass::network::placement::{Placement, SpatialEnd, is_finite};
use crate::pass::network::stiffness::{StiffnessModel, StiffnessRoom};
use crate::pass::network::ties::tie;
use crate::pass::network::visit::visit_network;
use crate::pass::searched::{ComplexPasses, RealPasses, Spectrum, Undamped};
use crate::proof::visit::Visitor;
use crate::structure::Chart;
use crate::structure::StructureScalar;
use crate::subspace::RootCounter;
use mstmm_plan::{Freedoms, NetworkOrder};

/// The points of networks, by their indices.
#[derive(Clone, Copy, Debug)]
pub enum InNetwork {}

/// A plane structure of beams, springs and dampers between nodes, at any angle, with any number of closed loops.
///
/// Nodes are eliminated one after the other. With `std` a network is as large as the program wants: its memory, and that of what it is asked, is on
/// the heap. Without `std` it stands in [`Arrays`] of a size that the compiler knows. There an evaluation takes a stack of
/// `2 WIDTH²` numbers, 110 for the charts of members that may be equal, and some 100 bytes per unknown: 8 bytes a number of `f64`, 16 with its
/// slope, and each twice as much in extended precision, where the search of a doubtful result has 32. A motion takes `WIDTH²` numbers more for each of `NODES` nodes. Searches for natural frequencies take up to 60 kB more.
///
/// ```
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{Arrays, Member, Network, Node, Section, Support, UndampedMember};
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
/// let portal = Network::<_, Arrays<16, 4, 3>>::in_arrays(&nodes, &members)?;
/// let found = portal.first_frequencies::<2>().unwrap();
/// assert!((found[0].omega - 178.832186592728532).abs() < 1e-12);
/// # Ok::<(), mstmm_core::NetworkError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Network<E: MemberElement, M: Memory> {
    sizes: [usize; 2],
    nodes: M::PerNode<PlacedNode<E::Parameter>>,
    motions: M::PerNode<Motions<E::Parameter>>,
    pub(super) members: M::PerMember<Option<E::Built>>,
    /// What each member is.
    kinds: M::PerMember<&'static str>,
    pub(super) placements: M::PerMember<Placement<E::Parameter>>,
    /// Nodes and members in numbers, for searches at many frequencies at once.
    pub(super) stiffness: StiffnessRoom<M>,
    pub(super) order: Order<M>,
    width: usize,
    /// Stiffnesses and inertias, which motions ask for at each frequency.
    estimates: FrequencyEstimates,
}

#[cfg(feature = "std")]
impl<E: MemberElement> Network<E, Vectors> {
    /// Builds a network of any size.
    ///
    /// # Errors
    /// [`NetworkError`] for what cannot be built.
    pub fn new(nodes: &[Node<E::Parameter>], members: &[Member<E>]) -> Result<Self, NetworkError> {
        Network::build(nodes, members)
    }
}

impl<E: MemberElement, const WIDTH: usize, const NODES: usize, const MEMBERS: usize>
    Network<E, Arrays<WIDTH, NODES, MEMBERS>>
{
    /// Builds a network in arrays: some 200 bytes per node, some 720 per member.
    ///
    /// # Errors
    /// [`NetworkError`] for what cannot be built, and for arrays that are too small.
    pub fn in_arrays(nodes: &[Node<E::Parameter>], members: &[Member<E>]) -> Result<Self, NetworkError> {
        if nodes.len() > NODES || members.len() > MEMBERS {
            return Err(NetworkError::Room { nodes: nodes.len(), members: members.len() });
        }
        match Network::build(nodes, members)? {
            Network { width: needed, .. } if needed > WIDTH => Err(NetworkError::Width { needed }),
            network => Ok(network),
        }
    }
}

impl<E: MemberElement, M: Memory> Network<E, M> {
    /// Builds a network in memory that has room for it.
    fn build(nodes: &[Node<E::Parameter>], members: &[Member<E>]) -> Result<Self, NetworkError> {
        let mut first = None;
        let origin = PlacedNode::at([<E::Parameter as Scalar>::from_f64(0.0); 3]);
        let mut own_nodes = M::per_node(nodes.len(), origin);
        own_nodes.as_mut().iter_mut().zip(nodes).for_each(|(own, node)| *own = (*node).into());
        let nodes = &own_nodes.as_ref()[..nodes.len()];
        let part = |index: usize| Part::from(members[index]);
        let built = Self::with_paths(nodes, (members.len(), part), |_| false, |error| first = first.or(Some(error)));
        built.ok_or(first.unwrap_or(NetworkError::Empty))
    }

    /// Builds a network some of whose nodes are motions of paths. What is wrong with it is refused: each node, and each member whose nodes are right.
    pub(crate) fn with_paths(
        nodes: &[PlacedNode<E::Parameter>],
        (member_count, part): (usize, impl Fn(usize) -> Part<E>),
        is_of_path: impl Fn(usize) -> bool,
        mut refuse: impl FnMut(NetworkError),
    ) -> Option<Self> {
        if member_count == 0 {
            refuse(NetworkError::Empty);
        }
        let sizes @ [node_count, _] = [nodes.len(), member_count];
        let mut motions = M::per_node(node_count, Motions::none());
        let mut stiffness = StiffnessRoom::new(sizes);
        let mut wrong_nodes = M::per_node(node_count, false);
        for (index, (node, motions)) in nodes.iter().zip(motions.as_mut()).enumerate() {
            if let Err(error) = check_node(index, node) {
                wrong_nodes.as_mut()[index] = true;
                refuse(error);
            }
            *motions = Motions::of(node);
            motions.is_of_path = is_of_path(index);
            stiffness.set_node(index, node, motions);
        }
        let mut built = M::per_member(member_count, None);
        let mut kinds = M::per_member(member_count, "");
        let mut placements = M::per_member(member_count, Placement::nowhere());
        for index in 0..member_count {
            let member = part(index);
            // what is wrong with a node is said once
            if member.ends.iter().any(|end| wrong_nodes.as_ref().get(end.node) == Some(&true)) {
                continue;
            }
            match build_placed(index, &member, nodes, motions.as_ref()) {
                Ok((element, placement)) => {
                    stiffness.set_member(index, E::member_numbers(&element), &placement);
                    built.as_mut()[index] = Some(element);
                    placements.as_mut()[index] = placement;
                    kinds.as_mut()[index] = member.element.name();
                }
                Err(error) => refuse(error),
            }
        }
        let all_built = built.as_ref()[..member_count].iter().all(Option::is_some);
        if member_count == 0 || !all_built || wrong_nodes.as_ref().contains(&true) {
            return None;
        }
        let rests = |node: usize| motions.as_ref()[node].count == 0;
        let order = Order::of(sizes, |member| part(member).ends.map(|end| end.node), rests)
            .map_err(|node| refuse(NetworkError::Apart { node }))
            .ok()?;
        stiffness.arrange(&order.get());
        #[cfg(feature = "std")]
        stiffness.set_space(nodes, motions.as_ref(), &placements.as_ref()[..member_count]);
        let ends = &mut placements.as_mut()[..member_count];
        tie(&mut motions.as_mut()[..node_count], ends, stiffness.numbers());
        let origin = PlacedNode::at([<E::Parameter as Scalar>::from_f64(0.0); 3]);
        let mut own_nodes = M::per_node(node_count, origin);
        own_nodes.as_mut()[..node_count].copy_from_slice(nodes);
        let width = width::<M, _>(&order.get(), motions.as_ref(), placements.as_ref());
        let (nodes, members, estimates) = (own_nodes, built, FrequencyEstimates::default());
        let mut network =
            Network { sizes, nodes, motions, members, kinds, placements, stiffness, order, width, estimates };
        network.estimate();
        Some(network)
    }

    /// The largest number of unknowns at once: motions of nodes, and what members have of their own.
    pub fn unknowns_at_once(&self) -> usize {
        self.width
    }

    /// Estimates stiffnesses and inertias.
    pub(super) fn estimate(&mut self) {
        let mut estimates = FrequencyEstimates::default();
        self.members.as_ref().iter().flatten().for_each(|member| E::estimate(member, &mut estimates));
        self.nodes().iter().for_each(|node| node.estimate(&mut estimates));
        estimates.finish();
        self.estimates = estimates;
    }

    /// The nodes.
    pub(super) fn nodes(&self) -> &[PlacedNode<E::Parameter>] {
        &self.nodes.as_ref()[..self.sizes[0]]
    }

    /// What each member is.
    pub(crate) fn kinds(&self) -> &[&'static str] {
        &self.kinds.as_ref()[..self.sizes[1]]
    }

    /// `∂L/∂p` for a parameter of a member by its name.
    #[cfg(feature = "std")]
    pub(crate) fn slope<S: Scalar>(&self, member: usize, motion: &MemberEnds<S>, name: &str) -> Option<S>
    where
        E: MemberSlopes<S>,
    {
        E::slope(self.member(member)?, motion, name)
    }

    /// A built member.
    fn member(&self, member: usize) -> Option<&E::Built> {
        self.members.as_ref().get(member)?.as_ref()
    }
}

/// The largest number of unknowns at once.
fn width<M: Memory, T: Real>(order: &NetworkOrder<'_>, motions: &[Motions<T>], placements: &[Placement<T>]) -> usize {
    let (mut of_nodes, mut of_members) = (M::per_node(motions.len(), 0), M::per_member(placements.len(), 0));
    of_nodes.as_mut().iter_mut().zip(motions).for_each(|(count, motions)| *count = motions.count);
    let ends = of_members.as_mut().iter_mut().zip(placements);
    ends.for_each(|(count, placement)| *count = placement.freedoms.count());
    order.width(of_nodes.as_ref(), of_members.as_ref())
}

/// Checks the numbers of a node.
fn check_node<T: Parameter>(index: usize, node: &PlacedNode<T>) -> Result<(), NetworkError> {
    let fail = |problem| Err(NetworkError::InvalidNode { node: index, problem });
    let is_valid = |inertia: T| inertia.to_f64() >= 0.0 && inertia.to_f64().is_finite();
    if !is_finite(node.position) {
        return fail("its place is not finite");
    }
    if !(is_valid(node.mass) && node.inertia[..3].iter().all(|moment| is_valid(*moment)) && is_finite(node.centre)) {
        return fail("mass and inertia must be zero or positive, and finite like the mass centre");
    }
    let held = XYZ.intersection(node.held);
    match node.skew {
        Some(skew) if !is_direction(*skew.direction()) => fail("its direction is zero, not finite or beyond 1e±70"),
        Some(_) if held.contains(Freedoms::X) || held.contains(Freedoms::Y) => {
            fail("it moves along a direction, and x or y is held as well: hold rz at most")
        }
        _ => Ok(()),
    }
}

/// Whether a vector has a direction.
pub(crate) fn is_direction<T: Parameter, const N: usize>(vector: [T; N]) -> bool {
    let size = vector.iter().map(|part| part.to_f64().abs()).fold(0.0, f64::max);
    is_finite(vector) && is_size_of_direction(size)
}

/// Builds a member.
fn build_placed<E: MemberElement>(
    index: usize,
    member: &Part<E>,
    nodes: &[PlacedNode<E::Parameter>],
    motions: &[Motions<E::Parameter>],
) -> Result<(E::Built, Placement<E::Parameter>), NetworkError> {
    let Part { mut ends, element, plane } = *member;
    if let Some(end) = ends.iter().find(|end| end.node >= nodes.len()) {
        return Err(NetworkError::NoSuchNode { member: index, node: end.node });
    }
    let freedoms = element.freedoms();
    let acts_along = freedoms.is(Freedoms::X) || element.is_joint() || plane == MemberPlane::About;
    let mut directions = ends.iter().filter_map(|end| end.along);
    if directions.any(|direction| !acts_along || !is_direction(direction)) {
        return Err(NetworkError::Direction { member: index });
    }
    if element.is_joint() {
        ends = ends.map(SpatialEnd::in_axes);
    }
    let [from, to] = &ends;
    let placement = Placement::new(
        (freedoms, plane),
        &ends,
        [&nodes[from.node], &nodes[to.node]],
        [&motions[from.node], &motions[to.node]],
    );
    let length = placement.own_length();
    if element.is_joint() && length.to_f64() > 0.0 {
        return Err(NetworkError::TwoPlaces { member: index, nodes: [from.node, to.node] });
    }
    let have_directions = ends.iter().all(|end| end.along.is_some());
    let has_no_direction = freedoms.is(Freedoms::RZ) && plane == MemberPlane::Structure;
    if !(length.to_f64() > 0.0 || have_directions || has_no_direction) {
        return Err(NetworkError::SamePlace { member: index, nodes: [from.node, to.node] });
    }
    let built = element.build(length).map_err(|error| NetworkError::Parameter {
        member: index,
        element: element.name(),
        error,
    })?;
    Ok((built, placement))
}

impl<E: MemberElement, M: Memory> System for Network<E, M> {
    type Parameter = E::Parameter;

    const HAS_PHASES: bool = false;
    const IS_NETWORK: bool = true;
    const MAY_BUCKLE: bool = E::MAY_BUCKLE;
    const SPINS: bool = E::SPINS;

    fn in_numbers(&self) -> Option<StiffnessModel<'_>> {
        self.stiffness.model(&self.order.get())
    }

    fn name_parts(&self, visitor: &mut dyn Visitor) {
        visit_network(self, visitor);
    }

    fn is_flat(&self) -> bool {
        self.stiffness.is_flat()
    }

    fn spot_of(&self, place: usize) -> Spot {
        self.spot(place)
    }

    fn may_buckle(&self) -> bool {
        E::MAY_BUCKLE && self.members.as_ref().iter().flatten().any(E::may_buckle)
    }

    fn frequency_estimates(&self) -> FrequencyEstimates {
        self.estimates
    }
}

impl<E: MemberElement, M: Memory> Placed for Network<E, M> {
    type Model = InNetwork;

    fn node(&self, node: usize) -> (&PlacedNode<E::Parameter>, &Motions<E::Parameter>) {
        (&self.nodes.as_ref()[node], &self.motions.as_ref()[node])
    }

    fn sizes(&self) -> [usize; 2] {
        self.sizes
    }

    fn place(&self, place: usize) -> [E::Parameter; 3] {
        self.nodes.as_ref()[place].position
    }

    fn placement(&self, member: usize) -> &Placement<E::Parameter> {
        &self.placements.as_ref()[member]
    }

    fn numbers(&self) -> &[MemberNumbers] {
        self.stiffness.numbers()
    }

    fn order(&self) -> NetworkOrder<'_> {
        self.order.get()
    }

    fn width(&self) -> usize {
        self.width
    }

    type Memory = M;
}

impl<E: MemberChart<S>, M: Memory, S: Frequency<E::Parameter>> PlacedCharts<S> for Network<E, M> {
    fn chart(&self, member: usize, at: &FrequencyPowers<S>, length: S) -> Option<Chart<S>> {
        Some(E::chart(self.member(member)?, at, length))
    }
}

impl<E: MemberVisit<S>, M: Memory, S: Frequency<E::Parameter>> PlacedMotions<S> for Network<E, M> {
    fn visit_member<V: VisitMember<S>>(&self, member: usize, visitor: V) -> Option<V::Output> {
        Some(E::visit(self.member(member)?, visitor))
    }
}

impl<E: MemberMatrix<S>, M: Memory, S: Frequency<E::Parameter> + Single> PlacedTransfers<S> for Network<E, M> {
    fn transfer(&self, member: usize, x: S) -> Option<MemberTransfer<S>> {
        Some(E::transfer(self.member(member)?, x))
    }
}

impl<E: MemberChart<S>, M: Memory, S: Frequency<E::Parameter> + StructureScalar> Characteristic<S> for Network<E, M> {
    fn pass<C: RootCounter<S>>(&self, x: S, counter: &mut C) -> Scaled<S> {
        network_pass(self, x, counter)
    }
}

impl<E: MemberElement<Parameter: InLanes>, M: Memory> Undamped for Network<E, M> where Self: RealPasses {}

impl<E: MemberElement, M: Memory> Spectrum for Network<E, M> where Self: ComplexPasses {}
