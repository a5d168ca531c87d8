//! Responses in time by superposition of modes.

use crate::answer::at_rest::{AtRest, Part};
use crate::answer::facts::Facts;
use crate::answer::root::Root;
use crate::model::MotionError;
use crate::number::{Frequency, List, Oscillation, Real, Scalar, exponential, phi_1};
use core::marker::PhantomData;
use num_complex::Complex;
use num_traits::Zero;

/// Number of shapes of a multiple root for which there is room at any capacity of the response.
pub(crate) const USUAL_MULTIPLICITY: u64 = 4;
/// Difference between the static response and that of the modes, in roundings of both, up to which it counts as zero.
const ROUNDING: f64 = 64.0;

/// The response of an entry of a state in time, as a sum over modes: to an impulse, to a step, and to a force history.
///
/// With the eigenvalues λ of the modes and their shapes φ at the load and at the entry, the response to an impulse of 1 is
/// `Σ φ φ/(2λ) e^{λt}` over the eigenvalues and their conjugates, `φ φ sin(ωt)/ω` for an undamped mode and `φ φ t` for one of a
/// rigid body.
///
/// Modes that are not in the list are assumed to follow the load at once. Their part of the static response, the residual
/// compliance `H(0) - Σ`, is a part of the responses to steps and to histories, and of the static value. So massless points give
/// way at once, and deflections, forces and moments near the load become right, however few modes there are. Slow modes and points
/// far from the load follow later in truth, so that the list has to hold all modes that are slow compared with the load. The
/// response to an impulse has no residual term, since such modes would be over at once.
///
/// Rigid bodies, and parts that only dampers hold, move by the poles `r₂/λ² + r₁/λ` of the response at λ = 0, if the list has that
/// root. If it has not, they do not move off, and the residual compliance is that of the response without these poles.
///
/// A response does not borrow the system: it is a plain value. `M` is the meaning of its frequencies: [`RealFrequency`](crate::RealFrequency) for an
/// undamped system, [`ComplexEigenvalue`](crate::ComplexEigenvalue) for a damped one.
#[derive(Clone, Copy, Debug)]
pub struct ModalResponse<T, const N: usize, M> {
    pub(crate) terms: List<Term<T>, N>,
    /// `Σ φ φ` over the modes of rigid bodies: one over the mass that the load feels.
    pub(crate) rigid: T,
    /// The residual compliance.
    pub(crate) residual: T,
    /// The time by which the residual compliance is late.
    pub(crate) lag: T,
    /// What follows the rate of the load at once.
    pub(crate) flow: T,
    /// How much of the motion of the ground is in it.
    pub(crate) carried: T,
    /// How many roots were in the list.
    pub(crate) roots: usize,
    pub(crate) facts: Facts<T>,
    pub(crate) meaning: PhantomData<fn() -> M>,
}

/// The part of a mode in the response to an impulse: the real part of `residue · e^{λt}`, for an eigenvalue and its conjugate.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Term<T> {
    pub(crate) lambda: Complex<T>,
    pub(crate) residue: Complex<T>,
    /// The place of its root in the list.
    pub(crate) root: usize,
}

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// Superposes the shapes of all roots.
    #[inline(never)]
    pub(crate) fn new<'r, R>(
        source: &impl Superposed<T, R>,
        roots: impl IntoIterator<Item = &'r R>,
    ) -> Result<Self, MotionError>
    where
        R: Root<T> + 'r,
    {
        ModalResponse::of_products(source, roots, |root, _, add| source.for_each_product::<N>(root, add))
    }

    /// Superposes the shapes of all roots, given what hands on `φ φ` of each shape of a root at a place of the list.
    pub(crate) fn of_products<'r, R>(
        source: &impl Superposed<T, R>,
        roots: impl IntoIterator<Item = &'r R>,
        for_each_product: impl Fn(
            &R,
            usize,
            &mut dyn FnMut(R::Frequency) -> Result<(), MotionError>,
        ) -> Result<(), MotionError>,
    ) -> Result<Self, MotionError>
    where
        R: Root<T> + 'r,
    {
        if source.has_loss() {
            return Err(MotionError::LossFactor);
        }
        let [rigid, residual, lag, flow, carried] = [T::zero(); 5];
        let (terms, facts, meaning) = (List::new(), source.facts(), PhantomData);
        let mut response = ModalResponse { terms, rigid, residual, lag, flow, carried, roots: 0, facts, meaning };
        let mut at_rest = None;
        for root in roots {
            response.roots += 1;
            let omega = root.frequency().omega().to_complex();
            // an upper eigenvalue stands for its conjugate, too
            if omega.re < T::zero() {
                continue;
            }
            if omega.is_zero() {
                at_rest = Some(root);
                continue;
            }
            let (lambda, place) = (Complex::new(-omega.im, omega.re), response.roots - 1);
            for_each_product(root, place, &mut |product: R::Frequency| {
                let product = product.to_complex();
                let residue = if lambda.im.is_zero() { product / (lambda + lambda) } else { product / lambda };
                response.push(Term { lambda, residue, root: place })
            })?;
        }
        response.complete(source, at_rest)?;
        Ok(response)
    }

    pub(super) fn push(&mut self, term: Term<T>) -> Result<(), MotionError> {
        self.terms.push(term).map_err(|_| MotionError::Capacity { capacity: N })
    }

    /// Adds the residual compliance from the response at rest, and the motion of the root at zero if the list has it.
    #[inline(never)]
    fn complete<R: Root<T>>(&mut self, source: &impl Superposed<T, R>, at_rest: Option<&R>) -> Result<(), MotionError> {
        let held = self.held();
        let scale = self.terms.iter().fold(0.0, |sum, term| sum + term.at_rest().size());
        match (source.held_at_rest()?, at_rest) {
            (Some(whole), None) => {
                let whole = whole.to_complex().re;
                self.residual = beyond_rounding(whole - held, scale + whole.size());
                return Ok(());
            }
            // something holds the system: it may not have that root
            (Some(_), Some(root)) => {
                source.for_each_product::<{ USUAL_MULTIPLICITY as usize }>(root, &mut |_| Ok(()))?;
            }
            (None, _) => {}
        }
        let left = |x: R::Frequency| {
            let whole = source.sized(x)?;
            let omega = x.omega().to_complex();
            let (sum, size) = self.sum_at(Complex::new(-omega.im, omega.re));
            Ok(Part::new::<T>(whole.value - R::Frequency::from_complex(sum), whole.size + size))
        };
        let rest = AtRest::of::<T>(source.lowest_exponent(), scale, left)?;
        let AtRest { double, simple, finite, uncertainty, .. } = rest;
        if uncertainty > 0.0 {
            return Err(MotionError::Unsettled { change: uncertainty });
        }
        self.residual = beyond_rounding(finite.to_complex().re, scale);
        if at_rest.is_some() {
            self.rigid = double.to_complex().re;
            if !simple.is_zero() {
                self.push(Term { lambda: Complex::zero(), residue: simple.to_complex(), root: 0 })?;
            }
        }
        Ok(())
    }

    /// The acceleration of what moves off at once, under a load of 1.
    pub(crate) fn away(&self) -> T {
        self.rigid + self.carried
    }

    /// The static response of the listed modes, without those at zero.
    fn held(&self) -> T {
        self.terms.iter().fold(T::zero(), |sum, term| sum + term.at_rest())
    }

    /// The response of the listed modes at λ, and the sum of the sizes of their terms.
    pub(super) fn sum_at(&self, lambda: Complex<T>) -> (Complex<T>, f64) {
        let half = T::from_f64(0.5);
        self.terms.iter().fold((Complex::zero(), 0.0), |(sum, size), term| {
            let own = (term.residue / (lambda - term.lambda)) * half;
            let mirrored = (term.residue.conj() / (lambda - term.lambda.conj())) * half;
            (sum + own + mirrored, size + own.size() + mirrored.size())
        })
    }

    /// The entry at a time \[s\] after an impulse of 1 N s, or of 1 N m s; 0 before it, NaN for a time that is NaN. The residual
    /// compliance has no part in it.
    pub fn to_impulse(&self, time: T) -> T {
        if time < T::zero() {
            return T::zero();
        }
        let one = |term: &Term<T>| (term.residue * exponential(term.lambda * time)).re;
        self.terms.iter().fold(self.away() * time, |sum, term| sum + one(term))
    }

    /// The entry at a time \[s\] after the begin of a constant load of 1 N, or of 1 N m; 0 before it, NaN for a time that is
    /// NaN. At 0 it is the residual compliance.
    pub fn to_step(&self, time: T) -> T {
        if time < T::zero() {
            return T::zero();
        }
        let half = T::from_f64(0.5);
        let one = |term: &Term<T>| (term.residue * phi_1(term.lambda * time)).re * time;
        let away = self.away() * time * time * half;
        self.terms.iter().fold(self.residual_after(time) + away, |sum, term| sum + one(term))
    }

    /// What modes that are not in the list have followed of a step at a time.
    fn residual_after(&self, time: T) -> T {
        self.late().map_or(self.residual, |term| (term.residue * phi_1(term.lambda * time)).re * time)
    }

    /// The residual compliance as a term, where it is late.
    pub(super) fn late(&self) -> Option<Term<T>> {
        let rate = Complex::from(T::one() / self.lag);
        (!self.lag.is_zero()).then(|| Term { lambda: -rate, residue: rate * self.residual, root: 0 })
    }

    /// The static response: the entry under a constant load of 1 at rest, whatever modes are in the list.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where a rigid body of the list moves off, or drifts against a damper.
    pub fn static_value(&self) -> Result<T, MotionError> {
        if !self.away().is_zero() || self.terms.iter().any(|term| term.lambda.is_zero()) {
            return Err(MotionError::Resonance { frequency: 0.0 });
        }
        Ok(self.held() + self.residual)
    }
}

impl<T: Real> Term<T> {
    /// The static response of the mode.
    pub(super) fn at_rest(&self) -> T {
        -(self.residue / self.lambda).re
    }
}

/// A difference, or zero where it may be rounding alone, compared with the scale of its terms.
fn beyond_rounding<T: Real>(number: T, scale: f64) -> T {
    if number.size() <= ROUNDING * T::EPSILON * scale { T::zero() } else { number }
}

/// A response whose parts at roots, `φ φ` at the load and at the entry, are known by their shapes.
pub(crate) trait Superposed<T: Real, R: Root<T>> {
    /// Hands on `φ φ` for each shape of a root, of which there is room for `CAP` if there are more than usual.
    fn for_each_product<const CAP: usize>(
        &self,
        root: &R,
        add: &mut dyn FnMut(R::Frequency) -> Result<(), MotionError>,
    ) -> Result<(), MotionError>;

    /// The static limit of a system that is held; `None` where something moves off.
    fn held_at_rest(&self) -> Result<Option<R::Frequency>, MotionError>;

    /// The response, exactly.
    fn exactly(&self, x: R::Frequency) -> Result<R::Frequency, MotionError>;

    /// The response, and a size compared with which its rounding is small.
    fn sized(&self, x: R::Frequency) -> Result<Part<R::Frequency>, MotionError>;

    /// Logarithm to base 2 of a frequency below all roots but those at zero.
    fn lowest_exponent(&self) -> i32;

    /// What its load and its entry are.
    fn facts(&self) -> Facts<T>;

    /// Whether something has a loss factor.
    fn has_loss(&self) -> bool;
}
