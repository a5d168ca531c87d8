//! Linear constraints are eliminated: each takes one degree of freedom, of those it holds one that weighs least.

use super::Form;
use mstmm::number::{DoubleDouble, Parameter};

/// Part of its terms below which the rest of a sum is their rounding.
const FOLLOWS: f64 = 1e-28;

/// A row of factors of all degrees of freedom.
type Row = Vec<DoubleDouble>;

fn zero() -> DoubleDouble {
    DoubleDouble::from(0.0)
}

/// `a - factor · b`, zero where rounding alone is left.
fn less(a: DoubleDouble, factor: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let product = factor * b;
    let difference = a - product;
    let size = a.to_f64().abs() + product.to_f64().abs();
    if difference.to_f64().abs() > FOLLOWS * size { difference } else { zero() }
}

/// The degrees of freedom in terms of those that are kept.
pub(super) struct Independent {
    /// Every degree of freedom as a form of the kept ones.
    forms: Vec<Form>,
    /// Number of those that are kept.
    pub(super) size: usize,
    /// Whether a constraint follows from others.
    pub(super) is_held_twice: bool,
}

impl Independent {
    /// By elimination with complete pivoting, in units of displacement in which all weigh the same.
    pub(super) fn of(constraints: &[Form], weights: &[f64]) -> Self {
        let size = weights.len();
        let heaviest = weights.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let units: Vec<f64> = weights.iter().map(|weight| weight.max(1e-80 * heaviest).sqrt()).collect();
        let dense = |form: &Form| {
            let mut row = vec![zero(); size];
            form.iter().for_each(|&(index, factor)| row[index] += factor);
            row
        };
        let mut rows: Vec<Row> = constraints.iter().map(dense).collect();
        let mut solved: Vec<(usize, Row)> = Vec::new();
        let mut is_held_twice = false;
        while !rows.is_empty() {
            let scaled = |row: &Row, j: usize| row[j].to_f64().abs() / units[j];
            let largest = |row: &Row| (0..size).max_by(|&i, &j| scaled(row, i).total_cmp(&scaled(row, j)));
            let value = |row: &Row| largest(row).map_or(0.0, |pivot| scaled(row, pivot));
            let Some(best) = (0..rows.len()).max_by(|&i, &j| value(&rows[i]).total_cmp(&value(&rows[j]))) else {
                break;
            };
            let row = rows.swap_remove(best);
            let Some(pivot) = largest(&row).filter(|&pivot| row[pivot] != zero()) else {
                is_held_twice = true;
                continue;
            };
            let others = rows.iter_mut().chain(solved.iter_mut().map(|(_, row)| row));
            for other in others.filter(|other| other[pivot] != zero()) {
                let factor = other[pivot] / row[pivot];
                let terms = other.iter_mut().zip(&row).filter(|(_, term)| **term != zero());
                terms.for_each(|(entry, &term)| *entry = less(*entry, factor, term));
                other[pivot] = zero();
            }
            solved.push((pivot, row));
        }
        Independent { forms: forms(size, &solved), size: size - solved.len(), is_held_twice }
    }

    /// A form of all degrees of freedom as one of the kept ones.
    pub(super) fn reduced(&self, form: &Form) -> Form {
        let mut entries = vec![(zero(), 0.0); self.size];
        for &(freedom, factor) in form {
            for &(column, entry) in &self.forms[freedom] {
                let term = factor * entry;
                entries[column].0 += term;
                entries[column].1 += term.to_f64().abs();
            }
        }
        let counts = |(_, (sum, size)): &(usize, (DoubleDouble, f64))| sum.to_f64().abs() > FOLLOWS * size;
        entries.into_iter().enumerate().filter(counts).map(|(column, (sum, _))| (column, sum)).collect()
    }
}

/// Every degree of freedom: a kept one is itself, another what its constraint says.
fn forms(size: usize, solved: &[(usize, Row)]) -> Vec<Form> {
    let mut columns = vec![None; size];
    let is_kept = |index: &usize| solved.iter().all(|(pivot, _)| pivot != index);
    (0..size).filter(is_kept).enumerate().for_each(|(column, index)| columns[index] = Some(column));
    let mut forms: Vec<Form> =
        columns.iter().map(|column| column.iter().map(|&column| (column, DoubleDouble::from(1.0))).collect()).collect();
    for (pivot, row) in solved {
        let entry = |(index, &factor): (usize, &DoubleDouble)| {
            columns[index].filter(|_| factor != zero()).map(|column| (column, -(factor / row[*pivot])))
        };
        forms[*pivot] = row.iter().enumerate().filter_map(entry).collect();
    }
    forms
}
