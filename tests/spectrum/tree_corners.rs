//! Corners of trees, each against a closed form or an equivalent tree.
#![expect(clippy::unwrap_used, reason = "all elements here are valid")]

use core::f64::consts::PI;
use mstmm::element::Support;
use mstmm::elements::{Beam, Damper, ElasticHinge, Mass, PointMass, Spring, SpringDamper};
use mstmm::list::{AnyElement, AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;

type Step = ListStep<AnyUndamped<f64>>;

fn beam() -> Step {
    let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    ListStep::Element(beam.try_into().unwrap())
}

fn mass() -> Step {
    ListStep::Element(Mass { mass: 1.0 }.try_into().unwrap())
}

fn spring() -> Step {
    ListStep::Element(Spring { stiffness: 1.0 }.try_into().unwrap())
}

/// The first frequencies with their multiplicities.
fn first<const N: usize>(steps: &[Step]) -> Vec<(f64, u64)> {
    let found = StepList::new(steps).unwrap().first_frequencies::<N>().unwrap();
    found.iter().map(|root| (root.omega, root.multiplicity)).collect()
}

/// A line that is fixed holds the deflection of a beam, not its rotation: a mass there changes nothing.
#[test]
fn a_mass_on_a_fixed_tip_is_a_pin() {
    let fixed = [ListStep::Tip(Support::Fixed), mass(), ListStep::Tip(Support::Free), beam(), ListStep::Connection(2)];
    let pinned = [ListStep::Tip(Support::Pinned), ListStep::Tip(Support::Free), beam(), ListStep::Connection(2)];
    let root = [ListStep::Root(Support::Free)];
    let [fixed, pinned] = [&fixed[..], &pinned[..]].map(|steps| first::<4>(&[steps, &root].concat()));
    assert_eq!((fixed.len(), pinned.len()), (4, 4));
    for ((one, multiplicity), (other, same)) in fixed.into_iter().zip(pinned) {
        assert_eq!(multiplicity, same);
        // both are certified to 4 eps or so, each from starts of its own
        assert!((one - other).abs() <= 8.0 * f64::EPSILON * other, "{one} and {other}");
    }
}

/// Closed form: arms of one length on pins turn about all pins at once, since the middle moves by the length times the
/// angle on each of them.
#[test]
fn equal_arms_on_pins_turn_as_a_rigid_body() {
    for length in [0.37, 1.0, 1.3, 2.9, 3.1] {
        let arm = Beam { length, bending_stiffness: 0.7, mass_per_length: 1.3 };
        let arm: Step = ListStep::Element(arm.try_into().unwrap());
        let tip = ListStep::Tip(Support::Pinned);
        let steps = [tip, arm, tip, arm, tip, arm, ListStep::Connection(3), ListStep::Root(Support::Free)];
        let found = first::<2>(&steps);
        assert_eq!(found[0], (0.0, 1), "{length}: {found:?}");
    }
}

/// Closed form: with `cos z = 0` the stiffnesses of a fixed and of a free arm of one length are each other's negative, so
/// that their sum vanishes and with it both frequencies of `z = π/2`, those of a guided-pinned beam.
#[test]
fn a_fixed_and_a_free_arm_have_a_double_root() {
    let (fixed, free) = (ListStep::Tip(Support::Fixed), ListStep::Tip(Support::Free));
    let steps = [fixed, beam(), free, beam(), ListStep::Connection(2), ListStep::Root(Support::Free)];
    let omega = PI * PI / 4.0;
    let list = StepList::new(&steps).unwrap();
    // within sqrt(eps) of such a double root a single count would be at the mercy of rounding: it is judged
    let counts = [1.0 - 1e-14, 1.0 + 1e-14].map(|factor| list.count_below(omega * factor));
    assert_eq!(counts, [Ok(0), Ok(2)]);
    let (found, multiplicity) = first::<2>(&steps)[0];
    assert!((found / omega - 1.0).abs() < 1e-14 && multiplicity == 2, "{found} x{multiplicity}");
}

/// A translation path ends in `fixed` or `free` only, at a connection as elsewhere.
#[test]
fn a_list_refuses_a_pin_on_a_line() {
    let pin = ListStep::Tip(Support::Pinned);
    let held =
        [ListStep::Tip(Support::Fixed), spring(), pin, ListStep::Connection(2), mass(), ListStep::Root(Support::Free)];
    assert!(StepList::new(&held).is_err(), "at a connection");
    let ended = [ListStep::Tip(Support::Fixed), spring(), mass(), ListStep::Root(Support::Pinned)];
    assert!(StepList::new(&ended).is_err(), "at the root");
    let rolling = [ListStep::Tip(Support::Fixed), beam(), ListStep::Root(Support::Roller)];
    assert!(StepList::new(&rolling).is_err(), "a roller on a beam");
}

/// Closed form of a beam on pins, `ω = π²`.
#[test]
fn a_pin_may_be_written_at_the_root_or_at_a_connection_before_a_free_root() {
    let pin = ListStep::Tip(Support::Pinned);
    let ended = [pin, beam(), ListStep::Root(Support::Pinned)];
    let held = [pin, beam(), pin, ListStep::Connection(2), ListStep::Root(Support::Free)];
    for steps in [&ended[..], &held] {
        let (omega, multiplicity) = first::<1>(steps)[0];
        // z is good to a few units in the last place, twice that in ω
        assert!((omega / (PI * PI) - 1.0).abs() < 1e-14 && multiplicity == 1, "{omega} x{multiplicity}");
    }
}

system! {
    struct HeldByTwo { length: f64 }
    free -> conn 1;
    pinned -> conn 1;
    conn 1 -> beam 2 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

/// Closed form of a beam with one pin, `tan z = th z`, z = 3.926602312047919.
#[test]
fn two_supports_at_a_connection_hold_together() {
    let system = HeldByTwo { length: 1.0 }.build().unwrap();
    let found = system.first_frequencies::<2>().unwrap();
    let z: f64 = 3.926_602_312_047_919;
    assert_eq!((found[0].omega, found[0].multiplicity), (0.0, 1));
    assert!((found[1].omega / (z * z) - 1.0).abs() < 1e-14, "{}", found[1].omega);
}

/// Closed form: a spring of 27 beside a damper of 8 in series with a spring of 216 holds a unit mass with the characteristic
/// polynomial (λ + 9)³.
#[test]
fn a_triple_eigenvalue_is_found_as_one() {
    let element = |element: AnyElement<f64>| ListStep::Element(element);
    let steps = [
        ListStep::Tip(Support::Fixed),
        element(Spring { stiffness: 27.0 }.try_into().unwrap()),
        ListStep::Tip(Support::Fixed),
        element(Damper { damping: 8.0 }.try_into().unwrap()),
        element(Spring { stiffness: 216.0 }.try_into().unwrap()),
        ListStep::Connection(2),
        element(Mass { mass: 1.0 }.try_into().unwrap()),
        ListStep::Root(Support::Free),
    ];
    let found = StepList::new(&steps).unwrap().eigenvalues::<4>(Region { re: -50.0..=5.0, im: -50.0..=50.0 }).unwrap();
    assert_eq!((found.len(), found[0].multiplicity), (1, 3));
    assert!((found[0].lambda.re + 9.0).abs() <= found[0].error && found[0].error < 1e-2, "{:?}", found[0]);
}

/// Closed form: an undamped cantilever in a strip of 1e-6 around the imaginary axis; and a damper so strong that one
/// eigenvalue is 1e10 times as far as the springs of other systems suggest.
#[test]
fn slender_regions_and_strong_dampers_are_searched() {
    let steps: [Step; 3] = [ListStep::Tip(Support::Fixed), beam(), ListStep::Root(Support::Free)];
    let list = StepList::new(&steps).unwrap();
    assert_eq!(list.count_in(Region { re: -1e-6..=1e-6, im: 1.0..=100.0 }), Ok(3));
    let damper = ListStep::Element(AnyElement::try_from(Damper { damping: 1e10_f64 }).unwrap());
    let mass = ListStep::Element(AnyElement::try_from(Mass { mass: 1.0 }).unwrap());
    let steps = [ListStep::Tip(Support::Fixed), damper, mass, ListStep::Root(Support::Free)];
    let found = StepList::new(&steps).unwrap().first_eigenvalues::<2>().unwrap();
    assert_eq!(found[0].lambda.re, 0.0);
    assert!((found[1].lambda.re / -1e10 - 1.0).abs() < 1e-14);
}

system! {
    /// A mass on a spring, and an inertia on a torsion spring behind it: nothing passes from one to the other.
    struct TurnedAway { k: f64, m: f64, kt: f64, j: f64 }
    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> conn 3
          -> torsion_spring 4 { stiffness: kt } -> inertia 5 { inertia: j } -> free;
    guided -> conn 3;
}

/// Closed form: `ω² = k/m` and `kt/j`, since the guide holds the rotation and leaves the deflection free.
#[test]
fn a_translation_may_go_on_as_a_rotation() {
    let system = TurnedAway { k: 4.0, m: 1.0, kt: 18.0, j: 2.0 }.build().unwrap();
    let found = system.first_frequencies::<2>().unwrap();
    let expected = [2.0, 3.0];
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.lower <= expected && expected <= found.upper, "{found}");
    }
    // and the same Δ as the determinant, which knows nothing of planes
    let ratio = |omega: f64| system.characteristic(omega).value() / system.overall_determinant(omega).value();
    for omega in [0.3, 1.1, 2.5, 7.0] {
        assert!((ratio(omega) / ratio(1.7) - 1.0).abs() <= 16.0 * f64::EPSILON, "{omega}");
    }
}

/// Masses on springs of so many stiffnesses, all on a mass on a spring and damper.
fn oscillators(stiffnesses: &[f64]) -> Vec<ListStep<AnyElement<f64>>> {
    let mut steps = Vec::new();
    for &stiffness in stiffnesses {
        let (mass, spring) = (Mass { mass: 1.0 }.try_into().unwrap(), Spring { stiffness }.try_into().unwrap());
        steps.extend([ListStep::Tip(Support::Free), ListStep::Element(mass), ListStep::Element(spring)]);
    }
    let strut = SpringDamper { stiffness: 3.0, damping: 0.01 };
    steps.extend([ListStep::Tip(Support::Free), ListStep::Element(Mass { mass: 1.0 }.try_into().unwrap())]);
    steps.extend([ListStep::Tip(Support::Fixed), ListStep::Element(strut.try_into().unwrap())]);
    steps.extend([ListStep::Connection(stiffnesses.len() + 2), ListStep::Root(Support::Free)]);
    steps
}

/// Eleven of the eigenvalues lie within a part in ten thousand of each other, and are simple. Closed form: the zeros of
/// `λ² + cλ + K + Σ k λ²/(λ² + k)`, from each of which a step of Newton's method must not lead out of its circle.
#[test]
fn a_cluster_of_simple_eigenvalues_is_told_apart() {
    let stiffnesses: Vec<f64> = (0..12).map(|i| 1.0 + 3e-5 * f64::from(i) * (1.0 + 0.1 * f64::from(i))).collect();
    let steps = oscillators(&stiffnesses);
    let list = StepList::new(&steps).unwrap();
    let found = list.eigenvalues::<32>(Region { re: -5.0..=1.0, im: 0.1..=30.0 }).unwrap();
    assert_eq!(found.len(), 13);
    for root in &found {
        let Eigenvalue { lambda, error, multiplicity, .. } = *root;
        let (mut value, mut slope) = (lambda * lambda + 0.01 * lambda + 3.0, 2.0 * lambda + 0.01);
        for &k in &stiffnesses {
            let below = lambda * lambda + k;
            value += k * lambda * lambda / below;
            slope += 2.0 * k * k * lambda / (below * below);
        }
        assert!(multiplicity == 1 && error < 1e-12, "{root:?}");
        // the terms of the closed form nearly cancel and magnify the rounding of λ² + k: it is good to 1e-10 here
        assert!((value / slope).norm() <= error + 1e-10, "{root:?}: {:e}", (value / slope).norm());
    }
}

/// Closed form: of twelve equal oscillators, eleven move against each other with `λ² = -k`.
#[test]
fn equal_oscillators_have_one_eigenvalue_many_times() {
    let steps = oscillators(&[1.0; 12]);
    let list = StepList::new(&steps).unwrap();
    let found = list.eigenvalues::<32>(Region { re: -5.0..=1.0, im: 0.1..=30.0 }).unwrap();
    let multiple = found.iter().find(|root| root.multiplicity > 1).unwrap();
    assert_eq!((found.len(), multiple.multiplicity), (3, 11));
    assert!((multiple.lambda - Complex::new(0.0, 1.0)).norm() <= multiple.error, "{multiple:?}");
}

/// Closed form: a point mass behind a hinge with `k_y/m = k_θ/J` has one frequency twice, sqrt(k/m), written from either end.
#[test]
fn a_double_frequency_behind_a_hinge_is_one() {
    for k in 1..=300 {
        let (mass, stiffness) = (0.01 * f64::from(k) + 0.05, 0.37 + 0.013 * f64::from(k));
        let hinge = ElasticHinge { stiffness_y: stiffness, stiffness_theta: stiffness };
        let point_mass = PointMass { mass, inertia: mass };
        let (hinge, point_mass): (Step, Step) =
            (ListStep::Element(hinge.try_into().unwrap()), ListStep::Element(point_mass.try_into().unwrap()));
        let to_fixed = [ListStep::Tip(Support::Free), point_mass, hinge, ListStep::Root(Support::Fixed)];
        let to_free = [ListStep::Tip(Support::Fixed), hinge, point_mass, ListStep::Root(Support::Free)];
        for steps in [to_fixed, to_free] {
            let found = first::<2>(&steps);
            let expected = (stiffness / mass).sqrt();
            assert!(found.len() == 1 && found[0].1 == 2, "{mass} {stiffness}: {found:?}");
            assert!((found[0].0 / expected - 1.0).abs() < 1e-14, "{mass} {stiffness}: {found:?}");
        }
    }
}
