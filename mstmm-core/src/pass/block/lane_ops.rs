//! Operations on the subspace of a lane, each written once for branch-free numbers and for a lane that is evaluated alone.

use crate::element::{Element, PlaneStep};
use crate::model::StateSpace;
use crate::number::{BranchFree, Branches, InColumns, Scalar};
use crate::pass::block::counters::Unwrapped;
use crate::pass::block::frequencies::Frequencies;
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::{BENDING, BranchFreeOp, KINDS, LINE, LaneOp, PLANE, ROTATION, TRANSLATION, TURN};
use crate::subspace::{Connecting, NoCount, Plane, RootCounter, Subspace, Watch};
use mstmm_plan::{Space, Support};

/// The step of an element.
pub(crate) struct Through<'a, E: Element, S: InColumns> {
    pub(crate) built: &'a E::Built,
    pub(crate) at: &'a Frequencies<S>,
}

impl<S, C, E> LaneOp<S, C> for Through<'_, E, S>
where
    S: InColumns,
    C: RootCounter<S>,
    E: PlaneStep<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>>,
{
    const HAS_SERIES: bool = <E as PlaneStep<S>>::WAVES;

    fn branches(&self) -> Branches {
        E::branches(self.built, &self.at.lane(0, |number| number))
    }

    const SUITS: u32 = match E::State::SPACE {
        Space::Bending => BENDING,
        Space::Translation => TRANSLATION,
        _ => ROTATION,
    };

    #[inline(always)]
    fn fallback(&self, lane: usize, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        E::step(&E::coefficients(self.built, &self.at.lane(lane, |number| number)), input, counter)
    }
}

impl<S, C, E, const SERIES: bool> BranchFreeOp<S, C, SERIES> for Through<'_, E, S>
where
    S: InColumns,
    C: RootCounter<S>,
    E: PlaneStep<BranchFree<S, SERIES>>,
{
    #[inline(always)]
    fn straight(
        &self,
        lane: usize,
        input: Subspace<BranchFree<S, SERIES>>,
        counter: &mut C,
    ) -> Subspace<BranchFree<S, SERIES>> {
        E::step(&E::coefficients(self.built, &self.at.lane(lane, BranchFree)), input, &mut Unwrapped(counter))
    }
}

impl<E: Element, S: InColumns> Clone for Through<'_, E, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<E: Element, S: InColumns> Copy for Through<'_, E, S> {}

/// The join with another path, of the kind with a number in [`KINDS`].
#[derive(Clone, Copy)]
pub(crate) struct Join<'a, S: InColumns, const OTHER: usize>(pub(super) &'a Lanes<S>);

impl<S: InColumns, const OTHER: usize> LaneOp<S, NoCount> for Join<'_, S, OTHER> {
    const SUITS: u32 = 1 << PLANE;

    fn branches(&self) -> Branches {
        if self.0.is_fit { Branches::Waves } else { Branches::All }
    }

    #[inline(always)]
    fn fallback(&self, lane: usize, input: Subspace<S>, _: &mut NoCount) -> Subspace<S> {
        joined_fallback(input, self.0.lane(lane))
    }
}

impl<S: InColumns, const OTHER: usize, const SERIES: bool> BranchFreeOp<S, NoCount, SERIES> for Join<'_, S, OTHER> {
    #[inline(always)]
    fn other_exponent(&self, lane: usize) -> i32 {
        self.0.exponents[lane]
    }

    #[inline(always)]
    fn straight(
        &self,
        lane: usize,
        input: Subspace<BranchFree<S, SERIES>>,
        _: &mut NoCount,
    ) -> Subspace<BranchFree<S, SERIES>> {
        input.rescaled().joined(self.0.known(KINDS[OTHER], lane, BranchFree).rescaled(), &mut NoCount)
    }
}

/// The join of two paths in a lane that is evaluated alone. A sum that cancels is NaN, since no counter is told of it; the whole
/// frequency is then evaluated outside of the block.
pub(crate) fn joined_fallback<S: Scalar>(input: Subspace<S>, other: Subspace<S>) -> Subspace<S> {
    let mut watch = Watch::default();
    let sum = input.rescaled().joined(other.rescaled(), &mut watch);
    if watch.cancelled.any() { Subspace::Plane(Plane::unscaled([S::zero().or_nan(false); 5], 0)) } else { sum }
}

/// Declares an operation on one subspace by its name, its field, the kinds worth a loop, and a function that is generic over
/// scalars.
macro_rules! act_by {
    ($(#[$doc:meta])* $name:ident($field:ty), $suits:expr, |$own:ident, $input:ident, $counter:ident| $result:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub(crate) struct $name(pub(super) $field);

        impl<S: InColumns, C: RootCounter<S>> LaneOp<S, C> for $name {
            const SUITS: u32 = $suits;

            #[inline(always)]
            fn fallback(&self, _: usize, $input: Subspace<S>, $counter: &mut C) -> Subspace<S> {
                let $own = self.0;
                $result
            }
        }

        impl<S: InColumns, C: RootCounter<S>, const SERIES: bool> BranchFreeOp<S, C, SERIES> for $name {
            #[inline(always)]
            fn straight(
                &self,
                _: usize,
                $input: Subspace<BranchFree<S, SERIES>>,
                counter: &mut C,
            ) -> Subspace<BranchFree<S, SERIES>> {
                let ($own, $counter) = (self.0, &mut Unwrapped(counter));
                $result
            }
        }
    };
}

act_by!(
    /// The join to the free state of an output that is wider than the paths.
    Widen(Option<Space>), 0, |output, input, _counter| input.widened(output)
);
act_by!(
    /// The restriction to an output that is narrower than the paths.
    Narrow(Option<Space>), 0b11 << PLANE,
    |output, input, counter| input.narrowed(output, counter)
);

act_by!(
    /// The only path of a connection, as an ordinary subspace in the range of joins.
    Rescale(()), 0b11 << PLANE | 1 << LINE | 1 << TURN, |_own, input, _counter| input.rescaled()
);

/// Supports as constants of [`Hold`] and of the root: their places in [`Support::ALL`].
pub(crate) const FIXED: usize = Support::Fixed as usize;
pub(crate) const PINNED: usize = Support::Pinned as usize;
pub(crate) const GUIDED: usize = Support::Guided as usize;
pub(crate) const FREE: usize = Support::Free as usize;

/// The support that holds the point; it is known to the compiler, since the order of minors depends on it.
#[derive(Clone, Copy)]
pub(crate) struct Hold<const SUPPORT: usize>;

impl<S: InColumns, const SUPPORT: usize> LaneOp<S, NoCount> for Hold<SUPPORT> {
    const SUITS: u32 = 1 << PLANE;

    #[inline(always)]
    fn fallback(&self, _: usize, input: Subspace<S>, _: &mut NoCount) -> Subspace<S> {
        input.held(Support::ALL[SUPPORT])
    }
}

impl<S: InColumns, const SUPPORT: usize, const SERIES: bool> BranchFreeOp<S, NoCount, SERIES> for Hold<SUPPORT> {
    #[inline(always)]
    fn straight(
        &self,
        _: usize,
        input: Subspace<BranchFree<S, SERIES>>,
        _: &mut NoCount,
    ) -> Subspace<BranchFree<S, SERIES>> {
        input.held(Support::ALL[SUPPORT])
    }
}
