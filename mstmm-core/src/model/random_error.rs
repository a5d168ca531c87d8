//! Errors of random vibrations.

use crate::model::plain::error;
use core::fmt;

/// Why a power spectrum is none, or a response to one has no root mean square.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum RandomError {
    /// A table of fewer than two rows: it has no width.
    Rows {
        /// How many there are.
        rows: usize,
    },
    /// A row of a table whose frequency is not above that before, or not positive and finite.
    Order {
        /// The row, from 0 on.
        row: usize,
    },
    /// A row of a table that stands so close behind the one before that numbers do not tell what is between them.
    Steep {
        /// The row, from 0 on.
        row: usize,
    },
    /// A level, or the factor of one, that is not positive or not finite.
    Level {
        /// The level or the factor.
        level: f64,
    },
    /// A band that is empty, reversed, negative or not finite.
    Band {
        /// Its start \[Hz\].
        start: f64,
        /// Its end \[Hz\].
        end: f64,
    },
    /// A frequency that is negative or not finite.
    Frequency {
        /// The frequency \[Hz\].
        hertz: f64,
    },
    /// A mode without damping at a frequency of the spectrum: its vibration grows without a limit.
    NoDamping {
        /// Its frequency [rad/s].
        omega: f64,
    },
    /// A motion that grows by itself, and settles at no root mean square.
    Unstable {
        /// By how much it grows \[1/s\].
        growth: f64,
    },
    /// A rigid body that moves off, or drifts, under a spectrum that reaches down to zero.
    AtRest,
    /// White noise on a response of which a part follows the load at once: its mean square is infinite.
    Residual {
        /// The part that follows at once.
        residual: f64,
    },
    /// A result beyond the range of numbers.
    Overflow,
}

impl fmt::Display for RandomError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            RandomError::Rows { rows } => write!(f, "a power spectrum has two rows or more, not {rows}"),
            RandomError::Order { row } => {
                write!(f, "frequencies have to be positive and finite and to grow from row to row: row {row} does not")
            }
            RandomError::Steep { row } => {
                write!(f, "between row {row} and the one before the spectrum is too steep to tell: move them apart")
            }
            RandomError::Level { level } => {
                write!(f, "a level of {level}, or a factor of it, is none: it has to be positive and finite")
            }
            RandomError::Band { start, end } => {
                write!(f, "from {start} Hz to {end} Hz is no band: it has to start at 0 or above and to end beyond")
            }
            RandomError::Frequency { hertz } => write!(f, "{hertz} Hz is no frequency: it has to be 0 or above"),
            RandomError::NoDamping { omega } => {
                write!(
                    f,
                    "the mode at {omega} rad/s has no damping, and the spectrum has power there: its mean square is infinite"
                )
            }
            RandomError::Unstable { growth } => {
                write!(f, "a motion grows by {growth} per second by itself: it has no root mean square")
            }
            RandomError::AtRest => {
                write!(
                    f,
                    "a rigid body moves off under a spectrum that reaches down to 0 Hz: its mean square is infinite"
                )
            }
            RandomError::Residual { residual } => {
                write!(
                    f,
                    "a part of {residual} follows white noise at once, with an infinite mean square: take a band, or `without_residual`"
                )
            }
            RandomError::Overflow => write!(f, "the mean square is beyond the range of numbers"),
        }
    }
}

error! { RandomError }
