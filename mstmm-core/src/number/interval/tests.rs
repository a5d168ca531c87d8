//! Intervals against samples in them.

use crate::number::DoubleDouble;
use crate::number::elementary::{Elementary, Function};
use crate::number::interval::Interval;
use crate::number::partials::Partials;
use crate::number::scalar::Scalar;

type Two<V> = Partials<2, V>;

/// A formula of two fields over both kinds of numbers.
struct Case {
    name: &'static str,
    plain: fn(Two<f64>, Two<f64>) -> Two<f64>,
    enclosed: fn(Two<Interval>, Two<Interval>) -> Two<Interval>,
}

macro_rules! case {
    (|$a:ident, $b:ident| $formula:expr) => {
        Case { name: stringify!($formula), plain: |$a, $b| $formula, enclosed: |$a, $b| $formula }
    };
}

/// All functions and operators, of any numbers.
fn cases() -> [Case; 36] {
    [
        case!(|a, b| a + b),
        case!(|a, b| a - b - 0.1),
        case!(|a, b| 2.0 * a * b),
        case!(|a, b| a / (b * b + 0.3)),
        case!(|a, b| (a * b).sin()),
        case!(|a, b| (5.0 * a + b).cos()),
        case!(|a, b| (a + b).tan()),
        case!(|a, b| (a - b).atan()),
        case!(|a, b| a.atan2(b)),
        case!(|a, b| a.hypot(b)),
        case!(|a, b| a.min(b) + a.max(2.0 * b)),
        case!(|a, b| a.clamp(0.3 * b, b * b)),
        case!(|a, b| (a - b).abs()),
        case!(|a, b| (a - 0.5 * b).signum() * b),
        case!(|a, b| a.powi(3) + b.powi(2) + a.powi(0)),
        case!(|a, b| a.powi(-2) * b),
        case!(|a, b| (a * b).exp()),
        case!(|a, b| (a + b).exp_m1()),
        case!(|a, b| (a * b).cbrt()),
        case!(|a, b| (a * b).sinh()),
        case!(|a, b| (a * b).cosh()),
        case!(|a, b| (a - b).tanh()),
        case!(|a, b| a.recip() + b),
        case!(|a, b| a.to_radians() + b.to_degrees()),
        case!(|a, b| a.mul_add(b, -a)),
        case!(|a, b| -a * a * a * b),
        case!(|a, b| (a * a + b * b).sqrt()),
        case!(|a, b| (a * a + b * b + 0.1).ln()),
        case!(|a, b| (a * a).ln_1p() * b),
        case!(|a, b| (a * a + 0.2).log10() + (b * b + 0.2).log2()),
        case!(|a, b| (a * a + 0.1).powf(b)),
        case!(|a, b| (0.3 * a).asin() + b),
        case!(|a, b| (0.3 * b).acos() * a),
        case!(|a, b| (0.2 + a * a).powf(Partials::constant(1.5)) + b),
        case!(|a, b| 100.0 * (1e3 * a).sin() + b),
        case!(|a, b| (a - a * b) / (1.0 + a.abs() + b.abs())),
    ]
}

/// Numbers that share nothing with the code: parts of the golden section.
fn sample(number: u32) -> f64 {
    (f64::from(number) * 0.618_033_988_749_894_9).fract()
}

/// Values and slopes at random places of random boxes are in their intervals; boxes of all widths, about zero too. A slope is looked at where it is one: not at a kink.
#[test]
fn what_is_in_a_box_is_in_its_interval() {
    let mut number = 0;
    let mut next = || {
        number += 1;
        sample(number)
    };
    let mut known = 0;
    for width in [0.0, 1e-12, 1e-6, 1e-2, 0.3, 2.0] {
        for _ in 0..60 {
            let [a, b] = [4.0 * next() - 2.0, 4.0 * next() - 2.0];
            let [from, to] = [[a, b], [a + width * next(), b + width * next()]];
            let fields = [Interval::between(from[0], to[0]), Interval::between(from[1], to[1])];
            for Case { name, plain, enclosed } in &cases() {
                let whole = enclosed(Partials::variable(fields[0], 0), Partials::variable(fields[1], 1));
                known += u32::from(whole.value.low.is_finite());
                for _ in 0..8 {
                    let [x, y]: [f64; 2] = core::array::from_fn(|k| {
                        let within = from[k] + next() * (to[k] - from[k]);
                        within.clamp(fields[k].low, fields[k].high)
                    });
                    let one = plain(Partials::variable(x, 0), Partials::variable(y, 1));
                    if whole.value.low.is_nan() {
                        continue;
                    }
                    assert!(whole.value.holds(one.value), "{name} of {fields:?} at {x} {y}: {one:?} {whole:?}");
                    for (slope, all) in one.partials.into_iter().zip(whole.partials) {
                        let rounding = 1e-9 * (1.0 + slope.abs());
                        let is_in = all.low.is_nan() || all.low - rounding <= slope && slope <= all.high + rounding;
                        assert!(is_in, "{name} of {fields:?} at {x} {y}: {one:?} {whole:?}");
                    }
                }
            }
        }
    }
    assert!(known > 11_000, "{known}");
}

/// An interval is no wider than it must be: the ends of what is monotone are those of plain numbers, but for a few neighbours.
#[test]
fn ends_are_attained_by_what_is_monotone() {
    let of = Interval::between(0.25, 0.5);
    for (function, ends) in [
        (Function::Sqrt, [0.5, 0.5_f64.sqrt()]),
        (Function::Ln, [0.25_f64.ln(), 0.5_f64.ln()]),
        (Function::Acos, [0.5_f64.acos(), 0.25_f64.acos()]),
        (Function::Sin, [0.25_f64.sin(), 0.5_f64.sin()]),
        (Function::Cos, [0.5_f64.cos(), 0.25_f64.cos()]),
        (Function::Tan, [0.25_f64.tan(), 0.5_f64.tan()]),
    ] {
        let found = of.of(function);
        for (end, known) in [found.low, found.high].into_iter().zip(ends) {
            assert!((end - known).abs() <= 5.0 * f64::EPSILON * known.abs(), "{function:?}: {found:?}");
        }
    }
    // turning points are in it, and nothing beyond them
    let quarter = Interval::between(1.5, 1.6).of(Function::Sin);
    assert_eq!(quarter.high, 1.0);
    assert!(quarter.low > 0.99);
    assert_eq!(Interval::between(-0.1, 0.1).of(Function::Cosh).low, 1.0);
    // what is zero stays zero
    let (zero, any) = (Interval::point(0.0), Interval::between(-3.0, 5.0));
    assert!((zero * any).is_zero() && (any * zero).is_zero() && (zero / of).is_zero());
    assert!((Interval::point(0.1) - Interval::point(0.1)).is_zero());
    // and what is too small for a number does not become nothing
    let tiny = Interval::between(0.0, 1e-200);
    assert!((tiny * tiny).high > 0.0 && (tiny / Interval::point(1e200)).high > 0.0);
    assert_eq!(Interval::between(0.0, 2.0).whole_power(2.0).low, 0.0);
}

#[test]
fn what_is_not_defined_in_all_of_a_box_is_not_a_number() {
    let across = Interval::between(-1.0, 1.0);
    for function in [Function::Sqrt, Function::Ln, Function::Log2] {
        assert!(across.of(function).low.is_nan(), "{function:?}");
    }
    assert!(Interval::between(0.5, 1.5).of(Function::Asin).high.is_nan());
    assert!(across.of(Function::Sqrt).lesser(Interval::point(0.0)).low.is_nan());
    assert!((across.of(Function::Sqrt) * Interval::point(0.0)).low.is_nan());
    let poles = [Interval::point(1.0) / across, Interval::between(1.5, 1.6).of(Function::Tan)];
    assert!(poles.iter().all(|none| none.low.is_nan() && none.high.is_nan()));
    assert_eq!(across.partial_cmp(&Interval::point(0.5)), None);
    assert!(across < Interval::point(1.5) && Interval::point(2.0) == Interval::point(2.0));
}

/// The four operations on single numbers hold their result in two words, which no rounding of one word shows.
#[test]
fn ends_are_rounded_outwards() {
    let (mut number, mut strict) = (0, 0);
    for _ in 0..2000 {
        number += 2;
        let [a, b] = [sample(number) - 0.4, 3.0 * sample(number + 1) - 1.0];
        let [one, other] = [a, b].map(Interval::point);
        let [x, y] = [a, b].map(DoubleDouble::from_f64);
        for (found, exact) in [(one + other, x + y), (one - other, x - y), (one * other, x * y), (one / other, x / y)] {
            let [low, high] = [found.low, found.high].map(DoubleDouble::from_f64);
            assert!(low <= exact && exact <= high, "{a} {b}: {found:?} {exact:?}");
            assert!(found.high - found.low <= 4.0 * f64::EPSILON * found.high.abs(), "{found:?}");
            strict += u32::from(low < exact && exact < high);
        }
    }
    assert!(strict > 7000, "{strict}");
}
