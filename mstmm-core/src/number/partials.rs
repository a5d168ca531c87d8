//! Numbers with partial derivatives, for the formulas of a model: forward differentiation in all fields at once.

mod functions;
mod operators;

use core::cmp::Ordering;

/// A number and its partial derivatives with respect to the `K` fields of a model.
///
/// Formulas of a model, written for `f64`, hold for it too: it has the operators, with an `f64` on either side, and the
/// functions of `f64` that have a derivative. Order and equality look at the value alone.
///
/// A derivative that is zero stays zero where the slope of a function is infinite. Where a function has a kink, as `abs` at
/// zero, the derivative is that of one side.
///
/// # Example
/// ```
/// # use mstmm_core::Partials;
/// let (width, height) = (Partials::<2>::variable(0.2, 0), Partials::<2>::variable(0.5, 1));
/// let area = width * height;
/// assert_eq!((area.value, area.partials), (0.1, [0.5, 0.2]));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Partials<const K: usize> {
    /// The value.
    pub value: f64,
    /// Its derivative with respect to each field.
    pub partials: [f64; K],
}

impl<const K: usize> Partials<K> {
    /// The field at an index itself: its own derivative is 1, all others are 0.
    pub fn variable(value: f64, index: usize) -> Self {
        Partials { value, partials: core::array::from_fn(|field| if field == index { 1.0 } else { 0.0 }) }
    }

    /// A number that depends on no field.
    pub fn constant(value: f64) -> Self {
        Partials { value, partials: [0.0; K] }
    }

    /// A function by its value and slope at `self.value`.
    #[inline]
    fn chain(self, value: f64, slope: f64) -> Self {
        Partials { value, partials: self.partials.map(|partial| scaled(partial, slope)) }
    }

    /// A function of two numbers by its value and its slopes in both.
    #[inline]
    fn chain_of_two(self, other: Self, value: f64, slopes: [f64; 2]) -> Self {
        let partial = |field| scaled(self.partials[field], slopes[0]) + scaled(other.partials[field], slopes[1]);
        Partials { value, partials: core::array::from_fn(partial) }
    }
}

/// A partial derivative times a slope: zero where there is none, however steep the slope.
#[inline]
fn scaled(partial: f64, slope: f64) -> f64 {
    if partial == 0.0 { 0.0 } else { partial * slope }
}

impl<const K: usize> Default for Partials<K> {
    fn default() -> Self {
        Partials::constant(0.0)
    }
}

/// Implements comparisons by value between two types.
macro_rules! compare {
    ($($left:ty, $right:ty: $of_left:expr, $of_right:expr;)*) => {$(
        impl<const K: usize> PartialEq<$right> for $left {
            fn eq(&self, other: &$right) -> bool {
                $of_left(self) == $of_right(other)
            }
        }

        impl<const K: usize> PartialOrd<$right> for $left {
            fn partial_cmp(&self, other: &$right) -> Option<Ordering> {
                $of_left(self).partial_cmp(&$of_right(other))
            }
        }
    )*};
}

/// The value of a number with derivatives.
fn value<const K: usize>(number: &Partials<K>) -> f64 {
    number.value
}

/// The value of a plain number.
fn itself(number: &f64) -> f64 {
    *number
}

compare! {
    Partials<K>, Partials<K>: value, value;
    Partials<K>, f64: value, itself;
    f64, Partials<K>: itself, value;
}

#[cfg(test)]
mod tests;
