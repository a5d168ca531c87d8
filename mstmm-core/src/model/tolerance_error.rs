//! Errors of boxes of tolerances.

use crate::model::motion_error::MotionError;
use crate::model::search_error::{SearchError, Spot};
use core::fmt;

/// Why two systems are no ends of a box.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ToleranceError {
    /// A parameter by which the first system is not the softer or heavier one, or which has to be the same in both.
    NotOrdered {
        /// The element, the body or the point.
        element: Spot,
        /// The parameter.
        parameter: &'static str,
        /// Its value in the system that should be soft.
        soft: f64,
        /// Its value in the system that should be stiff.
        stiff: f64,
    },
    /// Systems of another topology, or with other places.
    NotAlike {
        /// The first part that differs.
        at: Spot,
    },
    /// An element of which no parameters are known: one of the user's own.
    NotKnown {
        /// The element.
        at: Spot,
    },
    /// A search in one of both systems.
    Search(SearchError),
    /// A load at rest on one of both systems.
    Motion(MotionError),
}

impl From<SearchError> for ToleranceError {
    fn from(error: SearchError) -> Self {
        ToleranceError::Search(error)
    }
}

impl From<MotionError> for ToleranceError {
    fn from(error: MotionError) -> Self {
        ToleranceError::Motion(error)
    }
}

impl fmt::Display for ToleranceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ToleranceError::NotOrdered { element, parameter, soft, stiff } => write!(
                f,
                "`{parameter}` of {element} is {soft} in the soft system and {stiff} in the stiff one: from the first system to the second stiffnesses have to grow, masses and inertias to \
                 fall, and all else has to be the same"
            ),
            ToleranceError::NotAlike { at } => {
                write!(f, "the two systems are not alike at {at}: a box has one topology and one geometry")
            }
            ToleranceError::NotKnown { at } => {
                write!(f, "no parameters of {at} are known, so that nothing tells which system is the softer one there")
            }
            ToleranceError::Search(error) => write!(f, "{error}"),
            ToleranceError::Motion(error) => write!(f, "{error}"),
        }
    }
}

impl core::error::Error for ToleranceError {}
