//! Whether a ratio stays below a level on a piece of a band.

use crate::number::{List, modulus};
use crate::search::damped::peak::function::{Coefficients, Local, ROOM, Side};
use num_complex::Complex;

/// Least half length of a part, below which rounding decides.
const FINEST: f64 = 1e-13;
/// Units of rounding of a coefficient of `γ² |q|² - |p|²`, a sum of so many products of sums.
const ROUNDINGS: f64 = 4.0 * ROOM as f64;
/// Room for parts that wait: one of each size.
const WAITING: usize = 64;

/// What is known of a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    /// The ratio is below the level on the whole piece.
    Below,
    /// At x the polynomials are above it, over a part of this half length.
    Above { x: f64, s: f64 },
    /// Errors are too large to tell about x.
    Undecided { x: f64 },
}

/// Whether `|f/g|` is below a level on a piece.
pub(crate) fn below(f: &Side, g: &Side, level: f64) -> Verdict {
    let mut waiting = List::<(f64, f64), WAITING>::new();
    let mut part = Some((0.0, 1.0));
    while let Some((x, s)) = part.take().or_else(|| waiting.pop()) {
        let (p, q) = (f.about(x, s), g.about(x, s));
        if is_below(&p, &q, level) {
            continue;
        }
        if p.coefficients[0].norm_sqr() > level * level * q.coefficients[0].norm_sqr() {
            return Verdict::Above { x, s };
        }
        let half = 0.5 * s;
        if half < FINEST || waiting.push((x + half, half)).is_err() {
            return Verdict::Undecided { x };
        }
        part = Some((x - half, half));
    }
    Verdict::Below
}

/// Whether the ratio is below a level on a part, as its polynomials and their errors prove it.
fn is_below(p: &Local, q: &Local, level: f64) -> bool {
    let dividend = p.coefficients.iter().copied().map(modulus).sum::<f64>();
    if dividend + p.absolute <= 0.0 {
        return true;
    }
    // a side has errors of one kind, so that those of the divisor are not enlarged
    let level = level * (1.0 - q.relative) / (1.0 + p.relative);
    let size = q.coefficients.iter().copied().map(modulus).sum::<f64>();
    // a level that is zero or negative, or no number, does not pass
    if !(level > 0.0 && level * size > 0.0) {
        return false;
    }
    let error = (p.absolute / level + q.absolute) / size;
    let [above, below] = [squares(&q.coefficients, size), squares(&p.coefficients, level * size)];
    let weight = dividend / (level * size);
    let rounding = ROUNDINGS * f64::EPSILON * (1.0 + weight * weight);
    least(&above, &below) >= 2.0 * error + rounding
}

/// The coefficients of `|p/size|²` for real t.
fn squares(p: &Coefficients, size: f64) -> [f64; 2 * ROOM] {
    let mut squares = [0.0; 2 * ROOM];
    let scaled = p.map(|z: Complex<f64>| z / size);
    for (j, a) in scaled.iter().enumerate() {
        squares[2 * j] += a.norm_sqr();
        for (k, b) in scaled.iter().enumerate().skip(j + 1) {
            squares[j + k] += 2.0 * (a.re * b.re + a.im * b.im);
        }
    }
    squares
}

/// A lower bound of the difference of two polynomials for t from -1 to 1: the least of its parabola, less the sizes of all other terms.
fn least(above: &[f64; 2 * ROOM], below: &[f64; 2 * ROOM]) -> f64 {
    let term = |k: usize| above[k] - below[k];
    let [constant, slope, bend] = [term(0), term(1).abs(), term(2)];
    let rest = (3..2 * ROOM).map(|k| term(k).abs()).sum::<f64>();
    // the lowest point of the parabola is inside
    let parabola = if slope < 2.0 * bend { constant - slope * slope / (4.0 * bend) } else { constant - slope + bend };
    parabola - rest
}
