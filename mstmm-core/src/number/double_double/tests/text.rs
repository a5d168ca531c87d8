//! Numbers to text and text to numbers.

use crate::number::double_double::DoubleDouble;
use crate::number::double_double::tests::{Exact, PRODUCT, SUM, UNIT, assert_equal, exact, sizes};
use crate::number::frequency::Parameter;
use num_traits::{Num, One, Zero};
use proptest::prelude::*;
use std::format;
use std::string::ToString;

/// One product or quotient with a power of ten, which itself is a product of up to eight.
const DECIMAL: f64 = 9.0 * PRODUCT;

/// The text as a quotient or product of integers.
fn decimal(text: &str) -> Exact {
    let (digits, exponent) = text.split_once('e').unwrap();
    let integer: u128 = digits.replace('.', "").parse().unwrap();
    let exponent = exponent.parse::<i32>().unwrap() - (digits.len() as i32 - 2);
    // 10^300 has 700 bits in its odd part
    let size = Exact::from(integer).with_precision(1500).value();
    let power =
        (0..exponent.abs()).fold(Exact::from(1).with_precision(1500).value(), |power, _| power * Exact::from(10));
    if exponent < 0 { size / power } else { size * power }
}

proptest! {
    #[test]
    fn decimals_are_parsed_with_all_digits(digits in "[1-9]\\.[0-9]{24}", exponent in -250..280) {
        let text = format!("{digits}e{exponent}");
        assert_equal(text.parse().unwrap(), &decimal(&text), DECIMAL);
        let text = format!("{digits}e{}", exponent % 20);
        // both the digits and the power of ten are exact
        assert_equal(text.parse().unwrap(), &decimal(&text), PRODUCT);
    }

    #[test]
    fn what_is_shown_is_read_again(x in sizes()) {
        let text = x.to_string();
        // half a unit of the thirty-second digit, and the powers of ten on both ways
        let estimate = 0.5e-31 / UNIT + 2.0 * DECIMAL;
        assert_equal(text.parse().unwrap(), &exact(x), estimate);
    }
}

#[test]
fn text_of_any_form_and_size() {
    let parse = |text: &str| text.parse::<DoubleDouble>().unwrap();
    assert_eq!(parse("1.2345e-6") * parse("1e4"), parse("0.012345"));
    assert_eq!(parse("-.5"), DoubleDouble::from(-0.5));
    assert_eq!(parse("+12.E+1"), DoubleDouble::from(120.0));
    assert_eq!(parse("0.1") * DoubleDouble::from(10.0), DoubleDouble::one());
    assert_eq!(parse("0e99"), DoubleDouble::zero());
    assert_eq!(parse("-inf").to_f64(), f64::NEG_INFINITY);
    assert_eq!(parse("1e400").to_f64(), f64::INFINITY);
    for text in [
        "1.7976931348623157e308",
        "-4.9e-324",
        "2.2250738585072014e-308",
        "1e300",
        "123456789012345678901234567890e-330",
    ] {
        assert_eq!(parse(text).to_f64(), text.parse::<f64>().unwrap());
    }
    let long = "1234567890123456789012345678901234567890123456789.5";
    assert_equal(parse(long), &decimal("1.2345678901234567890123456789012345e48"), SUM);
    for text in ["", "-", "1.2.3", "1e", "one", "1_000"] {
        assert!(text.parse::<DoubleDouble>().is_err());
    }
    assert!(DoubleDouble::from_str_radix("11", 2).is_err());
    assert_eq!(DoubleDouble::from_str_radix("11", 10), Ok(DoubleDouble::from(11.0)));
}

#[test]
fn shown_in_32_digits_or_as_many_as_asked_for() {
    let show = |text: &str| text.parse::<DoubleDouble>().unwrap().to_string();
    assert_eq!(show("0.1"), "1.0000000000000000000000000000000e-1");
    assert_eq!(show("-1234.5678901234567890123456789"), "-1.2345678901234567890123456789000e3");
    for (text, shown) in [
        ("9.9996", "1.000e1"),
        ("1e308", "1.000e308"),
        ("5e-324", "4.941e-324"),
        ("0.99994", "9.999e-1"),
        ("1000", "1.000e3"),
        ("1e-5", "1.000e-5"),
        ("8.5e22", "8.500e22"),
        ("0", "0.000"),
        ("inf", "inf"),
    ] {
        assert_eq!(format!("{:.3}", text.parse::<DoubleDouble>().unwrap()), shown);
    }
    let none = format!("{:.0}", DoubleDouble::from(-75.0));
    assert_eq!(none, "-8e1");
}
