//! Errors of bounds for what a list of modes leaves out.

use crate::model::motion_error::MotionError;
use crate::model::plain::error;
use crate::model::search_error::SearchError;
use core::fmt;

/// Why what a list of modes leaves out has no bound.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TruncationError {
    /// The list has not all modes below the reach, one after the other, or it has more.
    Missing {
        /// The proven number of modes below the reach.
        counted: u64,
        /// The number of modes of the list up to the first gap in its indices.
        listed: u64,
    },
    /// A reach that is not positive or not finite.
    Reach {
        /// The reach [rad/s].
        reach: f64,
    },
    /// A weight along a path, under which its motion inside of elements is not known. Give the points of the model places.
    Spread,
    /// A part of the question.
    Motion(MotionError),
    /// The count of the modes below the reach.
    Search(SearchError),
}

impl From<MotionError> for TruncationError {
    fn from(error: MotionError) -> Self {
        TruncationError::Motion(error)
    }
}

impl From<SearchError> for TruncationError {
    fn from(error: SearchError) -> Self {
        TruncationError::Search(error)
    }
}

impl fmt::Display for TruncationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TruncationError::Missing { counted, listed } => {
                write!(
                    f,
                    "the system has {counted} modes below the reach, and the list has {listed} of them in order: list all of them from the first one on, and no other"
                )
            }
            TruncationError::Reach { reach } => {
                write!(f, "a reach of {reach} rad/s is none: it has to be positive and finite")
            }
            TruncationError::Spread => {
                write!(
                    f,
                    "a load along a path has no bound here: give the points of the model places, `conn a at (0.0, 0.0)`"
                )
            }
            TruncationError::Motion(error) => write!(f, "{error}"),
            TruncationError::Search(error) => write!(f, "{error}"),
        }
    }
}

error! { TruncationError }
