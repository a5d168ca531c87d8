//! The assembly of a front: objects are joined at a node, whose motions replace the displacements of their ports.

use crate::number::{Scalar, Size, power_of_two};
use crate::subspace::front::chart::MOST_FREEDOMS;
use crate::subspace::front::eliminate::BOUND;
use crate::subspace::front::fronts::{FrontNode, Fronts};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::target::{Kind, Target};
use crate::subspace::front::triangle::{self, row};
use crate::subspace::front::units::{NodeUnits, Units};
use crate::subspace::front::variable::{Measure, Variable};

impl<S: Scalar> Fronts<'_, S> {
    /// Joins the last objects at a node, with the body there.
    pub(super) fn join(&mut self, node: &FrontNode<S>, from: usize) {
        let (units, boundary) = self.units(node, from);
        for object in from..self.objects.count {
            self.restrain(node, object, units);
        }
        let count = self.aim(node, from, units, boundary);
        self.front.begin(boundary, count);
        for motion in 0..node.motions {
            let is_rotation = node.is_rotation(motion);
            let unit = units.of(is_rotation);
            self.front.variables[boundary + motion] = Variable { is_rotation, unit, ..Variable::DISPLACEMENT };
        }
        self.enter_ports(node, from, units);
        for object in from..self.objects.count {
            self.enter_object(object, node.motions);
        }
        if let Some(body) = &node.body {
            self.front.add_body(&body[..node.motions]);
        }
        if self.total.carries_errors {
            self.enter_errors(node.motions, from);
        }
    }

    /// The units of a node, and the number of variables elsewhere.
    fn units(&self, node: &FrontNode<S>, from: usize) -> (Units, usize) {
        let (mut units, mut elsewhere) = (NodeUnits::new(), 0);
        for variable in &self.objects.variables[self.objects.last(from)] {
            if variable.node == node.index {
                units.include(variable);
            } else {
                elsewhere += 1;
            }
        }
        (units.units(node.inertias), elsewhere)
    }

    /// Lets displacements of an object at the node become forces where it is stiff in its units. Else these stiffnesses would be added to
    /// softer ones there.
    fn restrain(&mut self, node: &FrontNode<S>, object: usize, units: Units) {
        for (k, place) in self.objects.range(object).enumerate() {
            let size = self.objects.triangle(object)[row(k) + k].size().first();
            let variable = &self.objects.variables[place];
            if variable.is_force || variable.is_released || variable.node != node.index {
                continue;
            }
            let unit = units.of(variable.is_rotation);
            let power = power_of_two(unit - variable.unit);
            if size * power * power > BOUND {
                self.flip(object, k, unit);
            }
        }
    }

    /// Takes an object through a front of its own, in which all variables are on the boundary and one flips, in a unit.
    #[cold]
    fn flip(&mut self, object: usize, place: usize, unit: i32) {
        let Fronts { objects, front, total, .. } = self;
        let variables = objects.range(object);
        front.begin(variables.len(), variables.len());
        front.variables[..front.count].copy_from_slice(&objects.variables[variables.clone()]);
        front.errors[..front.count].copy_from_slice(&objects.errors[variables]);
        front.entries[..row(front.count)].copy_from_slice(objects.triangle(object));
        let power = power_of_two(front.variables[place].shift_to(unit));
        front.variables[place].unit = unit;
        front.errors[place] *= power * power;
        for other in 0..front.count {
            let factor = if other == place { power * power } else { power };
            let entry = &mut front.entries[triangle::place(place, other)];
            *entry = entry.scaled(factor);
        }
        front.flip_one(place, total);
        objects.copy(object, front);
    }

    /// Finds where each variable goes, given how many those of the boundary are, behind which the motions stand. Returns the number of all.
    fn aim(&mut self, node: &FrontNode<S>, from: usize, units: Units, boundary: usize) -> usize {
        let places = self.objects.last(from);
        let variables = &self.objects.variables[places.clone()];
        let (mut outer, mut inner) = (0, boundary + node.motions);
        for (variable, target) in variables.iter().zip(&mut self.targets[places]) {
            let unit = units.of(variable.is_rotation);
            let (next, unit) = if variable.node != node.index {
                // the unit of a front is no smaller than that of its node
                let is_own = variable.measure != Measure::Nothing;
                (&mut outer, if is_own { unit.max(variable.unit) } else { unit })
            } else if variable.is_force != variable.is_released {
                (&mut inner, unit)
            } else {
                target.kind = Kind::Motions;
                if variable.is_force {
                    target.kind = Kind::Nowhere;
                    self.total.count(1.0);
                }
                continue;
            };
            let power = power_of_two(variable.shift_to(unit));
            *target = Target { kind: Kind::Place, place: *next as u32, power };
            self.front.variables[*next] = Variable { unit, measure: variable.measure.once_joined(), ..*variable };
            *next += 1;
        }
        inner
    }

    /// Brings the rows of ports into units, and enters those of forces, which act on the motions.
    fn enter_ports(&mut self, node: &FrontNode<S>, from: usize, units: Units) {
        let Fronts { objects, front, targets, .. } = self;
        let (first, motions, places) = (front.boundary, node.motions, objects.last(from));
        let powers = [units.displacement, units.rotation].map(power_of_two);
        let ports = objects.variables[places.clone()].iter().zip(&mut objects.rows[places.clone()]);
        for ((variable, sum), target) in ports.zip(&targets[places]) {
            if variable.node != node.index || variable.is_released {
                continue;
            }
            // the row of a force stands in the unit of the node, that of a displacement in its own
            let own = power_of_two(-if variable.is_force { units.of(variable.is_rotation) } else { variable.unit });
            let sum = &mut sum[..motions];
            for (motion, coefficient) in sum.iter_mut().enumerate() {
                *coefficient = coefficient.scaled(powers[usize::from(node.is_rotation(motion))] * own);
            }
            if target.kind == Kind::Place {
                front.entries[row(target.place as usize) + first..][..motions].copy_from_slice(sum);
            }
        }
    }

    /// Enters the errors of objects, and what the assembly has rounded.
    #[cold]
    fn enter_errors(&mut self, motions: usize, from: usize) {
        let Fronts { objects, front, targets, .. } = self;
        for place in objects.last(from) {
            let (target, error) = (&targets[place], objects.errors[place]);
            match target.kind {
                Kind::Place => front.note_error(target.place as usize, error * target.power * target.power),
                Kind::Motions => {
                    for (motion, coefficient) in objects.rows[place][..motions].iter().enumerate() {
                        let size = coefficient.size().first();
                        front.note_error(front.boundary + motion, error * size * size);
                    }
                }
                Kind::Nowhere => {}
            }
        }
        front.note_entries();
    }

    /// Enters the matrix of an object.
    fn enter_object(&mut self, object: usize, motions: usize) {
        let Fronts { objects, front, targets, .. } = self;
        let places = objects.range(object);
        let (rows, targets) = (&objects.rows[places.clone()], &targets[places]);
        let first = front.boundary;
        let mut rest = objects.triangle(object);
        for (k, (target, sum)) in targets.iter().zip(rows).enumerate() {
            let (entries, others) = rest.split_at(k + 1);
            rest = others;
            for ((entry, other), other_sum) in entries.iter().zip(targets).zip(rows) {
                if entry.is_constant_zero() {
                    continue;
                }
                let (sum, place, power) = match (target.kind, other.kind) {
                    (Kind::Place, Kind::Place) => {
                        let place = triangle::place(target.place as usize, other.place as usize);
                        front.entries[place] += entry.scaled(target.power * other.power);
                        continue;
                    }
                    (Kind::Motions, Kind::Motions) => {
                        let is_diagonal = core::ptr::eq(target, other);
                        front.add_square(*entry, &sum[..motions], &other_sum[..motions], is_diagonal);
                        continue;
                    }
                    (Kind::Motions, Kind::Place) => (sum, other.place, other.power),
                    (Kind::Place, Kind::Motions) => (other_sum, target.place, target.power),
                    _ => continue,
                };
                let entry = entry.scaled(power);
                for (motion, coefficient) in sum[..motions].iter().enumerate() {
                    front.entries[triangle::place(first + motion, place as usize)] += entry * *coefficient;
                }
            }
        }
    }
}

impl<S: Scalar> Front<'_, S> {
    /// Adds an entry between two sums of motions, or of one with itself.
    fn add_square(&mut self, entry: S, one: &[S], other: &[S], is_diagonal: bool) {
        let first = self.boundary;
        for (k, (a, b)) in one.iter().zip(other).enumerate() {
            let (of_one, of_other) = (entry * *a, entry * *b);
            for l in 0..=k {
                let mut term = of_one * other[l];
                if !is_diagonal {
                    term += of_other * one[l];
                }
                self.add(first + k, first + l, term);
            }
        }
    }

    /// Adds the inertia of a body.
    fn add_body(&mut self, body: &[[S; MOST_FREEDOMS]]) {
        let first = self.boundary;
        for (k, terms) in body.iter().enumerate() {
            let own = self.variables[first + k].unit;
            for (l, term) in terms[..=k].iter().enumerate() {
                let power = power_of_two(own + self.variables[first + l].unit);
                self.add(first + k, first + l, term.scaled(power));
            }
        }
    }

    /// Notes what the assembly has rounded.
    fn note_entries(&mut self) {
        for row in 0..self.count {
            let sizes = (0..self.count).map(|column| self.size(row, column));
            let largest = sizes.fold(self.terms[row], f64::max);
            self.note_error(row, largest);
        }
    }
}
