//! Matrices that are singular between two floats of their last entry: neither bound is false at either.

use crate::proof::ball::Ball;
use crate::proof::front::{Front, Variable};
use crate::proof::number::OneWord;
use crate::proof::tests::exact::{Exact, Exactly, exact, word};
use crate::proof::tests::random::Random;
use crate::proof::tests::worst::{WAYS, Worst, choose};
use std::vec;
use std::vec::Vec;

/// A matrix of floats but for its last entry, which makes it singular between `ends`; `below` of the eigenvalues of the others are negative.
struct Singular {
    matrix: Vec<Vec<f64>>,
    ends: [f64; 2],
    below: f64,
}

/// What the last entry has to be, and the number of negative pivots before it; none where a pivot vanishes.
fn last_entry(matrix: &[Vec<f64>]) -> Option<(Exact, f64)> {
    let size = matrix.len();
    let mut rest: Vec<Vec<Exact>> = matrix.iter().map(|row| row.iter().copied().map(exact).collect()).collect();
    let mut below = 0.0;
    for k in 0..size - 1 {
        let pivot = rest[k][k].clone();
        if pivot == exact(0.0) {
            return None;
        }
        below += if pivot < exact(0.0) { 1.0 } else { 0.0 };
        for i in k + 1..size {
            let factor = &rest[i][k] / &pivot;
            for j in k + 1..size {
                let product = &factor * &rest[k][j];
                rest[i][j] -= product;
            }
        }
    }
    // the last entry was zero
    Some((-rest[size - 1][size - 1].clone(), below))
}

impl Singular {
    fn new(random: &mut Random, size: usize) -> Option<Self> {
        let mut matrix = vec![vec![0.0; size]; size];
        let decades = [0.3, 3.0, 8.0][random.below(3)];
        for row in 0..size {
            for column in 0..=row {
                let entry = if random.below(5) == 0 { 0.0 } else { random.any_size(decades) };
                (matrix[row][column], matrix[column][row]) = (entry, entry);
            }
        }
        // some have a block before the last entry that is nearly singular itself
        if size > 2 && random.below(3) == 0 {
            let mut block: Vec<Vec<f64>> = matrix[..size - 1].iter().map(|row| row[..size - 1].to_vec()).collect();
            block[size - 2][size - 2] = 0.0;
            let near = word(&last_entry(&block)?.0);
            matrix[size - 2][size - 2] = near * (1.0 + 1e-15 * random.below(3) as f64);
        }
        matrix[size - 1][size - 1] = 0.0;
        let (last, below) = last_entry(&matrix)?;
        let near = word(&last);
        // a singular float is no test
        let ends = match exact(near).partial_cmp(&last)? {
            core::cmp::Ordering::Less => [near, near.next_up()],
            core::cmp::Ordering::Greater => [near.next_down(), near],
            core::cmp::Ordering::Equal => return None,
        };
        near.is_normal().then_some(Singular { matrix, ends, below })
    }

    /// The bound of the number of negative eigenvalues at an end.
    fn bound<N: Exactly>(&self, last: f64, toward: f64, is_added: bool) -> f64 {
        let size = self.matrix.len();
        let (mut entries, mut variables) = ([N::of(0.0); 21], [Variable::none(); 6]);
        let mut front = Front::<N>::new(&mut entries, &mut variables, toward);
        for row in 0..size {
            front.enter().unwrap();
            let own = if row + 1 == size { last } else { self.matrix[row][row] };
            front.grow(row, own.abs());
        }
        for row in 0..size {
            for column in 0..=row {
                let entry = if row + 1 == size && column == row { last } else { self.matrix[row][column] };
                if is_added {
                    front.add(row, column, Ball::of(entry));
                } else {
                    front.put(row, column, N::of(entry));
                }
            }
        }
        (0..size).for_each(|variable| front.leave(variable));
        front.total.negative
    }

    /// Both bounds hold at both ends.
    fn check<N: Exactly>(&self, is_added: bool) {
        for (last, below) in [(self.ends[0], self.below + 1.0), (self.ends[1], self.below)] {
            let [most, least] = [-1.0, 1.0].map(|toward| self.bound::<N>(last, toward, is_added));
            assert!(
                !(least > below || most < below),
                "{}: {:?} {last:e}: {least} {below} {most}",
                N::NAME,
                self.matrix
            );
        }
    }
}

fn check(seeds: core::ops::Range<u64>) {
    let mut count = 0;
    for seed in seeds {
        let mut random = Random::new(seed);
        let size = 2 + random.below(4);
        let Some(singular) = Singular::new(&mut random, size) else { continue };
        count += 1;
        for is_added in [false, true] {
            singular.check::<OneWord>(is_added);
            for sums in WAYS {
                for products in WAYS {
                    choose(sums, products, 0.0, seed);
                    singular.check::<Worst>(is_added);
                }
            }
        }
    }
    std::println!("{count} singular matrices, each in 52 ways");
    assert!(count > 0);
}

#[test]
fn no_bound_is_false_beside_a_singular_matrix() {
    check(0..400);
}

#[test]
#[ignore = "long: .ci/long"]
fn no_bound_is_false_beside_many_singular_matrices() {
    check(400..20_000);
}

/// Both bounds meet away from singular matrices: a test of the tests above.
#[test]
fn bounds_meet_elsewhere() {
    let (mut met, mut all) = (0, 0);
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let Some(singular) = Singular::new(&mut random, 3) else { continue };
        let last = singular.ends[1] + 1e-3 * singular.ends[1].abs();
        let [most, least] = [-1.0, 1.0].map(|toward| singular.bound::<OneWord>(last, toward, true));
        assert!(!(least > singular.below || most < singular.below));
        met += i32::from(most == least);
        all += 1;
    }
    assert!(met > all / 2, "{met} of {all}");
}
