//! Negative pivots of a symmetric matrix, with a bound of the rounding of each entry beside it.

use super::{Assembled, UNIT};
use mstmm::number::{DoubleDouble, Parameter, Scalar};

/// Where the growth of the entries is least: Bunch and Parlett's `(1 + sqrt 17)/8`.
const THRESHOLD: f64 = 0.640_388_203_202_207_6;

/// Roundings in an entry: the wave number of a beam, its functions, the quotient and the sum.
pub(crate) const ROUNDINGS: f64 = 16.0;

/// An entry and a bound of its rounding.
pub(super) type Entry = (DoubleDouble, f64);

pub(super) fn size(entry: Entry) -> f64 {
    entry.0.to_f64().abs()
}

pub(super) fn product(a: Entry, b: Entry) -> Entry {
    (a.0 * b.0, size(a) * b.1 + a.1 * size(b) + a.1 * b.1 + UNIT * size(a) * size(b))
}

pub(super) fn difference(a: Entry, b: Entry) -> Entry {
    (a.0 - b.0, a.1 + b.1 + UNIT * (size(a) + size(b)))
}

/// The quotient by a number that is not zero.
pub(super) fn quotient(a: Entry, b: Entry) -> Entry {
    let value = a.0 / b.0;
    let size_of_value = value.to_f64().abs();
    (value, (a.1 + size_of_value * b.1) / (size(b) - b.1) + UNIT * size_of_value)
}

pub(super) fn is_sure(entry: Entry) -> bool {
    // a NaN is not sure
    size(entry) > entry.1 && entry.1.is_finite()
}

/// Whether an entry is not simply zero: most are, in large structures.
pub(super) fn is_there(entry: Entry) -> bool {
    size(entry) != 0.0 || entry.1 != 0.0
}

/// Number of negative pivots by elimination with complete pivoting, in which a pivot of two rows has one; `None` if the
/// sign of one is not sure.
pub(crate) fn negative(matrix: &Assembled<DoubleDouble>) -> Option<u64> {
    let mut a = in_units(matrix);
    let mut negative = 0;
    while !a.is_empty() {
        let n = a.len();
        let diagonal = (0..n).max_by(|&i, &j| size(a[i][i]).total_cmp(&size(a[j][j])))?;
        let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
        let largest = pairs.max_by(|&(i, j), &(k, l)| size(a[i][j]).total_cmp(&size(a[k][l])));
        let (pivot, beside) = (a[diagonal][diagonal], largest.map_or(0.0, |(i, j)| size(a[i][j])));
        match largest {
            Some((i, j)) if size(pivot) < THRESHOLD * beside => {
                let determinant = difference(product(a[i][i], a[j][j]), product(a[i][j], a[i][j]));
                if !is_sure(determinant) || determinant.0 > DoubleDouble::from(0.0) {
                    return None;
                }
                negative += 1;
                eliminate_two(&mut a, i, j, determinant);
            }
            _ => {
                if !is_sure(pivot) {
                    return None;
                }
                negative += u64::from(pivot.0 < DoubleDouble::from(0.0));
                eliminate_one(&mut a, diagonal, pivot);
            }
        }
    }
    Some(negative)
}

/// Powers of two for rows and columns that make the terms of the diagonal about one.
pub(crate) fn units<S>(matrix: &Assembled<S>) -> Vec<i32> {
    let exponent = |i: usize| {
        let size = matrix.sizes[i][i];
        if size > 0.0 && size.is_finite() { -(size.log2() / 2.0).round() as i32 } else { 0 }
    };
    (0..matrix.sizes.len()).map(exponent).collect()
}

/// The entries in these units.
fn in_units(matrix: &Assembled<DoubleDouble>) -> Vec<Vec<Entry>> {
    let (n, units) = (matrix.entries.len(), units(matrix));
    let entry = |i: usize, j: usize| {
        let unit = units[i] + units[j];
        let bound = ROUNDINGS * UNIT * matrix.sizes[i][j] * 2f64.powi(unit);
        (matrix.entries[i][j].times_power_of_two(unit), bound)
    };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

fn remove(a: &mut Vec<Vec<Entry>>, index: usize) {
    a.remove(index);
    for row in a {
        row.remove(index);
    }
}

fn eliminate_one(a: &mut Vec<Vec<Entry>>, index: usize, pivot: Entry) {
    let column = a[index].clone();
    remove(a, index);
    let column: Vec<Entry> =
        column.into_iter().enumerate().filter(|(i, _)| *i != index).map(|(_, entry)| entry).collect();
    for (row, &factor) in a.iter_mut().zip(&column).filter(|(_, factor)| is_there(**factor)) {
        let factor = quotient(factor, pivot);
        for (entry, &other) in row.iter_mut().zip(&column).filter(|(_, other)| is_there(**other)) {
            *entry = difference(*entry, product(factor, other));
        }
    }
}

/// Two rows at once, `i > j`: with `[u v]` of the inverse times their columns.
fn eliminate_two(a: &mut Vec<Vec<Entry>>, i: usize, j: usize, determinant: Entry) {
    let (first, second) = (a[i].clone(), a[j].clone());
    let (p, q, r) = (first[i], first[j], second[j]);
    for index in [i, j] {
        remove(a, index);
    }
    let rest = |column: Vec<Entry>| -> Vec<Entry> {
        column.into_iter().enumerate().filter(|(k, _)| *k != i && *k != j).map(|(_, entry)| entry).collect()
    };
    let (first, second) = (rest(first), rest(second));
    let are_there = |(x, y): &(&Entry, &Entry)| is_there(**x) || is_there(**y);
    for (row, (&x, &y)) in a.iter_mut().zip(first.iter().zip(&second)).filter(|(_, pair)| are_there(pair)) {
        let u = quotient(difference(product(r, x), product(q, y)), determinant);
        let v = quotient(difference(product(p, y), product(q, x)), determinant);
        let others = row.iter_mut().zip(first.iter().zip(&second)).filter(|(_, pair)| are_there(pair));
        for (entry, (&other_x, &other_y)) in others {
            *entry = difference(difference(*entry, product(u, other_x)), product(v, other_y));
        }
    }
}
