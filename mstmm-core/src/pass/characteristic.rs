//! The interface of built systems to the searches: Δ by the plane method, with a counter.

use crate::element::MemberNumbers;
use crate::model::{FrequencyEstimates, Spot};
use crate::number::{Real, Scalar, Scaled};
use crate::pass::network::stiffness::StiffnessModel;
use crate::proof::visit::Visitor;
use crate::subspace::{NoCount, RootCounter};
use mstmm_plan::Space;

/// A built system with parameters of type `Self::Parameter`.
pub trait System {
    /// Scalar of the parameters.
    type Parameter: Real;

    /// Whether a whole pass stands in line, as the lanes of vectors need it; other systems are evaluated at one frequency at a time.
    #[doc(hidden)]
    const STANDS_IN_LINE: bool = false;

    /// Whether a pass reports a phase, from which a search for all roots of a window starts.
    #[doc(hidden)]
    const HAS_PHASES: bool = true;

    /// Whether it is a network, which searches evaluate by its stiffnesses where they can.
    #[doc(hidden)]
    const IS_NETWORK: bool = false;

    /// Whether something spins: its gyroscopic moments take part in modal masses, and modes of both whirls in sums over modes.
    #[doc(hidden)]
    const SPINS: bool = false;

    /// Whether some element may have a negative stiffness at rest: then searches ask first whether the system is stable.
    #[doc(hidden)]
    const MAY_BUCKLE: bool = false;

    /// Whether such an element is there, where the program decides which are.
    #[doc(hidden)]
    #[inline]
    fn may_buckle(&self) -> bool {
        Self::MAY_BUCKLE
    }

    /// The system in numbers, if it is a network all of whose members are known in numbers.
    #[doc(hidden)]
    #[inline]
    fn in_numbers(&self) -> Option<StiffnessModel<'_>> {
        None
    }

    /// Names its parts one after the other, for the proof of natural frequencies.
    #[doc(hidden)]
    fn name_parts(&self, visitor: &mut dyn Visitor) {
        // nothing is known of a system that names nothing
        visitor.element(0, 0, Space::NONE, &MemberNumbers::Other);
    }

    /// Whether all that it names moves in one plane.
    #[doc(hidden)]
    fn is_flat(&self) -> bool {
        true
    }

    /// What a node or a step of it is called: `beam 1`, `conn 2`, `fixed`; of a list its index.
    #[doc(hidden)]
    fn spot_of(&self, place: usize) -> Spot {
        Spot::Step(place)
    }

    /// What errors call a member between points.
    #[doc(hidden)]
    fn spot_of_member(&self, member: usize) -> Spot {
        Spot::Member(member)
    }

    /// Estimates from which the searches take their first steps.
    #[doc(hidden)]
    fn frequency_estimates(&self) -> FrequencyEstimates;
}

/// A system that the plane method can evaluate at a frequency `x`: ω for a real scalar (undamped systems only), λ for a
/// complex one.
pub trait Characteristic<S: Scalar> {
    /// Δ by the plane method, in one pass with a counter.
    #[doc(hidden)]
    fn pass<C: RootCounter<S>>(&self, x: S, counter: &mut C) -> Scaled<S>;

    /// Δ by the plane method: exact at every frequency, without poles, with mantissa and exponent.
    ///
    /// It equals `overall_determinant` times a constant that does not depend on the frequency. It is zero at the eigenvalues and
    /// nowhere else. No matrix is formed.
    #[inline]
    fn characteristic(&self, x: S) -> Scaled<S> {
        counted_pass(self, x, NoCount).1
    }
}

/// The counter after a pass, and Δ: a call, since a pass stands in line.
#[inline(never)]
pub(crate) fn counted_pass<C: RootCounter<S>, Y, S: Scalar>(system: &Y, x: S, mut counter: C) -> (C, Scaled<S>)
where
    Y: Characteristic<S> + ?Sized,
{
    let value = system.pass(x, &mut counter);
    (counter, value)
}
