//! The motion of a network under loads: its nodes are eliminated one after the other, and the way back gives what each one does.

use crate::model::EndMotion;
use crate::number::{Frequency, FrequencyPowers, Real, Scalar, Scaled, Size};
use crate::pass::network::evaluate::{Placed, PlacedCharts, eliminate_nodes, front_node, push_members};
use crate::pass::network::loading::Loading;
use crate::pass::network::member::Placement;
use crate::subspace::{Chart, Choice, FrontScalar, Fronts, JoinedEnd, LoadEverywhere};
use mstmm_plan::Freedoms;

/// The motion of a network.
#[derive(Debug)]
pub(crate) struct NetworkMotion<Y: Placed, S: Scalar> {
    /// Displacements x \[m\], y \[m\] and rotation \[rad\] of each node.
    pub(crate) nodes: Y::PerNode<[S; 3]>,
    /// Displacements and forces of both ends of each member.
    pub(crate) members: Y::PerMember<[EndMotion<S>; 2]>,
    /// The work of the load on the motion: the sum of forces times displacements.
    pub(crate) work: S,
    /// The first node where a pivot was rounding alone, as at a resonance.
    pub(crate) vanished_at: Option<u32>,
    /// The largest part of the row of a pivot that rounding may be, where errors are carried along.
    pub(crate) rounding: f64,
    /// The largest distance of the end of a member from its node where the two are joined, where errors are carried along: what a chart
    /// makes of the forces that were found is rounding away from what the node does.
    pub(crate) gap: f64,
}

/// Δ of a network.
pub(crate) fn delta<Y, S>(network: &Y, x: S) -> Scaled<S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
{
    let at = FrequencyPowers::new(x, true);
    Y::in_way_back(|mut way| {
        way.fronts.forget_loads();
        eliminate_nodes(network, &at, &mut way.fronts);
        way.fronts.total().delta()
    })
}

impl<Y: Placed, S: Scalar> Clone for NetworkMotion<Y, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Y: Placed, S: Scalar> Copy for NetworkMotion<Y, S> {}

/// The motion under a load, with the errors of its rows.
pub(crate) fn motion_under<Y, S>(network: &Y, x: S, load: &Loading<'_, S>) -> NetworkMotion<Y, S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
{
    motion(network, &FrequencyPowers::new(x, true), (Choice::Largest, true), load)
}

/// How far the motion under a load is from that with other pivots, its displacements beside the largest and its forces beside the largest:
/// what differs is rounding. Of a motion that is nearly rigid forces are small differences.
pub(crate) fn rounding_under<Y, S>(network: &Y, x: S, load: &Loading<'_, S>, found: &NetworkMotion<Y, S>) -> [f64; 2]
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
{
    let at = FrequencyPowers::new(x, true);
    let other = motion(network, &at, (Choice::InOrder, false), load);
    let difference = other.with(found, |one, other| one - other, S::zero());
    let length = longest(network);
    let forces = found.largest_force(length);
    let of_forces = if forces > 0.0 { difference.largest_force(length) / forces } else { 0.0 };
    [difference.largest() / found.size(), of_forces]
}

/// The length of the longest member, by which moments are compared with forces; 1 if none has a length.
pub(crate) fn longest<Y: Placed>(network: &Y) -> f64 {
    let lengths = (0..network.sizes()[1]).map(|member| network.placement(member).own_length().size());
    Some(lengths.fold(0.0, f64::max)).filter(|length| *length > 0.0).unwrap_or(1.0)
}

/// The size of two forces and a moment, which counts by a length.
pub(crate) fn size_of_forces<S: Scalar>(forces: &[S; 3], length: f64) -> f64 {
    let [x, y, moment] = forces.map(|force| force.size().first());
    x.max(y).max(moment / length)
}

/// The motion under the load of a number, forces and perhaps dislocations everywhere, with other pivots for each second number.
pub(crate) fn motion_everywhere<Y, S>(network: &Y, x: S, number: u32, dislocates: bool) -> NetworkMotion<Y, S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
{
    let load = LoadEverywhere { number, dislocates };
    let choice = if number.is_multiple_of(2) { Choice::Largest } else { Choice::InOrder };
    motion(network, &FrequencyPowers::new(x, true), (choice, false), &Loading::Everywhere(load))
}

/// The motion of a network at a frequency under loads of its nodes.
fn motion<Y, S>(
    network: &Y,
    at: &FrequencyPowers<S>,
    (choice, carries_errors): (Choice, bool),
    loading: &Loading<'_, S>,
) -> NetworkMotion<Y, S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + FrontScalar,
{
    let order = network.order();
    let zero = [S::zero(); 3];
    let (mut nodes, mut members) = (Y::per_node(zero), Y::per_member([EndMotion::at_rest(); 2]));
    for (node, displacements) in nodes.as_mut().iter_mut().enumerate().take(network.sizes()[0]) {
        *displacements = loading.moved(node).unwrap_or(zero);
    }
    let mut gap = 0.0_f64;
    let (work, vanished_at, rounding) = Y::in_way_back(|mut way| {
        way.fronts.choose(choice, carries_errors);
        for &node in order.nodes {
            let moved = |fronts: &mut Fronts<'_, S>, member: usize, chart: &Chart<S>, ends: &[JoinedEnd<S>; 2]| {
                if let Some(load) = loading.of_chart(member, network.placement(member), chart) {
                    S::load_chart(fronts, chart, ends, &load);
                }
            };
            let objects = order.taken_up[node] + push_members(network, (&order, node), at, &mut way.fronts, moved);
            let (body, motions) = network.node(node);
            let front = front_node(node, objects, body, motions, at.lambda_squared);
            let load = loading.on_node(network, node, at);
            S::eliminate_and_keep(&mut way.fronts, &front, &load, &mut way.back.kept);
        }
        for &node in order.nodes.iter().rev() {
            let (body, motions) = network.node(node);
            let front = front_node(node, 0, body, motions, at.lambda_squared);
            let displacements = motions.displacements(S::recover(&mut way.back, &front));
            for (sum, displacement) in nodes.as_mut()[node].iter_mut().zip(displacements) {
                *sum += displacement;
            }
            for &end in order.incidence.ends(node).iter().rev() {
                let member = end / 2;
                let placement = network.placement(member);
                if !order.is_first_at(end, node) {
                    continue;
                }
                if let Some(chart) = network.chart(member, at, placement.length()) {
                    let joins = [0, 1].map(|end| order.incidence.node(2 * member + end));
                    let ends = placement.joined(joins, joins.map(|node| network.node(node).1));
                    let (moved, load) = (loading.of_ends(placement), loading.along(member, &chart));
                    let motions = way.back.member(&chart, &ends, &moved, &load);
                    if carries_errors {
                        let of_nodes = [0, 1].map(|end| nodes.as_ref()[placement.node_of(end)]);
                        gap = gap.max(gap_of(placement, &motions, &of_nodes));
                    }
                    members.as_mut()[member] = motions;
                }
            }
        }
        let total = way.fronts.total();
        let [row, error] = total.smallest_row;
        (-way.back.kept.form, total.vanished_at, S::EPSILON * error / row)
    });
    NetworkMotion { nodes, members, work, vanished_at, rounding, gap }
}

/// How far the ends of a member are from their nodes in the displacements that they share.
fn gap_of<T: Real, S: Frequency<T>>(placement: &Placement<T>, ends: &[EndMotion<S>; 2], nodes: &[[S; 3]; 2]) -> f64 {
    let of_end = |end: usize| {
        let tied = placement.tied(end, nodes[end]);
        let differences = [0, 1, 2].map(|freedom| (ends[end].displacements[freedom] - tied[freedom]).size().first());
        let is_shared = |kind| placement.freedoms.contains(kind) && !placement.released(end).contains(kind);
        Freedoms::SINGLE
            .into_iter()
            .zip(differences)
            .filter(|(kind, _)| is_shared(*kind))
            .fold(0.0, |gap, (_, one)| one.max(gap))
    };
    of_end(0).max(of_end(1))
}

impl<Y: Placed, S: Scalar> NetworkMotion<Y, S> {
    /// Each number of this motion and of another one through a function.
    fn with<R: Scalar>(&self, other: &Self, change: impl Fn(S, S) -> R, work: R) -> NetworkMotion<Y, R> {
        let three = |one: [S; 3], other: [S; 3]| [0, 1, 2].map(|k| change(one[k], other[k]));
        let mut nodes = Y::per_node([R::zero(); 3]);
        for (changed, (one, other)) in
            nodes.as_mut().iter_mut().zip(self.nodes.as_ref().iter().zip(other.nodes.as_ref()))
        {
            *changed = three(*one, *other);
        }
        let mut members = Y::per_member([EndMotion::at_rest(); 2]);
        for (changed, (one, other)) in
            members.as_mut().iter_mut().zip(self.members.as_ref().iter().zip(other.members.as_ref()))
        {
            *changed = [0, 1].map(|end| EndMotion {
                displacements: three(one[end].displacements, other[end].displacements),
                forces: three(one[end].forces, other[end].forces),
            });
        }
        NetworkMotion { nodes, members, work, vanished_at: self.vanished_at, rounding: self.rounding, gap: self.gap }
    }

    /// The motion under so many times the load.
    pub(crate) fn times(&self, factor: S) -> Self {
        self.with(self, |one, _| one * factor, self.work * factor * factor)
    }

    /// The motion plus another one times a factor; the work stays that of the first load alone.
    pub(crate) fn plus(&self, other: &Self, factor: S) -> Self {
        self.with(other, |one, other| one + other * factor, self.work)
    }

    /// The motion in numbers of another precision.
    pub(crate) fn rounded<R: Scalar>(&self, round: impl Fn(S) -> R) -> NetworkMotion<Y, R> {
        self.with(self, |one, _| round(one), round(self.work))
    }

    /// The largest force of a member; a moment counts by a length.
    pub(crate) fn largest_force(&self, length: f64) -> f64 {
        let of_ends = self.members.as_ref().iter().flatten();
        let sizes = of_ends.map(|end| size_of_forces(&end.forces, length));
        sizes.fold(0.0, f64::max)
    }

    /// Whether all displacements and forces are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let of_ends = self.members.as_ref().iter().flatten();
        let numbers = of_ends.flat_map(|end| end.displacements.iter().chain(&end.forces));
        numbers.chain(self.nodes.as_ref().iter().flatten()).all(|number| number.size().first().is_finite())
    }

    /// The size of the largest displacement or rotation; 1 if there is none.
    pub(crate) fn size(&self) -> f64 {
        let largest = self.largest();
        if largest > 0.0 { largest } else { 1.0 }
    }

    fn largest(&self) -> f64 {
        let of_nodes = self.nodes.as_ref().iter().flatten();
        let of_ends = self.members.as_ref().iter().flatten().flat_map(|end| &end.displacements);
        of_nodes.chain(of_ends).map(|number| number.size().first()).fold(0.0, f64::max)
    }
}
