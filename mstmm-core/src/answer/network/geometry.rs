//! How the numbers of a sketch change the dynamic work of a plane structure: places, directions, masses.

use crate::answer::network::states::PlaneStates;
use crate::number::{Frequency, Scalar};
use crate::pass::network::vector::{Six, displacements, moved, rotations};
use crate::pass::network::{Axis, NetworkSketch, Placed, SketchedMember};

/// `∂L/∂(number)` for the numbers of a sketch, in their order.
pub(super) struct Geometry<'g, S> {
    places: &'g mut [[S; 2]],
    directions: &'g mut [[S; 2]],
    /// Mass, inertia and mass centre.
    bodies: &'g mut [[S; 4]],
}

impl<'g, S: Scalar> Geometry<'g, S> {
    /// Zeros, in memory of so many numbers as the sketch has.
    fn of<const NODES: usize, const MEMBERS: usize>(
        sketch: &NetworkSketch<NODES, MEMBERS>,
        slopes: &'g mut [S],
    ) -> Self {
        let (places, rest) = slopes.split_at_mut(2 * sketch.places.len());
        let (directions, rest) = rest.split_at_mut(2 * sketch.directions.len());
        let bodies = &mut rest[..4 * sketch.bodies.len()];
        Geometry {
            places: places.as_chunks_mut().0,
            directions: directions.as_chunks_mut().0,
            bodies: bodies.as_chunks_mut().0,
        }
    }

    /// Adds what a place adds where it moves one thing away from another: the end of a member, or a mass centre, from its node.
    fn move_apart(&mut self, place: Option<usize>, node: Option<usize>, slopes: [S; 2]) {
        if let Some(place) = place {
            add(&mut self.places[place], slopes);
        }
        if let Some(node) = node {
            add(&mut self.places[node], slopes.map(|slope| -slope));
        }
    }

    /// Adds what the vector from one place to another adds.
    fn move_vector(&mut self, from: Option<usize>, to: Option<usize>, slopes: [S; 2]) {
        self.move_apart(to, from, slopes);
    }
}

fn add<S: Scalar>(sum: &mut [S; 2], terms: [S; 2]) {
    for (sum, term) in sum.iter_mut().zip(terms) {
        *sum += term;
    }
}

/// Fills memory with the slopes of the dynamic work in the numbers of a sketch, given those in the lengths of members.
pub fn geometry_slopes<Y, S, const NODES: usize, const MEMBERS: usize>(
    sketch: &NetworkSketch<NODES, MEMBERS>,
    states: &PlaneStates<'_, Y, S>,
    numbers: &[f64],
    lengths: &[S],
    slopes: &mut [S],
) where
    Y: Placed,
    S: Frequency<Y::Parameter>,
{
    let mut geometry = Geometry::of(sketch, slopes);
    for (member, (sketched, length)) in sketch.members.iter().zip(lengths).enumerate() {
        add_member(&mut geometry, sketch, (member, sketched), states, *length);
    }
    add_supports(&mut geometry, sketch, states);
    add_bodies(&mut geometry, sketch, states, numbers);
}

/// Adds a member: its length, its directions and where its ends are on their nodes.
fn add_member<Y, S, const NODES: usize, const MEMBERS: usize>(
    geometry: &mut Geometry<'_, S>,
    sketch: &NetworkSketch<NODES, MEMBERS>,
    (member, sketched): (usize, &SketchedMember),
    states: &PlaneStates<'_, Y, S>,
    length: S,
) where
    Y: Placed,
    S: Frequency<Y::Parameter>,
{
    let placement = states.system.placement(member);
    let [from, to] = sketched.ends.each_ref().map(|end| sketch.place_of(end));
    if !length.is_zero() {
        let [c, s, _] = placement.axes::<S>(0).along;
        geometry.move_vector(from, to, [c * length, s * length]);
    }
    for (end, motion) in states.motion.members.as_ref()[member].iter().enumerate() {
        let joined = &sketched.ends[end];
        let node = sketch.node_of(joined);
        let rotation = states.motion.nodes.as_ref()[node][2];
        // a spring knows nothing of what its node does across it
        let ([along, across, _], [fx, fy, _]) = (states.tied(member, end), motion.forces);
        let force = states.in_global_axes(member, end, motion.forces);
        let [place, of_node] = [sketch.place_of(joined), sketch.nodes[node].place];
        geometry.move_apart(place, of_node, [rotation * force[1], -(rotation * force[0])]);
        // a turn of the axes by dφ changes displacements along and across by their cross product with it
        let turn = fx * across - fy * along;
        let by_direction = |[x, y, _]: [S; 3]| {
            let square = x * x + y * y;
            [-(turn * y) / square, turn * x / square]
        };
        match sketched.axis(end) {
            Axis::X | Axis::Y => {}
            Axis::Member => geometry.move_vector(from, to, by_direction(placement.vector(end))),
            Axis::FromTo(from, to) => geometry.move_vector(Some(from), Some(to), by_direction(placement.vector(end))),
            Axis::Along(direction) => {
                add(&mut geometry.directions[direction], by_direction(placement.vector(end)));
            }
        }
    }
}

/// Adds the directions along which nodes move: each is the motion of its node by the force that holds it across.
fn add_supports<Y, S, const NODES: usize, const MEMBERS: usize>(
    geometry: &mut Geometry<'_, S>,
    sketch: &NetworkSketch<NODES, MEMBERS>,
    states: &PlaneStates<'_, Y, S>,
) where
    Y: Placed,
    S: Frequency<Y::Parameter>,
{
    let reactions = states.reactions();
    for (node, sketched) in sketch.nodes.iter().enumerate() {
        let (Some(direction), Some(skew)) = (sketched.along, states.system.node(node).0.skew) else { continue };
        let [x, y, _] = skew.direction().map(S::from_parameter);
        let [u, v, ..] = states.motion.nodes.as_ref()[node];
        let motion = (u * x + v * y) / (x * x + y * y);
        let [fx, fy, ..] = reactions.as_ref()[node];
        add(&mut geometry.directions[direction], [motion * fx, motion * fy]);
    }
}

/// Adds masses, inertias and mass centres.
fn add_bodies<Y, S, const NODES: usize, const MEMBERS: usize>(
    geometry: &mut Geometry<'_, S>,
    sketch: &NetworkSketch<NODES, MEMBERS>,
    states: &PlaneStates<'_, Y, S>,
    numbers: &[f64],
) where
    Y: Placed,
    S: Frequency<Y::Parameter>,
{
    let square = states.x.lambda_squared();
    let first = 2 * (sketch.places.len() + sketch.directions.len());
    for (index, body) in sketch.bodies.iter().enumerate() {
        let [mass, _, x, y] = [0, 1, 2, 3].map(|k| S::from_f64(numbers[first + 4 * index + k]));
        let node = states.motion.nodes.as_ref()[body.node];
        let place = sketch.nodes[body.node].place;
        let position = states.system.node(body.node).0.position.map(S::from_parameter);
        // a mass on a path has no place: it moves as its node does
        let zero = S::zero();
        let to_centre = if place.is_some() { [x - position[0], y - position[1], zero] } else { [zero; 3] };
        let centre @ [at_x, at_y, rotation, ..] = moved(node, to_centre);
        let slopes = [square * mass * rotation * at_y, -(square * mass * rotation * at_x)];
        geometry.move_apart(None, place, slopes);
        let [by_mass, by_inertia] = body_slopes(square, centre);
        geometry.bodies[index] = [by_mass, by_inertia, slopes[0], slopes[1]];
    }
}

/// `∂L/∂m` and `∂L/∂J`, J about z, of a body, given λ² and the displacements of its mass centre.
pub(crate) fn body_slopes<S: Scalar>(square: S, centre: Six<S>) -> [S; 2] {
    let half = S::from_f64(0.5) * square;
    let [x, y, z] = displacements(centre);
    let [.., rotation] = rotations(centre);
    [half * (x * x + y * y + z * z), half * rotation * rotation]
}
