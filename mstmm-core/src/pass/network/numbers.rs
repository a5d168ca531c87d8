//! The numbers of a sketch, and their ranges.

use crate::model::{InvalidParameter, ParameterError, Requirement, Tensor, definite, least_moment};
use crate::number::Parameter;
use crate::pass::network::sketch::{Axis, NetworkSketch, SketchedMember};

/// The numbers of a sketch by what they are: places, directions, and mass, inertia and mass centre of bodies.
pub(super) struct Numbers<'a> {
    list: &'a [f64],
    places: NumberPlaces,
}

/// Where the numbers of a sketch stand in their list.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NumberPlaces {
    /// The number of coordinates of a place.
    pub(crate) coordinates: usize,
    /// The number of entries of an inertia.
    pub(crate) entries: usize,
    /// The places of the first direction and of the first body.
    first_direction: usize,
    first_body: usize,
}

impl NumberPlaces {
    /// The place of the first coordinate of a place.
    pub(crate) fn of_place(&self, place: usize) -> usize {
        self.coordinates * place
    }

    /// The place of the first part of a direction.
    pub(crate) fn of_direction(&self, direction: usize) -> usize {
        self.first_direction + self.coordinates * direction
    }

    /// The place of the mass of a body, which its inertia and its mass centre follow.
    pub(crate) fn of_body(&self, body: usize) -> usize {
        self.first_body + (1 + self.entries + self.coordinates) * body
    }

    /// The place of an entry xx, yy, zz, xy, yz or zx of the inertia of a body; none where it is zero.
    pub(crate) fn of_entry(&self, body: usize, entry: usize) -> Option<usize> {
        let own = if self.entries == 1 { (entry == ABOUT_Z).then_some(0) } else { Some(entry) };
        own.map(|own| self.of_body(body) + 1 + own)
    }

    /// The place of the first coordinate of the mass centre of a body.
    pub(crate) fn of_centre(&self, body: usize) -> usize {
        self.of_body(body) + 1 + self.entries
    }
}

/// The entry of a tensor that is the moment of inertia of a body in the plane.
const ABOUT_Z: usize = 2;

impl<const NODES: usize, const MEMBERS: usize> NetworkSketch<NODES, MEMBERS> {
    /// Where its numbers stand in their list.
    pub(crate) fn number_places(&self) -> NumberPlaces {
        let [coordinates, entries] = if self.is_in_space { [3, 6] } else { [2, 1] };
        let first_direction = coordinates * self.places.len();
        let first_body = first_direction + coordinates * self.directions.len();
        NumberPlaces { coordinates, entries, first_direction, first_body }
    }

    /// The numbers at the beginning of a list.
    pub(super) fn numbers<'a>(&self, list: &'a [f64]) -> Numbers<'a> {
        Numbers { list, places: self.number_places() }
    }

    /// The coordinates of a place in space, from the list of numbers.
    pub fn place<T: Parameter>(&self, list: &[f64], place: usize) -> [T; 3] {
        self.numbers(list).place(place)
    }

    /// The parts of a direction.
    pub(crate) fn direction(&self, list: &[f64], direction: usize) -> [f64; 3] {
        self.numbers(list).direction(direction)
    }

    /// The mass centre of a body.
    pub(crate) fn centre(&self, list: &[f64], body: usize) -> [f64; 3] {
        self.numbers(list).centre(body)
    }
}

impl Numbers<'_> {
    /// The coordinates from a place in the list on; in the plane z is zero.
    fn vector(&self, first: usize) -> [f64; 3] {
        let mut vector = [0.0; 3];
        vector.iter_mut().zip(&self.list[first..first + self.places.coordinates]).for_each(|(own, part)| *own = *part);
        vector
    }

    /// The coordinates of a place.
    pub(super) fn place<T: Parameter>(&self, place: usize) -> [T; 3] {
        self.vector(self.places.of_place(place)).map(T::from_f64)
    }

    /// The parts of a direction.
    pub(super) fn direction<T: Parameter>(&self, direction: usize) -> [T; 3] {
        self.vector(self.places.of_direction(direction)).map(T::from_f64)
    }

    /// The mass of a body.
    pub(super) fn mass<T: Parameter>(&self, body: usize) -> T {
        T::from_f64(self.list[self.places.of_body(body)])
    }

    /// The inertia of a body, with what rounding of its entries needs to be definite.
    pub(super) fn inertia<T: Parameter>(&self, body: usize) -> Tensor<T> {
        let entries = self.entries(body);
        definite(entries).unwrap_or(entries).map(T::from_f64)
    }

    /// The inertia of a body as it is given.
    fn entries(&self, body: usize) -> Tensor<f64> {
        core::array::from_fn(|entry| self.places.of_entry(body, entry).map_or(0.0, |place| self.list[place]))
    }

    /// The coordinates of the mass centre of a body.
    pub(super) fn centre<T: Parameter>(&self, body: usize) -> [T; 3] {
        self.vector(self.places.of_centre(body)).map(T::from_f64)
    }

    /// Checks all of them, in their order.
    pub(super) fn check<const NODES: usize, const MEMBERS: usize>(
        &self,
        sketch: &NetworkSketch<NODES, MEMBERS>,
    ) -> Result<(), ParameterError> {
        let check = |name: &'static str, parameter, value: f64, requirement: Requirement| {
            requirement.check(parameter, value).map_err(|error| error.of(name))
        };
        for (place, name) in sketch.places.iter().enumerate() {
            for (part, value) in ["x", "y", "z"].into_iter().zip(self.place(place)) {
                check(name, part, value, Requirement::Finite)?;
            }
        }
        for (direction, of) in sketch.directions.iter().enumerate() {
            let parts: [f64; 3] = self.direction(direction);
            let wrong = parts.into_iter().find(|part| !part.is_finite());
            let size = wrong.unwrap_or_else(|| parts.into_iter().fold(0.0, |size, part| size.max(part.abs())));
            check(of.name, of.word, size, Requirement::Direction)?;
        }
        for (index, body) in sketch.bodies.iter().enumerate() {
            check(body.name, "mass", self.mass(index), Requirement::NonNegative)?;
            check_inertia(self.entries(index), sketch.is_in_space).map_err(|error| error.of(body.name))?;
            for part in self.centre(index) {
                check(body.name, "centre", part, Requirement::Finite)?;
            }
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
        let (distance, ends) = match (sketch.axis(member, 0), sketch.axis(member, 1)) {
            (Axis::FromTo(from, to), _) | (_, Axis::FromTo(from, to)) => {
                let [one, other]: [[f64; 3]; 2] = [from, to].map(|place| self.place(place));
                let apart = one.into_iter().zip(other).map(|(one, other)| (other - one).abs());
                (apart.fold(0.0, f64::max), [Some(from), Some(to)])
            }
            (Axis::Member, _) => (length, [from, to].map(|end| sketch.place_of(end))),
            _ => return Ok(()),
        };
        let [from, to] = ends.map(|place| place.map_or("a point", |place| sketch.places[place]));
        Requirement::Apart { from, to }.check("length", distance).map_err(|error| error.of(member.name))
    }
}

/// Checks the inertia of a body: about no axis it is negative.
fn check_inertia(entries: Tensor<f64>, is_in_space: bool) -> Result<(), InvalidParameter> {
    for moment in &entries[..3] {
        Requirement::NonNegative.check("inertia", *moment)?;
    }
    for product in &entries[3..] {
        Requirement::Finite.check("inertia", *product)?;
    }
    if !is_in_space || definite(entries).is_some() {
        return Ok(());
    }
    Requirement::LeastMoment.check("inertia", least_moment(entries))
}
