//! One variable leaves: the errors of the rows that stay cover what the stored entries are off by, as a matrix.

use crate::proof::four_words::FourWords;
use crate::proof::front::{Front, Variable};
use crate::proof::number::{Number, OneWord, TwoWords};
use crate::proof::tests::arithmetic::number;
use crate::proof::tests::exact::{Exact, Exactly, exact, word};
use crate::proof::tests::random::Random;
use crate::proof::tests::worst::{WAYS, Worst, choose};
use crate::proof::word::Word;
use nalgebra::DMatrix;
use std::vec::Vec;

/// The least t such that `t diag(errors) ± off` is semidefinite: one at most, if the errors cover.
pub(super) fn used(off: &[Vec<Exact>], errors: &[f64]) -> f64 {
    let scaled = |row: usize, column: usize| word(&off[row][column]) / errors[row].sqrt() / errors[column].sqrt();
    let matrix = DMatrix::from_fn(errors.len(), errors.len(), scaled);
    assert!(matrix.iter().all(|entry| entry.is_finite()), "{errors:?}");
    matrix.symmetric_eigenvalues().iter().fold(0.0, |largest, value| value.abs().max(largest))
}

/// What entries are like.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Any, of ratios as large as 1e±12.
    Any,
    /// What is left is far less than what is taken: products are all that rounds.
    Products,
    /// What is taken is far less than what is left: sums are all that rounds.
    Sums,
}

fn step<N: Exactly>(random: &mut Random, size: usize, kind: Kind) -> f64 {
    let (mut entries, mut variables) = ([N::of(0.0); 21], [Variable::none(); 6]);
    let toward = if random.below(2) == 0 { 1.0 } else { -1.0 };
    let mut front = Front::<N>::new(&mut entries, &mut variables, toward);
    let scales: Vec<f64> = (0..size).map(|_| 10f64.powf(6.0 * random.signed())).collect();
    let pivot = number::<N>(random, 8.0);
    for row in 0..size {
        front.enter().unwrap();
        front.grow(row, scales[row] * scales[row]);
    }
    front.put(0, 0, pivot);
    for row in 1..size {
        let scale = match kind {
            Kind::Any => scales[row] * 10f64.powf(3.0 * random.signed()),
            Kind::Products => scales[row],
            Kind::Sums => 1e-7 * scales[row] * pivot.size().sqrt(),
        };
        front.put(row, 0, number::<N>(random, 0.3).times(N::of(scale)));
        for column in 1..=row {
            let product = front.entry(row, 0).times(front.entry(column, 0)).times(pivot.near_inverse());
            let any = number::<N>(random, 0.3).times(N::of(scales[row])).times(N::of(scales[column]));
            front.put(
                row,
                column,
                match kind {
                    Kind::Products => product,
                    Kind::Any | Kind::Sums => any,
                },
            );
        }
    }
    // the pivot has an error, of which most of the ones are small
    front.disturb(0, pivot.size() * 10f64.powf(-17.0 + 15.0 * random.unit()) * random.unit());
    let before = front.error(0);
    let old: Vec<Vec<Exact>> = (0..size).map(|i| (0..size).map(|j| front.entry(i, j).exactly()).collect()).collect();
    let nudge = before + pivot.size() * (2.1 * N::SUM);
    front.leave(0);
    let moved = pivot.plus(N::of(toward * nudge));
    let d = moved.exactly();
    // the theorem's first demand; the error is taken 1e-6 larger than it is, for its own roundings
    assert!(exact(toward) * (&d - &old[0][0]) >= exact(before * (1.0 - 0.9e-6)), "{}", N::NAME);
    let off: Vec<Vec<Exact>> = (1..size)
        .map(|i| {
            let complement = |j: usize| &old[i][j] - &old[i][0] * &old[0][j] / &d;
            (1..size).map(|j| front.entry(i, j).exactly() - complement(j)).collect()
        })
        .collect();
    let errors: Vec<f64> = (1..size).map(|i| front.error(i)).collect();
    assert_eq!(front.total.negative, moved.leading().one_if_negative());
    used(&off, &errors)
}

fn steps<N: Exactly>(random: &mut Random, runs: usize) {
    let mut largest = [0.0f64; 3];
    for run in 0..runs {
        for (k, kind) in [Kind::Any, Kind::Products, Kind::Sums].into_iter().enumerate() {
            let share = step::<N>(random, 2 + run % 5, kind);
            assert!(share <= 1.0, "{}, {kind:?}: errors are {share} times as large as said", N::NAME);
            largest[k] = largest[k].max(share);
        }
    }
    std::println!("{}: a step uses {largest:.3?} of the errors", N::NAME);
}

/// The worst roundings: in all ways, with inverses that are off by more than a rounding.
fn worst_steps(runs: usize) {
    let mut random = Random::new(12);
    for sums in WAYS {
        for products in WAYS {
            for of_inverses in [0.0, 1e-13, -3e-12] {
                choose(sums, products, of_inverses, 77);
                for run in 0..runs {
                    for kind in [Kind::Any, Kind::Products, Kind::Sums] {
                        let share = step::<Worst>(&mut random, 2 + run % 5, kind);
                        assert!(share <= 1.0, "{sums:?} {products:?} {of_inverses}, {kind:?}: {share}");
                    }
                }
            }
        }
    }
}

#[test]
fn errors_of_a_step_cover_what_it_rounds() {
    let mut random = Random::new(11);
    steps::<OneWord>(&mut random, 100);
    steps::<TwoWords<f64>>(&mut random, 60);
    steps::<FourWords>(&mut random, 10);
}

#[test]
fn errors_of_a_step_cover_the_worst_roundings() {
    worst_steps(2);
}

#[test]
#[ignore = "long: .ci/long"]
fn errors_of_many_steps_cover_what_they_round() {
    let mut random = Random::new(13);
    steps::<OneWord>(&mut random, 30_000);
    steps::<TwoWords<f64>>(&mut random, 30_000);
    steps::<FourWords>(&mut random, 1_000);
    worst_steps(300);
}

/// A pivot whose inverse is none, or not a number, says nothing.
#[test]
fn what_has_no_inverse_is_lost() {
    for (pivot, of_inverses) in [(1.0, 1e-3), (1.0, f64::NAN), (f64::NAN, 0.0), (f64::INFINITY, 0.0), (1e-320, 0.0)] {
        choose(WAYS[0], WAYS[0], of_inverses, 1);
        let (mut entries, mut variables) = ([Worst(0.0); 3], [Variable::none(); 2]);
        let mut front = Front::<Worst>::new(&mut entries, &mut variables, -1.0);
        for row in 0..2 {
            front.enter().unwrap();
            front.grow(row, 1.0);
            front.put(row, 0, Worst(1.0));
        }
        front.put(0, 0, Worst(pivot));
        front.put(1, 1, Worst(5.0));
        front.leave(0);
        front.leave(1);
        // a pivot far below what underflows is one of that size, and a bound
        assert!(front.total.negative.is_nan() || pivot == 1e-320, "{pivot} {of_inverses}");
    }
}

/// A pivot that is exactly zero after it was moved counts against the claim.
#[test]
fn a_pivot_of_zero_is_on_the_safe_side() {
    for (toward, negative) in [(-1.0, 1.0), (1.0, 0.0)] {
        let (mut entries, mut variables) = ([OneWord(0.0); 1], [Variable::none(); 1]);
        let mut front = Front::<OneWord>::new(&mut entries, &mut variables, toward);
        front.enter().unwrap();
        front.disturb(0, 0.3);
        // the entry that the nudge takes away
        let mut size = 0.3;
        for _ in 0..20 {
            size = front.error(0) + size * (2.1 * OneWord::SUM);
        }
        front.put(0, 0, OneWord(-toward * size));
        front.leave(0);
        assert!(front.total.smallest < 1e-200, "not a test");
        assert_eq!(front.total.negative, negative);
    }
}
