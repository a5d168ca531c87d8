//! The oracle obeys laws on structures whose frequencies are unknown, and agrees with finite elements and closed forms.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::equivalents::{in_halves, reversed, turned};
use crate::families::random::Spread;
use crate::families::{Named, named_structures, random_structures};
use crate::finite_elements::{ELEMENTS, FiniteElements};
use crate::oracle::Oracle;
use crate::structure::{Element, Freedoms, Node, Section, Structure};
use crate::support::random_tree::Random;
use mstmm::number::{DoubleDouble, Parameter};

/// Named structures and random ones.
fn structures(seeds: u64) -> impl Iterator<Item = Named> {
    named_structures()
        .into_iter()
        .chain(random_structures(0..seeds, Spread::Moderate))
        .chain(random_structures(0..seeds, Spread::Stiff))
}

/// Frequencies of all sizes.
fn frequencies(random: &mut Random) -> impl Iterator<Item = DoubleDouble> {
    (0..4).map(|_| DoubleDouble::from(10f64.powf(7.0 * random.unit() - 3.0)))
}

/// The counts of two ways of writing a structure are the same wherever both are sure, which is nearly everywhere.
fn compare(seeds: u64, other: impl Fn(&Structure) -> Structure) {
    let random = &mut Random(7);
    let (mut compared, mut unsure) = (0, 0);
    for (name, structure) in structures(seeds) {
        let [oracle, other] = [Oracle::of(&structure), Oracle::of(&other(&structure))];
        for omega in frequencies(random) {
            match (oracle.count_below(omega), other.count_below(omega)) {
                (Some(count), Some(other)) => assert_eq!(count, other, "{name} below {omega}\n{structure:?}"),
                _ => unsure += 1,
            }
            compared += 1;
        }
    }
    assert!(100 * unsure <= compared, "{unsure} of {compared}");
}

#[test]
fn halves_of_members_count_as_the_whole() {
    compare(25, in_halves);
}

#[test]
fn turned_structures_count_the_same() {
    compare(25, turned);
}

#[test]
fn order_and_direction_of_members_do_not_count() {
    compare(25, reversed);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_structures_count_the_same_however_they_are_written() {
    compare(300, in_halves);
    compare(300, turned);
    compare(300, reversed);
}

/// Forces as unknowns count the same as stiffnesses.
#[test]
fn both_forms_count_the_same() {
    let random = &mut Random(11);
    let mut compared = 0;
    for (name, structure) in structures(25) {
        let oracle = Oracle::of(&structure);
        for omega in frequencies(random) {
            if let [Some(count), Some(other)] = oracle.counts(omega) {
                assert_eq!(count, other, "{name} below {omega}\n{structure:?}");
                compared += 1;
            }
        }
    }
    assert!(compared > 250, "{compared}");
}

/// Relative error from which on a frequency of finite elements is not compared.
const COARSE: f64 = 0.05;

/// Relative rounding of a frequency of finite elements.
const ROUNDING: f64 = 1e-6;

/// Frequency of finite elements below which rounding may have made it of a rigid motion.
const AT_REST: f64 = 1e-3;

/// Bound of the relative error of a frequency of finite elements: that of the member with the most waves.
fn error(structure: &Structure, omega: f64) -> f64 {
    let of_member = |element: &Element, length: f64| {
        let Element::Beam(Section { axial_stiffness, bending_stiffness, mass_per_length }) = element else {
            return 0.0;
        };
        let piece = length / ELEMENTS as f64;
        let axial = omega * piece * (mass_per_length / axial_stiffness).sqrt();
        let bending = omega * piece * piece * (mass_per_length / bending_stiffness).sqrt();
        axial * axial / 12.0 + bending * bending / 240.0
    };
    let members = structure.members.iter().map(|member| {
        let [from, to] = member.ends.map(|end| structure.position(&end));
        of_member(&member.element, (to[0] - from[0]).hypot(to[1] - from[1]))
    });
    members.fold(ROUNDING, f64::max)
}

/// Exact frequencies are below those of finite elements with the same number, and not far below.
fn compare_with_finite_elements(seeds: core::ops::Range<u64>) -> usize {
    let (mut compared, mut rigid) = (0, 0);
    for (name, structure) in random_structures(seeds, Spread::Moderate) {
        let oracle = Oracle::of(&structure);
        let found = FiniteElements::of(&structure).frequencies().unwrap();
        for (below, &omega) in (0..).zip(&found) {
            let error = error(&structure, omega);
            if error > COARSE {
                break;
            }
            if omega < AT_REST {
                rigid += 1;
                continue;
            }
            let count = |omega: f64| oracle.count_below(DoubleDouble::from(omega)).unwrap();
            let (lower, upper) = (count(omega * (1.0 - error)), count(omega * (1.0 + ROUNDING)));
            let is_between = lower <= below && below < upper;
            assert!(is_between, "{name}: {lower} to {upper} at {omega}, not {below}, to {error:e}\n{structure:?}");
            compared += 1;
        }
    }
    assert!(rigid > 0, "none moves as a whole");
    compared
}

#[test]
fn counts_are_those_of_finite_elements() {
    let compared = compare_with_finite_elements(0..20);
    assert!(compared > 60, "{compared}");
}

#[test]
#[ignore = "long: .ci/long"]
fn counts_of_many_structures_are_those_of_finite_elements() {
    let compared = compare_with_finite_elements(20..520);
    assert!(compared > 1500, "{compared}");
}

/// Closed forms: `tan(ωl/c) = 0` of a free rod, `ω² = k/m` of a mass on a spring at an angle.
#[test]
fn closed_forms_are_met() {
    let mut rod = Structure::default();
    let ends = [[0.0, 0.0], [3.0, 4.0]].map(|place| rod.node(Node::at(place).along([3.0, 4.0]).held(Freedoms::RZ)));
    rod.beam(ends[0], ends[1], Section { axial_stiffness: 4.0, bending_stiffness: 1e9, mass_per_length: 1.0 });
    let pi: DoubleDouble = "3.14159265358979323846264338327950288".parse().unwrap();
    for n in 1..5 {
        // one is the rigid motion; c = 2, l = 5
        let expected = pi * DoubleDouble::from(2.0 * f64::from(n)) / DoubleDouble::from(5.0);
        let error = (Oracle::of(&rod).frequency(n as u64 + 1) / expected).to_f64() - 1.0;
        assert!(error.abs() < 1e-15, "{n}: {error:e}");
    }
    let mut mass = Structure::default();
    let body = mass.node(Node::at([0.0, 0.0]).along([1.0, 0.0]).body(2.0, 0.5, [0.0, 0.0]));
    let ground = mass.clamp([3.0, 4.0]);
    mass.spring(body, ground, 50.0);
    mass.torsion_spring(body, ground, 8.0);
    let oracle = Oracle::of(&mass);
    // 50 · 0.36/2 and 8/0.5
    for (n, square) in [(1, 9.0), (2, 16.0)] {
        let omega = oracle.frequency(n);
        let error = (omega * omega / DoubleDouble::from(square)).to_f64() - 1.0;
        assert!(error.abs() < 1e-15, "{n}: {error:e}");
    }
}
