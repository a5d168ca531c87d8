//! Sums, products, inverses and roots against many digits.

use crate::number::constants::{HALF_PI, LN_2, RECIPROCAL_FACTORIALS};
use crate::proof::ball::Ball;
use crate::proof::four_words::FourWords;
use crate::proof::level::Level;
use crate::proof::number::{Number, OneWord, TwoWords};
use crate::proof::tests::exact::{Exact, Exactly, exact, pi, share, size};
use crate::proof::tests::random::Random;

/// A number with all its words filled, of which some are zero or cancel.
pub(super) fn number<N: Number<Word = f64>>(random: &mut Random, decades: f64) -> N {
    let mut number = N::of(random.any_size(decades));
    let mut size = number.leading();
    for _ in 0..3 {
        size *= 1.1e-16 * random.signed() * if random.below(4) == 0 { 1e-9 } else { 1.0 };
        number = number.plus(N::of(size));
    }
    number
}

fn arithmetic<N: Level<Word = f64> + Exactly>(runs: usize) {
    let mut random = Random::new(1);
    let mut used = [0.0f64; 4];
    let mut note = |k: usize, ball: Ball<N>, expected: &Exact| {
        assert!(ball.rad < f64::INFINITY);
        let share = share(ball, expected);
        assert!(share <= 1.0, "{}: operation {k} {ball:?} uses {share}", N::NAME);
        used[k] = used[k].max(share);
    };
    for run in 0..runs {
        let a = number::<N>(&mut random, 20.0);
        // every other one nearly cancels
        let b = if run % 2 == 0 {
            number::<N>(&mut random, 20.0)
        } else {
            a.negated().plus(a.times(number(&mut random, 10.0)))
        };
        let ([a, b], [x, y]) = ([Ball::exactly(a), Ball::exactly(b)], [a.exactly(), b.exactly()]);
        note(0, a + b, &(&x + &y));
        note(1, a * b, &(&x * &y));
        note(2, a.inverse(), &(exact(1.0) / &x));
        if a.mid.leading() > 0.0 {
            note(3, a.root(), &x.sqrt());
        }
    }
    std::println!("{}: sum, product, inverse, root use {used:.3?} of their radii", N::NAME);
}

#[test]
fn sums_products_inverses_and_roots_are_in_their_balls() {
    arithmetic::<OneWord>(300);
    arithmetic::<TwoWords<f64>>(300);
    arithmetic::<FourWords>(300);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_sums_products_inverses_and_roots_are_in_their_balls() {
    arithmetic::<OneWord>(30_000);
    arithmetic::<TwoWords<f64>>(30_000);
    arithmetic::<FourWords>(30_000);
}

#[test]
fn inverses_and_roots_have_all_digits() {
    let mut random = Random::new(2);
    for _ in 0..100 {
        let a = Ball::exactly(number::<FourWords>(&mut random, 20.0));
        let inverse = a.inverse();
        assert!(inverse.rad <= 1e-59 * inverse.mid.size(), "{inverse:?}");
        if a.mid.leading() > 0.0 {
            let root = a.root();
            assert!(root.rad <= 1e-59 * root.mid.size(), "{root:?}");
        }
    }
}

#[test]
fn words_are_distilled_to_half_an_ulp_of_the_one_before() {
    let mut random = Random::new(3);
    for run in 0..300 {
        let a = number::<FourWords>(&mut random, 5.0);
        let b =
            if run % 2 == 0 { number(&mut random, 5.0) } else { a.negated().plus(a.times(number(&mut random, 20.0))) };
        for words in [a.plus(b), a.times(b)].map(FourWords::words) {
            for pair in words.windows(2) {
                assert_eq!(pair[0] + pair[1], pair[0], "{words:?}");
            }
        }
    }
    let lost = FourWords::of(f64::MAX).plus(FourWords::of(f64::MAX));
    assert!(lost.leading().is_nan());
    assert!(FourWords::of(f64::INFINITY).times(FourWords::of(1.0)).leading().is_nan());
}

#[test]
fn roots_of_zero_and_of_negative_numbers_are_not_claimed() {
    fn check<N: Level<Word = f64>>() {
        assert!(!Ball::<N>::of(0.0).root().rad.is_finite());
        assert!(!Ball::<N>::of(-2.0).root().rad.is_finite());
        assert!(!Ball::<N>::of(0.0).inverse().rad.is_finite());
        assert!(!Ball { mid: N::of(1.0), rad: 1.0 }.inverse().rad.is_finite());
        assert!(!Ball { mid: N::of(1.0), rad: 1.0 }.root().rad.is_finite());
    }
    check::<OneWord>();
    check::<TwoWords<f64>>();
    check::<FourWords>();
}

#[test]
fn a_pair_of_words_is_in_its_ball() {
    let pair = [1.0 / 3.0, 1.8e-17];
    let number = exact(pair[0]) + exact(pair[1]);
    assert!(share(Ball::<OneWord>::of_pair(pair), &number) <= 1.0);
    assert_eq!(Ball::<TwoWords<f64>>::of_pair(pair).mid.exactly(), number);
    assert_eq!(Ball::<FourWords>::of_pair(pair).rad, 0.0);
}

#[test]
fn constants_leave_what_they_are_said_to() {
    let sum = |parts: &[f64]| parts.iter().fold(exact(0.0), |sum, part| sum + exact(*part));
    let (half_pi, ln_2) = (pi() / exact(2.0), exact(2.0).ln());
    for (count, rest) in [OneWord::PARTS, TwoWords::<f64>::PARTS, FourWords::PARTS] {
        assert!(size(&(&half_pi - sum(&HALF_PI[..count]))) <= rest);
        assert!(size(&(&ln_2 - sum(&LN_2[..count]))) <= rest);
    }
    let mut reciprocal = exact(1.0);
    for (n, parts) in RECIPROCAL_FACTORIALS.iter().enumerate() {
        if n > 0 {
            reciprocal /= exact(n as f64);
        }
        assert!(share(Ball::<OneWord>::reciprocal_factorial(n), &reciprocal) <= 1.0);
        assert!(share(Ball::<TwoWords<f64>>::reciprocal_factorial(n), &reciprocal) <= 1.0);
        assert!(share(Ball::<FourWords>::reciprocal_factorial(n), &reciprocal) <= 1.0, "{n} {parts:?}");
    }
}
