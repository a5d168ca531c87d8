//! Responses of plane structures to harmonic loads.

use crate::answer::network::states::{PlaneStates, check_freedom, offset};
use crate::model::{MotionError, PlaneEntry, PlaneLoad, Site};
use crate::number::Frequency;
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, NetworkMotion, Placed, PlaneFrequency, motion_under, rounding_under};

/// The difference of motions with other pivots, beside the largest displacement, beyond which they are computed in extended precision.
const AGREEING: f64 = 1e-13;

/// The part of the row of a pivot that rounding may be, beyond which other pivots may round alike.
const ROUNDED: f64 = 1e-9;

/// A transfer function of a plane structure: a displacement, an internal force or a reaction per harmonic load of 1 N, or of 1 N m.
#[derive(Debug)]
pub struct PlaneResponse<'a, Y: Placed> {
    system: &'a Y,
    load: PlaneLoad<Y::Model>,
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
        acting_at::<Y, Y::Parameter>(system, load)?;
        Ok(PlaneResponse { system, load, entry })
    }

    /// The response at a frequency: a real ω [rad/s], or a complex λ [1/s], `iω` for a steady vibration; at 0 that to a load at rest.
    ///
    /// It is computed with two choices of pivots, and at a real ω in extended precision where they differ.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where it is infinite, [`MotionError::NotFinite`] where numbers overflow,
    /// [`MotionError::NoSuchPoint`] for an entry of another list.
    pub fn at<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let value = self.states(x)?.value(self.entry)?;
        let frequency = x.modulus();
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency }) }
    }

    /// All displacements and forces at a frequency.
    ///
    /// # Errors
    /// As [`at`](PlaneResponse::at).
    pub fn states<S>(&self, x: S) -> Result<PlaneStates<'a, Y, S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let load = acting_at::<Y, S>(self.system, self.load)?;
        let mut motion = motion_under(self.system, x, load);
        let is_sure = |motion: &NetworkMotion<Y, S>| {
            !motion.vanishes && motion.rounding <= ROUNDED && rounding_under(self.system, x, load, motion) <= AGREEING
        };
        if S::HAS_EXTENDED && !is_sure(&motion) {
            let load = acting_at::<Y, S::Extended>(self.system, self.load)?;
            motion = motion_under(self.system, x.to_extended(), load).rounded(S::from_extended);
        }
        if motion.vanishes {
            return Err(MotionError::Resonance { frequency: x.modulus() });
        }
        Ok(PlaneStates { system: self.system, x, motion })
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
        if values.len() < grid.len() {
            return Err(MotionError::Capacity { capacity: values.len() });
        }
        for (value, &x) in values.iter_mut().zip(grid) {
            *value = self.at(x)?;
        }
        Ok(())
    }
}

/// The node on which a load acts, and its forces x, y and moment there.
fn acting_at<Y: Placed, S: Frequency<Y::Parameter>>(
    system: &Y,
    load: PlaneLoad<Y::Model>,
) -> Result<(usize, [S; 3]), MotionError> {
    let mut forces = [S::zero(); 3];
    forces[load.axis] = S::one();
    check_freedom(load.site, load.axis)?;
    let (node, [x, y]) = match load.site {
        Site::Node(node) => (node, [S::zero(); 2]),
        Site::Tied { node, place, .. } => (node, offset(system, node, place)),
        Site::End { member, end } => {
            if member >= system.sizes()[1] {
                return Err(MotionError::NoSuchPoint { index: member });
            }
            let placement = system.placement(member);
            let released = placement.released(end);
            if !released.is_empty() {
                return Err(MotionError::NoSuchFreedom { freedom: released });
            }
            (placement.node_of(end), placement.offset(end))
        }
    };
    if node >= system.sizes()[0] {
        return Err(MotionError::NoSuchPoint { index: node });
    }
    forces[2] += x * forces[1] - y * forces[0];
    Ok((node, forces))
}
