//! What a load works on the shape of a plane structure, or of one in space.

use crate::answer::network::shape::PlaneShape;
use crate::answer::network::states::PlaneStates;
use crate::answer::network::under_load::acting_at;
use crate::model::{MotionError, PlaneLoad};
use crate::pass::characteristic::System;
use crate::pass::network::{ActingLoad, JumpAt, LoadAt, MovingNetwork, Placed, PlaneFrequency};

impl<Y, S> PlaneShape<'_, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    /// The work of a load of 1 on the shape: what excites its mode. Of a force it is the displacement of its point, of a moment the rotation, of the motion of a
    /// support its reaction with the other sign, of a dislocation its internal force, of the weight the factor of participation [kg^½].
    ///
    /// ```
    /// use mstmm_core::frame::{Frame, Section};
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::{FrameAnalysis, PlaneLoad, Support};
    ///
    /// let mut frame = Frame::new();
    /// let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
    /// frame.hold(foot, Support::Fixed);
    /// frame.member(foot, tip, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
    /// let cantilever = frame.build()?;
    /// let root = cantilever.frequencies(1)?[0];
    /// let factor = cantilever.mode_shape(&root)?.work(PlaneLoad::self_weight_y())?;
    /// // 61 % of its 3 kg take part
    /// assert!((factor * factor / 3.0 - 0.613).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`frequency_response`](crate::FrameAnalysis::frequency_response) for a load that acts nowhere.
    pub fn work(&self, load: PlaneLoad<<Y as Placed>::Model>) -> Result<S, MotionError> {
        let load = acting_at::<Y, S>(self.system, load.acting)?;
        let beside_nodes = match load {
            ActingLoad::Spread(spread) => self.work_of(spread)?,
            ActingLoad::At(LoadAt { node, moved: Some(moved), .. }) => {
                let against = moved.into_iter().zip(self.reactions().as_ref()[node]);
                against.fold(S::zero(), |sum, (moved, reaction)| sum - moved * reaction)
            }
            ActingLoad::At(_) => S::zero(),
            ActingLoad::Jump(JumpAt { member, end, freedom, by }) => {
                -(by * self.member_ends(member).ends[end].forces[freedom])
            }
        };
        Ok(beside_nodes + self.work_on_nodes(&load)?)
    }
}

impl<Y, S> PlaneStates<'_, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    /// The work of what a load is on nodes.
    pub(super) fn work_on_nodes(&self, load: &ActingLoad<S>) -> Result<S, MotionError> {
        let mut work = S::zero();
        for node in 0..self.system.sizes()[0] {
            let forces = load.on_node(self.system, node).into_iter().flatten();
            for (force, displacement) in forces.zip(self.all_of(node)?) {
                work += force * displacement;
            }
        }
        Ok(work)
    }
}
