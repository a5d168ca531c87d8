//! Errors of axial forces under loads.

use crate::model::error::ParameterError;
use crate::model::motion_error::MotionError;
use crate::model::plain::error;
use crate::model::search_error::Spot;
use core::fmt;

/// Why the axial forces under loads cannot stiffen or soften a structure.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum AxialForceError {
    /// A member that carries an axial force and has no parameter for it.
    NoAxialForce {
        /// The member.
        member: Spot,
        /// Its name, or its kind.
        name: &'static str,
        /// The axial force that it carries \[N\].
        force: f64,
    },
    /// Forces that act beside each other on what is rigid: where it turns they work, and no parameter takes that.
    Lever {
        /// The point.
        point: Spot,
        /// The sum of forces times levers \[N m\], which is a stiffness against rotation.
        stiffness: f64,
    },
    /// A joint, or a released end of a member, that slides across a force: that turns what it slides on, and no parameter takes that.
    Slides {
        /// The member.
        member: Spot,
        /// Its name, or its kind.
        name: &'static str,
        /// The force across which it slides \[N\].
        force: f64,
    },
    /// Forces that go on changing as the deflected structure is loaded: near a critical load, or beyond it.
    Unsettled {
        /// The last change of an axial force \[N\].
        change: f64,
    },
    /// A load whose value is not finite.
    Load {
        /// Its index in the list.
        index: usize,
        /// The value.
        value: f64,
    },
    /// A load, or the motion under it.
    Motion(MotionError),
    /// A member that does not take its axial force.
    Parameter(ParameterError),
}

impl From<MotionError> for AxialForceError {
    fn from(error: MotionError) -> Self {
        AxialForceError::Motion(error)
    }
}

impl From<ParameterError> for AxialForceError {
    fn from(error: ParameterError) -> Self {
        AxialForceError::Parameter(error)
    }
}

/// A member by where it is, with its name where that is not the same.
fn write_member(f: &mut fmt::Formatter<'_>, member: &Spot, name: &str) -> fmt::Result {
    match member {
        Spot::Named(_) => write!(f, "{member}"),
        _ => write!(f, "{member} ({name})"),
    }
}

impl fmt::Display for AxialForceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AxialForceError::NoAxialForce { member, name, force } => {
                write_member(f, member, name)?;
                write!(
                    f,
                    " carries an axial force of {force} N and has no parameter for it: a beam or a bar has one if it is \
                     named, `axial_force: 0.0`; a string adds it to its tension; make a spring or a rod between two places a `bar`"
                )
            }
            AxialForceError::Lever { point, stiffness } => write!(
                f,
                "forces act on levers about {point}, and turn it with a stiffness of {stiffness} N m that the model has no parameter for: let beams end where they meet, without a \
                 rigid link or body between"
            ),
            AxialForceError::Slides { member, name, force } => {
                write_member(f, member, name)?;
                write!(
                    f,
                    " slides across a force of {force} N, which turns what it slides on by more the farther it slides: no parameter takes that, so tie its displacements"
                )
            }
            AxialForceError::Unsettled { change } => write!(
                f,
                "axial forces go on changing, by {change} N in the last step: the load is near a critical one, or beyond it"
            ),
            AxialForceError::Load { index, value } => {
                write!(f, "load {index} of the list has the value {value}: loads are finite")
            }
            AxialForceError::Motion(error) => write!(f, "{error}"),
            AxialForceError::Parameter(error) => write!(f, "{error}"),
        }
    }
}

error! { AxialForceError }
