//! What a search cannot do, and where.

use crate::model::plain::error;
use core::fmt;

/// What a point or a member of a network is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// The node of an index, of a network that is a list.
    Node(usize),
    /// The member of an index, of a network that is a list, or of a frame.
    Member(usize),
    /// The point of an index, of a frame.
    Point(usize),
    /// The step of an index, of a tree that is a list.
    Step(usize),
    /// What has a name.
    Named(&'static str),
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Spot::Node(node) => write!(f, "node {node}"),
            Spot::Member(member) => write!(f, "member {member}"),
            Spot::Point(point) => write!(f, "point {point}"),
            Spot::Step(step) => write!(f, "step {step}"),
            Spot::Named(name) => write!(f, "{name}"),
        }
    }
}

/// A search that cannot start or cannot return all it found.
#[derive(Clone, Copy, PartialEq)]
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
        /// How many it has; of each pair of eigenvalues one counts.
        found: u64,
        /// How many were asked for.
        wanted: u64,
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
    /// A count is not proven in the largest precision: rounding decides it, as next to a root. Both bounds are proven.
    Unproven {
        /// The frequency.
        near: f64,
        /// At most so many frequencies are below; `u64::MAX` where nothing is known.
        at_most: u64,
        /// At least so many are.
        at_least: u64,
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
    /// A region that reaches down to the real axis of λ, of a whirl of a rotor: below are the eigenvalues of the other whirl.
    OtherWhirl {
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

impl SearchError {
    /// The name of its kind, for tables.
    #[doc(hidden)]
    pub fn kind(&self) -> &'static str {
        match self {
            SearchError::Range { .. } => "Range",
            SearchError::Grid { .. } => "Grid",
            SearchError::Tolerance { .. } => "Tolerance",
            SearchError::NotANumber { .. } => "NotANumber",
            SearchError::Zero { .. } => "Zero",
            SearchError::StillMoving { .. } => "StillMoving",
            SearchError::TooFewRoots { .. } => "TooFewRoots",
            SearchError::Effort { .. } => "Effort",
            SearchError::Unresolved { .. } => "Unresolved",
            SearchError::Unproven { .. } => "Unproven",
            SearchError::Unstable { .. } => "Unstable",
            SearchError::LossFactor { .. } => "LossFactor",
            SearchError::OtherWhirl { .. } => "OtherWhirl",
            SearchError::Accumulation { .. } => "Accumulation",
            SearchError::Capacity { .. } => "Capacity",
        }
    }
}

impl fmt::Display for SearchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SearchError::Range { start, end } => {
                write!(f, "the range from {start} to {end} must run upwards, frequencies from 0 on, and be finite")
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
            SearchError::TooFewRoots { found, wanted } => {
                let frequencies = if found == 1 { "frequency" } else { "frequencies" };
                write!(f, "the system has {found} {frequencies}, {wanted} were asked for; ")?;
                write!(f, "of each pair of eigenvalues one counts")
            }
            SearchError::Effort { evaluations, found } => {
                write!(f, "the search was given up after {evaluations} evaluations, with {found} eigenvalues found; ")?;
                write!(f, "search a smaller region, or one whose edges keep away from eigenvalues")
            }
            SearchError::Unresolved { near } => {
                write!(f, "what is near {near} cannot be certified: too few digits are left there after rounding")
            }
            SearchError::Unproven { near, at_most, at_least } => unproven(f, near, [at_least, at_most]),
            SearchError::Unstable { modes } => {
                let grow = if modes == 1 { "motion grows" } else { "motions grow" };
                write!(f, "the system is statically unstable: {modes} {grow} instead of vibrating; ")?;
                write!(f, "their rates are real eigenvalues, which `eigenvalues` finds")
            }
            SearchError::LossFactor { im } => {
                write!(f, "the region reaches down to Im λ = {im}: let it begin above zero, ")?;
                write!(f, "since a loss factor describes motions with Im λ > 0 alone")
            }
            SearchError::OtherWhirl { im } => {
                write!(f, "the region reaches down to Im λ = {im}: below zero are the eigenvalues of the other whirl")
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

error! { SearchError }

/// What is proven of a count that rounding decides.
fn unproven(f: &mut fmt::Formatter<'_>, near: f64, bounds: [u64; 2]) -> fmt::Result {
    let [at_least, at_most] = bounds;
    if at_most == u64::MAX {
        return write!(f, "nothing is proven near {near}, but that at least {at_least} frequencies are below");
    }
    write!(f, "rounding decides the count near {near}: at least {at_least} and at most {at_most} frequencies are below")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn a_range_too_long_for_its_type_is_told_so() {
        let message = SearchError::Range { start: -1.5e308, end: 1.5e308 }.to_string();
        assert!(message.ends_with("and be finite"), "{message}");
    }
}
