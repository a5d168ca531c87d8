//! Operations and functions of complex balls against many digits.

use crate::proof::disc::complex::ComplexBall;
use crate::proof::four_words::FourWords;
use crate::proof::level::Level;
use crate::proof::number::{OneWord, TwoWords};
use crate::proof::tests::arithmetic::number;
use crate::proof::tests::discs::exact_complex::{ExactComplex, points, share};
use crate::proof::tests::exact::Exactly;
use crate::proof::tests::random::Random;

/// A ball of some decades; every third one is wide.
fn ball<N: Level<Word = f64>>(random: &mut Random, decades: f64) -> ComplexBall<N> {
    let [re, im] = [(); 2].map(|()| number::<N>(random, decades));
    let exact = ComplexBall::exactly(re, im);
    let rad = if random.below(3) == 0 { exact.size() * 10f64.powf(-25.0 * random.unit() - 0.3) } else { 0.0 };
    ComplexBall { rad, ..exact }
}

/// What operations use of their radii.
struct Used<const K: usize> {
    used: [f64; K],
    known: [usize; K],
}

impl<const K: usize> Used<K> {
    fn new() -> Self {
        Used { used: [0.0; K], known: [0; K] }
    }

    fn note<N: Exactly>(&mut self, k: usize, ball: ComplexBall<N>, number: &ExactComplex, is_wide: bool) {
        let Some(share) = share(ball, number) else { return };
        assert!(share <= 1.0, "{}: operation {k}, {ball:?} uses {share} for {number:?}", N::NAME);
        self.known[k] += 1;
        if !is_wide {
            self.used[k] = self.used[k].max(share);
        }
    }
}

fn operations<N: Level<Word = f64> + Exactly>(runs: usize) {
    let mut random = Random::new(11);
    let mut used = Used::<5>::new();
    for run in 0..runs {
        let a = ball::<N>(&mut random, 12.0);
        // every other one nearly cancels
        let b = if run % 2 == 0 { ball(&mut random, 12.0) } else { -a + a * ball(&mut random, 5.0) };
        let b = if run % 4 == 1 { ComplexBall { rad: 0.0, ..b } } else { b };
        let is_wide = a.rad > 0.0 || b.rad > 0.0;
        for x in &points(a) {
            for y in &points(b) {
                used.note(0, a + b, &(x + y), is_wide);
                used.note(1, a * b, &(x * y), is_wide);
            }
            used.note(2, a.inverse(), &(&ExactComplex::of(1.0, 0.0) / x), is_wide);
            let root = a.root();
            let near = x.sqrt();
            let is_opposite = (&ExactComplex::centre(root) - &near).size() > near.size();
            used.note(3, root, &if is_opposite { -&near } else { near }, is_wide);
            used.note(4, a.times_i(), &(x * &ExactComplex::of(0.0, 1.0)), is_wide);
        }
    }
    std::println!("{}: sum, product, inverse, root use {:.3?} of their radii", N::NAME, used.used);
    assert!(used.known.iter().all(|known| 10 * known >= 8 * runs), "{:?}", used.known);
}

#[test]
fn operations_are_in_their_balls() {
    operations::<OneWord>(200);
    operations::<TwoWords<f64>>(200);
    operations::<FourWords>(100);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_operations_are_in_their_balls() {
    operations::<OneWord>(20_000);
    operations::<TwoWords<f64>>(20_000);
}

/// `Σ y^k/(stride k + first)!`.
fn exact_series(y: &ExactComplex, first: usize, stride: usize) -> ExactComplex {
    let mut term = ExactComplex::of(1.0, 0.0);
    (1..=first).for_each(|n| term = &term / &ExactComplex::of(n as f64, 0.0));
    let mut sum = ExactComplex::of(0.0, 0.0);
    for k in 0..90 {
        sum = &sum + &term;
        term = &term * y;
        (1..=stride).for_each(|n| term = &term / &ExactComplex::of((stride * k + first + n) as f64, 0.0));
    }
    sum
}

fn functions<N: Level<Word = f64> + Exactly>(runs: usize) {
    let mut random = Random::new(12);
    let mut used = Used::<5>::new();
    for _ in 0..runs {
        let decay = ball::<N>(&mut random, 2.5);
        for x in &points(decay) {
            used.note(0, decay.decay(), &(-x).exp(), decay.rad > 0.0);
        }
        let y = ball::<N>(&mut random, 3.0);
        let size = y.largest();
        let small = |most: f64| if size < most { y } else { y.scaled(most / size * 0.9).scaled(1.0) };
        let [one, four] = [small(1.0), small(4.0)].map(|y| if y.largest() <= 4.0 { y } else { ComplexBall::of(0.5) });
        for x in &points(one) {
            used.note(1, one.series::<0, 2>(), &exact_series(x, 0, 2), one.rad > 0.0);
            used.note(2, one.series::<1, 2>(), &exact_series(x, 1, 2), one.rad > 0.0);
        }
        for x in &points(four) {
            used.note(3, four.series::<1, 4>(), &exact_series(x, 1, 4), four.rad > 0.0);
            used.note(4, four.series::<4, 4>(), &exact_series(x, 4, 4), four.rad > 0.0);
        }
    }
    std::println!("{}: decay and series use {:.3?} of their radii", N::NAME, used.used);
    assert!(used.known.iter().all(|known| *known >= runs / 2), "{:?}", used.known);
}

#[test]
fn decays_and_series_are_in_their_balls() {
    functions::<OneWord>(100);
    functions::<TwoWords<f64>>(100);
    functions::<FourWords>(30);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_decays_and_series_are_in_their_balls() {
    functions::<OneWord>(5_000);
    functions::<TwoWords<f64>>(5_000);
}

/// Radii are of the size of the rounding, not larger by powers of ten.
#[test]
fn functions_have_nearly_all_digits() {
    fn check<N: Level<Word = f64>>() {
        for (re, im) in [(0.3, 0.2), (1.0, -3.0), (0.1, 20.0), (-0.01, 5.0), (20.0, 7.0)] {
            let x = ComplexBall::<N>::exactly(N::of(re), N::of(im));
            for value in [x.inverse(), x.root(), x.decay(), (x * x.inverse().scaled(0.5)).series::<1, 2>()] {
                assert!(value.rad <= 200.0 * N::SUM * value.size(), "{x:?}: {value:?}");
            }
        }
    }
    check::<OneWord>();
    check::<TwoWords<f64>>();
    check::<FourWords>();
}

/// Whether neither bound of the size of a ball is one.
fn says_nothing<N: Level<Word = f64>>(ball: ComplexBall<N>) -> bool {
    let (has_least, has_largest) = (ball.least() > 0.0, ball.largest() < 1e300);
    !has_least && !has_largest
}

/// What is not a number says nothing, and never a bound.
#[test]
fn what_is_not_known_says_nothing() {
    type Ball = ComplexBall<TwoWords<f64>>;
    let zero = Ball::of(0.0);
    let around_zero = Ball::of(1e-3).widened(2e-3);
    let unknown = Ball::of(1.0).widened(f64::INFINITY);
    for ball in [
        zero.inverse(),
        around_zero.inverse(),
        around_zero.root(),
        zero.root(),
        unknown.decay(),
        unknown.series::<1, 2>(),
    ] {
        assert!(!ball.rad.is_finite(), "{ball:?}");
    }
    for ball in [unknown, unknown * zero, around_zero.inverse()] {
        assert!(says_nothing(ball), "{ball:?}");
    }
    assert!(says_nothing(Ball::of(f64::NAN)));
}
