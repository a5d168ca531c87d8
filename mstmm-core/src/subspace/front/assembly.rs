//! The assembly of a front: objects are joined at a node, whose motions replace the displacements of their ports.

use crate::number::{Scalar, Size};
use crate::subspace::front::chart::MOST_FREEDOMS;
use crate::subspace::front::eliminate::BOUND;
use crate::subspace::front::matrix::{Front, Variable};
use crate::subspace::front::objects::Objects;
use crate::subspace::front::pivot::After;
use crate::subspace::front::total::Total;
use core::ops::Range;

/// What a variable of an object becomes in the front of a node.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Role<S> {
    /// A port elsewhere, which stays on the boundary in a unit.
    Boundary(i32),
    /// The force at the node in a unit, which acts on its motions by coefficients.
    Force(i32, [S; MOST_FREEDOMS]),
    /// The displacement at the node, the sum of its motions with coefficients.
    Displacement([S; MOST_FREEDOMS]),
    /// A displacement in a unit that the node does not share.
    Released(i32),
    /// A force that the node does not take.
    Absent,
}

/// Where the variable of an object goes in the front.
#[derive(Clone, Copy)]
enum Target<S> {
    /// To a place, in a unit that shifts its row.
    Place(usize, i32),
    /// To the motions of the node.
    Motions([S; MOST_FREEDOMS]),
    Nowhere,
}

/// A node in whose front objects are joined.
pub(crate) struct Joint<'a, S, const W: usize> {
    /// Its motions.
    pub(crate) motions: &'a [Variable],
    /// The first object.
    pub(crate) from: usize,
    /// What becomes of the variables of the objects.
    pub(crate) roles: &'a [Role<S>; W],
}

impl<S: Scalar, const W: usize> Objects<S, W> {
    /// Lets the displacement of a variable become a force if its object is stiff in a unit of the node. Else the stiffness would be added
    /// to softer ones there.
    pub(crate) fn restrain(&mut self, place: usize, unit: i32, front: &mut Front<S, W>, total: &mut Total<S>) {
        let range = self.range(self.object_of(place));
        let own = self.entries[place][place - range.start].times_power_of_two(2 * self.variables[place].shift_to(unit));
        if own.size().first() > BOUND {
            self.flip(range, place, unit, front, total);
        }
    }

    /// Takes an object through a front of its own, in which all variables are on the boundary and one flips, in a unit.
    #[cold]
    fn flip(&mut self, range: Range<usize>, place: usize, unit: i32, front: &mut Front<S, W>, total: &mut Total<S>) {
        front.begin(0, range.len());
        for (k, row) in range.clone().enumerate() {
            front.variables[k] = self.variables[row];
            front.errors[k] = self.errors[row];
            front.entries[k][..range.len()].copy_from_slice(&self.entries[row][..range.len()]);
        }
        let own = place - range.start;
        let shift = front.variables[own].shift_to(unit);
        front.variables[own].unit = unit;
        for other in 0..range.len() {
            front.entries[own][other] = front.entries[own][other].times_power_of_two(shift);
        }
        for other in 0..range.len() {
            front.entries[other][own] = front.entries[other][own].times_power_of_two(shift);
        }
        front.pivot_on_one(own, After::Flips, total);
        self.put_back(range.start, front, 0);
    }
}

impl<S: Scalar, const W: usize> Front<S, W> {
    /// Joins the last objects at a node.
    pub(crate) fn join(&mut self, objects: &Objects<S, W>, joint: &Joint<'_, S, W>, total: &mut Total<S>) {
        let motions = joint.motions.len();
        let variables = objects.last(joint.from);
        let (mut interior, mut boundary) = (motions, 0);
        for role in &joint.roles[variables.clone()] {
            match role {
                Role::Boundary(_) => boundary += 1,
                Role::Force(..) | Role::Released(_) => interior += 1,
                Role::Displacement(_) => {}
                Role::Absent => total.count(1.0),
            }
        }
        self.begin(interior, interior + boundary);
        self.variables[..motions].copy_from_slice(joint.motions);
        let mut targets = [Target::Nowhere; W];
        let mut next = [motions, interior];
        for place in variables {
            let (kind, unit) = match joint.roles[place] {
                Role::Force(unit, _) | Role::Released(unit) => (0, unit),
                Role::Boundary(unit) => (1, unit),
                Role::Displacement(row) => {
                    targets[place] = Target::Motions(row);
                    if total.carries_errors {
                        for (motion, coefficient) in row.iter().enumerate().take(motions) {
                            let size = coefficient.size().first();
                            self.note_error(motion, objects.errors[place] * size * size);
                        }
                    }
                    continue;
                }
                Role::Absent => continue,
            };
            let at = next[kind];
            next[kind] += 1;
            let variable = &objects.variables[place];
            self.variables[at] = Variable { unit, measure: variable.measure.once_joined(), ..*variable };
            targets[place] = Target::Place(at, variable.shift_to(unit));
            if total.carries_errors {
                self.note_error(at, objects.errors[place].times_power_of_two(2 * variable.shift_to(unit)));
            }
            if let Role::Force(_, row) = joint.roles[place] {
                for (motion, coefficient) in row.iter().enumerate().take(motions) {
                    self.add(at, motion, *coefficient);
                }
            }
        }
        for object in joint.from..objects.len() {
            self.add_object(objects, object, &targets, motions);
        }
        if total.carries_errors {
            self.note_entries();
        }
    }

    /// Notes what the assembly has rounded.
    fn note_entries(&mut self) {
        for row in 0..self.count {
            let entries = self.entries[row][..self.count].iter();
            let largest = entries.fold(self.terms[row], |largest, entry| entry.size().first().max(largest));
            self.note_error(row, largest);
        }
    }

    /// Adds the matrix of an object.
    fn add_object(&mut self, objects: &Objects<S, W>, object: usize, targets: &[Target<S>; W], motions: usize) {
        let range = objects.range(object);
        for row in range.clone() {
            let entries = objects.entries[row][..range.len()].iter().zip(&targets[range.clone()]);
            match &targets[row] {
                Target::Nowhere => {}
                &Target::Place(row, one) => {
                    for (entry, target) in entries {
                        if let &Target::Place(column, other) = target {
                            self.entries[row][column] = entry.times_power_of_two(one + other);
                        }
                    }
                }
                Target::Motions(sum) => {
                    for (column, (entry, target)) in range.clone().zip(entries) {
                        match target {
                            &Target::Place(place, shift) => {
                                let entry = entry.times_power_of_two(shift);
                                for (motion, coefficient) in sum[..motions].iter().enumerate() {
                                    self.add(motion, place, entry * *coefficient);
                                }
                            }
                            Target::Motions(other) if column >= row => {
                                self.add_square(*entry, &sum[..motions], &other[..motions], row == column);
                            }
                            _ => {}
                        }
                    }
                }
            }
        }
    }

    /// Adds an entry between two sums of motions, or of one with itself.
    fn add_square(&mut self, entry: S, one: &[S], other: &[S], is_diagonal: bool) {
        for (k, a) in one.iter().enumerate() {
            let product = entry * *a;
            for (l, b) in other.iter().enumerate() {
                let term = product * *b;
                self.entries[k][l] += term;
                if !is_diagonal {
                    self.entries[l][k] += term;
                }
                if k == l {
                    self.note(k, term.size().first());
                }
            }
        }
    }
}
