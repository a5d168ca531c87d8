//! Charts: what an element is in a front.

use crate::element::member_motion::VisitMember;
use crate::element::member_numbers::MemberNumbers;
use crate::element::traits::{Element, space_of};
use crate::model::{FrequencyEstimates, InvalidParameter};
use crate::number::{FrequencyPowers, Real, Scalar};
use crate::subspace::Chart;
use core::fmt::Debug;
use mstmm_plan::{Freedoms, Space};

/// The freedom that the ends of a translation or rotation element have in the axes of a member: along it or about z.
pub(crate) fn along_member<E: Element>() -> Freedoms {
    if space_of::<E>().is(Space::Translation) { Freedoms::X } else { Freedoms::RZ }
}

/// An element as a member of a network.
///
/// A chart is the relation of displacements and forces at both ends, written for such variables that all entries are bounded. Along a
/// translation path the displacement is the one along the member.
pub trait Charted<S: Scalar>: Element {
    /// The chart at a frequency, of a member of a length.
    fn chart(built: &Self::Built, at: &FrequencyPowers<S>, length: S) -> Chart<S>;
}

/// What stands between two points of a network whose size the program decides.
pub trait MemberElement: Copy + Debug {
    /// Scalar of the parameters.
    type Parameter: Real;

    /// The element with its quantities that do not depend on the frequency.
    type Built: Copy + Debug;

    /// Whether some member of this type may have a negative stiffness at rest.
    const MAY_BUCKLE: bool = false;

    /// Whether this member may.
    fn may_buckle(_built: &Self::Built) -> bool {
        Self::MAY_BUCKLE
    }

    /// The element between two points that are so far apart.
    ///
    /// # Errors
    /// [`InvalidParameter`] names the first parameter out of its range, with its value.
    fn build(self, length: Self::Parameter) -> Result<Self::Built, InvalidParameter>;

    /// Its name in messages.
    fn name(&self) -> &'static str;

    /// The freedoms of its ends, in its own axes: X is along it.
    fn freedoms(&self) -> Freedoms;

    /// Whether it stands at one place, with the axes of the plane where it has no direction; else it spans two places.
    fn is_joint(&self) -> bool;

    /// Adds the element's stiffnesses and masses to the estimates from which searches take their first steps.
    fn estimate(built: &Self::Built, estimates: &mut FrequencyEstimates);

    /// The numbers from which its dynamic stiffness follows.
    fn member_numbers(_built: &Self::Built) -> MemberNumbers {
        MemberNumbers::Other
    }
}

/// A member at a frequency of type `S`.
pub trait MemberChart<S: Scalar>: MemberElement {
    /// Its chart.
    fn chart(built: &Self::Built, at: &FrequencyPowers<S>, length: S) -> Chart<S>;
}

/// A member that says how it moves at a frequency of type `S`.
pub trait MemberVisit<S: Scalar>: MemberElement {
    /// What a visitor makes of it.
    fn visit<V: VisitMember<S>>(built: &Self::Built, visitor: V) -> V::Output;
}
