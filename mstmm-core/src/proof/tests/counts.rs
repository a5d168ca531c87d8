//! Counts of members with their ends held against a count of the roots themselves.

use crate::proof::ball::Ball;
use crate::proof::bending::bending;
use crate::proof::four_words::FourWords;
use crate::proof::level::Level;
use crate::proof::line::line;
use crate::proof::member::Member;
use crate::proof::number::{OneWord, TwoWords};
use crate::proof::tests::exact::{Exact, Exactly, exact, pi, word};
use crate::proof::tests::members::{Oracle, POLES, exact_bending, exact_line, poles};
use crate::proof::tests::random::Random;
use std::vec::Vec;

/// Arguments a few floats about those of poles and of kπ, small ones, and random ones; below the last pole.
fn arguments(poles: &[Exact], power: i32, runs: usize) -> Vec<f64> {
    let mut random = Random::new(9);
    let to_power = |z: &Exact| word(&(0..power).fold(exact(1.0), |product, _| product * z));
    let last = to_power(&poles[POLES - 1]) * 0.99;
    let mut all: Vec<f64> = (0..runs).map(|_| last * random.unit().powi(power)).collect();
    let pi = pi();
    for k in 1..POLES {
        for z in [&poles[k - 1], &(&pi * exact(k as f64)), &(&pi * exact(k as f64 - 0.25))] {
            let mut x = to_power(z);
            (0..3).for_each(|_| x = x.next_down());
            for _ in 0..7 {
                all.push(x);
                x = x.next_up();
            }
            all.extend([x * (1.0 - 1e-9), x * (1.0 + 1e-9), x * (1.0 + 1e-4 * random.signed())]);
        }
    }
    all.extend([0.0, 1e-300, 1e-20, 1e-6, 0.5, 1.0, 1.0f64.next_down(), 1.0f64.next_up(), 3.0]);
    all.retain(|x| *x < last);
    all
}

/// Whether the bounds hold; those of a NaN do. Returns whether anything is known.
fn is_counted<N: Exactly, const F: usize, const E: usize>(
    member: &Member<N, F, E>,
    oracle: impl Fn() -> Oracle<F, E>,
    (poles, z): (&[Exact], &Exact),
    at: f64,
) -> bool {
    let mut count = poles.iter().filter(|pole| *pole < z).count() as f64;
    if member.border.is_some() && oracle().flexibility > exact(0.0) {
        count -= 1.0;
    }
    let [low, high] = member.held;
    assert!(!(low > count || high < count), "{} at {at:e}: {:?}, not {count}", N::NAME, member.held);
    low == high && member.stiffness[0].rad < f64::INFINITY
}

/// Every one of so many arguments.
fn check<N: Level<Word = f64> + Exactly>(runs: usize, every: usize) {
    let (of_beams, half_waves) = (poles(), (1..=POLES).map(|k| pi() * exact(k as f64)).collect::<Vec<_>>());
    let mut unknown = [0; 2];
    let mut bordered = [0; 2];
    for x in arguments(of_beams, 4, runs).into_iter().filter(|x| *x > 0.0).step_by(every) {
        let z = exact(x).sqrt().sqrt();
        let member = bending::<N>(Ball::of(x));
        bordered[0] += usize::from(member.border.is_some());
        unknown[0] += usize::from(!is_counted(&member, || exact_bending(&exact(x)), (of_beams, &z), x));
    }
    for x in arguments(&half_waves, 2, runs).into_iter().filter(|x| *x > 0.0).step_by(every) {
        let z = exact(x).sqrt();
        let member = line::<N>(Ball::of(x));
        bordered[1] += usize::from(member.border.is_some());
        unknown[1] += usize::from(!is_counted(&member, || exact_line(&exact(x)), (&half_waves, &z), x));
        let stiff = line::<N>(Ball::of(-x));
        assert!(stiff.held == [0.0; 2] && stiff.border.is_none());
    }
    std::println!("{}: {bordered:?} have borders, {unknown:?} are unknown", N::NAME);
    assert!(bordered.iter().all(|count| *count > 50));
    assert!(unknown == [0; 2] || N::SUM > 1e-20);
}

#[test]
fn held_frequencies_are_counted() {
    check::<OneWord>(50, 1);
    check::<TwoWords<f64>>(50, 2);
}

#[test]
#[ignore = "long: .ci/long"]
fn held_frequencies_are_counted_at_many_places() {
    check::<OneWord>(3_000, 1);
    check::<TwoWords<f64>>(3_000, 1);
    check::<FourWords>(1_000, 1);
}

#[test]
fn at_rest_nothing_is_held() {
    for x in [0.0, -0.0] {
        assert_eq!(bending::<TwoWords<f64>>(Ball::of(x)).held, [0.0; 2]);
        assert_eq!(line::<TwoWords<f64>>(Ball::of(x)).held, [0.0; 2]);
    }
}

/// A ball that holds a pole has no count, or the border; so has one in which a frequency of the border's freedom is.
#[test]
fn counts_hold_in_all_of_a_wide_ball() {
    fn check<N: Level<Word = f64> + Exactly>() {
        let (of_beams, half_waves) = (poles(), (1..=POLES).map(|k| pi() * exact(k as f64)).collect::<Vec<_>>());
        let mut random = Random::new(10);
        for run in 0..80 {
            let z = if run % 3 == 0 { word(&of_beams[random.below(9)]) } else { 25.0 * random.unit() + 0.1 };
            let part = 10f64.powf(-8.0 * random.unit()) * if run % 4 == 0 { 20.0 } else { 1.0 };
            let [beam, rod] = [4, 2].map(|power| Ball { mid: N::of(z.powi(power)), rad: z.powi(power) * part });
            let (bend, axial) = (bending::<N>(beam), line::<N>(rod));
            let mirrored = line::<N>(Ball { mid: rod.mid.negated(), rad: rod.rad });
            for at in [-1.0, -0.5, 0.0, 0.5, 1.0] {
                let place = |ball: Ball<N>| ball.mid.exactly() + exact(ball.rad) * exact(at);
                if word(&place(beam)) > 0.0 {
                    let root = place(beam).sqrt().sqrt();
                    is_counted(&bend, || exact_bending(&place(beam)), (of_beams, &root), word(&place(beam)));
                }
                if word(&place(rod)) > 0.0 {
                    let root = place(rod).sqrt();
                    is_counted(&axial, || exact_line(&place(rod)), (&half_waves, &root), word(&place(rod)));
                }
                let opposite = exact(rod.rad) * exact(at) - rod.mid.exactly();
                if word(&opposite) > 0.0 {
                    is_counted(&mirrored, || exact_line(&opposite), (&half_waves, &opposite.sqrt()), word(&opposite));
                }
            }
        }
    }
    check::<OneWord>();
    check::<TwoWords<f64>>();
}
