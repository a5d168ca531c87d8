//! Certified frequencies against exact values of another method (see `about` in tests/data/validation.json).
//!
//! Everywhere: the exact value, compared in all its digits, lies in the proven interval, but for what rounding its decimal parameters to
//! doubles has moved the root; the interval is no wider than [`WIDTH`]; index, multiplicity and counts are those of the exact spectrum.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]
#![expect(clippy::panic, reason = "the same")]

mod cases;
mod models;

use crate::decimal::is_within;
use cases::{Case, Connection, Root, Sequence, Steps, Tip, beam, element, spring};
use models::{DampedBeam, FromValues, SprungMasses, Stepped, Twins};
use mstmm::element::Support;
use mstmm::elements::ElasticHinge;
use mstmm::prelude::*;
use mstmm::search::System;
use serde_json::Value;

/// Relative width of a proven interval: from a number to the next one.
const WIDTH: f64 = f64::EPSILON;

/// Relative diameter of a certified circle per unit of condition: 36 eps, of which the certificate takes 32.
const DAMPED_WIDTH: f64 = 8e-15;

/// What rounding a parameter to a double may move it by, in its own size.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Relative step of central differences: far above the rounding of a root, far below the distance of any two.
const STEP: f64 = 1e-6;

/// An undamped system.
trait Searched: Undamped + System<Parameter = f64> {}
impl<Y: Undamped + System<Parameter = f64>> Searched for Y {}

/// All cases of the file, with their ids.
fn cases() -> Vec<(String, Value)> {
    let file: Value = serde_json::from_str(include_str!("../data/validation.json")).unwrap();
    let id = |case: &Value| case["id"].as_str().unwrap().to_owned();
    file["cases"].as_array().unwrap().iter().map(|case| (id(case), case.clone())).collect()
}

/// Modes and exact frequencies of a case, in ascending order; modes count from 1 and include rigid-body modes.
fn exact_modes(case: &Value) -> Vec<(u64, String)> {
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    if let Some(all) = case["omega"].as_array() {
        return (1..).zip(all.iter().map(text)).collect();
    }
    let pairs = case["omega_by_mode"].as_array().unwrap();
    pairs.iter().map(|pair| (pair[0].as_u64().unwrap(), text(&pair[1]))).collect()
}

/// The exact frequencies of one case of the file, from the first on.
fn exact(id: &str) -> Vec<(u64, String)> {
    exact_modes(&cases().into_iter().find(|(other, _)| other == id).unwrap().1)
}

/// The certified entry of a mode, from a search around a frequency.
fn mode(system: &impl Searched, index: u64, near: f64) -> NaturalFrequency {
    let found = system.natural_frequencies::<128>(near * 0.999..=near * 1.001).unwrap();
    let holds = |root: &&NaturalFrequency| {
        let below = system.count_below(root.lower).unwrap();
        below < index && index <= below + root.multiplicity
    };
    *found.iter().find(holds).unwrap_or_else(|| panic!("mode {index} is not near {near}"))
}

/// Condition of a mode: `Σ |∂ω/∂p · p/ω|` over the parameters, by central differences of the root itself; at least 1.
fn condition(parameters: &[f64], root_of: impl Fn(&[f64]) -> f64) -> f64 {
    let omega = root_of(parameters);
    let sensitivity = |k: usize| {
        let moved = |factor: f64| {
            let mut parameters = parameters.to_vec();
            parameters[k] *= factor;
            root_of(&parameters)
        };
        (moved(1.0 + STEP) - moved(1.0 - STEP)).abs() / (2.0 * STEP * omega)
    };
    (0..parameters.len()).map(sensitivity).sum::<f64>().max(1.0)
}

/// Whether a decimal is in an interval, but for the rounding of parameters of a root with such a condition, and for its own last digit.
fn is_near(exact: &str, root: &NaturalFrequency, condition: f64) -> bool {
    let room = root.omega * (condition + 0.25) * ROUNDING;
    is_within(exact, root.lower - room, root.upper + room)
}

/// The certificate of a single root.
fn assert_certified(
    system: &impl Searched,
    root: &NaturalFrequency,
    index: u64,
    exact: &str,
    condition: f64,
    id: &str,
) {
    let NaturalFrequency { omega, lower, upper, multiplicity, is_proven, index: of_root } = *root;
    assert!(is_proven && of_root == index, "{id}, mode {index}: {root:?}");
    assert!(is_near(exact, root, condition), "{id}, mode {index}: {exact} is not in [{lower:?}, {upper:?}]");
    assert!(lower <= omega && omega <= upper, "{id}, mode {index}: {omega} is not in [{lower:?}, {upper:?}]");
    let width = (upper - lower) / omega;
    assert!(width <= WIDTH, "{id}, mode {index}: width {width:e}, condition {condition}");
    assert_eq!(multiplicity, 1, "{id}, mode {index}");
    assert_eq!(
        (system.count_below(lower), system.count_below(upper)),
        (Ok(index - 1), Ok(index)),
        "{id}, mode {index}"
    );
}

/// Every mode of a case, its system built from the values of its parameters.
fn check<Y: Searched>(id: &str, case: &Value, parameters: &[f64], build: impl Fn(&[f64]) -> Y) {
    let system = build(parameters);
    for (index, exact) in exact_modes(case) {
        let near: f64 = exact.parse().unwrap();
        if near > 0.0 {
            let condition = condition(parameters, |parameters| mode(&build(parameters), index, near).omega);
            assert_certified(&system, &mode(&system, index, near), index, &exact, condition, id);
        }
    }
}

/// Oracle: the file; modes 1 to 1000.
#[test]
fn every_undamped_case_is_certified_by_steps() {
    let mut checked = 0;
    for (id, case) in cases() {
        if let Some(model) = Case::of(&id) {
            check(&id, &case, &model.parameters, |parameters| model.build(parameters));
            checked += 1;
        }
    }
    assert_eq!(checked, cases().len() - 1, "the damped beam has a test of its own");
}

/// Oracle: the file.
#[test]
fn cases_in_the_language_are_certified() {
    for (id, case) in cases() {
        let parameters = || Case::of(&id).unwrap().parameters;
        if id.starts_with("twin_cantilevers") {
            check(&id, &case, &parameters(), Twins::system_of);
        } else if id.starts_with("stepped") {
            check(&id, &case, &parameters(), Stepped::system_of);
        } else if id == "three_sprung_masses" {
            check(&id, &case, &parameters(), SprungMasses::system_of);
        }
    }
}

/// Oracle: the file, where it lists all modes from the first on: the range from zero holds these and no others.
#[test]
fn a_range_holds_every_mode_once() {
    for (id, case) in cases() {
        if case["omega"].is_null() {
            continue;
        }
        let model = Case::of(&id).unwrap();
        let system = model.build(&model.parameters);
        let modes = exact_modes(&case);
        let last: f64 = modes.last().unwrap().1.parse().unwrap();
        let found = system.natural_frequencies::<16>(0.0..=last * (1.0 + 1e-9)).unwrap();
        let mut positive = modes.iter().filter(|(_, exact)| exact.parse::<f64>().unwrap() > 0.0);
        let rigid = modes.len() - positive.clone().count();
        let multiplicities = (found[0].omega == 0.0).then_some(found[0].multiplicity);
        assert_eq!(multiplicities.unwrap_or(0), rigid as u64, "{id}");
        for root in found.iter().filter(|root| root.omega > 0.0) {
            let (index, exact) = positive.next().unwrap();
            // conditions are computed where each mode is checked by itself
            assert!(is_near(exact, root, 8.0), "{id}, mode {index}: {root:?}");
        }
        assert_eq!(positive.next(), None, "{id}");
    }
}

/// Frequencies and multiplicities of the first entries of a list of steps.
fn first<const N: usize>(steps: Sequence) -> Vec<NaturalFrequency> {
    Steps(steps).first_frequencies::<N>().unwrap().to_vec()
}

/// Oracle: a star of three equal arms, each fixed outside, moves at the centre as one cantilever does at its tip, or
/// rests there with two independent sets of forces that cancel: each frequency of a clamped arm is a double root.
#[test]
fn a_symmetric_star_has_double_roots() {
    let arm = [Tip(Support::Fixed), beam(&[1.0, 1.0, 1.0])];
    let mut steps = [arm, arm, arm].concat();
    steps.extend([Connection(3), Root(Support::Free)]);
    let found = first::<13>(steps);
    let tagged = |id, count, multiplicity| {
        exact(id).into_iter().take(count).map(move |(_, exact)| (exact, multiplicity)).collect::<Vec<_>>()
    };
    let mut expected = [tagged("single_free_fixed", 5, 1), tagged("single_fixed_fixed", 4, 2)].concat();
    expected.sort_by(|(a, _), (b, _)| a.parse::<f64>().unwrap().total_cmp(&b.parse().unwrap()));
    for (root, (exact, multiplicity)) in found.iter().zip(&expected) {
        assert!(is_within(exact, root.lower, root.upper), "{exact} is not in {root:?}");
        assert_eq!(root.multiplicity, *multiplicity, "{exact}");
        assert!(root.upper - root.lower <= WIDTH * root.omega, "{root:?}");
    }
    assert_eq!(found.len(), expected.len());
}

/// Asserts the number of rigid-body modes, and that the next frequency is not near zero.
fn assert_rigid_body_modes(steps: Sequence, expected: u64) {
    let found = first::<4>(steps);
    assert_eq!((found[0].omega, found[0].lower, found[0].multiplicity), (0.0, 0.0, expected));
    assert!(found[1].lower > 0.1, "{:?}", found[1]);
}

/// Oracle: degrees of freedom that no stiffness holds: two of a free bar, and of bars joined one for each that the joint
/// leaves free.
#[test]
fn rigid_body_modes_are_counted_at_zero() {
    let bar = beam(&[1.0, 1.0, 1.0]);
    let (tip, root) = (Tip(Support::Free), Root(Support::Free));
    assert_rigid_body_modes(vec![tip, bar, root], 2);
    let hinge = element(ElasticHinge { stiffness_y: 3.0, stiffness_theta: 2.0 });
    assert_rigid_body_modes(vec![tip, bar, hinge, bar, root], 2);
    let through_spring = [tip, bar, Connection(1), spring(3.0), Connection(1), bar, root];
    assert_rigid_body_modes(through_spring.to_vec(), 3);
    assert_rigid_body_modes(vec![Tip(Support::Pinned), bar, root], 1);
}

/// Oracle: of two free bars whose ends are joined by a spring, the motions in phase do not strain it.
#[test]
fn a_path_narrowed_to_a_spring_keeps_the_motions_in_phase() {
    let bar = beam(&[1.0, 1.0, 1.0]);
    // the second bar mirrors the first: it arrives at the connection from its own free end
    let first_bar = [Tip(Support::Free), bar, Connection(1), spring(3.0)];
    let second_bar = [Tip(Support::Free), bar, Connection(2), Root(Support::Free)];
    let system = Steps(first_bar.into_iter().chain(second_bar).collect());
    let found = system.natural_frequencies::<16>(0.0..=200.0).unwrap();
    for (_, exact) in exact("single_free_free").into_iter().skip(2) {
        assert!(found.iter().any(|root| is_within(&exact, root.lower, root.upper)), "{exact}");
    }
    assert_eq!(found.iter().map(|root| root.multiplicity).sum::<u64>(), 3 + 1 + 4 + 4);
}

/// The damped beam, searched by `eigenvalues`.
mod damped {
    use super::*;

    type C = Complex<f64>;

    /// Oracle: the file. All eight listed eigenvalues and no others, four of them on the imaginary axis and so on the edge
    /// of the region; each circle, no wider than a certified interval per unit of condition, holds the exact value.
    #[test]
    fn eigenvalues_of_the_damped_beam_are_exact() {
        let parameters = [0.5, 7e10 * 0.05 * 0.005_f64.powi(3) / 12.0, 0.674, 5.0];
        let (_, case) = cases().into_iter().find(|(id, _)| id == "damped_beam").unwrap();
        let number = |value: &Value| value.as_str().unwrap().parse::<f64>().unwrap();
        let region = || Region { re: -20.0..=0.0, im: 0.0..=5000.0 };
        let roots = |parameters: &[f64]| DampedBeam::system_of(parameters).eigenvalues::<16>(region()).unwrap();
        let (found, listed) = (roots(&parameters), case["lambda"].as_array().unwrap());
        assert_eq!(found.len(), listed.len());
        assert_eq!(DampedBeam::system_of(&parameters).count_in(region()), Ok(8));
        for (index, (root, pair)) in found.iter().zip(listed).enumerate() {
            let exact = C::new(number(&pair[0]), number(&pair[1]));
            let condition: f64 = (0..4)
                .map(|k| {
                    let moved = |factor: f64| {
                        let mut parameters = parameters;
                        parameters[k] *= factor;
                        roots(&parameters)[index].lambda
                    };
                    (moved(1.0 + STEP) - moved(1.0 - STEP)).norm() / (2.0 * STEP * exact.norm())
                })
                .sum();
            assert_eq!(root.multiplicity, 1, "{exact}");
            // the file has 18 digits, which are rounded here
            let rounding = 0.5 * f64::EPSILON * exact.norm();
            assert!((root.lambda - exact).norm() <= root.error + rounding, "{exact}: {root:?}");
            assert!(
                2.0 * root.error <= DAMPED_WIDTH * condition.max(1.0) * exact.norm(),
                "{exact}: {root:?}, {condition}"
            );
        }
    }
}
