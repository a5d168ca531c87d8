//! Errors of searches for critical loads.

use crate::model::plain::error;
use crate::model::{ParameterError, SearchError, ToleranceError};
use core::fmt;

/// A search for critical loads that cannot start or cannot return all it found.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum LoadError {
    /// The model of a load factor has a parameter out of its range.
    Parameter {
        /// The load factor.
        factor: f64,
        /// What is wrong.
        error: ParameterError,
    },
    /// The search found no answer at a model of the range.
    Search(SearchError),
    /// Systems under a load factor that are no ends of a box of tolerances.
    NotABox {
        /// The load factor.
        factor: f64,
        /// Why they are none.
        error: ToleranceError,
    },
    /// The number of motions that grow falls as the load grows: loads that also pull have no first critical factor that counts could certify.
    Falls {
        /// Factor from which on fewer motions grow.
        factor: f64,
    },
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoadError::Parameter { factor, error } => write!(f, "at the load factor {factor}: {error}"),
            LoadError::Search(error) => write!(f, "{error}"),
            LoadError::NotABox { factor, error } => write!(f, "at the load factor {factor}: {error}"),
            LoadError::Falls { factor } => {
                write!(
                    f,
                    "fewer motions grow beyond the load factor {factor}: loads have to compress all elements on which they act"
                )
            }
        }
    }
}

error! { LoadError }

impl From<SearchError> for LoadError {
    fn from(error: SearchError) -> Self {
        LoadError::Search(error)
    }
}
