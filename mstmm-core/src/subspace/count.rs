//! The count of natural frequencies below a frequency, in the same pass as Δ (Wittrick and Williams along a tree).
//!
//! The steps of the plane method tell a counter what happens; [`NoCount`] ignores it at no cost, [`WittrickWilliams`] applies the
//! rules. Each rule adds the negative eigenvalues of the stiffness that a step eliminates. A support is the limit of a
//! stiff spring, hence the rules for exact zeros.

use crate::number::{Real, Scalar, is_ill_conditioned};
use crate::subspace::minors::line::Line;
use crate::subspace::minors::plane::Plane;
use mstmm_plan::{Space, Support};

/// A bending element with both its ends held: its clamped count, and the stiffness and sign for the rule of a plane.
#[derive(Clone, Copy, Debug)]
pub struct Held<S> {
    /// Number of its own frequencies below this one.
    pub below: u64,
    /// Whether the factor by which its step has multiplied the minors is negative.
    pub is_negative: bool,
    /// Its stiffness against deflection of the input end.
    pub stiffness: S,
}

/// A counter of natural frequencies, to which the steps of the plane method report.
pub trait RootCounter<S: Scalar> {
    /// Whether the counter counts; else a step may leave out computations for it.
    const COUNTS: bool;
    /// Whether sums that cancel are watched.
    const WATCHES: bool = Self::COUNTS;
    /// An element took a line from `before` to `after`; held at both ends it has `held` frequencies below this one, and its step
    /// has multiplied the line by a number that `is_negative`.
    #[inline(always)]
    fn line(&mut self, _before: &Line<S>, _after: &Line<S>, _held: u64, _is_negative: bool) {}
    /// An element took a plane from `before` to `after`.
    #[inline(always)]
    fn plane(&mut self, _before: &Plane<S>, _after: &Plane<S>, _held: Held<S>) {}
    /// A plane goes on as a line of `space`.
    #[inline(always)]
    fn narrowing(&mut self, _plane: &Plane<S>, _space: Space) {}
    /// A plane ends in the root.
    #[inline(always)]
    fn plane_root(&mut self, _plane: &Plane<S>, _support: Support) {}
    /// A line ends in the root.
    #[inline(always)]
    fn line_root(&mut self, _line: &Line<S>, _support: Support) {}

    /// A sum lost more digits to cancellation than a certificate has room for, or all of them: then it was taken for zero.
    #[inline(always)]
    fn cancelled(&mut self, _completely: bool) {}
    /// Whether the frequency is so close to a root that the terms of Δ are examined.
    #[inline(always)]
    fn looks_at_root(&self) -> bool {
        false
    }
    /// The size of Δ is `sum`, and the sizes of its terms add up to `terms`.
    #[inline(always)]
    fn root_sum(&mut self, _sum: f64, _terms: f64) {}
}

/// The counter that ignores all reports, for Δ alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoCount;

impl<S: Scalar> RootCounter<S> for NoCount {
    const COUNTS: bool = false;
}

/// The sums that cancelled in a pass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cancelled {
    /// Sums lost more digits than a certificate has room for.
    pub(crate) partly: bool,
    /// Sums lost all digits.
    pub(crate) completely: bool,
    /// Δ lost more digits than near a well-conditioned root.
    pub(crate) at_root: bool,
}

impl Cancelled {
    #[inline(always)]
    fn add(&mut self, completely: bool) {
        self.completely |= completely;
        self.partly |= !completely;
    }

    #[inline(always)]
    fn add_root<S: Scalar>(&mut self, sum: f64, terms: f64) {
        self.at_root |= is_ill_conditioned::<S>(sum, terms);
    }

    /// Whether the pass is doubtful.
    #[inline]
    pub(crate) fn any(self) -> bool {
        self.partly || self.completely
    }
}

/// The counter that watches sums that cancel, and counts nothing.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Watch {
    pub(crate) cancelled: Cancelled,
}

impl<S: Scalar> RootCounter<S> for Watch {
    const COUNTS: bool = false;
    const WATCHES: bool = true;
    #[inline(always)]
    fn cancelled(&mut self, completely: bool) {
        self.cancelled.add(completely);
    }
}

/// The number of natural frequencies below the frequency of a pass, by the algorithm of Wittrick and Williams.
///
/// `IN_LINE` counts without branches, as a block of frequencies needs it; a single frequency is faster with branches. `WATCHES` is
/// false for passes at frequencies where another pass watches sums that cancel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WittrickWilliams<const IN_LINE: bool = false, const WATCHES: bool = true> {
    below: u64,
    cancelled: Cancelled,
    is_at_root: bool,
}

impl<const IN_LINE: bool, const WATCHES: bool> WittrickWilliams<IN_LINE, WATCHES> {
    /// The count so far; of all frequencies once the pass has reached the root.
    #[inline]
    pub fn below(&self) -> u64 {
        self.below
    }

    /// A counter; `is_at_root` tells that the frequency is close to a root.
    #[inline]
    pub(crate) fn new(is_at_root: bool) -> Self {
        WittrickWilliams { is_at_root, ..WittrickWilliams::default() }
    }

    /// The sums that cancelled in the pass.
    #[inline]
    pub(crate) fn cancelled(&self) -> Cancelled {
        self.cancelled
    }

    #[inline]
    fn add_if(&mut self, condition: bool) {
        self.below = self.below.saturating_add(u64::from(condition));
    }

    /// Adds the negative eigenvalues of a symmetric 2×2 matrix from the sign of its determinant and its first entry.
    #[inline]
    fn negative_eigenvalues(&mut self, determinant_negative: bool, first_positive: bool) {
        self.below = self.below.saturating_add(match (determinant_negative, first_positive) {
            (true, _) => 1,
            (false, true) => 0,
            (false, false) => 2,
        });
    }
}

/// Sign of the first number that is not zero: whether it is negative.
#[inline]
fn negative<T: Real>(candidates: impl IntoIterator<Item = T>) -> bool {
    candidates.into_iter().find(|x| !x.is_zero()).is_some_and(|x| x < T::zero())
}

/// Sign of the first number that is not zero, without branches.
#[inline(always)]
fn negative_in_line<T: Real, const N: usize>(candidates: [T; N]) -> bool {
    candidates.into_iter().rev().fold(T::zero(), |next, x| if x.is_zero() { next } else { x }) < T::zero()
}

/// Sign of p_YΘ, of the limit of stiff springs where it is zero.
#[inline]
fn plane_negative<T: Real>(p: &Plane<T>) -> bool {
    negative([p.y_theta, p.theta_q, p.y_m, p.m_q])
}

/// Whether the stiffness p_ΘQ/p_YΘ against deflection, with another beside it, is positive, as that of stiff springs where p_YΘ
/// is zero. By signs, not by a quotient: it may underflow, and takes its time.
#[inline(always)]
fn is_stiff<T: Real>(p: &Plane<T>, beside: T) -> bool {
    let (y_theta, force, zero) = (p.y_theta, p.theta_q + beside * p.y_theta, T::zero());
    y_theta.is_zero() | ((force > zero) & (y_theta > zero)) | ((force < zero) & (y_theta < zero))
}

/// Sign of y, of the limit of a stiff spring where it is zero.
#[inline]
fn line_negative<T: Real>(line: &Line<T>) -> bool {
    negative([line.y, -line.q])
}

impl<T: Real, const IN_LINE: bool, const WATCHES: bool> RootCounter<T> for WittrickWilliams<IN_LINE, WATCHES> {
    const COUNTS: bool = true;
    // extended precision always watches: it takes other formulas where sums cancel
    const WATCHES: bool = WATCHES || T::EPSILON < f64::EPSILON;

    #[inline]
    fn line(&mut self, before: &Line<T>, after: &Line<T>, held: u64, is_negative: bool) {
        self.below = self.below.saturating_add(held);
        self.add_if(line_negative(before) != (line_negative(after) != is_negative));
    }

    #[inline]
    fn plane(&mut self, before: &Plane<T>, after: &Plane<T>, held: Held<T>) {
        let Held { below, is_negative, stiffness } = held;
        self.below = self.below.saturating_add(below);
        let determinant_negative = plane_negative(before) != (plane_negative(after) != is_negative);
        self.negative_eigenvalues(determinant_negative, is_stiff(before, stiffness));
    }

    #[inline]
    fn narrowing(&mut self, plane: &Plane<T>, space: Space) {
        let left_behind = plane.minor(Space::Bending.without(space));
        self.add_if(negative([left_behind, plane.m_q]) != plane_negative(plane));
    }

    #[inline]
    fn plane_root(&mut self, plane: &Plane<T>, support: Support) {
        let differs = |x: T| !x.is_zero() && (x < T::zero()) != plane_negative(plane);
        match support {
            Support::Fixed => {}
            Support::Pinned | Support::Guided | Support::Roller => self.add_if(differs(plane.minor_at(support))),
            Support::Free if IN_LINE => {
                let Plane { y_theta, y_m, theta_q, m_q, .. } = *plane;
                let zero = T::zero();
                let is_negative = negative_in_line([y_theta, theta_q, y_m, m_q]);
                let is_singular = m_q.is_zero();
                let determinant_negative = !is_singular & ((m_q < zero) != is_negative);
                let one = determinant_negative | (is_singular & (negative_in_line([theta_q, y_m]) != is_negative));
                let two = !is_singular & !determinant_negative & !is_stiff(plane, zero);
                self.below = self.below.saturating_add(u64::from(one) + 2 * u64::from(two));
            }
            Support::Free if plane.m_q.is_zero() => {
                self.add_if(negative([plane.theta_q, plane.y_m]) != plane_negative(plane));
            }
            Support::Free => self.negative_eigenvalues(differs(plane.m_q), is_stiff(plane, T::zero())),
        }
    }

    #[inline(always)]
    fn cancelled(&mut self, completely: bool) {
        self.cancelled.add(completely);
    }

    #[inline(always)]
    fn looks_at_root(&self) -> bool {
        WATCHES && self.is_at_root
    }

    #[inline(always)]
    fn root_sum(&mut self, sum: f64, terms: f64) {
        self.cancelled.add_root::<T>(sum, terms);
    }

    #[inline]
    fn line_root(&mut self, line: &Line<T>, support: Support) {
        // stiffness -q/y of the free end
        self.add_if(support != Support::Fixed && !line.q.is_zero() && (line.q < T::zero()) == line_negative(line));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All planes whose minors are positive, negative or zero, and some that are no numbers.
    #[test]
    fn rules_without_branches_are_the_others() {
        let sizes = [-3.0, -0.0, 0.0, 2.0, f64::NAN, f64::INFINITY];
        for place in 0..sizes.len().pow(4) {
            let minor = |index: u32| sizes[place / sizes.len().pow(index) % sizes.len()];
            let plane = Plane::unscaled([minor(0), minor(1), 1.0, minor(2), minor(3)], 0);
            for support in [Support::Fixed, Support::Pinned, Support::Guided, Support::Free] {
                let (mut alone, mut in_line) =
                    (WittrickWilliams::<false>::default(), WittrickWilliams::<true>::default());
                alone.plane_root(&plane, support);
                in_line.plane_root(&plane, support);
                assert_eq!(alone.below(), in_line.below(), "{plane:?} at {support:?}");
            }
        }
    }
}
