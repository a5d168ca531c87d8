//! Mantissas and exponents of Δ: random trees in other units, with beams in pieces, and at zeros that are exact.
#![expect(clippy::unwrap_used, reason = "the trees here are valid")]

use crate::support::list_of_tree::any_steps;
use crate::support::random_tree::{Random, random_tree};
use crate::support::tree::{Part, Tree};
use mstmm::element::{Support, WittrickWilliams};
use mstmm::elements::{
    Beam, Body, Damper, ElasticHinge, Inertia, Mass, PointMass, RotationalHinge, ShearHinge, Spring, SpringDamper,
    TorsionDamper, TorsionSpring, TorsionSpringDamper,
};
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::number::Scaled;
use mstmm::prelude::*;
use mstmm::search::SearchError;

type C = Complex<f64>;

fn delta(tree: &Tree, lambda: C) -> Scaled<C> {
    let steps = any_steps(tree);
    StepList::new(&steps).unwrap().characteristic(lambda)
}

/// A part in a unit of force and mass that is smaller by `unit`.
fn in_unit(part: Part, unit: f64) -> Part {
    let of_spring = |stiffness: f64, damping: f64| (unit * stiffness, unit * damping);
    match part {
        Part::Beam(b) => Part::Beam(Beam {
            bending_stiffness: unit * b.bending_stiffness,
            mass_per_length: unit * b.mass_per_length,
            ..b
        }),
        Part::Body(b) => Part::Body(Body { mass: unit * b.mass, inertia: unit * b.inertia, ..b }),
        Part::ElasticHinge(h) => Part::ElasticHinge(ElasticHinge {
            stiffness_y: unit * h.stiffness_y,
            stiffness_theta: unit * h.stiffness_theta,
        }),
        Part::RotationalHinge(h) => Part::RotationalHinge(RotationalHinge { stiffness: unit * h.stiffness }),
        Part::ShearHinge(h) => Part::ShearHinge(ShearHinge { stiffness: unit * h.stiffness }),
        Part::Lever(_) => part,
        Part::PointMass(p) => Part::PointMass(PointMass { mass: unit * p.mass, inertia: unit * p.inertia }),
        Part::Spring(s) => Part::Spring(Spring { stiffness: unit * s.stiffness }),
        Part::TorsionSpring(s) => Part::TorsionSpring(TorsionSpring { stiffness: unit * s.stiffness }),
        Part::Mass(p) => Part::Mass(Mass { mass: unit * p.mass }),
        Part::Inertia(p) => Part::Inertia(Inertia { inertia: unit * p.inertia }),
        Part::Damper(d) => Part::Damper(Damper { damping: unit * d.damping }),
        Part::TorsionDamper(d) => Part::TorsionDamper(TorsionDamper { damping: unit * d.damping }),
        Part::SpringDamper(s) => {
            let (stiffness, damping) = of_spring(s.stiffness, s.damping);
            Part::SpringDamper(SpringDamper { stiffness, damping })
        }
        Part::TorsionSpringDamper(s) => {
            let (stiffness, damping) = of_spring(s.stiffness, s.damping);
            Part::TorsionSpringDamper(TorsionSpringDamper { stiffness, damping })
        }
    }
}

/// A tree with each element replaced by others in a row.
fn replaced(tree: &Tree, parts: impl Fn(Part) -> Vec<Part>) -> Tree {
    let steps = tree.iter().flat_map(|step| match *step {
        ListStep::Element(part) => parts(part).into_iter().map(ListStep::Element).collect(),
        other => vec![other],
    });
    steps.collect()
}

/// Δ is homogeneous in the unit of force and mass, and powers of two are exact: the mantissa keeps every bit, the
/// exponent grows by one and the same number for each power of two, however far from one that leads.
#[test]
fn the_unit_of_force_changes_the_exponent_alone() {
    for seed in 0..300 {
        let tree = random_tree(seed, 4, true);
        let in_units = |power: i32| replaced(&tree, |part| vec![in_unit(part, 2f64.powi(power))]);
        let mut random = Random(seed);
        let mut degree = None;
        for _ in 0..3 {
            let lambda = C::new(random.unit() - 0.5, 4.0 * random.unit() + 0.1);
            let [own, one, many, few] = [0, 1, 150, -150].map(|power| delta(&in_units(power), lambda));
            if own.mantissa() == C::ZERO {
                continue; // a displacement that is held twice
            }
            let degree = *degree.get_or_insert(one.exponent() - own.exponent());
            for (power, other) in [(1, one), (150, many), (-150, few)] {
                assert_eq!(other.mantissa(), own.mantissa(), "seed {seed}: {tree:?}");
                assert_eq!(other.exponent() - own.exponent(), power * degree, "seed {seed}: {tree:?}");
            }
        }
    }
}

/// A beam is the same in one piece and in 64, short enough that no exponent is taken out; up to `z = βl` of 400.
#[test]
fn a_beam_in_pieces_has_the_same_characteristic() {
    for (tip, root) in [
        (Support::Fixed, Support::Free),
        (Support::Free, Support::Fixed),
        (Support::Pinned, Support::Guided),
        (Support::Guided, Support::Pinned),
    ] {
        for z in [3.0, 30.0, 90.0, 110.0, 400.0] {
            let beam = |length: f64| Part::Beam(Beam { length, bending_stiffness: 1.0, mass_per_length: 1.0 });
            // the first and the last step have formulas of their own
            let whole = vec![
                ListStep::Tip(tip),
                ListStep::Element(beam(1.0)),
                ListStep::Element(beam(1.0)),
                ListStep::Element(beam(1.0)),
                ListStep::Root(root),
            ];
            let pieces = replaced(&whole, |_| vec![beam(1.0 / 64.0); 64]);
            let lambda = C::new(-0.2 * z, z * z);
            let (whole, pieces) = (delta(&whole, lambda), delta(&pieces, lambda));
            let exponent = pieces.exponent() - whole.exponent();
            let ratio = Scaled::new(pieces.mantissa() / whole.mantissa(), exponent).value();
            // each of 192 steps has about ten roundings, and the argument z of an exponential carries half an eps
            let bound = (10.0 * 192.0 + 3.0 * z) * f64::EPSILON;
            assert!((ratio - 1.0).norm() < bound, "{tip:?}, {root:?} at {z}: {ratio}");
        }
    }
}

fn count(steps: &[ListStep<AnyUndamped<f64>>], omega: f64) -> u64 {
    let mut count = WittrickWilliams::<f64>::default();
    StepList::new(steps).unwrap().pass(omega, &mut count);
    count.below()
}

fn hinge(stiffness: f64) -> ListStep<AnyUndamped<f64>> {
    ListStep::Element(ElasticHinge { stiffness_y: 4.0, stiffness_theta: stiffness }.try_into().unwrap())
}

fn point_mass(mass: f64, inertia: f64) -> ListStep<AnyUndamped<f64>> {
    ListStep::Element(PointMass { mass, inertia }.try_into().unwrap())
}

/// Closed form of a spring and a mass, ω = 2 without rounding: a frequency is not below itself.
#[test]
fn a_frequency_of_a_line_is_not_below_itself() {
    let spring = ListStep::Element(Spring { stiffness: 4.0 }.try_into().unwrap());
    let mass = ListStep::Element(Mass { mass: 1.0 }.try_into().unwrap());
    let steps = [ListStep::Tip(Support::Fixed), spring, mass, ListStep::Root(Support::Free)];
    assert_eq!([1.9, 2.0, 2.1].map(|omega| count(&steps, omega)), [0, 0, 1]);
    // a mass on the fixed tip does not move
    let steps = [ListStep::Tip(Support::Fixed), mass, spring, mass, ListStep::Root(Support::Free)];
    assert_eq!([1.9, 2.0, 2.1].map(|omega| count(&steps, omega)), [0, 0, 1]);
}

/// Closed form of a point mass on a hinge: ω² = 4/m and 4/J, without rounding at ω = 2.
#[test]
fn a_frequency_at_a_free_root_is_not_below_itself() {
    for (mass, inertia, expected) in [(1.0, 1.0, 0), (1.0, 2.0, 1), (2.0, 1.0, 1), (1.0, 0.5, 0), (0.5, 1.0, 0)] {
        let steps =
            [ListStep::Tip(Support::Fixed), hinge(4.0), point_mass(mass, inertia), ListStep::Root(Support::Free)];
        assert_eq!(count(&steps, 2.0), expected, "mass {mass}, inertia {inertia}");
    }
}

/// Closed form of two inertias on torsion springs of 2 and 1: `[[3 - ω², -1], [-1, 1 - ω²/2]]` has ω = 1 and 2.
#[test]
fn a_frequency_at_a_pinned_root_is_not_below_itself() {
    let fixed = ListStep::Tip(Support::Fixed);
    let pinned = ListStep::Root(Support::Pinned);
    let steps = [fixed, hinge(2.0), point_mass(0.0, 1.0), hinge(1.0), point_mass(0.0, 0.5), pinned];
    assert_eq!([0.9, 1.0, 1.1, 2.0, 2.1].map(|omega| count(&steps, omega)), [0, 0, 1, 1, 2]);
}

/// Closed form of one mass at a guided root, ω² = 4/m, without rounding at ω = 2; and of two, with
/// `(8 - 12ω²)(4 - 3ω²) = 16`, on both sides of each.
#[test]
fn a_frequency_at_a_guided_root_is_not_below_itself() {
    let fixed = ListStep::Tip(Support::Fixed);
    let guided = ListStep::Root(Support::Guided);
    let steps = [fixed, hinge(1.0), point_mass(1.0, 0.0), guided];
    assert_eq!([1.9, 2.0, 2.1].map(|omega| count(&steps, omega)), [0, 0, 1]);
    let two = [fixed, hinge(1.0), point_mass(12.0, 0.0), hinge(1.0), point_mass(3.0, 0.0), guided];
    let root = |sign: f64| (1.0 + sign * 5f64.sqrt() / 3.0).sqrt();
    let (low, high) = (root(-1.0), root(1.0));
    assert_eq!([0.99 * low, 1.01 * low, 0.99 * high, 1.01 * high].map(|omega| count(&two, omega)), [0, 1, 1, 2]);
}

/// So many cantilevers with their ends at one point, joined there at once or, at one connection after another, in a row.
fn arms(count: usize, arm: Beam<f64>, in_a_row: bool) -> Vec<ListStep<AnyUndamped<f64>>> {
    let mut steps = Vec::new();
    for index in 0..count {
        steps.extend([ListStep::Tip(Support::Fixed), ListStep::Element(arm.try_into().unwrap())]);
        if in_a_row && index > 0 {
            steps.push(ListStep::Connection(2));
        }
    }
    steps.extend((!in_a_row).then_some(ListStep::Connection(count)));
    steps.push(ListStep::Root(Support::Free));
    steps
}

/// Closed form: one frequency of a cantilever, `z = 1.875..`, and all others but one of each clamped beam's.
#[test]
fn a_sum_may_enter_another_sum_whatever_the_units() {
    for (ei, m) in [(1.0, 1.0), (2e7, 80.0), (1e-20, 1e-20), (1e12, 1e5)] {
        let arm = Beam { length: 1.0, bending_stiffness: ei, mass_per_length: m };
        for count in [2, 8, 16] {
            let found = [false, true].map(|in_a_row| {
                let steps = arms(count, arm, in_a_row);
                let found = StepList::new(&steps).unwrap().first_frequencies::<17>().unwrap();
                found.iter().map(|root| (root.omega, root.multiplicity)).collect::<Vec<_>>()
            });
            let cantilever = 1.875_104_068_711_961_2_f64.powi(2) * f64::sqrt(ei / m);
            assert!((found[0][0].0 / cantilever - 1.0).abs() < 1e-14, "{:?}", found[0]);
            for ((a, multiplicity), (b, other)) in found[0].iter().zip(&found[1]) {
                assert!(multiplicity == other && (a / b - 1.0).abs() < 1e-14, "{count} {ei}: {found:?}");
            }
        }
    }
}

/// Two arms on hinges that are beyond all stiffness of the arms: right, or refused.
#[test]
fn hinges_of_any_stiffness_are_clamps_or_an_error() {
    for (k, ei) in [(1e40, 1e-40), (1e50, 1e-30), (1e70, 1e-10), (1e60, 1.0), (1e100, 1.0), (1e150, 1.0), (1e40, 1e40)]
    {
        let hinge = ElasticHinge { stiffness_y: k, stiffness_theta: k };
        let beam = Beam { length: 1.0, bending_stiffness: ei, mass_per_length: ei };
        let (hinge, beam): (AnyUndamped<f64>, AnyUndamped<f64>) = (hinge.try_into().unwrap(), beam.try_into().unwrap());
        let arm = [ListStep::Tip(Support::Fixed), ListStep::Element(hinge), ListStep::Element(beam)];
        let steps = [&arm[..], &arm, &[ListStep::Connection(2), ListStep::Root(Support::Free)]].concat();
        match StepList::new(&steps).unwrap().first_frequencies::<2>() {
            Err(error) => assert!(matches!(error, SearchError::NotANumber { .. }), "{k:e}: {error}"),
            Ok(found) if k > 1e12 * ei => {
                assert!((found[0].omega / 3.516_015_268_500_152 - 1.0).abs() < 1e-11, "{k:e}: {}", found[0]);
            }
            Ok(_) => {}
        }
    }
}

/// Arms with their ends at one point, joined at one connection after another.
macro_rules! arms_in_a_row {
    ($($arm:ident at $point:ident from $before:ident;)*) => {
        system! {
            struct ArmsInARow { ei: f64 }
            fixed -> beam arm { length: 1.0, bending_stiffness: ei, mass_per_length: ei } -> conn a;
            fixed -> beam other { length: 1.0, bending_stiffness: ei, mass_per_length: ei } -> conn a;
            $(fixed -> beam $arm { length: 1.0, bending_stiffness: ei, mass_per_length: ei } -> conn $point;)*
            $(conn $before -> conn $point;)*
            conn h -> free
        }
    };
}
arms_in_a_row! {
    arm_b at b from a; arm_c at c from b; arm_d at d from c; arm_e at e from d; arm_f at f from e; arm_g at g from f; arm_h at h from g;
}

/// Closed form: nine arms in unison are one cantilever, whatever the unit of force; the rest are clamped beams.
#[test]
fn the_macro_looks_at_the_range_of_sums_of_sums() {
    for ei in [1.0, 1e-20, 1e-30, 1e12] {
        let found = ArmsInARow { ei }.build().unwrap().first_frequencies::<8>().unwrap();
        assert!((found[0].omega / 3.516_015_268_500_152 - 1.0).abs() < 1e-14, "{ei:e}: {}", found[0]);
        assert_eq!((found[0].multiplicity, found.len()), (1, 3), "{ei:e}");
    }
}
