//! Each function against central differences, each operator too.

use crate::number::partials::Partials;

type Two = Partials<2>;

/// A function of two fields, as `f64` and with derivatives.
struct Case {
    name: &'static str,
    plain: fn(f64, f64) -> f64,
    partial: fn(Two, Two) -> Two,
}

/// A case of one formula, over `f64` and over `Partials`.
macro_rules! case {
    (|$a:ident, $b:ident| $formula:expr) => {
        Case { name: stringify!($formula), plain: |$a, $b| $formula, partial: |$a, $b| $formula }
    };
}

/// The value is that of `f64`, and the partial derivatives are near `(f(x + h) - f(x - h))/2h`, whose error is about
/// `eps^(2/3)` of the function's size.
#[track_caller]
fn assert_derivatives(case: &Case, points: &[[f64; 2]]) {
    let step = f64::EPSILON.cbrt();
    for &[a, b] in points {
        let found = (case.partial)(Partials::variable(a, 0), Partials::variable(b, 1));
        let value = (case.plain)(a, b);
        assert!(
            (found.value - value).abs() <= 4.0 * f64::EPSILON * value.abs(),
            "{} at {a}, {b}: {found:?}",
            case.name
        );
        let difference =
            |da: f64, db: f64| ((case.plain)(a + da, b + db) - (case.plain)(a - da, b - db)) / (2.0 * (da + db));
        for (partial, expected) in found.partials.into_iter().zip([difference(step, 0.0), difference(0.0, step)]) {
            let tolerance = 30.0 * step * step * (1.0 + value.abs() + expected.abs());
            assert!((partial - expected).abs() <= tolerance, "{} at {a}, {b}: {found:?}, {expected}", case.name);
        }
    }
}

/// Points of all signs.
const POINTS: [[f64; 2]; 4] = [[0.3, 0.8], [-1.7, 0.45], [2.2, -1.3], [-0.9, -2.6]];
/// Points with positive coordinates.
const POSITIVE: [[f64; 2]; 4] = [[0.3, 0.8], [1.7, 0.45], [2.2, 1.3], [0.9, 2.6]];
/// Points within the unit square.
const SMALL: [[f64; 2]; 4] = [[0.3, 0.8], [-0.7, 0.45], [0.85, -0.1], [-0.5, -0.6]];

#[test]
fn operators() {
    let cases = [
        case!(|a, b| a + b),
        case!(|a, b| a - b),
        case!(|a, b| a * b),
        case!(|a, b| a / b),
        case!(|a, b| -a * b),
        case!(|a, b| (a * b - a / b) / (a * a + b * b)),
        case!(|a, b| (2.0 + a) * (a + 2.0) - (3.0 - b) * (b - 3.0)),
        case!(|a, b| (2.0 * a) * (b * 0.7) + (2.0 / a) / (b / 0.7)),
    ];
    cases.iter().for_each(|case| assert_derivatives(case, &POINTS));
}

#[test]
fn functions_of_any_number() {
    let cases = [
        case!(|a, b| (a * b).cbrt()),
        case!(|a, b| (a * b).exp()),
        case!(|a, b| (a * b).exp_m1()),
        case!(|a, b| (a * b).sin()),
        case!(|a, b| (a * b).cos()),
        case!(|a, b| (0.3 * a * b).tan()),
        case!(|a, b| (a * b).atan()),
        case!(|a, b| (a * b).sinh()),
        case!(|a, b| (a * b).cosh()),
        case!(|a, b| (a * b).tanh()),
        case!(|a, b| (a * b).abs()),
        case!(|a, b| (a * b).signum() * a),
        case!(|a, b| (a * b).recip()),
        case!(|a, b| (a * b).to_radians()),
        case!(|a, b| (a * b).to_degrees()),
        case!(|a, b| (a * b).powi(0) + (a * b).powi(1) + (a * b).powi(3) + (a * b).powi(-2)),
        case!(|a, b| a.atan2(b)),
        case!(|a, b| a.hypot(b)),
        case!(|a, b| a.min(b) * a),
        case!(|a, b| a.max(b) * a),
        case!(|a, b| a.mul_add(b, a)),
    ];
    cases.iter().for_each(|case| assert_derivatives(case, &POINTS));
}

#[test]
fn functions_of_a_range() {
    let positive = [
        case!(|a, b| (a * b).sqrt()),
        case!(|a, b| (a * b).ln()),
        case!(|a, b| (a * b).ln_1p()),
        case!(|a, b| (a * b).log10()),
        case!(|a, b| (a * b).log2()),
        case!(|a, b| a.powf(b)),
        // below, in and above
        case!(|a, b| a.clamp(0.25 * b, b)),
        case!(|a, b| a.clamp(2.0 * b, 3.0 * b)),
    ];
    positive.iter().for_each(|case| assert_derivatives(case, &POSITIVE));
    let small = [case!(|a, b| (a * b).asin()), case!(|a, b| (a * b).acos())];
    small.iter().for_each(|case| assert_derivatives(case, &SMALL));
}

/// Oracle: the order of `f64`.
#[test]
fn order_is_that_of_the_values() {
    for (a, b) in [(1.0, 2.0), (2.0, 1.0), (1.0, 1.0), (1.0, f64::NAN)] {
        let (left, right) = (Partials::<1>::variable(a, 0), Partials::<1>::constant(b));
        assert_eq!((left.partial_cmp(&right), left == right), (a.partial_cmp(&b), a == b));
        assert_eq!((left.partial_cmp(&b), left == b), (a.partial_cmp(&b), a == b));
        assert_eq!((a.partial_cmp(&right), a == right), (a.partial_cmp(&b), a == b));
    }
}

/// Not a number counts neither in `min` nor in `max`, and passes through `clamp`, as in `f64`.
#[test]
fn not_a_number_is_treated_as_by_f64() {
    let (one, none) = (Partials::<1>::variable(1.0, 0), Partials::constant(f64::NAN));
    for value in [one.min(none), none.min(one), one.max(none), none.max(one)] {
        assert_eq!((value.value, value.partials), (1.0, [1.0]));
    }
    assert!(none.clamp(one, one).value.is_nan());
}

/// A slope without bound is no derivative of what does not change.
#[test]
fn a_number_that_depends_on_nothing_has_no_derivative_at_a_steep_place() {
    let zero = Partials::<1>::constant(0.0);
    assert_eq!(zero.sqrt().partials, [0.0]);
    assert_eq!(zero.ln().partials, [0.0]);
    // ln of a negative base is not a number, and no part of the derivative for a constant exponent
    let square = Partials::<1>::variable(-3.0, 0).powf(Partials::constant(2.0));
    assert_eq!((square.value, square.partials), (9.0, [-6.0]));
    assert_eq!(Partials::<1>::variable(0.0, 0).powi(0).partials, [0.0]);
    assert_eq!(Partials::<1>::variable(0.0, 0).powi(1).partials, [1.0]);
}
