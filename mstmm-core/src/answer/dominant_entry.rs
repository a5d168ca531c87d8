//! Where a motion of the system shows best: the entries of states at all ends of elements, made comparable.

use crate::element::energies::Energies;
use crate::model::state::{Coordinate, Space};
use crate::number::frequency_powers::FrequencyPowers;
use crate::number::scalar::Scalar;
use crate::pass::both_ways::Passes;
use crate::pass::tree::{Tree, Visit};
use mstmm_plan::Step;

/// An entry of the state at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Candidate {
    /// The step behind which the point is.
    pub(crate) step: usize,
    pub(crate) coordinate: Coordinate,
    /// What makes the square of the entry an energy: a stiffness, or one over a stiffness.
    pub(crate) unit: f64,
}

/// The frequency at which elements tell their usual stiffnesses: that of the motion, but where that is zero and inertia has no
/// force that of the slowest motion.
pub(crate) fn comparable<S: Scalar, Y: Tree<S> + ?Sized>(system: &Y, x: S) -> FrequencyPowers<S> {
    let slowest = || S::one().times_power_of_two(system.estimates().lowest_exponent());
    Y::at(if x.is_zero() { slowest() } else { x })
}

/// Asks an element for its usual stiffnesses.
pub(crate) struct UnitsOf<'a, S>(pub(super) &'a FrequencyPowers<S>);

impl<S: Scalar> Visit<S> for UnitsOf<'_, S> {
    type Output = [f64; 2];

    fn element<E: Energies<S>>(self, built: &E::Built) -> [f64; 2] {
        E::units(built, self.0)
    }
}

impl<S: Scalar, Y: Tree<S> + ?Sized> Passes<'_, Y, S> {
    /// Calls a function with every candidate.
    pub(crate) fn for_each_candidate(&self, mut f: impl FnMut(Candidate)) {
        let at = comparable(self.system, self.at.x);
        for step in 0..Y::scheme().len() {
            let Step::Element(input, space) = Y::scheme().steps[step] else { continue };
            let Some([y, theta]) = self.system.visit(step, UnitsOf(&at)) else { continue };
            let entries: &[(Coordinate, f64)] = match space {
                Space::Translation => &[(Coordinate::Y, y), (Coordinate::Q, 1.0 / y)],
                Space::Rotation => &[(Coordinate::Theta, theta), (Coordinate::M, 1.0 / theta)],
                _ => &[
                    (Coordinate::Y, y),
                    (Coordinate::Theta, theta),
                    (Coordinate::M, 1.0 / theta),
                    (Coordinate::Q, 1.0 / y),
                ],
            };
            for &(coordinate, unit) in entries.iter().filter(|(_, unit)| *unit > 0.0 && unit.is_finite()) {
                for step in [step, input] {
                    f(Candidate { step, coordinate, unit });
                }
            }
        }
    }
}
