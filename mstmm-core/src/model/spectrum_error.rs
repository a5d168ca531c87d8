//! Errors of response spectra.

use crate::model::plain::error;
use core::fmt;

/// Why a spectrum, or a peak by one, cannot be given.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpectrumError {
    /// A table without rows.
    Empty,
    /// A row of a table whose frequency or period is not above that before, or not positive and finite.
    Order {
        /// The row, from 0 on.
        row: usize,
    },
    /// A row of a table whose acceleration is not positive, or an answer of a spectrum that is negative or not finite.
    Acceleration {
        /// The acceleration [m/s²].
        acceleration: f64,
    },
    /// A response to another load than an acceleration of the ground, a rate, or one in space: a spectrum has the motion relative to the ground.
    NotRelative,
    /// A mode that does not vibrate: a rigid body, or one that damping stops.
    NoVibration {
        /// Size of its eigenvalue |λ|.
        root: f64,
    },
    /// An oscillator whose frequency is not positive and finite, or whose damping ratio is not from 0 to below 1.
    Oscillator {
        /// Its frequency [rad/s].
        omega: f64,
        /// Its damping ratio.
        ratio: f64,
    },
    /// An oscillator with more than a million vibrations in a record: it moves as what is rigid.
    Stiff {
        /// Its frequency [rad/s].
        omega: f64,
        /// The vibrations.
        vibrations: f64,
    },
    /// An oscillator whose motion overflows.
    Overflow {
        /// Its frequency [rad/s].
        omega: f64,
        /// The time \[s\].
        time: f64,
    },
    /// A step of time that is not positive or not finite.
    TimeStep {
        /// The step \[s\].
        step: f64,
    },
    /// A sample of a record that is not finite.
    Sample {
        /// The sample, from 0 on.
        sample: usize,
    },
}

impl fmt::Display for SpectrumError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SpectrumError::Empty => write!(f, "the table has no rows"),
            SpectrumError::Order { row } => {
                write!(
                    f,
                    "frequencies or periods have to be positive and to grow from row to row: row {row} does not; for a period of zero write a short one"
                )
            }
            SpectrumError::Acceleration { acceleration } => {
                write!(
                    f,
                    "a spectral acceleration of {acceleration} m/s² is none: in a table it has to be positive and finite"
                )
            }
            SpectrumError::NotRelative => {
                write!(
                    f,
                    "a spectrum has the motion relative to the ground: take a response to `base_acceleration`, not `absolute` and no rate"
                )
            }
            SpectrumError::NoVibration { root } => {
                write!(
                    f,
                    "the mode of the root of size {root} does not vibrate, so that it has no spectral acceleration"
                )
            }
            SpectrumError::Oscillator { omega, ratio } => {
                write!(
                    f,
                    "an oscillator needs a positive frequency and a damping ratio from 0 to below 1, not {omega} rad/s and {ratio}"
                )
            }
            SpectrumError::Stiff { omega, vibrations } => {
                write!(
                    f,
                    "an oscillator of {omega} rad/s vibrates {vibrations:.1e} times in the record: beyond a million it moves as what is rigid"
                )
            }
            SpectrumError::Overflow { omega, time } => {
                write!(f, "the motion of an oscillator of {omega} rad/s overflows at {time} s")
            }
            SpectrumError::TimeStep { step } => {
                write!(f, "a step of {step} s is none: it has to be positive and finite")
            }
            SpectrumError::Sample { sample } => write!(f, "sample {sample} of the record is not finite"),
        }
    }
}

error! { SpectrumError }
