//! Responses of plane structures to harmonic loads.

use crate::answer::at_rest::{AtRest, Part};
use crate::answer::facts::Facts;
use crate::answer::frequency_response::on_grid;
use crate::answer::network::states::{PlaneStates, Seen, check, internal, located};
use crate::answer::network::under_load::UnderLoad;
use crate::answer::response_curve::{Sample, refined};
use crate::answer::root::Root;
use crate::model::{MotionError, PlaneActing, PlaneEntry, PlaneLoad, Quantity, SpreadLoad, hertz};
use crate::number::{List, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, Placed, PlaneFrequency, Wanted};
use crate::search::ClosedRange;
use num_complex::Complex;
use num_traits::{One, Zero};

/// A transfer function of a plane structure: a displacement, an internal force or a reaction per harmonic load of 1 N, or of 1 N m.
#[derive(Debug)]
pub struct PlaneResponse<'a, Y: Placed> {
    under: UnderLoad<'a, Y>,
    entry: PlaneEntry<Y::Model>,
}

impl<Y: Placed> Clone for PlaneResponse<'_, Y> {
    fn clone(&self) -> Self {
        PlaneResponse { ..*self }
    }
}

impl<'a, Y: Placed> PlaneResponse<'a, Y> {
    pub(super) fn new(
        system: &'a Y,
        load: PlaneLoad<Y::Model>,
        entry: PlaneEntry<Y::Model>,
    ) -> Result<Self, MotionError> {
        let under = UnderLoad::new(system, load)?;
        check(system, entry)?;
        Ok(PlaneResponse { under, entry })
    }

    /// The structure.
    pub(crate) fn system(&self) -> &'a Y {
        self.under.system
    }

    /// What its load and its entry are.
    pub(crate) fn facts(&self) -> Facts<Y::Parameter> {
        let is_motion = matches!(self.under.load.acting, PlaneActing::Motion(..) | PlaneActing::Dislocation(..));
        let displaced = match self.entry.quantity {
            Quantity::Displacement(_, axis) => Some(axis),
            Quantity::Internal { .. } | Quantity::Reaction(..) => None,
        };
        let along = match self.under.load.acting {
            PlaneActing::Spread(SpreadLoad { axis, is_inertia: true, .. }) => {
                Some(if displaced == Some(axis) { Y::Parameter::one() } else { Y::Parameter::zero() })
            }
            _ => None,
        };
        Facts { along, ..Facts::of(self.under.system, is_motion, displaced.is_none()) }
    }

    /// The response to a steady vibration of a frequency \[Hz\], by its amplitude and its phase: [`at`](PlaneResponse::at) `λ = 2π f i`.
    ///
    /// # Errors
    /// As [`at`](PlaneResponse::at).
    pub fn at_hertz(
        &self,
        frequency: <Y as System>::Parameter,
    ) -> Result<Complex<<Y as System>::Parameter>, MotionError>
    where
        Y: MovingNetwork<Complex<<Y as System>::Parameter>>,
        Complex<<Y as System>::Parameter>: PlaneFrequency<<Y as System>::Parameter>,
    {
        self.at(Complex::new(Scalar::from_f64(0.0), hertz(frequency)))
    }

    /// The response at a frequency: a real ω [rad/s], or a complex λ [1/s], `iω` for a steady vibration; at 0 that to a load at rest, with
    /// loss factors the limit from above.
    ///
    /// It is computed in extended precision, where the numbers of the model have one. Where a part of the structure is not held
    /// and the load does not move it off, the limit at rest is extrapolated from some tens to hundreds of responses at low frequencies, to 12
    /// digits of the largest of these.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where it is infinite, [`MotionError::Mechanism`] where nothing holds a part without mass,
    /// [`MotionError::Unsettled`] for an uncertain limit at rest, [`MotionError::NotFinite`] where numbers overflow.
    pub fn at<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let frequency = x.modulus();
        let wanted = self.wanted()?;
        let value = match self.under.states(x, wanted) {
            Err(MotionError::Resonance { .. }) if x.is_zero() => self.limit_at_rest()?,
            // below the real axis a motion has the conjugate loss factor; that of a rotor is one of the other whirl
            Err(MotionError::LossFactor) if !const { Y::SPINS } => {
                self.under.states(x.conjugate(), wanted)?.value(self.entry)?.conjugate()
            }
            states => states?.value(self.entry)?,
        };
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency }) }
    }

    /// The response in the numbers of the model, for control loops and others that count each microsecond: it takes a third of the time of
    /// [`at`](PlaneResponse::at), or less.
    ///
    /// It loses as many digits as the ratio of the stiffnesses that meet has: of 16 there are 8 left where one is 1e8 times as stiff as another, and
    /// beside a resonance those that the distance takes. Nothing tells how many; `at` loses none.
    ///
    /// # Errors
    /// As [`at`](PlaneResponse::at), and [`MotionError::Resonance`] at rest where a part of the structure is not held.
    pub fn at_speed<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let value = self.under.states_at_speed(x, self.wanted()?)?.value(self.entry)?;
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency: x.modulus() }) }
    }

    /// Of which members the entry needs the motions.
    fn wanted(&self) -> Result<Wanted, MotionError> {
        Ok(match self.entry.quantity {
            Quantity::Displacement(site, _) => match located(self.under.system, site)? {
                Seen::Tied(_) => Wanted::Nodes,
                Seen::End { parts, .. } if parts.len() > 1 => Wanted::All,
                Seen::End { parts, .. } => Wanted::Member(parts.start),
            },
            Quantity::Internal { member, force, .. } => Wanted::Member(internal(self.under.system, member, force)?),
            Quantity::Reaction(..) => Wanted::All,
        })
    }

    /// The limit at rest of a structure of which a part is not held.
    #[cold]
    fn limit_at_rest<S>(&self) -> Result<S, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let rest = AtRest::of::<<Y as System>::Parameter>(self.under.lowest_exponent(), 0.0, |x| self.sized(x))?;
        let moves_off = !(rest.double.is_zero() && rest.simple.is_zero());
        if moves_off { Err(MotionError::Resonance { frequency: 0.0 }) } else { Ok(rest.finite) }
    }

    /// The response, and a size compared with which its rounding is small: the largest displacement, or the largest force.
    pub(crate) fn sized<S>(&self, x: S) -> Result<Part<S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let states = self.states(x)?;
        let value = states.value(self.entry)?;
        let size = match self.entry.quantity {
            Quantity::Displacement(..) => states.motion.size(),
            Quantity::Reaction(..) | Quantity::Internal { .. } => states.motion.largest_force(1.0),
        };
        let size = value.size().max(size);
        if const { Y::SPINS } || self.under.system.frequency_estimates().has_loss() {
            return Ok(Part { value, size, mirrored: self.under.continued(-x, Wanted::All)?.value(self.entry)? });
        }
        Ok(Part::new(value, size))
    }

    /// The response over a range of ω [rad/s], refined where it bends: between two samples it differs from the straight line at the middle by
    /// no more than `tolerance` times the largest of the three.
    ///
    /// `roots` are the roots whose resonances may lie in the range: none of them is missed, however narrow. Undamped resonances are infinite
    /// and are approached to 1e-4 of the range.
    ///
    /// # Errors
    /// [`MotionError::Capacity`] for more than `CAP` samples; [`MotionError::Range`] for a range that is empty, reversed or not finite;
    /// [`MotionError::Tolerance`] for a tolerance that is not positive; else as [`at`](PlaneResponse::at).
    pub fn curve<const CAP: usize, S>(
        &self,
        range: impl ClosedRange<Y::Parameter>,
        roots: &[impl Root<Y::Parameter, Frequency = S>],
        tolerance: f64,
    ) -> Result<List<Sample<Y::Parameter, S>, CAP>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        refined(|x| self.at(x), &range.closed(), roots.iter().map(Root::peak), tolerance)
    }

    /// All displacements and forces at a frequency.
    ///
    /// # Errors
    /// As [`at`](PlaneResponse::at), and [`MotionError::LossFactor`] for `Im λ < 0` where something has a loss factor.
    pub fn states<S>(&self, x: S) -> Result<PlaneStates<'a, Y, S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        self.under.states(x, Wanted::All)
    }

    /// Writes the responses at the frequencies of `grid` to `values`.
    ///
    /// # Errors
    /// As [`at`](PlaneResponse::at), for the first frequency where it fails; [`MotionError::Capacity`] where `values` is shorter than
    /// `grid`.
    pub fn on<S>(&self, grid: &[S], values: &mut [S]) -> Result<(), MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        on_grid(|x| self.at(x), grid, values)
    }
}
