//! Decimal text, in both directions with all digits.

use crate::number::double_double::DoubleDouble;
use crate::number::scalar::Scalar;
use core::fmt;
use core::num::ParseFloatError;
use core::str::FromStr;
use num_traits::Num;

/// Digits after the point that the type has to show.
const DIGITS: usize = 31;

/// Mantissas below this have room for one more digit in a `u128`; others have more digits than the type.
const FULL_MANTISSA: u128 = 10_u128.pow(37);

/// The size of the steps in which powers of ten are applied, so that none overflows.
const STEP: u32 = 200;

/// The power of two that shifts a number of this decimal exponent away from the end of the range, where products have no room.
const fn margin(exponent: i32) -> i32 {
    if exponent > 0 { -100 } else { 100 }
}

/// `10^n`, exact up to `n = 45`, by squaring.
fn power_of_ten(mut n: u32) -> DoubleDouble {
    let (mut power, mut square) = (DoubleDouble::ONE, DoubleDouble::from_double(10.0));
    while n > 0 {
        if n % 2 == 1 {
            power *= square;
        }
        n /= 2;
        square *= square;
    }
    power
}

impl DoubleDouble {
    /// An integer below 2^127: exact up to 2^106, and beyond as near as the type can be.
    fn from_integer(n: u128) -> Self {
        let hi = n as f64;
        DoubleDouble { hi, lo: (n as i128 - hi as i128) as f64 }
    }

    fn times_power_of_ten(mut self, exponent: i32) -> Self {
        let mut left = exponent.unsigned_abs();
        while left > 0 {
            let power = power_of_ten(left.min(STEP));
            self = if exponent > 0 { self * power } else { self / power };
            left -= left.min(STEP);
        }
        self
    }
}

/// Mantissa and power of ten of a decimal number of valid form. Digits beyond the thirty-eighth do not count.
fn decimal(text: &str) -> (u128, i32) {
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (mut mantissa, mut shift, mut after_point) = (0_u128, 0_i32, false);
    for byte in digits.bytes() {
        match byte {
            b'.' => after_point = true,
            b'0'..=b'9' if mantissa < FULL_MANTISSA => {
                mantissa = mantissa * 10 + u128::from(byte - b'0');
                shift -= i32::from(after_point);
            }
            b'0'..=b'9' => shift += i32::from(!after_point),
            // the sign
            _ => {}
        }
    }
    (mantissa, exponent.parse().unwrap_or(0_i32).saturating_add(shift))
}

/// Parses the text that an `f64` parses, with the digits for which an `f64` has no room.
impl FromStr for DoubleDouble {
    type Err = ParseFloatError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        // this checks the form, and knows infinities and NaN
        let nearest: f64 = text.parse()?;
        if nearest == 0.0 || !nearest.is_finite() {
            return Ok(DoubleDouble::from_double(nearest));
        }
        let (mantissa, exponent) = decimal(text);
        let margin = margin(exponent);
        let size = DoubleDouble::from_integer(mantissa).times_power_of_two(margin);
        let size = size.times_power_of_ten(exponent).times_power_of_two(-margin);
        Ok(if nearest < 0.0 { -size } else { size })
    }
}

/// For decimal digits only.
impl Num for DoubleDouble {
    type FromStrRadixErr = ParseFloatError;

    fn from_str_radix(digits: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        // the error has no constructor, but a word that is no number makes one
        if radix == 10 { digits.parse() } else { "digits of another radix".parse() }
    }
}

/// In scientific notation with 32 digits, or as many after the point as the format asks for, up to 31.
impl fmt::Display for DoubleDouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.hi == 0.0 || !self.hi.is_finite() {
            return fmt::Display::fmt(&self.hi, f);
        }
        let size = if self.hi < 0.0 { -*self } else { *self };
        let digits = f.precision().unwrap_or(DIGITS).min(DIGITS);
        let one = 10_u128.pow(digits as u32);
        let mut exponent = least_exponent(size.hi);
        let mut mantissa = size.decimal_mantissa(digits as i32 - exponent);
        while mantissa >= 10 * one {
            exponent += 1;
            mantissa = size.decimal_mantissa(digits as i32 - exponent);
        }
        let sign = if self.hi < 0.0 { "-" } else { "" };
        write!(f, "{sign}{}", mantissa / one)?;
        if digits > 0 {
            write!(f, ".{:0digits$}", mantissa % one)?;
        }
        write!(f, "e{exponent}")
    }
}

/// The decimal exponent of a positive number or, next to a power of ten, one less.
fn least_exponent(value: f64) -> i32 {
    // a subnormal number becomes a normal one
    const UP: i32 = 64;
    let (value, lift) = if value < f64::MIN_POSITIVE { (value.times_power_of_two(UP), UP) } else { (value, 0) };
    let binary = ((value.to_bits() >> 52) as i32) - 1023 - lift;
    let decimal = f64::from(binary) * core::f64::consts::LOG10_2;
    // the cast rounds towards zero
    decimal as i32 - i32::from(decimal < 0.0)
}

impl DoubleDouble {
    /// `self · 10^exponent` to the nearest integer, for positive numbers.
    fn decimal_mantissa(self, exponent: i32) -> u128 {
        let margin = margin(-exponent);
        let scaled = self.times_power_of_two(margin).times_power_of_ten(exponent).times_power_of_two(-margin);
        let DoubleDouble { hi, lo } = (scaled + DoubleDouble::from_double(0.5)).truncated();
        (hi as i128 + lo as i128) as u128
    }
}
