//! Why a model cannot be shown.

use core::fmt;
use mstmm::element::ParameterError;
use mstmm::motion::MotionError;
use mstmm::search::SearchError;

/// Why a model cannot be shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Problem {
    /// A parameter of the model is out of its range.
    Parameter(ParameterError),
    /// A search for roots has failed.
    Search(SearchError),
    /// A shape or a response cannot be had.
    Motion(MotionError),
    /// A table for the page is full.
    Full {
        /// How many numbers it holds.
        capacity: usize,
    },
    /// There is no model of that number.
    NoModel,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Problem::Parameter(error) => error.fmt(f),
            Problem::Search(error) => error.fmt(f),
            Problem::Motion(error) => error.fmt(f),
            Problem::Full { capacity } => write!(f, "there are more than {capacity} numbers to show"),
            Problem::NoModel => f.write_str("there is no such model"),
        }
    }
}

impl core::error::Error for Problem {}

impl From<ParameterError> for Problem {
    fn from(error: ParameterError) -> Self {
        Problem::Parameter(error)
    }
}

impl From<SearchError> for Problem {
    fn from(error: SearchError) -> Self {
        Problem::Search(error)
    }
}

impl From<MotionError> for Problem {
    fn from(error: MotionError) -> Self {
        Problem::Motion(error)
    }
}
