//! Exact comparison of floating-point numbers with decimals of any length.

use core::cmp::Ordering;

/// Compares `x`, which is a decimal of finite length, with a decimal, digit by digit. Both are zero or positive.
pub(crate) fn compare(x: f64, decimal: &str) -> Ordering {
    assert!(x >= 0.0 && x.is_finite(), "{x} is no number to compare with {decimal}");
    // no double has more digits behind the point
    let exact = format!("{x:.1074}");
    let (whole, fraction) = decimal.split_once('.').unwrap_or((decimal, ""));
    assert!(whole.chars().chain(fraction.chars()).all(|c| c.is_ascii_digit()), "{decimal} is not a plain decimal");
    let width = exact.len().max(whole.len() + 1075);
    format!("{exact:0>width$}").cmp(&format!("{:0>width$}", format!("{whole}.{fraction:0<1074}")))
}

/// Whether a decimal lies between two numbers, ends included.
pub(crate) fn is_within(decimal: &str, lower: f64, upper: f64) -> bool {
    compare(lower, decimal) != Ordering::Greater && compare(upper, decimal) != Ordering::Less
}

/// Oracle: the decimal expansion of 0.1 as a double is 0.1000000000000000055511151231257827…
#[test]
fn comparison_sees_more_digits_than_a_double_has() {
    assert_eq!(compare(0.1, "0.1"), Ordering::Greater);
    assert_eq!(compare(0.1, "0.10000000000000000555"), Ordering::Greater);
    assert_eq!(compare(0.1, "0.10000000000000000556"), Ordering::Less);
    assert_eq!(compare(0.5, "0.50"), Ordering::Equal);
    assert_eq!(compare(9.0, "10"), Ordering::Less);
    assert_eq!(compare(1305.25, "999.9999"), Ordering::Greater);
    assert!(is_within("0.0", 0.0, 1e-300) && !is_within("0.1", 0.1, 1.0));
}
