//! The mass of a tree that modes can move.

use crate::element::{CoefficientsOf, MemberNumbers, Moving, Visit};
use crate::model::{Ends, MotionError, State};
use crate::number::Real;
use crate::pass::characteristic::System;
use crate::pass::tree::Tree;
use mstmm_plan::{Freedoms, Step};
use num_traits::Zero;

/// Masses that rigid steps tie to the end of a path.
#[derive(Clone, Copy, Debug)]
struct Cluster<T> {
    mass: T,
    /// The step of its last mass.
    last: usize,
    /// The freedoms that a support holds.
    held: Freedoms,
    /// Whether a body has an extent, so that a mass moves as it turns.
    has_arm: bool,
    /// Whether a part of it turns against another one.
    has_hinge: bool,
}

impl<T: Real> Cluster<T> {
    fn none() -> Self {
        Cluster { mass: T::zero(), last: 0, held: Freedoms::NONE, has_arm: false, has_hinge: false }
    }

    fn and(self, other: Self) -> Self {
        Cluster {
            mass: self.mass + other.mass,
            last: if other.mass.is_zero() { self.last } else { other.last },
            held: self.held.union(other.held),
            has_arm: self.has_arm || other.has_arm,
            has_hinge: self.has_hinge || other.has_hinge,
        }
    }

    /// The mass that modes can move, if that is known; else the step of a mass.
    fn moving(&self) -> Result<T, usize> {
        if !self.held.contains(Freedoms::Y) {
            return Ok(self.mass);
        }
        let rests = !self.has_arm || self.held.contains(Freedoms::RZ) && !self.has_hinge;
        if rests || self.mass.is_zero() { Ok(T::zero()) } else { Err(self.last) }
    }
}

/// How a step carries what is behind it on.
enum Part<T> {
    /// A rigid one with its mass, and whether that has an arm.
    Rigid(T, bool),
    /// One that ties deflections alone.
    Hinge,
    /// One that gives way, with its mass.
    Elastic(T),
}

/// The mass of a tree that modes can move along y.
///
/// # Errors
/// [`MotionError::HeldMass`] where a support holds a body in part; [`MotionError::NoUniformLoad`] for an element whose weight is not known.
pub(crate) fn moving_mass<Y>(system: &Y) -> Result<Y::Parameter, MotionError>
where
    Y: Tree<<Y as System>::Parameter> + ?Sized,
{
    let scheme = system.scheme();
    let mut clusters = Y::per_step(Cluster::none());
    let clusters = clusters.as_mut();
    let mut total = Y::Parameter::zero();
    let known =
        |cluster: &Cluster<_>| cluster.moving().map_err(|step| MotionError::HeldMass { at: system.spot_of(step) });
    for (index, step) in scheme.steps.iter().enumerate() {
        clusters[index] = match *step {
            Step::Tip(support) => Cluster { held: support.holds(), ..Cluster::none() },
            Step::Element(input, _) => {
                let before = clusters[input];
                match system.visit(None, index, PartOf).flatten().ok_or(MotionError::NoUniformLoad)? {
                    Part::Rigid(mass, has_arm) => before.and(Cluster { mass, last: index, has_arm, ..Cluster::none() }),
                    Part::Hinge => Cluster { has_hinge: true, ..before },
                    Part::Elastic(mass) => {
                        total += known(&before)? + mass;
                        Cluster::none()
                    }
                }
            }
            // rotations of all paths are one there
            Step::Connection(inputs) => inputs.iter().fold(Cluster::none(), |sum, input| sum.and(clusters[*input])),
            Step::Root(input, support) => {
                let end = Cluster { held: support.holds(), ..Cluster::none() };
                total += known(&clusters[input].and(end))?;
                Cluster::none()
            }
        };
    }
    Ok(total)
}

/// How the element of a step carries on; `None` for one whose weight is not known.
struct PartOf;

impl<T: Real> Visit<T> for PartOf {
    type Output = Option<Part<T>>;

    fn element<E: Moving<T>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, T>>) -> Option<Part<T>> {
        let (zero, lifted) = (T::zero(), State { y: T::one(), ..State::default() });
        if let Some(inside) = E::inside(built, zero) {
            let resting = Ends { x: zero, input: State::default(), output: State::default() };
            E::load_work(built, &resting)?;
            return Some(Part::Elastic(E::mass_per_length(built) * T::from_f64(inside.length)));
        }
        let all = Ends { x: zero, input: lifted, output: lifted };
        let mass = E::mass_form(built, &all, &all);
        Some(match E::member_numbers(built) {
            MemberNumbers::Body(body) | MemberNumbers::Disc(body, _) => {
                Part::Rigid(mass, body.output_x != [0.0; 2] || body.centre_x != [0.0; 2])
            }
            MemberNumbers::Joint(rigid, _) if rigid.contains(Freedoms::Y) => Part::Hinge,
            _ => Part::Elastic(mass),
        })
    }
}
