//! Natural frequencies of a finite element model by Sylvester's law: the frequencies below ω are the negative
//! eigenvalues of `K - ω²M`, and these are the negative pivots of any symmetric elimination.

use super::finite_elements::{BeamElement, Model, Square, add_product};

/// Why a model is of no use as a test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Degenerate {
    /// Nothing can move.
    Rigid,
    /// A displacement without stiffness and mass.
    Massless,
}

/// Pivots of inner functions that would make the others grow.
const SMALL: f64 = 0.05;

/// Appends a row and a column for an inner function of a beam.
fn border(matrix: &mut Square, beam: &BeamElement, coupling: [f64; 4], pivot: f64) {
    let last = matrix.len();
    let mut row = vec![0.0; last + 1];
    row[last] = beam.stiffness * pivot;
    for (end, entry) in beam.ends.iter().zip(coupling) {
        end.iter().for_each(|&(index, factor)| row[index] += beam.stiffness * entry * factor);
    }
    for (other, &entry) in matrix.iter_mut().zip(&row) {
        other.push(entry);
    }
    matrix.push(row);
}

impl Model<'_> {
    /// `K - ω²M` for the degrees of freedom that remain when the inner functions of the beams are eliminated, and the
    /// number of negative pivots of these. Those whose pivots are small remain.
    fn eliminated(&self, omega: f64) -> (u64, Square) {
        let square = omega * omega;
        let mut matrix = self.stiffness.clone();
        for (row, mass) in matrix.iter_mut().zip(&self.mass) {
            row.iter_mut().zip(mass).for_each(|(entry, mass)| *entry -= square * mass);
        }
        let mut negative = 0;
        for beam in &self.beams {
            let x = square * beam.wave_fourth;
            let mut schur = [[0.0; 4]; 4];
            for (&inner, coupling) in self.element.inner.iter().zip(&self.element.coupling) {
                let pivot = 1.0 - x * inner;
                if pivot.abs() < SMALL {
                    border(&mut matrix, beam, coupling.map(|entry| -(x * entry)), pivot);
                    continue;
                }
                negative += u64::from(pivot < 0.0);
                for (row, a) in schur.iter_mut().zip(coupling) {
                    row.iter_mut().zip(coupling).for_each(|(entry, b)| *entry += a * b / pivot);
                }
            }
            for (row, a) in schur.iter().zip(&beam.ends) {
                for (&entry, b) in row.iter().zip(&beam.ends) {
                    add_product(&mut matrix, a, b, -(beam.stiffness * x * x * entry));
                }
            }
        }
        (negative, matrix)
    }

    /// Number of frequencies below ω.
    pub(crate) fn count_below(&self, omega: f64) -> u64 {
        let (inner, matrix) = self.eliminated(omega);
        inner + negative_pivots(matrix).0
    }

    /// A frequency below which there are about `count`, unless the system has fewer or they are so high that a beam has
    /// `z = βl` above `limit`.
    pub(crate) fn frequency_above(&self, count: u64, limit: f64) -> f64 {
        let half = limit / 2.0;
        let waves = |beam: &BeamElement| half * half / beam.wave_fourth.sqrt();
        let (mut lower, mut upper) = (0.0, self.beams.iter().map(waves).fold(1e4, f64::min));
        for _ in 0..12 {
            let middle = if upper > 4.0 * lower { 0.3 * upper } else { (lower + upper) / 2.0 };
            if self.count_below(middle) > count { upper = middle } else { lower = middle }
        }
        upper
    }

    /// Bound of the relative error that rounding leaves in a frequency: `n` times eps of the largest stiffness, compared
    /// with `ω²` times the largest mass. A mode of small masses is far from the largest stiffness, or its ω is high.
    pub(crate) fn rounding(&self, omega: f64) -> f64 {
        let largest = |matrix: &Square| (0..matrix.len()).map(|i| matrix[i][i]).fold(1e-3, f64::max);
        self.size() as f64 * f64::EPSILON * largest(&self.stiffness) / (largest(&self.mass) * omega * omega)
    }

    /// Whether the model has frequencies, and as many as degrees of freedom with a mass.
    pub(crate) fn check(&self) -> Result<(), Degenerate> {
        if self.size() == 0 && self.beams.is_empty() {
            return Err(Degenerate::Rigid);
        }
        let sum = |(k, m): (&Vec<f64>, &Vec<f64>)| k.iter().zip(m).map(|(k, m)| k + m).collect();
        let definite: Square = self.stiffness.iter().zip(&self.mass).map(sum).collect();
        let (negative, smallest) = negative_pivots(definite);
        // parameters are between 0.01 and 100: what is smaller is rounding
        if negative > 0 || smallest < 1e-9 { Err(Degenerate::Massless) } else { Ok(()) }
    }
}

/// Negative pivots of a symmetric matrix and the smallest modulus of a pivot; Bunch and Parlett's elimination with
/// complete pivoting, in which a 2×2 pivot is always indefinite.
fn negative_pivots(mut a: Square) -> (u64, f64) {
    // growth of the elements is least for this threshold
    let threshold = (1.0 + 17f64.sqrt()) / 8.0;
    let (mut negative, mut smallest) = (0, f64::INFINITY);
    while !a.is_empty() {
        let n = a.len();
        let (mut row, mut column, mut diagonal) = (0, 0, 0);
        for i in 0..n {
            if a[i][i].abs() > a[diagonal][diagonal].abs() {
                diagonal = i;
            }
            for j in 0..i {
                if a[i][j].abs() > a[row][column].abs() || row == column {
                    (row, column) = (i, j);
                }
            }
        }
        let pivot = a[diagonal][diagonal];
        smallest = smallest.min(pivot.abs().max(a[row][column].abs()));
        if row == column || pivot.abs() >= threshold * a[row][column].abs() {
            negative += u64::from(pivot < 0.0);
            eliminate(&mut a, diagonal, pivot);
        } else {
            negative += 1;
            // [[p, q], [q, r]] with q much larger than p and r: rotated by 45° it has two pivots far from zero
            rotate(&mut a, row, column);
            let (p, r) = (a[row][row], a[column][column]);
            let (first, last) = if p.abs() > r.abs() { (row, column) } else { (column, row) };
            let pivot = a[first][first];
            eliminate(&mut a, first, pivot);
            let last = if last == a.len() { first } else { last };
            let pivot = a[last][last];
            eliminate(&mut a, last, pivot);
        }
    }
    (negative, smallest)
}

/// Takes the row and column of a pivot out; the last ones take their place.
fn eliminate(a: &mut Square, index: usize, pivot: f64) {
    let row = a[index].clone();
    if pivot != 0.0 {
        for (other, factor) in a.iter_mut().zip(&row).filter(|(_, factor)| **factor != 0.0) {
            let factor = factor / pivot;
            other.iter_mut().zip(&row).for_each(|(entry, row)| *entry -= factor * row);
        }
    }
    a.swap_remove(index);
    for row in a {
        row.swap_remove(index);
    }
}

/// Turns two degrees of freedom by 45°.
fn rotate(a: &mut Square, i: usize, j: usize) {
    let half = core::f64::consts::FRAC_1_SQRT_2;
    let turned = |x: f64, y: f64| (half * (x + y), half * (x - y));
    for row in a.iter_mut() {
        (row[i], row[j]) = turned(row[i], row[j]);
    }
    let (mut first, mut second) = (core::mem::take(&mut a[i]), core::mem::take(&mut a[j]));
    first.iter_mut().zip(&mut second).for_each(|(x, y)| (*x, *y) = turned(*x, *y));
    (a[i], a[j]) = (first, second);
}
