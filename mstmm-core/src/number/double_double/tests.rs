//! Against arithmetic of 500 bits (`dashu-float`), and identities that hold exactly.

use crate::elements::shared::krylov::krylov;
use crate::number::double_double::DoubleDouble;
use crate::number::dual::Dual;
use crate::number::frequency::{ComplexFrequency, Frequency, Parameter, Real};
use crate::number::scalar::Scalar;
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use num_complex::Complex;
use num_traits::{One, Zero};
use proptest::prelude::*;

mod text;

type Exact = FBig<HalfEven, 2>;

/// 2^-106, half a unit in the last of 106 places: what one perfect rounding may cost.
const UNIT: f64 = 1.232_595_164_407_831e-32;

/// The proven bound of a sum is 3 units, of a square root 25/8.
const SUM: f64 = 3.0;
const ROOT: f64 = 3.125;

/// The proven bound of a product is 5 units.
const PRODUCT: f64 = 5.0;

/// Long division rounds but once, after two exact digits; the third is good to 2^-53 of itself.
const QUOTIENT: f64 = 1.000_001;

/// Reduction of the argument, and one sum with 1 or the argument, whose other term is below a third of it and carries
/// two products and one sum.
const FUNCTION: f64 = 2.0 * SUM + (PRODUCT + PRODUCT + SUM) / 3.0;

/// An exponential, its reciprocal, and the sum or difference of the two: this is up to 1.3 times smaller than `ch x`.
const HYPERBOLIC: f64 = 1.4 * (FUNCTION + QUOTIENT + SUM);

fn exact_double(value: f64) -> Exact {
    Exact::try_from(value).unwrap().with_precision(500).value()
}

fn exact(value: DoubleDouble) -> Exact {
    let (hi, lo) = value.parts();
    exact_double(hi) + exact_double(lo)
}

fn nearest(value: &Exact) -> DoubleDouble {
    let hi = value.to_f64().value();
    DoubleDouble::from_sum(hi, (value - exact_double(hi)).to_f64().value())
}

/// `|actual - expected| <= estimate · UNIT · scale`, and that the parts are normalised.
#[track_caller]
fn assert_near(actual: DoubleDouble, expected: &Exact, scale: f64, estimate: f64) {
    let (hi, lo) = actual.parts();
    assert_eq!(hi + lo, hi, "not normalised");
    let difference = (exact(actual) - expected).to_f64().value().abs();
    let error = if difference == 0.0 { 0.0 } else { difference / (UNIT * scale) };
    assert!(error <= estimate, "{actual} is off by {error} units of {scale:e}, not {estimate}");
}

/// `|actual - expected| <= estimate · UNIT · |expected|`.
#[track_caller]
fn assert_equal(actual: DoubleDouble, expected: &Exact, estimate: f64) {
    assert_near(actual, expected, expected.to_f64().value().abs(), estimate);
}

/// Numbers with 106 random bits.
fn numbers(limit: f64) -> impl Strategy<Value = DoubleDouble> {
    (-limit..limit, -1.0..1.0).prop_map(|(hi, lo)| DoubleDouble::from_sum(hi, hi * lo * f64::EPSILON / 2.0))
}

/// Numbers of any size that has all digits.
fn sizes() -> impl Strategy<Value = DoubleDouble> {
    (numbers(1.0), -400..400).prop_map(|(number, exponent)| number.times_power_of_two(exponent))
}

proptest! {
    #[test]
    fn sums_and_products_of_two_doubles_are_exact(a in -1e9..1e9f64, b in -1.0..1.0f64, exponent in -300..300) {
        let b = b.times_power_of_two(exponent);
        prop_assert_eq!(exact(DoubleDouble::from_sum(a, b)), exact_double(a) + exact_double(b));
        prop_assert_eq!(exact(DoubleDouble::from_sum(b, a)), exact_double(a) + exact_double(b));
        prop_assert_eq!(exact(DoubleDouble::from_product(a, b)), exact_double(a) * exact_double(b));
    }

    #[test]
    fn arithmetic(a in sizes(), b in sizes()) {
        assert_equal(a * b, &(exact(a) * exact(b)), PRODUCT);
        assert_equal(a / b, &(exact(a) / exact(b)), QUOTIENT);
        assert_equal(a + b, &(exact(a) + exact(b)), SUM);
    }

    /// Where most digits cancel, the rest still is relatively exact.
    #[test]
    fn cancelling_sums(a in numbers(1.0), part in numbers(1.0), exponent in -110..0) {
        let b = -a * (DoubleDouble::one() + part.times_power_of_two(exponent));
        assert_equal(a + b, &(exact(a) + exact(b)), SUM);
        prop_assert!((a - a).is_zero());
    }

    #[test]
    fn remainders(a in numbers(1e6), b in numbers(10.0)) {
        let rest = a % b;
        prop_assert!(rest.abs() < b.abs());
        prop_assert!(rest.is_zero() || (rest < DoubleDouble::zero()) == (a < DoubleDouble::zero()));
        let quotient = (exact(a) - exact(rest)) / exact(b);
        let whole = quotient.round();
        // the product with the quotient, and the difference
        assert_near(rest, &(exact(a) - whole * exact(b)), a.size(), PRODUCT + SUM);
    }

    #[test]
    fn square_roots(x in sizes()) {
        let x = x.abs();
        assert_equal(x.sqrt(), &exact(x).sqrt(), ROOT);
        assert_equal(x.sqrt() * x.sqrt(), &exact(x), 2.0 * ROOT + PRODUCT);
    }

    /// A square whose root has 53 bits is exact, and so is the way back.
    #[test]
    fn roots_of_exact_squares(x in 1e-9..1e9f64) {
        prop_assert_eq!(DoubleDouble::from_product(x, x).sqrt(), DoubleDouble::from(x));
    }

    #[test]
    fn exponentials(x in numbers(700.0), small in numbers(1.0)) {
        // `exp(-700)` has no room for 106 bits
        let x = if x.size() < 600.0 { x } else { x.abs() };
        assert_equal(x.exp(), &exact(x).exp(), FUNCTION);
        assert_equal(small.exp(), &exact(small).exp(), FUNCTION);
    }

    #[test]
    fn sines_and_cosines(x in prop_oneof![numbers(2.0), numbers(100.0), numbers(1e4), numbers(1e15)]) {
        let (sin, cos) = x.sin_cos();
        let (exact_sin, exact_cos) = exact(x).sin_cos();
        assert_equal(sin, &exact_sin, FUNCTION);
        assert_equal(cos, &exact_cos, FUNCTION);
    }

    #[test]
    fn sines_next_to_their_zeros(k in -6000..6000_i32, rest in numbers(1e-6)) {
        let x = nearest(&(exact_double(f64::from(k)) * exact_double(-1.0).acos())) + rest;
        assert_equal(x.sin_cos().0, &exact(x).sin(), FUNCTION);
    }

    #[test]
    fn hyperbolic_functions(x in prop_oneof![numbers(1.0), numbers(4.0), numbers(500.0)]) {
        let (sinh, cosh) = x.sinh_cosh();
        let (exact_sinh, exact_cosh) = exact(x).sinh_cosh();
        assert_equal(sinh, &exact_sinh, HYPERBOLIC);
        assert_equal(cosh, &exact_cosh, HYPERBOLIC);
    }

    /// Both sides of the switch; closed forms of 500 bits lose nothing that counts.
    #[test]
    fn beam_functions(z in prop_oneof![0.01..1.0f64, 1.0..50.0f64]) {
        let z4 = DoubleDouble::from_product(z, z) * DoubleDouble::from_product(z, z);
        let z = exact(z4).sqrt().sqrt();
        let ((sin, cos), (sinh, cosh)) = (z.sin_cos(), z.sinh_cosh());
        let (two, z2) = (exact_double(2.0), &z * &z);
        let expected = [
            (&cosh + cos) / &two,
            (&sinh + &sin) / (&two * &z),
            (&cosh - z.cos()) / (&two * &z2),
            (sinh - sin) / (two * &z * z2),
        ];
        for (k, (function, expected)) in krylov(z4).into_iter().zip(expected).enumerate() {
            // the closed forms of U and V lose up to three bits next to z = 1, and the phase some units of `z`
            let scale = (expected.to_f64().value().abs() + if k < 2 { 1.0 } else { 2.0 }) * (1.0 + z.to_f64().value());
            assert_near(function, &expected, scale, HYPERBOLIC);
        }
    }
}

#[test]
fn reciprocal_factorials_are_rounded_once() {
    let mut factorial = exact_double(1.0);
    for n in 0..=4 * DoubleDouble::SERIES_TERMS {
        factorial = if n > 0 { factorial * exact_double(n as f64) } else { factorial };
        assert_equal(DoubleDouble::reciprocal_factorial(n), &(exact_double(1.0) / &factorial), QUOTIENT);
    }
}

/// At `|x| = 1`, the term after the last is below half a unit.
#[test]
fn the_series_has_enough_terms() {
    let next = DoubleDouble::reciprocal_factorial(4 * DoubleDouble::SERIES_TERMS).to_f64();
    assert!(next < UNIT / 2.0 && 4f64.powi(10) * next < UNIT / 2.0);
    // ch c at z = 1, by the series of `-4 z⁴`
    let [product, ..] = DoubleDouble::one().short_wave_products();
    let one = exact_double(1.0);
    assert_near(product, &(one.cosh() * one.cos()), 1.0, FUNCTION);
}

#[test]
fn constants_in_parts_are_those_of_the_functions() {
    let pi = "3.14159265358979323846264338327950288".parse::<DoubleDouble>().unwrap();
    assert_equal(pi, &exact_double(-1.0).acos(), QUOTIENT);
    assert!((pi.sin_cos().0).size() < 4.0 * UNIT);
    let ten = DoubleDouble::from(10.0);
    assert!(
        ("2.30258509299404568401799145468436421".parse::<DoubleDouble>().unwrap().exp() - ten).size()
            < 10.0 * FUNCTION * UNIT
    );
}

#[test]
fn order_equality_and_truncation_see_both_parts() {
    let one = DoubleDouble::one();
    let more = DoubleDouble::from_sum(1.0, 1e-20);
    let less = DoubleDouble::from_sum(1.0, -1e-20);
    assert!(less < one && one < more && less != more && -more < -one);
    assert_eq!(DoubleDouble::from(-0.0), DoubleDouble::zero());
    assert!(DoubleDouble::from(f64::NAN).partial_cmp(&one).is_none());
    let truncated = |hi, lo| DoubleDouble::from_sum(hi, lo).truncated().parts();
    assert_eq!(truncated(1.0, -1e-20), (0.0, 0.0));
    assert_eq!(truncated(-1.0, 1e-20), (0.0, 0.0));
    assert_eq!(truncated(-1.0, -1e-20), (-1.0, 0.0));
    assert_eq!(truncated(2.75, 0.0), (2.0, 0.0));
    assert_eq!(truncated(1e20, -2.5), (1e20, -3.0));
    assert_eq!(truncated(-1e20, -2.5), (-1e20, -2.0));
    assert_eq!(truncated(-1e20, 0.0), (-1e20, 0.0));
}

#[test]
fn ends_of_the_range() {
    let number = DoubleDouble::from_f64;
    assert_eq!(number(800.0).exp().to_f64(), f64::INFINITY);
    assert_eq!(number(-800.0).exp().to_f64(), 0.0);
    assert!(number(f64::NAN).exp().to_f64().is_nan());
    assert_eq!((number(1.0) / number(0.0)).to_f64(), f64::INFINITY);
    assert_eq!((number(1.0) / number(f64::INFINITY)).to_f64(), 0.0);
    assert!((number(0.0) / number(0.0)).to_f64().is_nan());
    assert_eq!(number(0.0).sqrt(), number(0.0));
    assert_eq!(number(f64::INFINITY).sqrt().to_f64(), f64::INFINITY);
    assert!(number(-1.0).sqrt().to_f64().is_nan());
    for angle in [f64::INFINITY, f64::NAN, 1e16] {
        assert!(number(angle).sin_cos().0.size().is_nan() && number(angle).sin_cos().1.size().is_nan());
    }
    assert_eq!(number(0.0).sin_cos(), (number(0.0), number(1.0)));
    assert_eq!(number(0.0).sinh_cosh(), (number(0.0), number(1.0)));
}

/// The first root of `ch z cos z = -1`, the cantilever, by Newton's rule with dual numbers: what the searches do.
#[test]
fn scalars_over_double_doubles() {
    fn frequency<S: Frequency<DoubleDouble>>() {}
    fn complex_frequency<S: ComplexFrequency<DoubleDouble>>() {}
    fn real<T: Real + Frequency<T>>() {}
    real::<DoubleDouble>();
    real::<Dual<DoubleDouble>>();
    frequency::<Dual<DoubleDouble>>();
    complex_frequency::<Complex<DoubleDouble>>();
    complex_frequency::<Dual<Complex<DoubleDouble>>>();

    let mut root = DoubleDouble::from(1.875);
    for _ in 0..4 {
        let waves = Dual::variable(root).wave_functions();
        let value = waves.ch * waves.cos + waves.one;
        root -= value.value / value.derivative;
    }
    let expected = "1.8751040687119611664453082410782141626".parse::<DoubleDouble>().unwrap();
    assert!((root - expected).size() < FUNCTION * UNIT * 4.0);
    let waves = Complex::from_parameter(root).wave_functions();
    assert!((waves.ch * waves.cos + waves.one).size() < FUNCTION * UNIT * 8.0);
}
