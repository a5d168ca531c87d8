//! The determinant of a complex symmetric matrix, with a bound of its rounding.

use super::pivots::{ROUNDINGS, units};
use super::{Assembled, UNIT};
use mstmm::Complex;
use mstmm::number::{DoubleDouble, Scalar};

type C = Complex<DoubleDouble>;

/// A number with an exponent of its own.
#[derive(Clone, Copy)]
pub(crate) struct Determinant {
    pub(crate) mantissa: C,
    pub(crate) exponent: i64,
    /// Bound of its relative error.
    pub(crate) error: f64,
}

impl Determinant {
    fn times(self, factor: C, error: f64) -> Self {
        let product = self.mantissa * factor;
        let size = product.size();
        let shift = if size > 0.0 && size.is_finite() { size.log2() as i32 } else { 0 };
        Determinant {
            mantissa: product.times_power_of_two(-shift),
            exponent: self.exponent + i64::from(shift),
            error: self.error + error / factor.size(),
        }
    }

    /// The number over `2^exponent`.
    pub(crate) fn over_power(self, exponent: i64) -> C {
        let shift = (self.exponent - exponent).clamp(-900, 900);
        self.mantissa.times_power_of_two(shift as i32)
    }
}

/// Bunch and Parlett's threshold would keep the symmetry; here rows and columns are exchanged for the largest entry.
pub(crate) fn determinant(sum: &Assembled<C>) -> Determinant {
    let (n, units) = (sum.entries.len(), units(sum));
    let entry = |i: usize, j: usize| {
        let unit = units[i] + units[j];
        let bound = ROUNDINGS * UNIT * sum.sizes[i][j] * 2f64.powi(unit);
        (sum.entries[i][j].times_power_of_two(unit), bound)
    };
    let mut a: Vec<Vec<(C, f64)>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
    let exponent = -2 * units.iter().map(|&unit| i64::from(unit)).sum::<i64>();
    let one = C::new(DoubleDouble::from(1.0), DoubleDouble::from(0.0));
    let mut product = Determinant { mantissa: one, exponent, error: 0.0 };
    while let Some(last) = a.len().checked_sub(1) {
        let all = (0..=last).flat_map(|i| (0..=last).map(move |j| (i, j)));
        let largest = all.max_by(|&(i, j), &(k, l)| a[i][j].0.size().total_cmp(&a[k][l].0.size()));
        let (row, column) = largest.unwrap_or((last, last));
        let mut pivot_row = a.swap_remove(row);
        pivot_row.swap(column, last);
        let (pivot, error) = pivot_row[last];
        // each exchange changes the sign
        let changes = (row == last) != (column == last);
        product = product.times(if changes { -pivot } else { pivot }, error);
        if pivot.size() == 0.0 {
            return product;
        }
        for other in &mut a {
            other.swap(column, last);
            eliminate(other, &pivot_row, pivot, error);
        }
    }
    product
}

/// Takes the last column out of a row.
fn eliminate(row: &mut Vec<(C, f64)>, pivot_row: &[(C, f64)], pivot: C, error: f64) {
    let Some((entry, bound)) = row.pop() else { return };
    let factor = entry / pivot;
    // products of complex numbers have four real ones, and sizes are those of the larger part
    let (size, room) = (2.0 * factor.size(), 2.0 * (bound + factor.size() * error) / pivot.size());
    for ((entry, bound), &(above, above_bound)) in row.iter_mut().zip(pivot_row) {
        *entry -= factor * above;
        let product = size * above.size();
        *bound += size * above_bound + room * above.size() + 4.0 * UNIT * (product + entry.size());
    }
}
