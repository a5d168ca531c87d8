//! Linear constraints are eliminated: each takes one degree of freedom.

use super::Form;
use mstmm::{DoubleDouble, Real};

/// Part of its terms below which the rest of a constraint is their rounding: it follows from the others.
const FOLLOWS: f64 = 1e-28;

/// Every degree of freedom as a form of the independent ones, by rows; and whether a constraint follows from others.
pub(super) fn independent(size: usize, constraints: &[Form]) -> (Vec<Vec<DoubleDouble>>, bool) {
    let unit = |i: usize, j: usize| DoubleDouble::from(f64::from(u8::from(i == j)));
    let mut forms: Vec<Vec<DoubleDouble>> = (0..size).map(|i| (0..size).map(|j| unit(i, j)).collect()).collect();
    let mut is_held_twice = false;
    for constraint in constraints {
        let width = forms.first().map_or(0, Vec::len);
        let (mut row, mut sizes) = (vec![DoubleDouble::from(0.0); width], vec![0.0; width]);
        for &(freedom, factor) in constraint {
            for ((sum, size), &entry) in row.iter_mut().zip(&mut sizes).zip(&forms[freedom]) {
                let term = factor * entry;
                *sum += term;
                *size += term.to_f64().abs();
            }
        }
        let counts = |&j: &usize| row[j].to_f64().abs() > FOLLOWS * sizes[j];
        // a displacement by itself is taken out without a rounding
        let preference = |&j: &usize| (row[j].abs() == DoubleDouble::from(1.0), row[j].to_f64().abs());
        let order = |i: &usize, j: &usize| {
            let (a, b) = (preference(i), preference(j));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        };
        let Some(pivot) = (0..width).filter(counts).max_by(order) else {
            is_held_twice = true;
            continue;
        };
        for form in forms.iter_mut().filter(|form| form[pivot] != DoubleDouble::from(0.0)) {
            let factor = form[pivot] / row[pivot];
            form.iter_mut().zip(&row).for_each(|(entry, &row)| *entry -= factor * row);
        }
        for form in &mut forms {
            form.swap_remove(pivot);
        }
    }
    (forms, is_held_twice)
}

/// A form of all degrees of freedom as one of the independent ones.
pub(super) fn reduced(form: &Form, independent: &[Vec<DoubleDouble>]) -> Form {
    let width = independent.first().map_or(0, Vec::len);
    let zero = DoubleDouble::from(0.0);
    let entry = |column: usize| {
        let (mut sum, mut size) = (zero, 0.0);
        for &(freedom, factor) in form {
            let term = factor * independent[freedom][column];
            sum += term;
            size += term.to_f64().abs();
        }
        // what two paths of one displacement leave of it
        if sum.to_f64().abs() > FOLLOWS * size { sum } else { zero }
    };
    (0..width).map(|column| (column, entry(column))).filter(|(_, entry)| *entry != zero).collect()
}
