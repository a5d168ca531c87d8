//! A network as its evaluation reads it: nodes, members, and the order in which nodes leave.

use crate::element::{MemberNumbers, VisitMember};
use crate::model::{Handle, MotionError, Spot, Tied};
use crate::number::{Frequency, FrequencyPowers, Real, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::memory::Memory;
use crate::pass::network::motions::Motions;
use crate::pass::network::placed_node::PlacedNode;
use crate::pass::network::placement::Placement;
use crate::structure::Chart;
use core::fmt::Debug;
use core::ops::Range;
use mstmm_plan::{Freedoms, NetworkOrder, freedoms_of_part};

/// A network as its evaluation reads it.
pub trait Placed: System {
    /// The model whose points it has.
    type Model;

    /// A node and its motions.
    fn node(&self, node: usize) -> (&PlacedNode<Self::Parameter>, &Motions<Self::Parameter>);

    /// Where a member stands.
    fn placement(&self, member: usize) -> &Placement<Self::Parameter>;

    /// The members in numbers, as far as they are known so.
    fn numbers(&self) -> &[MemberNumbers];

    /// A place that rigid bodies tie.
    fn place(&self, place: usize) -> [Self::Parameter; 3];

    /// The node of a point of a list or of a frame, with its place and its support.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] and [`MotionError::OtherFrame`] for a point that it has not got.
    fn point(&self, point: Handle) -> Result<Tied, MotionError> {
        Ok(Tied::node(of_list(point, self.sizes()[0])?))
    }

    /// The number of the frame of its points and members; zero of a list and of a sketch.
    fn frame_number(&self) -> u32 {
        0
    }

    /// The index of a member.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] and [`MotionError::OtherFrame`] for a member that it has not got.
    fn member_of(&self, member: Handle) -> Result<usize, MotionError> {
        of_list(member, self.sizes()[1])
    }

    /// The parts of a member, by their indices: one in a plane structure.
    ///
    /// # Errors
    /// As [`member_of`](Placed::member_of).
    fn parts_of(&self, member: Handle) -> Result<Range<usize>, MotionError> {
        self.member_of(member).map(|first| self.parts_from(first))
    }

    /// The parts of the member that begins with one of an index; none where that is a further part.
    fn parts_from(&self, first: usize) -> Range<usize> {
        first..first + 1
    }

    /// The part of a member in a plane, 0 that of x and y or its only one, 1 that of x and z, 2 its rotation about x; none where it has none.
    ///
    /// # Errors
    /// As [`member_of`](Placed::member_of).
    fn part_of(&self, member: Handle, part: usize) -> Result<Option<usize>, MotionError> {
        Ok(self.parts_of(member)?.find(|own| self.placement(*own).part() == part))
    }

    /// What errors call a node.
    fn spot(&self, node: usize) -> Spot {
        Spot::Node(node)
    }

    /// The order of its nodes.
    fn order(&self) -> NetworkOrder<'_>;

    /// The number of nodes and of members.
    fn sizes(&self) -> [usize; 2];

    /// The largest number of unknowns at once.
    fn width(&self) -> usize {
        Self::Memory::WIDTH
    }

    /// Its memory.
    type Memory: Memory;

    /// One value for all nodes.
    fn per_node<V: Copy + Debug>(&self, value: V) -> PerNode<Self, V> {
        Self::Memory::per_node(self.sizes()[0], value)
    }

    /// One value for all members.
    fn per_member<V: Copy + Debug>(&self, value: V) -> PerMember<Self, V> {
        Self::Memory::per_member(self.sizes()[1], value)
    }
}

/// The index in a list of so many.
pub(super) fn of_list(Handle { index, frame }: Handle, count: usize) -> Result<usize, MotionError> {
    if frame != 0 {
        return Err(MotionError::OtherFrame { index });
    }
    if index < count { Ok(index) } else { Err(MotionError::NoSuchPoint { index }) }
}

/// A value for each node of a network.
pub type PerNode<Y, V> = <<Y as Placed>::Memory as Memory>::PerNode<V>;

/// A value for each member of a network.
pub type PerMember<Y, V> = <<Y as Placed>::Memory as Memory>::PerMember<V>;

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

/// Charts that are kept: frames have few kinds of members beside each other.
const KEPT: usize = 4;

/// The charts of the last members that differ, at one frequency: equal members have one chart.
pub(super) struct ChartsOfEqual<S: Scalar> {
    /// A member with its length and its chart.
    kept: [Option<(usize, S, Chart<S>)>; KEPT],
    /// The place of the next one.
    next: usize,
}

impl<S: Scalar> ChartsOfEqual<S> {
    /// No chart yet.
    pub(super) fn new() -> Self {
        ChartsOfEqual { kept: [const { None }; KEPT], next: 0 }
    }

    /// The chart of a member.
    pub(super) fn chart<Y>(&mut self, network: &Y, member: usize, at: &FrequencyPowers<S>) -> Option<Chart<S>>
    where
        Y: PlacedCharts<S>,
        S: Frequency<Y::Parameter>,
    {
        let (placement, all) = (network.placement(member), network.numbers());
        let (length, numbers) = (placement.length(), &all[member]);
        if !Y::Parameter::IS_ITS_WORDS || matches!(numbers, MemberNumbers::Other) {
            return network.chart(member, at, length);
        }
        // the numbers have the length rounded, the frequency may have more digits; a joint that lets go and one that does not tie have the
        // same numbers, and other freedoms
        let is_equal = |(other, other_length, _): &&(usize, S, Chart<S>)| {
            *other_length == length
                && all[*other] == *numbers
                && network.placement(*other).freedoms.is(placement.freedoms)
        };
        if let Some((_, _, chart)) = self.kept.iter().flatten().find(is_equal) {
            return Some(*chart);
        }
        let chart = network.chart(member, at, length)?;
        self.kept[self.next] = Some((member, length, chart));
        self.next = (self.next + 1) % KEPT;
        Some(chart)
    }
}

/// The freedoms of the parts of a member in its own axes, given those of each part.
pub(crate) fn together<Y: Placed>(
    system: &Y,
    parts: Range<usize>,
    of_part: impl Fn(&Placement<Y::Parameter>) -> Freedoms,
) -> Freedoms {
    let own = parts.map(|part| system.placement(part)).map(|part| freedoms_of_part(part.part(), of_part(part)));
    own.fold(Freedoms::NONE, Freedoms::union)
}
