//! The displacements of a tree: what moves with what, what is held.
//!
//! Every elongation, bending and displacement of a mass has a degree of freedom of its own, joined to the others by
//! constraints: which of them are eliminated is decided later.

use super::weights::Weight;
use super::{BeamEnds, Form, Inertia, Link};
use crate::support::tree::{Part, Tree, next_space};
use mstmm::element::{Space, Support};
use mstmm::elements::{Beam, Body};
use mstmm::list::ListStep;
use mstmm::number::DoubleDouble;

/// Whether a support holds the deflection, and whether it holds the rotation.
fn holds(support: Support) -> (bool, bool) {
    match support {
        Support::Fixed => (true, true),
        Support::Pinned => (true, false),
        Support::Guided => (false, true),
        Support::Free | Support::Roller => (false, false),
    }
}

/// What a tree is made of, before its constraints are eliminated.
#[derive(Default)]
pub(super) struct Parts {
    /// What each degree of freedom by itself is held or slowed down by.
    pub(super) weights: Vec<Weight>,
    /// Forms that are zero.
    pub(super) constraints: Vec<Form>,
    pub(super) links: Vec<Link>,
    pub(super) masses: Vec<Inertia>,
    pub(super) beams: Vec<BeamEnds>,
}

/// The open end of a path: its deflection and rotation, where it has them; or a support that holds a connection.
#[derive(Clone)]
enum End {
    Point { y: Option<Form>, theta: Option<Form> },
    Held(Support),
}

/// `a + factor · b`.
pub(super) fn sum(a: &Form, factor: f64, b: &Form) -> Form {
    let mut sum = a.clone();
    for &(index, entry) in b {
        let term = entry * DoubleDouble::from(factor);
        match sum.iter_mut().find(|(other, _)| *other == index) {
            Some((_, entry)) => *entry += term,
            None => sum.push((index, term)),
        }
    }
    sum
}

/// `J_I - m c²` of the numbers as they are given, below zero where their rounding has put it: each product in parts without rounding.
fn central_inertia(body: &Body<f64>) -> DoubleDouble {
    let (high, low) = DoubleDouble::from_product(body.centre_x, body.centre_x).parts();
    let (first, second) = DoubleDouble::from_product(body.mass, high).parts();
    let third = DoubleDouble::from_product(body.mass, low);
    DoubleDouble::from_sum(body.inertia, -first) - DoubleDouble::from(second) - third
}

impl Parts {
    fn freedom(&mut self, weight: Weight) -> Form {
        self.weights.push(weight);
        vec![(self.weights.len() - 1, DoubleDouble::from(1.0))]
    }

    /// A degree of freedom that is equal to a form.
    fn equal(&mut self, weight: Weight, form: &Form) -> Form {
        let freedom = self.freedom(weight);
        self.constraints.push(sum(form, -1.0, &freedom));
        freedom
    }

    /// The beginning of a path: what the support holds is the empty form.
    fn tip(&mut self, space: Space, support: Support) -> End {
        let (holds_y, holds_theta) = holds(support);
        let mut displacement = |holds: bool| if holds { Vec::new() } else { self.freedom(Weight::NONE) };
        let y = (!space.is(Space::Rotation)).then(|| displacement(holds_y));
        let theta = (!space.is(Space::Translation)).then(|| displacement(holds_theta));
        End::Point { y, theta }
    }

    fn hold(&mut self, y: Option<&Form>, theta: Option<&Form>, support: Support) {
        let (holds_y, holds_theta) = holds(support);
        self.constraints.extend(y.filter(|_| holds_y).cloned());
        self.constraints.extend(theta.filter(|_| holds_theta).cloned());
    }

    /// One displacement for all inputs of a connection; a new one if it is needed and none is there.
    fn join(&mut self, inputs: &[&Form], needed: bool) -> Option<Form> {
        self.constraints.extend(inputs.iter().skip(1).map(|other| sum(inputs[0], -1.0, other)));
        inputs.first().map(|&form| form.clone()).or_else(|| needed.then(|| self.freedom(Weight::NONE)))
    }

    fn connection(&mut self, inputs: &[End], next: Option<Space>) -> End {
        let forms = |which: fn(&End) -> Option<&Form>| inputs.iter().filter_map(which).collect::<Vec<&Form>>();
        let deflections = forms(|end| if let End::Point { y, .. } = end { y.as_ref() } else { None });
        let rotations = forms(|end| if let End::Point { theta, .. } = end { theta.as_ref() } else { None });
        let y = self.join(&deflections, next.is_some_and(|space| !space.is(Space::Rotation)));
        let theta = self.join(&rotations, next.is_some_and(|space| !space.is(Space::Translation)));
        for end in inputs {
            if let End::Held(support) = *end {
                self.hold(y.as_ref(), theta.as_ref(), support);
            }
        }
        End::Point { y, theta }
    }

    fn mass(&mut self, mass: DoubleDouble, form: &Form) {
        let form = self.equal(Weight::mass(mass), form);
        self.masses.push(Inertia { form, mass });
    }

    fn link(&mut self, stiffness: f64, damping: f64, from: &Form) -> Form {
        let elongation = self.freedom(Weight::link(stiffness, damping));
        let out = sum(from, -1.0, &elongation);
        self.links.push(Link { form: elongation, stiffness, damping });
        out
    }

    fn beam(&mut self, beam: &Beam<f64>, y: &Form, theta: &Form) -> End {
        let [deflection, rotation] = [false, true].map(|is_rotation| Weight::beam_end(beam, is_rotation));
        let [bending, turning] = [false, true].map(|is_rotation| Weight::bending(beam, is_rotation));
        let (y, theta) = (self.equal(deflection, y), self.equal(rotation, theta));
        let bending = [self.freedom(bending), self.freedom(turning)];
        let rigid = sum(&y, beam.length, &theta);
        let y_out = self.equal(deflection, &sum(&rigid, 1.0, &bending[0]));
        let theta_out = self.equal(rotation, &sum(&theta, 1.0, &bending[1]));
        let ends = [y, theta, y_out.clone(), theta_out.clone()];
        self.beams.push(BeamEnds { ends, bending, beam: *beam });
        End::Point { y: Some(y_out), theta: Some(theta_out) }
    }

    /// A path of two displacements goes through an element.
    fn bending(&mut self, part: Part, y: Form, theta: Form) -> End {
        let (y, theta) = match part {
            Part::PointMass(p) => {
                self.mass(p.mass.into(), &y);
                self.mass(p.inertia.into(), &theta);
                (y, theta)
            }
            Part::Beam(b) => return self.beam(&b, &y, &theta),
            Part::Body(b) => {
                self.mass(b.mass.into(), &sum(&y, b.centre_x, &theta));
                self.mass(central_inertia(&b), &theta);
                (sum(&y, b.output_x, &theta), theta)
            }
            Part::ElasticHinge(h) => (self.link(h.stiffness_y, 0.0, &y), self.link(h.stiffness_theta, 0.0, &theta)),
            Part::RotationalHinge(h) => (y, self.link(h.stiffness, 0.0, &theta)),
            Part::ShearHinge(h) => (self.link(h.stiffness, 0.0, &y), theta),
            Part::Lever(l) => (sum(&y, l.output_x, &theta), theta),
            _ => (y, theta),
        };
        End::Point { y: Some(y), theta: Some(theta) }
    }

    /// A path of one displacement goes through an element.
    fn line(&mut self, part: Part, q: Form) -> Form {
        match part {
            Part::Mass(p) => {
                self.mass(p.mass.into(), &q);
                return q;
            }
            Part::Inertia(p) => {
                self.mass(p.inertia.into(), &q);
                return q;
            }
            _ => {}
        }
        let Some([stiffness, damping]) = part.link() else { return q };
        self.link(stiffness, damping, &q)
    }

    fn element(&mut self, part: Part, input: Option<End>) -> End {
        match (input, part.space()) {
            (Some(End::Point { y: Some(y), theta: Some(theta) }), Space::Bending) => self.bending(part, y, theta),
            (Some(End::Point { y: Some(y), .. }), Space::Translation) => {
                End::Point { y: Some(self.line(part, y)), theta: None }
            }
            (Some(End::Point { theta: Some(theta), .. }), Space::Rotation) => {
                End::Point { y: None, theta: Some(self.line(part, theta)) }
            }
            _ => unreachable!("{part:?} does not fit its path"),
        }
    }

    pub(super) fn of(tree: &Tree) -> Parts {
        let mut parts = Parts::default();
        let mut open: Vec<End> = Vec::new();
        for (index, step) in tree.iter().enumerate() {
            let next = next_space(tree, index);
            let end = match (step, next) {
                (ListStep::Tip(support), None) => End::Held(*support),
                (ListStep::Tip(support), Some(space)) => parts.tip(space, *support),
                (ListStep::Connection(inputs), _) => {
                    let inputs = open.split_off(open.len() - inputs);
                    parts.connection(&inputs, next)
                }
                (ListStep::Element(part), _) => {
                    let input = open.pop();
                    parts.element(*part, input)
                }
                (ListStep::Root(support), _) => {
                    if let Some(End::Point { y, theta }) = open.pop() {
                        parts.hold(y.as_ref(), theta.as_ref(), *support);
                    }
                    return parts;
                }
            };
            open.push(end);
        }
        parts
    }
}
