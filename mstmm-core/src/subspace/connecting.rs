//! What a representation of subspaces does at supports, at connections and at the root.

use crate::number::{Scalar, Scaled};
use crate::subspace::count::RootCounter;
use mstmm_plan::{Space, Support};

/// A subspace of states that starts at a support, meets others at connections and ends in the root.
pub trait Connecting<S: Scalar>: Copy {
    /// What a support leaves of the states of a space.
    fn of_support(support: Support, space: Space) -> Self;

    /// The support, if nothing has come behind it yet.
    fn support(&self) -> Option<Support>;

    /// The subspace with its entries shifted into the middle of the range. Joins multiply entries without a shift, so that between
    /// two joins, also at successive connections, the entries have to be shifted.
    #[must_use]
    fn rescaled(self) -> Self;

    /// Joins another path: displacements are equal, forces add up. Neither of the two is a support.
    #[must_use]
    fn joined<C: RootCounter<S>>(self, other: Self, counter: &mut C) -> Self;

    /// Joins the free states of a connection whose output is wider, before supports hold the point.
    #[must_use]
    fn widened(self, output: Option<Space>) -> Self;

    /// Holds the point by a support.
    #[must_use]
    fn held(self, support: Support) -> Self;

    /// Restricts the subspace to a narrower output: forces that the output does not carry are zero.
    #[must_use]
    fn narrowed<C: RootCounter<S>>(self, output: Option<Space>, counter: &mut C) -> Self;

    /// Δ: vanishes where the subspace meets the boundary condition of the root.
    fn at_root<C: RootCounter<S>>(self, support: Support, counter: &mut C) -> Scaled<S>;
}

/// The connection of several inputs, supports among them, to an output in the space `output`; `None` at the root.
///
/// Paths are joined first; if the output is wider, they are joined to its free state. Then supports hold the point; if
/// the output is narrower, forces that it does not carry are zero.
#[inline]
pub(crate) fn connection<S: Scalar, P: Connecting<S>, C: RootCounter<S>>(
    inputs: impl Iterator<Item = P> + Clone,
    output: Option<Space>,
    counter: &mut C,
) -> P {
    let mut paths = inputs.clone().filter(|input| input.support().is_none()).map(P::rescaled);
    let first = paths.next();
    let pair = first.map(|first| paths.next().map_or(first, |second| first.joined(second, counter)));
    let sum = pair.map(|pair| paths.fold(pair, |sum, path| sum.rescaled().joined(path, counter)));
    // supports alone hold the output
    let alone = P::of_support(Support::Free, output.unwrap_or(Space::Bending));
    let mut sum = sum.map_or(alone, |sum| sum.widened(output));
    for support in inputs.filter_map(|input| input.support()) {
        sum = sum.held(support);
    }
    sum.narrowed(output, counter)
}
