//! The exact roots of the scenes against values that come from other methods.

use rivals::scenes::{self, Scene};
use serde_json::Value;

fn data(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_default()
}

fn number(value: &Value) -> f64 {
    value.as_str().and_then(|digits| digits.parse().ok()).unwrap_or(f64::NAN)
}

fn paper(id: &str) -> Vec<Value> {
    let data = data(include_str!("../../../tests/data/paper.json"));
    let examples = data["examples"].as_array().cloned().unwrap_or_default();
    let example = examples.iter().find(|example| example["id"] == id).cloned().unwrap_or_default();
    example["values"][0]["exact"].as_array().cloned().unwrap_or_default()
}

fn validation(id: &str) -> Value {
    let data = data(include_str!("../../../tests/data/validation.json"));
    let cases = data["cases"].as_array().cloned().unwrap_or_default();
    cases.into_iter().find(|case| case["id"] == id).unwrap_or_default()
}

/// Real and imaginary parts of the roots of a scene as other methods have them.
fn expected(scene: &Scene) -> Vec<[f64; 2]> {
    let span = scene.structure.spans[0];
    let unit = (span.bending_stiffness / span.mass_per_length).sqrt();
    let frequency = |omega: f64| [0.0, omega];
    let values = paper(scene.name);
    match scene.name {
        // these tables list the square root of ω
        "4.1a" | "4.2" => values.iter().map(|value| frequency(number(value).powi(2) * unit)).collect(),
        "4.3" => values.iter().map(|value| frequency(number(value) * unit)).collect(),
        "4.4" => values.iter().map(|value| frequency(number(value))).collect(),
        "4.5" => values.iter().map(|value| [0, 1].map(|part| number(&value[part]) * unit)).collect(),
        "mode 100" => {
            let modes = validation("single_free_fixed")["omega_by_mode"].clone();
            let modes = modes.as_array().cloned().unwrap_or_default();
            modes.iter().filter(|mode| mode[0] == 100).map(|mode| frequency(number(&mode[1]))).collect()
        }
        "close pair" => {
            let omegas = validation("twin_cantilevers_1e-8")["omega"].clone();
            omegas
                .as_array()
                .cloned()
                .unwrap_or_default()
                .iter()
                .take(2)
                .map(|value| frequency(number(value)))
                .collect()
        }
        // dynamic stiffness matrices with 60 digits
        "stiff" => [0.254_268_919_272_360_47, 1.759_428_533_962_436_5, 5.554_787_429_323_448].map(frequency).to_vec(),
        _ => Vec::new(),
    }
}

/// Oracles: the paper's examples and the validation cases as other methods computed them in 40 to 90 digits. Units and
/// products of parameters are rounded, in 4.5 five times: 8 eps in all.
#[test]
fn exact_roots_are_those_of_other_methods() {
    for scene in scenes::all().unwrap() {
        let expected = expected(&scene);
        assert_eq!(scene.exact.len(), expected.len(), "{}", scene.name);
        for (root, [re, im]) in scene.exact.iter().zip(expected) {
            let error = (root.re - re).hypot(root.im - im) / re.hypot(im);
            assert!(error <= 8.0 * f64::EPSILON, "{} {root}: {error:e}", scene.name);
        }
    }
}
