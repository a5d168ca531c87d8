//! The dominant entry of a motion: entries of states at all ends of elements, compared as energies.

use crate::element::{CoefficientsOf, Moving, Visit};
use crate::number::{FrequencyPowers, Single};
use crate::pass::both_ways::Passes;
use crate::pass::tree::Tree;
use mstmm_plan::{Coordinate, Space, Step};

/// An entry of the state at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Candidate {
    /// The step behind which the point is.
    pub(crate) step: usize,
    pub(crate) coordinate: Coordinate,
    /// The factor that makes the square of the entry an energy: a stiffness, or one over a stiffness.
    pub(crate) unit: f64,
}

/// The frequency at which elements give their usual stiffnesses: that of the motion, or the lowest estimate where that is zero,
/// since inertia has no force there.
pub(crate) fn comparable<S: Single, Y: Tree<S> + ?Sized>(system: &Y, x: S) -> FrequencyPowers<S> {
    let slowest = || S::one().times_power_of_two(system.frequency_estimates().lowest_exponent());
    Y::at(if x.is_zero() { slowest() } else { x })
}

/// Asks an element for its usual stiffnesses.
pub(crate) struct UnitsOf<'a, S>(pub(super) &'a FrequencyPowers<S>);

impl<S: Single> Visit<S> for UnitsOf<'_, S> {
    type Output = [f64; 2];

    fn element<E: Moving<S>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, S>>) -> [f64; 2] {
        E::units(built, self.0)
    }
}

impl<S: Single, Y: Tree<S> + ?Sized> Passes<'_, Y, S> {
    /// Calls a function with every candidate.
    pub(crate) fn for_each_candidate(&self, mut f: impl FnMut(Candidate)) {
        let at = comparable(self.system, self.at.x);
        for step in 0..self.system.scheme().len() {
            let Step::Element(input, space) = self.system.scheme().steps[step] else { continue };
            let Some([y, theta]) = self.system.visit(None, step, UnitsOf(&at)) else { continue };
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
