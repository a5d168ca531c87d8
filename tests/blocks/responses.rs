//! Responses on a grid against responses alone: every bit, on every instruction set, whatever is beside a frequency.

use crate::support::list_of_tree::{MOST, any, point, undamped};
use crate::support::models::*;
use crate::support::random_tree::{Random, varied_tree};
use core::ops::Range;
use mstmm::motion::{Entry, ExtendedTree, Load, MotionError, Point};
use mstmm::number::Oscillation;
use mstmm::prelude::*;
use mstmm_lanes::InstructionSet;

type C = Complex<f64>;

/// Asserts that a response on a grid is that at each of its frequencies, up to the first that fails, and so on behind that.
/// Returns how many were compared.
fn assert_response<Y, S>(system: &Y, load: Load<Y::Model>, entry: Entry<Y::Model>, grid: &[S]) -> usize
where
    Y: ExtendedTree<S>,
    S: Oscillation<Y::Parameter>,
{
    let Ok(response) = system.frequency_response(load, entry) else { return 0 };
    let alone: Vec<Result<S, MotionError>> = grid.iter().map(|&x| response.at(x)).collect();
    for set in InstructionSet::ALL {
        let set = set.limit();
        let mut start = 0;
        while start < grid.len() {
            let (grid, alone) = (&grid[start..], &alone[start..]);
            let mut values = vec![S::zero(); grid.len()];
            let result = response.on(grid, &mut values);
            let good = alone.iter().position(Result::is_err).unwrap_or(grid.len());
            for ((value, alone), x) in values.iter().zip(&alone[..good]).zip(grid) {
                assert_eq!(bits(&Ok(*value)), bits(alone), "at {x:?} on {set:?}");
            }
            let end = alone.get(good).map_or(Ok(S::zero()), |end| *end);
            assert_eq!(bits(&end), bits(&result.map(|()| S::zero())), "behind {good} of {grid:?} on {set:?}");
            start += good + 1;
        }
    }
    alone.iter().filter(|value| value.is_ok()).count()
}

/// Numbers are the same only if all bits are.
fn bits<S: mstmm::number::Single>(value: &Result<S, MotionError>) -> String {
    format!("{value:?}")
}

/// Frequencies in and out of order, from short waves to many, some where only errors are.
fn grid(seed: u64, count: usize) -> Vec<f64> {
    let mut random = Random(seed);
    let mut all: Vec<f64> = (0..count).map(|_| 10f64.powf(9.0 * random.unit() - 3.0)).collect();
    for (place, odd) in [0.0, f64::NAN, 1e-160, 1e200].into_iter().enumerate() {
        all[11 * place + 5] = odd;
    }
    all
}

fn loads_and_entries<M>(points: &[Point<M>]) -> (Vec<Load<M>>, Vec<Entry<M>>) {
    let loads = points.iter().flat_map(|point| [point.force(), point.torque()]).collect();
    let entries =
        points.iter().flat_map(|point| [point.deflection(), point.rotation(), point.moment(), point.shear()]).collect();
    (loads, entries)
}

/// All responses between some points of a model of the paper, at real frequencies or at decaying ones.
macro_rules! assert_model {
    ($model:expr, $end:expr, $x:expr, [$($point:expr),+ $(,)?]) => {{
        let system = $model.build().unwrap();
        let scan: Vec<f64> = (1..=75).map(|k| $end * f64::from(k) / 75.0).collect();
        let (loads, entries) = loads_and_entries(&[$($point),+]);
        let mut compared = 0;
        for omegas in [scan, grid(3, 70)] {
            let all: Vec<_> = omegas.into_iter().map($x).collect();
            for (load, entry) in loads.iter().flat_map(|load| entries.iter().map(move |entry| (*load, *entry))) {
                compared += assert_response(&system, load, entry, &all);
            }
        }
        assert!(compared > 1000, "{compared}");
    }};
}

#[test]
fn models_of_the_paper() {
    let real = |omega: f64| omega;
    let ends = [TipBody::beam_1.input(), TipBody::beam_1.output(), TipBody::body_2.output()];
    assert_model!(light_tip_body(), 1700.0, real, [ends[0], ends[1], ends[2]]);
    assert_model!(restrained_beam(), 3000.0, real, [RestrainedBeam::conn_2, RestrainedBeam::conn_4]);
    assert_model!(
        spring_and_mass(),
        2000.0,
        real,
        [SpringAndMass::conn_2, SpringAndMass::conn_5, SpringAndMass::beam_7.output(), SpringAndMass::mass_6.input()]
    );
    assert_model!(
        two_spans(),
        20_000.0,
        real,
        [TwoSpans::beam_1.input(), TwoSpans::conn_2, TwoSpans::conn_4, TwoSpans::mass_6.input()]
    );
    assert_model!(
        damped_oscillator(),
        12_000.0,
        |omega: f64| C::new(-0.02 * omega, omega),
        [DampedOscillator::conn_2, DampedOscillator::conn_5, DampedOscillator::mass_7.input()]
    );
}

/// Pairs of a load and an entry that are tried in a random tree.
const PAIRS: usize = 25;

/// Responses of random trees, which have every element, connections within connections and bodies in both directions.
fn compared(seeds: Range<u64>) -> usize {
    let mut compared = 0;
    for seed in seeds {
        let tree = varied_tree(seed);
        if tree.len() > MOST {
            continue;
        }
        let points: Vec<_> = (0..tree.len() - 1).flat_map(|step| [false, true].map(|side| point(step, side))).collect();
        let (loads, entries) = loads_and_entries(&points);
        let omegas = grid(seed, 50);
        // trees of odd seeds have no dashpots
        let (real, complex) = ((seed % 2 == 1).then(|| undamped::<f64>(&tree)), any::<f64>(&tree));
        let lambdas: Vec<C> = omegas.iter().map(|omega| C::new(-0.1 * omega, *omega)).collect();
        let mut random = Random(seed);
        for _ in 0..PAIRS {
            let mut any = |count: usize| (random.unit() * count as f64) as usize;
            let (load, entry) = (loads[any(loads.len())], entries[any(entries.len())]);
            compared += match real {
                Some(real) => assert_response(&real, load, entry, &omegas),
                None => assert_response(&complex, load, entry, &lambdas),
            };
        }
    }
    compared
}

#[test]
fn some_random_trees() {
    let compared = compared(0..6);
    assert!(compared > 2000, "{compared}");
}

#[test]
#[ignore = "long: .ci/long"]
fn random_trees() {
    let compared = compared(0..60);
    assert!(compared > 20_000, "{compared}");
}

#[test]
fn grids_need_room() {
    let system = light_tip_body().build().unwrap();
    let tip = TipBody::body_2.output();
    let response = system.frequency_response(tip.force(), tip.deflection()).unwrap();
    assert_eq!(response.on(&[1.0; 40], &mut [0.0; 39]), Err(MotionError::Capacity { capacity: 39 }));
    assert_eq!(response.on::<f64>(&[], &mut []), Ok(()));
    let mut values = [0.0; 61];
    assert_eq!(response.on(&[1.0; 59], &mut values), Ok(()));
    assert_eq!((values[58], values[59], values[60]), (response.at(1.0).unwrap(), 0.0, 0.0));
}
