//! The evaluation of a network: its nodes are eliminated one after the other.

use crate::element::VisitMember;
use crate::model::Spot;
use crate::number::{Frequency, FrequencyPowers, Parameter, Scalar, Scaled, Size};
use crate::pass::characteristic::System;
use crate::pass::network::member::Placement;
use crate::pass::network::node::{Motions, Node};
use crate::structure::{Factor, FactorRoom, StructureScalar};
use crate::subspace::{Chart, Choice, FrontNode, FrontScalar, Fronts, JoinedEnd, RootCounter, Total};
use core::fmt::Debug;
use mstmm_plan::NetworkOrder;

/// Size of a pivot or of its row, in units of its error, beyond which no other choice of pivots is looked at.
const NEAR: f64 = 16.0;

/// Part of Δ by which another choice of pivots may change it, as it may where rounding alone is left.
const NOISE: f64 = 0.5;

/// A network as its evaluation reads it.
pub trait Placed: System {
    /// The model whose points it has.
    type Model;

    /// A node and its motions.
    fn node(&self, node: usize) -> (&Node<Self::Parameter>, &Motions<Self::Parameter>);

    /// Where a member stands.
    fn placement(&self, member: usize) -> &Placement<Self::Parameter>;

    /// A place that rigid bodies tie.
    fn place(&self, place: usize) -> [Self::Parameter; 2];

    /// What errors call a node.
    fn spot(&self, node: usize) -> Spot {
        Spot::Node(node)
    }

    /// The order of its nodes.
    fn order(&self) -> NetworkOrder<'_>;

    /// The number of nodes and of members.
    fn sizes(&self) -> [usize; 2];

    /// A value per node.
    type PerNode<V: Copy + Debug>: AsRef<[V]> + AsMut<[V]> + Copy + Debug;

    /// A value per member.
    type PerMember<V: Copy + Debug>: AsRef<[V]> + AsMut<[V]> + Copy + Debug;

    /// One value for all nodes.
    fn per_node<V: Copy + Debug>(value: V) -> Self::PerNode<V>;

    /// One value for all members.
    fn per_member<V: Copy + Debug>(value: V) -> Self::PerMember<V>;

    /// What a function does in memory for the elimination of its unknowns.
    fn in_factor<S: StructureScalar, R>(work: impl FnOnce(Factor<'_, S>) -> R) -> R;
}

/// What a function does in memory for the elimination of so many nodes, with up to `WIDTH` unknowns at once.
pub fn in_factor<const WIDTH: usize, const NODES: usize, S: Scalar, R>(work: impl FnOnce(Factor<'_, S>) -> R) -> R {
    work(FactorRoom::<S, WIDTH, NODES>::new().factor())
}

/// A network whose members are known at a frequency.
pub trait PlacedCharts<S: Frequency<Self::Parameter>>: Placed {
    /// The chart of a member of a length.
    fn chart(&self, member: usize, at: &FrequencyPowers<S>, length: S) -> Option<Chart<S>>;
}

/// A network whose members say how they move.
pub trait PlacedMotions<S: Frequency<Self::Parameter>>: Placed {
    /// What a visitor makes of a member.
    fn visit_member<V: VisitMember<S>>(&self, member: usize, visitor: V) -> Option<V::Output>;
}

/// Δ of a network, with a counter. `WIDTH` is the largest number of variables of a front.
pub fn network_pass<const WIDTH: usize, Y, S, C>(network: &Y, x: S, counter: &mut C) -> Scaled<S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
    C: RootCounter<S>,
{
    let total = eliminated::<WIDTH, _, _>(network, x, Choice::Largest, S::IS_EXTENDED);
    let [row, error] = total.smallest_row;
    let mut vanished_at = total.vanished_at;
    // another choice of pivots rounds otherwise: what differs is decided by rounding
    if S::IS_EXTENDED
        && vanished_at.is_none()
        && row < NEAR * S::EPSILON * error
        && differs(total.delta(), eliminated::<WIDTH, _, _>(network, x, Choice::InOrder, false).delta())
    {
        vanished_at = Some(total.smallest_at);
    }
    if let (true, Some(node)) = (C::WATCHES, vanished_at) {
        counter.cancelled(true);
        counter.vanished(network.spot(node as usize));
    }
    counter.eliminated(total.below);
    // in extended precision what is rounding alone is zero: there is nothing further that could tell
    if S::IS_EXTENDED && vanished_at.is_some() { Scaled::new(S::zero(), 0) } else { total.delta() }
}

/// Whether two numbers have no digits in common.
#[cold]
fn differs<S: Scalar>(one: Scaled<S>, other: Scaled<S>) -> bool {
    let difference = (one.over(other).over_power(0) - S::one()).size().first();
    // a NaN has none
    difference.is_nan() || difference > NOISE
}

/// Eliminates all nodes.
#[inline(never)]
fn eliminated<const WIDTH: usize, Y, S>(network: &Y, x: S, choice: Choice, carries_errors: bool) -> Total<S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
{
    let at = FrequencyPowers::new(x, true);
    let total = S::in_memory::<WIDTH, _>(|room| {
        let mut fronts = room.fronts(choice, carries_errors);
        eliminate_nodes(network, &at, &mut fronts);
        *fronts.total()
    });
    // numbers in lanes are evaluated alone
    total.unwrap_or_else(Total::unknown)
}

/// Takes up and eliminates all nodes in their order.
#[inline(always)]
fn eliminate_nodes<Y, S>(network: &Y, at: &FrequencyPowers<S>, fronts: &mut Fronts<'_, S>)
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
{
    let order = network.order();
    for &node in order.nodes {
        let objects = order.taken_up[node] + push_members(network, (&order, node), at, fronts);
        let (body, motions) = network.node(node);
        S::eliminate(fronts, &front_node(node, objects, body, motions, at.lambda_squared));
    }
}

/// Adds the members that are cut by the elimination of a node. Returns the number of objects.
#[inline(always)]
fn push_members<Y, S>(
    network: &Y,
    (order, node): (&NetworkOrder<'_>, usize),
    at: &FrequencyPowers<S>,
    fronts: &mut Fronts<'_, S>,
) -> usize
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
{
    let mut count = 0;
    for_each_cut(network, (order, node), at, |_, chart, ends| count += S::push_chart(fronts, chart, ends));
    count
}

/// Hands on each member that is cut by the elimination of a node, with its chart and where its ends are joined.
#[inline(always)]
pub(super) fn for_each_cut<Y, S>(
    network: &Y,
    (order, node): (&NetworkOrder<'_>, usize),
    at: &FrequencyPowers<S>,
    mut take: impl FnMut(usize, &Chart<S>, &[JoinedEnd<S>; 2]),
) where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter>,
{
    for &end in order.incidence.ends(node) {
        let member = end / 2;
        if !order.is_first_at(end, node) {
            continue;
        }
        let placement = network.placement(member);
        if let Some(chart) = network.chart(member, at, placement.length()) {
            let nodes = [0, 1].map(|end| order.incidence.node(2 * member + end));
            let ends = placement.joined(nodes, nodes.map(|node| network.node(node).1));
            take(member, &chart, &ends);
        }
    }
}

/// What fronts need of a node.
fn front_node<T: Parameter, S: Frequency<T>>(
    index: usize,
    objects: usize,
    node: &Node<T>,
    motions: &Motions<T>,
    lambda_squared: S,
) -> FrontNode<S> {
    let square = lambda_squared.size().first();
    FrontNode {
        index: index as u32,
        objects,
        motions: motions.count,
        has_rotation: motions.has_rotation,
        inertias: [node.mass, node.inertia].map(|inertia| square * inertia.to_f64()),
        body: motions.body(node, lambda_squared),
    }
}
