//! The evaluation of a network: its nodes are eliminated one after the other.

use crate::number::{Frequency, FrequencyPowers, Scalar, Scaled};
use crate::pass::network::loading::Loading;
use crate::pass::network::placed::{Placed, PlacedCharts, for_each_cut};
use crate::structure::{Factor, MemberStiffness, NodeUnknowns, StructureScalar, Total, in_memory, with_many};
use crate::subspace::RootCounter;

/// What a function does in memory for the elimination of a network of up to so many nodes, with up to `WIDTH` unknowns at once.
pub fn in_factor<const WIDTH: usize, const NODES: usize, S: Scalar, R>(
    network: &impl Placed,
    work: impl FnOnce(Factor<'_, S>) -> R,
) -> R {
    let [nodes, members] = network.sizes();
    // a member has no more unknowns of its own than freedoms
    let unknowns = || {
        let of_nodes = (0..nodes).map(|node| network.node(node).1.count);
        of_nodes.chain((0..members).map(|member| network.placement(member).freedoms.count())).sum()
    };
    in_memory::<WIDTH, NODES, S, R>(true, unknowns, work)
}

/// Δ of a network, with a counter. `WIDTH` is the largest number of unknowns at once.
pub fn network_pass<const WIDTH: usize, Y, S, C>(network: &Y, x: S, counter: &mut C) -> Scaled<S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
    C: RootCounter<S>,
{
    let (total, vanished_at) = total::<WIDTH, _, _>(network, x);
    if let (true, Some(node)) = (C::WATCHES, vanished_at) {
        counter.vanished(network.spot(node as usize));
        if S::IS_EXTENDED {
            counter.cancelled(true);
        }
    }
    counter.eliminated(total.below);
    // in extended precision what is rounding alone is zero: there is nothing further that could tell
    if S::IS_EXTENDED && vanished_at.is_some() { Scaled::new(S::zero(), 0) } else { total.delta() }
}

/// Δ and the count of a network, and the first node where a pivot was rounding alone.
#[inline(never)]
fn total<const WIDTH: usize, Y, S>(network: &Y, x: S) -> (Total<S>, Option<u32>)
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
{
    // the rows of one node at a time
    in_memory::<WIDTH, 1, S, _>(
        false,
        || WIDTH,
        |mut factor| {
            let mut stiffness = MemberStiffness::none();
            let at = FrequencyPowers::new(x, true);
            with_many(NodeUnknowns::NONE, network.sizes()[0], Y::per_node, |unknowns| {
                eliminate(
                    network,
                    &at,
                    &Loading::Nothing,
                    &mut factor,
                    (unknowns, core::slice::from_mut(&mut stiffness)),
                );
            });
            S::leave_all(&mut factor);
            (factor.total, factor.vanished_at)
        },
    )
}

/// Lets all nodes and members join the factor, and all nodes leave in their order. Fills the unknowns of nodes and the stiffnesses of members,
/// or one stiffness after the other where no rows are kept.
pub(super) fn eliminate<Y, S>(
    network: &Y,
    at: &FrequencyPowers<S>,
    loading: &Loading<'_, S>,
    factor: &mut Factor<'_, S>,
    (unknowns, stiffnesses): (&mut [NodeUnknowns], &mut [MemberStiffness<S>]),
) where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
{
    let order = network.order();
    for &node in order.nodes {
        factor.node = node as u32;
        let mut entered = |factor: &mut Factor<'_, S>, node: usize| {
            let unknowns = &mut unknowns[node];
            if !unknowns.has_entered {
                *unknowns = S::enter(factor, network.node(node).1.count);
            }
            *unknowns
        };
        for_each_cut(network, (&order, node), at, |member, chart, ends| {
            let nodes = ends.each_ref().map(|end| entered(factor, end.node));
            let load = loading.on_member(member, network.placement(member), chart);
            let stiffness = &mut stiffnesses[if factor.keeps_rows { member } else { 0 }];
            S::join(factor, stiffness, chart, (ends, nodes.each_ref()), load);
        });
        let own = entered(factor, node);
        let (body, motions) = network.node(node);
        let body = motions.body(body, at.lambda_squared);
        S::take_up(factor, &own, &body, &loading.on_node(network, node, at));
    }
}
