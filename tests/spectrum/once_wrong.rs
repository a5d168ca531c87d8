//! Models that searches without a proof answered wrongly: loads and roots that coincide, counts beside buckling, rods between heavy masses.

use mstmm::element::Support;
use mstmm::elements::{AnyUndamped, Beam, Spring, TorsionSpring};
use mstmm::list::{ListStep, StepList};
use mstmm::number::DoubleDouble;
use mstmm::prelude::*;
use mstmm::search::critical_loads;
use std::f64::consts::PI;

/// π in two words.
fn pi() -> DoubleDouble {
    DoubleDouble::from(PI) + DoubleDouble::from(1.224_646_799_147_353_2e-16)
}

system! {
    /// A strut on a foundation.
    struct Strut { foundation: f64, load: f64 }
    pinned -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load, foundation_stiffness: foundation
    } -> pinned
}

/// Closed form: with a foundation of `m² n² π⁴` the strut buckles in m and in n half waves at once, under `(m² + n²) π²`.
#[test]
fn loads_that_coincide_are_one_entry_whatever_the_range() {
    for (m, n) in [(1_u32, 2_u32), (2, 3), (3, 4), (4, 5)] {
        let squares = [m, n].map(|waves| f64::from(waves * waves));
        let foundation = squares[0] * squares[1] * PI.powi(4);
        let exact = (squares[0] + squares[1]) * PI * PI;
        for range in 0..40 {
            let end = exact * (1.01 + 0.002 * f64::from(range));
            let loads = critical_loads::<8, _>(0.0..=end, |load| Strut { foundation, load }.build()).unwrap();
            // the foundation is rounded: the loads are apart by less than its rounding tells
            let total: u64 = loads.iter().map(|load| load.multiplicity).sum();
            assert_eq!(total, 2, "{m} {n} {end} {loads:?}");
            assert_eq!(loads[0].index, 1);
            for load in loads.iter() {
                assert!((load.factor / exact - 1.0).abs() < 1e-14, "{m} {n} {end} {load:?}");
            }
        }
    }
}

system! {
    /// Three cantilevers that are equal but for rounding, on springs so soft that they join nothing.
    struct Three {}
    fixed -> beam 1 { length: 0.969, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn p -> spring 2 { stiffness: 9.65e-16 } -> conn m;
    fixed -> beam 3 { length: 0.9689999999999973, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn q
        -> spring 4 { stiffness: 2.71e-15 } -> conn m;
    fixed -> beam 5 { length: 0.9689999999999996, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn r
        -> spring 6 { stiffness: 2.04e-15 } -> conn m;
    conn m -> spring 7 { stiffness: 1.0 } -> mass 8 { mass: 1.0 } -> free
}

/// Closed form: the joints move with the mass, whose own frequency is that of two springs in a row.
#[test]
fn the_search_for_cantilevers_that_nothing_joins_ends() {
    let roots = Three {}.build().unwrap().first_frequencies::<4>().unwrap();
    let total: u64 = roots.iter().map(|root| root.multiplicity).sum();
    assert!(total >= 4 && roots.iter().all(|root| root.is_proven), "{roots:?}");
    let cantilever = 3.516_015_268_500_15 / (0.969 * 0.969);
    let beams: Vec<_> = roots.iter().filter(|root| root.omega > 1.0).collect();
    assert_eq!(beams.iter().map(|root| root.multiplicity).sum::<u64>(), 3, "{roots:?}");
    assert!(beams.iter().all(|root| (root.omega / cantilever - 1.0).abs() < 1e-13), "{roots:?}");
}

system! {
    struct Column { length: f64, force: f64 }
    pinned -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force } -> pinned
}

/// Closed form: `ω² = κ² (κ² - P)` of a pinned column with `κ = π/l`, evaluated in two words.
#[test]
fn beside_buckling_intervals_hold_the_root_and_counts_agree() {
    for length in [1.03, 0.7, 1.93, 2.4] {
        for below in [0.5, 1e-2, 1e-4, 1e-8, 1e-10, 1e-12, 1e-14] {
            let force = PI * PI / (length * length) * (1.0 - below);
            let wave = pi() / DoubleDouble::from(length);
            let square = wave * wave;
            let exact = square * (square - DoubleDouble::from(force));
            let squared = |omega: f64| DoubleDouble::from(omega) * DoubleDouble::from(omega);
            let column = Column { length, force }.build().unwrap();
            let root = column.first_frequencies::<1>().unwrap()[0];
            assert!(squared(root.lower) <= exact && exact < squared(root.upper), "{length} {below} {root:?}");
            for away in [1e-15, 1e-12, 1e-9, 1e-6, 1e-5, 1e-3] {
                for (at, count) in [(root.omega * (1.0 - away), 0), (root.omega * (1.0 + away), 1)] {
                    if at < root.lower || root.upper <= at {
                        assert_eq!(column.count_below(at).unwrap(), count, "{length} {below} {at}");
                    }
                }
            }
        }
    }
}

system! {
    /// A rod on a foundation between heavy masses.
    struct HeavyRods {}
    fixed -> rod 1 { length: 1.0, axial_stiffness: 1.0, mass_per_length: 1.0 } -> mass 2 { mass: 1.79e6 }
        -> rod 3 { length: 1.0, axial_stiffness: 1.0, mass_per_length: 1.0, foundation_stiffness: 1e4 } -> mass 4 { mass: 1.79e6 } -> free
}

/// Reference: the zeros of the determinant of both masses, `(w cot w + κ coth κ - M w²)(κ coth κ - M w²) - (κ/sinh κ)²` with `κ² = 10⁴ - w²`, by fifty
/// digits.
#[test]
fn intervals_of_rods_between_heavy_masses_hold_their_roots() {
    let roots = HeavyRods {}.build().unwrap().first_frequencies::<2>().unwrap();
    let exact = [
        (0.007_474_350_917_080_321, 2.641_473_280_458_078_7e-19),
        (0.007_511_629_007_117_415, -2.153_423_663_350_331_2e-19),
    ];
    for (root, (leading, rest)) in roots.iter().zip(exact) {
        let exact = DoubleDouble::from(leading) + DoubleDouble::from(rest);
        assert!(DoubleDouble::from(root.lower) <= exact && exact < DoubleDouble::from(root.upper), "{root:?}");
        assert!(root.is_proven && root.upper - root.lower <= 2.0 * f64::EPSILON * root.omega, "{root:?}");
    }
}

/// A property: six equal beams that all but fixed joints part share their frequencies, in entries that are disjoint.
#[test]
fn entries_of_nearly_held_beams_are_disjoint() {
    let part = |part: AnyUndamped<f64>| ListStep::Element(part);
    let beam = part(Beam { length: 0.521, bending_stiffness: 1.0, mass_per_length: 1.0 }.try_into().unwrap());
    for (stiffness, turning) in [(1e18, 1e19), (1e18, 1e18), (1e14, 1e14), (1e19, 1e17)] {
        let spring = part(Spring { stiffness }.try_into().unwrap());
        let torsion = part(TorsionSpring { stiffness: turning }.try_into().unwrap());
        let mut steps = vec![ListStep::Tip(Support::Fixed), beam];
        for _ in 0..5 {
            let hold = ListStep::Tip(Support::Fixed);
            steps.extend([hold, spring, hold, torsion, ListStep::Connection(3), beam]);
        }
        steps.push(ListStep::Root(Support::Fixed));
        let list = StepList::new(&steps).unwrap();
        let roots = list.first_frequencies::<18>().unwrap();
        // cos(x) cosh(x) = 1 for clamped beams
        let clamped =
            [22.373_285_448_061, 61.672_822_867_914, 120.903_391_715_69].map(|square| square / (0.521 * 0.521));
        for omega in clamped {
            let near = roots.iter().filter(|root| (root.omega / omega - 1.0).abs() < 1e-9);
            assert_eq!(near.map(|root| root.multiplicity).sum::<u64>(), 6, "{stiffness:e} {omega} {roots:?}");
        }
        for pair in roots.windows(2) {
            assert!(pair[0].upper <= pair[1].lower, "{stiffness:e} {pair:?}");
            assert_eq!(pair[0].index + pair[0].multiplicity, pair[1].index);
        }
    }
}
