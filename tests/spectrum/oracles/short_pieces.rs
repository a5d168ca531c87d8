//! Beams as stiffness matrices of many digits, without a count of held beams.
//!
//! Every beam is cut into pieces so short that none of them vibrates below the frequency with both ends held: with `γ = Y' - σΘ` its energy is
//! `½ ∫ EI Θ'² + (1/f + T) γ² + σT Θ² + k Y²`, and functions that vanish at both ends of a piece of length a have `∫ f² <= (a/π)² ∫ f'²`. So the
//! count is that of negative pivots alone, and no count of held beams is in it. The matrix of a piece follows from the exponential of the
//! equations.

use super::chain_matrix::{ChainMatrix, Form, negative_pivots, number};
use super::many_digits::Exact;
use crate::general_chains::chain::Chain;
use mstmm::elements::GeneralBeam;
use std::f64::consts::PI;

/// The largest number of pieces of a beam that is of use.
const PIECES: f64 = 400.0;

/// Terms of a power series, which is precise to all digits up to the largest wave.
const TERMS: usize = 130;

/// The largest wave number times the length of a piece.
const WAVE: f64 = 12.0;

/// Length, in that of a beam, of equal pieces that do not vibrate.
fn pieces(beam: &GeneralBeam<f64>, square: f64) -> Option<usize> {
    let tension = beam.axial_force + beam.foundation_shear_stiffness;
    let (ei, f) = (beam.bending_stiffness, 1.0 / beam.shear_stiffness);
    let left = exact_share(beam);
    let sigma = 1.0 / left;
    let h = (beam.mass_per_length * square - beam.foundation_stiffness).max(0.0);
    let a = (beam.rotary_inertia * square).max(0.0) + (-sigma * tension).max(0.0);
    let limits = [ei / (2.0 * a), (ei / (4.0 * h * sigma * sigma)).sqrt(), left / (2.0 * h * f)];
    let shortest = limits.into_iter().filter(|limit| !limit.is_nan()).fold(f64::INFINITY, f64::min);
    let by_count = beam.length / (PI * (0.9 * shortest).sqrt());
    let by_count = by_count.min(by_sines(beam, square, left));
    let hs = (beam.mass_per_length * square - beam.foundation_stiffness).abs() / ei;
    let g = (sigma * tension.abs() + beam.rotary_inertia * square.abs()) / ei;
    let wave = (hs.sqrt() * sigma + g + f * sigma * hs * ei).sqrt();
    let number = (by_count + 1.0).max(wave * beam.length / WAVE + 1.0).floor();
    (number < PIECES).then_some(number as usize)
}

/// The number of pieces that do not vibrate pinned, whose shapes are sines, with `1 + T f`; a clamped piece has less.
fn by_sines(beam: &GeneralBeam<f64>, square: f64, left: f64) -> f64 {
    let (ei, f) = (beam.bending_stiffness, 1.0 / beam.shear_stiffness);
    if f == 0.0 {
        return f64::INFINITY;
    }
    let (ga, of_slope) = (1.0 / f, left / f);
    let of_rotation = ga - beam.rotary_inertia * square;
    let of_deflection = beam.foundation_stiffness - beam.mass_per_length * square;
    if of_rotation <= 0.0 {
        return f64::INFINITY;
    }
    // `(EI q + GA - r ω²) ((GA + T) q + k - m ω²) - GA² q` is positive from here on, with `q = (π/a)²`
    let [a, b, c] = [ei * of_slope, ei * of_deflection + of_rotation * of_slope - ga * ga, of_rotation * of_deflection];
    let rest = b * b - 4.0 * a * c;
    let largest = if rest < -1e-6 * b * b { 0.0 } else { (rest.max(0.0).sqrt() - b) / (2.0 * a) };
    let least = largest.max(-of_deflection / of_slope).max(0.0);
    beam.length * (1.1 * least).sqrt() / PI
}

/// `1/kGA`; nothing without shear.
fn flexibility(beam: &GeneralBeam<f64>) -> Exact {
    if beam.shear_stiffness < f64::INFINITY { number(1.0) / number(beam.shear_stiffness) } else { number(0.0) }
}

/// `1 + T f`.
fn exact_share(beam: &GeneralBeam<f64>) -> f64 {
    let tension = number(beam.axial_force) + number(beam.foundation_shear_stiffness);
    (number(1.0) + tension * flexibility(beam)).to_f64().value()
}

/// `exp A` of the equations with σ, τ, g, h, by its power series, column by column.
fn exponential([sigma, tau, g, h]: &[Exact; 4]) -> [[Exact; 4]; 4] {
    let mut columns: [[Exact; 4]; 4] =
        core::array::from_fn(|j| core::array::from_fn(|i| number(f64::from(u8::from(i == j)))));
    let mut terms = columns.clone();
    for k in 1..TERMS {
        let part = number(1.0) / number(k as f64);
        for (term, sum) in terms.iter_mut().zip(&mut columns) {
            let [y, theta, m, q] = &*term;
            let next = [sigma * theta - tau * q, m.clone(), g * theta + sigma * q, h * y];
            *term = next.map(|entry| entry * &part);
            sum.iter_mut().zip(&*term).for_each(|(sum, entry)| *sum += entry);
        }
    }
    core::array::from_fn(|i| core::array::from_fn(|j| columns[j][i].clone()))
}

/// The stiffness of a piece against deflection and rotation of both ends.
fn stiffness(beam: &GeneralBeam<f64>, square: &Exact, count: usize) -> [[Exact; 4]; 4] {
    let [l, ei, m] = [beam.length, beam.bending_stiffness, beam.mass_per_length].map(number);
    let f = flexibility(beam);
    let l = l / number(count as f64);
    let tension = number(beam.axial_force) + number(beam.foundation_shear_stiffness);
    let sigma = number(1.0) / (number(1.0) + &tension * &f);
    let scale = &l * &l / &ei;
    let tau = &f * &sigma / &scale;
    let g = (&sigma * &tension - number(beam.rotary_inertia) * square) * &scale;
    let h = (m * square - number(beam.foundation_stiffness)) * &scale * &l * &l;
    let u = exponential(&[sigma, tau, g, h]);
    let unit = &ei / &l;
    let units = [l.clone(), number(1.0), unit.clone(), unit / l];
    let u = |row: usize, column: usize| &u[row][column] * &units[row] / &units[column];
    // forces M, Q at the input end from the displacements of both, `f = B⁻¹ (d' - A d)`
    let determinant = u(0, 2) * u(1, 3) - u(0, 3) * u(1, 2);
    let inverse = [[u(1, 3), -u(0, 3)], [-u(1, 2), u(0, 2)]].map(|row| row.map(|entry| entry / &determinant));
    let at_input: [[Exact; 4]; 2] = core::array::from_fn(|i| {
        core::array::from_fn(|j| match j {
            0 | 1 => -(&inverse[i][0] * u(0, j) + &inverse[i][1] * u(1, j)),
            _ => inverse[i][j - 2].clone(),
        })
    });
    let at_output = |row: usize, j: usize| {
        let own = if j < 2 { u(row, j) } else { number(0.0) };
        own + u(row, 2) * &at_input[0][j] + u(row, 3) * &at_input[1][j]
    };
    core::array::from_fn(|i| {
        core::array::from_fn(|j| match i {
            0 => at_input[1][j].clone(),
            1 => -at_input[0][j].clone(),
            2 => -at_output(3, j),
            _ => at_output(2, j),
        })
    })
}

/// Pieces of beams, with the last beam, the number of its pieces and the stiffness of one.
#[derive(Default)]
struct Pieces(Option<(GeneralBeam<f64>, usize, [[Exact; 4]; 4])>);

impl Pieces {
    /// A beam from one end on, to the displacements of the other.
    fn through(
        &mut self,
        matrix: &mut ChainMatrix,
        beam: &GeneralBeam<f64>,
        [mut y, mut theta]: [Form; 2],
        last: Option<[Form; 2]>,
        square: &Exact,
    ) -> Option<[Form; 2]> {
        let (count, stiffness) = match &self.0 {
            Some((last, count, stiffness)) if last == beam => (*count, stiffness.clone()),
            _ => {
                let count = pieces(beam, square.to_f64().value())?;
                let stiffness = stiffness(beam, square, count);
                self.0 = Some((*beam, count, stiffness.clone()));
                (count, stiffness)
            }
        };
        for piece in 1..=count {
            let [y_out, theta_out] = match &last {
                Some(last) if piece == count => last.clone(),
                _ => [matrix.freedom(), matrix.freedom()],
            };
            let ends = [y, theta, y_out.clone(), theta_out.clone()];
            for (i, a) in ends.iter().enumerate() {
                for (j, b) in ends.iter().enumerate() {
                    matrix.add(a, b, &stiffness[i][j]);
                }
            }
            (y, theta) = (y_out, theta_out);
        }
        Some([y, theta])
    }
}

/// The number of roots of a chain whose square is below one of either sign; none where beams would have too many pieces.
pub(crate) fn roots_below(chain: &Chain, square: &Exact) -> Option<u64> {
    let mut pieces = Pieces::default();
    negative_pivots(chain, square, |matrix, beam, from, to| pieces.through(matrix, beam, from, to, square))
}
