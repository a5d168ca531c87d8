//! Negative eigenvalues of a symmetric matrix where bounds of single entries have grown too large.
//!
//! A positive diagonal matrix that is added takes negative eigenvalues away or leaves them, one that is subtracted brings some or
//! none (Weyl). A bound of all rounding is added once and subtracted once: two equal counts are the count of the matrix.

use super::double;
use crate::stiffness_matrix::pivots::ROUNDINGS;
use crate::stiffness_matrix::{Assembled, UNIT};
use mstmm::number::{DoubleDouble, Parameter, Scalar};

/// Where the growth of the entries is least: Bunch and Parlett's `(1 + sqrt 17)/8`.
const THRESHOLD: f64 = 0.640_388_203_202_207_6;

/// Rounding of a factorisation in units of the size of the matrix and of its largest entry on the way.
const FACTORISATION: f64 = 20.0;

/// How far entries are expected to grow.
const GROWTH: f64 = 64.0;

type Matrix = Vec<Vec<DoubleDouble>>;

fn size(value: DoubleDouble) -> f64 {
    value.to_f64().abs()
}

/// The number of negative eigenvalues; `None` where rounding may change it.
pub(super) fn negative(matrix: &Assembled<DoubleDouble>) -> Option<u64> {
    let n = matrix.entries.len();
    let units = units(&matrix.entries);
    let power = |i: usize, j: usize| units[i] + units[j];
    let entry = |i: usize, j: usize| matrix.entries[i][j].times_power_of_two(power(i, j));
    let bound = |i: usize, j: usize| ROUNDINGS * UNIT * matrix.sizes[i][j] * 2f64.powi(power(i, j));
    let own = FACTORISATION * GROWTH * n as f64 * UNIT;
    let counts = [-1.0, 1.0].map(|sign| {
        let mut shifted: Matrix = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        for (i, row) in shifted.iter_mut().enumerate() {
            let doubt: f64 = (0..n).map(|j| bound(i, j)).sum();
            row[i] += double(sign * (own + doubt));
        }
        eliminated(shifted)
    });
    match counts {
        [Some(more), Some(less)] if more == less => Some(more),
        _ => None,
    }
}

/// Powers of two for rows and columns that make the largest entry of each about one.
fn units(entries: &Matrix) -> Vec<i32> {
    let mut units = vec![0_i32; entries.len()];
    let logarithm = |value: DoubleDouble| size(value).log2();
    for _ in 0..12 {
        let largest = |(i, row): (usize, &Vec<DoubleDouble>)| {
            let scaled = row.iter().enumerate().map(|(j, &entry)| logarithm(entry) + f64::from(units[i] + units[j]));
            scaled.fold(f64::NEG_INFINITY, f64::max)
        };
        let steps: Vec<f64> = entries.iter().enumerate().map(largest).collect();
        for (unit, step) in units.iter_mut().zip(steps).filter(|(_, step)| step.is_finite()) {
            *unit -= (step / 2.0).round() as i32;
        }
    }
    units
}

/// Negative pivots by elimination with complete pivoting; `None` where entries grow beyond what is expected.
fn eliminated(mut a: Matrix) -> Option<u64> {
    let mut left: Vec<usize> = (0..a.len()).collect();
    let mut negative = 0;
    while !left.is_empty() {
        let diagonal = left.iter().copied().max_by(|&i, &j| size(a[i][i]).total_cmp(&size(a[j][j])))?;
        let pairs = left.iter().flat_map(|&i| left.iter().map(move |&j| (i, j))).filter(|(i, j)| j < i);
        let beside = pairs.max_by(|&(i, j), &(k, l)| size(a[i][j]).total_cmp(&size(a[k][l])));
        let pivot = size(a[diagonal][diagonal]);
        let largest = beside.map_or(0.0, |(i, j)| size(a[i][j]));
        // a NaN is in no range
        if !(f64::MIN_POSITIVE..GROWTH).contains(&pivot.max(largest)) {
            return None;
        }
        let pivots = match beside {
            Some((i, j)) if pivot < THRESHOLD * largest => {
                negative += 1;
                vec![i, j]
            }
            _ => {
                negative += u64::from(a[diagonal][diagonal] < double(0.0));
                vec![diagonal]
            }
        };
        left.retain(|index| !pivots.contains(index));
        eliminate(&mut a, &pivots, &left);
    }
    Some(negative)
}

/// Takes one or two unknowns out of the rows that are left.
fn eliminate(a: &mut Matrix, pivots: &[usize], left: &[usize]) {
    let zero = double(0.0);
    let touched: Vec<usize> =
        left.iter().copied().filter(|&k| pivots.iter().any(|&pivot| a[k][pivot] != zero)).collect();
    for &k in &touched {
        let factors = match *pivots {
            [i, j] => {
                let (p, q, r, x, y) = (a[i][i], a[i][j], a[j][j], a[k][i], a[k][j]);
                let determinant = p * r - q * q;
                vec![(i, (r * x - q * y) / determinant), (j, (p * y - q * x) / determinant)]
            }
            _ => pivots.iter().map(|&i| (i, a[k][i] / a[i][i])).collect(),
        };
        for &l in &touched {
            for &(pivot, factor) in &factors {
                a[k][l] = a[k][l] - factor * a[pivot][l];
            }
        }
    }
}

/// Closed form: the eigenvalues of `[[0, 1], [1, 0]]` are ±1, beside one that is nearly zero.
#[test]
fn signs_are_told_as_far_as_rounding_allows() {
    let matrix = |small: f64| {
        let numbers = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, small]];
        Assembled { entries: numbers.map(|row| row.map(double).into()).into(), sizes: vec![vec![1.0; 3]; 3] }
    };
    assert_eq!(negative(&matrix(1.0)), Some(1));
    assert_eq!(negative(&matrix(-1.0)), Some(2));
    let mut coupled = matrix(1.0);
    coupled.entries[2][2] = double(1e-32);
    coupled.entries[2][0] = double(1e-3);
    coupled.entries[0][2] = double(1e-3);
    // the determinant is -1e-32
    assert_eq!(negative(&coupled), None);
}
