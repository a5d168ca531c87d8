//! Charts: what an element is in a plane structure.

use crate::element::member_motion::VisitMember;
use crate::element::member_numbers::MemberNumbers;
use crate::element::traits::{Element, space_of};
use crate::model::{FrequencyEstimates, InvalidParameter};
use crate::number::{FrequencyPowers, Real, Scalar};
use crate::structure::Chart;
use core::fmt::Debug;
use mstmm_plan::{Freedoms, Space, refuse_if};
use num_complex::Complex;

/// The freedom that the ends of a translation or rotation element have in the axes of a member: along it or about z.
pub(crate) const fn along_member<E: Element>() -> Freedoms {
    if space_of::<E>().is(Space::Translation) { Freedoms::X } else { Freedoms::RZ }
}

/// The freedoms that a translation or rotation element brings to a point, of those that the dimension has, where it has any direction.
#[doc(hidden)]
pub const fn brought<E: Element>() -> Freedoms {
    let along = along_member::<E>();
    if along.is(Freedoms::X) {
        Freedoms::X.union(Freedoms::Y).union(Freedoms::Z)
    } else if along.is(Freedoms::RZ) {
        Freedoms::RX.union(Freedoms::RY).union(Freedoms::RZ)
    } else {
        along
    }
}

/// Fails where an element of the user's own that stands in a path between places has more than one motion.
#[doc(hidden)]
#[track_caller]
pub const fn one_motion<E: Element>() {
    refuse_if(
        space_of::<E>().count() != 1,
        "between places stand elements of one motion, with the state `Translation` or `Rotation`: this one has another state, so it stands in \
         models without places",
    );
}

/// Asks rustc for the chart of an element of the user's own, at the numbers that all elements have one for: complex λ.
#[doc(hidden)]
pub const fn has_chart<E: Charted<Complex<f64>>>() {}

/// An element as a member of a network: between points with places, and in a list.
///
/// A chart is the relation of displacements and forces at both ends, written for such variables that all entries are bounded. Along a
/// translation path the displacement is the one along the member. [`Chart::translation`] and [`Chart::rotation`] make it of the transfer matrix
/// of an element of one motion, [`Chart::spring`] and [`Chart::torsion_spring`] of a dynamic stiffness between both ends.
///
/// ```
/// use mstmm_core::{Chart, Charted, Element, Frequency, FrequencyPowers, InvalidParameter, Parameter, Translation};
///
/// /// A pad that grows stiffer with the frequency, `κ = K + g ω²`.
/// #[derive(Clone, Copy, Debug)]
/// struct Pad<T> { stiffness: T, growth: T }
///
/// impl<T: Parameter> Element for Pad<T> {
///     type State = Translation;
///     type Built = Self;
///
///     fn build(self) -> Result<Self, InvalidParameter> {
///         Ok(self)
///     }
/// }
///
/// impl<T: Parameter, S: Frequency<T>> Charted<S> for Pad<T> {
///     fn chart(pad: &Self, at: &FrequencyPowers<S>, _length: S) -> Chart<S> {
///         Chart::spring(S::from_parameter(pad.stiffness) - at.lambda_squared * pad.growth)
///     }
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not stand between points with places: it has no chart",
    label = "no `Charted<{S}>` for this element",
    note = "an element of your own implements `mstmm::element::Charted<S>` for every `S: mstmm::number::Frequency<T>`: `Chart::translation` and \
            `Chart::rotation` make a chart of its transfer matrix, `Chart::spring` and `Chart::torsion_spring` of a dynamic stiffness"
)]
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

    /// Whether some member of this type may spin.
    const SPINS: bool = false;

    /// Whether this member may buckle.
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

    /// The member under a further axial force \[N\], tension positive: the sum of two words. None where it bears none.
    ///
    /// # Errors
    /// [`InvalidParameter`] where both forces together are out of the range of the parameter.
    fn under_axial_force(_built: Self::Built, _force: [f64; 2]) -> Result<Option<Self::Built>, InvalidParameter> {
        Ok(None)
    }

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
