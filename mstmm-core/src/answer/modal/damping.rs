//! Damping of modes: a ratio each, or damping in proportion.

use crate::answer::modal::response::{ModalResponse, Term};
use crate::model::MotionError;
use crate::number::{ComplexEigenvalue, List, Real, RealFrequency, Scalar};
use crate::search::ProportionalDamping;
use num_complex::Complex;
use num_traits::Zero;

/// Distance of both real eigenvalues of a mode, over the larger one, below which their parts cancel more than half of their digits.
const CRITICAL: f64 = 1e-8;

/// A response with damping.
type Damped<T, const N: usize> = ModalResponse<T, N, ComplexEigenvalue>;

/// A damping ratio with which a mode vibrates.
///
/// # Errors
/// [`MotionError::DampingRatio`] for one that is negative, or 1 and more.
pub(crate) fn checked<T: Real>(ratio: T) -> Result<T, MotionError> {
    let vibrates = ratio >= T::zero() && ratio < T::one();
    if vibrates { Ok(ratio) } else { Err(MotionError::DampingRatio { ratio: ratio.to_f64() }) }
}

/// Checks that a list of ratios has one for each root.
///
/// # Errors
/// [`MotionError::DampingRatios`] for another number of them.
pub(crate) fn check_count<T>(ratios: &[T], roots: usize) -> Result<(), MotionError> {
    let given = ratios.len();
    if given == roots { Ok(()) } else { Err(MotionError::DampingRatios { given, needed: roots }) }
}

/// `ω_d/ω` at a damping ratio.
fn slowed_by<T: Real>(ratio: T) -> T {
    ((T::one() - ratio) * (T::one() + ratio)).sqrt()
}

/// The eigenvalue `-ζω + iω_d` of a mode with a damping ratio.
pub(crate) fn damped_by<T: Real>(omega: T, ratio: T) -> Complex<T> {
    Complex::new(-(ratio * omega), slowed_by(ratio) * omega)
}

impl<T: Real, const N: usize> ModalResponse<T, N, RealFrequency> {
    /// The response with a damping ratio ζ in each mode: `e^{-ζωt} sin(ω_d t)/ω_d` in place of `sin(ωt)/ω`, with
    /// `ω_d = ω sqrt(1 - ζ²)`. Rigid bodies move as before, and modes that are not in the list still follow at once.
    ///
    /// Under the motion of a support each mode is damped relative to the support, not against a place at rest: its part is
    /// `-λ²(φφ/ω²)/(λ² + 2ζωλ + ω²)` beside the static response.
    ///
    /// A force or a moment is that of the stiffness, without what damps it.
    ///
    /// # Errors
    /// [`MotionError::DampingRatio`] for a ratio that is negative, or 1 and more, where nothing vibrates; [`MotionError::Derived`] for a rate.
    pub fn with_damping_ratio(&self, ratio: T) -> Result<Damped<T, N>, MotionError> {
        self.with_ratios(|_, _| ratio)
    }

    /// The response with a damping ratio for each root of the list, in its order; a root at rest has none, and its number means nothing.
    ///
    /// # Errors
    /// [`MotionError::DampingRatios`] for another number of ratios than roots; else as [`with_damping_ratio`](ModalResponse::with_damping_ratio).
    pub fn with_damping_ratios(&self, ratios: &[T]) -> Result<Damped<T, N>, MotionError> {
        check_count(ratios, self.roots)?;
        self.with_ratios(|root, _| ratios[root])
    }

    /// The response with a damping ratio for each mode by its frequency ω [rad/s].
    ///
    /// # Errors
    /// As [`with_damping_ratio`](ModalResponse::with_damping_ratio).
    pub fn with_damping_ratios_by(&self, mut ratio: impl FnMut(T) -> T) -> Result<Damped<T, N>, MotionError> {
        self.with_ratios(|_, omega| ratio(omega))
    }

    fn with_ratios(&self, mut ratio: impl FnMut(usize, T) -> T) -> Result<Damped<T, N>, MotionError> {
        let mut damped = self.without_terms()?;
        for term in &self.terms {
            let omega = term.lambda.im;
            let ratio = checked(ratio(term.root, omega))?;
            let (lambda, residue) = (damped_by(omega, ratio), term.residue / slowed_by(ratio));
            damped.push(Term { lambda, residue, root: term.root }.moved_with(self, omega))?;
        }
        Ok(damped)
    }

    /// The response with damping in proportion to inertias and stiffnesses, `C = α M + β K`: each mode has the eigenvalues of this damping, and modes that are
    /// not in the list follow late, by `ρ/(1 + βλ)`. A mode that does not vibrate any more has two terms in place of one.
    ///
    /// A force or a moment is that of the stiffness and of its damping, `1 + βλ` times that of the stiffness. A motion of a support moves what it damps with it, as in
    /// [`with_damping_ratio`](ModalResponse::with_damping_ratio).
    ///
    /// # Errors
    /// [`MotionError::LossFactor`] for a loss factor, which has no motions in time; [`MotionError::AxialForce`] for damping of stiffnesses where a member bears an axial
    /// force; [`MotionError::Critical`] for a mode that is critically damped to 1e-8; [`MotionError::Derived`] for a rate; [`MotionError::Capacity`] for more terms than `N`.
    pub fn with_damping(&self, damping: &ProportionalDamping<T>) -> Result<Damped<T, N>, MotionError> {
        if !damping.loss_factor().is_zero() {
            return Err(MotionError::LossFactor);
        }
        let (alpha, beta) = (damping.of_inertias(), damping.of_stiffnesses());
        if self.facts.obstacles.axial_force && !beta.is_zero() {
            return Err(MotionError::AxialForce);
        }
        let mut damped = self.without_terms()?;
        if !(self.facts.is_motion || self.facts.is_force) {
            damped.lag = beta;
        }
        for term in &self.terms {
            let omega = term.lambda.im;
            // φφ of the mode
            let product = (term.residue * term.lambda).re;
            let [first, second] = damping.eigenvalues_at(omega);
            let apart = first - second;
            if apart.size() <= CRITICAL * first.size().max(second.size()) {
                return Err(MotionError::Critical { frequency: omega.to_f64() });
            }
            let own = |lambda: Complex<T>, residue| Term { lambda, residue, root: term.root }.moved_with(self, omega);
            if first.im.is_zero() {
                damped.push(own(first, Complex::from(product) / apart))?;
                damped.push(own(second, -(Complex::from(product) / apart)))?;
            } else {
                damped.push(own(first, Complex::from(product + product) / apart))?;
            }
        }
        if self.facts.is_force {
            damped.add_forces_of_damping(beta);
        }
        damped.drag(self.rigid, alpha)?;
        Ok(damped)
    }

    /// What is no mode, for a response with damping.
    fn without_terms(&self) -> Result<Damped<T, N>, MotionError> {
        if self.facts.is_derived {
            return Err(MotionError::Derived);
        }
        let ModalResponse { rigid, residual, lag, flow, carried, roots, facts, .. } = *self;
        let (terms, meaning) = (List::new(), core::marker::PhantomData);
        Ok(ModalResponse { terms, rigid, residual, lag, flow, carried, roots, facts, meaning })
    }
}

impl<T: Real, const N: usize> Damped<T, N> {
    /// The response times `1 + βλ`, of which what grows with λ follows the rate of the load. A force that follows a force at once has damping within it.
    fn add_forces_of_damping(&mut self, beta: T) {
        let mut at_once = T::zero();
        for term in self.terms.as_mut_slice() {
            at_once += term.residue.re;
            term.residue *= Complex::from(T::one()) + term.lambda * beta;
        }
        if self.facts.is_motion {
            self.flow = self.residual * beta;
            self.residual += at_once * beta;
        }
    }

    /// Rigid bodies that a damping α drags: `1/(λ² + αλ)`, one that drifts and one that stops, in place of `1/λ²`.
    fn drag(&mut self, rigid: T, alpha: T) -> Result<(), MotionError> {
        if rigid.is_zero() || alpha.is_zero() {
            return Ok(());
        }
        self.rigid = T::zero();
        let residue = Complex::from(rigid / alpha);
        self.push(Term { lambda: Complex::zero(), residue, root: 0 })?;
        self.push(Term { lambda: Complex::from(-alpha), residue: -residue, root: 0 })
    }
}

impl<T: Real> Term<T> {
    /// The term under the motion of a support, whose damping moves with it: `-λ²/ω²` times that of a force.
    fn moved_with<const N: usize, M>(self, response: &ModalResponse<T, N, M>, omega: T) -> Self {
        if !response.facts.is_motion {
            return self;
        }
        let along = self.lambda / omega;
        Term { residue: -(self.residue * along * along), ..self }
    }
}
