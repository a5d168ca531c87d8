//! Chains with general beams, as lists of steps.

use mstmm::element::Support;
use mstmm::elements::{Body, GeneralBeam, Lever, PointMass, RotationalHinge, ShearHinge, Spring, TorsionSpring};
use mstmm::list::{AnyUndamped, ListStep};

/// A link of a chain.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Link {
    Beam(GeneralBeam<f64>),
    /// A beam from a support of its own to where the chain is.
    Side(Support, GeneralBeam<f64>),
    Mass {
        mass: f64,
        inertia: f64,
    },
    /// A body with its inertia about its mass centre.
    Body {
        mass: f64,
        central: f64,
        centre_x: f64,
        output_x: f64,
    },
    /// Springs to the ground.
    Spring(f64),
    TorsionSpring(f64),
    RotationalHinge(f64),
    ShearHinge(f64),
    Lever(f64),
}

/// A chain from its tip to its root, whose last link is a beam.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    pub(crate) tip: Support,
    pub(crate) links: Vec<Link>,
    pub(crate) root: Support,
}

impl Chain {
    /// The chain as a list of steps.
    pub(crate) fn steps(&self) -> Vec<ListStep<AnyUndamped<f64>>> {
        type Any = AnyUndamped<f64>;
        let mut steps: Vec<ListStep<Any>> = vec![ListStep::Tip(self.tip)];
        let grounded = |support: Support, element: Any| {
            vec![ListStep::Tip(support), ListStep::Element(element), ListStep::Connection(2)]
        };
        for link in &self.links {
            match *link {
                Link::Beam(beam) => steps.push(ListStep::Element(beam.try_into().unwrap())),
                Link::Side(support, beam) => steps.extend(grounded(support, beam.try_into().unwrap())),
                Link::Mass { mass, inertia } => {
                    steps.push(ListStep::Element(PointMass { mass, inertia }.try_into().unwrap()));
                }
                Link::Body { mass, central, centre_x, output_x } => {
                    let inertia = central + mass * centre_x * centre_x;
                    let body = Body { mass, inertia, output_x, centre_x };
                    steps.push(ListStep::Element(body.try_into().unwrap()));
                }
                Link::Spring(stiffness) => {
                    steps.extend(grounded(Support::Fixed, Spring { stiffness }.try_into().unwrap()));
                }
                Link::TorsionSpring(stiffness) => {
                    steps.extend(grounded(Support::Fixed, TorsionSpring { stiffness }.try_into().unwrap()));
                }
                Link::RotationalHinge(stiffness) => {
                    steps.push(ListStep::Element(RotationalHinge { stiffness }.try_into().unwrap()));
                }
                Link::ShearHinge(stiffness) => {
                    steps.push(ListStep::Element(ShearHinge { stiffness }.try_into().unwrap()));
                }
                Link::Lever(output_x) => steps.push(ListStep::Element(Lever { output_x }.try_into().unwrap())),
            }
        }
        steps.push(ListStep::Root(self.root));
        steps
    }

    /// All parameters that a change may move a root with.
    pub(crate) fn parameters(&mut self) -> Vec<&mut f64> {
        let mut all = Vec::new();
        for link in &mut self.links {
            match link {
                Link::Beam(beam) | Link::Side(_, beam) => all.extend([
                    &mut beam.length,
                    &mut beam.bending_stiffness,
                    &mut beam.mass_per_length,
                    &mut beam.shear_stiffness,
                    &mut beam.rotary_inertia,
                    &mut beam.axial_force,
                    &mut beam.foundation_stiffness,
                    &mut beam.foundation_shear_stiffness,
                ]),
                Link::Mass { mass, inertia } => all.extend([mass, inertia]),
                Link::Body { mass, central, centre_x, output_x } => all.extend([mass, central, centre_x, output_x]),
                Link::Spring(one)
                | Link::TorsionSpring(one)
                | Link::RotationalHinge(one)
                | Link::ShearHinge(one)
                | Link::Lever(one) => all.push(one),
            }
        }
        all
    }
}
