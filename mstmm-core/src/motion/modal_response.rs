//! Responses in time by superposition of modes.

use super::error::MotionError;
use super::exponentials::{exponential, phi_1};
use super::force_history::ForceHistory;
use super::forms::Form;
use super::label::{Entry, Load};
use super::motions::Motions;
use super::response::Place;
use super::root::Root;
use super::shape::ModeShape;
use super::tree::{JudgedTree, Planned, Tree};
use crate::characteristic::System;
use crate::list::List;
use crate::scalar::{ComplexEigenvalue, Frequency, Oscillation, Real, RealFrequency, Scalar};
use crate::state::Coordinate;
use core::marker::PhantomData;
use num_complex::Complex;
use num_traits::Zero;

/// Shapes of a multiple root for which there is room at least, whatever the capacity of the response.
const USUAL_MULTIPLICITY: u64 = 4;

/// The response of an entry of a state in time, as a sum over modes: to an impulse, to a step, and to a force history.
///
/// With the eigenvalues λ of the modes and their shapes φ at the load and at the entry, the response to an impulse of 1 is
/// `Σ φ φ/(2λ) e^{λt}` over the eigenvalues and their conjugates, `φ φ sin(ωt)/ω` for an undamped mode and `φ φ t` for one of a
/// rigid body. Modes that are not in the list take no part: deflections far from the load hardly miss them, forces and moments
/// near it do.
///
/// A response depends on the system no more: it is a plain value. `M` is what its frequencies mean: [`RealFrequency`] for an
/// undamped system, [`ComplexEigenvalue`] for a damped one.
#[derive(Clone, Copy, Debug)]
pub struct ModalResponse<T, const N: usize, M> {
    pub(super) terms: List<Term<T>, N>,
    /// `Σ φ φ` over the modes of rigid bodies: one over the mass that the load feels.
    pub(super) rigid: T,
    meaning: PhantomData<fn() -> M>,
}

/// What a mode adds to the response to an impulse: the real part of `residue · e^{λt}`, for an eigenvalue and its conjugate.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Term<T> {
    pub(super) lambda: Complex<T>,
    pub(super) residue: Complex<T>,
}

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// Superposes the shapes of all roots.
    pub(super) fn new<'r, Y, R>(
        system: &Y,
        roots: impl IntoIterator<Item = &'r R>,
        load: Load<Y::Model>,
        entry: Entry<Y::Model>,
    ) -> Result<Self, MotionError>
    where
        R: Root<T> + 'r,
        Y: JudgedTree<R::Frequency> + System<Parameter = T>,
    {
        let places = Places::new::<Y>(load, entry)?;
        let mut response = ModalResponse { terms: List::new(), rigid: T::zero(), meaning: PhantomData };
        for root in roots {
            // the conjugate of an upper eigenvalue, for which that one stands
            if root.frequency().omega().to_complex().re < T::zero() {
                continue;
            }
            match root.multiplicity() {
                0 | 1 => response.add(&system.mode_shape(root)?, &places, 1)?,
                2..=USUAL_MULTIPLICITY => {
                    response.add_all::<{ USUAL_MULTIPLICITY as usize }, Y, R>(system, root, &places)?
                }
                _ => response.add_all::<N, Y, R>(system, root, &places)?,
            }
        }
        Ok(response)
    }

    /// The shapes of a multiple root; a call, whose memory for them is there no longer than they are.
    #[inline(never)]
    fn add_all<const CAP: usize, Y, R>(&mut self, system: &Y, root: &R, places: &Places) -> Result<(), MotionError>
    where
        R: Root<T>,
        Y: JudgedTree<R::Frequency> + System<Parameter = T>,
    {
        let shapes = system.mode_shapes::<CAP, _>(root)?;
        shapes.iter().try_for_each(|shape| self.add(shape, places, root.multiplicity()))
    }

    /// Adds what a shape of a root contributes.
    fn add<Y, S>(&mut self, shape: &ModeShape<'_, Y, S>, places: &Places, multiplicity: u64) -> Result<(), MotionError>
    where
        Y: Tree<S, Parameter = T> + ?Sized,
        S: Oscillation<T>,
    {
        let product = places.product(shape).to_complex();
        let omega = shape.x.omega().to_complex();
        let lambda = Complex::new(-omega.im, omega.re);
        let residue = if lambda.is_zero() {
            let damping = shape.form(Form::Damping, shape).to_complex();
            // one eigenvalue at zero belongs to what only dampers hold; a rigid body that nothing holds has two
            if damping.size() <= 1.0.times_power_of_two(shape.system.bounds().negligible_exponent()) {
                self.rigid += product.re;
                return Ok(());
            }
            if multiplicity > 1 {
                return Err(MotionError::Defective { root: 0.0, multiplicity, shapes: 1 });
            }
            product / damping
        } else if lambda.im.is_zero() {
            product / (lambda + lambda)
        } else {
            product / lambda
        };
        self.terms.push(Term { lambda, residue }).map_err(|_| MotionError::Capacity { capacity: N })
    }

    /// The entry at a time \[s\] after an impulse of 1 N s, or of 1 N m s; 0 before it, NaN for a time that is none.
    pub fn to_impulse(&self, time: T) -> T {
        if time < T::zero() {
            return T::zero();
        }
        let one = |term: &Term<T>| (term.residue * exponential(term.lambda * time)).re;
        self.terms.iter().fold(self.rigid * time, |sum, term| sum + one(term))
    }

    /// The entry at a time \[s\] after the begin of a constant load of 1 N, or of 1 N m; 0 before it, NaN for a time that is
    /// none.
    pub fn to_step(&self, time: T) -> T {
        if time < T::zero() {
            return T::zero();
        }
        let half = T::from_f64(0.5);
        let one = |term: &Term<T>| (term.residue * phi_1(term.lambda * time)).re * time;
        self.terms.iter().fold(self.rigid * time * time * half, |sum, term| sum + one(term))
    }

    /// The entry under a constant load of 1 once all has come to rest: what the modes of the list make up of the static
    /// response.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where a rigid body moves off, or drifts against a damper.
    pub fn static_value(&self) -> Result<T, MotionError> {
        let moves_off = |term: &Term<T>| term.lambda.is_zero() && !term.residue.is_zero();
        if !self.rigid.is_zero() || self.terms.iter().any(moves_off) {
            return Err(MotionError::Resonance { frequency: 0.0 });
        }
        let held = self.terms.iter().filter(|term| !term.lambda.is_zero());
        Ok(held.fold(T::zero(), |sum, term| sum - (term.residue / term.lambda).re))
    }

    /// The response to a force history in steps of `dt` \[s\], from rest.
    ///
    /// # Errors
    /// [`MotionError::TimeStep`] for a step that is not positive or not finite.
    pub fn history(&self, dt: T) -> Result<ForceHistory<T, N>, MotionError> {
        ForceHistory::new(self, dt)
    }
}

impl<T: Real, const N: usize> ModalResponse<T, N, RealFrequency> {
    /// The same modes with a damping ratio ζ in each: `e^{-ζωt} sin(ω_d t)/ω_d` in place of `sin(ωt)/ω`, with
    /// `ω_d = ω sqrt(1 - ζ²)`. Rigid bodies move as before.
    ///
    /// # Errors
    /// [`MotionError::DampingRatio`] for a ratio that is negative, or 1 and more, where nothing vibrates.
    pub fn with_damping_ratio(&self, ratio: T) -> Result<ModalResponse<T, N, ComplexEigenvalue>, MotionError> {
        if !(ratio >= T::zero() && ratio < T::one()) {
            return Err(MotionError::DampingRatio { ratio: ratio.to_f64() });
        }
        let slowed = ((T::one() - ratio) * (T::one() + ratio)).sqrt();
        let mut terms = self.terms;
        for term in terms.as_mut_slice() {
            let omega = term.lambda.im;
            term.lambda = Complex::new(-(ratio * omega), slowed * omega);
            term.residue /= slowed;
        }
        Ok(ModalResponse { terms, rigid: self.rigid, meaning: PhantomData })
    }
}

/// Where the load acts and what is asked for.
struct Places {
    load: Place,
    entry: Place,
}

impl Places {
    fn new<Y: Planned + ?Sized>(load: Load<Y::Model>, entry: Entry<Y::Model>) -> Result<Self, MotionError> {
        let mut load = Place::of_load::<Y>(load)?;
        // a force does work along the deflection, a moment along the rotation
        load.coordinate = if load.coordinate == Coordinate::M { Coordinate::Theta } else { Coordinate::Y };
        Ok(Places { load, entry: Place::of_entry::<Y>(entry)? })
    }

    /// `φ φ` of a shape.
    fn product<Y: Tree<S> + ?Sized, S: Scalar>(&self, shape: &ModeShape<'_, Y, S>) -> S {
        let at = |place: Place| shape.at(place.step, place.beyond).entry(place.coordinate);
        at(self.load) * at(self.entry)
    }
}
