//! Bounds of root mean squares by lists of modes: beside sums of many more modes, and beside the bound in frequency.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::cantilever;
use crate::numbers::Random;
use crate::random::frame;
use crate::random_vibration::{gauss, table};
use mstmm::motion::PowerSpectrum;
use mstmm::prelude::*;
use std::f64::consts::TAU;

/// Bounds of random frames beside sums of many more modes; prints how much of them is used.
fn assert_bounds_hold(seeds: core::ops::Range<u64>) {
    let (mut most, mut used, mut count, mut tried) = (0.0_f64, 0.0, 0.0, 0);
    for seed in seeds {
        let own = frame(seed, 0.0, || 0.0);
        let system = own.frame.build().unwrap();
        let mut random = Random(seed + 4000);
        let modes = 2 + random.below(5);
        let Ok(many) = system.frequencies(24) else { continue };
        let roots = &many[..modes];
        let reach =
            roots[modes - 1].omega + (0.05 + 0.94 * random.unit()) * (many[modes].omega - roots[modes - 1].omega);
        let point = own.points[1 + random.below(own.points.len() - 1)];
        let member = own.members[random.below(own.members.len())];
        let loads = [point.force_x(), PlaneLoad::base_acceleration(Direction::y()), member.input().kink()];
        let entries =
            [point.displacement_x(), point.displacement_y(), member.input().moment(), member.output().shear()];
        for (load, entry) in loads.into_iter().flat_map(|load| entries.map(|entry| (load, entry))) {
            let Ok(truncation) = system.truncation::<16>(roots, load, entry, reach) else { continue };
            let few = system.modal_response::<16, _>(roots, load, entry).unwrap();
            let all = system.modal_response::<32, _>(&many, load, entry).unwrap();
            for ratio in [1e-4, 0.02, 0.3] {
                // up to the reach, or far below it
                let top = random.pick([0.999, 0.3]) * reach / TAU;
                let mut rows = table(&mut random, roots[0].omega / TAU, top);
                rows.retain(|(hertz, _)| *hertz < top);
                rows.push((top, rows[rows.len() - 1].1));
                let spectrum = PowerSpectrum::hertz(&rows).unwrap();
                let Some(bound) = truncation.random(&spectrum, ratio) else {
                    assert!(truncation.at_with_ratio(reach, ratio).is_none());
                    continue;
                };
                let [one, other] = [
                    few.with_damping_ratio(ratio).unwrap().random(&spectrum).unwrap().rms,
                    all.with_damping_ratio(ratio).unwrap().random(&spectrum).unwrap().rms,
                ];
                let error = (one - other).abs();
                assert!(error <= bound + 1e-12 * other, "{seed} {load:?} {entry:?} {ratio}: {error:e} {bound:e}");
                tried += 1;
                if error > 1e-9 * other {
                    (most, used, count) = (most.max(error / bound), used + error / bound, count + 1.0);
                }
            }
        }
    }
    println!("{tried} random loads: {:.3} of the bound on the average, {most:.3} at most", used / count);
    assert!(tried > 0);
}

#[test]
fn bounds_of_random_loads_hold() {
    assert_bounds_hold(0..3);
}

#[test]
#[ignore = "long: .ci/long"]
fn bounds_of_random_loads_on_three_hundred_random_frames_hold() {
    assert_bounds_hold(0..300);
}

/// The bound is what it says: the integral of the square of the bound in frequency, from above and closely.
#[test]
fn a_bound_is_the_integral_of_that_in_frequency() {
    let (model, [_, tip], beam) = cantilever();
    let roots = model.first_frequencies::<3>().unwrap();
    let reach = 520.0;
    let rows = [(2.0, 0.3), (9.0, 2.0), (30.0, 0.5), (0.999 * reach / TAU, 4.0)];
    let spectrum = PowerSpectrum::hertz(&rows).unwrap();
    for (entry, ratio) in [(tip.displacement_y(), 0.0), (tip.displacement_y(), 0.05), (beam.input().moment(), 0.02)] {
        let truncation = model.truncation::<3>(&roots, tip.force_y(), entry, reach).unwrap();
        let (nodes, mut sum) = (gauss(), 0.0);
        for pair in rows.windows(2) {
            for panel in 0..40 {
                let width = (pair[1].0 - pair[0].0) / 40.0;
                for (node, weight) in &nodes {
                    let hertz = pair[0].0 + width * (f64::from(panel) + 0.5 + 0.5 * node);
                    let error = truncation.at_with_ratio(TAU * hertz, ratio).unwrap();
                    sum += error * error * spectrum.at(hertz) * 0.5 * width * weight;
                }
            }
        }
        let bound = truncation.random(&spectrum, ratio).unwrap();
        assert!(bound >= sum.sqrt() * (1.0 - 1e-12) && bound < 1.02 * sum.sqrt(), "{bound:e} {:e}", sum.sqrt());
        let from_rest = truncation.random(&PowerSpectrum::band(0.0..=60.0, 1.0).unwrap(), ratio).unwrap();
        let nearly = truncation.random(&PowerSpectrum::band(1e-9..=60.0, 1.0).unwrap(), ratio).unwrap();
        // both are above the integral, each by its own parts
        assert!((from_rest / nearly - 1.0).abs() < 0.02, "{from_rest:e} {nearly:e}");
    }
}

#[test]
fn bounds_where_there_are_none() {
    let (model, [_, tip], beam) = cantilever();
    let roots = model.first_frequencies::<3>().unwrap();
    let truncation = model.truncation::<3>(&roots, tip.force_y(), tip.displacement_y(), 500.0).unwrap();
    let within = PowerSpectrum::band(1.0..=79.0, 1.0).unwrap();
    assert!(truncation.random(&within, 0.02).is_some_and(|bound| bound > 0.0));
    assert_eq!(truncation.random(&PowerSpectrum::band(1.0..=80.0, 1.0).unwrap(), 0.02), None);
    assert_eq!(truncation.random(&PowerSpectrum::white(1.0), 0.02), None);
    for ratio in [-0.1, f64::NAN, f64::INFINITY] {
        assert_eq!(truncation.random(&within, ratio), None);
    }
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(truncation.random(&within.times(factor), 0.02), None);
    }
    // a moment under a kink: with damping of what is left out there is none
    let (load, entry) = (beam.input().kink(), beam.output().moment());
    let truncation = model.truncation::<3>(&roots, load, entry, 500.0).unwrap();
    assert!(truncation.random(&within, 0.0).is_some());
    assert_eq!(truncation.random(&within, 0.02), None);
}
