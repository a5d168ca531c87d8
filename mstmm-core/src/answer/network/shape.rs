//! Mode shapes of plane structures.

use crate::answer::network::frequency::{MovingNetwork, PlaneFrequency};
use crate::answer::network::products::mass_product;
use crate::answer::network::states::PlaneStates;
use crate::model::MotionError;
use crate::number::{FrequencyPowers, Oscillation, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::{NetworkMotion, Placed, PlacedCharts, motion};
use crate::subspace::{FrontScalar, NodeLoad};
use core::ops::Deref;

/// Relative size of λ² - λ₁², with λ₁ the root, beyond which a frequency is none.
const NO_ROOT: f64 = 1e-7;

/// Size of the difference of two shapes under different loads beside them, beyond which other roots are too close for plain numbers.
const TWO_SHAPES: f64 = 1e-12;

/// The motion of a plane structure at a root, normalised to unit modal mass; dereferences to its states.
#[derive(Debug)]
pub struct PlaneShape<'a, Y: Placed, S: PlaneFrequency<Y::Parameter>> {
    states: PlaneStates<'a, Y, S>,
}

impl<Y: Placed, S: PlaneFrequency<Y::Parameter>> Clone for PlaneShape<'_, Y, S> {
    fn clone(&self) -> Self {
        PlaneShape { states: self.states.clone() }
    }
}

impl<'a, Y: Placed, S: PlaneFrequency<Y::Parameter>> Deref for PlaneShape<'a, Y, S> {
    type Target = PlaneStates<'a, Y, S>;

    fn deref(&self) -> &PlaneStates<'a, Y, S> {
        &self.states
    }
}

impl<Y, S> PlaneShape<'_, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    /// The modal mass `φᵀ M φ [+ φᵀ C φ/(2λ)]`: 1.
    pub fn modal_mass(&self) -> S {
        mass_product(self.system, self.x, &self.motion, &self.motion)
    }
}

/// The shapes of one root.
#[derive(Debug)]
pub struct PlaneShapes<'a, Y: Placed, S: PlaneFrequency<Y::Parameter>, const CAP: usize> {
    shapes: [Option<PlaneShape<'a, Y, S>>; CAP],
}

impl<'a, Y: Placed, S: PlaneFrequency<Y::Parameter>, const CAP: usize> PlaneShapes<'a, Y, S, CAP> {
    /// The shapes, one after the other.
    pub fn iter(&self) -> impl Iterator<Item = &PlaneShape<'a, Y, S>> {
        self.shapes.iter().flatten()
    }
}

/// The motion under the load of a number everywhere.
fn everywhere<Y, S>(system: &Y, x: S, number: u32) -> NetworkMotion<Y, S>
where
    Y: PlacedCharts<S>,
    S: Oscillation<Y::Parameter> + FrontScalar,
{
    motion(system, &FrequencyPowers::new(x, true), |_| NodeLoad::Everywhere(number))
}

/// The shape of a simple root: the motion under a load everywhere, which is the shape but for rounding. Where that under another load
/// differs, both are computed in extended precision, at the root with more digits.
pub(super) fn simple<Y, S>(system: &Y, x: S) -> Result<PlaneShape<'_, Y, S>, MotionError>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    let frequency = x.modulus();
    let [first, second] = [0, 1].map(|number| everywhere(system, x, number));
    let (Some(one), Some(other)) = (normalised(system, x, first), normalised(system, x, second)) else {
        return Err(MotionError::NotFinite { frequency });
    };
    let mismatch = one.distance;
    if !(mismatch <= NO_ROOT) {
        return Err(MotionError::NotARoot { frequency, mismatch });
    }
    let difference = without(system, x, &other.motion, &one.motion);
    let misfit = mass_product(system, x, &difference, &difference).size().sqrt();
    if misfit <= TWO_SHAPES {
        return Ok(one.shape(system, x));
    }
    if !S::HAS_EXTENDED {
        return Err(MotionError::Unresolved { root: frequency, misfit });
    }
    Err(MotionError::Unresolved { root: frequency, misfit })
}

/// A motion of unit modal mass.
struct Normalised<Y: Placed, S: Scalar> {
    motion: NetworkMotion<Y, S>,
    /// How far λ² is from that of the root, beside λ² or the smallest one.
    distance: f64,
}

impl<Y: Placed, S: PlaneFrequency<Y::Parameter>> Normalised<Y, S> {
    fn shape(self, system: &Y, x: S) -> PlaneShape<'_, Y, S> {
        PlaneShape { states: PlaneStates { system, x, motion: self.motion } }
    }
}

/// A motion of unit modal mass; none where it is not finite.
fn normalised<Y, S>(system: &Y, x: S, motion: NetworkMotion<Y, S>) -> Option<Normalised<Y, S>>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    // sizes of motions at a root are beyond those of their squares in a shorter format
    let motion = motion.times(S::one() / S::from_f64(motion.size()));
    let mass = mass_product(system, x, &motion, &motion);
    if !(mass.size() > 0.0 && mass.size().is_finite()) {
        return None;
    }
    let square = if x.is_zero() {
        S::one().times_power_of_two(2 * system.estimates().lowest_exponent())
    } else {
        x.lambda_squared()
    };
    let distance = (motion.work / (mass * square)).size();
    Some(Normalised { motion: motion.times(S::one() / mass.sqrt()), distance })
}

/// A motion less its part in another one of unit modal mass.
fn without<Y, S>(
    system: &Y,
    x: S,
    motion: &NetworkMotion<Y, S>,
    other: &NetworkMotion<Y, S>,
) -> NetworkMotion<Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    motion.plus(other, -mass_product(system, x, motion, other))
}

/// All shapes of a root, orthogonal with respect to the mass: motions under as many loads as it is multiple.
pub(super) fn all<const CAP: usize, Y, S>(
    system: &Y,
    x: S,
    multiplicity: u64,
) -> Result<PlaneShapes<'_, Y, S, CAP>, MotionError>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    let mut found = PlaneShapes { shapes: [const { None }; CAP] };
    if multiplicity == 1 && CAP > 0 {
        found.shapes[0] = Some(simple(system, x)?);
        return Ok(found);
    }
    let wanted = usize::try_from(multiplicity).ok().filter(|wanted| *wanted <= CAP);
    let wanted = wanted.ok_or(MotionError::Capacity { capacity: CAP })?;
    let frequency = x.modulus();
    for number in 0..wanted {
        let mut next = everywhere(system, x, number as u32);
        next = next.times(S::one() / S::from_f64(next.size()));
        // twice: the first difference may be small, and rounding large beside it
        for _ in 0..2 {
            for shape in found.shapes[..number].iter().flatten() {
                next = without(system, x, &next, &shape.motion);
            }
        }
        let next = normalised(system, x, next).ok_or(MotionError::NotFinite { frequency })?;
        let mismatch = next.distance;
        if !(mismatch <= NO_ROOT) {
            return Err(MotionError::NotARoot { frequency, mismatch });
        }
        found.shapes[number] = Some(next.shape(system, x));
    }
    Ok(found)
}
