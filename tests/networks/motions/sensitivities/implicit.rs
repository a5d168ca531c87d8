//! How a root moves with the fields of a model, from the determinant of the overall matrix alone: `dx/dp = -(∂Δ/∂p)/(∂Δ/∂x)`.

use mstmm::number::{DoubleDouble, Oscillation, Scaled};

/// The determinant as a function of the fields and of the frequency.
pub(super) trait Determinant<S>: Fn(&[f64], S) -> Scaled<S> {}

impl<S, F: Fn(&[f64], S) -> Scaled<S>> Determinant<S> for F {}

/// A step of 2^-18 of a number, which is a power of two, so that arguments and weights are what they are meant to be.
///
/// It is small beside the distances of close roots, among which Δ is no polynomial of fourth degree, and large enough for formulas of
/// fields, which are rounded to 16 digits where they are not exact.
fn step(number: f64) -> f64 {
    2.0_f64.powi(number.abs().log2().floor() as i32 - 18)
}

/// The first derivative, as a multiple of a power of two, from four values: exact to the fourth power of the step.
fn slope<S: Oscillation<DoubleDouble>>(exponent: i64, step: f64, value: impl Fn(f64) -> Scaled<S>) -> S {
    let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(|steps| over(value(steps * step), exponent));
    (S::from_f64(8.0) * (above - below) - (far_above - far_below)) / S::from_f64(12.0 * step)
}

/// A number over a power of two.
fn over<S: Oscillation<DoubleDouble>>(number: Scaled<S>, exponent: i64) -> S {
    number.mantissa().times_power_of_two((number.exponent() - exponent) as i32)
}

/// The derivatives of a root with respect to all fields, and the root in twice the digits, given a root in 16 digits.
pub(super) fn derivatives<S: Oscillation<DoubleDouble>>(
    determinant: impl Determinant<S>,
    fields: &[f64],
    root: S,
) -> (Vec<S>, S) {
    let width = step(root.modulus());
    // Δ varies by powers of two far beyond the range of a number: all are taken over one of them
    let exponent = determinant(fields, root + S::from_f64(width)).exponent();
    let by_root = |at: S| slope(exponent, width, |away| determinant(fields, at + S::from_f64(away)));
    // the slope is right to a part of 1e-12, and each step has so many digits more
    let (mut at, first) = (root, by_root(root));
    for _ in 0..2 {
        at = at - over(determinant(fields, at), exponent) / first;
    }
    let by_root = by_root(at);
    let by_field = |field: usize| {
        slope(exponent, step(fields[field]), |away| {
            let mut changed = fields.to_vec();
            changed[field] += away;
            determinant(&changed, at)
        })
    };
    ((0..fields.len()).map(|field| -(by_field(field) / by_root)).collect(), at)
}
