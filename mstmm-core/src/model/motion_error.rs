//! Errors of questions about motions.

use crate::model::plain::error;
use crate::model::search_error::Spot;
use core::fmt;
use mstmm_plan::{Coordinate, Freedoms};

/// The reason why a motion cannot be given.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum MotionError {
    /// The root has several shapes.
    Multiple {
        /// Size of the root, |ω| or |λ|.
        root: f64,
        /// Its multiplicity.
        multiplicity: u64,
    },
    /// The system has no motion of its own at this frequency.
    NotARoot {
        /// Size of the frequency, |ω| or |λ|.
        frequency: f64,
        /// Relative difference of the states at one point.
        mismatch: f64,
    },
    /// The states of a shape do not fit together: other roots are so close that rounding moves forces from path to path.
    Unresolved {
        /// Size of the root, |ω| or |λ|.
        root: f64,
        /// Difference of states at a connection, relative to the largest in the system.
        misfit: f64,
    },
    /// A multiple eigenvalue with fewer shapes than its multiplicity, as at critical damping.
    Defective {
        /// Size of the eigenvalue |λ|.
        root: f64,
        /// Its multiplicity.
        multiplicity: u64,
        /// Number of its shapes.
        shapes: u64,
    },
    /// At frequency zero the derivative of ω is not defined: ω² moves, and ω is its root. A rotor that rests has no shapes either.
    ZeroFrequency,
    /// The system resonates at this frequency: the response to a force is infinite. It is not determined at a multiple root that the
    /// force does not excite, and at any frequency of a model without a spectrum.
    Resonance {
        /// Size of the frequency, |ω| or |λ|.
        frequency: f64,
    },
    /// Something without mass is held by nothing, or something is held twice: no response is determined at any frequency.
    Mechanism {
        /// Where in the structure that shows.
        at: Spot,
    },
    /// The limit of a response at rest, without its poles, is uncertain: other roots are too close to zero.
    Unsettled {
        /// Relative difference of limits from two ranges of frequencies.
        change: f64,
    },
    /// A frequency at which numbers overflow, or which is not a number.
    NotFinite {
        /// Size of the frequency, |ω| or |λ|.
        frequency: f64,
    },
    /// The states at this point have no such entry: no path there carries it.
    NoSuchEntry {
        /// The entry.
        coordinate: Coordinate,
    },
    /// A node or a member of another list.
    NoSuchPoint {
        /// Index of the node or of the member.
        index: usize,
    },
    /// A point or a member of another frame.
    OtherFrame {
        /// Its number there.
        index: usize,
    },
    /// A parameter that a member or a body of a frame has not, or without a derivative.
    NoSuchParameter,
    /// A point of a plane structure without this motion, or the end of a member that does not share it with its node.
    NoSuchFreedom {
        /// The motion: along or about x, y or z; of a member along it, across it, or the rotation.
        freedom: Freedoms,
    },
    /// A point of a plane structure that no support holds in this freedom.
    NotHeld {
        /// The freedom: along or about x, y or z.
        freedom: Freedoms,
    },
    /// A reaction to the motion of a support, which has a part that grows with the frequency and is no sum over modes.
    NotModal,
    /// A motion in time, or one at `Im λ < 0`, of a system in which something has a loss factor: that describes motions with `Im λ > 0` alone.
    LossFactor,
    /// A range of frequencies that is empty, reversed or not finite.
    Range {
        /// Start of the range [rad/s].
        start: f64,
        /// End of the range [rad/s].
        end: f64,
    },
    /// A tolerance that is not positive or not finite.
    Tolerance {
        /// The tolerance that was given.
        tolerance: f64,
    },
    /// An element on which no load acts all along, or whose weight is not known: a tapered beam, one of the user's own, and between places what
    /// has a mass on a path of one motion.
    NoUniformLoad,
    /// An element without an interior: it has states at its ends only.
    NoInside,
    /// A place outside of an element.
    Outside {
        /// Distance from the input end \[m\].
        distance: f64,
        /// Length of the element \[m\].
        length: f64,
    },
    /// A step of time that is not positive or not finite.
    TimeStep {
        /// The step \[s\].
        step: f64,
    },
    /// A damping ratio with which modes do not vibrate: not between 0 and 1.
    DampingRatio {
        /// The ratio.
        ratio: f64,
    },
    /// Another number of damping ratios than roots.
    DampingRatios {
        /// How many were given.
        given: usize,
        /// How many roots are in the list.
        needed: usize,
    },
    /// Damping in proportion to the stiffness of a system in which a member bears an axial force: a stiffness that nothing damps.
    AxialForce,
    /// A mode that is critically damped: its motion is no sum of exponentials.
    Critical {
        /// Its natural frequency [rad/s].
        frequency: f64,
    },
    /// Damping of a rate, or of a response to an acceleration: damping comes first.
    Derived,
    /// Damping in proportion of a system in which something is damped already.
    Damped,
    /// A rate of an entry of which a part follows the load, or its rate, at once.
    AtOnce,
    /// An acceleration of a support where the load is no motion of one.
    NoSupportMotion,
    /// A motion of the ground where the load is no acceleration of it.
    NotOfGround,
    /// A body that something holds in part: how much of its mass modes can move is not known.
    HeldMass {
        /// The body.
        at: Spot,
    },
    /// There are more results than the capacity; none is returned.
    Capacity {
        /// The capacity.
        capacity: usize,
    },
}

impl fmt::Display for MotionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            MotionError::Multiple { root, multiplicity } => {
                write!(
                    f,
                    "the root of size {root} has multiplicity {multiplicity}: its shapes are given by `mode_shapes`, "
                )?;
                write!(f, "and it has no derivative, since its parts move apart")
            }
            MotionError::NotARoot { frequency, mismatch } => {
                write!(
                    f,
                    "a frequency of size {frequency} is no root of this system, with these parameters: states differ by {mismatch:.1e}"
                )
            }
            MotionError::Unresolved { root, misfit } => {
                write!(
                    f,
                    "the shape of the root of size {root} cannot be told from others near it: states differ by {misfit:.1e}"
                )
            }
            MotionError::Defective { root, multiplicity, shapes } => {
                write!(f, "the eigenvalue {root} of multiplicity {multiplicity} has {shapes} shapes only")
            }
            MotionError::ZeroFrequency => {
                write!(f, "a zero frequency has no derivative, since it is the root of ω², and of a rotor no shape")
            }
            MotionError::Resonance { frequency: 0.0 } => {
                write!(f, "nothing holds the system at rest: under the load it moves off as a rigid body")
            }
            MotionError::Resonance { frequency } => {
                write!(
                    f,
                    "the system resonates at the frequency {frequency}: its response is infinite or not determined"
                )
            }
            MotionError::Mechanism { at } => {
                write!(f, "a part without mass is held by nothing, or something is held twice, as shows at {at}")
            }
            MotionError::Unsettled { change } => {
                write!(
                    f,
                    "the response at rest cannot be told from that of roots close to zero: its limit is uncertain by {change:.1e} of it"
                )
            }
            MotionError::NotFinite { frequency } => {
                write!(f, "at the frequency {frequency} the motion is not finite")
            }
            MotionError::LossFactor | MotionError::NoUniformLoad => self.fmt_limit(f),
            _ => self.fmt_question(f),
        }
    }
}

impl MotionError {
    /// What the elements of a system do not tell.
    fn fmt_limit(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == MotionError::LossFactor {
            write!(
                f,
                "a loss factor describes motions with Im λ > 0, not those in time: ask `frequency_response`, or take "
            )?;
            return write!(f, "`kelvin_voigt_time`");
        }
        write!(
            f,
            "no load acts all along this element, or the weight of an element or of a mass on a path is not known"
        )
    }

    /// What is wrong with a question, whatever the system.
    fn fmt_question(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            MotionError::NoSuchEntry { coordinate } => {
                let (name, path) = match coordinate {
                    Coordinate::Y => ("deflection Y", "bending or translation"),
                    Coordinate::Q => ("shear force Q", "bending or translation"),
                    Coordinate::Theta => ("rotation Θ", "bending or rotation"),
                    Coordinate::M => ("moment M", "bending or rotation"),
                    Coordinate::X | Coordinate::Qx => ("longitudinal entry", "planar"),
                };
                write!(f, "no state at this point has a {name}: no {path} path leads there")
            }
            MotionError::NoSuchPoint { index } => write!(f, "this structure has no node or member {index}"),
            MotionError::NoSuchParameter => write!(f, "no parameter of this name has a derivative here"),
            MotionError::OtherFrame { index } => write!(f, "point or member {index} belongs to another frame"),
            MotionError::NotHeld { freedom } => {
                let name = held_name(freedom);
                write!(f, "no support holds this point {name}: there is no reaction, and nothing that could move it")
            }
            MotionError::NoSuchFreedom { freedom } => {
                let name = motion_name(freedom);
                write!(f, "this point has no {name}: no element there brings it, or a joint releases it")
            }
            MotionError::Range { start, end } => {
                write!(f, "the range from {start} to {end} rad/s must run upwards and be finite")
            }
            MotionError::Tolerance { tolerance } => {
                write!(f, "the tolerance {tolerance} must be positive and finite")
            }
            MotionError::NoInside => {
                write!(f, "this element has no inside: ask for the states at its `input()` and `output()`")
            }
            MotionError::Outside { distance, length } => {
                write!(f, "{distance} m from the input end is outside of the element, whose length is {length} m")
            }
            MotionError::Capacity { capacity } => {
                write!(f, "there are more results than the capacity of {capacity}; ask for a larger one")
            }
            _ => self.fmt_sum(f),
        }
    }

    /// What is wrong with a sum over modes.
    fn fmt_sum(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            MotionError::NotModal => {
                write!(
                    f,
                    "a reaction to the motion of a support is no sum over modes: ask `frequency_response` for it, or for forces in members"
                )
            }
            MotionError::TimeStep { step } => write!(f, "a step of {step} s is none: it has to be positive and finite"),
            MotionError::DampingRatio { ratio } => {
                write!(f, "with a damping ratio of {ratio} no mode vibrates: it has to be at least 0 and below 1")
            }
            MotionError::DampingRatios { given, needed } => {
                write!(f, "the list has {needed} roots, and {given} damping ratios were given: one for each root")
            }
            MotionError::AxialForce => {
                write!(
                    f,
                    "a member bears an axial force, a stiffness that nothing damps: damping in proportion would damp it"
                )
            }
            MotionError::Critical { frequency } => {
                write!(
                    f,
                    "the mode at {frequency} rad/s is critically damped to rounding: damp it by another 1e-8 of that"
                )
            }
            MotionError::Derived => {
                write!(
                    f,
                    "damp the response first, and then ask for its rate, its acceleration or its response to an acceleration"
                )
            }
            MotionError::Damped => {
                write!(
                    f,
                    "something in the system is damped already: damping in proportion is that of an undamped system"
                )
            }
            MotionError::AtOnce => {
                write!(
                    f,
                    "a part of the entry follows the load at once, and its rate is no sum over modes: under a motion take `from_acceleration`"
                )
            }
            MotionError::NoSupportMotion => {
                write!(
                    f,
                    "the load is no motion of a support: an acceleration of the ground is the load `base_acceleration`"
                )
            }
            MotionError::NotOfGround => {
                write!(f, "the load is no acceleration of the ground: take the load `base_acceleration`")
            }
            MotionError::HeldMass { at } => {
                write!(f, "something holds a part of the mass at {at}: how much of it modes can move is not known")
            }
            _ => Ok(()),
        }
    }
}

/// How a support holds a freedom.
fn held_name(freedom: Freedoms) -> &'static str {
    match freedom {
        Freedoms::X => "along x",
        Freedoms::Y => "along y",
        Freedoms::Z => "along z",
        Freedoms::RX => "against rotation about x",
        Freedoms::RY => "against rotation about y",
        _ => "against rotation",
    }
}

/// A motion of a freedom, or its force.
fn motion_name(freedom: Freedoms) -> &'static str {
    match freedom {
        Freedoms::X => "displacement or force along x",
        Freedoms::Y => "displacement or force along y",
        Freedoms::Z => "displacement or force along z",
        Freedoms::RX => "rotation or moment about x",
        Freedoms::RY => "rotation or moment about y",
        _ => "rotation or moment",
    }
}

error! { MotionError }
