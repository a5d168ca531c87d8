//! Errors of searches for speeds.

use crate::model::{ParameterError, SearchError, ToleranceError};
use core::fmt;

/// A search for critical speeds, or for a threshold of stability, that cannot start or cannot return all it found, given the error `E` of a rotor that is not
/// built: of a [`Frame`](crate::frame::Frame) its `BuildErrors`.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpeedError<E = ParameterError> {
    /// The rotor at a speed cannot be built.
    Parameter {
        /// The speed [rad/s].
        speed: f64,
        /// What is wrong.
        error: E,
    },
    /// The search found no answer at a rotor of the range.
    Search(SearchError),
    /// Rotors at a speed that are no ends of a box of tolerances.
    NotABox {
        /// The speed [rad/s].
        speed: f64,
        /// Why they are none.
        error: ToleranceError,
    },
    /// The order is not a positive number.
    Order {
        /// The order.
        order: f64,
    },
    /// A motion grows at the first speed of a range already.
    Grows {
        /// The speed [rad/s].
        speed: f64,
    },
    /// A motion neither grows nor decays at an end of a range.
    Neutral {
        /// The speed [rad/s].
        speed: f64,
        /// The frequency of the motion [rad/s].
        omega: f64,
    },
    /// The region of a threshold does not begin at `Re λ = 0`.
    Region {
        /// Where its real part begins [1/s].
        re: f64,
    },
    /// A range of critical speeds begins below zero.
    Negative {
        /// Its first speed [rad/s].
        speed: f64,
    },
    /// Fewer frequencies are below the line of the order as the speed grows: bearings that stiffen with the speed have no critical speeds that counts
    /// could certify.
    Falls {
        /// Speed from which on fewer frequencies are below [rad/s].
        speed: f64,
    },
}

impl<E: fmt::Display> fmt::Display for SpeedError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SpeedError::Parameter { speed, error } => write!(f, "at the speed {speed} rad/s: {error}"),
            SpeedError::Search(error) => write!(f, "{error}"),
            SpeedError::NotABox { speed, error } => write!(f, "at the speed {speed} rad/s: {error}"),
            SpeedError::Order { order } => write!(f, "the order of a critical speed is a positive number, not {order}"),
            SpeedError::Grows { speed } => {
                write!(f, "a motion grows at the first speed already, {speed} rad/s: begin below the threshold")
            }
            SpeedError::Neutral { speed, omega } => {
                write!(
                    f,
                    "at the speed {speed} rad/s the motion with Im λ = {omega} rad/s neither grows nor decays: "
                )?;
                write!(f, "damp it, or leave it out of the region")
            }
            SpeedError::Region { re } => write!(f, "the region of a threshold begins at Re λ = 0, not at {re}"),
            SpeedError::Negative { speed } => {
                write!(f, "critical speeds are zero or positive, but the range begins at {speed} rad/s")
            }
            SpeedError::Falls { speed } => {
                write!(
                    f,
                    "fewer frequencies are below the line of the order beyond the speed {speed} rad/s: the bearings stiffen with the speed"
                )
            }
        }
    }
}

impl<E: fmt::Display> fmt::Debug for SpeedError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<E: fmt::Display> core::error::Error for SpeedError<E> {}

impl<E> From<SearchError> for SpeedError<E> {
    fn from(error: SearchError) -> Self {
        SpeedError::Search(error)
    }
}
