//! What the examples compute, against results that share nothing with it.

#[expect(dead_code, reason = "the example's main")]
#[path = "../../examples/column.rs"]
pub mod column;
#[expect(dead_code, reason = "the example's main")]
#[path = "../../examples/spindle.rs"]
pub mod spindle;
#[expect(dead_code, reason = "the example's main")]
#[path = "../../examples/time_response.rs"]
pub mod time_response;
#[expect(dead_code, reason = "the example's main")]
#[path = "../../examples/tip_body.rs"]
pub mod tip_body;
#[expect(dead_code, reason = "the example's main")]
#[path = "../../examples/track.rs"]
pub mod track;

use crate::support::example::{assert_close, printed, rows_of};
use std::f64::consts::PI;

/// Oracles: the paper's exact Ω; a cantilever's `A (cosh - cos) + B (sinh - sin)`; and what energies say about sensitivities,
/// since ω² is the strain energy over the kinetic one.
#[test]
#[ignore = "long: .ci/long"]
fn the_tip_body_is_as_it_must() {
    let (text, model) = (printed("tip_body"), tip_body::light_body());
    let data: serde_json::Value = serde_json::from_str(include_str!("../data/paper.json")).unwrap();
    let example = data["examples"].as_array().unwrap().iter().find(|example| example["id"] == "4.1a").unwrap();
    let values = example["values"].as_array().unwrap().iter().find(|values| values["quantity"] == "Omega").unwrap();
    let exact = |mode: usize| values["exact"][mode].as_str().unwrap().parse::<f64>().unwrap();

    let frequencies = rows_of(&text, "mode    f [Hz]");
    assert_eq!(frequencies.len(), 4);
    for (mode, row) in frequencies.iter().enumerate() {
        let omega = exact(mode) * (model.ei / model.m).sqrt();
        assert_close(row[2], omega, 1e-11);
        assert_close(row[1], omega / std::f64::consts::TAU, 1e-4);
        assert!(row[3] <= row[2] + 1e-10 && row[2] <= row[4] + 1e-10, "{row:?}");
    }
    let slopes = rows_of(&text, "What the first frequency");
    let energies = rows_of(&text, "mode   strain");
    let [ei, m, mass, inertia] = [slopes[1][0], slopes[2][0], slopes[3][0], slopes[4][0]];
    let half = exact(0) * (model.ei / model.m).sqrt() / 2.0;
    assert_close(ei, half / model.ei, 1e-5);
    assert_close(m, -half / model.m * energies[0][2] / 100.0, 3e-4);
    assert_close(model.mass * mass + model.inertia * inertia, -half * energies[0][3] / 100.0, 1e-4);
    assert_eq!(slopes[6], [0.0]);

    let shapes = rows_of(&text, "mode       0.25");
    for (mode, row) in shapes.iter().enumerate() {
        let beta = exact(mode).sqrt();
        let even = |x: f64| (beta * x).cosh() - (beta * x).cos();
        let odd = |x: f64| (beta * x).sinh() - (beta * x).sin();
        let determinant = even(0.5) * odd(1.0) - even(1.0) * odd(0.5);
        let a = (row[2] * odd(1.0) - row[4] * odd(0.5)) / determinant;
        let b = (even(0.5) * row[4] - even(1.0) * row[2]) / determinant;
        let slope = beta * (a * ((beta).sinh() + beta.sin()) + b * (beta.cosh() - beta.cos()));
        for (part, deflection) in [(0.25, row[1]), (0.75, row[3])] {
            let expected = a * even(part) + b * odd(part);
            assert!((deflection - expected).abs() < 1e-5, "mode {mode} at {part}: {deflection} {expected}");
        }
        assert!((row[5] - row[4] - model.depth * slope).abs() < 1e-4, "mode {mode}: {row:?} {slope}");
        let nodes = row[1..5].windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
        assert_eq!(row[6], nodes as f64);
    }
}

/// Oracle: `Σ φ(l/2) φ(l) e^{-ζωt} sin(ω_d t)/(m l ω_d)` with the cantilever's `φ`, whose squares have the integral l, and its
/// integrals over the forces.
#[test]
#[ignore = "long: .ci/long"]
fn the_cantilever_moves_as_the_sum_over_its_modes() {
    let (length, ei, m, ratio) = (0.8, 113.4_f64, 1.413, 0.01_f64);
    let modes: Vec<_> = (1..=30)
        .map(|number: u32| {
            let z = root_of_cantilever(number);
            let omega = (z / length).powi(2) * (ei / m).sqrt();
            // cosh z/2 - q sinh z/2 with q = (cos z + cosh z)/(sin z + sinh z), without the difference of large numbers
            let (half, rest) = (z / 2.0, (z.sin() - z.cos() - (-z).exp()) / (z.sin() + z.sinh()));
            let middle = (-half).exp() + rest * half.sinh() - half.cos() + (1.0 - rest) * half.sin();
            let tip = if number % 2 == 1 { 2.0 } else { -2.0 };
            (ratio * omega, omega * (1.0 - ratio * ratio).sqrt(), middle * tip / (m * length))
        })
        .collect();
    let impulse = |t: f64| -> f64 { modes.iter().map(|(d, w, a)| a * (-d * t).exp() * (w * t).sin() / w).sum() };
    // the tip follows the middle and turns with it, `x³/(3 EI) + x²/(2 EI) x`; what the modes leave of that is there at once
    let middle: f64 = length / 2.0;
    let at_once = 5.0 * middle.powi(3) / (6.0 * ei) - modes.iter().map(|(d, w, a)| a / (d * d + w * w)).sum::<f64>();
    let step = |t: f64| -> f64 {
        let term = |(d, w, a): &(f64, f64, f64)| {
            a * (1.0 - (-d * t).exp() * ((w * t).cos() + d / w * (w * t).sin())) / (d * d + w * w)
        };
        modes.iter().map(term).sum::<f64>() + at_once
    };
    // between samples the hammer's force is linear: Simpson's rule has as many intervals in each tenth of a millisecond
    let hammer = |t: f64| {
        if t > 1e-3 - 1e-12 {
            return 0.0;
        }
        let sample = |index: f64| 0.5e3 * PI * (index * PI / 10.0).sin();
        let (index, part) = ((1e4 * t + 1e-9).floor(), (1e4 * t + 1e-9).fract());
        sample(index) * (1.0 - part) + sample(index + 1.0) * part
    };
    let struck = |t: f64| {
        let width = t.min(1e-3) / 5040.0;
        let weight = |index: u32| f64::from([2, 4][index as usize % 2] - u32::from(index == 0 || index == 5040));
        let value = |index: u32| hammer(width * f64::from(index)) * impulse(t - width * f64::from(index));
        (0..=5040).map(|index| weight(index) * value(index)).sum::<f64>() * width / 3.0 + at_once * hammer(t)
    };
    let rows = time_response::deflections(1001).unwrap();
    assert_eq!(rows.len(), 1001);
    let largest = [0, 1, 2].map(|load| rows.iter().map(|row| row.1[load].abs()).fold(0.0, f64::max));
    for (time, found) in rows.iter().step_by(37).chain(&rows[..12]) {
        let expected = [impulse(*time), step(*time), struck(*time)];
        for load in 0..3 {
            let error = (found[load] - expected[load]).abs() / largest[load];
            assert!(error < [1e-9, 1e-9, 1e-6][load], "{load} at {time}: {found:?} {expected:?} {error:e}");
        }
    }
    assert_eq!(rows_of(&printed("time_response"), "time [ms]").len(), 21);
}

/// The solution of `cos z cosh z = -1` of this number.
fn root_of_cantilever(number: u32) -> f64 {
    let value = |z: f64| z.cos() + 1.0 / z.cosh();
    let (mut low, mut high) = (PI * f64::from(number - 1), PI * f64::from(number));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if value(middle) * value(low) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Oracle: the work of a unit force at the nose, in both bearings, in bending and in shear.
#[test]
fn the_spindle_gives_way_as_much_as_its_parts() {
    let spindle = spindle::heavy();
    let (a, b) = (spindle.overhang, spindle.span);
    let of_tube = |diameter: f64, power: i32| diameter.powi(power) - spindle.bore.powi(power);
    let [(ei, ga), (ei_of_nose, ga_of_nose)] = [spindle.diameter, spindle.nose]
        .map(|diameter| (2.1e11 * PI / 64.0 * of_tube(diameter, 4), 0.6 * 8.1e10 * 0.25 * PI * of_tube(diameter, 2)));
    let bearings = (a / b).powi(2) / spindle.rear + (1.0 + a / b).powi(2) / spindle.front;
    let bending = a * a * (a / ei_of_nose + b / ei) / 3.0;
    let shear = a / ga_of_nose + a * a / b / ga;
    assert_close(spindle::flexibility(&spindle).unwrap(), bearings + bending + shear, 1e-12);
    let slender = spindle::Spindle { shear: 0.0, ..spindle };
    assert_close(spindle::flexibility(&slender).unwrap(), bearings + bending, 1e-12);
}

/// Oracles: Euler's load; a pinned column's frequency falls with the root of what is left of its load; a brace with 16π² EI/l³ doubles the
/// half waves.
#[test]
#[ignore = "long: .ci/long"]
fn the_column_buckles_where_it_must() {
    let (text, model) = (printed("column"), column::steel());
    let euler = PI * PI * model.ei / (model.height * model.height);
    let loads = rows_of(&text, "brace [MN/m]");
    // the brace of the first row is 1 N/mm
    assert_close(loads[0][1], 1e-6 * euler, 1e-6);
    assert_close(loads[0][2], 4e-6 * euler, 1e-6);
    assert!(16.0 * euler / model.height < 1e7);
    assert_close(loads[3][1], 4e-6 * euler, 1e-6);
    for row in rows_of(&text, "load / critical") {
        assert_close(row[2], 1.0 - row[0], 2e-7);
    }
    assert!(text.contains("beyond it 1 motion grows"));
}

/// Oracle: Winkler's rail without end.
#[test]
#[ignore = "long: .ci/long"]
fn the_track_goes_down_as_winkler_says() {
    let (text, model) = (printed("track"), track::main_line());
    let number = |start: &str| -> f64 {
        let line = text.lines().find(|line| line.starts_with(start)).unwrap();
        line.split_whitespace().rev().nth(1).unwrap().parse().unwrap()
    };
    let exact = 1e8 * track::winkler(&model);
    assert_close(number("a wheel of 100 kN"), exact, 2e-9);
    assert_close(number("Winkler's rail"), exact, 2e-9);
    let waves = rows_of(&text, "waves travel from");
    assert_eq!(waves.len(), 4);
}

/// Oracle: a rigid blade on a hinge at the axis flaps once per turn, so that Southwell's coefficient of a first mode is more than 1; published
/// ones of blades are below 1.6.
#[test]
#[ignore = "long: .ci/long"]
fn the_blade_stiffens_as_it_turns() {
    let text = printed("rotating_blade");
    let rows = rows_of(&text, "speed [1/min]");
    assert_eq!(rows.len(), 5);
    for pair in rows.windows(2) {
        assert!(pair[0][1] < pair[1][1] && pair[0][2] < pair[1][2] && pair[0][3] < pair[1][3], "{rows:?}");
    }
    let coefficient: f64 = text.lines().last().unwrap().split_whitespace().last().unwrap().parse().unwrap();
    assert!((1.0..1.6).contains(&coefficient), "{coefficient}");
}
