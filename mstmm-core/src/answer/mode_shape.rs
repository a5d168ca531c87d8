//! Mode shapes: the motion of a system at a root.

use crate::answer::dominant_entry::Candidate;
use crate::answer::energies::Form;
use crate::answer::root::is_below_losses;
use crate::answer::states::SystemStates;
use crate::model::MotionError;
use crate::number::{Magnitude, Oscillation, Scalar, Scaled, Single};
use crate::pass::both_ways::Passes;
use crate::pass::characteristic::System;
use crate::pass::tree::{ExtendedTree, Tree};
use core::fmt;
use core::ops::Deref;

/// Relative step of the secant method: as large as the rounding of a root, so that another root as near as a hundred roundings does not matter.
const STEP: f64 = f64::EPSILON;

/// Relative distance beyond which a root is not the number rounded. Eigenvalues are less exact than natural frequencies.
const NEAR: f64 = 1e-13;

/// Part by which the square of an entry may differ from the residue of its response. Another root takes part in that by the step over its distance.
const TRAPPED: f64 = 0.1;

/// The motion of a system at a root, normalised to unit modal mass; dereferences to its states.
///
/// It is real for a natural frequency, complex for an eigenvalue. With deflections in m the modal mass is 1 kg m²;
/// [`with_unit_deflection`](ModeShape::with_unit_deflection) makes the largest deflection 1 m.
#[derive(Debug)]
pub struct ModeShape<'a, Y: Tree<S> + ?Sized, S: Single> {
    field: SystemStates<'a, Y, S>,
}

impl<Y: Tree<S> + ?Sized, S: Single> Clone for ModeShape<'_, Y, S> {
    fn clone(&self) -> Self {
        ModeShape { field: self.field.clone() }
    }
}

impl<'a, Y: Tree<S> + ?Sized, S: Single> Deref for ModeShape<'a, Y, S> {
    type Target = SystemStates<'a, Y, S>;

    fn deref(&self) -> &SystemStates<'a, Y, S> {
        &self.field
    }
}

/// The shapes of one root.
pub struct ShapeList<'a, Y: Tree<S> + ?Sized, S: Single, const CAP: usize> {
    pub(crate) shapes: [Option<ModeShape<'a, Y, S>>; CAP],
}

impl<Y, S, const CAP: usize> fmt::Debug for ShapeList<'_, Y, S, CAP>
where
    Y: Tree<S> + fmt::Debug + ?Sized,
    S: Single,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

impl<'a, Y: Tree<S> + ?Sized, S: Single, const CAP: usize> ShapeList<'a, Y, S, CAP> {
    /// The shapes, one after the other.
    pub fn iter(&self) -> impl Iterator<Item = &ModeShape<'a, Y, S>> {
        self.shapes.iter().flatten()
    }
}

/// The shape of a simple root, in extended precision: a root that is rounded to the next number is too far from the exact one where
/// others are close, and the rounded states may fit together all the same.
pub(crate) fn simple<S, Y>(system: &Y, x: S) -> Result<ModeShape<'_, Y, S>, MotionError>
where
    Y: ExtendedTree<S> + ?Sized,
    S: Oscillation<<Y as System>::Parameter>,
{
    if is_below_losses(system, x) {
        return Err(MotionError::LossFactor);
    }
    if !S::HAS_EXTENDED {
        return at_root(system, x)?.accepted();
    }
    let nearer = nearer_root(system, x.to_extended())?;
    let shape = at_root(system, nearer.x)?;
    if let Some(misfit) = nearer.misfit(&shape).filter(|misfit| *misfit > TRAPPED) {
        return Err(MotionError::Unresolved { root: x.modulus(), misfit });
    }
    ModeShape::of_extended(&shape).accepted()
}

/// A root with more digits, and what the slope of Δ there says of its shape.
struct Nearer<S> {
    x: S,
    /// The entry in which the shape shows best.
    best: Candidate,
    /// The square of that entry in a shape of unit modal mass: the residue of its response in λ².
    square: S,
}

impl<S: Single> Nearer<S> {
    /// What the square of an entry in an undamped shape differs by from the residue, as a part of it. The modal mass of a shape follows from the states at
    /// the ends of elements. Where a motion is trapped inside an element, these are rounding.
    fn misfit<Y>(&self, shape: &ModeShape<'_, Y, S>) -> Option<f64>
    where
        Y: Tree<S> + ?Sized,
        S: Oscillation<Y::Parameter>,
    {
        let entry = shape.at(self.best.step, false).entry(self.best.coordinate);
        let ratio = (entry * entry).size() / self.square.size();
        let is_known = self.x.lambda().is_zero() && !self.x.is_zero() && self.square.size().is_finite();
        is_known.then(|| (ratio - 1.0).abs())
    }
}

/// The root after a step of the secant method with Δ at the point where the shape shows best, from a value rounded to fewer digits.
fn nearer_root<S, Y>(system: &Y, x: S) -> Result<Nearer<S>, MotionError>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    let passes = Passes::whole(system, x);
    let best = passes.dominant().ok_or(MotionError::NotFinite { frequency: x.modulus() })?;
    let (point, delta) = (best.step, passes.meeting(best.step).delta());
    let beside = x + x * S::from_f64(STEP);
    let mut away = Passes::from_tips(system, beside, |_| true);
    away.down_to(point);
    let ratio = away.meeting(point).delta().over(delta).value();
    let step = x * S::from_f64(STEP) / (ratio - S::one());
    let square = passes.meeting(point).square(best.coordinate).over(delta).value() * step * x.slope_of_lambda_squared();
    // where Δ is zero, or as small as it can be, there is nothing to gain
    Ok(Nearer { x: if step.size() <= NEAR * x.size() { x - step } else { x }, best, square })
}

/// The shape of a simple root, in the precision of `S` alone.
fn at_root<S, Y>(system: &Y, x: S) -> Result<ModeShape<'_, Y, S>, MotionError>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    let frequency = x.modulus();
    let passes = Passes::whole(system, x);
    let Some(best) = passes.dominant() else { return Err(MotionError::NotFinite { frequency }) };
    let square = passes.meeting(best.step).square(best.coordinate);
    // the difference of the states on both sides of the point, compared with usual states there
    let jump = passes.meeting(best.step).delta().over(square);
    let mismatch = jump.magnitude().value() / best.unit;
    if mismatch.is_nan() {
        return Err(MotionError::NotFinite { frequency });
    }
    // a root known to rounding, in a shape whose energy is spread over a thousand waves, gives less than half of the digits
    if mismatch > <Y::Parameter as Scalar>::EPSILON.sqrt() {
        return Err(MotionError::NotARoot { frequency, mismatch });
    }
    let jump = passes.meeting(best.step).jump(best.coordinate.dual());
    let recovered = passes.recover(best.step, jump.upstream, jump.downstream);
    let largest = recovered.states.as_ref().iter().filter_map(|state| state.magnitude()).max();
    let field = SystemStates::of(system, x, &recovered, -largest.unwrap_or(0));
    ModeShape::normalised(field).ok_or(MotionError::NotFinite { frequency })
}

impl<S: Single, Y: Tree<S> + ?Sized> Passes<'_, Y, S> {
    /// The entry with the largest energy.
    fn dominant(&self) -> Option<Candidate> {
        let mut best: Option<(Candidate, Magnitude)> = None;
        self.for_each_candidate(|candidate| {
            let energy = self.energy(&candidate);
            if best.is_none_or(|(_, most)| energy > most) {
                best = Some((candidate, energy));
            }
        });
        best.map(|(candidate, _)| candidate)
    }

    /// The square of an entry as an energy, times Δ and a constant.
    fn energy(&self, candidate: &Candidate) -> Magnitude {
        let square = self.meeting(candidate.step).square(candidate.coordinate);
        Scaled::new(square.mantissa().size() * candidate.unit, square.exponent()).into()
    }
}

impl<'a, Y, S> ModeShape<'a, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    /// A shape of given states.
    pub(crate) fn of(field: SystemStates<'a, Y, S>) -> Self {
        ModeShape { field }
    }

    /// The shape of unit modal mass; `None` if the modal mass of the states is zero or not finite.
    pub(crate) fn normalised(field: SystemStates<'a, Y, S>) -> Option<Self> {
        let mut shape = ModeShape { field };
        let mass = shape.modal_mass();
        if !(mass.size() > 0.0 && mass.size().is_finite()) {
            return None;
        }
        let factor = S::one() / mass.sqrt();
        shape.scale(factor);
        Some(shape)
    }

    pub(crate) fn scale(&mut self, factor: S) {
        self.field.map(|state| state.map(|entry| entry * factor));
    }

    /// The shape plus another times a factor.
    pub(crate) fn add(&mut self, other: &Self, factor: S) {
        self.field.add(&other.field, factor);
    }

    /// The modal mass `φᵀ M φ [+ φᵀ C φ/(2λ)]`, of a rotor `φᵀ M φ - φᵀ Ω G φ/(2ω)`: 1, unless the shape was scaled.
    pub fn modal_mass(&self) -> S {
        self.product(self)
    }

    /// The modal stiffness `φᵀ K φ`; at a natural frequency ω² times the modal mass.
    pub fn modal_stiffness(&self) -> S {
        self.field.form(Form::Stiffness, &self.field)
    }

    /// `φ₁ᵀ M φ₂ + φ₁ᵀ C φ₂/(λ₁ + λ₂)`: zero for shapes of different roots. Of a rotor it is `φ₁ᵀ M φ₂ - φ₁ᵀ Ω G φ₂/(ω₁ + ω₂)`, zero for shapes of
    /// one whirl.
    ///
    /// Integrals along beams are exact; rigid bodies, masses and dampers take part.
    pub fn product(&self, other: &Self) -> S {
        let mass = self.field.form(Form::Mass, &other.field);
        let [first, second] = [self.field.x, other.field.x];
        let sum = if const { Y::SPINS } {
            (first.slope_of_lambda_squared() + second.slope_of_lambda_squared()) * S::from_f64(0.5)
        } else {
            first.lambda() + second.lambda()
        };
        if sum.is_zero() { mass } else { mass + self.field.form(Form::Damping, &other.field) / sum }
    }

    /// The shape divided by its largest deflection in size; `None` if nothing deflects.
    #[must_use]
    pub fn with_unit_deflection(mut self) -> Option<Self> {
        let largest = self.field.largest_deflection();
        if largest.is_zero() {
            return None;
        }
        self.scale(S::one() / largest);
        Some(self)
    }
}
