//! The two sides of a ratio on a piece of a band: polynomials by their Chebyshev series, and products over poles.

use crate::number::{List, Scalar, modulus};
use num_complex::Complex;
use num_traits::Zero;

/// Room for the coefficients of a polynomial.
pub(crate) const ROOM: usize = 48;
/// Most poles that are divided out of a piece, with multiplicity. Each makes values on the ellipse up to three times as large as on the piece.
pub(crate) const MOST_POLES: usize = 8;

type C = Complex<f64>;

/// The coefficients of a polynomial.
pub(crate) type Coefficients = List<C, ROOM>;

/// A pole in the variable x of a piece, and the radius within which it is known.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pole {
    pub(crate) x: C,
    pub(crate) radius: f64,
}

/// A side of the ratio on a piece, in its variable x from -1 to 1.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::large_enum_variant, reason = "there are two, on the stack")]
pub(crate) enum Side {
    /// A response times the product over the poles: a Chebyshev series, and a bound of its error.
    Series { coefficients: Coefficients, error: f64 },
    /// The product over the poles alone.
    Product(List<Pole, MOST_POLES>),
}

/// A side about a point: its Taylor coefficients in `t = (x - x0)/s`, t from -1 to 1, and bounds of its error there.
pub(crate) struct Local {
    pub(crate) coefficients: Coefficients,
    /// As a part of the value.
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

/// Zeros of the Chebyshev polynomial of degree `count`, from 1 down.
pub(crate) fn node(count: usize, number: usize) -> f64 {
    cosine(2 * number + 1, count)
}

/// Extrema of that polynomial, between its zeros, from 1 down.
pub(crate) fn extremum(count: usize, number: usize) -> f64 {
    cosine(2 * number, count)
}

/// `cos(m π/2n)`.
fn cosine(m: usize, n: usize) -> f64 {
    let angle = core::f64::consts::FRAC_PI_2 * ((m % (4 * n)) as f64 / n as f64);
    Scalar::sin_cos(angle).1
}

/// The coefficients of the polynomial through values at the zeros of a Chebyshev polynomial.
pub(crate) fn series_through(values: &[C]) -> Coefficients {
    let count = values.len();
    let mut coefficients = List::new();
    for k in 0..count {
        let weight = if k == 0 { 1.0 } else { 2.0 } / count as f64;
        let sum: C = values.iter().enumerate().map(|(j, value)| value * cosine(k * (2 * j + 1), count)).sum();
        push(&mut coefficients, sum * weight);
    }
    coefficients
}

/// Adds to a list that has room: no polynomial is of a higher degree than the list holds.
fn push<V: Copy + Default, const CAP: usize>(list: &mut List<V, CAP>, value: V) {
    let is_full = list.push(value).is_err();
    debug_assert!(!is_full, "a list of {CAP} is full");
}

impl Side {
    /// The value at x.
    pub(crate) fn value(&self, x: f64) -> C {
        match self {
            Side::Series { coefficients, .. } => series_at(coefficients, x),
            Side::Product(poles) => product_at(poles, C::from(x)),
        }
    }

    /// The side about x0, up to a distance s.
    pub(crate) fn about(&self, x0: f64, s: f64) -> Local {
        match self {
            Side::Series { coefficients, error } => {
                Local { coefficients: series_about(coefficients, x0, s), relative: 0.0, absolute: *error }
            }
            Side::Product(poles) => {
                let mut coefficients = List::new();
                push(&mut coefficients, C::from(1.0));
                let mut relative = 0.0;
                for pole in poles {
                    let from = C::from(x0) - pole.x;
                    push(&mut coefficients, C::zero());
                    let terms = coefficients.as_mut_slice();
                    for k in (0..terms.len()).rev() {
                        terms[k] = terms[k] * from + if k > 0 { terms[k - 1] * s } else { C::zero() };
                    }
                    relative += part_of(pole.radius, distance(pole.x, x0, s));
                }
                Local { coefficients, relative, absolute: 0.0 }
            }
        }
    }
}

/// The product over poles at a point.
pub(crate) fn product_at(poles: &[Pole], x: C) -> C {
    poles.iter().fold(C::from(1.0), |product, pole| product * (x - pole.x))
}

/// The distance of a pole from the part of the real axis from `x0 - s` to `x0 + s`.
fn distance(pole: C, x0: f64, s: f64) -> f64 {
    let beside = ((pole.re - x0).abs() - s).max(0.0);
    modulus(C::new(beside, pole.im))
}

/// Bound of `|(x - y)/(x - z) - 1|` at a distance of x from z, where y is within the radius of z; infinite within the radius.
pub(crate) fn part_of(radius: f64, distance: f64) -> f64 {
    if radius < distance { radius / (distance - radius) } else { f64::INFINITY }
}

/// A Chebyshev series at x: Clenshaw's recursion.
pub(crate) fn series_at(series: &[C], x: f64) -> C {
    let (mut next, mut after) = (C::zero(), C::zero());
    for &coefficient in series.iter().skip(1).rev() {
        (next, after) = (coefficient + next * (2.0 * x) - after, next);
    }
    series[0] + next * x - after
}

/// A Chebyshev series as a polynomial in `t = (x - x0)/s`: Clenshaw's recursion, in polynomials.
fn series_about(series: &[C], x0: f64, s: f64) -> Coefficients {
    let mut next: [C; ROOM] = [C::zero(); ROOM];
    let mut after = next;
    let degree = series.len() - 1;
    for (k, &coefficient) in series.iter().enumerate().rev() {
        // x b for the last term, 2 x b for others
        let twice = if k == 0 { 1.0 } else { 2.0 };
        let order = degree - k;
        let mut new = [C::zero(); ROOM];
        for m in 0..=order {
            let shifted = if m > 0 { next[m - 1] * s } else { C::zero() };
            new[m] = (next[m] * x0 + shifted) * twice - after[m];
        }
        new[0] += coefficient;
        (next, after) = (new, next);
    }
    let mut coefficients = List::new();
    next[..=degree].iter().for_each(|&coefficient| push(&mut coefficients, coefficient));
    coefficients
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Closed form: `1/(x - z)` with a pole beyond the ellipse, at points and about them.
    #[test]
    fn a_series_is_its_function_at_points_and_about_them() {
        let pole = C::new(0.3, 1.9);
        let f = |x: f64| (C::from(x) - pole).inv();
        let values: std::vec::Vec<C> = (0..40).map(|j| f(node(40, j))).collect();
        let side = Side::Series { coefficients: series_through(&values), error: 0.0 };
        for x in [-0.71, 0.0, 0.3, 0.74] {
            assert!((side.value(x) - f(x)).norm() < 1e-14, "{x}");
            let local = side.about(x, 0.25);
            for t in [-1.0, 0.4, 1.0] {
                let at = local.coefficients.iter().rev().fold(C::zero(), |sum, c| sum * t + c);
                assert!((at - f(x + 0.25 * t)).norm() < 1e-14, "{x} {t}");
            }
        }
    }

    #[test]
    fn a_product_about_a_point_is_the_product() {
        let mut poles = List::new();
        for x in [C::new(0.1, 0.2), C::new(-3.0, 0.0), C::new(0.1, 0.2), C::new(0.7, -1.0)] {
            push(&mut poles, Pole { x, radius: 1e-3 });
        }
        let side = Side::Product(poles);
        let local = side.about(0.4, 0.1);
        for t in [-1.0, 0.3, 1.0] {
            let at = local.coefficients.iter().rev().fold(C::zero(), |sum, c| sum * t + c);
            assert!((at - side.value(0.4 + 0.1 * t)).norm() < 1e-15);
        }
        // the nearest points of the part are at 0.3: twice 1e-3 of 0.28, and less of the others
        let [near, far] = [2.0 * 1e-3 / 0.2818, 2.0 * 1e-3 / 0.27];
        assert!(local.relative > near && local.relative < far + 2e-3, "{}", local.relative);
        assert!(part_of(1e-3, 1e-4).is_infinite());
    }
}
