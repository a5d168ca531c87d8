//! The displacements of a tree: what moves with what, what is held.

use super::{BeamEnds, Form, Inertia, Link};
use crate::tree::{Part, Tree, next_space};
use mstmm::elements::Body;
use mstmm::{DoubleDouble, ListStep, Space, Support};

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
    pub(super) size: usize,
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
fn sum(a: &Form, factor: f64, b: &Form) -> Form {
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

/// `J_I - m c²` of the numbers as they are given: each product in parts without rounding. What rounding has put below zero
/// is zero.
fn central_inertia(body: &Body<f64>) -> DoubleDouble {
    let (high, low) = DoubleDouble::from_product(body.centre_x, body.centre_x).parts();
    let (first, second) = DoubleDouble::from_product(body.mass, high).parts();
    let third = DoubleDouble::from_product(body.mass, low);
    let rest = DoubleDouble::from_sum(body.inertia, -first) - DoubleDouble::from(second) - third;
    let zero = DoubleDouble::from(0.0);
    if rest < zero { zero } else { rest }
}

impl Parts {
    fn freedom(&mut self) -> Form {
        self.size += 1;
        vec![(self.size - 1, DoubleDouble::from(1.0))]
    }

    /// The beginning of a path: what the support holds is the empty form.
    fn tip(&mut self, space: Space, support: Support) -> End {
        let (holds_y, holds_theta) = holds(support);
        let mut displacement = |holds: bool| if holds { Vec::new() } else { self.freedom() };
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
        inputs.first().map(|&form| form.clone()).or_else(|| needed.then(|| self.freedom()))
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

    fn mass(&mut self, mass: f64, form: &Form) {
        self.masses.push(Inertia { form: form.clone(), mass: DoubleDouble::from(mass) });
    }

    fn link(&mut self, stiffness: f64, damping: f64, from: &Form) -> Form {
        let out = self.freedom();
        self.links.push(Link { form: sum(from, -1.0, &out), stiffness, damping });
        out
    }

    /// A path of two displacements goes through an element.
    fn bending(&mut self, part: Part, y: Form, theta: Form) -> End {
        let (y, theta) = match part {
            Part::PointMass(p) => {
                self.mass(p.mass, &y);
                self.mass(p.inertia, &theta);
                (y, theta)
            }
            Part::Beam(b) => {
                let (y_out, theta_out) = (self.freedom(), self.freedom());
                self.beams.push(BeamEnds {
                    ends: [y, theta, y_out.clone(), theta_out.clone()],
                    length: b.length,
                    bending_stiffness: b.bending_stiffness,
                    mass_per_length: b.mass_per_length,
                });
                (y_out, theta_out)
            }
            Part::Body(b) => {
                self.mass(b.mass, &sum(&y, b.centre_x, &theta));
                self.masses.push(Inertia { form: theta.clone(), mass: central_inertia(&b) });
                (sum(&y, b.output_x, &theta), theta)
            }
            Part::ElasticHinge(h) => (self.link(h.stiffness_y, 0.0, &y), self.link(h.stiffness_theta, 0.0, &theta)),
            _ => (y, theta),
        };
        End::Point { y: Some(y), theta: Some(theta) }
    }

    /// A path of one displacement goes through an element.
    fn line(&mut self, part: Part, q: Form) -> Form {
        let (stiffness, damping) = match part {
            Part::Mass(p) => {
                self.mass(p.mass, &q);
                return q;
            }
            Part::Inertia(p) => {
                self.mass(p.inertia, &q);
                return q;
            }
            Part::Spring(p) => (p.stiffness, 0.0),
            Part::TorsionSpring(p) => (p.stiffness, 0.0),
            Part::Damper(p) => (0.0, p.damping),
            Part::TorsionDamper(p) => (0.0, p.damping),
            Part::SpringDamper(p) => (p.stiffness, p.damping),
            Part::TorsionSpringDamper(p) => (p.stiffness, p.damping),
            _ => return q,
        };
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
