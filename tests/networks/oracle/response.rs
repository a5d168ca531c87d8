//! Responses by the dynamic stiffness matrix, in double-double arithmetic.

use super::{Oracle, double};
use crate::stiffness_matrix::beam_matrix::Field;
use crate::stiffness_matrix::discs::{C, Zeros};
use mstmm::number::Scalar;

/// Part of the largest unknown to which two orders of elimination must agree.
const SURE: f64 = 1e-14;

impl Oracle {
    /// The displacements of all nodes under a force on one of them, at a complex frequency; none where rounding may stand for a pivot.
    pub(crate) fn response(&self, lambda: C, node: usize, axis: usize) -> Option<Vec<[C; 3]>> {
        let matrix = self.assembled(lambda, &self.cuts(lambda));
        let size = matrix.entries.len();
        let mut load = vec![C::of(double(0.0)); size];
        for &(unknown, part) in &self.nodes[node][axis] {
            load[unknown] += C::of(part);
        }
        let solution = solved(matrix.entries.clone(), load.clone())?;
        // in the reverse order of unknowns other roundings are made
        let reversed = |row: &Vec<C>| row.iter().rev().copied().collect::<Vec<C>>();
        let mut other = solved(matrix.entries.iter().rev().map(reversed).collect(), reversed(&load))?;
        other.reverse();
        let largest = solution.iter().map(|value| value.size()).fold(0.0, f64::max);
        let agree = |(one, other): (&C, &C)| (*one - *other).size() <= SURE * largest;
        if !solution.iter().zip(&other).all(agree) {
            return None;
        }
        let of_form = |form: &crate::stiffness_matrix::Form| {
            form.iter().fold(C::of(double(0.0)), |sum, &(unknown, part)| sum + C::of(part) * solution[unknown])
        };
        Some(self.nodes.iter().map(|node| node.each_ref().map(of_form)).collect())
    }
}

/// Elimination with the largest entry of its column, beside the largest of its row, as the pivot.
fn solved(mut rows: Vec<Vec<C>>, mut load: Vec<C>) -> Option<Vec<C>> {
    let size = rows.len();
    // an unknown that nothing refers to stays at rest
    for (k, row) in rows.iter_mut().enumerate() {
        if row.iter().all(|entry| entry.size() == 0.0) {
            row[k] = C::of(double(1.0));
        }
    }
    let scales: Vec<f64> = rows.iter().map(|row| row.iter().map(|entry| entry.size()).fold(0.0, f64::max)).collect();
    let mut order: Vec<usize> = (0..size).collect();
    for k in 0..size {
        let part = |place: usize| rows[order[place]][k].size() / scales[order[place]];
        let best = (k..size).max_by(|a, b| part(*a).total_cmp(&part(*b)))?;
        if part(best) < 1e-28 {
            return None;
        }
        order.swap(k, best);
        let pivot = rows[order[k]].clone();
        let of_pivot = load[order[k]];
        for &other in &order[k + 1..] {
            let factor = rows[other][k] / pivot[k];
            if factor.size() == 0.0 {
                continue;
            }
            for (entry, own) in rows[other][k..].iter_mut().zip(&pivot[k..]) {
                *entry -= factor * *own;
            }
            load[other] -= factor * of_pivot;
        }
    }
    let mut solution = vec![C::of(double(0.0)); size];
    for k in (0..size).rev() {
        let row = &rows[order[k]];
        let rest = (k + 1..size).fold(load[order[k]], |sum, column| sum - row[column] * solution[column]);
        solution[k] = rest / row[k];
    }
    Some(solution)
}
