//! Errors of peaks over a band.

use crate::model::motion_error::MotionError;
use crate::model::plain::error;
use crate::model::search_error::SearchError;
use core::fmt;

/// Why a peak over a band has no bound.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum PeakError {
    /// The band has an eigenvalue without damping, or with as little as rounding: there the response is infinite.
    Resonance {
        /// Its frequency [rad/s].
        omega: f64,
    },
    /// The response by which another one is divided vanishes in the band.
    Infinite {
        /// Where [rad/s].
        omega: f64,
    },
    /// The list has not all natural frequencies up to the band and a little beyond, or it has more.
    Missing {
        /// Up to which frequency [rad/s].
        below: f64,
        /// The proven number of frequencies up to there.
        counted: u64,
        /// The number of them in the list.
        listed: u64,
    },
    /// Two responses of different systems.
    OtherSystem,
    /// A tolerance that is not between 1e-12 and 0.5.
    Tolerance {
        /// The tolerance that was given.
        tolerance: f64,
    },
    /// Rounding hides the response.
    Unresolved {
        /// Where [rad/s].
        omega: f64,
    },
    /// The band has so many modes that the search was given up.
    Effort {
        /// How many evaluations were made.
        evaluations: usize,
    },
    /// A response.
    Motion(MotionError),
    /// A count of eigenvalues.
    Search(SearchError),
}

impl From<MotionError> for PeakError {
    fn from(error: MotionError) -> Self {
        PeakError::Motion(error)
    }
}

impl From<SearchError> for PeakError {
    fn from(error: SearchError) -> Self {
        PeakError::Search(error)
    }
}

impl fmt::Display for PeakError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PeakError::Resonance { omega } => {
                write!(f, "at {omega} rad/s, in the band, the system has a mode without damping: no peak is finite")
            }
            PeakError::Infinite { omega } => {
                write!(f, "the response below vanishes at {omega} rad/s, in the band: the ratio is infinite there")
            }
            PeakError::Missing { below, counted, listed } => {
                write!(
                    f,
                    "the system has {counted} frequencies below {below} rad/s, and the list has {listed} of them: list all up to the band and a little beyond"
                )
            }
            PeakError::OtherSystem => write!(f, "a ratio is one of two responses of the same system"),
            PeakError::Tolerance { tolerance } => {
                write!(f, "a tolerance of {tolerance} is none: it has to be between 1e-12 and 0.5")
            }
            PeakError::Unresolved { omega } => {
                write!(f, "at {omega} rad/s rounding hides the response: ask for a larger tolerance")
            }
            PeakError::Effort { evaluations } => {
                write!(f, "the search was given up after {evaluations} evaluations: ask for parts of the band")
            }
            PeakError::Motion(error) => write!(f, "{error}"),
            PeakError::Search(error) => write!(f, "{error}"),
        }
    }
}

error! { PeakError }
