//! Mode shapes of plane structures.

use crate::answer::network::states::PlaneStates;
use crate::answer::root::is_below_losses;
use crate::element::Forms;
use crate::model::MotionError;
use crate::number::Scalar;
use crate::pass::characteristic::System;
use crate::pass::network::{
    MovingNetwork, NetworkMotion, Placed, PlaneFrequency, delta, mass_product, mass_product_of_two, motion_everywhere,
};
use core::ops::Deref;

/// How often parts of other shapes are taken from one: each time leaves rounding of what was there.
const PASSES: usize = 3;

/// Distance from a root in which all its shapes are computed: half of the digits of extended precision, in bits, and somewhat less of λ² at
/// rest, beside stiffnesses of all sizes.
const BESIDE: i32 = 52;
const BESIDE_REST: i32 = 56;

/// Relative step of the secant method, large beside the rounding of a root and small beside the distance of other roots.
const STEP: f64 = 1e-13;

/// Relative size of λ² - λ₁², with λ₁ the root, beyond which a frequency is none.
const NO_ROOT: f64 = 1e-7;

/// Relative size of λ² - λ₁² beyond which there is no root at rest: it is one beside λ₁ = 0.
const BESIDE_NO_ROOT: f64 = 8.0;

/// What must be left of a motion without its parts in other shapes of a root, or other loads are tried, and how many.
const LEFT: f64 = 1e-3;
const RETRIES: usize = 4;

/// The modal mass of a shape beside that of its size, below which two roots share it.
const DEFECTIVE: f64 = 1e-5;

/// The difference of shapes under two loads, of unit modal mass, and the sum of forces at a node beside the largest, beyond which a shape
/// is computed again in extended precision.
const FITTING: f64 = 1e-12;

/// The difference of shapes under two loads beyond which other roots are too close for any precision.
const RESOLVED: f64 = 1e-9;

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
    /// The frequency of the root: ω for a real scalar, λ for a complex one.
    pub fn frequency(&self) -> S {
        self.x
    }

    /// The modal mass `φᵀ M φ [+ φᵀ C φ/(2λ)]`: 1, unless the shape was scaled.
    pub fn modal_mass(&self) -> S {
        mass_product(self.system, self.x, &self.motion, &self.motion)
    }

    /// The shape divided by the size of its largest displacement, of nodes and inside of members; `None` if nothing is displaced.
    #[must_use]
    pub fn with_unit_deflection(mut self) -> Option<Self> {
        let largest = self.largest_deflection();
        if largest > 0.0 && largest.is_finite() {
            self.states.motion = self.motion.times(S::from_f64(1.0 / largest));
            return Some(self);
        }
        None
    }

    /// `φ₁ᵀ M φ₂ + φ₁ᵀ C φ₂/(λ₁ + λ₂)`: zero for shapes of different roots.
    pub fn product(&self, other: &Self) -> S {
        mass_product_of_two(self.system, (self.x, &self.motion), (other.x, &other.motion))
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

/// A motion less its part in another one of unit modal mass.
fn without<Y, S>(system: &Y, x: S, motion: &NetworkMotion<Y, S>, other: &NetworkMotion<Y, S>) -> NetworkMotion<Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    motion.plus(other, -mass_product(system, x, motion, other))
}

/// The motions under loads everywhere at a root, in plain numbers or at the root with twice the digits.
#[derive(Clone, Copy)]
struct AtRoot<'a, Y: Placed, S: PlaneFrequency<Y::Parameter>> {
    system: &'a Y,
    x: S,
    /// The root in extended precision; none for plain numbers.
    nearer: Option<S::Precise>,
}

impl<'a, Y, S> AtRoot<'a, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    /// The motion under the load of a number.
    fn motion(&self, number: u32) -> NetworkMotion<Y, S> {
        match self.nearer {
            Some(nearer) => {
                let motion = motion_everywhere(self.system, nearer, number, self.dislocates());
                let size = S::Precise::from_f64(motion.size());
                motion.times(S::Precise::from_f64(1.0) / size).rounded(S::nearest)
            }
            None => motion_everywhere(self.system, self.x, number, self.dislocates()),
        }
    }

    /// Whether loads have dislocations: at rest, beside motions without stiffness, they would not be small.
    fn dislocates(&self) -> bool {
        !self.x.is_zero()
    }

    fn not_finite(&self) -> MotionError {
        MotionError::NotFinite { frequency: self.x.modulus() }
    }

    /// The motion of unit modal mass under the load of a number.
    ///
    /// # Errors
    /// It is not finite, or the frequency is no root.
    fn normalised(&self, number: u32) -> Result<NetworkMotion<Y, S>, MotionError> {
        let motion = self.motion(number);
        // of a motion at a root the square is out of range in a short format
        let motion = motion.times(S::one() / S::from_f64(motion.size()));
        let mass = mass_product(self.system, self.x, &motion, &motion);
        if !(mass.size() > 0.0 && mass.size().is_finite()) {
            return Err(self.not_finite());
        }
        self.check(&motion, mass)?;
        if self.is_defective(&motion, mass) {
            return Err(MotionError::Unresolved { root: self.x.modulus(), misfit: 1.0 });
        }
        Ok(motion.times(S::one() / mass.sqrt()))
    }

    /// Whether the modal mass of a motion is small beside that of its size: another root has the shape, too.
    fn is_defective(&self, motion: &NetworkMotion<Y, S>, mass: S) -> bool {
        let lambda = self.x.lambda();
        // without dampers modal masses are those of the size
        if lambda.is_zero() {
            return false;
        }
        let Forms { mass: kinetic, damping, .. } = self.shape(*motion).whole();
        mass.size() < DEFECTIVE * (kinetic.size() + damping.size() / lambda.size())
    }

    /// Checks that the frequency is a root, given a motion there and its modal mass: the work of the load over the mass is λ² less that of
    /// the root.
    fn check(&self, motion: &NetworkMotion<Y, S>, mass: S) -> Result<(), MotionError> {
        let at = if self.x.is_zero() { self.nearer.map_or(self.x, S::nearest) } else { self.x };
        let mismatch = (motion.work / mass / at.lambda_squared()).size();
        // beside rest it is all of λ²; at rest itself it has no size to compare with, and a count has found the root
        let limit = if self.x.is_zero() { BESIDE_NO_ROOT } else { NO_ROOT };
        if at.is_zero() || mismatch <= limit {
            return Ok(());
        }
        Err(MotionError::NotARoot { frequency: self.x.modulus(), mismatch })
    }

    /// The root with twice the digits, after a step of the secant method with Δ.
    fn extended(self) -> Self {
        let x = self.x.precise();
        let away = x * S::Precise::from_f64(STEP);
        let ratio = delta(self.system, x + away).over(delta(self.system, x)).value();
        let step = away / (ratio - S::Precise::from_f64(1.0));
        // where Δ is zero, or as small as it can be, there is nothing to gain
        let is_known = step.size() <= STEP * x.size();
        AtRoot { nearer: Some(if is_known { x - step } else { x }), ..self }
    }

    /// A frequency beside a root, so near that other shapes are rounding, and so far that all shapes of the root grow alike.
    fn beside(self) -> Self {
        let x = self.x.precise();
        let nearer = if self.x.is_zero() {
            S::steady(self.system.frequency_estimates().least_exponent() - BESIDE_REST / 2)
        } else {
            x + x.times_power_of_two(-BESIDE)
        };
        AtRoot { nearer: Some(nearer), ..self }
    }

    fn shape(&self, motion: NetworkMotion<Y, S>) -> PlaneShape<'a, Y, S> {
        PlaneShape { states: PlaneStates { system: self.system, x: self.x, motion, load: None } }
    }

    /// The shape of a simple root, and how far that under another load is from it.
    fn simple(&self) -> Result<(PlaneShape<'a, Y, S>, f64), MotionError> {
        let (motion, other) = (self.normalised(0)?, self.normalised(1)?);
        let difference = without(self.system, self.x, &other, &motion);
        let misfit = mass_product(self.system, self.x, &difference, &difference).size().sqrt();
        Ok((self.shape(motion), misfit))
    }

    /// As many shapes as a root has, orthogonal with respect to the mass.
    ///
    /// A light part moves much farther than a heavy one. So motions stay in extended precision until all others are taken from them. What is
    /// left of one more motion, elsewhere beside the root and under another load, tells how far other roots take part.
    fn all<const CAP: usize>(&self, multiplicity: usize) -> Result<PlaneShapes<'a, Y, S, CAP>, MotionError> {
        let mut found = PlaneShapes { shapes: [const { None }; CAP] };
        let mut motions = [const { None::<NetworkMotion<Y, S::Precise>> }; CAP];
        let mut number = 0;
        for shape in 0..multiplicity {
            let mut best = self.orthogonal(&motions[..shape], number)?;
            number += 1;
            for _ in 0..RETRIES {
                if best.1 > LEFT {
                    break;
                }
                let other = self.orthogonal(&motions[..shape], number)?;
                number += 1;
                best = if other.1 > best.1 { other } else { best };
            }
            let (motion, rounded) = (best.0, best.0.rounded(S::nearest));
            if self.is_defective(&rounded, S::one()) {
                let (root, multiplicity, shapes) = (self.x.modulus(), multiplicity as u64, shape.max(1) as u64);
                return Err(MotionError::Defective { root, multiplicity, shapes });
            }
            (found.shapes[shape], motions[shape]) = (Some(self.shape(rounded)), Some(motion));
        }
        if let Some(nearer) = self.nearer {
            let farther = if self.x.is_zero() { nearer + nearer } else { nearer + nearer - self.x.precise() };
            let elsewhere = AtRoot { nearer: Some(farther), ..*self };
            let (_, misfit) = elsewhere.orthogonal(&motions[..multiplicity], number)?;
            if misfit.is_nan() || misfit > RESOLVED {
                return Err(MotionError::Unresolved { root: self.x.modulus(), misfit });
            }
        }
        Ok(found)
    }

    /// The motion under the load of a number without its parts in others, of unit modal mass, and what is left of it as a part of the whole.
    fn orthogonal(
        &self,
        others: &[Option<NetworkMotion<Y, S::Precise>>],
        number: u32,
    ) -> Result<(NetworkMotion<Y, S::Precise>, f64), MotionError> {
        let x = self.nearer.unwrap_or(self.x.precise());
        let motion = motion_everywhere(self.system, x, number, self.dislocates());
        let mut motion = motion.times(S::Precise::from_f64(1.0 / motion.size()));
        let rounded = motion.rounded(S::nearest);
        let whole = mass_product(self.system, self.x, &rounded, &rounded);
        self.check(&rounded, whole)?;
        let mut left = 1.0;
        for pass in 0..PASSES {
            for other in others.iter().flatten() {
                let rounded = [&motion, other].map(|motion| motion.rounded(S::nearest));
                let part = mass_product(self.system, self.x, &rounded[0], &rounded[1]);
                motion = motion.plus(other, (-part).precise());
            }
            let rounded = motion.rounded(S::nearest);
            let mass = mass_product(self.system, self.x, &rounded, &rounded);
            if !(mass.size() > 0.0 && mass.size().is_finite()) {
                return Err(self.not_finite());
            }
            if pass == 0 {
                left = Scalar::sqrt(mass.size() / whole.size());
            }
            motion = motion.times((S::one() / mass.sqrt()).precise());
        }
        Ok((motion, left))
    }
}

/// The shape of a simple root: the motion under a load everywhere, which is the shape but for rounding. Where that under another load
/// differs, or forces at nodes do not add up to zero, it is computed again in extended precision.
pub(super) fn simple<Y, S>(system: &Y, x: S) -> Result<PlaneShape<'_, Y, S>, MotionError>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    if is_below_losses(system, x) {
        return Err(MotionError::LossFactor);
    }
    let plain = AtRoot { system, x, nearer: None };
    let fits =
        |(shape, misfit): &(PlaneShape<'_, Y, S>, f64)| misfit.max(shape.gap()).max(shape.imbalance()) <= FITTING;
    let found = plain.simple();
    let (shape, misfit) = match found {
        _ if S::HAS_PRECISE && x.is_zero() => plain.beside().simple()?,
        Ok(found) if fits(&found) => found,
        _ if S::HAS_PRECISE => plain.extended().simple()?,
        found => found?,
    };
    if misfit <= RESOLVED { Ok(shape) } else { Err(MotionError::Unresolved { root: x.modulus(), misfit }) }
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
    if is_below_losses(system, x) {
        return Err(MotionError::LossFactor);
    }
    let wanted = usize::try_from(multiplicity).ok().filter(|wanted| *wanted <= CAP);
    let wanted = wanted.ok_or(MotionError::Capacity { capacity: CAP })?;
    if wanted == 1 {
        let mut found = PlaneShapes { shapes: [const { None }; CAP] };
        found.shapes[0] = Some(simple(system, x)?);
        return Ok(found);
    }
    let plain = AtRoot { system, x, nearer: None };
    if S::HAS_PRECISE { plain.beside().all(wanted) } else { plain.all(wanted) }
}
