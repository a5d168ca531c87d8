//! The plain method: zeros of the determinant of the overall matrix, separated by a grid and polished one by one.

use crate::brent;
use crate::found::Found;
use core::ops::RangeInclusive;
use mstmm::number::{Magnitude, Scaled};
use mstmm::prelude::*;
use std::cell::Cell;

/// The value in units of `2^exponent`.
fn in_units<S: mstmm::number::Scalar>(value: Scaled<S>, exponent: i64) -> S {
    // beyond these shifts the value is zero or infinite anyway
    value.mantissa().times_power_of_two((value.exponent() - exponent).clamp(-2000, 2000) as i32)
}

/// Sign changes of the overall determinant on a grid of `points` that are equally spaced in the square root of ω, as its
/// zeros nearly are, each polished by Brent's method.
pub fn line(system: &impl Evaluate<f64>, range: &RangeInclusive<f64>, points: usize, tolerance: f64) -> Found {
    let evaluations = Cell::new(0);
    let evaluate = |omega: f64| {
        evaluations.set(evaluations.get() + 1);
        system.overall_determinant(omega)
    };
    let (start, end) = (range.start().sqrt(), range.end().sqrt());
    let mut found = Found::new(0);
    let mut before = (*range.start(), evaluate(*range.start()));
    for k in 1..points {
        let root = start + (end - start) * k as f64 / (points - 1) as f64;
        let point = (root * root, evaluate(root * root));
        if (before.1.mantissa() < 0.0) != (point.1.mantissa() < 0.0) {
            let unit = before.1.exponent().max(point.1.exponent());
            let function = |omega| in_units(evaluate(omega), unit);
            let [start, end] = [before, point].map(|sample| (sample.0, in_units(sample.1, unit)));
            found.push(Complex::new(0.0, brent::zero(start, end, tolerance, function)));
        }
        before = point;
    }
    found.evaluations = evaluations.get();
    found
}

/// A search along a line of constant real part: minima of the modulus on a grid, each polished by Muller's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Real part of the line [1/s].
    pub re: f64,
    /// Points of the grid, equally spaced in the square root of the imaginary part.
    pub points: usize,
}

/// Roots of the overall determinant near a line, up to the imaginary part `end`.
///
/// Muller's parabola through the last three points needs no derivative and gains 1.84 times as many digits a step.
pub fn strip(system: &impl Evaluate<Complex<f64>>, line: Line, end: f64, tolerance: f64) -> Found {
    let evaluations = Cell::new(0);
    let evaluate = |lambda: Complex<f64>| {
        evaluations.set(evaluations.get() + 1);
        system.overall_determinant(lambda)
    };
    let point = |k: usize| Complex::new(line.re, end * (k as f64 / line.points as f64).powi(2));
    let mut found = Found::new(0);
    let sample = |k: usize| (point(k), evaluate(point(k)));
    let mut samples = [sample(0), sample(1), sample(2)];
    for k in 3..=line.points + 1 {
        let [before, middle, after] = samples.map(|sample| Magnitude::from(sample.1));
        if middle < before && middle <= after {
            let root = muller(evaluate, samples, tolerance);
            let is_known = found.roots().iter().any(|known| (known - root).norm() <= 1e-3 * root.norm());
            if !is_known && root.im > 0.0 {
                found.push(root);
            }
        }
        samples = [samples[1], samples[2], sample(k)];
    }
    found.evaluations = evaluations.get();
    found.sorted()
}

type Sample = (Complex<f64>, Scaled<Complex<f64>>);

/// Muller's method from three samples, until a step is shorter than a tolerance, relative to the root.
fn muller(evaluate: impl Fn(Complex<f64>) -> Scaled<Complex<f64>>, start: [Sample; 3], tolerance: f64) -> Complex<f64> {
    let [mut a, mut b, mut c] = [start[0], start[2], start[1]];
    for _ in 0..50 {
        let unit = c.1.exponent();
        let [fa, fb, fc] = [a, b, c].map(|sample| in_units(sample.1, unit));
        let (first, second) = ((fb - fc) / (b.0 - c.0), (fa - fb) / (a.0 - b.0));
        let curvature = (second - first) / (a.0 - c.0);
        let slope = first + (c.0 - b.0) * curvature;
        let root = (slope * slope - curvature * fc * 4.0).sqrt();
        let divisor = if (slope + root).norm() > (slope - root).norm() { slope + root } else { slope - root };
        let step = fc * -2.0 / divisor;
        let next = c.0 + step;
        if step.norm() <= tolerance * next.norm() {
            return next;
        }
        (a, b, c) = (b, c, (next, evaluate(next)));
    }
    c.0
}
