//! What the load and the entry of a response are, as far as sums over modes and damping in proportion depend on it.

use crate::pass::characteristic::System;
use crate::pass::in_proportion::Obstacles;

/// What the load and the entry of a response are.
#[derive(Clone, Copy, Debug, Default)]
pub struct Facts<T> {
    /// Whether the load is the motion of a support, or a dislocation.
    pub(crate) is_motion: bool,
    /// Whether the entry is a force or a moment.
    pub(crate) is_force: bool,
    /// What the system has that damping in proportion does not go with.
    pub(crate) obstacles: Obstacles,
    /// Whether it is the rate of a response, or one to an acceleration in place of a motion.
    pub(crate) is_derived: bool,
    /// Under an acceleration of the ground: how far the entry goes along with a motion of 1 of the ground.
    pub(crate) along: Option<T>,
}

impl<T: Default> Facts<T> {
    /// What a load and an entry of a system are.
    pub(crate) fn of<Y: System + ?Sized>(system: &Y, is_motion: bool, is_force: bool) -> Self {
        Facts { is_motion, is_force, obstacles: Obstacles::of(system), ..Facts::default() }
    }
}
