//! The nodes of a sketched network and the placements of its members, with numbers.

use crate::element::{Element, MemberNumbers, build};
use crate::model::{FrequencyEstimates, InvalidParameter, MemberPlane, ParameterError, Requirement, Skew, up_of};
use crate::number::{Parameter, Real};
use crate::pass::network::memory::Arrays;
use crate::pass::network::motions::Motions;
use crate::pass::network::numbers::Numbers;
use crate::pass::network::placed_node::PlacedNode;
use crate::pass::network::placement::{Placement, SpatialEnd};
use crate::pass::network::sketch::{Axis, NetworkSketch, SketchedMember, SketchedPlane, SketchedSkew, SketchedUp};
use crate::pass::network::stiffness::{StiffnessModel, StiffnessRoom};
use crate::pass::network::ties::tie;
use crate::pass::network::vector::difference;
use mstmm_plan::{Freedoms, NetworkOrder};

/// The nodes of a network and the placements of its members; what the members are made of stands elsewhere.
#[derive(Clone, Debug)]
pub struct Skeleton<T, const NODES: usize, const MEMBERS: usize> {
    nodes: [PlacedNode<T>; NODES],
    motions: [Motions<T>; NODES],
    placements: [Placement<T>; MEMBERS],
    /// Nodes and members in numbers, for searches at many frequencies at once.
    stiffness: StiffnessRoom<Arrays<0, NODES, MEMBERS>>,
}

impl<T: Real, const NODES: usize, const MEMBERS: usize> Skeleton<T, NODES, MEMBERS> {
    /// The skeleton of a sketch with its numbers.
    ///
    /// # Errors
    /// The error names the first place, direction or mass that is out of its range, or the first member with both ends at one place.
    pub fn new(sketch: &NetworkSketch<NODES, MEMBERS>, numbers: &[f64]) -> Result<Self, ParameterError> {
        let numbers = sketch.numbers(numbers);
        numbers.check(sketch)?;
        let mut nodes: [PlacedNode<T>; NODES] = core::array::from_fn(|node| placed_node(sketch, &numbers, node));
        for (index, body) in sketch.bodies.iter().enumerate() {
            let (mass, inertia, centre) = (numbers.mass(index), numbers.inertia(index), numbers.centre(index));
            nodes[body.node] = nodes[body.node].and_body(mass, inertia, centre);
        }
        let mut motions = nodes.each_ref().map(Motions::of);
        for (motions, node) in motions.iter_mut().zip(&sketch.nodes) {
            motions.is_of_path = node.place.is_none();
        }
        let mut placements = [Placement::nowhere(); MEMBERS];
        for (placement, member) in placements.iter_mut().zip(&sketch.members) {
            let ends = [0, 1].map(|end| joined(sketch, &numbers, member, end));
            let [from, to] = member.ends.each_ref().map(|end| sketch.node_of(end));
            let at_nodes = ([&nodes[from], &nodes[to]], [&motions[from], &motions[to]]);
            // a first placement tells where the member leads
            *placement = Placement::new((member.freedoms, MemberPlane::Structure), &ends, at_nodes.0, at_nodes.1);
            numbers.check_distance(sketch, member, placement.own_length().to_f64())?;
            let plane = plane(&numbers, member, placement.vector(0)).map_err(|error| error.of(member.name))?;
            if sketch.is_in_space {
                *placement = Placement::new((member.freedoms, plane), &ends, at_nodes.0, at_nodes.1);
            }
        }
        let mut stiffness = StiffnessRoom::new([NODES, MEMBERS]);
        for (index, (node, motions)) in nodes.iter().zip(&motions).enumerate() {
            stiffness.set_node(index, node, motions);
        }
        Ok(Skeleton { nodes, motions, placements, stiffness })
    }

    /// Describes a member: its numbers, and what it adds to the estimates from which searches take their first steps. A call, since a frame
    /// has hundreds of members and is built once.
    #[inline(never)]
    pub fn describe<E: Element>(&mut self, member: usize, built: &E::Built, estimates: &mut FrequencyEstimates) {
        E::estimate(built, estimates);
        self.stiffness.set_member(member, E::member_numbers(built), &self.placements[member]);
    }

    /// Arranges what searches evaluate at many frequencies, once all members are described.
    pub fn arrange(&mut self, order: &NetworkOrder<'_>) {
        self.stiffness.arrange(order);
        #[cfg(feature = "std")]
        self.stiffness.set_space(&self.nodes, &self.motions, &self.placements);
        tie(&mut self.motions, &mut self.placements, self.stiffness.numbers());
    }

    /// The length of a member.
    pub fn length(&self, member: usize) -> T {
        self.placements[member].own_length()
    }

    /// Whether all nodes and members move in one plane.
    pub fn is_flat(&self) -> bool {
        self.stiffness.is_flat()
    }

    /// Adds the bodies to the estimates from which searches take their first steps.
    pub fn estimate(&self, estimates: &mut FrequencyEstimates) {
        estimate_nodes(&self.nodes, estimates);
    }
}

impl<T: Copy, const NODES: usize, const MEMBERS: usize> Skeleton<T, NODES, MEMBERS> {
    /// A node and its motions.
    pub fn node(&self, node: usize) -> (&PlacedNode<T>, &Motions<T>) {
        (&self.nodes[node], &self.motions[node])
    }

    /// Where a member stands.
    pub fn placement(&self, member: usize) -> &Placement<T> {
        &self.placements[member]
    }

    /// The members in numbers.
    pub fn numbers(&self) -> &[MemberNumbers] {
        self.stiffness.numbers()
    }

    /// The network in numbers, given its order, if all of its members are known in numbers.
    pub fn in_numbers<'a>(&'a self, order: &NetworkOrder<'a>) -> Option<StiffnessModel<'a>> {
        self.stiffness.model(order)
    }
}

impl<const NODES: usize, const MEMBERS: usize> NetworkSketch<NODES, MEMBERS> {
    /// How a point moves where it does not along axes.
    pub(super) fn skew<T: Parameter>(&self, skew: SketchedSkew, numbers: &Numbers<'_>) -> Skew<T> {
        match (skew, numbers.direction::<T>(skew.direction())) {
            (SketchedSkew::Along(_), along) => Skew::Along(along),
            // the one direction of the plane across another one
            (SketchedSkew::Normal(_), [x, y, _]) if !self.is_in_space => Skew::Along([-y, x, T::zero()]),
            (SketchedSkew::Normal(_), normal) => Skew::Normal(normal),
        }
    }
}

/// A node with its place and what holds it, without its body.
fn placed_node<T: Real, const NODES: usize, const MEMBERS: usize>(
    sketch: &NetworkSketch<NODES, MEMBERS>,
    numbers: &Numbers<'_>,
    index: usize,
) -> PlacedNode<T> {
    let node = &sketch.nodes[index];
    // a motion of a path has any place
    let position = node.place.map_or([T::zero(); 3], |place| numbers.place(place));
    let skew = node.skew.map(|skew| sketch.skew(skew, numbers));
    PlacedNode { held: sketch.held(index), skew, ..PlacedNode::at(position) }
}

/// The plane of a member that leads along a vector.
fn plane<T: Real>(
    numbers: &Numbers<'_>,
    member: &SketchedMember,
    along: [T; 3],
) -> Result<MemberPlane<T>, InvalidParameter> {
    let turned = |up: SketchedUp| {
        let named = match up {
            SketchedUp::Named(direction) => Some(numbers.direction(direction)),
            SketchedUp::Z | SketchedUp::Any => None,
        };
        let chosen = up_of(along.map(T::to_f64), named, matches!(up, SketchedUp::Any));
        let refused = |value| InvalidParameter { parameter: "up", value, requirement: Requirement::Orientation };
        chosen.map(|up| up.map(T::from_f64)).map_err(refused)
    };
    Ok(match member.plane {
        SketchedPlane::Structure => MemberPlane::Structure,
        SketchedPlane::First(up) => MemberPlane::First(turned(up)?),
        SketchedPlane::Second(up) => MemberPlane::Second(turned(up)?),
        SketchedPlane::Twist => MemberPlane::About,
        SketchedPlane::OneMotion if member.freedoms.is(Freedoms::RZ) => MemberPlane::About,
        SketchedPlane::OneMotion => MemberPlane::Along,
    })
}

/// The end of a member, with numbers.
fn joined<T: Real, const NODES: usize, const MEMBERS: usize>(
    sketch: &NetworkSketch<NODES, MEMBERS>,
    numbers: &Numbers<'_>,
    member: &SketchedMember,
    end: usize,
) -> SpatialEnd<T> {
    let (node, place) = (sketch.node_of(&member.ends[end]), sketch.place_of(&member.ends[end]));
    let [x, y, z] = [0, 1, 2].map(|axis| [0, 1, 2].map(|part| if part == axis { T::one() } else { T::zero() }));
    let turns = matches!(member.plane, SketchedPlane::OneMotion) && member.freedoms.is(Freedoms::RZ);
    let along = match sketch.axis(member, end) {
        Axis::Member => None,
        Axis::X if turns => Some(z),
        Axis::X => Some(x),
        Axis::Y => Some(y),
        Axis::Along(direction) => Some(numbers.direction(direction)),
        Axis::FromTo(from, to) => Some(difference(numbers.place(from), numbers.place(to))),
    };
    let elsewhere = place.filter(|_| place != sketch.nodes[node].place);
    let place = elsewhere.map(|place| numbers.place(place));
    SpatialEnd { node, place, released: member.released, along }
}

/// Adds bodies to the estimates: a loop, which would stand in line for each number of nodes.
fn estimate_nodes<T: Real>(nodes: &[PlacedNode<T>], estimates: &mut FrequencyEstimates) {
    nodes.iter().for_each(|node| node.estimate(estimates));
}

/// Builds a member under its name in the model: a call, since a frame has hundreds of them and builds them once.
///
/// # Errors
/// The error names the member, the parameter and its value.
#[inline(never)]
pub fn build_member<E: Element>(element: E, name: &'static str) -> Result<E::Built, ParameterError> {
    build(element, name)
}
