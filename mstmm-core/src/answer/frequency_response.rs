//! Responses to harmonic loads.

use crate::answer::at_rest::{AtRest, Part};
use crate::answer::facts::Facts;
use crate::answer::root::is_below_losses;
use crate::answer::spread_load::{Work, response};
use crate::model::{Acting, Entry, Load, MotionError, Spread, hertz};
use crate::number::{Oscillation, Scalar};
use crate::pass::both_ways::Passes;
use crate::pass::characteristic::System;
use crate::pass::route::{Place, Route};
use crate::pass::tree::{ExtendedTree, Planned, Tree};
use mstmm_plan::Coordinate;
use num_complex::Complex;
use num_traits::{One, Zero};

/// Size of Δ at rest, in roundings of Δ at low frequencies, up to which it counts as zero.
const VANISHING: f64 = 4096.0;

/// A transfer function of a system: an entry of a state per harmonic load of 1 N, or of 1 N m.
#[derive(Debug)]
pub struct FrequencyResponse<'a, Y: Planned + ?Sized> {
    /// The way from the load to the entry; under a load along elements that from a jump at the entry.
    route: Route<'a, Y>,
    /// A load along elements.
    spread: Option<Spread>,
}

impl<Y: Planned + ?Sized> Clone for FrequencyResponse<'_, Y> {
    fn clone(&self) -> Self {
        FrequencyResponse { route: self.route.clone(), spread: self.spread }
    }
}

impl<'a, Y: Planned + ?Sized> FrequencyResponse<'a, Y> {
    pub(crate) fn new(system: &'a Y, load: Load<Y::Model>, entry: Entry<Y::Model>) -> Result<Self, MotionError> {
        let entry = Place::of_entry(system, entry)?;
        let (load, spread) = match load.acting {
            Acting::At(step, coordinate) => (Place::of_load(system, (step, coordinate))?, None),
            Acting::Spread(spread) => (entry, Some(spread)),
        };
        Ok(FrequencyResponse { route: Route::new(system, load, entry), spread })
    }

    /// The system.
    pub(crate) fn system(&self) -> &'a Y {
        self.route.system
    }

    /// What its load and its entry are.
    pub(crate) fn facts(&self) -> Facts<Y::Parameter> {
        let Route { system, load, entry, .. } = &self.route;
        let is_motion = self.spread.is_none() && !load.coordinate.is_force();
        let is_along = if entry.coordinate == Coordinate::Y { Y::Parameter::one() } else { Y::Parameter::zero() };
        let is_of_ground = matches!(self.spread, Some(Spread::Inertia(_)));
        let along = is_of_ground.then_some(is_along);
        Facts { along, ..Facts::of(*system, is_motion, entry.coordinate.is_force()) }
    }

    /// The response to a steady vibration of a frequency \[Hz\], by its amplitude and its phase: [`at`](FrequencyResponse::at) `λ = 2π f i`.
    ///
    /// # Errors
    /// As [`at`](FrequencyResponse::at).
    pub fn at_hertz(
        &self,
        frequency: <Y as System>::Parameter,
    ) -> Result<Complex<<Y as System>::Parameter>, MotionError>
    where
        Y: ExtendedTree<Complex<<Y as System>::Parameter>>,
        Complex<<Y as System>::Parameter>: Oscillation<<Y as System>::Parameter>,
    {
        self.at(Complex::new(Scalar::from_f64(0.0), hertz(frequency)))
    }

    /// The response at a frequency: a real ω [rad/s], or a complex λ [1/s], `iω` for a steady vibration.
    ///
    /// It is computed in extended precision, where the numbers of the model have one.
    ///
    /// At 0 it is the static limit, wherever it is finite, and with loss factors the limit from above; this takes twice the time, to see that Δ is not rounding alone. Where a
    /// part of the system is not held and the load does not move it, the limit is extrapolated from some tens to hundreds of responses
    /// at low frequencies, to 12 digits of the largest of these. A part that the load moves by rounding alone is at rest.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where it is infinite, [`MotionError::Unsettled`] for an uncertain static limit,
    /// [`MotionError::NotFinite`] where numbers overflow.
    pub fn at<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: ExtendedTree<S>,
        S: Oscillation<<Y as System>::Parameter>,
    {
        if x.is_zero() {
            return self.static_limit();
        }
        // below the real axis a motion has the conjugate loss factor
        if is_below_losses(self.route.system, x) {
            // the conjugate motion of a rotor is one of the other whirl
            return if const { Y::SPINS } {
                Err(MotionError::LossFactor)
            } else {
                Ok(self.precisely(x.conjugate())?.conjugate())
            };
        }
        self.precisely(x)
    }

    /// The response in the numbers of the model, for control loops and others that count each microsecond: it takes a tenth of the time of
    /// [`at`](FrequencyResponse::at).
    ///
    /// It loses as many digits as the ratio of the stiffnesses that meet has, and beside a resonance those that the distance takes. Nothing tells how
    /// many; `at` loses none.
    ///
    /// # Errors
    /// As [`at`](FrequencyResponse::at), and [`MotionError::Resonance`] at rest where a part of the system is not held;
    /// [`MotionError::LossFactor`] for `Im λ < 0` where something has a loss factor.
    pub fn at_speed<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        if is_below_losses(self.route.system, x) {
            return Err(MotionError::LossFactor);
        }
        self.evaluated(x)
    }

    /// The response, computed in extended precision, where there is one.
    fn precisely<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: ExtendedTree<S>,
        S: Oscillation<<Y as System>::Parameter>,
    {
        if !S::HAS_EXTENDED {
            return self.evaluated(x);
        }
        let value = S::from_extended(self.evaluated(x.to_extended())?);
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency: x.modulus() }) }
    }

    /// The response in the numbers of the frequency.
    fn evaluated<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        match self.spread {
            None => self.route.value(&self.route.passes(x), x),
            Some(load) => Ok(response(self.route.system, load, self.route.entry, x)?.value),
        }
    }

    /// The response and a size compared with which its rounding is small: the geometric mean of the responses at the load and at the
    /// entry to loads of their own.
    pub(crate) fn sized<S>(&self, x: S) -> Result<Part<S>, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let (value, size) = match self.spread {
            None => self.to_point(x)?,
            Some(load) => {
                let Work { value, size } = response(self.route.system, load, self.route.entry, x)?;
                (value, size)
            }
        };
        if const { Y::SPINS } || self.route.system.frequency_estimates().has_loss() {
            return Ok(Part { value, size, mirrored: self.evaluated(-x)? });
        }
        Ok(Part::new(value, size))
    }

    /// The response to a load at a point, and its size.
    fn to_point<S>(&self, x: S) -> Result<(S, f64), MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let passes = Passes::whole(self.route.system, x);
        let value = self.route.value(&passes, x)?;
        let own = |step: usize, coordinate: Coordinate| {
            let meeting = passes.meeting(step);
            meeting.square(coordinate).over(meeting.delta()).value().size()
        };
        let load = own(self.route.load.step, self.route.load.coordinate.dual());
        let entry = own(self.route.entry.step, self.route.entry.coordinate);
        Ok((value, value.size().max(load.sqrt() * entry.sqrt())))
    }

    /// The static limit.
    #[cold]
    fn static_limit<S>(&self) -> Result<S, MotionError>
    where
        Y: ExtendedTree<S>,
        S: Oscillation<<Y as System>::Parameter>,
    {
        if let Some(held) = self.held_at_rest()? {
            return Ok(held);
        }
        let rest = AtRest::of::<<Y as System>::Parameter>(
            self.route.system.frequency_estimates().lowest_exponent(),
            0.0,
            |x: S| self.sized(x),
        );
        let moves_off = Err(MotionError::Resonance { frequency: 0.0 });
        match rest {
            Ok(AtRest { double, simple, finite, .. }) if double.is_zero() && simple.is_zero() => Ok(finite),
            Ok(_) | Err(MotionError::Resonance { .. }) => moves_off,
            Err(error) => Err(error),
        }
    }

    /// The static limit of a system that is held; `None` where Δ at rest is zero, or as small as rounding compared with Δ at low
    /// frequencies.
    pub(crate) fn held_at_rest<S>(&self) -> Result<Option<S>, MotionError>
    where
        Y: ExtendedTree<S>,
        S: Oscillation<<Y as System>::Parameter>,
    {
        let step = self.route.load.step;
        let low = <<Y as System>::Parameter as One>::one()
            .times_power_of_two(self.route.system.frequency_estimates().lowest_exponent());
        let rest = self.route.passes(S::zero());
        let (own, beside) = (rest.meeting(step).delta(), self.route.passes(S::of_omega(low)).meeting(step).delta());
        if own.mantissa().is_zero() || own.over(beside).magnitude().value() <= VANISHING * S::EPSILON {
            return Ok(None);
        }
        self.precisely(S::zero()).map(Some)
    }

    /// Writes the responses at the frequencies of `grid` to `values`, each with the bits that [`at`](FrequencyResponse::at) gives it.
    ///
    /// # Errors
    /// As [`at`](FrequencyResponse::at), for the first frequency where it fails; [`MotionError::Capacity`] where `values` is
    /// shorter than `grid`.
    pub fn on<S>(&self, grid: &[S], values: &mut [S]) -> Result<(), MotionError>
    where
        Y: ExtendedTree<S>,
        S: Oscillation<<Y as System>::Parameter>,
    {
        on_grid(|x| self.at(x), grid, values)
    }
}

/// Writes a response at the frequencies of a grid to `values`, which has to be as long.
pub(crate) fn on_grid<S: Copy>(
    at: impl Fn(S) -> Result<S, MotionError>,
    grid: &[S],
    values: &mut [S],
) -> Result<(), MotionError> {
    if values.len() < grid.len() {
        return Err(MotionError::Capacity { capacity: values.len() });
    }
    for (value, &x) in values.iter_mut().zip(grid) {
        *value = at(x)?;
    }
    Ok(())
}
