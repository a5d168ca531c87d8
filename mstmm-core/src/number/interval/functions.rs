//! Functions of intervals: by their ends where they are monotone, with their turning points else.

use crate::number::elementary::{Elementary, Function};
use crate::number::floats::elementary;
use crate::number::interval::{Interval, LIBRARY, NONE};
use core::f64::consts::{FRAC_PI_2, PI};

/// The largest argument of a sine whose turning points are looked for; beyond it their places are not known well enough, and it may be anything from -1 to 1.
const LARGEST_ANGLE: f64 = 1e6;
/// How far a turning point may be off, relative to π/2 and to the argument: a few roundings of both, by which an interval is widened for the search of turning points.
const TURNING_POINT: f64 = 1e-14;

/// How a function of one number goes.
enum Course {
    /// It grows.
    Up,
    /// It falls.
    Down,
    /// It has its least value at zero.
    Even,
    /// A sine, of the argument and so many quarters of a turn.
    Wave(f64),
    /// A tangent.
    Branches,
}

/// The course of a function, and the range that it cannot leave.
fn course(function: Function) -> (Course, [f64; 2]) {
    use Function as F;
    let inf = f64::INFINITY;
    match function {
        F::Sqrt | F::Exp => (Course::Up, [0.0, inf]),
        F::ExpM1 => (Course::Up, [-1.0, inf]),
        F::Tanh => (Course::Up, [-1.0, 1.0]),
        F::Cbrt | F::Ln | F::Ln1P | F::Log10 | F::Log2 | F::Asin | F::Atan | F::Sinh => (Course::Up, [-inf, inf]),
        F::Acos => (Course::Down, [0.0, inf]),
        F::Cosh => (Course::Even, [1.0, inf]),
        F::Sin => (Course::Wave(0.0), [-1.0, 1.0]),
        F::Cos => (Course::Wave(1.0), [-1.0, 1.0]),
        F::Tan => (Course::Branches, [-inf, inf]),
    }
}

/// The largest whole number that is not above one.
fn floor(value: f64) -> f64 {
    elementary!(f64::floor, libm::floor, value)
}

/// Whether a whole number is even.
fn is_even(number: f64) -> bool {
    2.0 * floor(0.5 * number) == number
}

/// Whether multiples of a half turn are in an interval behind so many quarters of a turn: those of even and of odd number.
fn turns_in(angles: Interval, quarters: f64) -> [bool; 2] {
    if !(angles.low.abs() < LARGEST_ANGLE && angles.high.abs() < LARGEST_ANGLE) {
        return [true; 2];
    }
    let off = TURNING_POINT * (1.0 + angles.low.abs().max(angles.high.abs()));
    let half_turns = |angle: f64| (angle - quarters * FRAC_PI_2) / PI;
    let first = -floor(-half_turns(angles.low - off));
    let last = floor(half_turns(angles.high + off));
    let is_odd = |number: f64| !is_even(number);
    if first > last {
        [false; 2]
    } else if first == last {
        [!is_odd(first), is_odd(first)]
    } else {
        [true; 2]
    }
}

impl Interval {
    /// The ends by a function that errs by no more than the library does, within a range.
    fn by_ends(values: [f64; 2], range: [f64; 2]) -> Self {
        Interval::of_all(values).outwards(LIBRARY).within(range)
    }
}

impl Elementary for Interval {
    fn constant(value: f64) -> Self {
        Interval::point(value)
    }

    fn is_number(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    fn is_below(self, other: Self) -> Option<bool> {
        if !(self.is_number() && other.is_number()) {
            return None;
        }
        if self.high < other.low {
            Some(true)
        } else if self.low >= other.high {
            Some(false)
        } else {
            None
        }
    }

    fn hull(self, other: Self) -> Self {
        Interval::of_all([self.low, self.high, other.low, other.high])
    }

    fn lesser(self, other: Self) -> Self {
        if self.is_number() && other.is_number() {
            Interval { low: self.low.min(other.low), high: self.high.min(other.high) }
        } else {
            NONE
        }
    }

    fn greater(self, other: Self) -> Self {
        -(-self).lesser(-other)
    }

    fn sign(self) -> Self {
        let [below, above] = [self.low <= 0.0, self.high >= 0.0];
        let sign = Interval { low: if below { -1.0 } else { 1.0 }, high: if above { 1.0 } else { -1.0 } };
        if self.is_number() { sign } else { NONE }
    }

    fn absolute(self) -> Self {
        if !self.is_number() {
            NONE
        } else if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            Interval { low: 0.0, high: self.high.max(-self.low) }
        }
    }

    fn whole_power(self, exponent: f64) -> Self {
        if !self.is_number() {
            return NONE;
        }
        if exponent == 0.0 {
            return Interval::point(1.0);
        }
        if exponent < 0.0 {
            return Interval::point(1.0) / self.whole_power(-exponent);
        }
        if exponent == 1.0 {
            return self;
        }
        let is_even = is_even(exponent);
        let base = if is_even { self.absolute() } else { self };
        let powers = [base.low, base.high].map(|end| end.power(exponent));
        let exact = [base.low, base.high].map(|end| end == 0.0);
        let range = [if is_even { 0.0 } else { f64::NEG_INFINITY }, f64::INFINITY];
        // a power by products has a rounding for each factor, which is relative
        let products = Interval { low: 1.0 - exponent * f64::EPSILON, high: 1.0 + exponent * f64::EPSILON };
        let wide = (Interval::by_ends(powers, range) * products).within(range);
        Interval { low: if exact[0] { 0.0 } else { wide.low }, high: if exact[1] { 0.0 } else { wide.high } }
    }

    fn power(self, exponent: Self) -> Self {
        if exponent.low == exponent.high && exponent.low == floor(exponent.low) {
            return self.whole_power(exponent.low);
        }
        // a power of a positive base is monotone in both
        if !(self.low >= 0.0 && self.is_number() && exponent.is_number()) {
            return NONE;
        }
        let of = |base: f64| [base.power(exponent.low), base.power(exponent.high)];
        let [[a, b], [c, d]] = [of(self.low), of(self.high)];
        let all = Interval::of_all([a, b, c, d]);
        Interval::by_ends([all.low, all.high], [0.0, f64::INFINITY])
    }

    fn angle(self, x: Self) -> (Self, [Self; 2]) {
        if !(self.is_number() && x.is_number()) {
            return (NONE, [NONE; 2]);
        }
        // the angle jumps at the negative half of the axis
        if x.low <= 0.0 && self.low <= 0.0 && self.high >= 0.0 {
            return (Interval { low: -PI, high: PI }.outwards(1), [NONE; 2]);
        }
        let of = |y: f64| [x.low, x.high].map(|x| y.angle(x).0);
        let [[a, b], [c, d]] = [of(self.low), of(self.high)];
        let all = Interval::of_all([a, b, c, d]);
        let square = self.whole_power(2.0) + x.whole_power(2.0);
        let value = Interval::by_ends([all.low, all.high], [f64::NEG_INFINITY, f64::INFINITY]);
        (value, [x / square, -self / square])
    }

    fn diagonal(self, other: Self) -> Self {
        if !(self.is_number() && other.is_number()) {
            return NONE;
        }
        let [one, other] = [self.absolute(), other.absolute()];
        Interval::by_ends([one.low.diagonal(other.low), one.high.diagonal(other.high)], [0.0, f64::INFINITY])
    }

    fn of(self, function: Function) -> Self {
        if !self.is_number() {
            return NONE;
        }
        let (course, range) = course(function);
        let at_ends = |of: Interval| Interval::by_ends([function.at(of.low), function.at(of.high)], range);
        match course {
            Course::Up | Course::Down => at_ends(self),
            Course::Even => at_ends(self.absolute()),
            Course::Wave(quarters) => {
                let ends = at_ends(self);
                // a sine is 1 a quarter of a turn behind zero, a cosine at zero
                let [up, down] = turns_in(self, 1.0 - quarters);
                Interval { low: if down { -1.0 } else { ends.low }, high: if up { 1.0 } else { ends.high } }
            }
            Course::Branches => {
                let [up, down] = turns_in(self, 1.0);
                if up || down { NONE } else { at_ends(self) }
            }
        }
    }
}
