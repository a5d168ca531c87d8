//! What the page shows, against closed forms and exact values: the same functions that WebAssembly runs, compiled for this machine.
#![expect(clippy::unwrap_used, reason = "a failure here is one of the test")]

use explorer::bridge::Bridge;
use explorer::model::{Explored, MODELS, describe};
use explorer::portal::Portal;
use explorer::shown::Shown;
use explorer::table::Table;
use mstmm::Complex;
use serde_json::Value;
use std::f64::consts::PI;

/// The rows of a table of so many columns.
fn rows<const COLUMNS: usize, const CAP: usize>(table: &Table<CAP>) -> Vec<[f64; COLUMNS]> {
    let numbers: Vec<f64> = table.numbers().collect();
    let (rows, rest) = numbers.as_chunks();
    assert!(rest.is_empty());
    rows.to_vec()
}

/// The deflection of a pinned beam at a under a force there, `(sin βa sin βb / sin βl - sinh βa sinh βb / sinh βl)/(2 EI β³)` with
/// `b = l - a`, `EI β⁴ = -(m λ² + c λ)`, as a fraction below `sin βl`; and the dynamic stiffness of the damper there.
fn beam_and_damper(bridge: &Bridge, lambda: Complex<f64>) -> ([Complex<f64>; 2], Complex<f64>) {
    let (m, pace): (f64, f64) = (1500.0, 730.0);
    let ei = m * pace * pace;
    let air = 2.0 * bridge.ratio * m * pace * (PI / bridge.span).powi(2);
    let beta = (-(lambda * lambda * m + lambda * air) / ei).sqrt().sqrt();
    let (a, l) = (bridge.place * bridge.span, bridge.span);
    let [sa, sb, sl] = [a, l - a, l].map(|x| (beta * x).sin());
    let [ha, hb, hl] = [a, l - a, l].map(|x| (beta * x).sinh());
    let above = (sa * sb - ha * hb * sl / hl) / (beta * beta * beta * 2.0 * ei);
    let (link, inertia) = (bridge.stiffness + lambda * bridge.damping, lambda * lambda * bridge.mass);
    ([above, sl], link * inertia / (link + inertia))
}

/// How far a root of `(1 + Y/F D) sin βl` is from λ, relatively: a step of the secant method.
fn distance(bridge: &Bridge, lambda: Complex<f64>) -> f64 {
    let value = |lambda| {
        let ([above, below], damper) = beam_and_damper(bridge, lambda);
        below + above * damper
    };
    let away = lambda * (1.0 + 1e-6);
    (value(lambda) / (value(away) - value(lambda))).norm() * 1e-6
}

#[test]
fn bridges_have_the_roots_and_the_response_of_their_closed_form() {
    let shown = Shown::new();
    for values in [
        [760.0, 55.2, 360.0, 50.0, 24.0, 0.5],
        [300.0, 90.0, 900.0, 31.5, 20.0, 2.0],
        [0.0, 30.0, 100.0, 12.0, 33.0, 0.1],
    ] {
        let bridge = Bridge::at(values);
        MODELS[0].show(&values, &shown).unwrap();
        let eigenvalues: Vec<[f64; 5]> = rows(&shown.eigenvalues);
        assert_eq!(eigenvalues.len(), 3, "{values:?}: {eigenvalues:?}");
        for [re, im, ..] in eigenvalues {
            let lambda = Complex::new(re, im);
            assert!(distance(&bridge, lambda) < 1e-13, "{values:?}: {lambda} is {:e} off", distance(&bridge, lambda));
        }
        let still = Bridge { damping: 0.0, ratio: 0.0, ..bridge };
        for [omega, lower, upper, _] in rows(&shown.frequencies) {
            assert!(lower <= omega && omega <= upper);
            assert!(distance(&still, Complex::new(0.0, omega)) < 1e-13, "{values:?}: {omega}");
        }
        for [omega, re, im] in rows(&shown.response) {
            let ([above, below], damper) = beam_and_damper(&bridge, Complex::new(0.0, omega));
            let expected = above / (below + above * damper);
            assert!((Complex::new(re, im) - expected).norm() < 1e-11 * expected.norm(), "{values:?}: {omega}");
        }
        for [omega, re, im] in rows(&shown.bare) {
            let ([above, below], _) = beam_and_damper(&bridge, Complex::new(0.0, omega));
            let beam = above / below;
            assert!((Complex::new(re, im) - beam).norm() < 1e-11 * beam.norm(), "{values:?}: {omega}");
        }
    }
}

/// Oracle: the symmetric portal of `tests/data/frames.json`, by a dynamic stiffness in 77 digits.
#[test]
fn the_portal_has_the_exact_frequencies() {
    let cases: Value = serde_json::from_str(include_str!("../../../tests/data/frames.json")).unwrap();
    let exact: Vec<f64> = cases["portal"]["wanted"]["omega"].as_array().unwrap().iter().map(number).collect();
    let shown = Shown::new();
    MODELS[1].show(&[2.0, 35.0, 2.0, 0.0, 1.0], &shown).unwrap();
    let found: Vec<[f64; 4]> = rows(&shown.frequencies);
    assert_eq!(found.len(), 5);
    for ([omega, ..], exact) in found.iter().zip(exact) {
        assert!((omega / exact - 1.0).abs() < 1e-14, "{omega} is not {exact}");
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().or_else(|| value.as_str()?.parse().ok()).unwrap()
}

/// A mode of both models is at rest where it is held, and moves by 1 m where it moves most.
#[test]
fn shapes_are_held_where_the_model_is_and_move_by_one() {
    let shown = Shown::new();
    for (model, modes) in [(0, 3), (1, 5)] {
        MODELS[model].show(&[], &shown).unwrap();
        let points: Vec<[f64; 2]> = rows(&shown.points);
        let shapes: Vec<[f64; 4]> = rows(&shown.shapes);
        assert_eq!(shapes.len(), modes * points.len());
        let parts: Vec<[f64; 3]> = rows(&shown.parts);
        let supports: Vec<[f64; 2]> =
            parts.iter().filter(|[kind, ..]| *kind >= 4.0).map(|[_, first, _]| points[*first as usize]).collect();
        assert_eq!(supports.len(), 2);
        for shape in shapes.chunks(points.len()) {
            let size = |[x, xi, y, yi]: &[f64; 4]| (x * x + xi * xi + y * y + yi * yi).sqrt();
            let largest = shape.iter().map(size).fold(0.0, f64::max);
            // the largest may be between two points
            assert!((0.95..1.0 + 1e-9).contains(&largest), "{largest}");
            for (point, motion) in points.iter().zip(shape) {
                assert!(!supports.contains(point) || size(motion) < 1e-12, "{point:?} moves");
            }
        }
    }
}

#[test]
fn every_slider_can_go_from_end_to_end() {
    let mut text = String::new();
    let shown = Shown::new();
    describe(&mut text, &shown).unwrap();
    let described: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(described["tables"].as_array().unwrap().len(), shown.tables().len());
    for (model, listed) in described["models"].as_array().unwrap().iter().zip(MODELS) {
        let sliders = model["sliders"].as_array().unwrap();
        let start: Vec<f64> = sliders.iter().map(|slider| number(&slider["start"])).collect();
        for (k, slider) in sliders.iter().enumerate() {
            for end in ["min", "start", "max"] {
                let mut values = start.clone();
                values[k] = number(&slider[end]);
                listed.show(&values, &shown).unwrap_or_else(|problem| panic!("{slider}: {problem}"));
                assert!(shown.response.length() > 0);
            }
        }
    }
}

#[test]
fn a_problem_is_told_and_leaves_nothing_to_show() {
    let shown = Shown::new();
    MODELS[1].show(&[], &shown).unwrap();
    let problem = MODELS[1].show(&[4.0, 35.0, 3.0, 200.0, -1.0], &shown).unwrap_err();
    assert_eq!(problem.to_string(), "beam 1: bending_stiffness is -1000000, but must be positive and finite");
    assert!(shown.tables().iter().all(|(_, _, table)| table.place().1 == 0));
    assert_eq!(Portal::at([]).machine, 200.0);
}
