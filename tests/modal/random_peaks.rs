//! Peaks of random damped structures with close modes, against dense samples of their responses.
#![expect(clippy::unwrap_used, reason = "a model that does not build fails the test")]

use crate::numbers::Random;
use mstmm::Complex;
use mstmm::elements::SpringDamper;
use mstmm::frame::{DampedStructure, Frame, Ground, Line, Point, Section};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm::search::{Eigenvalue, Region};

/// Beams and masses in a row whose frequencies are close, on weak springs, with little damping.
fn structure(random: &mut Random) -> (DampedStructure<Line>, Vec<Point<Line>>) {
    let mut frame = Frame::new();
    let apart = 10.0_f64.powf(-1.0 - 4.0 * random.unit());
    let ratio = 10.0_f64.powf(-1.5 - 4.0 * random.unit());
    let count = 2 + random.below(4);
    let mut points: Vec<Point<Line>> = Vec::new();
    for k in 0..count {
        let point = frame.point(2.0 * k as f64 + 1.0);
        let own = 1.0 + apart * random.unit();
        if random.chance(0.3) {
            let foot = frame.point(2.0 * k as f64);
            frame.hold(foot, Support::Fixed);
            // 3 EI/l³ about the stiffness of the springs
            frame.member(foot, point, Section::new().bending_stiffness(30.0 * own).mass_per_length(0.8));
            frame.mass(point, 1.0);
            frame.member(point, Ground, SpringDamper { stiffness: 1.0, damping: 20.0 * ratio });
        } else {
            let damping = 20.0 * ratio * (0.2 + random.unit());
            frame.member(point, Ground, SpringDamper { stiffness: 100.0 * own, damping });
            frame.mass(point, 1.0);
        }
        if let Some(&before) = points.last() {
            let stiffness = 100.0 * apart * random.unit();
            frame.member(before, point, SpringDamper { stiffness, damping: 0.1 * ratio * random.unit() });
        }
        points.push(point);
    }
    (frame.build_damped().unwrap(), points)
}

/// Frequencies about each mode, of so many each, and as many over the band.
fn places(roots: &[Eigenvalue], [start, end]: [f64; 2], count: usize) -> Vec<f64> {
    let mut places: Vec<f64> = (0..=count).map(|n| start + (end - start) * n as f64 / count as f64).collect();
    for root in roots {
        for n in 0..=count {
            let x = 2.0 * n as f64 / count as f64 - 1.0;
            // from a thousandth to ten widths
            places.push(root.lambda.im + root.lambda.re.abs() * (10.0 * x.powi(3) + 0.03 * x));
        }
    }
    places.retain(|omega| (start..=end).contains(omega));
    places
}

/// Peaks and least values of random structures: no sample is beyond their bounds, and what was found is what the response is there.
fn hold_against_samples(seeds: std::ops::Range<u64>, count: usize) {
    let (mut evaluations, mut most) = (0, 0);
    for seed in seeds.clone() {
        let mut random = Random(seed);
        let (model, points) = structure(&mut random);
        let band = if random.chance(0.5) { [1.0, 40.0] } else { [9.0, 11.0 + random.unit()] };
        let region = Region { re: -30.0..=0.0, im: 0.5..=45.0 };
        let roots = model.eigenvalues_in(region).unwrap();
        let [load, entry] = [points[0], points[random.below(points.len())]];
        let response = model.frequency_response(load.force_y(), entry.displacement_y()).unwrap();
        let size = |omega: f64| response.at(Complex::new(0.0, omega)).unwrap().norm();
        let samples: Vec<_> = places(&roots, band, count).into_iter().map(|omega| (omega, size(omega))).collect();
        let some = roots.len() - random.below(roots.len() / 2 + 1);
        for list in [&roots[..], &roots[..some]] {
            let range = band[0]..=band[1];
            let peak = response.peak(range.clone(), list, 1e-8).unwrap();
            let least = response.least(range, list, 1e-6).unwrap();
            let about = format!("{seed} {band:?} {peak:?} {least:?}");
            let beyond = samples.iter().find(|(_, size)| !(*size <= peak.upper && *size >= least.lower));
            assert!(beyond.is_none(), "{about} {beyond:?}");
            assert!((size(peak.omega) / peak.lower - 1.0).abs() < 1e-13, "{about}");
            assert!((size(least.omega) / least.upper - 1.0).abs() < 1e-13, "{about}");
            assert!(
                peak.upper <= peak.lower * (1.0 + 1.001e-8) && least.upper <= least.lower * (1.0 + 1.001e-6),
                "{about}"
            );
            if list.len() == roots.len() {
                (evaluations, most) = (evaluations + peak.evaluations, most.max(peak.evaluations));
            }
        }
    }
    let mean = evaluations as f64 / (seeds.end - seeds.start) as f64;
    println!("{mean:.0} evaluations, at most {most}");
    assert!(most <= 2000, "{most} evaluations");
}

#[test]
fn peaks_of_random_structures_hold_against_samples() {
    hold_against_samples(0..16, 30);
}

#[test]
#[ignore = "long: .ci/long"]
fn peaks_of_random_structures_hold_against_many_samples() {
    hold_against_samples(0..100, 4000);
    hold_against_samples(100..102, 80_000);
}
