//! The nodes of a sketched network and the placements of its members, with numbers.

use crate::element::{Element, build};
use crate::model::{FrequencyEstimates, ParameterError, Requirement};
use crate::number::Real;
use crate::pass::network::member::{End, Placement};
use crate::pass::network::node::{Motions, Node};
use crate::pass::network::sketch::{Axis, NetworkSketch, SketchedEnd, SketchedMember};

/// The nodes of a network and the placements of its members; what the members are made of stands elsewhere.
#[derive(Clone, Debug)]
pub struct Skeleton<T, const NODES: usize, const MEMBERS: usize, const PLACES: usize> {
    places: [[T; 2]; PLACES],
    nodes: [Node<T>; NODES],
    motions: [Motions<T>; NODES],
    placements: [Placement<T>; MEMBERS],
}

impl<T: Real, const NODES: usize, const MEMBERS: usize, const PLACES: usize> Skeleton<T, NODES, MEMBERS, PLACES> {
    /// The skeleton of a sketch with its numbers.
    ///
    /// # Errors
    /// The error names the first place, direction or mass that is out of its range, or the first member with both ends at one place.
    pub fn new(sketch: &NetworkSketch<NODES, MEMBERS>, numbers: &[f64]) -> Result<Self, ParameterError> {
        let numbers = Numbers::of(sketch, numbers);
        numbers.check(sketch)?;
        let mut nodes = sketch.nodes.map(|node| {
            let own = Node::at(numbers.place(node.place)).held(node.held);
            node.along.map_or(own, |direction| own.along(numbers.direction(direction)))
        });
        for (body, &[mass, inertia, x, y]) in sketch.bodies.iter().zip(numbers.bodies) {
            let [mass, inertia, x, y] = [mass, inertia, x, y].map(T::from_f64);
            nodes[body.node] = nodes[body.node].and_body(mass, inertia, [x, y]);
        }
        let motions = nodes.each_ref().map(Motions::of);
        let mut placements = [Placement::nowhere(); MEMBERS];
        for (placement, member) in placements.iter_mut().zip(&sketch.members) {
            let ends = [0, 1].map(|k| numbers.end(&member.ends[k], &sketch.nodes[member.ends[k].node].place));
            let [from, to] = [0, 1].map(|k| member.ends[k].node);
            let at_nodes = ([&nodes[from], &nodes[to]], [&motions[from], &motions[to]]);
            *placement = Placement::new(member.freedoms, [&ends[0], &ends[1]], at_nodes.0, at_nodes.1);
            numbers.check_distance(member, placement.own_length().to_f64(), sketch.places)?;
        }
        let places = core::array::from_fn(|place| numbers.place(Some(place)));
        Ok(Skeleton { places, nodes, motions, placements })
    }

    /// The length of a member.
    pub fn length(&self, member: usize) -> T {
        self.placements[member].own_length()
    }

    /// Adds the bodies to the estimates from which searches take their first steps.
    pub fn estimate(&self, estimates: &mut FrequencyEstimates) {
        estimate_nodes(&self.nodes, estimates);
    }
}

impl<T: Copy, const NODES: usize, const MEMBERS: usize, const PLACES: usize> Skeleton<T, NODES, MEMBERS, PLACES> {
    /// A place.
    pub fn place(&self, place: usize) -> [T; 2] {
        self.places[place]
    }

    /// A node and its motions.
    pub fn node(&self, node: usize) -> (&Node<T>, &Motions<T>) {
        (&self.nodes[node], &self.motions[node])
    }

    /// Where a member stands.
    pub fn placement(&self, member: usize) -> &Placement<T> {
        &self.placements[member]
    }
}

/// Adds bodies to the estimates: a loop, which would stand in line for each number of nodes.
fn estimate_nodes<T: Real>(nodes: &[Node<T>], estimates: &mut FrequencyEstimates) {
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

/// Adds a member to the estimates from which searches take their first steps: a call, as `build_member` is.
#[inline(never)]
pub fn estimate_member<E: Element>(built: &E::Built, estimates: &mut FrequencyEstimates) {
    E::estimate(built, estimates);
}

/// The numbers of a sketch.
struct Numbers<'a> {
    places: &'a [[f64; 2]],
    directions: &'a [[f64; 2]],
    bodies: &'a [[f64; 4]],
}

impl<'a> Numbers<'a> {
    fn of<const NODES: usize, const MEMBERS: usize>(
        sketch: &NetworkSketch<NODES, MEMBERS>,
        numbers: &'a [f64],
    ) -> Self {
        let (places, rest) = numbers.split_at(2 * sketch.places.len());
        let (directions, rest) = rest.split_at(2 * sketch.directions.len());
        let bodies = rest.split_at(4 * sketch.bodies.len()).0;
        Numbers { places: places.as_chunks().0, directions: directions.as_chunks().0, bodies: bodies.as_chunks().0 }
    }

    /// Checks all of them, in their order.
    fn check<const NODES: usize, const MEMBERS: usize>(
        &self,
        sketch: &NetworkSketch<NODES, MEMBERS>,
    ) -> Result<(), ParameterError> {
        let check = |name: &'static str, parameter, value: f64, requirement: Requirement| {
            requirement.check(parameter, value).map_err(|error| error.of(name))
        };
        for (name, [x, y]) in sketch.places.iter().zip(self.places) {
            check(name, "x", *x, Requirement::Finite)?;
            check(name, "y", *y, Requirement::Finite)?;
        }
        for (name, [x, y]) in sketch.directions.iter().zip(self.directions) {
            let wrong = if x.is_finite() { *y } else { *x };
            let size = if wrong.is_finite() { x.abs().max(y.abs()) } else { wrong };
            check(name, "along", size, Requirement::Direction)?;
        }
        for (body, [mass, inertia, x, y]) in sketch.bodies.iter().zip(self.bodies) {
            check(body.name, "mass", *mass, Requirement::NonNegative)?;
            check(body.name, "inertia", *inertia, Requirement::NonNegative)?;
            check(body.name, "centre", *x, Requirement::Finite)?;
            check(body.name, "centre", *y, Requirement::Finite)?;
        }
        Ok(())
    }

    /// Checks that a member whose direction leads from one place to another has two of them.
    fn check_distance(
        &self,
        member: &SketchedMember,
        length: f64,
        places: &[&'static str],
    ) -> Result<(), ParameterError> {
        let [from, to] = &member.ends;
        let (distance, ends) = match (from.axis, to.axis) {
            (Axis::FromTo(from, to), _) | (_, Axis::FromTo(from, to)) => {
                let [[x, y], [to_x, to_y]] = [self.places[from], self.places[to]];
                ((to_x - x).abs().max((to_y - y).abs()), [Some(from), Some(to)])
            }
            (Axis::Member, _) => (length, [from.place, to.place]),
            _ => return Ok(()),
        };
        let [from, to] = ends.map(|place| place.map_or("a point", |place| places[place]));
        Requirement::Apart { from, to }.check("length", distance).map_err(|error| error.of(member.name))
    }

    /// The coordinates of a place, and of a motion of a path any.
    fn place<T: Real>(&self, place: Option<usize>) -> [T; 2] {
        place.map_or([T::zero(); 2], |place| self.places[place].map(T::from_f64))
    }

    fn direction<T: Real>(&self, direction: usize) -> [T; 2] {
        self.directions[direction].map(T::from_f64)
    }

    /// The end of a member, whose node has a place.
    fn end<T: Real>(&self, end: &SketchedEnd, own: &Option<usize>) -> End<T> {
        let along = match end.axis {
            Axis::Member => None,
            Axis::X => Some([T::one(), T::zero()]),
            Axis::Y => Some([T::zero(), T::one()]),
            Axis::Along(direction) => Some(self.direction(direction)),
            Axis::FromTo(from, to) => {
                let [[x, y], [to_x, to_y]] = [from, to].map(|place| self.place::<T>(Some(place)));
                Some([to_x - x, to_y - y])
            }
        };
        let position = if end.place == *own { None } else { Some(self.place(end.place)) };
        End { position, along, ..End::of(end.node) }
    }
}
