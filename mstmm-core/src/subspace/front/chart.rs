//! Charts of members: their relations between both ends as an element gives them.

use crate::number::{Scalar, Scaled, Size};
use crate::subspace::front::matrix::{Measure, Variable};
use crate::subspace::front::units::Units;
use mstmm_plan::Freedoms;

/// Most freedoms of an end.
pub const MOST_FREEDOMS: usize = Freedoms::SINGLE.len();

/// Most variables of a member.
pub const MOST_VARIABLES: usize = 2 * MOST_FREEDOMS;

/// A member as a symmetric matrix over displacements and forces of both ends, in its own axes and units.
///
/// The variables are the freedoms of the input end and then those of the output end, each a displacement or its force. A kind for each is
/// chosen with which all entries are bounded.
#[derive(Clone, Copy, Debug)]
pub struct Chart<S: Scalar> {
    /// The freedoms of an end, in the axes of the member.
    pub freedoms: Freedoms,
    /// The matrix; the rows of the variables that there are come first.
    pub entries: [[S; MOST_VARIABLES]; MOST_VARIABLES],
    /// A bit per variable: whether it is a force.
    pub forces: u32,
    /// Logarithms to base 2 of the units of displacements and of rotations.
    pub(crate) units: Units,
    /// What the units come from.
    pub(crate) measure: Measure,
    /// The minor of the subspace for these variables, without units: an entire function.
    pub product: Scaled<S>,
    /// Natural frequencies of the member with its displacement variables held and its force variables free, less the number of forces.
    pub below: S::Size,
}

impl<S: Scalar> Chart<S> {
    /// A chart of displacements without entries.
    pub(crate) fn empty(freedoms: Freedoms, units: Units, measure: Measure) -> Self {
        Chart {
            freedoms,
            entries: [[S::zero(); MOST_VARIABLES]; MOST_VARIABLES],
            forces: 0,
            units,
            measure,
            product: Scaled::new(S::one(), 0),
            below: S::Size::of(0.0),
        }
    }

    /// The variable at a place, of a freedom of one of the ends.
    #[inline]
    pub(crate) fn variable(&self, place: usize, end: usize, freedom: usize) -> Variable {
        let is_rotation = freedom + 1 == MOST_FREEDOMS;
        Variable {
            label: end * MOST_FREEDOMS + freedom,
            is_force: self.forces >> place & 1 == 1,
            is_rotation,
            unit: self.units.of(is_rotation),
            measure: self.measure,
        }
    }
}
