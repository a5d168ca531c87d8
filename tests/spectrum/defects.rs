//! Models on which searches went wrong once: each is the smallest that did.
#![expect(clippy::panic, reason = "a failing helper fails the test that called it")]

use crate::counts::count_below;
use mstmm::prelude::*;
use mstmm::search::SearchError;

system! {
    /// Two equal levers on one axle, both bolted to the joint of a cantilever.
    struct Levers { mass: f64, inertia: f64 }
    fixed -> beam 1 { length: 1.56, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a;
    pinned -> body 2 { mass, inertia_about_input: inertia, output_x: 2.541, centre_x: 0.2 } -> conn a;
    pinned -> body 3 { mass, inertia_about_input: inertia, output_x: 2.541, centre_x: 0.2 } -> conn a
           -> beam 4 { length: 1.56, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

system! {
    /// The same with a single lever that has the mass and the inertia of both.
    struct Lever { mass: f64, inertia: f64 }
    fixed -> beam 1 { length: 1.56, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a;
    pinned -> body 2 { mass: 2.0 * mass, inertia_about_input: 2.0 * inertia, output_x: 2.541, centre_x: 0.2 } -> conn a
           -> beam 4 { length: 1.56, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

/// A mass and inertia of the levers, and the first frequencies then, of a model with 40 digits.
const LEVERS: (f64, f64, [f64; 3]) = (0.3, 0.7, [0.642_988_496_048_01, 2.375_970_330_553_04, 9.142_440_917_968_29]);

/// Something is held twice, which is what two levers of one length do; or the answer satisfies `is_right`.
fn is_refused_or<T: core::fmt::Debug>(answer: Result<T, SearchError>, is_right: impl Fn(&T) -> bool) {
    match answer {
        Err(SearchError::Zero { .. }) => {}
        Ok(answer) => assert!(is_right(&answer), "{answer:?}"),
        Err(error) => panic!("{error:?}"),
    }
}

/// The digits of an expected value leave less than this of it.
const LISTED: f64 = 1e-14;

fn agrees(found: &NaturalFrequency, expected: f64) -> bool {
    let margin = LISTED * expected;
    found.multiplicity == 1 && found.lower - margin <= expected && expected <= found.upper + margin
}

#[test]
fn a_lever_of_twice_the_mass_has_the_frequencies_of_two() {
    let (mass, inertia, expected) = LEVERS;
    let found = Lever { mass, inertia }.build().unwrap().first_frequencies::<3>().unwrap();
    assert!(found.iter().zip(expected).all(|(root, expected)| agrees(root, expected)), "{found:?}");
}

#[test]
fn equal_levers_on_one_axle_have_the_first_frequencies_of_one() {
    let (mass, inertia, expected) = LEVERS;
    let system = Levers { mass, inertia }.build().unwrap();
    let right = |found: &Vec<NaturalFrequency>| found.iter().zip(expected).all(|(root, omega)| agrees(root, omega));
    is_refused_or(system.first_frequencies::<3>().map(|found| found.to_vec()), right);
}

#[test]
fn equal_levers_on_one_axle_have_the_frequencies_of_one_in_a_range() {
    let (mass, inertia, expected) = LEVERS;
    let system = Levers { mass, inertia }.build().unwrap();
    let right = |found: &Vec<NaturalFrequency>| found.len() == 1 && agrees(&found[0], expected[0]);
    is_refused_or(system.natural_frequencies::<8>(0.0..=2.0).map(|found| found.to_vec()), right);
}

#[test]
fn equal_levers_on_one_axle_have_the_count_of_one() {
    let (mass, inertia, _) = LEVERS;
    let system = Levers { mass, inertia }.build().unwrap();
    for (omega, expected) in [(0.6, 0), (1.0, 1), (2.0, 1), (3.0, 2), (9.1, 2), (9.15, 3)] {
        is_refused_or(count_below(&system, omega), |&count| count == expected);
    }
}

/// Without mass, too, the levers hold no more than one of them does.
#[test]
fn equal_massless_levers_on_one_axle_have_the_frequencies_of_one() {
    let single = Lever { mass: 0.0, inertia: 0.0 }.build().unwrap().first_frequencies::<3>().unwrap();
    let double = Levers { mass: 0.0, inertia: 0.0 }.build().unwrap();
    let right = |found: &Vec<NaturalFrequency>| found.iter().zip(&single).all(|(a, b)| agrees(a, b.omega));
    is_refused_or(double.first_frequencies::<3>().map(|found| found.to_vec()), right);
}

system! {
    /// Cantilever with a dashpot at its tip and a point mass on a rigid arm.
    struct ArmMass { mass: f64, centre: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a;
    fixed -> damper 2 { damping: 0.25 } -> conn a
          -> body 3 { mass, inertia_about_input: mass * centre * centre, output_x: centre, centre_x: centre } -> free;
}

/// The second eigenvalue has a node at the heavy point: there `J_I - m c²` is all that counts of the inertia.
#[test]
fn the_disc_of_a_beam_with_a_heavy_point_on_an_arm_holds_the_eigenvalue() {
    let expected = Complex::new(-0.232_565_579_870_354_7, 7.206_313_629_913_533_1);
    let found = ArmMass { mass: 1e6, centre: 1.1 }.build().unwrap().first_eigenvalues::<6>().unwrap();
    let distance = (found[1].lambda - expected).norm();
    // the expected value and the distance are rounded
    let rounding = 4.0 * f64::EPSILON * expected.norm();
    assert!(distance <= found[1].error + rounding, "{distance:e} away: {:?}", found[1]);
}

system! {
    /// A beam with a body in it, from which a massless lever leads back to where the first lever began.
    struct ThereAndBack { offset: f64 }
    fixed -> beam 1 { length: 1.372, bending_stiffness: 1.876, mass_per_length: 1.0 }
          -> body 2 { mass: 1.694, inertia_about_input: 1.003, output_x: offset, centre_x: 0.0 }
          -> body 3 { mass: 0.0, inertia_about_input: 0.0, output_x: -offset, centre_x: 0.0 }
          -> beam 4 { length: 1.662, bending_stiffness: 1.849, mass_per_length: 1.0 } -> free;
}

/// Equal levers there and back are none at all.
#[test]
fn levers_there_and_back_change_no_frequency() {
    let found = |offset: f64| ThereAndBack { offset }.build().unwrap().first_frequencies::<6>().unwrap();
    let none = found(0.0);
    for offset in [10.0, 1e3, 18_850.0, 1e6] {
        for (root, expected) in found(offset).iter().zip(&none) {
            let overlap = root.lower <= expected.upper && expected.lower <= root.upper;
            assert!(overlap, "{offset} m: {root:?} instead of {expected:?}");
        }
    }
}

system! {
    /// A cantilever with a dashpot at its middle.
    struct Tip {}
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a
          -> beam 2 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
    fixed -> damper 3 { damping: 1.0 } -> conn a;
}

/// The region that all of them are in, and a million times longer ones: no more evaluations than a few cuts ask for.
#[test]
fn a_region_may_be_long_in_the_real_direction() {
    let system = Tip {}.build().unwrap();
    let found = |re: f64| system.eigenvalues::<32>(Region { re: -re..=1.0, im: -1.0..=300.0 }).unwrap();
    let short = found(1e3);
    for re in [1e4, 1e5, 1e6] {
        let long = found(re);
        assert_eq!(long.len(), short.len(), "to {re:e}");
        let (few, many) = (short.evaluations(), long.evaluations());
        assert!(many <= 20 * few, "{many} evaluations to {re:e}, {few} to 1e3");
    }
}

system! {
    /// A wheel on a short lever that a spring holds: `ω = b sqrt(k/J)`.
    struct ShortLever { b: f64 }
    pinned -> body 1 { mass: 1.0, inertia_about_input: 1.0, output_x: b, centre_x: 0.0 } -> conn a -> free;
    fixed -> spring 2 { stiffness: 1.0 } -> conn a;
}

/// Closed form; a frequency is not zero because it is small.
#[test]
fn a_slow_lever_is_no_rigid_body() {
    for b in [1e-9, 1e-10, 1e-12] {
        let found = ShortLever { b }.build().unwrap().first_frequencies::<1>().unwrap()[0];
        let close = (found.omega / b - 1.0).abs() <= 16.0 * f64::EPSILON;
        assert!(close && found.lower > 0.0 && found.lower <= b && b <= found.upper, "{found:?} instead of {b}");
    }
}

system! {
    struct Oscillator { k: f64, c: f64, m: f64 }
    fixed -> spring 1 { stiffness: k, damping: c } -> mass 2 { mass: m } -> free;
}

/// Closed form: `λ = -ζω ± iω sqrt(1 - ζ²)`.
#[test]
fn the_eigenvalue_of_an_oscillator_is_found_wherever_it_lies() {
    for (w, z) in [(32.337_f64, 0.2002_f64), (32.008, 0.025)] {
        let system = Oscillator { k: w * w, c: 2.0 * z * w, m: 1.0 }.build().unwrap();
        let region = Region { re: -330.0..=4.0, im: 0.0..=330.0 };
        assert_eq!(system.count_in(region), Ok(1));
        let found = system.first_eigenvalues::<1>().unwrap();
        let expected = Complex::new(-z * w, w * (1.0 - z * z).sqrt());
        // ω² and 2ζω of the model are rounded, and so is the expected value
        let rounding = 8.0 * f64::EPSILON * w;
        let distance = (found[0].lambda - expected).norm();
        assert!(distance <= found[0].error + rounding, "{distance:e} away: {:?}", found[0]);
    }
}

system! {
    /// A quarter of a car on its tyre.
    struct QuarterCar {}
    fixed -> spring tyre { stiffness: 142496.0, damping: 78.0 } -> mass wheel { mass: 29.46 }
          -> spring strut { stiffness: 21248.8, damping: 2937.5 } -> mass body { mass: 345.7 } -> free;
}

/// The quartic `|K + λC + λ²M|`, and the eigenvalues to the digits known.
#[test]
fn all_eigenvalues_of_a_quarter_car_are_found() {
    let found = QuarterCar {}.build().unwrap().first_eigenvalues::<2>().unwrap();
    let expected = [Complex::new(-3.61, 6.96), Complex::new(-51.8, 46.3)];
    assert_eq!(found.len(), 2);
    for (root, expected) in found.iter().zip(expected) {
        assert!((root.lambda - expected).norm() < 2e-3 * expected.norm(), "{root:?} instead of {expected}");
        let l = root.lambda;
        let (tyre, strut) = (l * 78.0 + 142_496.0, l * 2937.5 + 21_248.8);
        let (wheel, body) = (l * l * 29.46, l * l * 345.7);
        let quartic = (tyre + strut + wheel) * (strut + body) - strut * strut;
        let size = (tyre.norm() + strut.norm() + wheel.norm()) * (strut.norm() + body.norm());
        // a root moves by 16 eps, each of four factors with it, and the terms have about ten roundings
        assert!(quartic.norm() < 128.0 * f64::EPSILON * size, "{root:?}");
    }
}

system! {
    /// A cantilever with a damper that is switched off.
    struct SwitchedOff {}
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a -> free;
    fixed -> damper 2 { damping: 0.0 } -> conn a;
}

/// Nothing drives it, so that no motion grows.
#[test]
fn no_undamped_motion_has_a_negative_damping_ratio() {
    let found = SwitchedOff {}.build().unwrap().first_eigenvalues::<8>().unwrap();
    let ratios: Vec<f64> = found.iter().map(Eigenvalue::damping_ratio).collect();
    assert!(ratios.iter().all(|&ratio| ratio >= 0.0), "{ratios:?}");
}

/// Closed form of a mass of 1 on a spring of 1: beside the critical damping of 2 a rounding of Δ moves the eigenvalues by its root,
/// at first in one direction alone.
#[test]
fn discs_hold_beside_the_critical_damping() {
    for step in 1..=150 {
        for sign in [-1.0, 1.0] {
            let half = 1.0 + sign * 10f64.powf(-f64::from(step) / 10.0);
            let root = ((1.0 - half) * (1.0 + half)).abs().sqrt();
            let expected = if half < 1.0 {
                [Complex::new(-half, root), Complex::new(-half, -root)]
            } else {
                [Complex::new(-1.0 / (half + root), 0.0), Complex::new(-(half + root), 0.0)]
            };
            let system = Oscillator { k: 1.0, c: 2.0 * half, m: 1.0 }.build().unwrap();
            let found = system.eigenvalues::<2>(Region { re: -5.0..=0.1, im: -2.0..=2.0 }).unwrap();
            assert_eq!(found.iter().map(|root| root.multiplicity).sum::<u64>(), 2, "{half}");
            for lambda in expected {
                // the closed form has a few roundings itself
                let holds = |root: &Eigenvalue| (root.lambda - lambda).norm() <= root.error + 4.0 * f64::EPSILON * half;
                assert!(found.iter().any(holds), "damping ratio {half}: {lambda} in none of {:?}", &*found);
            }
        }
    }
}

system! {
    /// Two cantilevers, whose tips a spring joins so loosely that rounding cannot tell their frequencies apart.
    struct Pair { other: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a -> spring 2 { stiffness: 1e-30 } -> conn b;
    fixed -> beam 3 { length: other, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b -> free;
}

/// Closed form: each frequency of a cantilever, twice, wherever the list ends or the range begins or ends.
#[test]
fn an_interval_at_the_end_of_a_list_counts_both_roots_of_a_pair() {
    /// Both frequencies of each pair are there, in one entry or in two, and no third; of the first and the last pair one may be beyond the end of
    /// what was asked for.
    fn assert_pairs(found: &[NaturalFrequency], of: &str) {
        let is_near = |one: &NaturalFrequency, other: &NaturalFrequency| other.omega - one.omega < 1e-12 * one.omega;
        let pairs: Vec<u64> =
            found.chunk_by(is_near).map(|pair| pair.iter().map(|root| root.multiplicity).sum()).collect();
        let inner = pairs.get(1..pairs.len() - 1).unwrap_or_default();
        assert!(inner.iter().all(|count| *count == 2), "{of}: {found:?}");
        assert!(pairs.iter().all(|count| (1..=2).contains(count)), "{of}: {found:?}");
    }
    for other in [1.0, 1.0 + 2.0 * f64::EPSILON, 1.0 - f64::EPSILON, 1.0 + f64::EPSILON, 1.0 - 3.0 * f64::EPSILON] {
        let system = Pair { other }.build().unwrap();
        assert_pairs(&system.first_frequencies::<1>().unwrap(), "the first one");
        assert_pairs(&system.first_frequencies::<3>().unwrap(), "the first three");
        assert_pairs(&system.first_frequencies::<5>().unwrap(), "the first five");
        let second = system.first_frequencies::<4>().unwrap()[1].omega;
        for end in [second * (1.0 - f64::EPSILON), second, second * (1.0 + f64::EPSILON)] {
            assert_pairs(&system.natural_frequencies::<8>(1.0..=end).unwrap(), "up to the second");
            assert_pairs(&system.natural_frequencies::<8>(end..=70.0).unwrap(), "from the second on");
        }
    }
}

system! {
    /// A beam in the air.
    struct InTheAir {}
    free -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

/// Two motions of a rigid body belong to each range that starts at zero.
#[test]
fn a_range_that_ends_just_above_zero_has_the_motions_of_the_rigid_body() {
    let system = InTheAir {}.build().unwrap();
    for end in [1e-300, 1e-20, 1e-10, 1e-9, 1e-3, 1.0] {
        let found = system.natural_frequencies::<4>(0.0..=end).unwrap();
        assert_eq!(
            found.iter().map(|root| (root.omega, root.multiplicity)).collect::<Vec<_>>(),
            [(0.0, 2)],
            "up to {end:e}"
        );
    }
}
