//! The evaluation of a network: its nodes are eliminated one after the other.

use crate::number::{Frequency, FrequencyPowers, Scaled};
use crate::pass::network::loading::Loading;
use crate::pass::network::memory::Memory;
use crate::pass::network::motions::Shared;
use crate::pass::network::placed::{ChartsOfEqual, Placed, PlacedCharts};
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
    let ties = !loading.moves_support();
    for &node in order.nodes {
        factor.node = node as u32;
        for &end in order.incidence.ends(node).iter().filter(|end| order.is_first_at(**end, node)) {
            let member = end / 2;
            let nodes = [0, 1].map(|end| order.incidence.node(2 * member + end));
            let joined = nodes.map(|node| entered(network, (node, ties), factor, unknowns));
            let placement = network.placement(member);
            if placement.is_tie && ties {
                continue;
            }
            let Some(mut chart) = charts.chart(network, member, at) else { continue };
            chart.coarsen(factor.units);
            let load = loading.on_member(member, placement, &chart);
            let ends = placement.joined(nodes.map(|node| network.node(node).1));
            let stiffness = &mut stiffnesses[if factor.keeps_rows { member } else { 0 }];
            S::join(factor, stiffness, &chart, (&ends, joined.each_ref()), load);
        }
        let own = entered(network, (node, ties), factor, unknowns);
        let (body, motions) = network.node(node);
        let body = motions.body(body, at.lambda_squared);
        S::take_up(factor, &own, &body, &loading.on_node(network, node, at));
    }
}

/// The unknowns of a node, which enter where they have not. With ties a motion that is that of another node is its unknown.
fn entered<Y, S>(
    network: &Y,
    (node, ties): (usize, bool),
    factor: &mut Factor<'_, S>,
    unknowns: &mut [NodeUnknowns],
) -> NodeUnknowns
where
    Y: Placed,
    S: Frequency<Y::Parameter> + StructureScalar,
{
    if unknowns[node].has_entered {
        return unknowns[node];
    }
    let motions = network.node(node).1;
    for motion in 0..motions.count {
        let owner = match motions.shared[motion] {
            Shared::With { node, motion } if ties => Some((node as usize, motion as usize)),
            Shared::AtRest if ties => None,
            _ => Some((node, motion)),
        };
        let unknown =
            owner.map(|(node, motion)| *unknowns[node].motions[motion].get_or_insert_with(|| S::enter(factor)));
        unknown.into_iter().for_each(|unknown| factor.hold(unknown));
        unknowns[node].motions[motion] = unknown;
    }
    (unknowns[node].has_entered, unknowns[node].count) = (true, motions.count as u32);
    unknowns[node]
}
