//! The numbers of a sketch, and their ranges.

use crate::model::{ParameterError, Requirement};
use crate::number::Parameter;
use crate::pass::network::node::in_space;
use crate::pass::network::sketch::{Axis, NetworkSketch, SketchedMember};

/// The numbers of a sketch by what they are: places, directions, and mass, inertia and mass centre of bodies.
pub(super) struct Numbers<'a> {
    places: &'a [[f64; 2]],
    directions: &'a [[f64; 2]],
    bodies: &'a [[f64; 4]],
}

impl<const NODES: usize, const MEMBERS: usize> NetworkSketch<NODES, MEMBERS> {
    /// The numbers at the beginning of a list.
    pub(super) fn numbers<'a>(&self, list: &'a [f64]) -> Numbers<'a> {
        let (places, rest) = list.split_at(2 * self.places.len());
        let (directions, rest) = rest.split_at(2 * self.directions.len());
        let bodies = rest.split_at(4 * self.bodies.len()).0;
        Numbers { places: places.as_chunks().0, directions: directions.as_chunks().0, bodies: bodies.as_chunks().0 }
    }

    /// The coordinates of a place in space, from the list of numbers.
    pub fn place<T: Parameter>(&self, list: &[f64], place: usize) -> [T; 3] {
        in_space(self.numbers(list).place(place))
    }
}

impl Numbers<'_> {
    /// The coordinates of a place.
    pub(super) fn place<T: Parameter>(&self, place: usize) -> [T; 2] {
        self.places[place].map(T::from_f64)
    }

    /// The parts of a direction.
    pub(super) fn direction<T: Parameter>(&self, direction: usize) -> [T; 2] {
        self.directions[direction].map(T::from_f64)
    }

    /// Mass, inertia and the coordinates of the mass centre of a body.
    pub(super) fn body<T: Parameter>(&self, body: usize) -> [T; 4] {
        self.bodies[body].map(T::from_f64)
    }

    /// Checks all of them, in their order.
    pub(super) fn check<const NODES: usize, const MEMBERS: usize>(
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
    pub(super) fn check_distance<const NODES: usize, const MEMBERS: usize>(
        &self,
        sketch: &NetworkSketch<NODES, MEMBERS>,
        member: &SketchedMember,
        length: f64,
    ) -> Result<(), ParameterError> {
        let [from, to] = &member.ends;
        let (distance, ends) = match (member.axis(0), member.axis(1)) {
            (Axis::FromTo(from, to), _) | (_, Axis::FromTo(from, to)) => {
                let [[x, y], [to_x, to_y]] = [self.places[from], self.places[to]];
                ((to_x - x).abs().max((to_y - y).abs()), [Some(from), Some(to)])
            }
            (Axis::Member, _) => (length, [from, to].map(|end| sketch.place_of(end))),
            _ => return Ok(()),
        };
        let [from, to] = ends.map(|place| place.map_or("a point", |place| sketch.places[place]));
        Requirement::Apart { from, to }.check("length", distance).map_err(|error| error.of(member.name))
    }
}
