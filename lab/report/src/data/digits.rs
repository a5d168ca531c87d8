//! Digits that the determinant and the certified search keep, against mode number and against stiffness.

use crate::error::ReportError;
use mstmm::number::{DoubleDouble, Parameter, Scalar};
use mstmm::prelude::*;
use mstmm::search::System;
use std::f64::consts::PI;

/// Digits that a double has.
const MOST: f64 = 16.0;
/// `2⁻¹¹⁰`: after as many halvings an interval has the width of a rounding in 32 digits.
const HALVINGS: usize = 110;

system! {
    /// Fixed and pinned beam with EI = m = l = 1.
    struct FixedPinned {}
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned
}

system! {
    /// Cantilever with EI = m = l = 1 and a grounded tip spring.
    struct TipSpring { stiffness: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2 -> free;
    fixed -> spring 3 { stiffness } -> conn 2
}

/// Correct digits of a root by both ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Digits {
    /// Mode number or stiffness ratio.
    pub(crate) at: f64,
    /// Of a bisection on the sign of the overall determinant; none where its signs show no root.
    pub(crate) determinant: Option<f64>,
    /// Of the certified search.
    pub(crate) planes: f64,
}

/// Digits of the modes of a fixed and pinned beam.
pub(crate) fn over_modes(modes: &[u32]) -> Result<Vec<Digits>, ReportError> {
    let system = FixedPinned {}.build()?;
    let row = |&mode: &u32| digits(&system, f64::from(mode), fixed_pinned(mode), 0.2 / f64::from(mode));
    modes.iter().map(row).collect()
}

/// Digits of the first mode of a cantilever whose tip spring is as stiff as 10ⁿ EI/l³.
pub(crate) fn over_stiffness(exponents: &[i32]) -> Result<Vec<Digits>, ReportError> {
    let row = |&exponent: &i32| {
        let stiffness = 10f64.powi(exponent);
        digits(&TipSpring { stiffness }.build()?, stiffness, tip_spring(stiffness), 0.1)
    };
    exponents.iter().map(row).collect()
}

/// Mode numbers up to 1000, spread evenly over the logarithm.
pub(crate) fn mode_numbers() -> Vec<u32> {
    let mut modes: Vec<u32> = (0..=36).map(|n| 10f64.powf(f64::from(n) / 12.0).round() as u32).collect();
    modes.dedup();
    modes
}

fn digits<Y>(system: &Y, at: f64, exact: f64, share: f64) -> Result<Digits, ReportError>
where
    Y: Evaluate<f64> + Undamped + System<Parameter = f64>,
{
    let correct = |omega: f64| -((omega - exact).abs() / exact).max(10f64.powf(-MOST)).log10();
    let ends = [exact * (1.0 - share), exact * (1.0 + share)];
    let found = system.natural_frequencies::<8>(ends[0]..=ends[1])?;
    let planes = found.iter().map(|root| correct(root.omega)).fold(0.0, f64::max);
    let sign = |omega: f64| system.overall_determinant(omega).mantissa();
    Ok(Digits { at, determinant: bisection(sign, ends).map(correct), planes })
}

/// Where a function changes its sign, to rounding; none if it does not, or is not a number on the way.
fn bisection(sign: impl Fn(f64) -> f64, [mut lower, mut upper]: [f64; 2]) -> Option<f64> {
    let (start, end) = (sign(lower), sign(upper));
    let has_root = (start < 0.0 && end > 0.0) || (start > 0.0 && end < 0.0);
    let mut middle = has_root.then_some(lower + (upper - lower) / 2.0)?;
    while middle > lower && middle < upper {
        let value = sign(middle);
        if value.is_nan() {
            return None;
        }
        *if (value > 0.0) == (start > 0.0) { &mut lower } else { &mut upper } = middle;
        middle = lower + (upper - lower) / 2.0;
    }
    Some(middle)
}

/// ω of a mode of a fixed and pinned beam: `tan z = tanh z`, ω = z².
fn fixed_pinned(mode: u32) -> f64 {
    let estimate = (f64::from(mode) + 0.25) * PI;
    square_of_root([estimate - 0.01, estimate + 0.01], |z| {
        let (sin, cos) = z.sin_cos();
        // beyond, tanh z is 1 in 32 digits, too
        let tanh = if z.to_f64() < 40.0 { z.sinh_cosh().0 / z.sinh_cosh().1 } else { DoubleDouble::from(1.0) };
        sin - cos * tanh
    })
}

/// ω of a cantilever with a tip spring: `z³ (1 + cos z cosh z) + k (sin z cosh z - cos z sinh z) = 0`, ω = z².
fn tip_spring(stiffness: f64) -> f64 {
    square_of_root([1.8, 4.0], |z| {
        let ((sin, cos), (sinh, cosh)) = (z.sin_cos(), z.sinh_cosh());
        let free = z * z * z * (DoubleDouble::from(1.0) + cos * cosh);
        free + DoubleDouble::from(stiffness) * (sin * cosh - cos * sinh)
    })
}

/// The square of a root in 32 digits, rounded once.
fn square_of_root([lower, upper]: [f64; 2], function: impl Fn(DoubleDouble) -> DoubleDouble) -> f64 {
    let is_positive = |z| function(z).to_f64() > 0.0;
    let (mut lower, mut upper) = (DoubleDouble::from(lower), DoubleDouble::from(upper));
    let start = is_positive(lower);
    for _ in 0..HALVINGS {
        let middle = (lower + upper) * DoubleDouble::from(0.5);
        *if is_positive(middle) == start { &mut lower } else { &mut upper } = middle;
    }
    (lower * lower).to_f64()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Oracle: values of another method in 18 digits.
    #[test]
    fn closed_forms_give_known_values() {
        assert_eq!(fixed_pinned(1), 15.418205716980061);
        assert_eq!(fixed_pinned(3), 104.24769645886133);
        // this one is rounded four times
        assert!((fixed_pinned(1000) / (1000.25 * PI).powi(2) - 1.0).abs() < 4.0 * f64::EPSILON);
        for (stiffness, omega) in [(1e3, 15.19285111681764), (1e9, 15.418205492152488), (1e15, 15.418205716979836)] {
            assert_eq!(tip_spring(stiffness), omega);
        }
    }

    #[test]
    fn the_search_keeps_what_the_determinant_loses() {
        let [first, sixth, hundredth] = over_modes(&[1, 6, 100]).unwrap()[..] else { panic!("three modes") };
        assert!(first.determinant.unwrap() > 15.0);
        assert!(sixth.determinant.unwrap() < 11.0);
        assert!(hundredth.determinant.is_none_or(|digits| digits < 5.0));
        assert!([first, sixth, hundredth].iter().all(|row| row.planes > 15.0));
        assert!(over_stiffness(&[-15, 0, 15]).unwrap().iter().all(|row| row.planes > 15.0));
    }
}
