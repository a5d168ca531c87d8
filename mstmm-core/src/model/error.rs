//! Errors: each carries the numbers that caused it.

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
    /// Positive, and not so extreme that products with the other parameters of the element leave the range of the type.
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
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Requirement::Finite => write!(f, "a finite number"),
            Requirement::Positive => write!(f, "positive and finite"),
            Requirement::Invertible => write!(f, "positive and finite, with a finite reciprocal"),
            Requirement::Rescale => write!(f, "positive, and not too extreme beside the other parameters"),
            Requirement::NonNegative => write!(f, "zero or positive, and finite"),
            Requirement::AtLeast { bound, formula } => write!(f, "finite and at least {formula} = {bound}"),
            Requirement::Above { bound, formula } => write!(f, "finite and greater than {formula} = {bound}"),
            Requirement::Between { least, most } => write!(f, "from {least} to {most}"),
            Requirement::Apart { from, to } => write!(f, "positive and finite: {from} and {to} are at one place"),
            Requirement::Direction => write!(f, "a direction, whose larger part is between 1e-70 and 1e70"),
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
#[derive(Clone, Copy, Debug, PartialEq)]
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
        write!(f, "{parameter} is {value}, but must be {requirement}")
    }
}

impl core::error::Error for InvalidParameter {}

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
            Requirement::Finite => true,
            Requirement::Positive | Requirement::Rescale | Requirement::Apart { .. } => number > 0.0,
            Requirement::Direction => is_size_of_direction(number),
            Requirement::Invertible => number > 0.0 && reciprocal().is_finite(),
            Requirement::NonNegative => number >= 0.0,
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
#[derive(Clone, Copy, Debug, PartialEq)]
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

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ParameterError { element, parameter, value, requirement } = *self;
        write!(f, "{element}: {}", InvalidParameter { parameter, value, requirement })
    }
}

impl core::error::Error for ParameterError {}

/// What a point or a member of a network is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// The node of an index, of a network that is a list.
    Node(usize),
    /// The member of an index, of a network that is a list.
    Member(usize),
    /// What has a name.
    Named(&'static str),
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Spot::Node(node) => write!(f, "node {node}"),
            Spot::Member(member) => write!(f, "member {member}"),
            Spot::Named(name) => write!(f, "{name}"),
        }
    }
}

/// A search that cannot start or cannot return all it found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SearchError {
    /// The range is empty, reversed or not finite, or its length is beyond the range of `f64`.
    Range {
        /// Start of the range.
        start: f64,
        /// End of the range.
        end: f64,
    },
    /// A grid needs at least three points in each direction, and no more than the search has room for.
    Grid {
        /// Points asked for.
        points: usize,
        /// Largest number of points of this direction.
        limit: usize,
    },
    /// A tolerance must be positive and finite.
    Tolerance {
        /// The tolerance that was given.
        tolerance: f64,
    },
    /// The function returned a NaN.
    NotANumber {
        /// First coordinate of the point.
        x: f64,
        /// Second coordinate of the point; zero in one dimension.
        y: f64,
    },
    /// The function is zero at every point that was tried: it vanishes identically, and every point of the range is a root. A
    /// degree of freedom is held twice, or a massless one by nothing.
    Zero {
        /// Number of points.
        points: usize,
        /// Where in a network that shows.
        at: Option<Spot>,
    },
    /// A search on a rectangle did not come to rest.
    StillMoving {
        /// First coordinate of the point where it was given up.
        x: f64,
        /// Second coordinate of that point.
        y: f64,
        /// How often it had moved with cells of one size.
        moves: usize,
    },
    /// The system has fewer roots than were asked for.
    TooFewRoots {
        /// How many it has.
        found: u64,
    },
    /// The search was given up: it took too many evaluations for the roots that it found. The region is too large, or too narrow
    /// beside roots on its edges.
    Effort {
        /// Evaluations so far.
        evaluations: usize,
        /// Eigenvalues that were found, in the region or close to it, of each pair one.
        found: usize,
    },
    /// Rounding leaves too few digits: counts contradict each other, sums cancel, or a count is asked for at a root itself. Nothing
    /// is certified, so nothing is returned.
    Unresolved {
        /// Frequency near which this happened.
        near: f64,
    },
    /// The system is statically unstable: motions grow, and have no frequency. Their rates are real eigenvalues.
    Unstable {
        /// How many motions grow.
        modes: u64,
    },
    /// A region that reaches down to the real axis of λ, of a system in which something has a loss factor: that describes motions with `Im λ > 0`
    /// alone.
    LossFactor {
        /// The lower end of the region [rad/s].
        im: f64,
    },
    /// A region that comes near a λ at which the stiffness of a member of Kelvin and Voigt vanishes: infinitely many eigenvalues accumulate
    /// there. Fewer than were asked for are nearer to zero.
    Accumulation {
        /// Start of the part of the real axis from which searches have to keep away [1/s].
        from: f64,
        /// Its end [1/s].
        to: f64,
    },
    /// There are more results than the caller's capacity; none is returned rather than a part of them.
    Capacity {
        /// The capacity.
        capacity: usize,
    },
}

impl fmt::Display for SearchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SearchError::Range { start, end } => {
                write!(f, "the search range from {start} to {end} must run upwards and be of finite length")
            }
            SearchError::Grid { points, limit } => {
                write!(f, "a grid of {points} points was asked for; it needs at least 3 and at most {limit}")
            }
            SearchError::Tolerance { tolerance } => {
                write!(f, "the tolerance {tolerance} must be positive and finite")
            }
            SearchError::NotANumber { x, y } => {
                write!(f, "the function is not a number at ({x:e}, {y:e}); where it overflows, search a smaller range")
            }
            SearchError::Zero { points, at } => {
                write!(f, "the function is zero at all {points} points that were tried, far from each other: ")?;
                write!(f, "something is held twice, or a massless part by nothing")?;
                at.map_or(Ok(()), |spot| write!(f, ", as shows at {spot}"))
            }
            SearchError::StillMoving { x, y, moves } => {
                write!(f, "the search for a minimum was given up at ({x}, {y}), still moving after {moves} moves")
            }
            SearchError::TooFewRoots { found } => {
                write!(
                    f,
                    "the system has no more than {found} of the roots asked for; of each pair of eigenvalues one counts"
                )
            }
            SearchError::Effort { evaluations, found } => {
                write!(f, "the search was given up after {evaluations} evaluations, with {found} eigenvalues found; ")?;
                write!(f, "search a smaller region, or one whose edges keep away from eigenvalues")
            }
            SearchError::Unresolved { near } => {
                write!(f, "what is near {near} cannot be certified: too few digits are left there after rounding")
            }
            SearchError::Unstable { modes } => {
                let grow = if modes == 1 { "motion grows" } else { "motions grow" };
                write!(f, "the system is statically unstable: {modes} {grow} instead of vibrating; ")?;
                write!(f, "their rates are real eigenvalues, which `eigenvalues` finds")
            }
            SearchError::LossFactor { im } => {
                write!(
                    f,
                    "the region reaches down to Im λ = {im}, but a loss factor describes motions with Im λ > 0 alone: "
                )?;
                write!(f, "let it begin above zero")
            }
            SearchError::Accumulation { from, to } => {
                write!(
                    f,
                    "eigenvalues accumulate between λ = {from} and {to}, where the stiffness of a member of Kelvin and "
                )?;
                write!(f, "Voigt vanishes: search regions that keep away from there")
            }
            SearchError::Capacity { capacity } => {
                write!(f, "there are more results than the capacity of {capacity}; ask for a larger one")
            }
        }
    }
}

impl core::error::Error for SearchError {}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn message_names_element_parameter_and_value() {
        let error = Requirement::Positive.check("length", -2.0).unwrap_err().of("beam 1");
        assert_eq!(error.to_string(), "beam 1: length is -2, but must be positive and finite");
    }

    #[test]
    fn a_range_too_long_for_its_type_is_told_so() {
        let message = SearchError::Range { start: -1.5e308, end: 1.5e308 }.to_string();
        assert!(message.contains("finite length"), "{message}");
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
