//! Elementary functions against many digits: nothing is outside of its ball.

use crate::proof::ball::Ball;
use crate::proof::four_words::FourWords;
use crate::proof::level::Level;
use crate::proof::number::{OneWord, TwoWords};
use crate::proof::tests::exact::{Exact, Exactly, exact, pi, share, word};
use crate::proof::tests::random::Random;
use std::vec::Vec;

/// Arguments: random ones in decades, the nearest floats to kπ/2, and those beside the limit of decays.
fn arguments(random: &mut Random, runs: usize) -> Vec<f64> {
    let mut all: Vec<f64> = (0..runs).map(|_| 10f64.powf(-6.0 + 11.0 * random.unit())).collect();
    let half_pi = pi() / exact(2.0);
    for count in 0..runs / 4 {
        let k = if count < 9 { count + 1 } else { 1 + random.below(1_048_575) };
        let near = word(&(&half_pi * exact(k as f64)));
        all.extend([near, near.next_up(), near.next_down(), near * (1.0 + 1e-12 * random.signed())]);
        // where the nearest number of quarter turns changes
        all.push(word(&(&half_pi * exact(k as f64 - 0.5))));
    }
    all.extend([0.0, 1.0, 1.0f64.next_up(), 650.0, 650.0f64.next_down(), 649.9999999, 700.0, 1e6, 1e9]);
    all
}

fn check<N: Level<Word = f64> + Exactly>(runs: usize) {
    let mut random = Random::new(4);
    let mut used = [0.0f64; 3];
    let mut note = |k: usize, ball: Ball<N>, expected: &Exact, [at, rad]: [f64; 2]| {
        let share = share(ball, expected);
        assert!(share <= 1.0, "{}: function {k} at {at:e}, {ball:?}, uses {share}", N::NAME);
        // of a wide ball the ends use all
        if rad == 0.0 {
            used[k] = used[k].max(share);
        }
    };
    for x in arguments(&mut random, runs) {
        // the rounded last word of an argument beside the exact one; every third one is a ball
        let mid = N::of(x).plus(N::of(x * 1e-17 * random.signed()));
        let rad = if random.below(3) == 0 { x * 10f64.powf(-30.0 * random.unit()) } else { 0.0 };
        let ball = Ball { mid, rad };
        let ([sine, cosine], decay) = (ball.sin_cos(), ball.decay());
        for end in if rad > 0.0 { [-1.0, 1.0].as_slice() } else { &[0.0] } {
            let at = mid.exactly() + exact(rad) * exact(*end);
            let (s, c) = at.sin_cos();
            note(0, sine, &s, [x, rad]);
            note(1, cosine, &c, [x, rad]);
            note(2, decay, &(-at).exp(), [x, rad]);
        }
    }
    std::println!("{}: sine, cosine, decay use {used:.3?} of their radii", N::NAME);
}

#[test]
fn sines_cosines_and_decays_are_in_their_balls() {
    check::<OneWord>(60);
    check::<TwoWords<f64>>(60);
    check::<FourWords>(60);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_sines_cosines_and_decays_are_in_their_balls() {
    check::<OneWord>(4_000);
    check::<TwoWords<f64>>(4_000);
    check::<FourWords>(4_000);
}

#[test]
fn functions_have_nearly_all_digits() {
    fn check<N: Level<Word = f64>>() {
        for x in [1e-3, 0.3, 1.0, 3.0, 20.0] {
            let ball = Ball::<N>::of(x);
            let [sine, cosine] = ball.sin_cos();
            for (value, factor) in [(sine, 40.0), (cosine, 40.0), (ball.decay(), 40.0)] {
                assert!(value.rad <= factor * N::SUM, "{x}: {value:?}");
            }
        }
    }
    check::<OneWord>();
    check::<TwoWords<f64>>();
    check::<FourWords>();
}

/// Checks K series at random arguments and at the ends.
fn check_series<N, const FIRST: usize, const K: usize, const STRIDE: usize, const SIXTEENTHS: usize>()
where
    N: Level<Word = f64> + Exactly,
{
    let (mut random, mut used, limit) = (Random::new(5), 0.0f64, SIXTEENTHS as f64 / 16.0);
    for run in 0..60 {
        let y = if run < 2 { limit * (1.0 - 2.0 * run as f64) } else { limit * random.signed() };
        let mid = N::of(y).plus(N::of(y * -1e-17 * random.unit()));
        let rad = if run % 3 == 2 { (limit - y.abs()) * 10f64.powf(-30.0 * random.unit()) } else { 0.0 };
        let balls = Ball { mid, rad }.series::<FIRST, K, STRIDE, SIXTEENTHS>();
        for (k, ball) in balls.into_iter().enumerate() {
            for end in [-1.0, 1.0] {
                let (first, y) = (FIRST + k, mid.exactly() + exact(rad) * exact(end));
                let mut term = (1..=first).fold(exact(1.0), |term, n| term / exact(n as f64));
                let mut sum = exact(0.0);
                for k in 0..120 {
                    sum += &term;
                    term = (1..=STRIDE).fold(term * &y, |term, n| term / exact((STRIDE * k + first + n) as f64));
                }
                let share = share(ball, &sum);
                assert!(share <= 1.0, "{}: {y} {first} {STRIDE} {share}", N::NAME);
                if rad == 0.0 {
                    used = used.max(share);
                }
            }
        }
    }
    std::println!("{}: series use {used:.3} of their radii", N::NAME);
}

#[test]
fn series_are_in_their_balls() {
    fn check<N: Level<Word = f64> + Exactly>() {
        check_series::<N, 2, 2, 2, 10>();
        check_series::<N, 2, 2, 2, 2>();
        check_series::<N, 0, 2, 2, 14>();
        check_series::<N, 1, 4, 4, 64>();
        check_series::<N, 1, 3, 4, 16>();
    }
    check::<OneWord>();
    check::<TwoWords<f64>>();
    check::<FourWords>();
}
