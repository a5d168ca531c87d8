//! A rotor: a system whose shafts and discs spin, seen from both whirls.

use crate::model::FrequencyEstimates;
use crate::pass::characteristic::System;

/// The sense in which the bending of a rotor whirls.
///
/// A shaft on isotropic bearings moves by `u = v + iw = U e^{iωt}`: its axis whirls at ω in the sense of a positive speed, or against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whirl {
    /// In the sense of positive speeds.
    Forward,
    /// Against it.
    Backward,
}

/// A system with parts that spin. `system!` implements it where an element names its speed.
pub trait Spinning: System {
    /// Why a rotor of this type is not built.
    type BuildError: core::error::Error + 'static;

    /// The system as the other whirl sees it: all its speeds have the other sign.
    #[must_use]
    fn turned_round(self) -> Self;
}

/// A built rotor on isotropic bearings. Ask one of its [whirls](Rotor::whirl), which is a system like others.
///
/// Both bending planes of such a rotor are one, of complex displacements `u = v + iw` and rotations `θ = θ_z - iθ_y`, so that gyroscopic moments
/// are real. Each whirl has a dynamic stiffness `K - ω²M + ωΩG` with real numbers and `ω > 0`, G with the sign of the whirl.
#[derive(Clone, Debug)]
pub struct Rotor<Y> {
    forward: Y,
    backward: Y,
}

impl<Y: Spinning + Clone> Rotor<Y> {
    /// A rotor, given its system in forward whirl.
    #[doc(hidden)]
    pub fn new(forward: Y) -> Self {
        Rotor { backward: forward.clone().turned_round(), forward }
    }
}

impl<Y> Rotor<Y> {
    /// The rotor as one whirl sees it: a system with proven frequencies, counts, shapes, exact responses and sensitivities.
    ///
    /// Its loads and entries are complex amplitudes of `u = v + iw`. A force of 1 turns with the whirl, as that of an unbalance does with forward whirl.
    /// It has no sums over modes, [`modal_response`](crate::ModalAnalysis::modal_response): these need the modes of both whirls.
    pub fn whirl(&self, whirl: Whirl) -> &Y {
        match whirl {
            Whirl::Forward => &self.forward,
            Whirl::Backward => &self.backward,
        }
    }

    /// The rotor as one whirl sees it, without the other one.
    pub fn into_whirl(self, whirl: Whirl) -> Y {
        match whirl {
            Whirl::Forward => self.forward,
            Whirl::Backward => self.backward,
        }
    }
}

/// A rotor is searched by its whirls: what is asked of itself is an error that says so.
impl<Y: System> System for Rotor<Y> {
    type Parameter = Y::Parameter;

    fn frequency_estimates(&self) -> FrequencyEstimates {
        self.forward.frequency_estimates()
    }
}
