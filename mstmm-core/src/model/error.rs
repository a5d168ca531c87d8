//! Parameters out of their ranges: errors carry the numbers that caused them.

use crate::model::member_plane::PARALLEL;
use crate::model::plain::error;
use crate::number::{Parameter, binary_exponent};
use core::fmt;

/// The range that a parameter must satisfy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Requirement {
    /// Any finite number.
    Finite,
    /// Finite and greater than zero.
    Positive,
    /// Greater than zero and finite, with a finite reciprocal, as for a compliance.
    Invertible,
    /// Greater than zero, with a finite reciprocal, or infinite, which is rigid.
    InvertibleOrInfinite,
    /// Zero, or greater with a finite reciprocal: a spring that lets go where it is zero.
    InvertibleOrZero,
    /// Not so extreme that products with the other parameters of the element leave the range of the type.
    Rescale,
    /// Finite and not less than zero.
    NonNegative,
    /// Finite and at least `bound`, which comes from `formula`, with room for the rounding of the caller, who may have
    /// computed the same product in another order (three roundings on either side).
    AtLeast {
        /// Smallest valid value.
        bound: f64,
        /// Where the bound comes from, in terms of the other parameters.
        formula: &'static str,
    },
    /// Finite and greater than `bound`, which comes from `formula`.
    Above {
        /// Largest value that is not valid.
        bound: f64,
        /// Where the bound comes from, in terms of the other parameters.
        formula: &'static str,
    },
    /// From `least` to `most`.
    Between {
        /// Smallest valid value.
        least: f64,
        /// Largest valid value.
        most: f64,
    },
    /// Positive, as the distance of two points: they are not at one place.
    Apart {
        /// Name of the one point.
        from: &'static str,
        /// Name of the other.
        to: &'static str,
    },
    /// The larger part of a direction, of whatever length between 1e-70 and 1e70.
    Direction,
    /// Not negative, as the least moment of inertia of a body about any axis.
    LeastMoment,
    /// The sine of the angle between the axis of a member and its `up`: the z axis of the member is not along it.
    Orientation,
    /// Of a structure with as many nodes and members as this one.
    SameStructure,
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Requirement::Finite => write!(f, "a finite number"),
            Requirement::Positive => write!(f, "positive and finite"),
            Requirement::Invertible => write!(f, "positive and finite, with a finite reciprocal"),
            Requirement::InvertibleOrInfinite => write!(f, "positive, with a finite reciprocal; infinite is rigid"),
            Requirement::InvertibleOrZero => write!(f, "zero, or positive and finite, with a finite reciprocal"),
            Requirement::Rescale => write!(f, "not too extreme beside the other parameters"),
            Requirement::NonNegative => write!(f, "zero or positive, and finite"),
            Requirement::AtLeast { bound, formula } => write!(f, "finite and at least {formula} = {bound}"),
            Requirement::Above { bound, formula } => write!(f, "finite and greater than {formula} = {bound}"),
            Requirement::Between { least, most } => write!(f, "from {} to {}", Readable(*least), Readable(*most)),
            Requirement::Apart { from, to } => write!(f, "positive and finite: {from} and {to} are at one place"),
            Requirement::Direction => write!(f, "a direction, whose largest part is between 1e-70 and 1e70"),
            Requirement::LeastMoment => write!(f, "the inertia of a body, whose moment about no axis is negative"),
            Requirement::SameStructure => write!(f, "the axial force of a member of this structure"),
            Requirement::Orientation => {
                write!(f, "at an angle to that: name another `up`, a vector that becomes the z axis")
            }
        }
    }
}

/// Whether a vector with such a larger part is a direction: its squares, and products of these, have to be in the range of numbers.
pub(crate) fn is_size_of_direction(size: f64) -> bool {
    (1e-70..=1e70).contains(&size.abs())
}

/// The largest error of `operations` roundings in a number of size `scale`.
fn rounding(operations: u32, scale: f64) -> f64 {
    f64::from(operations) * f64::EPSILON * scale
}

/// A parameter out of its range, as an element sees it.
#[derive(Clone, Copy, PartialEq)]
pub struct InvalidParameter {
    /// Name of the parameter.
    pub parameter: &'static str,
    /// The value that was given.
    pub value: f64,
    /// What it must satisfy.
    pub requirement: Requirement,
}

impl fmt::Display for InvalidParameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let InvalidParameter { parameter, value, requirement } = self;
        if let (Requirement::Apart { from, to }, true) = (requirement, *value == f64::INFINITY) {
            return write!(f, "{parameter} is infinite: {from} and {to} are farther apart than numbers reach");
        }
        match requirement {
            Requirement::LeastMoment => {
                write!(f, "{parameter} has the least moment {}, but must be {requirement}", Readable(*value))
            }
            Requirement::Orientation => {
                write!(
                    f,
                    "{parameter} leads along the x axis, with the sine {}, but must be {requirement}",
                    Readable(*value)
                )
            }
            _ => write!(f, "{parameter} is {}, but must be {requirement}", Readable(*value)),
        }
    }
}

error! { InvalidParameter }

/// A number in messages: with an exponent where it would have many digits.
pub(crate) struct Readable(pub(crate) f64);

impl fmt::Display for Readable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Readable(value) = *self;
        let is_short = value == 0.0 || !value.is_finite() || (1e-6..1e16).contains(&value.abs());
        if is_short { write!(f, "{value}") } else { write!(f, "{value:e}") }
    }
}

impl InvalidParameter {
    /// The parameter farthest from 1, of those whose products leave the range of the type; the first of several.
    pub(crate) fn most_extreme<T: Parameter, const N: usize>(parameters: [(&'static str, T); N]) -> Self {
        let parameters = parameters.map(|(name, value)| (name, value.to_f64()));
        let mut worst = parameters[0];
        for parameter in parameters {
            if binary_exponent(parameter.1).abs() > binary_exponent(worst.1).abs() {
                worst = parameter;
            }
        }
        InvalidParameter { parameter: worst.0, value: worst.1, requirement: Requirement::Rescale }
    }

    /// The error with the name of the element in the model.
    pub fn of(self, element: &'static str) -> ParameterError {
        ParameterError { element, parameter: self.parameter, value: self.value, requirement: self.requirement }
    }
}

impl Requirement {
    /// At least `bound`, which comes from `formula`.
    pub fn at_least<T: Parameter>(bound: T, formula: &'static str) -> Self {
        Requirement::AtLeast { bound: bound.to_f64(), formula }
    }

    /// Greater than `bound`, which comes from `formula`.
    pub fn above<T: Parameter>(bound: T, formula: &'static str) -> Self {
        Requirement::Above { bound: bound.to_f64(), formula }
    }

    /// Checks `value` and names it `parameter` if it fails.
    ///
    /// # Errors
    /// [`InvalidParameter`] if the value does not satisfy the requirement; a NaN satisfies none.
    ///
    /// ```
    /// use mstmm_core::Requirement;
    /// assert!(Requirement::Positive.check("length", 1.5).is_ok());
    /// assert!(Requirement::NonNegative.check("damping", f64::NAN).is_err());
    /// ```
    pub fn check<T: Parameter>(self, parameter: &'static str, value: T) -> Result<(), InvalidParameter> {
        if T::IN_LANES {
            // each model was built alone before
            return Ok(());
        }
        let reciprocal = || (T::one() / value).to_f64();
        let number = value.to_f64();
        let valid = match self {
            Requirement::Finite | Requirement::SameStructure => true,
            Requirement::Positive | Requirement::Rescale | Requirement::Apart { .. } => number > 0.0,
            Requirement::Direction => is_size_of_direction(number),
            Requirement::Invertible => number > 0.0 && reciprocal().is_finite(),
            Requirement::InvertibleOrZero => number == 0.0 || number > 0.0 && reciprocal().is_finite(),
            Requirement::InvertibleOrInfinite => {
                return if number > 0.0 && (number == f64::INFINITY || reciprocal().is_finite()) {
                    Ok(())
                } else {
                    Err(InvalidParameter { parameter, value: number, requirement: self })
                };
            }
            Requirement::NonNegative | Requirement::LeastMoment => number >= 0.0,
            Requirement::Orientation => number > PARALLEL,
            Requirement::Above { bound, .. } => number > bound,
            Requirement::Between { least, most } => (least..=most).contains(&number),
            // see `AtLeast`: three roundings of each of two numbers of the size of the bound
            Requirement::AtLeast { bound, .. } => number >= bound - rounding(3, 2.0 * bound.abs()),
        };
        if valid && number.abs() < f64::INFINITY {
            return Ok(());
        }
        Err(InvalidParameter { parameter, value: number, requirement: self })
    }
}

/// A parameter of a model out of its range.
#[derive(Clone, Copy, PartialEq)]
pub struct ParameterError {
    /// Keyword and label of the element, as in the model.
    pub element: &'static str,
    /// Name of the parameter.
    pub parameter: &'static str,
    /// The value that was given.
    pub value: f64,
    /// What it must satisfy.
    pub requirement: Requirement,
}

impl ParameterError {
    /// The error in the words of a model, given the fields of a type that are other words there: `(field, word)`.
    #[doc(hidden)]
    pub fn called(mut self, words: &[(&str, &'static str)]) -> Self {
        for (field, word) in words {
            if self.parameter == *field {
                self.parameter = word;
                break;
            }
        }
        self
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ParameterError { element, parameter, value, requirement } = *self;
        write!(f, "{element}: {}", InvalidParameter { parameter, value, requirement })
    }
}

error! { ParameterError }

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn numbers_of_messages_are_short_and_places_far_apart_are_told() {
        let error = Requirement::Invertible.check("stiffness", 1e-320).unwrap_err().to_string();
        assert_eq!(error, "stiffness is 1e-320, but must be positive and finite, with a finite reciprocal");
        let apart = Requirement::Apart { from: "a", to: "b" };
        let error = apart.check("length", f64::INFINITY).unwrap_err().to_string();
        assert_eq!(error, "length is infinite: a and b are farther apart than numbers reach");
        assert!(apart.check("length", 0.0).unwrap_err().to_string().ends_with("a and b are at one place"));
    }

    #[test]
    fn message_names_element_parameter_and_value() {
        let error = Requirement::Positive.check("length", -2.0).unwrap_err().of("beam 1");
        assert_eq!(error.to_string(), "beam 1: length is -2, but must be positive and finite");
    }

    #[test]
    fn what_is_infinite_may_be_rigid() {
        for (value, valid) in [(1.0, true), (f64::INFINITY, true), (f64::NEG_INFINITY, false), (f64::NAN, false)] {
            assert_eq!(Requirement::InvertibleOrInfinite.check("shear_stiffness", value).is_ok(), valid, "{value}");
        }
        for value in [0.0, -1.0, 1e-320] {
            assert!(Requirement::InvertibleOrInfinite.check("shear_stiffness", value).is_err(), "{value}");
        }
    }

    #[test]
    fn a_field_is_called_by_the_word_of_the_model() {
        let error = Requirement::Positive.check("stiffness", -2.0).unwrap_err().of("hinge 1");
        let words = [("stiffness", "stiffness_rz"), ("stiffness_rz", "other")];
        assert_eq!(error.called(&words).parameter, "stiffness_rz");
        assert_eq!(error.called(&[("length", "span")]), error);
    }

    #[test]
    fn a_finite_reciprocal_is_that_of_the_type_of_the_parameter() {
        for (value, valid) in [(1e-300, true), (1e-309, false), (1e-320, false), (0.0, false), (-1.0, false)] {
            assert_eq!(Requirement::Invertible.check("stiffness", value).is_ok(), valid, "{value}");
        }
        assert!(Requirement::Invertible.check("stiffness", 1e-38_f32).is_ok());
        assert!(Requirement::Invertible.check("stiffness", 1e-40_f32).is_err());
    }

    #[test]
    fn no_requirement_accepts_a_number_that_is_not_finite() {
        let all = [
            Requirement::Finite,
            Requirement::Positive,
            Requirement::Invertible,
            Requirement::NonNegative,
            Requirement::AtLeast { bound: 0.0, formula: "nothing" },
            Requirement::Apart { from: "one point", to: "another" },
            Requirement::Direction,
        ];
        for requirement in all {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                assert!(requirement.check("length", value).is_err(), "{requirement:?} accepts {value}");
            }
        }
    }
}
