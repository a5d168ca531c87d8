//! General beams: published values, and random beams of each kind beside an oracle of many digits.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::general_chains::families::PLAIN;
use crate::oracles::many_digits::Case;
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::{BeamColumn, FoundationBeam, GeneralBeam, RayleighBeam, TimoshenkoBeam};
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;
use mstmm::search::{FrequencyList, SearchError};
use std::f64::consts::TAU;

/// Shares of an eps of a root that rounding of a search may cost, times its condition.
const ROUNDING: f64 = 4.0;

/// A kind of beam with random numbers in all regimes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Rayleigh,
    Timoshenko,
    Column,
    Founded,
    General,
}

const KINDS: [Kind; 5] = [Kind::Rayleigh, Kind::Timoshenko, Kind::Column, Kind::Founded, Kind::General];

const SUPPORTS: [Support; 4] = [Support::Fixed, Support::Pinned, Support::Guided, Support::Free];

/// A number of decades.
fn decade(random: &mut Random, from: f64, to: f64) -> f64 {
    10f64.powf(from + (to - from) * random.unit())
}

fn case(kind: Kind, largest_tension: f64, random: &mut Random) -> (Case, AnyUndamped<f64>) {
    let [length, bending_stiffness, mass_per_length] = [0, 1, 2].map(|_| decade(random, -1.0, 1.0));
    let scale = bending_stiffness / (length * length);
    let slenderness = decade(random, 0.3, 3.0);
    let rotary_inertia = mass_per_length * length * length / (slenderness * slenderness);
    let shear_stiffness = scale * slenderness * slenderness * (0.2 + 0.2 * random.unit());
    let tension = decade(random, -2.0, largest_tension);
    let axial_force = scale * if random.chance(0.4) { -1.2 * random.unit() } else { tension };
    // with shear a stiff foundation leaves nothing but waves that decay within the section
    let stiffest = if kind == Kind::General { 5.0 } else { 12.0 };
    let foundation_stiffness = scale / (length * length) * decade(random, -2.0, stiffest);
    let foundation_shear_stiffness = if random.chance(0.5) { 0.0 } else { scale * decade(random, -2.0, 4.0) };
    let plain = GeneralBeam { length, bending_stiffness, mass_per_length, ..PLAIN };
    let (element, beam) = match kind {
        Kind::Rayleigh => {
            let beam = RayleighBeam { length, bending_stiffness, mass_per_length, rotary_inertia };
            (beam.try_into().unwrap(), GeneralBeam { rotary_inertia, ..plain })
        }
        Kind::Timoshenko => {
            let beam = TimoshenkoBeam { length, bending_stiffness, mass_per_length, shear_stiffness, rotary_inertia };
            (beam.try_into().unwrap(), GeneralBeam { shear_stiffness, rotary_inertia, ..plain })
        }
        Kind::Column => {
            let beam = BeamColumn { length, bending_stiffness, mass_per_length, axial_force };
            (beam.try_into().unwrap(), GeneralBeam { axial_force, ..plain })
        }
        Kind::Founded => {
            let beam = FoundationBeam {
                length,
                bending_stiffness,
                mass_per_length,
                foundation_stiffness,
                foundation_shear_stiffness,
            };
            (beam.try_into().unwrap(), GeneralBeam { foundation_stiffness, foundation_shear_stiffness, ..plain })
        }
        Kind::General => {
            let beam = GeneralBeam {
                length,
                bending_stiffness,
                mass_per_length,
                shear_stiffness,
                rotary_inertia,
                axial_force: axial_force.max(-0.3 * shear_stiffness),
                foundation_stiffness,
                foundation_shear_stiffness,
            };
            (beam.try_into().unwrap(), beam)
        }
    };
    let [tip, root] = [0, 1].map(|_| SUPPORTS[random.below(4)]);
    (Case { beam, tip, root }, element)
}

/// A mode of a number, or none that an interval holds alone.
fn mode(list: &StepList<'_, AnyUndamped<f64>>, number: u64) -> Result<Option<NaturalFrequency>, SearchError> {
    let below = |omega: f64| match list.count_below(omega) {
        Err(SearchError::Unresolved { .. }) => list.count_below(omega * 1.000_001),
        count => count,
    };
    let mut end = 1.0;
    while below(end)? < number {
        end *= 4.0;
    }
    let mut start = end / 4.0;
    while below(start)? >= number {
        start /= 4.0;
        if start < 1e-9 {
            return Ok(None);
        }
    }
    for _ in 0..40 {
        if below(end)? == number && below(start)? + 1 == number {
            break;
        }
        let middle = (start * end).sqrt();
        if below(middle)? < number { start = middle } else { end = middle }
    }
    let found = list.natural_frequencies::<4>(start..=end)?;
    Ok(found.iter().find(|root| root.multiplicity == 1 && root.omega > start && root.omega < end).copied())
}

/// What was found in many beams.
#[derive(Debug, Default)]
struct Tally {
    roots: usize,
    unstable: usize,
    /// Modes that are zero or share an interval.
    without: usize,
    refused: usize,
    outside: usize,
    /// Largest error in eps of the condition.
    worst: f64,
    most: (f64, String),
}

/// Compares modes of random beams of a kind with the oracle.
fn judge(kind: Kind, count: usize, most: f64) -> Tally {
    let mut random = Random(0x51 + kind as u64);
    let mut tally = Tally::default();
    for index in 0..count {
        let (case, element) = case(kind, if most > 100.0 { 8.0 } else { 4.0 }, &mut random);
        let band = index % 3;
        let number = decade(&mut random, band as f64, (band + 1) as f64).min(most) as u64;
        let steps = [ListStep::Tip(case.tip), ListStep::Element(element), ListStep::Root(case.root)];
        let list = StepList::new(&steps).unwrap();
        let root = match mode(&list, number.max(1)) {
            Ok(Some(root)) => root,
            Ok(None) => {
                tally.without += 1;
                continue;
            }
            Err(SearchError::Unstable { .. }) => {
                tally.unstable += 1;
                continue;
            }
            Err(error) => {
                tally.refused += 1;
                eprintln!("{kind:?} {index}: {error} {case:?} mode {number}");
                continue;
            }
        };
        let found = case.root_near(root.omega);
        tally.roots += 1;
        let error = found.away.abs() / (f64::EPSILON * found.condition.max(1.0));
        if error > tally.worst {
            (tally.worst, tally.most.1) = (error, format!("{case:?} mode {number}"));
        }
        // an interval holds the root of the parameters up to their last bits
        let room = f64::EPSILON * found.condition;
        let (lower, upper) = (root.lower * (1.0 - room), root.upper * (1.0 + room));
        if !case.changes_between(lower, upper) {
            tally.outside += 1;
            eprintln!("{kind:?} {index}: outside {root:?} {found:?} {case:?} mode {number}");
        }
        tally.most.0 = tally.most.0.max(found.condition);
    }
    println!("{kind:?}: {tally:?}");
    tally
}

fn assert_good(tally: &Tally) {
    assert_eq!((tally.refused, tally.outside), (0, 0), "{tally:?}");
    assert!(tally.worst <= ROUNDING, "{tally:?}");
}

#[test]
fn roots_of_random_beams_are_those_of_many_digits() {
    for kind in KINDS {
        let tally = judge(kind, 12, 60.0);
        assert!(tally.roots >= 6, "{tally:?}");
        assert_good(&tally);
    }
}

#[test]
#[ignore = "long: .ci/long"]
fn roots_of_hundreds_of_random_beams_are_those_of_many_digits() {
    for kind in KINDS {
        let tally = judge(kind, 400, 1000.0);
        assert!(tally.roots >= 300, "{tally:?}");
        assert_good(&tally);
    }
}

system! {
    struct Timoshenko { length: f64, ei: f64, ga: f64, m: f64, r: f64 }
    fixed -> beam 1 { length, bending_stiffness: ei, shear_stiffness: ga, mass_per_length: m, rotary_inertia: r } -> free
}

system! {
    struct PinnedTimoshenko { length: f64, ei: f64, ga: f64, m: f64, r: f64 }
    pinned -> beam 1 { length, bending_stiffness: ei, shear_stiffness: ga, mass_per_length: m, rotary_inertia: r } -> pinned
}

system! {
    struct Strut { length: f64, ei: f64, m: f64, force: f64, k: f64 }
    pinned -> beam 1 { length, bending_stiffness: ei, mass_per_length: m, axial_force: force, foundation_stiffness: k } -> pinned
}

fn assert_roots<const N: usize>(found: &FrequencyList<f64, N>, exact: &[f64], unit: f64, digits: f64) {
    for (root, exact) in found.iter().zip(exact) {
        let error = (root.omega / unit / exact - 1.0).abs();
        assert!(error <= digits, "{} beside {exact}: {error:e}", root.omega / unit);
        assert_eq!(root.multiplicity, 1);
    }
    assert_eq!(found.len(), exact.len());
}

/// Exact values of `timoshenko_cantilever` and `compressed_on_foundation` of tests/data/frames.json.
#[test]
fn a_stocky_cantilever_and_a_strut_on_a_foundation_have_their_exact_frequencies() {
    let cantilever = Timoshenko { length: 1.0, ei: 100.0, ga: 4000.0, m: 1.0, r: 0.01 }.build().unwrap();
    let exact = [
        32.661_581_769_516_08,
        151.379_830_822_044_16,
        333.530_530_197_368_5,
        514.549_773_718_255_7,
        683.711_589_517_213_2,
        733.759_862_394_925_3,
        878.318_944_629_970_3,
        953.313_186_059_178_9,
    ];
    assert_roots(&cantilever.first_frequencies::<8>().unwrap(), &exact, 1.0, 3e-15);
    let strut = Strut { length: 1.0, ei: 100.0, m: 1.0, force: -500.0, k: 2000.0 }.build().unwrap();
    let exact = [
        82.499_132_740_020_75,
        371.638_718_182_356_75,
        864.060_424_721_858,
        1_554.579_009_012_326_6,
        2_442.682_569_351_068,
    ];
    assert_roots(&strut.first_frequencies::<5>().unwrap(), &exact, 1.0, 5e-15);
}

/// NAFEMS FV5, the bending of a deep simply supported beam of 10 m with a square section of 2 m, steel, k = 5/6; the published target,
/// 42.649, 148.31, 284.55 Hz, has a shear coefficient between 5/6 and 1.
#[test]
fn the_deep_beam_of_nafems_has_its_frequencies() {
    let (e, nu, rho, a) = (200e9, 0.3, 8000.0, 4.0);
    let i = 16.0 / 12.0;
    let ga = 5.0 / 6.0 * e / (2.0 * (1.0 + nu)) * a;
    let beam = PinnedTimoshenko { length: 10.0, ei: e * i, ga, m: rho * a, r: rho * i }.build().unwrap();
    assert_roots(&beam.first_frequencies::<3>().unwrap(), &[42.608_717_3, 147.786_012_0, 282.363_385_5], TAU, 4e-9);
}

/// Closed form: a pinned beam has sines, with two frequencies each above the frequency of thickness shear.
#[test]
fn pinned_beams_have_the_frequencies_of_sines() {
    let (ei, ga, m, r) = (100.0, 4000.0, 1.0, 0.01_f64);
    let beam = PinnedTimoshenko { length: 1.0, ei, ga, m, r }.build().unwrap();
    let mut exact: Vec<f64> = Vec::new();
    for n in 0..=6 {
        let k2 = (f64::from(n) * std::f64::consts::PI).powi(2);
        // m r ω⁴ - (m (EI k² + GA) + r GA k²) ω² + GA k² EI k² = 0
        let (a, b, c) = (m * r, m * (ei * k2 + ga) + r * ga * k2, ga * k2 * ei * k2);
        let root = (b * b - 4.0 * a * c).sqrt();
        exact.push(((b + root) / (2.0 * a)).sqrt());
        if n > 0 {
            exact.push((2.0 * c / (b + root)).sqrt());
        }
    }
    exact.sort_by(f64::total_cmp);
    assert_roots(&beam.first_frequencies::<9>().unwrap(), &exact[..9], 1.0, 4e-15);
}

system! {
    #[derive(Clone, Copy)]
    struct Mixed { l: f64, ei: f64, m: f64, ga: f64, r: f64, n: f64, k: f64, g: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m, shear_stiffness: ga, rotary_inertia: r }
        -> beam 2 {
            length: 1.3 * l, bending_stiffness: ei, mass_per_length: m, shear_stiffness: ga, rotary_inertia: r,
            axial_force: n, foundation_stiffness: k, foundation_shear_stiffness: g
        }
        -> beam 3 { length: l, bending_stiffness: ei, mass_per_length: m, foundation_stiffness: k, foundation_shear_stiffness: g }
        -> beam 4 { length: 0.7 * l, bending_stiffness: ei, mass_per_length: m, axial_force: -0.1 * n }
        -> beam 5 { length: l, bending_stiffness: ei, mass_per_length: m, rotary_inertia: r } -> pinned
}

/// A model and a field of it.
type Field = (&'static str, fn(&mut Mixed) -> &mut f64);

/// Differences of roots, of an error of some 1e-10.
#[test]
fn sensitivities_are_differences_of_roots() {
    const STEP: f64 = 1e-5;
    let fields: [Field; 8] = [
        ("l", |model| &mut model.l),
        ("ei", |model| &mut model.ei),
        ("m", |model| &mut model.m),
        ("ga", |model| &mut model.ga),
        ("r", |model| &mut model.r),
        ("n", |model| &mut model.n),
        ("k", |model| &mut model.k),
        ("g", |model| &mut model.g),
    ];
    for model in [
        Mixed { l: 1.0, ei: 1.0, m: 1.0, ga: 30.0, r: 0.01, n: 5.0, k: 40.0, g: 2.0 },
        Mixed { l: 0.6, ei: 2.0, m: 0.5, ga: 400.0, r: 0.001, n: -3.0, k: 2e3, g: 1.0 },
    ] {
        let system = model.build().unwrap();
        let roots = system.first_frequencies::<8>().unwrap();
        for mode in [0, 3, 7] {
            let sensitivities = system.sensitivity(&roots[mode]).unwrap();
            for (name, field) in fields {
                let at = |factor: f64| {
                    let mut changed = model;
                    *field(&mut changed) *= factor;
                    changed.build().unwrap().first_frequencies::<8>().unwrap()[mode].omega
                };
                let mut changed = model;
                let value = *field(&mut changed);
                let difference = (at(1.0 + STEP) - at(1.0 - STEP)) / (2.0 * STEP);
                let found = sensitivities.get(name).unwrap() * value;
                assert!(
                    (found - difference).abs() <= 1e-8 * roots[mode].omega,
                    "{name} in mode {mode}: {found} {difference}"
                );
            }
        }
    }
}
