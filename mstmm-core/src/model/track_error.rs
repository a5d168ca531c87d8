//! Errors of loads that move along members.

use crate::model::motion_error::MotionError;
use crate::model::plain::error;
use core::fmt;

/// Why a load does not move along members.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TrackError {
    /// The list has no member.
    NoMembers,
    /// Members that are no straight chain, by the place in the list of the first one that is not on from the one before.
    NotATrack {
        /// Its place in the list, from 0 on.
        place: usize,
        /// What is wrong with it.
        reason: NotATrack,
    },
    /// A member whose deflection is no sum of exponentials: a tapered beam, an element of the user's own without
    /// [`deflection`](crate::MemberMotion::deflection), a spring or a joint.
    NoWaves {
        /// Its place in the list, from 0 on.
        place: usize,
    },
    /// A member of which two wave numbers coincide at a frequency, as those of a beam on a foundation do at rest at the load at which it buckles if it is long.
    Coincide {
        /// Its place in the list, from 0 on.
        place: usize,
        /// The frequency [rad/s].
        frequency: f64,
    },
    /// A speed that is not positive or not finite.
    Speed {
        /// The speed [m/s].
        speed: f64,
    },
    /// A part of the question.
    Motion(MotionError),
}

/// What is wrong with a member of a track.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotATrack {
    /// It does not begin where the one before ends: another order, a member twice, or an arrow the other way.
    Apart,
    /// It leads in another direction than the one before.
    Turned,
    /// It does not move across itself in the plane: it stands in space, or on a path, or acts in a direction of its own.
    NotAcross,
}

impl From<MotionError> for TrackError {
    fn from(error: MotionError) -> Self {
        TrackError::Motion(error)
    }
}

impl fmt::Display for TrackError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TrackError::NoMembers => write!(f, "a load moves along members: the list has none"),
            TrackError::NotATrack { place, reason } => {
                write!(f, "member {place} of the list is no part of a track: {reason}")
            }
            TrackError::NoWaves { place } => write!(
                f,
                "member {place} of the list has no wave numbers: loads move along uniform beams and strings between places"
            ),
            TrackError::Coincide { place, frequency } => write!(
                f,
                "two wave numbers of member {place} of the list coincide at {frequency} rad/s, where its waves cannot be told apart: change a parameter by a thousandth"
            ),
            TrackError::Speed { speed } => {
                write!(f, "no load moves with a speed of {speed} m/s: it has to be positive and finite")
            }
            TrackError::Motion(error) => write!(f, "{error}"),
        }
    }
}

impl fmt::Display for NotATrack {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            NotATrack::Apart => {
                "it does not begin where the member before it ends: list members in their order, along their arrows"
            }
            NotATrack::Turned => "it leads in another direction than the member before it",
            NotATrack::NotAcross => "it is no beam or string of the plane that stands between two places",
        })
    }
}

error! { TrackError }
