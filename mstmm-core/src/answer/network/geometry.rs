//! How the numbers of a sketch change the dynamic work of a structure: places, directions, masses.

use crate::answer::network::states::PlaneStates;
use crate::model::MemberPlane;
use crate::number::{Frequency, Parameter, Scalar};
use crate::pass::network::vector::{Axes, Six, cross, difference, displacements, dot, moved, norm, rotations, sum};
use crate::pass::network::{
    Axis, NetworkSketch, NumberPlaces, Placed, SketchedMember, SketchedPlane, SketchedSkew, SketchedUp,
};

/// `∂L/∂(number)` for the numbers of a sketch, in their order.
struct Geometry<'g, S> {
    slopes: &'g mut [S],
    places: NumberPlaces,
}

impl<S: Scalar> Geometry<'_, S> {
    /// Adds to the numbers of a vector; in the plane it has two.
    fn add(&mut self, first: usize, terms: [S; 3]) {
        let own = &mut self.slopes[first..first + self.places.coordinates];
        own.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
    }

    /// Adds what the vector from one place to another adds; a motion of a path has no place.
    fn move_vector(&mut self, from: Option<usize>, to: Option<usize>, slopes: [S; 3]) {
        if let Some(to) = to {
            self.add(self.places.of_place(to), slopes);
        }
        if let Some(from) = from {
            self.add(self.places.of_place(from), slopes.map(|slope| -slope));
        }
    }
}

/// A vector times a number.
fn times<S: Scalar>(vector: [S; 3], factor: S) -> [S; 3] {
    vector.map(|part| part * factor)
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
    let mut geometry = Geometry { slopes, places: sketch.number_places() };
    for (member, (sketched, length)) in sketch.members.iter().zip(lengths).enumerate() {
        add_member(&mut geometry, sketch, (member, sketched), states, *length);
    }
    add_supports(&mut geometry, sketch, states, numbers);
    add_bodies(&mut geometry, sketch, states, numbers);
}

/// Adds a member, or a part of one: its length, its directions and where its ends are on their nodes.
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
        geometry.move_vector(from, to, times(placement.axes::<S>(0).along, length));
    }
    for (end, motion) in states.motion.members.as_ref()[member].iter().enumerate() {
        let joined = &sketched.ends[end];
        let node = sketch.node_of(joined);
        let of_node = states.motion.nodes.as_ref()[node];
        let at_end = moved(of_node, placement.offset(end));
        let forces = states.in_global_axes(member, end, motion.forces);
        let (force, moment) = (displacements(forces), rotations(forces));
        geometry.move_vector(sketch.nodes[node].place, sketch.place_of(joined), cross(force, rotations(of_node)));
        // a turn of the axes by dφ changes the work of the forces by `turn dφ`
        let turn = sum(cross(force, displacements(at_end)), cross(moment, rotations(at_end)));
        let (vector, axes) = (placement.vector::<S>(end), placement.axes::<S>(end));
        let slopes = by_direction(turn, vector, &axes, &placement.plane());
        match sketch.axis(sketched, end) {
            Axis::X | Axis::Y => {}
            Axis::Member => geometry.move_vector(from, to, slopes),
            Axis::FromTo(from, to) => geometry.move_vector(Some(from), Some(to), slopes),
            Axis::Along(direction) => geometry.add(geometry.places.of_direction(direction), slopes),
        }
        if let SketchedPlane::First(SketchedUp::Named(up)) | SketchedPlane::Second(SketchedUp::Named(up)) =
            sketched.plane
            && let Some(Raised { y_axis, across, .. }) = raised(&axes, &placement.plane())
        {
            let slopes = times(y_axis, -(dot(turn, axes.along) / across));
            geometry.add(geometry.places.of_direction(up), slopes);
        }
    }
}

/// The `up` of a part of a member in space.
struct Raised<S> {
    /// The y axis of the member.
    y_axis: [S; 3],
    /// The part of `up` along the member, and the size of that across it.
    along: S,
    across: S,
}

/// The `up` of a part that bends, or stretches and bends.
fn raised<T: Parameter, S: Frequency<T>>(axes: &Axes<S>, plane: &MemberPlane<T>) -> Option<Raised<S>> {
    let (up, y_axis) = match plane {
        MemberPlane::First(up) => (up, axes.across),
        MemberPlane::Second(up) => (up, axes.normal.map(|part| -part)),
        MemberPlane::Structure | MemberPlane::Along | MemberPlane::About => return None,
    };
    let up = up.map(S::from_parameter);
    let z_axis = cross(axes.along, y_axis);
    Some(Raised { y_axis, along: dot(up, axes.along), across: dot(up, z_axis) })
}

/// What the vector that gives an x axis adds by turning it, given `∂L/∂φ` of a turn of the axes: with e the axis, l the length of the vector, u and
/// v the parts of `up` along it and across it, `(turn × e + (u/v) (turn·e) y)/l`.
fn by_direction<T: Parameter, S: Frequency<T>>(
    turn: [S; 3],
    vector: [S; 3],
    axes: &Axes<S>,
    plane: &MemberPlane<T>,
) -> [S; 3] {
    let mut slopes = cross(turn, axes.along);
    if let Some(Raised { y_axis, along, across }) = raised(axes, plane) {
        slopes = sum(slopes, times(y_axis, dot(turn, axes.along) * along / across));
    }
    let size = norm(vector);
    slopes.map(|slope| slope / size)
}

/// Adds the directions of supports. Along a direction the motion of the node is that times a number; across it the reaction is.
fn add_supports<Y, S, const NODES: usize, const MEMBERS: usize>(
    geometry: &mut Geometry<'_, S>,
    sketch: &NetworkSketch<NODES, MEMBERS>,
    states: &PlaneStates<'_, Y, S>,
    numbers: &[f64],
) where
    Y: Placed,
    S: Frequency<Y::Parameter>,
{
    let reactions = states.reactions();
    for (node, sketched) in sketch.nodes.iter().enumerate() {
        let Some(skew) = sketched.skew else { continue };
        let direction: [S; 3] = sketch.direction(numbers, skew.direction()).map(S::from_f64);
        let (motion, reaction) =
            (displacements(states.motion.nodes.as_ref()[node]), displacements(reactions.as_ref()[node]));
        let square = dot(direction, direction);
        let slopes = match skew {
            SketchedSkew::Along(_) => times(reaction, dot(motion, direction) / square),
            SketchedSkew::Normal(_) => times(motion, -(dot(reaction, direction) / square)),
        };
        geometry.add(geometry.places.of_direction(skew.direction()), slopes);
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
    let (square, places) = (states.x.lambda_squared(), geometry.places);
    for (index, body) in sketch.bodies.iter().enumerate() {
        let mass = S::from_f64(numbers[places.of_body(index)]);
        let node = states.motion.nodes.as_ref()[body.node];
        let place = sketch.nodes[body.node].place;
        let position = states.system.node(body.node).0.position.map(S::from_parameter);
        // a mass on a path has no place: it moves as its node does
        let centre: [S; 3] = sketch.centre(numbers, index).map(S::from_f64);
        let to_centre = if place.is_some() { difference(position, centre) } else { [S::zero(); 3] };
        let at_centre = moved(node, to_centre);
        let slopes = times(cross(displacements(at_centre), rotations(at_centre)), square * mass);
        geometry.move_vector(place, None, slopes);
        geometry.add(places.of_centre(index), slopes);
        let (by_mass, by_inertia) = body_slopes(square, at_centre);
        geometry.slopes[places.of_body(index)] = by_mass;
        for (entry, slope) in by_inertia.into_iter().enumerate() {
            if let Some(place) = places.of_entry(index, entry) {
                geometry.slopes[place] = slope;
            }
        }
    }
}

/// `∂L/∂m` and `∂L/∂J` for the entries xx, yy, zz, xy, yz and zx of the inertia of a body, given λ² and the displacements of its mass centre.
pub(crate) fn body_slopes<S: Scalar>(square: S, centre: Six<S>) -> (S, [S; 6]) {
    let half = S::from_f64(0.5) * square;
    let (moved, [x, y, z]) = (displacements(centre), rotations(centre));
    (
        half * dot(moved, moved),
        [half * x * x, half * y * y, half * z * z, square * x * y, square * y * z, square * z * x],
    )
}
