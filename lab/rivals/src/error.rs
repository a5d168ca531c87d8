//! What can go wrong.

use core::fmt;
use mstmm::element::ParameterError;
use mstmm::search::SearchError;

/// A failure of the measurements themselves; a method that finds nothing has a [`Run`](crate::Run) that says so.
#[derive(Debug)]
pub enum Error {
    /// A model cannot be built.
    Parameter(ParameterError),
    /// The exact roots of a scene were not found.
    Search(SearchError),
    /// The runs cannot be written as JSON.
    Json(serde_json::Error),
    /// The runs cannot be written as CSV.
    Csv(csv::Error),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Parameter(error) => write!(f, "a model cannot be built: {error}"),
            Error::Search(error) => write!(f, "no exact roots: {error}"),
            Error::Json(error) => write!(f, "no JSON: {error}"),
            Error::Csv(error) => write!(f, "no CSV: {error}"),
        }
    }
}

impl core::error::Error for Error {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        Some(match self {
            Error::Parameter(error) => error,
            Error::Search(error) => error,
            Error::Json(error) => error,
            Error::Csv(error) => error,
        })
    }
}

impl From<ParameterError> for Error {
    fn from(error: ParameterError) -> Self {
        Error::Parameter(error)
    }
}

impl From<SearchError> for Error {
    fn from(error: SearchError) -> Self {
        Error::Search(error)
    }
}

impl From<serde_json::Error> for Error {
    fn from(error: serde_json::Error) -> Self {
        Error::Json(error)
    }
}

impl From<csv::Error> for Error {
    fn from(error: csv::Error) -> Self {
        Error::Csv(error)
    }
}
