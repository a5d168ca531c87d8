//! Negative pivots of a large symmetric matrix most of whose entries are zero, with a bound of the rounding of each.

use super::pivots::{Entry, ROUNDINGS, difference, is_sure, is_there, product, quotient, size, units};
use super::{Assembled, UNIT};
use mstmm::number::{DoubleDouble, Scalar};
use std::collections::BTreeMap;

/// Parts of the largest entry of its row that a pivot is, in the order in which they are asked for.
const THRESHOLDS: [f64; 4] = [0.1, 1e-3, 1e-9, 0.0];

type Row = BTreeMap<usize, Entry>;

/// Number of negative pivots by elimination of the shortest rows first; `None` if the sign of one is not sure.
pub(crate) fn negative(matrix: &Assembled<DoubleDouble>) -> Option<u64> {
    eliminated(rows(matrix), false, true)
}

/// The same without a proof: two orders of elimination agree. Bounds of rounding grow along chains of a thousand members far beyond
/// rounding itself.
pub(crate) fn agreed(matrix: &Assembled<DoubleDouble>) -> Option<u64> {
    let one = eliminated(rows(matrix), false, false)?;
    (eliminated(rows(matrix), true, false)? == one).then_some(one)
}

fn eliminated(mut rows: Vec<Row>, is_backwards: bool, is_proven: bool) -> Option<u64> {
    let mut left: Vec<usize> = (0..rows.len()).collect();
    if is_backwards {
        left.reverse();
    }
    let mut negative = 0;
    while !left.is_empty() {
        let place = THRESHOLDS.iter().find_map(|&part| shortest(&rows, &left, part))?;
        let index = left.remove(place);
        let row = core::mem::take(&mut rows[index]);
        let pivot = *row.get(&index)?;
        if is_proven && !is_sure(pivot) {
            return None;
        }
        negative += u64::from(pivot.0 < DoubleDouble::from(0.0));
        eliminate(&mut rows, index, &row, pivot);
    }
    Some(negative)
}

/// The rows in units in which the terms of the diagonal are about one.
fn rows(matrix: &Assembled<DoubleDouble>) -> Vec<Row> {
    let units = units(matrix);
    let row = |i: usize| {
        let entry = |j: usize| {
            let unit = units[i] + units[j];
            let bound = ROUNDINGS * UNIT * matrix.sizes[i][j] * 2f64.powi(unit);
            (matrix.entries[i][j].times_power_of_two(unit), bound)
        };
        let there = (0..units.len()).filter(|&j| matrix.sizes[i][j] != 0.0);
        there.map(|j| (j, entry(j))).collect()
    };
    (0..units.len()).map(row).collect()
}

/// The place of the shortest row whose diagonal is such a part of its largest entry.
fn shortest(rows: &[Row], left: &[usize], part: f64) -> Option<usize> {
    let mut best: Option<(usize, usize)> = None;
    for (place, &index) in left.iter().enumerate() {
        let row = &rows[index];
        if best.is_some_and(|(length, _)| length <= row.len()) {
            continue;
        }
        let largest = row.values().map(|&entry| size(entry)).fold(0.0, f64::max);
        if row.get(&index).is_some_and(|&pivot| size(pivot) > part * largest) {
            best = Some((row.len(), place));
        }
    }
    best.map(|(_, place)| place)
}

fn eliminate(rows: &mut [Row], index: usize, row: &Row, pivot: Entry) {
    let others: Vec<(usize, Entry)> = row.iter().filter(|(k, _)| **k != index).map(|(&k, &entry)| (k, entry)).collect();
    let zero = (DoubleDouble::from(0.0), 0.0);
    for &(i, column) in &others {
        rows[i].remove(&index);
        if !is_there(column) {
            continue;
        }
        let factor = quotient(column, pivot);
        for &(j, other) in &others {
            let entry = rows[i].entry(j).or_insert(zero);
            *entry = difference(*entry, product(factor, other));
        }
    }
}

/// Closed form: the eigenvalues of the chain `2, -1` less s are `2 - s - 2 cos(kπ/(n + 1))`.
#[test]
fn negative_pivots_of_a_chain_are_counted() {
    let (n, form) = (50, |k: usize| vec![(k, DoubleDouble::from(1.0))]);
    for (shift, expected) in [(0.001, 0), (1.1, 17), (2.0 + 1e-9, 25), (3.9999, 50)] {
        let mut matrix = Assembled::zero(n);
        for k in 0..n {
            matrix.add(&form(k), &form(k), DoubleDouble::from(2.0 - shift), 2.0);
            if k > 0 {
                matrix.add(&form(k), &form(k - 1), DoubleDouble::from(-1.0), 1.0);
                matrix.add(&form(k - 1), &form(k), DoubleDouble::from(-1.0), 1.0);
            }
        }
        assert_eq!((negative(&matrix), agreed(&matrix)), (Some(expected), Some(expected)), "{shift}");
    }
}
