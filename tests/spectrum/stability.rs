//! Counts of motions that grow, against the negative eigenvalues of stiffness matrices, and searches that refuse them.
#![expect(clippy::unwrap_used, reason = "a failing search fails the test")]

pub(crate) mod link;
mod lists;

use crate::support::random_tree::Random;
use crate::support::roots::assert_same_intervals;
use mstmm::number::{DoubleDouble as Exact, Parameter, Scalar};
use mstmm::prelude::*;
use mstmm::search::{SearchError, SweepError, System};

system! {
    #[derive(Clone, Copy, Debug)]
    struct Oscillator { stiffness: f64, mass: f64 }
    fixed -> link::Link 1 { stiffness } -> mass 2 { mass } -> free;
}

system! {
    /// Three masses in a row, each to its neighbour and to the ground.
    #[derive(Clone, Copy, Debug)]
    struct Row { k_0: f64, k_1: f64, k_2: f64, k_3: f64, k_4: f64, k_5: f64, m_0: f64, m_1: f64, m_2: f64 }
    fixed -> link::Link 1 { stiffness: k_0 } -> mass 2 { mass: m_0 } -> conn 3
          -> link::Link 4 { stiffness: k_1 } -> mass 5 { mass: m_1 } -> conn 6
          -> link::Link 7 { stiffness: k_2 } -> mass 8 { mass: m_2 }
          -> link::Link 10 { stiffness: k_3 } -> fixed;
    conn 3 <- link::Link 11 { stiffness: k_4 } <- fixed;
    conn 6 <- link::Link 12 { stiffness: k_5 } <- fixed;
}

system! {
    /// Three masses in the air.
    #[derive(Clone, Copy, Debug)]
    struct FreeRow { first: f64, second: f64 }
    free -> mass 1 { mass: 1.0 } -> link::Link 2 { stiffness: first } -> mass 3 { mass: 2.0 }
         -> link::Link 4 { stiffness: second } -> mass 5 { mass: 3.0 } -> free;
}

system! {
    /// A cantilever with a link at its tip.
    #[derive(Clone, Copy, Debug)]
    struct Cantilever { length: f64, bending_stiffness: f64, stiffness: f64 }
    fixed -> beam 1 { length, bending_stiffness, mass_per_length: 1.0 } -> conn 2 -> free;
    conn 2 <- link::Link 3 { stiffness } <- fixed;
}

impl Cantilever {
    fn unit(stiffness: f64) -> Self {
        Cantilever { length: 1.0, bending_stiffness: 1.0, stiffness }
    }
}

system! {
    /// A beam in the air with a link to a mass beside its middle.
    #[derive(Clone, Copy, Debug)]
    struct FreeBeam { stiffness: f64 }
    free -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
         -> beam 3 { length: 1.5, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
    conn 2 <- link::Link 4 { stiffness } <- mass 5 { mass: 0.5 } <- free;
}

system! {
    /// A body on two links.
    #[derive(Clone, Copy, Debug)]
    struct Table { left: f64, right: f64, arm: f64 }
    free -> conn 1 -> body 2 { mass: 1.0, inertia_about_input: arm * arm, output_x: arm, centre_x: 0.3 * arm } -> conn 3 -> free;
    conn 1 <- link::Link 4 { stiffness: left } <- fixed;
    conn 3 <- link::Link 5 { stiffness: right } <- fixed;
}

system! {
    struct Plain { stiffness: f64, mass: f64 }
    fixed -> spring 1 { stiffness } -> mass 2 { mass } -> free;
}

/// The negative eigenvalues of the stiffness of a row, by the signs of the pivots of its elimination in double-double arithmetic; none
/// where a stiffness of one part in `1/rest` of the softest link at the masses decides.
fn negative_eigenvalues(k: [f64; 6], m: [f64; 3], rest: f64) -> Option<u64> {
    let heaviest = m.into_iter().fold(0.0, f64::max);
    let softest = k.iter().fold(f64::INFINITY, |least, k| least.min(k.abs()));
    let [below, above] = [-1.0, 1.0].map(|side| {
        let [a, b, c] = m.map(|mass| Exact::from_f64(side * rest * softest * (mass / heaviest)));
        let [k_0, k_1, k_2, k_3, k_4, k_5] = k.map(Exact::from_f64);
        let first = k_0 + k_1 + k_4 + a;
        let second = k_1 + k_2 + k_5 + b - k_1 * k_1 / first;
        let third = k_2 + k_3 + c - k_2 * k_2 / second;
        [first, second, third].iter().filter(|pivot| pivot.to_f64() < 0.0).count() as u64
    });
    (below == above).then_some(below)
}

fn row(k: [f64; 6], m: [f64; 3]) -> RowSystem {
    let ([k_0, k_1, k_2, k_3, k_4, k_5], [m_0, m_1, m_2]) = (k, m);
    Row { k_0, k_1, k_2, k_3, k_4, k_5, m_0, m_1, m_2 }.build().unwrap()
}

/// All searches refuse a system with so many motions that grow.
fn assert_refused<Y: Undamped<Parameter = f64>>(system: &Y, modes: u64) {
    let unstable = SearchError::Unstable { modes };
    assert_eq!(system.unstable_modes(), Ok(modes));
    assert_eq!(system.natural_frequencies::<8>(0.0..=10.0).unwrap_err(), unstable);
    assert_eq!(system.first_frequencies::<2>().unwrap_err(), unstable);
    assert_eq!(system.count_below(3.0), Err(unstable));
    let mut counts = [Ok(7); 3];
    system.counts_below(&[0.0, 1.0, 3.0], &mut counts).unwrap();
    assert_eq!(counts, [Ok(0), Err(unstable), Err(unstable)]);
}

#[test]
fn a_mass_on_a_negative_spring_grows() {
    let system = Oscillator { stiffness: -8.0, mass: 2.0 }.build().unwrap();
    assert_refused(&system, 1);
    let rates = system.eigenvalues::<4>(Region { re: -5.0..=5.0, im: -5.0..=5.0 }).unwrap();
    assert_eq!(rates.len(), 2);
    for (rate, expected) in rates.iter().zip([-2.0, 2.0]) {
        assert!((rate.lambda - Complex::new(expected, 0.0)).norm() <= rate.error, "{rate:?}");
    }
    let message = system.first_frequencies::<1>().unwrap_err().to_string();
    assert!(
        message.contains("statically unstable: 1 motion grows instead of vibrating")
            && message.contains("`eigenvalues`")
    );
}

#[test]
fn every_number_counts() {
    for (stiffness, modes) in [(-8.0, 1), (8.0, 0), (-1e-3, 1), (1e-3, 0)] {
        let model = Oscillator { stiffness, mass: 2.0 };
        assert_eq!(model.build_as::<f32>().unwrap().unstable_modes(), Ok(modes));
        assert_eq!(model.build_as::<Exact>().unwrap().unstable_modes(), Ok(modes));
    }
}

/// Oracle: the pivots of the stiffness matrix.
#[test]
fn rows_of_masses_grow_as_often_as_their_stiffness_is_negative() {
    let mut random = Random(5);
    let mut seen = [0; 4];
    for _ in 0..2000 {
        let k: [f64; 6] = core::array::from_fn(|_| 4.0 * random.unit() - 1.6);
        let m: [f64; 3] = core::array::from_fn(|_| 10f64.powf(2.0 * random.unit() - 1.0));
        let Some(modes) = negative_eigenvalues(k, m, 1e-9) else { continue };
        seen[modes as usize] += 1;
        let system = row(k, m);
        if modes > 0 {
            assert_refused(&system, modes);
        } else {
            assert_eq!(system.unstable_modes(), Ok(0));
            assert_eq!(system.count_below(1e6), Ok(3));
        }
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}

/// The same next to cancellation, with links that are 1e±8 times as stiff as others.
#[test]
fn stiff_links_that_nearly_cancel() {
    let mut random = Random(11);
    let mut seen = [0; 4];
    for _ in 0..4000 {
        let mut k: [f64; 6] =
            core::array::from_fn(|_| random.pick([-1.0, 1.0, 1.0]) * 10f64.powf(16.0 * random.unit() - 8.0));
        let m: [f64; 3] = core::array::from_fn(|_| 10f64.powf(6.0 * random.unit() - 3.0));
        let near =
            |sum: f64, random: &mut Random| -sum * (1.0 + (random.unit() - 0.5) * 10f64.powf(-14.0 * random.unit()));
        match random.below(3) {
            0 => k[4] = near(k[0] + k[1], &mut random),
            1 => k[5] = near(k[1] + k[2], &mut random),
            _ => k[3] = near(k[2], &mut random),
        }
        let Some(modes) = negative_eigenvalues(k, m, 1e-12) else { continue };
        seen[modes as usize] += 1;
        assert_eq!(row(k, m).unstable_modes(), Ok(modes), "{k:?} {m:?}");
    }
    assert!(seen.iter().all(|count| *count > 20), "{seen:?}");
}

/// A spring of either sign that is positive is a spring.
#[test]
fn a_stable_system_has_the_frequencies_that_it_has_with_springs() {
    let (link, spring) = (Oscillator { stiffness: 7.0, mass: 2.0 }, Plain { stiffness: 7.0, mass: 2.0 });
    let (link, spring) = (link.build().unwrap(), spring.build().unwrap());
    let (found, expected) = (link.first_frequencies::<1>().unwrap(), spring.first_frequencies::<1>().unwrap());
    assert_same_intervals(&found, &expected, &"oscillator");
    // two counts say that it is stable
    assert_eq!(found.evaluations(), expected.evaluations());
    let [runs, long_runs] = expected.proof_runs();
    assert_eq!(found.proof_runs(), [runs + 2, long_runs]);
}

/// Nothing is evaluated where nothing can buckle.
#[test]
fn elements_with_positive_stiffness_are_not_asked() {
    const { assert!(<OscillatorSystem as System>::MAY_BUCKLE && !<PlainSystem as System>::MAY_BUCKLE) };
    let system = Plain { stiffness: 1e300, mass: 1e-300 }.build().unwrap();
    assert_eq!(system.unstable_modes(), Ok(0));
}

/// K of the row is singular, and `3ab < 0` is the product of its other eigenvalues where the links differ in sign.
#[test]
fn motions_of_rigid_bodies_stay_what_they_are() {
    let system = FreeRow { first: 2.0, second: 1.0 }.build().unwrap();
    assert_eq!(system.unstable_modes(), Ok(0));
    let found = system.first_frequencies::<3>().unwrap();
    assert_eq!((found[0].omega, found[0].multiplicity, found.len()), (0.0, 1, 3));
    for (first, second, modes) in [(2.0, -1.0, 1), (-2.0, 1e-3, 1), (-2.0, -1e3, 2)] {
        assert_refused(&FreeRow { first, second }.build().unwrap(), modes);
    }
    let system = FreeBeam { stiffness: 1.0 }.build().unwrap();
    assert_eq!(system.unstable_modes(), Ok(0));
    let found = system.first_frequencies::<4>().unwrap();
    assert_eq!((found[0].omega, found[0].multiplicity), (0.0, 2));
    assert_refused(&FreeBeam { stiffness: -1e-3 }.build().unwrap(), 1);
    assert_refused(&FreeBeam { stiffness: -1e3 }.build().unwrap(), 1);
}

/// The tip of a cantilever has the stiffness 3EI/l³, exactly, and `ω² = (k + 3) φ(l)² / ∫φ²` next to its buckling, with
/// `φ = (3x² - x³)/2` and the integral 33/140.
#[test]
fn a_cantilever_buckles_at_its_tip_stiffness() {
    for part in [1e-1, 1e-4, 1e-8, 1e-12] {
        let [below, above] = [1.0 + part, 1.0 - part].map(|factor| Cantilever::unit(-3.0 * factor));
        assert_refused(&below.build().unwrap(), 1);
        let system = above.build().unwrap();
        assert_eq!(system.unstable_modes(), Ok(0));
        let first = system.first_frequencies::<1>().unwrap()[0].omega;
        let expected = ((above.stiffness + 3.0) * 140.0 / 33.0).sqrt();
        assert!((first / expected - 1.0).abs() < part + 1e-9, "{part}: {first} is not {expected}");
    }
}

/// The parameters are taken as they are, to the last bit and beyond: `3EI/l³ + k` is what rounding leaves of both.
#[test]
fn the_last_bit_decides_whether_a_cantilever_buckles() {
    let (mut random, mut seen) = (Random(3), [0; 2]);
    for _ in 0..300 {
        let [length, bending_stiffness] = [0.5 + random.unit(), 0.5 + random.unit()];
        let [l, ei] = [length, bending_stiffness].map(Exact::from_f64);
        let exact = ei * 3.0 / (l * l * l);
        let stiffness = -exact.to_f64();
        let rest = ((exact + Exact::from_f64(stiffness)) / exact).to_f64();
        // what is nearer to zero is at rest
        if rest.abs() > 1e-17 {
            let modes = u64::from(rest < 0.0);
            let system = Cantilever { length, bending_stiffness, stiffness }.build().unwrap();
            assert_eq!(system.unstable_modes(), Ok(modes), "{length} {bending_stiffness} {rest:e}");
            seen[modes as usize] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}

/// Oracle: `K = [[left + right, right a], [right a, right a²]]` has a negative eigenvalue per negative link.
#[test]
fn levers_count() {
    for (left, right) in [(1.0, 2.0), (-1.0, 2.0), (1.0, -1e-4), (-3.0, -3.0), (1e6, -1e-6)] {
        for arm in [1e-3, 1.0, 40.0] {
            let system = Table { left, right, arm }.build().unwrap();
            let modes = [left, right].iter().filter(|link| **link < 0.0).count() as u64;
            assert_eq!(system.unstable_modes(), Ok(modes), "{left} {right} {arm}");
        }
    }
}

/// Two links that cancel leave a mass at rest; one unit in the last place decides.
#[test]
fn what_is_about_to_buckle_is_at_rest() {
    let system = Oscillators { one: 1.5, other: -1.5 }.build().unwrap();
    assert_eq!(system.unstable_modes(), Ok(0));
    let found = system.natural_frequencies::<2>(0.0..=9.0).unwrap();
    assert_eq!((found[0].omega, found[0].multiplicity), (0.0, 1));
    let next = 1.5_f64.next_up();
    assert_refused(&Oscillators { one: 1.5, other: -next }.build().unwrap(), 1);
    let system = Oscillators { one: next, other: -1.5 }.build().unwrap();
    let first = system.first_frequencies::<1>().unwrap()[0].omega;
    assert!((first / (next - 1.5).sqrt() - 1.0).abs() < 1e-15);
}

system! {
    struct Oscillators { one: f64, other: f64 }
    fixed -> link::Link 1 { stiffness: one } -> conn 2 -> link::Link 3 { stiffness: other } -> fixed;
    conn 2 <- mass 4 { mass: 1.0 } <- free;
}

/// Models that grow are errors in their places, and leave the others as they are.
#[test]
fn sweeps_tell_stable_models_from_others() {
    let models: Vec<_> = (0..24).map(|k| Cantilever::unit(f64::from(5 - (k * 7) % 11))).collect();
    for (found, model) in models.iter().first_frequencies::<3>().zip(&models) {
        let alone = model.build().unwrap().first_frequencies::<3>().map_err(SweepError::Search);
        match (found, alone) {
            (Ok(found), Ok(alone)) if model.stiffness > -3.0 => assert_same_intervals(&found, &alone, model),
            (Err(found), Err(alone)) if model.stiffness < -3.0 => {
                assert_eq!((found, alone), (alone, SweepError::Search(SearchError::Unstable { modes: 1 })));
            }
            (found, alone) => assert!(model.stiffness == -3.0, "{found:?} {alone:?}"),
        }
    }
}
