//! Rectangles of the complex plane, plain or symmetric to the real axis, and their contours.

use crate::number::{Real, larger, smaller};
use num_complex::Complex;

/// A rectangle of the complex plane. With `low = -high` it is symmetric: since Δ(conj λ) = conj Δ(λ), half its contour counts
/// for all, and none of it runs along the real axis.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rectangle<T> {
    pub(super) left: T,
    pub(super) right: T,
    pub(super) low: T,
    pub(super) high: T,
}

/// Least ratio of the distance from the imaginary axis to the reach from the real one at which a rectangle is far.
const FAR: f64 = 8.0;

/// A side of the imaginary axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

/// The whole number that a count of turns stands for; `None` if it is none.
pub(super) fn whole(turns: f64) -> Option<u64> {
    let count = (turns + 0.5) as u64;
    ((turns - count as f64).abs() < 0.05).then_some(count)
}

impl<T: Real> Rectangle<T> {
    pub(super) fn is_symmetric(&self) -> bool {
        self.low == -self.high
    }

    pub(super) fn width(&self) -> T {
        self.right - self.left
    }

    pub(super) fn height(&self) -> T {
        self.high - self.low
    }

    /// The longer side.
    pub(super) fn size(&self) -> T {
        larger(self.width(), self.height())
    }

    pub(super) fn centre(&self) -> Complex<T> {
        let half = T::from_f64(0.5);
        Complex::new(self.left + self.width() * half, self.low + self.height() * half)
    }

    /// Points inside from which Newton's method may start, off the real axis, which it would not leave.
    pub(super) fn inner_points(&self) -> [Complex<T>; 3] {
        [(0.5, 0.75), (0.8, 0.6), (0.3, 0.9)].map(|(across, up)| {
            let (across, up) = (T::from_f64(across), T::from_f64(up));
            Complex::new(self.left + self.width() * across, self.low + self.height() * up)
        })
    }

    /// Whether a point lies inside or within a distance of it.
    pub(super) fn contains(&self, point: Complex<T>, distance: T) -> bool {
        point.re >= self.left - distance
            && point.re <= self.right + distance
            && point.im >= self.low - distance
            && point.im <= self.high + distance
    }

    /// Corners of the contour, counter-clockwise; of its upper half if the rectangle is symmetric.
    pub(super) fn contour(&self) -> [Complex<T>; 5] {
        let &Rectangle { left, right, low, high } = self;
        if self.is_symmetric() {
            let (start, end) = (Complex::new(right, T::zero()), Complex::new(left, T::zero()));
            return [start, Complex::new(right, high), Complex::new(left, high), end, end];
        }
        let start = Complex::new(left, low);
        [start, Complex::new(right, low), Complex::new(right, high), Complex::new(left, high), start]
    }

    /// The number of roots that the growth of the argument along the contour stands for.
    pub(super) fn roots(&self, argument: f64) -> Option<u64> {
        let (pi, turn) = (core::f64::consts::PI, core::f64::consts::TAU);
        whole(argument / if self.is_symmetric() { pi } else { turn })
    }

    /// The rectangle with its edges moved outwards, each by a share of the side that it cuts; a symmetric one stays so.
    pub(super) fn grown(&self, share: f64) -> Self {
        let share = T::from_f64(share);
        let (x, y) = (self.width() * share, self.height() * share);
        Rectangle { left: self.left - x, right: self.right + x, low: self.low - y, high: self.high + y }
    }

    /// The shorter side as a part of the longer one.
    pub(super) fn slenderness(&self) -> f64 {
        (smaller(self.width(), self.height()) / self.size()).to_f64()
    }

    /// The greatest distance from the real axis.
    fn reach(&self) -> T {
        larger(self.high, -self.low)
    }

    /// The side of the imaginary axis on which a far rectangle lies.
    pub(super) fn far_side(&self) -> Option<Side> {
        let far = self.reach() * T::from_f64(FAR);
        if self.right <= -far {
            Some(Side::Left)
        } else if self.left >= far {
            Some(Side::Right)
        } else {
            None
        }
    }

    /// The part of a rectangle near the imaginary axis, and the parts far to the left and to the right of it. A missing part has no
    /// width.
    pub(super) fn pieces(&self) -> [Self; 3] {
        let far = self.reach() * T::from_f64(FAR);
        let cut = |end: T, other: T| if end > far + far && other < far { far } else { end };
        let (left, right) = (-cut(-self.left, -self.right), cut(self.right, self.left));
        [Rectangle { left, right, ..*self }, Rectangle { right: left, ..*self }, Rectangle { left: right, ..*self }]
    }

    /// Two parts, cut across the longer side at a share of it. A symmetric rectangle is cut into two symmetric ones, or into
    /// an upper part, which stands for its mirror image, too, and a symmetric one.
    pub(super) fn parts(&self, share: f64) -> [Self; 2] {
        let share = T::from_f64(share);
        if self.width() >= self.height() * T::from_f64(if self.is_symmetric() { 0.5 } else { 1.0 }) {
            let cut = self.left + self.width() * share;
            return [Rectangle { right: cut, ..*self }, Rectangle { left: cut, ..*self }];
        }
        if self.is_symmetric() {
            let cut = self.high * share;
            return [Rectangle { low: cut, ..*self }, Rectangle { low: -cut, high: cut, ..*self }];
        }
        let cut = self.low + self.height() * share;
        [Rectangle { high: cut, ..*self }, Rectangle { low: cut, ..*self }]
    }
}
