//! The shapes and receptances of tests/data/frames.json.
#![expect(clippy::unwrap_used, reason = "a file that is not as it should be fails the test")]

use crate::reference_cases::{node_names, reference_cases};
use crate::through_library::asked;
use mstmm::motion::PlanePoint;
use mstmm::prelude::*;
use serde_json::Value;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_str().unwrap().parse().unwrap()).collect()
}

/// The case and its values, where it has some.
fn cases(what: &str) -> Vec<(crate::structure::Structure, Vec<String>, Value)> {
    let file: Value = serde_json::from_str(include_str!("../../data/frames.json")).unwrap();
    let wanted = |name: &str| file[name]["wanted"][what].clone();
    let with_values = reference_cases().into_iter().filter(|case| !wanted(case.name).is_null());
    with_values.map(|case| (case.structure, node_names(&file[case.name]["model"]), wanted(case.name))).collect()
}

#[test]
fn receptances_of_reference_cases_are_exact() {
    let mut compared = 0;
    for (structure, names, wanted) in cases("receptance") {
        let point = |place: &Value| {
            let node = names.iter().position(|name| name == place[0].as_str().unwrap()).unwrap();
            (PlanePoint::node(node), place[1].as_str().unwrap().to_owned())
        };
        for receptance in wanted.as_array().unwrap() {
            let (loaded, axis) = point(&receptance["load"]);
            let load = if axis == "x" { loaded.force_x() } else { loaded.force_y() };
            for row in receptance["rows"].as_array().unwrap() {
                let omega = row["omega"].as_f64().unwrap();
                let exact: Vec<f64> = row["H"].as_array().unwrap().iter().map(|value| numbers(value)[0]).collect();
                let largest = exact.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
                for (place, exact) in receptance["at"].as_array().unwrap().iter().zip(exact) {
                    let (read, axis) = point(place);
                    let entry = if axis == "x" { read.displacement_x() } else { read.displacement_y() };
                    let value = asked(&structure, |network| {
                        let response = network.frequency_response(load, entry).unwrap();
                        response.at(omega).map_err(|error| error.to_string())
                    });
                    let error = (value.unwrap() - exact).abs() / largest;
                    assert!(error <= 1e-13, "{omega} {place}: {error:e}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared >= 6);
}

#[test]
fn shapes_of_reference_cases_are_exact() {
    let mut compared = 0;
    for (structure, names, wanted) in cases("shapes") {
        for shape in wanted.as_array().unwrap() {
            let mode = shape["mode"].as_u64().unwrap() as usize;
            let found = asked(&structure, |network| {
                let roots = network.first_frequencies::<4>().unwrap();
                let shape = network.mode_shape(&roots[mode - 1]).map_err(|error| error.to_string())?;
                Ok((0..names.len()).map(|node| shape.node(node).unwrap()).collect::<Vec<_>>())
            })
            .unwrap();
            let exact: Vec<Vec<f64>> = names.iter().map(|name| numbers(&shape["unit_modal_mass"][name])).collect();
            let all = || exact.iter().flatten().zip(found.iter().flatten());
            let largest = exact.iter().flatten().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            // the sign of a shape is free
            let sign = all().map(|(exact, found)| exact * found).sum::<f64>().signum();
            for (exact, found) in all() {
                let error = (found * sign - exact).abs() / largest;
                assert!(error <= 1e-12, "mode {mode}: {found} {exact}");
                compared += 1;
            }
        }
    }
    assert!(compared >= 18);
}
