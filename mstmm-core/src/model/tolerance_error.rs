//! Errors of boxes of tolerances.

use crate::model::error::ParameterError;
use crate::model::motion_error::MotionError;
use crate::model::plain::error;
use crate::model::search_error::{SearchError, Spot};
use core::fmt;

/// Why two systems are no ends of a box.
#[derive(Clone, Copy, PartialEq)]
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
    /// A field whose values are reversed or not finite.
    Field {
        /// The field.
        field: &'static str,
        /// Its value in the first model.
        low: f64,
        /// Its value in the second model.
        high: f64,
    },
    /// A field that moves a parameter which acts both ways on frequencies.
    Mixed {
        /// The field.
        field: &'static str,
        /// The element, the body or the point.
        element: Spot,
        /// The parameter.
        parameter: &'static str,
    },
    /// A field that moves a parameter of an element of one's own, of which nothing tells how it acts on frequencies.
    OwnElement {
        /// The field.
        field: &'static str,
    },
    /// A formula that is not defined in all of a box, or has no bounds there.
    Unbounded {
        /// A field on which it depends.
        field: &'static str,
        /// Its lower bound, as far as there is one.
        low: f64,
        /// Its upper bound, as far as there is one.
        high: f64,
    },
    /// A parameter that differs by something else than fields whose formulas are known.
    Unseen {
        /// The element, the body or the point.
        element: Spot,
        /// The parameter.
        parameter: &'static str,
        /// Its value in the first model.
        low: f64,
        /// Its value in the second model.
        high: f64,
    },
    /// A name that is that of no field with formulas.
    NoSuchField {
        /// The name.
        field: &'static str,
    },
    /// A field in no parts.
    NoParts {
        /// The field.
        field: &'static str,
    },
    /// A parameter out of its range at an end of the box.
    Parameter(ParameterError),
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

impl From<ParameterError> for ToleranceError {
    fn from(error: ParameterError) -> Self {
        ToleranceError::Parameter(error)
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
            ToleranceError::Field { field, low, high } => {
                write!(
                    f,
                    "field `{field}` is {low} in the first model and {high} in the second one: a box goes up from the first to the second"
                )
            }
            ToleranceError::Mixed { field, element, parameter } => write!(
                f,
                "field `{field}` moves `{parameter}` of {element}, which acts both ways on frequencies: give it the same value in both models"
            ),
            ToleranceError::OwnElement { field } => write!(
                f,
                "field `{field}` moves a parameter of an element of your own, of which nothing tells how it acts on frequencies: give it the same value in both models"
            ),
            ToleranceError::Unbounded { field, low, high } => write!(
                f,
                "a formula of field `{field}` goes from {low} to {high}: it has to be defined and bounded in all of the box, or in each of its parts"
            ),
            ToleranceError::Unseen { element, parameter, low, high } => write!(
                f,
                "`{parameter}` of {element} is {low} in the first model and {high} in the second one by something else than fields with sensitivities: it has to be the same"
            ),
            ToleranceError::NoSuchField { field } => {
                write!(f, "the model has no field `{field}` that takes part in a box")
            }
            ToleranceError::NoParts { field } => write!(f, "field `{field}` in no parts: it has one at least"),
            ToleranceError::Parameter(error) => write!(f, "at an end of the box: {error}"),
            ToleranceError::Search(error) => write!(f, "{error}"),
            ToleranceError::Motion(error) => write!(f, "{error}"),
        }
    }
}

error! { ToleranceError }
