//! Mode shapes of plane structures.

use crate::answer::misfit::worse;
use crate::answer::network::states::PlaneStates;
use crate::answer::root::{check_at_rest, is_below_losses};
use crate::element::Forms;
use crate::model::MotionError;
use crate::number::Scalar;
use crate::pass::characteristic::System;
use crate::pass::network::{
    Loading, MovingNetwork, NetworkMotion, Placed, PlaneFrequency, mass_product, mass_product_of_two, motions_under,
};
use core::ops::Deref;

/// How often parts of other shapes are taken from one: each time leaves rounding of what was there.
const PASSES: usize = 3;

/// Distance on both sides of a root in which its shapes are computed, in units of the rounding of the root. The roots of an entry are within 4 of
/// these. Another root takes part by the square of this distance over its own.
const BESIDE: f64 = 16.0;

/// Steps with Rayleigh's quotient. Each squares the distance beside that of other roots: one does from 16 digits to 32, and five more where another
/// root is as near as rounding.
const STEPS: usize = 6;

/// Relative size of a step below which no other follows, in units of rounding in extended precision: four digits for what stiff members take.
const SETTLED: f64 = 16_384.0;

/// Relative distance of the root, by Rayleigh's quotient, beyond which the number is not the root rounded, in units of its rounding: of a natural
/// frequency, and of an eigenvalue, which is less exact.
const ROUNDED: [f64; 2] = [4.0, 512.0];

/// Relative size of λ² - λ₁², with λ₁ the root, beyond which a frequency is none.
const NO_ROOT: f64 = 1e-7;

/// Distance, in bits, below the lowest frequency that a part may have: what is less than that is rest, as rounding of stiff parts has it.
const REST: i32 = 10;

/// What must be left of a motion without its parts in other shapes of a root, or other loads are tried, and how many.
const LEFT: f64 = 1e-3;
const RETRIES: usize = 4;

/// The modal mass of a shape beside that of its size, below which two roots share it.
const DEFECTIVE: f64 = 1e-5;

/// The difference of shapes under two loads beyond which other roots are too close for any precision. What is less is rounding, and no shape.
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

    /// The modal mass `φᵀ M φ [+ φᵀ C φ/(2λ)]`, of a rotor `φᵀ M φ - φᵀ Ω G φ/(2ω)`: 1, unless the shape was scaled.
    pub fn modal_mass(&self) -> S {
        mass_product(self.system, self.x, &self.motion, &self.motion)
    }

    /// The largest sum of forces on the motions of a node, of a shape of unit modal mass, beside the largest force.
    ///
    /// Where all ends are free, as of a beam in the air, there is no force but that of the inertia inside of members: `|λ|²` times the modal mass is
    /// its work on the shape, so that over the largest displacement is its size.
    fn relative_imbalance(&self) -> f64 {
        let [worst, largest] = self.imbalance();
        if worst <= RESOLVED * largest {
            return if worst > 0.0 { worst / largest } else { 0.0 };
        }
        let displacement = self.largest_deflection().max(self.largest_motion());
        let inertia = if displacement > 0.0 { self.x.lambda_squared().size() / displacement } else { 0.0 };
        worst / largest.max(inertia)
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

/// A motion of the size 1.
#[inline(never)]
fn of_size_one<Y: Placed, S: Scalar>(motion: NetworkMotion<Y, S>) -> NetworkMotion<Y, S> {
    motion.times(S::from_f64(1.0 / motion.size()))
}

/// A motion less its part in another one of unit modal mass.
#[inline(never)]
fn without<Y, S>(system: &Y, x: S, motion: &NetworkMotion<Y, S>, other: &NetworkMotion<Y, S>) -> NetworkMotion<Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    motion.plus(other, -mass_product(system, x, motion, other))
}

/// The motions under loads everywhere at a root.
#[derive(Clone, Copy)]
struct AtRoot<'a, Y: Placed, S: PlaneFrequency<Y::Parameter>> {
    system: &'a Y,
    x: S,
}

impl<'a, Y, S> AtRoot<'a, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    /// The motions under the load of a number and the next one at a frequency in extended precision, of the size 1.
    #[inline(never)]
    fn precise_motions(&self, x: S::Extended, number: u32) -> [NetworkMotion<Y, S::Extended>; 2] {
        motions_under(self.system, x, &self.load(number)).map(of_size_one)
    }

    /// The motions under the load of a number and the next one beside a root, less those on its other side: shapes of the root grow with opposite
    /// signs, and what others and the load leave is the same. At rest nothing is taken off: what vanishes there is rounding alone.
    #[inline(never)]
    fn motions_beside(&self, number: u32) -> [NetworkMotion<Y, S::Extended>; 2] {
        let x = self.x.to_extended();
        if self.x.is_zero() {
            return self.precise_motions(x, number);
        }
        // without extended precision the distance is between its own rounding and that of the answer
        let distance = if S::HAS_EXTENDED { BESIDE * S::EPSILON } else { Scalar::sqrt(S::EPSILON) };
        let [above, below] = [distance, -distance]
            .map(|distance| motions_under(self.system, x + x * S::Extended::from_f64(distance), &self.load(number)));
        [0, 1].map(|load| of_size_one(above[load].plus(&below[load], -S::Extended::from_f64(1.0))))
    }

    /// The load of a number: forces on all displacements and dislocations, in the units of the root on both sides of it.
    fn load<R: Scalar>(&self, number: u32) -> Loading<'static, R> {
        // at rest, beside motions without stiffness, dislocations would not be small
        Loading::everywhere(number, !self.x.is_zero(), (self.system, self.x.lambda_squared()))
    }

    fn not_finite(&self) -> MotionError {
        MotionError::NotFinite { frequency: self.x.modulus() }
    }

    /// A motion with unit modal mass.
    ///
    /// # Errors
    /// It is not finite, or the frequency is no root.
    #[inline(never)]
    fn normalised(&self, motion: NetworkMotion<Y, S>) -> Result<NetworkMotion<Y, S>, MotionError> {
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
        let Forms { mass: kinetic, damping, .. } = self.shape(motion.clone()).whole();
        mass.size() < DEFECTIVE * (kinetic.size() + damping.size() / lambda.size())
    }

    /// Checks that the frequency is a root, given a motion there and its modal mass: the work of the load over the mass is λ² less that of
    /// the root.
    #[inline(never)]
    fn check(&self, motion: &NetworkMotion<Y, S>, mass: S) -> Result<(), MotionError> {
        // rest has no size to compare with
        let (at, limit) = if self.x.is_zero() {
            (S::from_extended(S::steady(self.system.frequency_estimates().least_exponent() - REST)), 1.0)
        } else {
            (self.x, NO_ROOT)
        };
        let mismatch = (motion.work / mass / at.lambda_squared()).size();
        if at.is_zero() || mismatch <= limit {
            return Ok(());
        }
        Err(MotionError::NotARoot { frequency: self.x.modulus(), mismatch })
    }

    /// The motions under two loads at the root, found by steps with Rayleigh's quotient: the work of a load on its motion over the modal mass is λ²
    /// less that of the root.
    #[inline(never)]
    fn motions_at_root(&self) -> [NetworkMotion<Y, S>; 2] {
        let x = self.x.to_extended();
        let rounded = ROUNDED[usize::from(!self.x.lambda().is_zero())] * S::EPSILON;
        let mut nearer = x;
        let mut motions = self.precise_motions(nearer, 0);
        for _ in 0..STEPS {
            let motion = &motions[0];
            let plain = motion.rounded(S::from_extended);
            let mass = mass_product(self.system, self.x, &plain, &plain);
            let step = motion.work / (mass * self.x.slope_of_lambda_squared()).to_extended();
            let is_near = (nearer - step - x).size() <= rounded * x.size();
            let is_settled = step.size() <= SETTLED * S::Extended::EPSILON * x.size();
            // a NaN is no root either
            if !is_near || is_settled {
                break;
            }
            nearer -= step;
            motions = self.precise_motions(nearer, 0);
        }
        motions.map(|motion| motion.rounded(S::from_extended))
    }

    fn shape(&self, motion: NetworkMotion<Y, S>) -> PlaneShape<'a, Y, S> {
        PlaneShape { states: PlaneStates { system: self.system, x: self.x, motion, load: None } }
    }

    /// The shape of a simple root, given the motions under two loads, and how far it is off: the second motion from it, or forces from balance.
    fn simple(&self, [motion, other]: [NetworkMotion<Y, S>; 2]) -> Result<(PlaneShape<'a, Y, S>, f64), MotionError> {
        let (motion, other) = (self.normalised(motion)?, self.normalised(other)?);
        let difference = without(self.system, self.x, &other, &motion);
        let misfit = mass_product(self.system, self.x, &difference, &difference).size().sqrt();
        let shape = self.shape(motion);
        // at rest no force is there to compare with
        let imbalance = if self.x.is_zero() { 0.0 } else { shape.relative_imbalance() };
        let misfit = worse(misfit.max(imbalance), shape.trapped());
        Ok((shape, misfit))
    }

    /// As many shapes as a root has, orthogonal with respect to the mass.
    ///
    /// A light part moves much farther than a heavy one. So motions stay in extended precision until all others are taken from them. What is
    /// left of one more motion, under another load, tells how far other roots take part.
    fn all<const CAP: usize>(&self, multiplicity: usize) -> Result<PlaneShapes<'a, Y, S, CAP>, MotionError> {
        let mut found = PlaneShapes { shapes: [const { None }; CAP] };
        let mut motions = [const { None::<NetworkMotion<Y, S::Extended>> }; CAP];
        // a factor has the motions of two numbers
        let (mut number, mut pair) = (0, self.motions_beside(0));
        let mut next = || {
            if number > 0 && number % 2 == 0 {
                pair = self.motions_beside(number);
            }
            number += 1;
            pair[(number as usize - 1) % 2].clone()
        };
        for shape in 0..multiplicity {
            let mut best = self.orthogonal(&motions[..shape], next())?;
            for _ in 0..RETRIES {
                if best.1 > LEFT {
                    break;
                }
                let other = self.orthogonal(&motions[..shape], next())?;
                best = if other.1 > best.1 { other } else { best };
            }
            let (motion, left) = best;
            let rounded = motion.rounded(S::from_extended);
            if left < RESOLVED || self.is_defective(&rounded, S::one()) {
                let (root, multiplicity, shapes) = (self.x.modulus(), multiplicity as u64, shape.max(1) as u64);
                return Err(MotionError::Defective { root, multiplicity, shapes });
            }
            (found.shapes[shape], motions[shape]) = (Some(self.shape(rounded)), Some(motion));
        }
        let (_, misfit) = self.orthogonal(&motions[..multiplicity], next())?;
        if misfit.is_nan() || misfit > RESOLVED {
            return Err(MotionError::Unresolved { root: self.x.modulus(), misfit });
        }
        Ok(found)
    }

    /// A motion without its parts in others, of unit modal mass, and what is left of it as a part of the whole.
    fn orthogonal(
        &self,
        others: &[Option<NetworkMotion<Y, S::Extended>>],
        mut motion: NetworkMotion<Y, S::Extended>,
    ) -> Result<(NetworkMotion<Y, S::Extended>, f64), MotionError> {
        let rounded = motion.rounded(S::from_extended);
        let whole = mass_product(self.system, self.x, &rounded, &rounded);
        self.check(&rounded, whole)?;
        let mut left = 1.0;
        for pass in 0..PASSES {
            for other in others.iter().flatten() {
                let rounded = [&motion, other].map(|motion| motion.rounded(S::from_extended));
                let part = mass_product(self.system, self.x, &rounded[0], &rounded[1]);
                motion = motion.plus(other, (-part).to_extended());
            }
            let rounded = motion.rounded(S::from_extended);
            let mass = mass_product(self.system, self.x, &rounded, &rounded);
            if pass == 0 {
                left = Scalar::sqrt(mass.size() / whole.size());
            }
            // rounding is no shape
            if left < RESOLVED {
                break;
            }
            if !(mass.size() > 0.0 && mass.size().is_finite()) {
                return Err(self.not_finite());
            }
            motion = motion.times((S::one() / mass.sqrt()).to_extended());
        }
        Ok((motion, left))
    }
}

/// The shape of a simple root: the difference of motions on both sides of it, under a load everywhere. Where that under another load differs, the
/// root has another one beside it, and the motion at the root itself is told from that of the other one.
pub(crate) fn simple<Y, S>(system: &Y, x: S) -> Result<PlaneShape<'_, Y, S>, MotionError>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    if is_below_losses(system, x) {
        return Err(MotionError::LossFactor);
    }
    check_at_rest(system, x)?;
    let at_root = AtRoot { system, x };
    let beside = at_root.simple(at_root.motions_beside(0).map(|motion| motion.rounded(S::from_extended)));
    match beside {
        Ok((shape, misfit)) if misfit <= RESOLVED => Ok(shape),
        beside if x.is_zero() || !S::HAS_EXTENDED => Err(match beside {
            Ok((_, misfit)) => MotionError::Unresolved { root: x.modulus(), misfit },
            Err(error) => error,
        }),
        _ => {
            let (shape, misfit) = at_root.simple(at_root.motions_at_root())?;
            if misfit <= RESOLVED { Ok(shape) } else { Err(MotionError::Unresolved { root: x.modulus(), misfit }) }
        }
    }
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
    check_at_rest(system, x)?;
    let wanted = usize::try_from(multiplicity).ok().filter(|wanted| *wanted <= CAP);
    let wanted = wanted.ok_or(MotionError::Capacity { capacity: CAP })?;
    if wanted == 1 {
        let mut found = PlaneShapes { shapes: [const { None }; CAP] };
        found.shapes[0] = Some(simple(system, x)?);
        return Ok(found);
    }
    AtRoot { system, x }.all(wanted)
}
