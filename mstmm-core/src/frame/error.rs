//! Frames that cannot be built: all that is wrong with one, in the words of its names.

use crate::model::InvalidParameter;
use crate::model::error;
use crate::pass::network::NetworkError;
use core::fmt;
use core::ops::Deref;
use std::string::String;
use std::vec::Vec;

/// What is wrong with a part of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Mistake {
    /// A beam names too little.
    Missing {
        /// The parameter that it needs.
        parameter: &'static str,
    },
    /// A beam in space names too little.
    MissingInSpace {
        /// The parameter that it needs.
        parameter: &'static str,
    },
    /// A shaft that spins names too little.
    MissingOfShaft {
        /// The parameter that it needs.
        parameter: &'static str,
    },
    /// A section names a parameter for both planes of a member in space, and for one of them.
    Twice {
        /// The parameter of one plane.
        parameter: &'static str,
    },
    /// A section names a parameter that the element has not.
    Foreign {
        /// The element.
        element: &'static str,
        /// The parameter.
        parameter: &'static str,
    },
    /// A beam along a line names an axial stiffness.
    AxialStiffness,
    /// A shear stiffness is not positive.
    ShearStiffness {
        /// Its name.
        parameter: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number is out of its range.
    Parameter(InvalidParameter),
    /// A place, a mass or a direction is out of its range.
    Number {
        /// What is wrong.
        problem: &'static str,
    },
    /// A handle is that of another frame.
    OtherFrame,
    /// A beam or a joint ends at the ground or at a path, which have no place.
    NoPlace,
    /// A spring, a damper or a path acts on a point in no direction.
    NoDirection,
    /// A direction is zero, not finite or beyond 1e±70, or the element has none to choose.
    Direction,
    /// A mass or a moment of inertia is negative or not finite, or a mass centre is not finite.
    Mass,
    /// The `up` of a member is zero, not finite or beyond 1e±70.
    Up,
    /// The ends of a joint have two directions.
    TwoAxes,
    /// Both ends of a joint are at one point, or at points of one body.
    OnePoint,
    /// A hinge names a freedom that points of this dimension have not.
    OtherDimension,
    /// What turns in space acts on a point about no axis.
    NoAxis,
    /// An end acts along a direction where it should turn about an axis, or the other way round.
    WrongWay,
    /// A member in space leads along its `up`.
    NoOrientation,
    /// A roller or a guide in space says no direction.
    NoWay,
    /// A tensor of inertia is indefinite or not finite.
    Tensor,
    /// Both ends of a member are at one place.
    SamePlace,
    /// The ends of a joint are at two places.
    TwoPlaces,
    /// A hinge names no stiffness.
    RigidHinge,
    /// Translations and rotations meet at a point of a path, or nothing does.
    Motions,
    /// A member has damping, and the frame is built without.
    Damped,
    /// A part of a rotor, and the frame is built as one that stands.
    OfRotor,
    /// A part of a rotor has damping, and the rotor is built without.
    DampedRotor,
    /// A body ties no point.
    NoPoint,
    /// A point is held twice.
    HeldTwice,
    /// Nothing joins it to the rest.
    Apart,
    /// The frame has no member.
    Empty,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Mistake::Missing { parameter: "axial_stiffness" } => {
                write!(
                    f,
                    "`axial_stiffness` is missing: in the plane and in space beams and strings stretch, too; a large number is nearly rigid"
                )
            }
            Mistake::Missing { parameter } => write!(f, "`{parameter}` is missing"),
            Mistake::MissingOfShaft { parameter } => {
                write!(
                    f,
                    "`{parameter}` is missing: a shaft that spins names `rotary_inertia`, `polar_inertia_per_length` and `speed`"
                )
            }
            Mistake::Foreign { element, parameter } => write!(f, "a {element} has no `{parameter}`"),
            Mistake::AxialStiffness => write!(f, "a beam along a line moves across it and has no `axial_stiffness`"),
            Mistake::ShearStiffness { parameter, value } => write!(f, "{parameter} is {value}, but must be positive"),
            Mistake::Parameter(error) => write!(f, "{error}"),
            Mistake::Number { problem } => write!(f, "{problem}"),
            Mistake::OtherFrame => write!(f, "a point or a member of another frame: each frame has handles of its own"),
            Mistake::NoPlace => write!(f, "it ends at the ground or at a path, which have no place: end it at a point"),
            Mistake::NoDirection => write!(f, "it acts on a point in no direction: `point.along(..)`"),
            Mistake::Direction => {
                write!(
                    f,
                    "its direction is zero, not finite, beyond 1e±70, or not its own to choose, as that of a beam"
                )
            }
            Mistake::SamePlace => {
                write!(f, "both ends are at one place: beams and strings have a length, a spring there a direction")
            }
            Mistake::TwoPlaces => write!(f, "the ends of a joint are at one place, and its are at two"),
            Mistake::RigidHinge => write!(
                f,
                "it lets nothing go and would be rigid: a hinge names a stiffness, `stiffness_rz(0.0)`, or write `Pin`"
            ),
            Mistake::Motions => {
                write!(f, "springs that move and springs that turn meet at this point of a path, or nothing does")
            }
            Mistake::Damped => write!(f, "it has damping: `build_damped()` has eigenvalues"),
            Mistake::OfRotor => write!(f, "it belongs to a rotor: `build_rotor()` has both whirls"),
            Mistake::DampedRotor => write!(f, "it has damping: `build_damped_rotor()` has eigenvalues"),
            Mistake::NoPoint => write!(f, "it ties no point"),
            Mistake::HeldTwice => write!(f, "it is held twice: name all that is held at once"),
            Mistake::Apart => write!(f, "nothing joins it to the rest: build two structures"),
            Mistake::Empty => write!(f, "the frame has no member"),
            in_space => in_space.fmt_in_space(f),
        }
    }
}

impl Mistake {
    /// What is wrong in space alone.
    fn fmt_in_space(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Mistake::MissingInSpace { parameter } => {
                write!(
                    f,
                    "`{parameter}` is missing: a beam in space stretches and bends both ways, by `axial_stiffness`, `bending_stiffness` or \
                     `bending_stiffness_y` and `_z`, `mass_per_length`, and it turns, unless it is a `Bar`, by `torsional_stiffness`, \
                     `polar_inertia_per_length`"
                )
            }
            Mistake::Twice { parameter } => {
                write!(
                    f,
                    "`{parameter}` is named, and that without an index, which stands for both planes: name one of them"
                )
            }
            Mistake::Mass => write!(f, "mass and inertia must be zero or positive, and finite like the mass centre"),
            Mistake::Up => write!(f, "its `up` is zero, not finite or beyond 1e±70"),
            Mistake::TwoAxes => {
                write!(f, "its ends have two directions, and a joint has one: name it at one end, or the same at both")
            }
            Mistake::OnePoint => {
                write!(f, "both ends are at one point, or at points of one body: a joint stands between two")
            }
            Mistake::OtherDimension => write!(f, "it names a stiffness, a damping or an `up` of another dimension"),
            Mistake::NoAxis => write!(f, "it turns about no axis: `point.about([x, y, z])`"),
            Mistake::WrongWay => {
                write!(
                    f,
                    "springs and dampers act `along` a direction, and torsion springs, torsion dampers and shafts `about` an axis"
                )
            }
            Mistake::NoOrientation => {
                write!(
                    f,
                    "it leads along its `up`, which is [0, 0, 1] unless it is named, and both its planes differ: name another `up`"
                )
            }
            Mistake::NoWay => {
                write!(
                    f,
                    "a roller or a guide in space says which way: `Roller::normal([0.0, 0.0, 1.0])` holds one direction, `Roller::along` leaves one, `.without_rotation()` makes it a guide"
                )
            }
            Mistake::Tensor => {
                write!(f, "its tensor of inertia is not finite, or indefinite: a moment about some axis is negative")
            }
            _ => Ok(()),
        }
    }
}

/// One thing that is wrong with a frame.
#[derive(Clone, PartialEq)]
pub struct BuildError {
    /// The part: its name, or its number.
    pub part: String,
    /// What is wrong with it.
    pub mistake: Mistake,
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.part, self.mistake)
    }
}

error! { BuildError }

/// All that is wrong with a frame, at least one thing.
#[derive(Clone, PartialEq)]
pub struct BuildErrors(pub(crate) Vec<BuildError>);

impl Deref for BuildErrors {
    type Target = [BuildError];

    fn deref(&self) -> &[BuildError] {
        &self.0
    }
}

impl fmt::Display for BuildErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, error) in self.0.iter().enumerate() {
            write!(f, "{}{error}", if place > 0 { "\n" } else { "" })?;
        }
        Ok(())
    }
}

error! { BuildErrors }

impl Mistake {
    /// What a network says against a member or a node.
    pub(crate) fn of(error: NetworkError) -> Self {
        match error {
            NetworkError::InvalidNode { problem, .. } => Mistake::Number { problem },
            NetworkError::Parameter { error, .. } => {
                // frames say rz, as they say x and y
                let parameter = match error.parameter {
                    "stiffness_theta" => "stiffness_rz",
                    "damping_theta" => "damping_rz",
                    other => other,
                };
                Mistake::Parameter(InvalidParameter { parameter, ..error })
            }
            NetworkError::SamePlace { .. } => Mistake::SamePlace,
            NetworkError::TwoPlaces { .. } => Mistake::TwoPlaces,
            NetworkError::Direction { .. } => Mistake::Direction,
            NetworkError::Apart { .. } => Mistake::Apart,
            _ => Mistake::Empty,
        }
    }
}
