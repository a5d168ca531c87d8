//! How many frequencies are proven between neighbouring numbers, and how many need more: cases with exact values, random models.
//!
//! `cargo test --release --test spectrum shares -- --ignored --nocapture` prints a row for each; those of directed families are printed
//! where these are judged.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a failing helper fails the test that called it")]

#[allow(dead_code, reason = "more of it is for the tests of the paper")]
#[path = "../paper/validation/cases.rs"]
mod cases;

use crate::support::models;
use crate::support::random_tree::Random;
use crate::support::shares::Shares;
use cases::Case;
use mstmm::number::{DoubleDouble, Parameter, Scalar};
use mstmm::prelude::*;
use mstmm::search::{System, Undamped};
use serde_json::Value;

system! {
    #[derive(Debug)]
    struct Spans { first: f64, second: f64, stiff: f64, soft: f64, line: f64, spring: f64, mass: f64 }
    pinned -> beam 1 { length: first, bending_stiffness: stiff, mass_per_length: 1.0 } -> conn 2
        -> beam 3 { length: second, bending_stiffness: soft, mass_per_length: line }
        -> body 5 { mass, inertia_about_input: mass, output_x: 0.3, centre_x: 0.1 } -> free;
    conn 2 <- spring 4 { stiffness: spring } <- fixed
}

system! {
    #[derive(Debug)]
    struct Portal { stiff: f64, soft: f64, line: f64, ea: f64, brace: f64 }
    fixed at (0.0, 0.0)
        -> beam 1 { bending_stiffness: stiff, mass_per_length: line, axial_stiffness: ea } -> conn b at (0.0, 1.0)
        -> beam 2 { bending_stiffness: soft, mass_per_length: 1.0, axial_stiffness: ea } -> conn c at (2.0, 1.0)
        -> beam 3 { bending_stiffness: 1.0, mass_per_length: 1.0, axial_stiffness: ea } -> fixed at (2.0, 0.0);
    conn b -> spring 4 { stiffness: brace } -> fixed at (2.0, 0.0)
}

/// A property: no model is refused, and of parameters in 1e±4 all frequencies are proven between neighbouring numbers.
fn random_models(models: usize, widest: &[f64]) {
    Shares::head("model");
    let mut random = Random(1);
    for &powers in widest {
        let mut next = || 10.0_f64.powf(powers * (2.0 * random.unit() - 1.0));
        let (mut spans, mut portals) = (Shares::default(), Shares::default());
        for _ in 0..models {
            let (first, second) = (next().powf(0.1), next().powf(0.1));
            let (stiff, soft, line, spring, mass) = (next(), next(), next(), next(), next());
            let model = Spans { first, second, stiff, soft, line, spring, mass };
            spans.search(&model.build().unwrap().first_frequencies::<6>(), &|| format!("{model:?}"));
            let model = Portal { stiff, soft, line, ea: next(), brace: spring };
            portals.search(&model.build().unwrap().first_frequencies::<6>(), &|| format!("{model:?}"));
        }
        for (name, shares) in [("spans", &spans), ("portal", &portals)] {
            shares.show(&format!("{name}, 1e±{powers}"));
            shares.all_proven(name);
            assert!(shares.entries >= 6 * models * 99 / 100);
        }
        spans.and(&portals);
        assert!(powers > 4.0 || spans.widths[0] * 1000 >= spans.entries * 999, "{spans:?}");
    }
}

#[test]
fn usual_frequencies_are_proven_between_neighbouring_numbers() {
    random_models(30, &[1.0, 4.0]);
}

#[test]
#[ignore = "long: .ci/long"]
fn shares_of_intervals() {
    random_models(500, &[1.0, 4.0, 6.0, 8.0]);
}

/// Half a unit in the last place of a parameter.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Whether the exact frequency is in an interval, moved by what the rounding of parameters moves it by: by no more than so many times their own.
fn holds(root: &NaturalFrequency, exact: DoubleDouble, condition: f64) -> bool {
    let room = DoubleDouble::from(root.omega * condition * ROUNDING);
    let [lower, upper] = [root.lower, root.upper].map(DoubleDouble::from);
    lower - room <= exact && exact <= upper + room
}

/// The entry of a mode, of a search beside it.
fn mode(
    system: &(impl System<Parameter = f64> + Undamped),
    index: u64,
    near: f64,
    shares: &mut Shares,
    name: &dyn Fn() -> String,
) -> NaturalFrequency {
    let found = system.natural_frequencies::<64>(near * 0.999..=near * 1.001);
    shares.search(&found, name);
    let found = found.unwrap();
    let holds = |root: &&NaturalFrequency| root.index <= index && index < root.index + root.multiplicity;
    *found.iter().find(holds).unwrap_or_else(|| panic!("{}: mode {index} is not near {near}", name()))
}

/// All cases of validation.json, each mode to its 18 digits.
fn validation(shares: &mut Shares) {
    let file: Value = serde_json::from_str(include_str!("../data/validation.json")).unwrap();
    for case in file["cases"].as_array().unwrap() {
        let id = case["id"].as_str().unwrap();
        let Some(model) = Case::of(id) else { continue };
        let system = model.build(&model.parameters);
        let listed: Vec<(u64, &Value)> = match case["omega"].as_array() {
            Some(all) => (1..).zip(all).collect(),
            None => {
                let pairs = case["omega_by_mode"].as_array().unwrap();
                pairs.iter().map(|pair| (pair[0].as_u64().unwrap(), &pair[1])).collect()
            }
        };
        for (index, text) in listed {
            let exact: DoubleDouble = text.as_str().unwrap().parse().unwrap();
            if exact.to_f64() > 0.0 {
                let root = mode(&system, index, exact.to_f64(), shares, &|| format!("{id}, mode {index}"));
                // parameters of one decimal are rounded; the last digit of the reference is 1e-18 of it
                let condition =
                    if model.parameters.iter().all(|value| (value * 1024.0).fract() == 0.0) { 0.05 } else { 8.0 };
                assert!(holds(&root, exact, condition), "{id}, mode {index}: {root:?} {exact}");
            }
        }
    }
}

/// `βl` of a bare cantilever.
const BARE: &str = "1.875104068711961166445308241078214162570";

/// The exact frequencies of an example of the paper, from what the first column of its table lists.
fn of_paper(id: &str, unit: DoubleDouble) -> Vec<DoubleDouble> {
    let file: Value = serde_json::from_str(include_str!("../data/paper.json")).unwrap();
    let example = file["examples"].as_array().unwrap().iter().find(|example| example["id"] == id).unwrap();
    let column = &example["values"][0];
    let quantity = column["quantity"].as_str().unwrap();
    let exact =
        column["exact"].as_array().unwrap().iter().map(|text| text.as_str().unwrap().parse::<DoubleDouble>().unwrap());
    let bare: DoubleDouble = BARE.parse().unwrap();
    let of_value = |value: DoubleDouble| match quantity.split(',').next() {
        Some("sqrt(Omega)") => value * value * unit,
        Some("Omega") => value * unit,
        Some("omega [rad/s]") => value,
        Some("omega/omega_1B") => value * bare * bare * unit,
        _ => panic!("{quantity} of {id}"),
    };
    exact.map(of_value).collect()
}

/// The undamped examples of the paper, with all frequencies that it lists.
fn paper(shares: &mut Shares) {
    macro_rules! example {
        ($id:literal, $model:expr) => {{
            let model = $model;
            let [length, stiffness, mass] =
                [model.length, model.bending_stiffness, model.mass_per_length].map(DoubleDouble::from);
            let unit = (stiffness / mass).sqrt() / (length * length);
            let system = model.build().unwrap();
            let exact = of_paper($id, unit);
            for exact in &exact {
                let near = exact.to_f64();
                let index = system.count_below(near * (1.0 - 1e-9)).unwrap() + 1;
                let root = mode(&system, index, near, shares, &|| $id.to_owned());
                assert!(holds(&root, *exact, 8.0), "{}: {root:?} {exact}", $id);
            }
            let first = system.first_frequencies::<10>();
            shares.search(&first, &|| $id.to_owned());
            println!("  {}: {} exact", $id, exact.len());
        }};
    }
    example!("4.1a", models::light_tip_body());
    example!("4.1b", models::heavy_tip_body());
    example!("4.2", models::restrained_beam());
    example!("4.3", models::spring_and_mass());
    example!("4.4", models::two_spans());
}

system! {
    struct Timoshenko { length: f64, ei: f64, ga: f64, m: f64, r: f64 }
    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m, shear_stiffness: ga, rotary_inertia: r } -> free
}

system! {
    struct Strut { length: f64, ei: f64, m: f64, force: f64, k: f64 }
    pinned -> beam 1 { length, bending_stiffness: ei, mass_per_length: m, axial_force: force, foundation_stiffness: k } -> pinned
}

/// The plane structures of frames.json whose beams are general ones, to their 24 digits; the others are rows of the tests of frames.
fn general_beams(shares: &mut Shares) {
    let file: Value = serde_json::from_str(include_str!("../data/frames.json")).unwrap();
    let exact = |name: &str| -> Vec<DoubleDouble> {
        let listed = file[name]["wanted"]["omega"].as_array().unwrap();
        listed.iter().map(|text| text.as_str().unwrap().parse().unwrap()).collect()
    };
    // rotary inertia and others of one decimal are the doubles next to what is written, in the file as well
    let timoshenko = Timoshenko { length: 1.0, ei: 100.0, ga: 4000.0, m: 1.0, r: 0.01 }.build().unwrap();
    let strut = Strut { length: 1.0, ei: 100.0, m: 1.0, force: -500.0, k: 2000.0 }.build().unwrap();
    for (index, exact) in (1..).zip(exact("timoshenko_cantilever")) {
        let root = mode(&timoshenko, index, exact.to_f64(), shares, &|| "timoshenko_cantilever".to_owned());
        assert!(holds(&root, exact, 0.0), "{root:?} {exact}");
    }
    for (index, exact) in (1..).zip(exact("compressed_on_foundation")) {
        let root = mode(&strut, index, exact.to_f64(), shares, &|| "compressed_on_foundation".to_owned());
        assert!(holds(&root, exact, 0.0), "{root:?} {exact}");
    }
}

/// Exact values lie in their intervals, each of which is proven and between neighbouring numbers.
#[test]
fn decision_shares_of_exact_cases() {
    Shares::head("cases");
    for (name, family) in [
        ("validation.json", validation as fn(&mut Shares)),
        ("examples of the paper", paper),
        ("general beams of frames.json", general_beams),
    ] {
        let mut shares = Shares::default();
        family(&mut shares);
        shares.show(name);
        shares.all_proven(name);
        assert_eq!(shares.widths[0], shares.entries, "{name}: {shares:?}");
    }
}
