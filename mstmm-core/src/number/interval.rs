//! Intervals that hold all values of a formula over a box of fields, rounded outwards.
//!
//! An operation on plain numbers is right to half a distance of neighbours, so that a neighbour further out is a bound. Functions of the standard library are
//! taken to be right to [`LIBRARY`] of these distances. An end that is not a finite number makes the whole interval none: the formula may not be defined in all of it, as behind a
//! division by zero. Zero stands for both of its signs.

mod functions;
#[cfg(test)]
mod tests;

use crate::number::elementary::Elementary;
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Distances of neighbours by which a function may be wrong. The GNU C library documents 4 at most for those that are used here, of the cube root.
const LIBRARY: usize = 4;

/// All numbers from one to another, or none.
#[derive(Clone, Copy, Debug, Default)]
pub struct Interval {
    /// The least one.
    pub low: f64,
    /// The greatest one.
    pub high: f64,
}

/// What nothing is known of.
const NONE: Interval = Interval { low: f64::NAN, high: f64::NAN };

impl Interval {
    /// From the smaller of two numbers to the larger one.
    pub fn between(one: f64, other: f64) -> Self {
        let [one, other] = [positive_zero(one), positive_zero(other)];
        if one <= other { Interval { low: one, high: other } } else { Interval { low: other, high: one } }
    }

    /// One number.
    pub fn point(value: f64) -> Self {
        Interval::between(value, value)
    }

    /// Whether a number is in it.
    pub fn holds(self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }

    /// The same with ends that are so many neighbours further out.
    fn outwards(self, neighbours: usize) -> Self {
        let out = |end: f64, next: fn(f64) -> f64| (0..neighbours).fold(end, |end, _| next(end));
        Interval { low: out(self.low, f64::next_down), high: out(self.high, f64::next_up) }
    }

    /// What is in a range, too.
    fn within(self, [least, most]: [f64; 2]) -> Self {
        if self.is_number() { Interval { low: self.low.max(least), high: self.high.min(most) } } else { NONE }
    }

    /// From the least to the greatest of some numbers; none where one is not a number.
    fn of_all<const N: usize>(values: [f64; N]) -> Self {
        if values.iter().any(|value| value.is_nan()) {
            return NONE;
        }
        let [least, most] = [f64::min, f64::max].map(|pick| values.iter().copied().fold(values[0], pick));
        Interval { low: least, high: most }
    }
}

/// The interval of a value that is rounded to the nearest number; an exact one stays what it is, so that what is absent stays absent.
fn rounded(value: f64, is_exact: bool) -> Interval {
    Interval::point(value).outwards(usize::from(!is_exact))
}

/// The bounds of a sum of two numbers, which is exact where it is zero.
fn sum(one: f64, other: f64) -> Interval {
    rounded(one + other, one + other == 0.0)
}

/// Zero without its sign.
fn positive_zero(value: f64) -> f64 {
    value + 0.0
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if !(self.is_number() && other.is_number()) {
            return NONE;
        }
        Interval { low: sum(self.low, other.low).low, high: sum(self.high, other.high).high }
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Interval { low: 0.0 - self.high, high: 0.0 - self.low }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if !(self.is_number() && other.is_number()) {
            return NONE;
        }
        let product = |one: f64, other: f64| rounded(positive_zero(one * other), one == 0.0 || other == 0.0);
        let of = |one: f64| product(one, other.low).hull(product(one, other.high));
        of(self.low).hull(of(self.high))
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if !(self.is_number() && other.is_number()) {
            return NONE;
        }
        if other.low <= 0.0 && other.high >= 0.0 {
            return NONE;
        }
        let quotient = |one: f64, other: f64| rounded(positive_zero(one / other), one == 0.0);
        let of = |one: f64| quotient(one, other.low).hull(quotient(one, other.high));
        of(self.low).hull(of(self.high))
    }
}

impl PartialEq for Interval {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

/// Intervals are in an order where all of their numbers are.
impl PartialOrd for Interval {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if !(self.is_number() && other.is_number()) {
            None
        } else if self.high < other.low {
            Some(Ordering::Less)
        } else if self.low > other.high {
            Some(Ordering::Greater)
        } else {
            let is_point = self.low == self.high && other.low == other.high;
            is_point.then_some(Ordering::Equal)
        }
    }
}
