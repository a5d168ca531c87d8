//! Entries are added up, and variables replaced: the errors of the rows cover what the stored matrix is off by.

use crate::proof::ball::Ball;
use crate::proof::front::{Front, Variable, substitute};
use crate::proof::level::Level;
use crate::proof::number::{OneWord, TwoWords};
use crate::proof::row::Term;
use crate::proof::tests::arithmetic::number;
use crate::proof::tests::exact::{Exact, Exactly, exact};
use crate::proof::tests::random::Random;
use crate::proof::tests::step::used;
use crate::proof::tests::worst::{WAYS, Worst, choose};
use std::vec;
use std::vec::Vec;

/// A front whose entries are sums of balls, and the exact sums of numbers of these, most of them at the ends.
struct Assembled {
    exact: Vec<Vec<Exact>>,
}

/// A ball and a number of it.
fn ball<N: Exactly>(random: &mut Random, scale: f64, radius: f64) -> (Ball<N>, Exact) {
    let mid = number::<N>(random, 0.5).times(N::of(scale));
    let rad = radius * mid.size();
    let end = [1.0, -1.0, 0.0][random.below(3)];
    (Ball { mid, rad }, mid.exactly() + exact(rad) * exact(end))
}

impl Assembled {
    /// Adds balls, of radii beside their sizes, at random places.
    fn new<N: Exactly>(
        front: &mut Front<'_, N>,
        random: &mut Random,
        size: usize,
        radius: f64,
        is_mixed: bool,
    ) -> Self {
        let scales: Vec<f64> = (0..size).map(|_| 10f64.powf(4.0 * random.signed())).collect();
        let mut exact = vec![vec![exact(0.0); size]; size];
        for _ in 0..size {
            front.enter().unwrap();
        }
        for _ in 0..12 {
            let (row, column) = (random.below(size), random.below(size));
            if !is_mixed && row == column {
                continue;
            }
            let (ball, number) = ball::<N>(random, scales[row] * scales[column], radius);
            if random.below(2) == 0 {
                front.grow(row, scales[row] * scales[row] * random.unit());
                front.grow(column, scales[column] * scales[column] * 10.0);
            }
            front.add(row, column, ball);
            exact[row][column] += &number;
            if row != column {
                exact[column][row] += &number;
            }
        }
        Assembled { exact }
    }

    /// What the errors of some variables use.
    fn used<N: Exactly>(&self, front: &Front<'_, N>, places: &[usize]) -> f64 {
        let off: Vec<Vec<Exact>> = places
            .iter()
            .map(|&i| places.iter().map(|&j| front.entry(i, j).exactly() - &self.exact[i][j]).collect())
            .collect();
        let errors: Vec<f64> = places.iter().map(|&i| front.error(i)).collect();
        used(&off, &errors)
    }

    /// Replaces the first variable by a combination of others.
    fn replace(&mut self, row: &[(usize, Exact)]) {
        let size = self.exact.len();
        // columns, then rows
        for k in 0..size {
            let moved = self.exact[k][0].clone();
            for (target, coefficient) in row {
                self.exact[k][*target] += &moved * coefficient;
            }
        }
        let moved = self.exact[0].clone();
        for (target, coefficient) in row {
            for k in 0..size {
                let change = &moved[k] * coefficient;
                self.exact[*target][k] += change;
            }
        }
    }
}

fn assembled<N: Exactly>(random: &mut Random, runs: usize) -> f64 {
    let mut largest = 0.0f64;
    for run in 0..runs {
        let size = 2 + run % 4;
        let (mut entries, mut variables) = ([N::of(0.0); 21], [Variable::none(); 6]);
        let mut front = Front::<N>::new(&mut entries, &mut variables, -1.0);
        // of exact balls nothing but the sums is off
        let radius = if run % 3 == 0 { 0.0 } else { 10f64.powf(-20.0 * random.unit()) };
        let parts = Assembled::new::<N>(&mut front, random, size, radius, run % 2 == 0);
        let places: Vec<usize> = (0..size).collect();
        let share = parts.used(&front, &places);
        assert!(share <= 1.0, "{}: errors of assembly are {share} times as large as said", N::NAME);
        largest = largest.max(share);
    }
    largest
}

fn replaced<N: Exactly + Level<Alone = N>>(random: &mut Random, runs: usize) -> f64 {
    let mut largest = 0.0f64;
    for run in 0..runs {
        let size = 2 + run % 4;
        let (mut entries, mut variables) = ([N::of(0.0); 21], [Variable::none(); 6]);
        let mut front = Front::<N>::new(&mut entries, &mut variables, -1.0);
        let radius = if run % 3 == 0 { 0.0 } else { 10f64.powf(-20.0 * random.unit()) };
        let mut parts = Assembled::new::<N>(&mut front, random, size, radius, true);
        let of_row = if run % 5 == 0 { 0.0 } else { 10f64.powf(-20.0 * random.unit()) };
        // the last one may name a variable twice
        let mut row = Vec::new();
        let mut exact_row = Vec::new();
        for _ in 0..random.below(4) {
            let target = 1 + random.below(size - 1);
            let size_of_it = 10f64.powf(2.0 * random.signed());
            let (coefficient, number) = ball::<N>(random, size_of_it, of_row);
            row.push((target, coefficient));
            exact_row.push((target, number));
        }
        // the sharpest case of a sum of coefficients
        if run % 4 == 1 {
            front.disturb(0, 1e3);
            parts.exact[0][0] += exact(1e3);
            let one = (Ball::of(1.0), exact(1.0));
            row = (1..size).map(|k| (k, one.0)).collect();
            exact_row = (1..size).map(|k| (k, one.1.clone())).collect();
        }
        let row: Vec<Term<N>> =
            row.into_iter().map(|(variable, coefficient)| Term::new(variable, coefficient)).collect();
        substitute(&mut front, 0, &row);
        parts.replace(&exact_row);
        let places: Vec<usize> = (1..size).collect();
        let share = parts.used(&front, &places);
        assert!(share <= 1.0, "{}: errors of a replacement are {share} times as large as said", N::NAME);
        largest = largest.max(share);
    }
    largest
}

fn check<N: Exactly + Level<Word = f64, Alone = N>>(runs: usize) {
    let mut random = Random::new(14);
    let shares = [assembled::<N>(&mut random, runs), replaced::<N>(&mut random, runs)];
    std::println!("{}: assembly and replacement use {shares:.3?} of the errors", N::NAME);
}

/// All numbers, and those that round to a worst side.
fn check_all(runs: usize, of_worst: usize) {
    check::<OneWord>(runs);
    check::<TwoWords<f64>>(runs);
    for way in WAYS {
        choose(way, way, 0.0, 5);
        check::<Worst>(of_worst);
    }
}

#[test]
fn errors_cover_what_is_added_and_replaced() {
    check_all(200, 50);
}

#[test]
#[ignore = "long: .ci/long"]
fn errors_cover_much_that_is_added_and_replaced() {
    check_all(50_000, 20_000);
}

/// What an entry between a stiff row and a soft one is off by does not drown the soft one.
#[test]
fn soft_rows_beside_stiff_ones_have_small_errors() {
    let (mut entries, mut variables) = ([OneWord(0.0); 3], [Variable::none(); 2]);
    let mut front = Front::<OneWord>::new(&mut entries, &mut variables, -1.0);
    for (row, size) in [(0, 1.0), (1, 1e12)] {
        front.enter().unwrap();
        front.grow(row, size);
    }
    front.add(1, 0, Ball { mid: OneWord(1e6), rad: 1e-7 });
    let [soft, stiff] = [0, 1].map(|row| front.error(row));
    assert!(soft < 4e-13 && stiff < 0.4 && soft * stiff >= 1e-14, "{soft} {stiff}");
}

/// Errors that underflow beside their weights are not lost.
#[test]
fn errors_that_underflow_are_not_lost() {
    for size in [1e200, 1.0, 1e-200] {
        let (mut entries, mut variables) = ([OneWord(0.0); 3], [Variable::none(); 2]);
        let mut front = Front::<OneWord>::new(&mut entries, &mut variables, -1.0);
        for row in 0..2 {
            front.enter().unwrap();
            front.grow(row, size);
        }
        let rad = 1e-250;
        front.add(1, 0, Ball { mid: OneWord(0.0), rad });
        assert!(front.error(0) >= rad && front.error(1) >= rad, "{size:e}");
    }
}
