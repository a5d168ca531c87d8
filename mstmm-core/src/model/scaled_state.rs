//! States with a power of two of their own.

use crate::model::state::State;
use crate::number::{Scalar, Single, binary_exponent};

/// A state with a power of two of its own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScaledState<S> {
    pub(crate) state: State<S>,
    pub(crate) exponent: i32,
}

impl<S: Single> ScaledState<S> {
    /// Exponent of its largest entry, of whatever unit; `None` for a state of zeros.
    pub(crate) fn magnitude(&self) -> Option<i32> {
        let size = self.state.size();
        (size > 0.0).then(|| binary_exponent(size).saturating_add(self.exponent))
    }
}

impl<S: Scalar> ScaledState<S> {
    pub(crate) fn zero() -> Self {
        ScaledState { state: State::default(), exponent: 0 }
    }

    /// The plain state times `2^shift`.
    pub(crate) fn shifted(&self, shift: i32) -> State<S> {
        self.state.map(|entry| entry.times_power_of_two(self.exponent.saturating_add(shift)))
    }

    /// The state seen against the x-axis: slope and shear force change their signs.
    pub(crate) fn backwards(self) -> Self {
        ScaledState { state: self.state.backwards(), ..self }
    }
}
