//! Digits that the determinant and the certified search keep, against mode number and against stiffness.

use crate::error::ReportError;
use mstmm::number::{DoubleDouble, Parameter, Scalar};
use mstmm::prelude::*;
use mstmm::search::System;
use std::f64::consts::PI;

/// Points on either side of a root at which the determinant should have one sign.
const PARTS: u32 = 16;
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

system! {
    /// Soft and stiff beam with m = l = 1 in a row, pinned at both ends and between; EI of the soft one is 1.
    struct SoftAndStiff { ratio: f64 }
    pinned -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 2
           -> beam 3 { length: 1.0, bending_stiffness: ratio, mass_per_length: 1.0 }
           -> pinned;
    pinned -> conn 2
}

/// Correct digits of a root by both ways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Digits {
    /// Mode number or stiffness ratio.
    pub(crate) at: f64,
    /// Of a bisection on the sign of the overall determinant; none where its signs show no root, or more than the one that is there.
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

/// Digits against a ratio of stiffnesses.
#[derive(Clone, Debug)]
pub(crate) struct OverStiffness {
    /// Of the first mode of a cantilever with a tip spring.
    pub(crate) tip_spring: Vec<Digits>,
    /// Of two spans, where the stiff one begins to bend.
    pub(crate) spans: Vec<Digits>,
}

/// Digits for ratios of 10ⁿ, those of the spans where it is no less than 1.
pub(crate) fn over_stiffness(exponents: &[i32]) -> Result<OverStiffness, ReportError> {
    let ratios: Vec<i32> = exponents.iter().copied().filter(|&exponent| exponent >= 0).collect();
    Ok(OverStiffness { tip_spring: of_tip_spring(exponents)?, spans: of_spans(&ratios)? })
}

/// Digits of the first mode of a cantilever whose tip spring is as stiff as 10ⁿ EI/l³.
fn of_tip_spring(exponents: &[i32]) -> Result<Vec<Digits>, ReportError> {
    let row = |&exponent: &i32| {
        let stiffness = 10f64.powi(exponent);
        digits(&TipSpring { stiffness }.build()?, stiffness, tip_spring(stiffness), 0.1)
    };
    exponents.iter().map(row).collect()
}

/// Digits of the mode of two spans next above the first of the stiff one alone, which is stiffer than the soft one by 10ⁿ.
fn of_spans(exponents: &[i32]) -> Result<Vec<Digits>, ReportError> {
    let row = |&exponent: &i32| {
        let ratio = 10f64.powi(exponent);
        let exact = two_spans(ratio);
        // less than the distance to the next mode of the soft span
        digits(&SoftAndStiff { ratio }.build()?, ratio, exact, 0.5 / exact.sqrt())
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
    let determinant = if is_noise(sign, exact, share) { None } else { bisection(sign, ends).map(correct) };
    Ok(Digits { at, determinant, planes })
}

/// Whether a function with a single root in a bracket changes its sign elsewhere, too, or is not a number.
fn is_noise(sign: impl Fn(f64) -> f64, root: f64, share: f64) -> bool {
    let above = |part: u32| sign(root * (1.0 + share * f64::from(part) / f64::from(PARTS)));
    let below = |part: u32| sign(root * (1.0 - share * f64::from(part) / f64::from(PARTS)));
    let agree = |first: f64, other: f64| first * other > 0.0;
    !(1..=PARTS).all(|part| agree(above(part), above(PARTS)) && agree(below(part), below(PARTS)))
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
        sin - cos * tanh(z)
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

/// ω of the mode of two spans next above π² √(ratio), where the stiff span alone has its first: turns of the joint by a moment on both
/// sides add up to none, `Σ (coth z - cot z)/(z EI) = 0`, once between neighbouring multiples of π of the soft span, ω = z².
fn two_spans(ratio: f64) -> f64 {
    let shorter = DoubleDouble::from(ratio).sqrt().sqrt();
    let multiple = shorter.to_f64().floor() + 1.0;
    let turn = |z: DoubleDouble, stiffness: f64| {
        let (sin, cos) = z.sin_cos();
        (DoubleDouble::from(1.0) / tanh(z) - cos / sin) / (z * DoubleDouble::from(stiffness))
    };
    square_of_root([multiple * PI + 0.1, (multiple + 1.0) * PI - 0.1], |z| turn(z, 1.0) + turn(z / shorter, ratio))
}

/// The hyperbolic tangent.
fn tanh(z: DoubleDouble) -> DoubleDouble {
    // beyond it is 1 in 32 digits, too
    if z.to_f64() < 40.0 { z.sinh_cosh().0 / z.sinh_cosh().1 } else { DoubleDouble::from(1.0) }
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
        // of equal spans: that of one alone, pinned and clamped
        assert_eq!(two_spans(1.0), fixed_pinned(2));
    }

    #[test]
    fn the_search_keeps_what_the_determinant_loses() {
        let [first, sixth, hundredth] = over_modes(&[1, 6, 100]).unwrap()[..] else { panic!("three modes") };
        assert!(first.determinant.unwrap() > 15.0);
        assert!(sixth.determinant.unwrap() < 11.0);
        assert!(hundredth.determinant.is_none_or(|digits| digits < 5.0));
        assert!([first, sixth, hundredth].iter().all(|row| row.planes > 15.0));
        let OverStiffness { tip_spring, spans } = over_stiffness(&[-15, 0, 3, 6, 12]).unwrap();
        assert_eq!((tip_spring.len(), spans.len()), (5, 4));
        assert!(tip_spring.iter().chain(&spans).all(|row| row.planes > 15.0), "{spans:?}");
        // a ratio alone is no difficulty; waves of the soft span are
        assert!(tip_spring.iter().all(|row| row.determinant.is_some_and(|digits| digits > 14.0)));
        assert!(spans[1].determinant.unwrap() < 10.0 && spans[2].determinant.is_none_or(|digits| digits < 4.0));
    }
}
