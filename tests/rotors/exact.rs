//! The whirl frequencies and critical speeds of tests/data/rotors.json, and those of ROSS beside them.
#![expect(clippy::unwrap_used, reason = "a file that is not as it should be fails the test")]

use mstmm::elements::{Disc, Spring};
use mstmm::frame::{Frame, Ground, RotorStructure, Section};
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;
use mstmm::search::{Rotor, Spinning, critical_speeds};
use serde_json::Value;

system! {
    /// Two discs on a shaft between isotropic bearings.
    pub(crate) struct Friswell { speed: f64 }
    section s0 {
        bending_stiffness: 64733.989248774065, mass_per_length: 15.334899140335178, shear_stiffness: 141308987.11622617,
        rotary_inertia: 0.002396077990677372, polar_inertia_per_length: 0.004792155981354744, speed,
    }

    free -> conn c0;
    fixed -> spring k0 { stiffness: 1000000.0 } -> conn c0;
    conn c0
        -> beam b0 { length: 0.5, ..s0 }
        -> disc d1 { mass: 32.58972765304033, inertia: 0.17808928257067663, polar_inertia: 0.32956362089137037, speed }
        -> beam b1 { length: 1.0 - 0.5, ..s0 }
        -> disc d2 { mass: 51.5252611115262, inertia: 0.4235805840543382, polar_inertia: 0.8050822048675967, speed }
        -> beam b2 { length: 1.5 - 1.0, ..s0 } -> conn c3;
    fixed -> spring k3 { stiffness: 1000000.0 } -> conn c3;
    conn c3 -> free;
}

system! {
    /// An overhung shaft of eighteen sections without shear.
    pub(crate) struct Nelson { speed: f64 }
    section s0 {
        bending_stiffness: 110.41196243181503, mass_per_length: 0.6378503113245093,
        rotary_inertia: 4.1476216493876234e-06, polar_inertia_per_length: 8.295243298775247e-06, speed,
    }
    section s1 {
        bending_stiffness: 1766.5913989090404, mass_per_length: 2.5514012452980372,
        rotary_inertia: 6.636194639020197e-05, polar_inertia_per_length: 0.00013272389278040395, speed,
    }
    section s2 {
        bending_stiffness: 544.4898567175757, mass_per_length: 1.4164642053865304,
        rotary_inertia: 2.0453743125781497e-05, polar_inertia_per_length: 4.0907486251562994e-05, speed,
    }
    section s3 {
        bending_stiffness: 27715.299510682442, mass_per_length: 10.105795263118685,
        rotary_inertia: 0.0010411242924946446, polar_inertia_per_length: 0.0020822485849892893, speed,
    }
    section s4 {
        bending_stiffness: 193549.11243450193, mass_per_length: 26.70584348452098,
        rotary_inertia: 0.0072706658886608376, polar_inertia_per_length: 0.014541331777321675, speed,
    }
    section s5 {
        bending_stiffness: 184837.2747270207, mass_per_length: 21.039986662974858,
        rotary_inertia: 0.006943405998648334, polar_inertia_per_length: 0.013886811997296668, speed,
    }
    section s6 {
        bending_stiffness: 51547.52711175943, mass_per_length: 8.051480746407648,
        rotary_inertia: 0.0019363811195110402, polar_inertia_per_length: 0.0038727622390220804, speed,
    }
    section s7 {
        bending_stiffness: 67931.35714118178, mass_per_length: 15.82143432734027,
        rotary_inertia: 0.002551839142656713, polar_inertia_per_length: 0.005103678285313426, speed,
    }
    section s8 {
        bending_stiffness: 4245.709821323861, mass_per_length: 3.9553585818350676,
        rotary_inertia: 0.00015948994641604456, polar_inertia_per_length: 0.00031897989283208913, speed,
    }
    section s9 {
        bending_stiffness: 8711.83770748121, mass_per_length: 5.665856821546122,
        rotary_inertia: 0.00032725989001250395, polar_inertia_per_length: 0.0006545197800250079, speed,
    }
    section s10 {
        bending_stiffness: 343902.4955272327, mass_per_length: 35.598227236515605,
        rotary_inertia: 0.012918685659699608, polar_inertia_per_length: 0.025837371319399217, speed,
    }
    section s11 {
        bending_stiffness: 19003.461803201233, mass_per_length: 4.439938441572563,
        rotary_inertia: 0.0007138644024821406, polar_inertia_per_length: 0.0014277288049642813, speed,
    }

    free
        -> beam b0 { length: 0.0127, ..s0 }
        -> beam b1 { length: 0.0508 - 0.0127, ..s1 }
        -> beam b2 { length: 0.0762 - 0.0508, ..s2 }
        -> beam b3 { length: 0.0889 - 0.0762, ..s3 }
        -> disc d4 { mass: 1.401, inertia: 0.00136, polar_inertia: 0.002, speed }
        -> beam b4 { length: 0.1016 - 0.0889, ..s3 }
        -> beam b5 { length: 0.1067 - 0.1016, ..s4 }
        -> beam b6 { length: 0.1143 - 0.1067, ..s5 }
        -> beam b7 { length: 0.127 - 0.1143, ..s6 }
        -> beam b8 { length: 0.1346 - 0.127, ..s7 }
        -> beam b9 { length: 0.16510000000000002 - 0.1346, ..s8 } -> conn c10;
    fixed -> spring k10 { stiffness: 43780000.0 } -> conn c10;
    conn c10
        -> beam b10 { length: 0.1905 - 0.16510000000000002, ..s8 }
        -> beam b11 { length: 0.2286 - 0.1905, ..s9 }
        -> beam b12 { length: 0.2667 - 0.2286, ..s9 }
        -> beam b13 { length: 0.287 - 0.2667, ..s8 } -> conn c14;
    fixed -> spring k14 { stiffness: 43780000.0 } -> conn c14;
    conn c14
        -> beam b14 { length: 0.3048 - 0.287, ..s8 }
        -> beam b15 { length: 0.315 - 0.3048, ..s10 }
        -> beam b16 { length: 0.3454 - 0.315, ..s3 }
        -> beam b17 { length: 0.355 - 0.3454, ..s11 } -> free;
}

/// Widest interval, in units of eps.
const WIDEST: f64 = 16.0;

/// The case of a name.
fn case(name: &str) -> Value {
    let file: Value = serde_json::from_str(include_str!("../data/rotors.json")).unwrap();
    file[name].clone()
}

/// Numbers of 22 digits.
fn numbers(list: &Value) -> Vec<DoubleDouble> {
    list.as_array().unwrap().iter().map(|number| number.as_str().unwrap().parse().unwrap()).collect()
}

/// Whether a number of 22 digits lies in an interval of a few eps, with so many eps of room.
fn lies_in(exact: DoubleDouble, [lower, upper]: [f64; 2], room: f64) -> bool {
    let is_narrow = upper - lower <= WIDEST * f64::EPSILON * upper;
    let room = room * f64::EPSILON * upper;
    is_narrow && DoubleDouble::from_sum(lower, -room) <= exact && exact <= DoubleDouble::from_sum(upper, room)
}

/// Holds the frequencies of both whirls at all speeds of a case, and its critical speeds, to the file, with eps of what a sketch rounds of its numbers.
fn check<Y: Undamped<Parameter = f64> + Spinning>(case: &Value, room: f64, build: impl Fn(f64) -> Rotor<Y>) -> usize {
    let mut compared = 0;
    for at in case["at"].as_array().unwrap() {
        let rotor = build(at["speed"].as_f64().unwrap());
        for (whirl, name) in [(Whirl::Forward, "forward"), (Whirl::Backward, "backward")] {
            let found = rotor.whirl(whirl).first_frequencies::<4>().unwrap();
            for ((index, exact), own) in (1..).zip(numbers(&at[name])).zip(found.iter()) {
                assert!(
                    own.is_proven && own.index == index && lies_in(exact, [own.lower, own.upper], room),
                    "{name} {exact}: {own:?}"
                );
                compared += 1;
            }
        }
    }
    for (whirl, name) in [(Whirl::Forward, "critical_forward"), (Whirl::Backward, "critical_backward")] {
        let exact = numbers(&case[name]);
        let end = exact[2].to_f64() * 1.01;
        let found = critical_speeds::<8, _>(0.01 * end..=end, whirl, 1.0, |speed| Ok(build(speed))).unwrap();
        assert_eq!(found.len(), exact.len(), "{found:?}");
        for ((index, exact), own) in (1..).zip(exact).zip(found.iter()) {
            assert!(
                own.is_proven && own.index == index && lies_in(exact, [own.lower, own.upper], room),
                "{name} {exact}: {own:?}"
            );
            compared += 1;
        }
    }
    compared
}

/// Oracle: counts in 77 digits, bisected to 22, and for this rotor exponentials of its equations.
#[test]
fn two_discs_on_a_shaft_have_their_frequencies_and_critical_speeds() {
    assert_eq!(check(&case("friswell_5_9_1"), 0.0, |speed| Friswell { speed }.build().unwrap()), 16 + 6);
}

/// Oracle: counts in 77 digits, bisected to 22. A length is the difference of two stations, of which `f64` rounds one.
#[test]
fn a_shaft_of_many_steps_has_its_frequencies_and_critical_speeds() {
    assert_eq!(check(&case("nelson_mcvaugh"), 0.5, |speed| Nelson { speed }.build().unwrap()), 12 + 6);
}

/// The rotor of a case at run time, at a speed.
fn frame_of(case: &Value, speed: f64) -> Rotor<RotorStructure> {
    let list = |name: &str| case[name].as_array().unwrap().clone();
    let mut frame = Frame::new();
    let points: Vec<_> = list("x").iter().map(|x| frame.point(x.as_f64().unwrap())).collect();
    for (ends, member) in points.windows(2).zip(list("members")) {
        let [ei, m, kga, r, rp] = [0, 1, 2, 3, 4].map(|place| member[place].as_f64());
        let section = Section::new().bending_stiffness(ei.unwrap()).mass_per_length(m.unwrap());
        let section = kga.map_or(section, |kga| section.shear_stiffness(kga));
        let section = section.rotary_inertia(r.unwrap()).polar_inertia_per_length(rp.unwrap()).speed(speed);
        frame.member(ends[0], ends[1], section);
    }
    let at = |part: &Value| points[usize::try_from(part[0].as_u64().unwrap()).unwrap()];
    for disc in list("discs") {
        let [mass, inertia, polar_inertia] = [1, 2, 3].map(|place| disc[place].as_f64().unwrap());
        frame.body([at(&disc)], Disc { mass, inertia, polar_inertia, speed });
    }
    for bearing in list("bearings") {
        frame.member(at(&bearing), Ground, Spring { stiffness: bearing[1].as_f64().unwrap() });
    }
    frame.build_rotor().unwrap()
}

/// Rotors whose topology and numbers are read from the file have its values, too: lengths are differences of places, which proofs have exactly.
#[test]
fn rotors_from_a_file_have_its_frequencies_and_critical_speeds() {
    for (name, values) in [("friswell_5_9_1", 16 + 6), ("nelson_mcvaugh", 12 + 6)] {
        let case = case(name);
        assert_eq!(check(&case, 0.0, |speed| frame_of(&case, speed)), values);
    }
}

/// What six elements of ROSS have at 4000 rpm, beside the intervals: their digits are not the exact ones.
#[test]
fn six_finite_elements_are_above_the_exact_values() {
    let of_elements = [85.389467, 87.7958637, 251.78460413, 294.71333087, 600.17936195, 827.07536193];
    let rotor = Friswell { speed: 4000.0 * core::f64::consts::TAU / 60.0 }.build().unwrap();
    let lists = [Whirl::Forward, Whirl::Backward].map(|whirl| rotor.whirl(whirl).first_frequencies::<3>().unwrap());
    let mut exact: Vec<f64> = lists.iter().flat_map(|list| list.iter().map(|root| root.omega)).collect();
    exact.sort_by(f64::total_cmp);
    for (exact, of_elements) in exact.into_iter().zip(of_elements) {
        let error = of_elements / exact - 1.0;
        println!("exact {exact:.10}, six elements {of_elements:.8}: {error:.1e} above");
        assert!((1e-6..6e-4).contains(&error), "{error:e}");
    }
}
