//! Numbers with partial derivatives, for the formulas of a model: forward differentiation in all fields at once.

mod functions;
mod operators;

use crate::number::elementary::Elementary;
use core::cmp::Ordering;

/// A number and its partial derivatives with respect to the `K` fields of a model.
///
/// Formulas of a model, written for `f64`, hold for it too: it has the operators, with an `f64` on either side, and the
/// functions of `f64` that have a derivative. Order and equality look at the value alone.
///
/// A derivative that is zero stays zero where the slope of a function is infinite. Where a function has a kink, as `abs` at
/// zero, the derivative is that of one side.
///
/// Value and derivatives are of a type `V`: `f64`, or an interval that holds all values over a box of fields.
///
/// # Example
/// ```
/// # use mstmm_core::Partials;
/// let (width, height) = (Partials::<2>::variable(0.2, 0), Partials::<2>::variable(0.5, 1));
/// let area = width * height;
/// assert_eq!((area.value, area.partials), (0.1, [0.5, 0.2]));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Partials<const K: usize, V = f64> {
    /// The value.
    pub value: V,
    /// Its derivative with respect to each field.
    pub partials: [V; K],
}

impl<const K: usize, V: Elementary> Partials<K, V> {
    /// The field at an index itself: its own derivative is 1, all others are 0.
    pub fn variable(value: V, index: usize) -> Self {
        let partial = |field| V::constant(if field == index { 1.0 } else { 0.0 });
        Partials { value, partials: core::array::from_fn(partial) }
    }

    /// A number that depends on no field.
    pub fn constant(value: f64) -> Self {
        Partials { value: V::constant(value), partials: [V::constant(0.0); K] }
    }

    /// A function by its value and slope at `self.value`.
    #[inline]
    fn chain(self, value: V, slope: V) -> Self {
        Partials { value, partials: self.partials.map(|partial| scaled(partial, slope)) }
    }

    /// A function of two numbers by its value and its slopes in both.
    #[inline]
    fn chain_of_two(self, other: Self, value: V, slopes: [V; 2]) -> Self {
        let partial = |field| scaled(self.partials[field], slopes[0]) + scaled(other.partials[field], slopes[1]);
        Partials { value, partials: core::array::from_fn(partial) }
    }
}

/// A partial derivative times a slope: zero where there is none, however steep the slope.
#[inline]
fn scaled<V: Elementary>(partial: V, slope: V) -> V {
    if partial.is_zero() { partial } else { partial * slope }
}

impl<const K: usize, V: Elementary> Default for Partials<K, V> {
    fn default() -> Self {
        Partials::constant(0.0)
    }
}

/// Implements comparisons by value between two types.
macro_rules! compare {
    ($($left:ty, $right:ty: $of_left:expr, $of_right:expr;)*) => {$(
        impl<const K: usize, V: Elementary> PartialEq<$right> for $left {
            fn eq(&self, other: &$right) -> bool {
                $of_left(self) == $of_right(other)
            }
        }

        impl<const K: usize, V: Elementary> PartialOrd<$right> for $left {
            fn partial_cmp(&self, other: &$right) -> Option<Ordering> {
                $of_left(self).partial_cmp(&$of_right(other))
            }
        }
    )*};
}

/// The value of a number with derivatives.
fn value<const K: usize, V: Elementary>(number: &Partials<K, V>) -> V {
    number.value
}

/// The value of a plain number.
fn itself<V: Elementary>(number: &f64) -> V {
    V::constant(*number)
}

compare! {
    Partials<K, V>, Partials<K, V>: value, value;
    Partials<K, V>, f64: value, itself::<V>;
    f64, Partials<K, V>: itself::<V>, value;
}

#[cfg(test)]
mod tests;
