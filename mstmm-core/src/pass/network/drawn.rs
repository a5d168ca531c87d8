//! What is drawn of a network: points, members, bodies and supports, each with its name and its coordinates.

use crate::element::{MemberElement, MemberNumbers};
use crate::model::{MemberEnd, MemberLabel, MemberPlane, PlanePoint, Skew, Spot, plain};
use crate::number::{Parameter, Real};
use crate::pass::network::memory::Memory;
use crate::pass::network::placed::{Placed, together};
use crate::pass::network::placed_node::PlacedNode;
use crate::pass::network::placement::Placement;
use crate::pass::network::sketch::{NetworkSketch, Seat, SketchedEnd};
use crate::pass::network::structure::{InNetwork, Network};
use core::ops::Range;
use mstmm_plan::Freedoms;

/// A network of which a [`Sketch`](crate::Sketch) tells what is where.
pub trait Drawn: Placed {
    /// Whether its points have three coordinates.
    const IS_IN_SPACE: bool = false;

    /// The points.
    fn points(&self) -> impl Iterator<Item = DrawnPoint<Self::Model, Self::Parameter>>;

    /// The members.
    fn members(&self) -> impl Iterator<Item = DrawnMember<Self::Model, Self::Parameter>>;

    /// The bodies.
    fn bodies(&self) -> impl Iterator<Item = DrawnBody<Self::Parameter>>;

    /// The supports.
    fn supports(&self) -> impl Iterator<Item = DrawnSupport<Self::Parameter>>;
}

/// A point with a place in a model `M`; of a list each node.
pub struct DrawnPoint<M, T> {
    /// What errors call it.
    pub name: Spot,
    /// Its coordinates \[m\]; those that the model has not got are zero.
    pub position: [T; 3],
    /// Index of the node that it moves with; a rigid body and all points that it ties are one.
    pub node: usize,
    /// The freedoms that elements bring there.
    pub freedoms: Freedoms,
    /// The point as motions are asked about it.
    pub label: PlanePoint<M>,
}

/// A member of a model `M`: an element with extent, a joint, an element of a path, or where a path acts on a point.
pub struct DrawnMember<M, T> {
    /// What errors call it.
    pub name: Spot,
    /// The name of its type, such as `GeneralBeam`, or the keyword of a joint that has none, such as `pin`; `tie` where the motion of a path is
    /// that of a point in a direction; of a list what errors call its element.
    pub kind: &'static str,
    /// The freedoms in which it acts at its ends, in its own axes: X along it.
    pub freedoms: Freedoms,
    /// Its own axes x, y and z, of length 1 each; none of what acts along one axis of space alone, and where there is no direction.
    pub axes: Option<[[T; 3]; 3]>,
    /// Its bending stiffness EI [N m²]: of a tapered beam the value at its input end, in space the larger of both. An element that does not bend
    /// has zero.
    pub bending_stiffness: f64,
    /// Its input end and its output end.
    pub ends: [DrawnEnd<M, T>; 2],
    /// The member as motions are asked about it.
    pub label: MemberLabel<M, ()>,
}

/// An end of a member of a model `M`.
pub struct DrawnEnd<M, T> {
    /// Index of its point in the order of the points; none at a motion of a path, which has no place.
    pub point: Option<usize>,
    /// Its coordinates \[m\]; in a list they may be others than those of its point, which ties it rigidly.
    pub position: Option<[T; 3]>,
    /// The direction in which a spring, a damper or a joint has its x axis here, of any length, in space that of an axis of rotation, too;
    /// none where that is the one from the input end to the output end.
    pub along: Option<[T; 3]>,
    /// The freedoms that it does not share with its point, in the axes of the member.
    pub released: Freedoms,
    /// Index of its node.
    pub node: usize,
    /// Whether its node is at rest.
    pub rests: bool,
    /// The end as motions are asked about it.
    pub label: MemberEnd<M>,
}

/// A rigid body, or a mass at a point or of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnBody<T> {
    /// What errors call it.
    pub name: Spot,
    /// Mass \[kg\].
    pub mass: T,
    /// Moment of inertia about an axis along z through the mass centre [kg m²].
    pub inertia: T,
    /// The mass centre \[m\]; none of a mass of a path.
    pub centre: Option<[T; 3]>,
    /// Index of the node that it moves with.
    pub node: usize,
}

/// A support of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnSupport<T> {
    /// What errors call it.
    pub name: Spot,
    /// Index of its point in the order of the points.
    pub point: usize,
    /// The coordinates of its point \[m\].
    pub position: [T; 3],
    /// The freedoms that it holds.
    pub held: Freedoms,
    /// The direction along which the point moves, held across it besides, or across which it moves, held along it; of any length.
    pub skew: Option<Skew<T>>,
}

plain!(DrawnPoint<M, T: Parameter>, name, position, node, freedoms, label);
plain!(DrawnMember<M, T: Parameter>, name, kind, freedoms, axes, bending_stiffness, ends, label);
plain!(DrawnEnd<M, T: Parameter>, point, position, along, released, node, rests, label);

impl<M, T: Real> DrawnEnd<M, T> {
    /// The end of a member, given the index of its point, if it has one.
    pub(crate) fn of(placement: &Placement<T>, label: MemberLabel<M, ()>, end: usize, point: Option<usize>) -> Self {
        let turns_in_plane = placement.freedoms.is(Freedoms::RZ) && placement.plane() == MemberPlane::Structure;
        let has_direction = point.is_some() && !turns_in_plane;
        DrawnEnd {
            point,
            position: point.map(|_| placement.place_of(end)),
            along: placement.along(end).filter(|_| has_direction),
            released: placement.released(end),
            node: placement.node_of(end),
            rests: placement.rests(end),
            label: if end == 0 { label.input() } else { label.output() },
        }
    }
}

/// The largest bending stiffness of the parts of a member.
pub(crate) fn stiffest(numbers: &[MemberNumbers], parts: Range<usize>) -> f64 {
    numbers.get(parts).into_iter().flatten().map(MemberNumbers::bending_stiffness).fold(0.0, f64::max)
}

impl<const NODES: usize, const MEMBERS: usize> NetworkSketch<NODES, MEMBERS> {
    /// The points, with the list of numbers.
    pub fn drawn_points<M, T: Parameter>(&self, list: &[f64]) -> impl Iterator<Item = DrawnPoint<M, T>> {
        let numbers = self.numbers(list);
        self.points.iter().enumerate().map(move |(index, point)| DrawnPoint {
            name: Spot::Named(point.name),
            position: numbers.place(point.place),
            node: point.node,
            freedoms: point.freedoms,
            label: self.label(index),
        })
    }

    /// The members where they are placed, but for second supports of bodies.
    pub fn drawn_members<Y: Placed>(&self, system: &Y) -> impl Iterator<Item = DrawnMember<Y::Model, Y::Parameter>> {
        let point = |end: &SketchedEnd| match end.seat {
            Seat::Point(point) => Some(point),
            Seat::Node(_) => None,
        };
        let first = self.members.iter().enumerate().filter(|(_, member)| !member.is_further);
        first.filter_map(move |(index, member)| {
            let (placement, parts) = (system.placement(index), self.parts(index));
            let label = MemberLabel::member(index);
            let ends = [0, 1].map(|end| {
                let released = together(system, parts.clone(), |part| part.released(end));
                DrawnEnd { released, ..DrawnEnd::of(placement, label, end, point(&member.ends[end])) }
            });
            let (freedoms, axes) = (together(system, parts.clone(), |part| part.freedoms), placement.drawn_axes());
            let (name, bending_stiffness) = (Spot::Named(member.name), stiffest(system.numbers(), parts));
            Some(DrawnMember { name, kind: member.kind?, freedoms, axes, bending_stiffness, ends, label })
        })
    }

    /// The bodies, with the list of numbers.
    pub fn drawn_bodies<T: Parameter>(&self, list: &[f64]) -> impl Iterator<Item = DrawnBody<T>> {
        let numbers = self.numbers(list);
        self.bodies.iter().enumerate().map(move |(index, body)| {
            let (mass, [.., inertia, _, _, _]) = (numbers.mass(index), numbers.inertia(index));
            let centre = self.nodes[body.node].place.map(|_| numbers.centre(index));
            DrawnBody { name: Spot::Named(body.name), mass, inertia, centre, node: body.node }
        })
    }

    /// The supports, with the list of numbers.
    pub fn drawn_supports<T: Parameter>(&self, list: &[f64]) -> impl Iterator<Item = DrawnSupport<T>> {
        let numbers = self.numbers(list);
        self.supports.iter().map(move |support| DrawnSupport {
            name: Spot::Named(support.name),
            point: support.point,
            position: numbers.place(self.points[support.point].place),
            held: support.held,
            skew: support.skew.map(|skew| self.skew(skew, &numbers)),
        })
    }
}

impl<E: MemberElement, M: Memory> Drawn for Network<E, M> {
    fn points(&self) -> impl Iterator<Item = DrawnPoint<InNetwork, E::Parameter>> {
        self.nodes().iter().enumerate().map(|(index, node)| DrawnPoint {
            name: Spot::Node(index),
            position: node.position,
            node: index,
            freedoms: Freedoms::PLANE,
            label: PlanePoint::node(index),
        })
    }

    fn members(&self) -> impl Iterator<Item = DrawnMember<InNetwork, E::Parameter>> {
        self.kinds().iter().enumerate().map(|(index, kind)| {
            let (placement, label) = (self.placement(index), MemberLabel::member(index));
            let ends = [0, 1].map(|end| DrawnEnd::of(placement, label, end, Some(placement.node_of(end))));
            let (freedoms, axes) = (placement.freedoms, placement.drawn_axes());
            let bending_stiffness = stiffest(self.numbers(), index..index + 1);
            DrawnMember { name: Spot::Member(index), kind, freedoms, axes, bending_stiffness, ends, label }
        })
    }

    fn bodies(&self) -> impl Iterator<Item = DrawnBody<E::Parameter>> {
        let with_body = self.nodes().iter().enumerate().filter(|(_, node)| node.has_body());
        with_body.map(|(index, node)| DrawnBody {
            name: Spot::Node(index),
            mass: node.mass,
            inertia: node.about_z(),
            centre: Some(node.centre),
            node: index,
        })
    }

    fn supports(&self) -> impl Iterator<Item = DrawnSupport<E::Parameter>> {
        let held = |node: &PlacedNode<_>| node.held.intersection(Freedoms::PLANE);
        let is_held = move |node: &PlacedNode<_>| !held(node).is_empty() || node.skew.is_some();
        self.nodes().iter().enumerate().filter(move |(_, node)| is_held(node)).map(move |(index, node)| DrawnSupport {
            name: Spot::Node(index),
            point: index,
            position: node.position,
            held: held(node),
            skew: node.skew,
        })
    }
}
