//! The motion of a network under loads: its nodes are eliminated one after the other, and the way back gives what each one does.

use crate::model::EndMotion;
use crate::number::{Frequency, FrequencyPowers, Scalar, Size};
use crate::pass::network::evaluate::eliminate;
use crate::pass::network::loading::Loading;
use crate::pass::network::memory::Memory;
use crate::pass::network::placed::{PerMember, PerNode, Placed, PlacedCharts};
use crate::pass::network::ties::{Solved, joints};
use crate::pass::network::vector::{Six, displacements, rotations};
use crate::structure::{Factor, LOADS, MemberStiffness, NodeUnknowns, StructureScalar, with_many};

/// The motion of a network.
#[derive(Debug)]
pub(crate) struct NetworkMotion<Y: Placed, S: Scalar> {
    /// Displacements \[m\] and rotations \[rad\] of each node.
    pub(crate) nodes: PerNode<Y, Six<S>>,
    /// Displacements and forces of both ends of each member.
    pub(crate) members: PerMember<Y, [EndMotion<S>; 2]>,
    /// The work of the load on the motion: the sum of forces times displacements.
    pub(crate) work: S,
    /// The first node where a pivot was rounding alone, as at a resonance.
    pub(crate) vanished_at: Option<u32>,
}

impl<Y: Placed, S: Scalar> Clone for NetworkMotion<Y, S> {
    fn clone(&self) -> Self {
        NetworkMotion { nodes: self.nodes.clone(), members: self.members.clone(), ..*self }
    }
}

impl<Y: Placed, S: Scalar> Copy for NetworkMotion<Y, S>
where
    PerNode<Y, Six<S>>: Copy,
    PerMember<Y, [EndMotion<S>; 2]>: Copy,
{
}

/// The members whose motions are found. Motions of nodes are always found; the motion of another member is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Wanted {
    /// Those of all members.
    All,
    /// That of one member.
    Member(usize),
    /// Those of no member.
    Nodes,
}

/// The motion under a load, the first one of two.
pub(crate) fn motion_under<Y, S>(network: &Y, x: S, loading: &Loading<'_, S>, wanted: Wanted) -> NetworkMotion<Y, S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
{
    solved(network, x, (loading, wanted), |found| found(0))
}

/// The motions under both loads of a number and the next one.
pub(crate) fn motions_under<Y, S>(network: &Y, x: S, loading: &Loading<'_, S>) -> [NetworkMotion<Y, S>; LOADS]
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
{
    solved(network, x, (loading, Wanted::All), |found| [found(0), found(1)])
}

/// What a function makes of the motions under the loads.
fn solved<Y, S, R>(
    network: &Y,
    x: S,
    (loading, wanted): (&Loading<'_, S>, Wanted),
    make: impl FnOnce(&dyn Fn(usize) -> NetworkMotion<Y, S>) -> R,
) -> R
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
{
    let ([nodes, members], none) = (network.sizes(), MemberStiffness::none());
    Y::Memory::in_factor(network.width(), |mut factor: Factor<'_, S>| {
        with_many(
            NodeUnknowns::NONE,
            nodes,
            |none| network.per_node(none),
            |unknowns| {
                with_many(
                    none,
                    members,
                    |none| network.per_member(none),
                    |stiffnesses| {
                        if let Loading::Everywhere(load) = loading {
                            factor.everywhere = Some(*load);
                        }
                        let at = FrequencyPowers::new(x, true);
                        factor.units = loading.units(network, &at);
                        eliminate(network, &at, loading, &mut factor, (unknowns, stiffnesses));
                        S::solve(&mut factor);
                        make(&|load| found(network, (&at, loading, wanted), (&factor, load), (unknowns, stiffnesses)))
                    },
                )
            },
        )
    })
}

/// The motion of all nodes and members under a load, once the values of unknowns are known.
fn found<Y, S>(
    network: &Y,
    (at, loading, wanted): (&FrequencyPowers<S>, &Loading<'_, S>, Wanted),
    (factor, load): (&Factor<'_, S>, usize),
    (unknowns, stiffnesses): (&[NodeUnknowns], &[MemberStiffness<S>]),
) -> NetworkMotion<Y, S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter> + StructureScalar,
{
    let (order, [node_count, member_count]) = (network.order(), network.sizes());
    let (mut nodes, mut members) = (network.per_node([S::zero(); 6]), network.per_member([EndMotion::at_rest(); 2]));
    for (node, displacements) in nodes.as_mut().iter_mut().enumerate().take(node_count) {
        let of_node = &unknowns[node];
        *displacements = network.node(node).1.displacements(factor.values_of(of_node, load));
        for (sum, moved) in displacements.iter_mut().zip(loading.moved(node).into_iter().flatten()) {
            *sum += moved;
        }
    }
    // the forces of a joint by rows follow from the forces of other members
    let needs_all = match wanted {
        Wanted::All => true,
        Wanted::Member(member) => network.placement(member).is_tie,
        Wanted::Nodes => false,
    };
    for (member, (motion, stiffness)) in members.as_mut().iter_mut().zip(stiffnesses).enumerate().take(member_count) {
        if !(needs_all || wanted == Wanted::Member(member)) {
            continue;
        }
        let joins = [0, 1].map(|end| order.incidence.node(2 * member + end));
        *motion = S::motion(factor, stiffness, joins.map(|node| &unknowns[node]), load);
    }
    if needs_all && !loading.moves_support() {
        let solved = Solved { stiffnesses, loading, at };
        joints(network, &solved, |node| factor.values_of(&unknowns[node], load), members.as_mut());
    }
    NetworkMotion { nodes, members, work: factor.works[load], vanished_at: factor.vanished_at }
}

/// The length of the longest member, by which moments are compared with forces; 1 if none has a length.
pub(crate) fn longest<Y: Placed>(network: &Y) -> f64 {
    let lengths = (0..network.sizes()[1]).map(|member| network.placement(member).own_length().size());
    Some(lengths.fold(0.0, f64::max)).filter(|length| *length > 0.0).unwrap_or(1.0)
}

/// The size of two forces and a moment, which counts by a length.
fn size_of_forces<S: Scalar>(forces: &[S; 3], length: f64) -> f64 {
    let [x, y, moment] = forces.map(|force| force.size().first());
    x.max(y).max(moment / length)
}

/// The size of the forces and the moments on a node, which count by a length.
pub(crate) fn size_on_node<S: Scalar>(forces: &Six<S>, length: f64) -> f64 {
    let largest = |three: [S; 3]| three.into_iter().map(|part| part.size().first()).fold(0.0, f64::max);
    largest(displacements(*forces)).max(largest(rotations(*forces)) / length)
}

impl<Y: Placed, S: Scalar> NetworkMotion<Y, S> {
    /// Each number of this motion and of another one through a function.
    fn with<R: Scalar>(&self, other: &Self, change: impl Fn(S, S) -> R, work: R) -> NetworkMotion<Y, R> {
        let three = |one: [S; 3], other: [S; 3]| [0, 1, 2].map(|k| change(one[k], other[k]));
        let ([of_nodes, of_members], zero) = ([self.nodes.as_ref().len(), self.members.as_ref().len()], [R::zero(); 6]);
        let mut nodes = Y::Memory::per_node(of_nodes, zero);
        for (changed, (one, other)) in
            nodes.as_mut().iter_mut().zip(self.nodes.as_ref().iter().zip(other.nodes.as_ref()))
        {
            changed
                .iter_mut()
                .zip(one.iter().zip(other))
                .for_each(|(changed, (one, other))| *changed = change(*one, *other));
        }
        let mut members = Y::Memory::per_member(of_members, [EndMotion::at_rest(); 2]);
        for (changed, (one, other)) in
            members.as_mut().iter_mut().zip(self.members.as_ref().iter().zip(other.members.as_ref()))
        {
            *changed = [0, 1].map(|end| EndMotion {
                displacements: three(one[end].displacements, other[end].displacements),
                forces: three(one[end].forces, other[end].forces),
            });
        }
        NetworkMotion { nodes, members, work, vanished_at: self.vanished_at }
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
