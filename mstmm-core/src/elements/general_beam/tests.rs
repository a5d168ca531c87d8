//! The general beam beside the exponential of its equations, in twice the digits, and limit cases.

use super::compound::GeneralCompound;
use super::*;
use crate::element::Charted;
use crate::elements::shared::relation::Relation;
use crate::number::{DoubleDouble, Scalar};
use crate::structure::Chart;
use num_traits::{One, Zero};
use std::vec::Vec;

type D = DoubleDouble;
type Rows = [[D; 4]; 4];

/// `exp A` of the equations by Taylor's series of a part of the length, squared back: nothing of wave numbers is in it.
fn exponential(section: &SectionAt<D>) -> Rows {
    let SectionAt { sigma, tau, g, h, .. } = *section;
    let o = D::zero();
    let a = [[o, sigma, o, -tau], [o, o, D::one(), o], [o, g, o, sigma], [h, o, o, o]];
    let size = a.as_flattened().iter().map(|entry| entry.size()).fold(1.0, f64::max);
    let doublings = (size.log2().ceil() as i32).max(0) + 2;
    let a = a.map(|row| row.map(|entry| entry.times_power_of_two(-doublings)));
    let identity: Rows = core::array::from_fn(|i| core::array::from_fn(|j| if i == j { D::one() } else { o }));
    let (mut sum, mut term) = (identity, identity);
    for n in 1..30 {
        term = product(&term, &a).map(|row| row.map(|entry| entry / D::from_f64(f64::from(n))));
        sum = core::array::from_fn(|i| core::array::from_fn(|j| sum[i][j] + term[i][j]));
    }
    (0..doublings).fold(sum, |power, _| product(&power, &power))
}

fn product(a: &Rows, b: &Rows) -> Rows {
    core::array::from_fn(|i| core::array::from_fn(|j| (0..4).fold(D::zero(), |sum, k| sum + a[i][k] * b[k][j])))
}

const PAIRS: [(usize, usize); 5] = [(0, 1), (0, 2), (0, 3), (1, 3), (2, 3)];

/// The compound of a matrix, over the minors of Lagrangian planes.
fn compound(u: &Rows) -> [[D; 5]; 5] {
    let minor = |(i, j): (usize, usize), (a, b): (usize, usize)| u[i][a] * u[j][b] - u[i][b] * u[j][a];
    core::array::from_fn(|row| {
        core::array::from_fn(|column| {
            let own = minor(PAIRS[row], PAIRS[column]);
            if column == 2 { own + minor(PAIRS[row], (1, 2)) } else { own }
        })
    })
}

/// Beams in all regimes: each number from a table of decades.
fn beams() -> Vec<(BeamParameters<f64>, f64)> {
    let mut all = Vec::new();
    let mut seed = 7_u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    for _ in 0..600 {
        let mut decade = |from: f64, to: f64| 10f64.powf(from + (to - from) * next());
        let shear_flexibility = decade(-6.0, 0.0);
        let beam = BeamParameters {
            length: 1.0,
            bending_stiffness: 1.0,
            mass_per_length: 1.0,
            shear_flexibility,
            rotary_inertia: decade(-6.0, 0.0),
            axial_force: decade(-2.0, 2.0),
            foundation_stiffness: decade(-2.0, 4.0),
            foundation_shear_stiffness: 0.0,
        };
        let omega = decade(-1.0, 2.3);
        let kind = all.len() % 6;
        let beam = match kind {
            0 => BeamParameters { axial_force: 0.0, foundation_stiffness: 0.0, ..beam },
            1 => BeamParameters { shear_flexibility: 0.0, rotary_inertia: 0.0, ..beam },
            2 => BeamParameters { shear_flexibility: 0.0, axial_force: -beam.axial_force, ..beam },
            3 => BeamParameters { axial_force: -(0.5 / shear_flexibility).min(beam.axial_force), ..beam },
            _ => beam,
        };
        all.push((beam, omega));
    }
    all.extend(where_waves_meet());
    all
}

/// Beams beside the loads and frequencies at which two wave numbers coincide or one of them vanishes.
fn where_waves_meet() -> Vec<(BeamParameters<f64>, f64)> {
    let plain = BeamParameters {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        shear_flexibility: 0.0,
        rotary_inertia: 0.0,
        axial_force: 0.0,
        foundation_stiffness: 0.0,
        foundation_shear_stiffness: 0.0,
    };
    let mut all = Vec::new();
    for part in (1..16).flat_map(|k| [1.0 + 10_f64.powi(-k), 1.0 - 10_f64.powi(-k)]) {
        for force in [-30.0, 30.0, 300.0_f64] {
            // T² = 4 (k - m ω²): both decay or both travel with one number
            let foundation_stiffness = force * force / 4.0 * part + 1.0;
            all.push((BeamParameters { axial_force: force, foundation_stiffness, ..plain }, 1.0));
        }
        // the cut-on, ω² = k/m, and the cut-off, ω² = kGA/r
        all.push((BeamParameters { foundation_stiffness: 900.0 * part, ..plain }, 30.0));
        all.push((BeamParameters { shear_flexibility: 0.01 * part, rotary_inertia: 0.01, ..plain }, 100.0));
    }
    all
}

/// A beam that is built of its parameters as the equations have them.
fn built(beam: BeamParameters<f64>) -> BuiltGeneralBeam<f64> {
    let shear_stiffness = if beam.shear_flexibility > 0.0 { 1.0 / beam.shear_flexibility } else { 0.0 };
    BuiltGeneralBeam::new(beam, shear_stiffness).unwrap()
}

/// The constants at ω, rounded, and beside them the exponential of these: the rounding of constants is another matter.
fn rounded(beam: BeamParameters<f64>, omega: f64) -> (SectionAt<f64>, Rows) {
    let section = built(beam).constants.at(-omega * omega);
    let wide = D::from_f64;
    let [sigma, tau, g, h] = [section.sigma, section.tau, section.g, section.h].map(wide);
    let constants = Constants { sigma, tau, tension: g, rotary: D::zero(), mass: D::zero(), foundation: -h };
    (section, exponential(&constants.at(D::zero())))
}

/// The relation of both ends at ω.
fn relation(beam: BeamParameters<f64>, omega: f64) -> Relation<f64> {
    built(beam).relation(&FrequencyPowers::new(omega, false), beam.length).0
}

/// Each choice of variables has a minor, whose sign changes at each frequency of a beam that is held so: as many as are counted.
#[test]
fn counts_for_all_kinds_are_roots_of_their_minors() {
    let plain = BeamParameters {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        shear_flexibility: 0.02,
        rotary_inertia: 0.003,
        axial_force: 3.0,
        foundation_stiffness: 20.0,
        foundation_shear_stiffness: 1.0,
    };
    let softer = BeamParameters { shear_flexibility: 0.2, rotary_inertia: 0.03, ..plain };
    let compressed = BeamParameters { axial_force: -8.0, foundation_stiffness: 0.0, ..plain };
    for beam in [plain, softer, compressed] {
        let near_zero = relation(beam, 1e-3);
        // above the frequency of thickness shear of the softer beam, 12.9
        for end in [4.0, 17.0, 61.0, 150.0] {
            let at_end = relation(beam, end);
            let steps: Vec<Relation<f64>> = (1..=3000).map(|k| relation(beam, end * f64::from(k) / 3000.0)).collect();
            for (input, output) in (0..4).flat_map(|input| (0..4).map(move |output| (input, output))) {
                let signs = steps.iter().map(|step| step.divisor(input, output) < 0.0);
                let mut last = near_zero.divisor(input, output) < 0.0;
                let changes = signs.filter(|sign| core::mem::replace(&mut last, *sign) != *sign).count();
                let counted = at_end.below(input, output) - near_zero.below(input, output);
                assert_eq!(counted, changes as f64, "{beam:?}, up to {end}, kinds {input} and {output}");
            }
        }
    }
}

/// Entries in the units of a chart are bounded in all regimes, since the largest minor divides.
#[test]
fn entries_of_charts_are_bounded() {
    for (beam, omega) in beams() {
        let at = FrequencyPowers::new(omega, false);
        let chart: Chart<f64> = GeneralBeam::chart(&built(beam), &at, beam.length);
        let largest =
            (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).map(|(i, j)| chart.entry(i, j).abs()).fold(0.0, f64::max);
        assert!(largest < 3.0, "{beam:?} at {omega}: {largest}");
    }
}

/// The size of waves, by which entries are compared: powers of it are the usual sizes of Y, Θ, M, Q.
fn wave(section: &SectionAt<f64>) -> f64 {
    let SectionAt { sigma, tau, g, h, .. } = *section;
    (sigma.abs() * h.abs().sqrt()).max(g.abs()).max((tau * h).abs()).sqrt().max(1.0)
}

#[test]
fn the_transfer_matrix_is_the_exponential_of_the_equations() {
    let mut worst = 0.0_f64;
    for (beam, omega) in beams() {
        let (section, exact) = rounded(beam, omega);
        let wave = wave(&section);
        let unit = BeamParameters { length: 1.0, bending_stiffness: 1.0, ..beam };
        let matrix = Transfer::new(&section).matrix(&unit);
        let powers = [1.0, wave, wave * wave, wave * wave * wave];
        let balanced = |i: usize, j: usize, entry: f64| entry * powers[j] / powers[i];
        let all = (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
        let size = all.clone().map(|(i, j)| balanced(i, j, exact[i][j].to_f64()).abs()).fold(0.0, f64::max);
        for (i, j) in all {
            let error = (D::from_f64(matrix[(i, j)]) - exact[i][j]).to_f64();
            worst = worst.max(balanced(i, j, error).abs() / (size * wave * f64::EPSILON));
        }
    }
    assert!(worst < 32.0, "{worst} eps times the waves");
}

#[test]
fn the_compound_is_that_of_the_exponential() {
    let (mut worst, mut compared) = (0.0_f64, 0);
    for (beam, omega) in beams() {
        let (section, exact) = rounded(beam, omega);
        let wave = wave(&section);
        let found = GeneralCompound::new(section, Units::new(1.0, 1.0));
        let largest = exact.as_flattened().iter().map(|entry| entry.size()).fold(0.0, f64::max);
        let exact = compound(&exact);
        // minors of the exponential cancel where one wave grows far faster than the other
        let largest_minor = exact.as_flattened().iter().map(|entry| entry.size()).fold(0.0, f64::max);
        if largest * largest * 1e-30 > largest_minor * 1e-18 {
            continue;
        }
        compared += 1;
        // p_YΘ, p_YM, w, p_ΘQ, p_MQ in powers of the wave number
        let powers = [1, 2, 3, 4, 5].map(|n| wave.powi(n));
        let all = (0..5).flat_map(|i| (0..5).map(move |j| (i, j)));
        let balanced = |i: usize, j: usize, entry: f64| entry * powers[j] / powers[i];
        let size = all.clone().map(|(i, j)| balanced(i, j, exact[i][j].to_f64()).abs()).fold(0.0, f64::max);
        for (i, j) in all {
            let entry = D::from_f64(found.row(i)[j]).times_power_of_two(found.exponent);
            let error = (entry - exact[i][j]).to_f64();
            let share = balanced(i, j, error).abs() / (size * wave * f64::EPSILON);
            worst = worst.max(share);
        }
    }
    assert!(compared > 400, "{compared}");
    assert!(worst < 32.0, "{worst} eps times the waves");
}
