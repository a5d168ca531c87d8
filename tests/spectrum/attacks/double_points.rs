//! Counts a number at a time about points where two frequencies of a general beam are one: both waves of a stocky beam are whole half waves,
//! a clamped column on a foundation buckles in two ways.

use super::exact::{Double, count_is_right, double, moved, pi, square};
use super::in_full;
use crate::general_chains::chain::{Chain, Link};
use crate::general_chains::families::{PLAIN, split};
use crate::oracles::many_digits::exact;
use crate::oracles::short_pieces::roots_below;
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::GeneralBeam;
use mstmm::list::StepList;
use mstmm::number::{Parameter, Scalar};
use mstmm::prelude::*;
use mstmm::search::critical_loads;

/// Numbers on both sides of a point.
const ABOUT: i64 = 20;

/// How far parameters are moved, in numbers.
const MOVES: [i64; 7] = [0, -20, -3, -1, 1, 3, 20];

fn between(tip: Support, links: Vec<Link>, root: Support) -> Chain {
    Chain { tip, links, root }
}

/// The exact count of a pinned beam: in each number of half waves the energy is a form of two numbers, `(Y' - Θ)²/f + EI Θ'² + N Y'² + k Y²`
/// less `ω² (m Y² + r Θ²)`. With none the sections turn as one. None where two words do not tell a sign.
fn of_sines(beam: &GeneralBeam<f64>, omega: f64) -> Option<u64> {
    let [ga, r, n, k] =
        [beam.shear_stiffness, beam.rotary_inertia, beam.axial_force, beam.foundation_stiffness].map(double);
    let (omega, one) = (square(omega), double(1.0));
    let f = one / ga;
    let sure = |value: Double, size: Double| (value.abs() > size.abs() * double(1e-27)).then_some(value < double(0.0));
    let mut count = u64::from(sure(one - omega * r * f, one)?);
    for waves in 1..40 {
        let wave = pi(waves) / double(beam.length);
        let (of_y, of_theta) =
            ((wave * wave + (n * wave * wave + k - omega) * f), (one + (wave * wave - omega * r) * f));
        let (product, mixed) = (of_y * of_theta, wave * wave);
        count += match sure(product - mixed, mixed)? {
            true => 1,
            false if of_y < double(0.0) => 2,
            false => 0,
        };
    }
    Some(count)
}

/// Stocky beams with EI = m = l = 1 whose waves are `mπ` and `nπ` at one frequency, and that frequency: of `κ²` their sum is `ω² (r + f)`, their product
/// `ω² (r f ω² - 1)`.
fn stocky(m: u32, n: u32, share: f64) -> Vec<(GeneralBeam<f64>, f64)> {
    let [a, b] = [m, n].map(|waves| f64::from(waves) * std::f64::consts::PI);
    let (sum, product) = (a * a + b * b, a * a * b * b);
    let f = share / ((a - b) * (a - b));
    let middle = sum * f - 1.0;
    let rest = (middle * middle - 4.0 * f * f * product).sqrt();
    let beam = |square: f64| {
        let r = sum / square - f;
        (r > 0.0 && r < 10.0)
            .then_some((GeneralBeam { shear_stiffness: 1.0 / f, rotary_inertia: r, ..PLAIN }, square.sqrt()))
    };
    [middle - rest, middle + rest].into_iter().filter_map(|twice| beam(twice / (2.0 * f * f))).collect()
}

/// Closed form for pinned ends; for clamped ones many digits, and the same beam in two parts. A count is never off by two.
fn two_waves(shares: usize) {
    let random = &mut Random(0xf10a7);
    let (mut counts, mut unproven, mut skipped, mut jumps) = (0, 0, 0, 0);
    for (m, n) in [(1, 2), (1, 3), (2, 3), (1, 4), (2, 4), (3, 4), (2, 5), (1, 5), (3, 5), (4, 5)] {
        for _ in 0..shares {
            for (point, omega) in stocky(m, n, 1.01 + 2.0 * random.unit() * random.unit()) {
                for (df, dr) in
                    [(0, 0), (random.pick(MOVES), random.pick(MOVES)), (random.pick(MOVES), random.pick(MOVES))]
                {
                    let beam = GeneralBeam {
                        shear_stiffness: moved(point.shear_stiffness, df),
                        rotary_inertia: moved(point.rotary_inertia, dr),
                        ..point
                    };
                    let pinned = between(Support::Pinned, vec![Link::Beam(beam)], Support::Pinned);
                    let steps = pinned.steps();
                    let list = StepList::new(&steps).unwrap();
                    let mut ends = [u64::MAX, 0];
                    for omega in (-ABOUT..=ABOUT).map(|by| moved(omega, by)) {
                        let Some(expected) = of_sines(&beam, omega) else {
                            skipped += 1;
                            continue;
                        };
                        counts += 1;
                        let (bounds, count) = (list.count_bounds(omega), list.count_below(omega));
                        assert!(
                            count_is_right(bounds, &count, expected),
                            "{expected} {bounds:?} {count:?} {omega} {beam:?}"
                        );
                        unproven += u64::from(count.is_err());
                        ends = [ends[0].min(expected), ends[1].max(expected)];
                    }
                    jumps += u64::from(ends[1] == ends[0] + 2);
                    clamped_counts(&beam, omega, random);
                }
            }
        }
    }
    println!("| two waves at once | {counts} | {unproven} | {skipped} | {jumps} |");
    assert!(jumps > 0 && skipped * 100 < counts && unproven * 100 < counts);
}

/// Counts of the same beam with clamped ends, whole and in two parts.
fn clamped_counts(beam: &GeneralBeam<f64>, omega: f64, random: &mut Random) {
    let parts = [3.0, 5.0].map(|eighths| Link::Beam(GeneralBeam { length: 0.125 * eighths * beam.length, ..*beam }));
    let [whole, parts] =
        [vec![Link::Beam(*beam)], parts.to_vec()].map(|links| between(Support::Fixed, links, Support::Fixed));
    let [whole_steps, part_steps] = [&whole, &parts].map(Chain::steps);
    let lists = [&whole_steps, &part_steps].map(|steps| StepList::new(steps).unwrap());
    for by in [-ABOUT, -1, 0, 1, ABOUT, random.below(41) as i64 - ABOUT] {
        let omega = moved(omega, by);
        let many = exact(omega, 320);
        let Some(expected) = roots_below(&whole, &(&many * &many)) else { continue };
        for list in &lists {
            let (bounds, count) = (list.count_bounds(omega), list.count_below(omega));
            assert!(
                count_is_right(bounds, &count, expected),
                "clamped {expected} {bounds:?} {count:?} {omega} {beam:?}"
            );
        }
    }
}

/// A clamped column of l = EI = m = 1 has waves a, b with `a² + b² = P`, `a² b² = k - ω²`. Its even modes are the zeros of
/// `a sin(a/2) cos(b/2) - b sin(b/2) cos(a/2)`, its odd ones of `b sin(a/2) cos(b/2) - a sin(b/2) cos(a/2)`.
fn of_halves(force: f64, density: Double) -> [Double; 2] {
    let half = double(force) * double(0.5);
    let root = (half * half - density).sqrt();
    let [a, b] = [half - root, half + root].map(|square| square.sqrt());
    let [(sin_a, cos_a), (sin_b, cos_b)] = [a, b].map(|wave| (wave * double(0.5)).sin_cos());
    [a * sin_a * cos_b - b * sin_b * cos_a, b * sin_a * cos_b - a * sin_b * cos_a]
}

fn column(force: f64, foundation: f64, is_in_parts: bool) -> Chain {
    let beam = GeneralBeam { axial_force: -force, foundation_stiffness: foundation, ..PLAIN };
    between(Support::Fixed, split(&beam, if is_in_parts { 4 } else { 1 }), Support::Fixed)
}

/// Oracle: far below the point many digits; about it the signs of both closed forms, each of which changes once. In parts the poles of the whole are
/// frequencies.
fn double_columns(models: usize) {
    let random = &mut Random(0xc01);
    let (mut counts, mut unproven, mut jumps) = (0, 0, 0);
    for (a, b) in [(1_u32, 3_u32), (2, 4), (3, 5), (1, 5)] {
        let squares = [a, b].map(|waves| (pi(waves) * pi(waves)).parts().0);
        for _ in 0..models {
            let omega = 10_f64.powf(-1.0 + 3.5 * random.unit());
            let force = moved(squares[0] + squares[1], random.pick(MOVES));
            let foundation = moved(squares[0] * squares[1] + omega * omega, random.pick(MOVES));
            let density = |omega: f64| double(foundation) - square(omega);
            // where the waves are whole half waves for the numbers that were moved
            let point = (double(foundation) - double(squares[0]) * double(squares[1])).sqrt().to_f64();
            let low = point * (1.0 - 1e-6);
            for is_in_parts in [false, true] {
                let chain = column(force, foundation, is_in_parts);
                let steps = chain.steps();
                let list = StepList::new(&steps).unwrap();
                let many = exact(low, 320);
                let below = roots_below(&chain, &(&many * &many)).unwrap();
                let signs = of_halves(force, density(low)).map(|value| value < double(0.0));
                let exact_count = |omega: f64| {
                    let here = of_halves(force, density(omega)).map(|value| value < double(0.0));
                    below + here.iter().zip(signs).map(|(here, low)| u64::from(*here != low)).sum::<u64>()
                };
                let near = (-ABOUT..=ABOUT).map(|by| moved(point, by));
                let wide = (1..40).flat_map(|k| [-1.0, 1.0].map(|side| point * (1.0 + side * 1e-15 * 1.7_f64.powi(k))));
                for omega in near.chain(wide.filter(|omega| (omega / point - 1.0).abs() < 1e-7)) {
                    let expected = exact_count(omega);
                    let (bounds, count) = (list.count_bounds(omega), list.count_below(omega));
                    let [least, most] = bounds;
                    let agrees = count.as_ref().map_or(true, |count| *count == expected);
                    assert!(
                        least <= expected && expected <= most && agrees,
                        "{expected} {bounds:?} {count:?} {omega} {chain:?}"
                    );
                    counts += 1;
                    unproven += u64::from(least < most);
                }
                jumps += u64::from(exact_count(point * (1.0 + 1e-6)) == below + 2);
            }
        }
    }
    println!("| clamped columns at double frequencies | {counts} | {unproven} | {jumps} |");
    assert!(jumps >= 6 * models as u64 && unproven * 100 < counts);
}

system! {
    struct Clamped { foundation: f64, load: f64 }
    fixed -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load, foundation_stiffness: foundation
    } -> fixed
}

/// Closed form: with `k = a² b²` a clamped column buckles in two ways under `a² + b²`, for waves `jπ` and `(j + 2)π`.
#[test]
fn clamped_columns_buckle_in_two_ways_at_once() {
    for a in 1..4 {
        let [one, other] = [a, a + 2].map(|waves: u32| (pi(waves) * pi(waves)).parts().0);
        for by in -ABOUT..=ABOUT {
            let (exact, foundation) = (one + other, moved(one * other, by));
            let loads =
                critical_loads::<8, _>(0.99 * exact..=1.01 * exact, |load| Clamped { foundation, load }.build())
                    .unwrap();
            assert_eq!(loads.iter().map(|load| load.multiplicity).sum::<u64>(), 2, "{a} {by} {loads:?}");
            assert!(loads.iter().all(|load| (load.factor / exact - 1.0).abs() < 1e-14), "{a} {by} {loads:?}");
        }
    }
}

in_full! {
    two_waves(1, 12) = some_points_of_two_waves, all_points_of_two_waves;
    double_columns(2, 40) = some_double_points_of_columns, all_double_points_of_columns;
}
