//! The evaluation of a network: its nodes are eliminated one after the other.

use crate::number::{Frequency, FrequencyPowers, Scaled};
use crate::pass::network::loading::Loading;
use crate::pass::network::memory::Memory;
use crate::pass::network::placed::{ChartsOfEqual, PlacedCharts, for_each_cut};
use crate::structure::{Factor, MemberStiffness, NodeUnknowns, StructureScalar, Total, with_many};
use crate::subspace::RootCounter;

/// Δ of a network, with a counter.
pub fn network_pass<Y, S, C>(network: &Y, x: S, counter: &mut C) -> Scaled<S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
    C: RootCounter<S>,
{
    let (total, vanished_at) = total(network, x);
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
fn total<Y, S>(network: &Y, x: S) -> (Total<S>, Option<u32>)
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
{
    Y::Memory::in_front(network.width(), |mut factor: Factor<'_, S>| {
        let mut stiffness = MemberStiffness::none();
        let (at, stiffnesses) = (FrequencyPowers::new(x, true), core::slice::from_mut(&mut stiffness));
        with_many(
            NodeUnknowns::NONE,
            network.sizes()[0],
            |none| network.per_node(none),
            |unknowns| {
                eliminate(network, &at, &Loading::Nothing, &mut factor, (unknowns, stiffnesses));
            },
        );
        S::leave_all(&mut factor);
        (factor.total, factor.vanished_at)
    })
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
    let (order, mut charts) = (network.order(), ChartsOfEqual::new());
    for &node in order.nodes {
        factor.node = node as u32;
        let mut entered = |factor: &mut Factor<'_, S>, node: usize| {
            let unknowns = &mut unknowns[node];
            if !unknowns.has_entered {
                *unknowns = S::enter(factor, network.node(node).1.count);
            }
            *unknowns
        };
        for_each_cut(network, (&order, node), (at, &mut charts), |member, chart, ends| {
            let nodes = ends.each_ref().map(|end| entered(factor, end.node));
            chart.coarsen(factor.units);
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
