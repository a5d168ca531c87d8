//! The count of natural frequencies below a frequency, in the same pass as Δ (Wittrick and Williams along a tree).
//!
//! The steps of the plane method tell a counter what happens; [`NoCount`] ignores it at no cost, [`WittrickWilliams`] applies the
//! rules. Each rule adds the negative eigenvalues of the stiffness that a step eliminates. A support is the limit of a
//! stiff spring, hence the rules for exact zeros. All decide by signs alone, without a quotient, in all lanes of a number.

use crate::model::Spot;
use crate::number::{Scalar, Scaled, Size, Truth};
use crate::subspace::minors::line::Line;
use crate::subspace::minors::plane::Plane;
use mstmm_plan::{Space, Support};

/// What a system is counted for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// Nothing: Δ alone is wanted, of the same code, which is compiled once.
    Values,
    /// The number of roots.
    Counts,
    /// That number with a share of the next one.
    Phases,
}

/// A bending element with both its ends held: its clamped count, and the sign and stiffness for the rule of a plane.
#[derive(Clone, Copy, Debug)]
pub struct Held<S: Scalar> {
    /// Number of its own frequencies below this one.
    pub below: S::Size,
    /// Whether the factor by which its step has multiplied the minors is negative.
    pub is_negative: S::Truth,
    /// Its stiffness against deflection of the input end: a number, and the one that divides it, zero where it is rigid.
    pub stiffness: [S; 2],
    /// Units of p_YM, w, p_ΘQ and p_MQ beside p_YΘ at its wave number, and their inverses, of an element with waves.
    pub units: Option<[[S; 4]; 2]>,
}

/// A counter of natural frequencies, to which the steps of the plane method report.
pub trait RootCounter<S: Scalar> {
    /// Whether the counter counts; else a step may leave out computations for it.
    const COUNTS: bool;
    /// Whether sums that cancel are watched.
    const WATCHES: bool = false;
    /// An element took a line from `before` to `after`; held at both ends it has `held` frequencies below this one, and its step
    /// has multiplied the line by a number that `is_negative`.
    #[inline(always)]
    fn line(&mut self, _before: &Line<S>, _after: &Line<S>, _held: S::Size, _is_negative: S::Truth) {}
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

    /// The pivots of a network have been taken: its count.
    #[inline(always)]
    fn eliminated(&mut self, _below: S::Size) {}
    /// A sum lost more digits to cancellation than a circle has room for, or all of them: then it was taken for zero.
    #[inline(always)]
    fn cancelled(&mut self, _completely: bool) {}
    /// What holds a point of a network has vanished.
    #[inline(always)]
    fn vanished(&mut self, _at: Spot) {}
    /// The plane before the last element with its wave a quarter of a turn ahead, if Δ is wanted there, too.
    #[inline(always)]
    fn turned(&self, _before: &Plane<S>) -> Option<Plane<S>> {
        None
    }
    /// Δ of the plane that [`turned`](RootCounter::turned) has returned.
    #[inline(always)]
    fn delta_ahead(&mut self, _delta: Scaled<S>) {}
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
    /// Sums lost more digits than a circle has room for.
    pub(crate) partly: bool,
    /// Sums lost all digits.
    pub(crate) completely: bool,
}

impl Cancelled {
    #[inline(always)]
    fn add(&mut self, completely: bool) {
        self.completely |= completely;
        self.partly |= !completely;
    }

    /// Whether the pass is doubtful.
    #[inline]
    pub(crate) fn any(&self) -> bool {
        self.partly || self.completely
    }
}

/// The number of natural frequencies below the frequency of a pass, by the algorithm of Wittrick and Williams.
///
/// It proposes a count and does not watch rounding: a proof decides.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WittrickWilliams<Z: Size = f64> {
    below: Z,
}

impl WittrickWilliams {
    /// The count so far; of all frequencies once the pass has reached the root.
    #[inline]
    pub fn below(&self) -> u64 {
        self.below as u64
    }
}

impl<Z: Size> WittrickWilliams<Z> {
    /// The count so far, a whole number in each lane.
    #[inline(always)]
    pub(crate) fn count(&self) -> Z {
        self.below
    }

    #[inline(always)]
    fn add_if(&mut self, condition: Z::Truth) {
        self.below = self.below + Z::one_if(condition);
    }

    /// Adds the negative eigenvalues of a symmetric 2×2 matrix from the sign of its determinant and its first entry.
    #[inline(always)]
    fn negative_eigenvalues(&mut self, determinant_negative: Z::Truth, first_positive: Z::Truth) {
        let definite = Z::choose(first_positive, Z::of(0.0), Z::of(2.0));
        self.below = self.below + Z::choose(determinant_negative, Z::of(1.0), definite);
    }
}

/// Sign of the first number that is not zero: whether it is negative.
#[inline(always)]
fn negative<S: Scalar, const N: usize>(candidates: [S; N]) -> S::Truth {
    let (mut is_negative, mut is_open) = (S::Truth::of(false), S::Truth::of(true));
    let mut k = 0;
    while k < N {
        let is_zero = candidates[k].vanishes();
        // a zero has a sign of its own, which does not count
        is_negative = is_negative | (is_open & !is_zero & candidates[k].is_negative());
        is_open = is_open & is_zero;
        if !is_open.any() {
            break;
        }
        k += 1;
    }
    is_negative
}

/// Sign of p_YΘ, of the limit of stiff springs where it is zero.
#[inline(always)]
fn plane_negative<S: Scalar>(p: &Plane<S>) -> S::Truth {
    negative([p.y_theta, p.theta_q, p.y_m, p.m_q])
}

/// Whether a minor that is not zero differs in sign from p_YΘ.
#[inline(always)]
fn differs<S: Scalar>(minor: S, plane: &Plane<S>) -> S::Truth {
    !minor.vanishes() & (minor.is_negative() ^ plane_negative(plane))
}

/// Whether the stiffness p_ΘQ/p_YΘ against deflection, with another beside it, is positive, as that of stiff springs where p_YΘ
/// is zero. By signs, not by quotients: they may underflow, and take their time.
#[inline(always)]
fn is_stiff<S: Scalar>(p: &Plane<S>, [stiffness, divisor]: [S; 2]) -> S::Truth {
    let force = p.theta_q * divisor + stiffness * p.y_theta;
    let is_against = force.is_negative() ^ divisor.is_negative() ^ p.y_theta.is_negative();
    p.y_theta.vanishes() | !(is_against | force.vanishes())
}

/// Whether p_ΘQ/p_YΘ is positive, or that of stiff springs.
#[inline(always)]
fn is_stiff_alone<S: Scalar>(p: &Plane<S>) -> S::Truth {
    p.y_theta.vanishes() | !((p.theta_q.is_negative() ^ p.y_theta.is_negative()) | p.theta_q.vanishes())
}

/// Sign of y, of the limit of a stiff spring where it is zero.
#[inline(always)]
fn line_negative<S: Scalar>(line: &Line<S>) -> S::Truth {
    negative([line.y, -line.q])
}

impl<S: Scalar> RootCounter<S> for WittrickWilliams<S::Size> {
    const COUNTS: bool = true;

    #[inline(always)]
    fn line(&mut self, before: &Line<S>, after: &Line<S>, held: S::Size, is_negative: S::Truth) {
        self.below = self.below + held;
        self.add_if(line_negative(before) ^ line_negative(after) ^ is_negative);
    }

    #[inline(always)]
    fn plane(&mut self, before: &Plane<S>, after: &Plane<S>, held: Held<S>) {
        let Held { below, is_negative, stiffness, .. } = held;
        self.below = self.below + below;
        let determinant_negative = plane_negative(before) ^ plane_negative(after) ^ is_negative;
        self.negative_eigenvalues(determinant_negative, is_stiff(before, stiffness));
    }

    #[inline(always)]
    fn narrowing(&mut self, plane: &Plane<S>, space: Space) {
        let left_behind = plane.minor(Space::Bending.without(space));
        self.add_if(negative([left_behind, plane.m_q]) ^ plane_negative(plane));
    }

    #[inline(always)]
    fn plane_root(&mut self, plane: &Plane<S>, support: Support) {
        match support {
            Support::Fixed => {}
            Support::Pinned | Support::Guided | Support::Roller => self.add_if(differs(plane.minor_at(support), plane)),
            Support::Free => {
                let is_singular = plane.m_q.vanishes();
                let definite = S::Size::choose(is_stiff_alone(plane), S::Size::of(0.0), S::Size::of(2.0));
                let mut added = S::Size::choose(differs(plane.m_q, plane), S::Size::of(1.0), definite);
                if is_singular.any() {
                    let one = negative([plane.theta_q, plane.y_m]) ^ plane_negative(plane);
                    added = S::Size::choose(is_singular, S::Size::one_if(one), added);
                }
                self.below = self.below + added;
            }
        }
    }

    #[inline(always)]
    fn eliminated(&mut self, below: S::Size) {
        self.below = self.below + below;
    }

    #[inline(always)]
    fn line_root(&mut self, line: &Line<S>, support: Support) {
        // stiffness -q/y of the free end
        if support != Support::Fixed {
            self.add_if(!line.q.vanishes() & !(line.q.is_negative() ^ line_negative(line)));
        }
    }
}

/// The counter that watches sums that cancel, and counts nothing.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Watch {
    pub(crate) cancelled: Cancelled,
    /// The point of a network where what holds it has vanished.
    pub(crate) vanished: Option<Spot>,
}

impl<S: Scalar> RootCounter<S> for Watch {
    const COUNTS: bool = false;
    const WATCHES: bool = true;
    #[inline(always)]
    fn cancelled(&mut self, completely: bool) {
        self.cancelled.add(completely);
    }
    #[inline(always)]
    fn vanished(&mut self, at: Spot) {
        self.vanished = Some(at);
    }
}
