//! A written glTF: what its specification asks of accessors, views and animations, and its numbers against the model.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod support;

use mstmm::prelude::*;
use mstmm_files::{FileError, Geometry, Mode, write_gltf};
use serde_json::{Value, json};
use std::f64::consts::TAU;
use support::mast::{HEIGHT, first_shape, modes};
use support::{complex_mode, mast};

/// What is written, as JSON.
fn written(geometry: &Geometry, modes: Vec<Mode>) -> Result<Value, FileError> {
    let mut file = Vec::new();
    let result = write_gltf(&mut file, geometry, modes);
    assert!(result.is_ok() || file.is_empty());
    result.map(|()| serde_json::from_slice(&file).unwrap())
}

/// Bytes from their base64, by the table of RFC 4648.
fn decoded(text: &str) -> Vec<u8> {
    let digit = |byte: u8| match byte {
        b'A'..=b'Z' => byte - b'A',
        b'a'..=b'z' => byte - b'a' + 26,
        b'0'..=b'9' => byte - b'0' + 52,
        b'+' => 62,
        _ => {
            assert_eq!(byte, b'/');
            63
        }
    };
    let digits: Vec<u8> = text.trim_end_matches('=').bytes().map(digit).collect();
    let (mut bytes, mut bits, mut count) = (Vec::new(), 0_u32, 0);
    for digit in digits {
        (bits, count) = (bits << 6 | u32::from(digit), count + 6);
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
            bits &= (1 << count) - 1;
        }
    }
    bytes
}

fn whole(value: &Value, key: &str) -> usize {
    value[key].as_u64().unwrap() as usize
}

/// The numbers of an accessor, after a check of all that the specification asks of it.
fn numbers(file: &Value, accessor: &Value) -> Vec<f64> {
    let accessor = &file["accessors"][accessor.as_u64().unwrap() as usize];
    let view = &file["bufferViews"][whole(accessor, "bufferView")];
    let buffer = &file["buffers"][whole(view, "buffer")];
    let bytes = decoded(buffer["uri"].as_str().unwrap().strip_prefix("data:application/octet-stream;base64,").unwrap());
    assert_eq!(whole(buffer, "byteLength"), bytes.len());
    let width = if accessor["type"] == "VEC3" { 3 } else { 1 };
    let (start, length) = (whole(view, "byteOffset"), whole(view, "byteLength"));
    assert_eq!((start % 4, length), (0, whole(accessor, "count") * width * 4));
    assert!(start + length <= bytes.len());
    let numbers: Vec<f64> = bytes[start..start + length]
        .chunks(4)
        .map(|four| match whole(accessor, "componentType") {
            5126 => f64::from(f32::from_le_bytes(four.try_into().unwrap())),
            kind => {
                assert_eq!(kind, 5125);
                f64::from(u32::from_le_bytes(four.try_into().unwrap()))
            }
        })
        .collect();
    for (key, of, start) in [("min", f64::min as fn(f64, f64) -> f64, f64::INFINITY), ("max", f64::max, -f64::INFINITY)]
    {
        if let Some(bounds) = accessor[key].as_array() {
            let bound = |k: usize| numbers.iter().skip(k).step_by(width).copied().fold(start, of) as f32;
            // serde_json is one unit of double precision beside some numbers; bounds are numbers of single precision
            let read = |bound: &Value| bound.as_f64().unwrap() as f32;
            assert_eq!(bounds.iter().map(read).collect::<Vec<_>>(), (0..width).map(bound).collect::<Vec<_>>());
        }
    }
    numbers
}

/// Places that have bounds, one target for each place of each name, weights for all targets, and lines among the places.
fn check(file: &Value) {
    assert_eq!(file["asset"]["version"], "2.0");
    let mesh = &file["meshes"][0];
    let primitive = &mesh["primitives"][0];
    assert_eq!(primitive["mode"], 1);
    let accessor = |index: &Value| &file["accessors"][index.as_u64().unwrap() as usize];
    let count = whole(accessor(&primitive["attributes"]["POSITION"]), "count");
    let indices = numbers(file, &primitive["indices"]);
    assert!(indices.len().is_multiple_of(2) && indices.iter().all(|index| *index < count as f64));
    let targets = primitive["targets"].as_array().map_or(&[][..], Vec::as_slice);
    for places in targets.iter().chain([&primitive["attributes"]]).map(|attributes| &attributes["POSITION"]) {
        assert!(accessor(places)["min"].is_array() && accessor(places)["max"].is_array());
        assert_eq!(numbers(file, places).len(), 3 * count);
    }
    for animation in file["animations"].as_array().into_iter().flatten() {
        let sampler = &animation["samplers"][0];
        assert_eq!(animation["channels"], json!([{ "sampler": 0, "target": { "node": 0, "path": "weights" } }]));
        assert_eq!(accessor(&sampler["input"])["min"], json!([0]));
        let (times, weights) = (numbers(file, &sampler["input"]), numbers(file, &sampler["output"]));
        assert!(times.is_sorted_by(|one, next| one < next));
        assert_eq!(weights.len(), times.len() * targets.len());
    }
    let length: usize = file["bufferViews"].as_array().unwrap().iter().map(|view| whole(view, "byteLength")).sum();
    assert_eq!(length, whole(&file["buffers"][0], "byteLength"));
    // every accessor has its own view
    assert_eq!(file["accessors"].as_array().unwrap().len(), file["bufferViews"].as_array().unwrap().len());
}

/// Closed form: a cantilever.
#[test]
fn modes_vibrate_as_the_model_does() {
    let (lines, modes) = modes(3);
    let file = written(lines.geometry(), modes).unwrap();
    check(&file);
    let (mesh, primitive) = (&file["meshes"][0], &file["meshes"][0]["primitives"][0]);
    assert_eq!(mesh["weights"], json!([0, 0, 0]));
    assert_eq!(mesh["extras"]["targetNames"][0], format!("mode 1 ({:.4} Hz)", mast::first_hertz()));
    assert_eq!(file["animations"][0]["name"], mesh["extras"]["targetNames"][0]);
    // 19 pieces of each of two members
    let indices = numbers(&file, &primitive["indices"]);
    assert_eq!((indices.len(), &indices[36..40]), (76, &[18.0, 19.0, 20.0, 21.0][..]));
    let (places, first) =
        (numbers(&file, &primitive["attributes"]["POSITION"]), numbers(&file, &primitive["targets"][0]["POSITION"]));
    // the tip moves by a tenth of the diagonal
    let scale = 0.1 * HEIGHT.hypot(3.0) / first_shape(HEIGHT) * first[58].signum();
    for (place, moved) in places.chunks(3).zip(first.chunks(3)).take(20) {
        assert!((moved[1] - scale * first_shape(place[2])).abs() < 1e-6, "{moved:?}");
    }
    for (mode, animation) in file["animations"].as_array().unwrap().iter().enumerate() {
        let sampler = &animation["samplers"][0];
        let (times, weights) = (numbers(&file, &sampler["input"]), numbers(&file, &sampler["output"]));
        assert_eq!((times[0], times[32], times.len()), (0.0, 1.0, 33));
        for (time, weights) in times.iter().zip(weights.chunks(3)) {
            for (target, weight) in weights.iter().enumerate() {
                let exact = if target == mode { (TAU * time).sin() } else { 0.0 };
                assert!((weight - exact).abs() < 1e-7);
            }
        }
    }
    // a model in space stands on its x-y plane: its z is y there
    let turn: Vec<f64> = file["nodes"][0]["rotation"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    assert_eq!(turned(&turn, [1.0, 2.0, 3.0]).map(|x| (1e9 * x).round() / 1e9), [1.0, 3.0, -2.0]);
}

/// A vector turned by a unit quaternion: `v + 2 q × (q × v + w v)`.
fn turned(turn: &[f64], v: [f64; 3]) -> [f64; 3] {
    let (q, w) = ([turn[0], turn[1], turn[2]], turn[3]);
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [0, 1, 2].map(|k: usize| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
    };
    let first = cross(q, v);
    let second = cross(q, [0, 1, 2].map(|k| first[k] + w * v[k]));
    [0, 1, 2].map(|k| v[k] + 2.0 * second[k])
}

/// `Im((φ) e^{iτ})` is `Re φ sin τ + Im φ cos τ`.
#[test]
fn complex_modes_have_two_targets_and_one_animation() {
    let (geometry, mode) = complex_mode();
    let real = Mode::from(NaturalFrequency::default()).with_vectors([[0.0; 3], [1.0, 0.0, 0.0]]).named("\"a\\b\"");
    let zero = Complex::new(0.0, 0.0);
    let circle = Mode::from(Eigenvalue::default())
        .with_vectors([[zero; 3], [Complex::new(3.0, 0.0), Complex::new(0.0, -4.0), zero]])
        .named("circle");
    let file = written(&geometry, vec![mode, circle, real]).unwrap();
    check(&file);
    let names = &file["meshes"][0]["extras"]["targetNames"];
    assert_eq!(names.as_array().unwrap().len(), file["meshes"][0]["weights"].as_array().unwrap().len());
    assert_eq!(names.as_array().unwrap().last().unwrap(), "\"a\\b\"");
    assert_eq!(file["animations"].as_array().unwrap().len(), 3);
    assert!(file["nodes"][0].get("rotation").is_none());
    let first = names.as_array().unwrap().iter().position(|name| name == "circle, real part").unwrap();
    let target = |k: usize| numbers(&file, &file["meshes"][0]["primitives"][0]["targets"][k]["POSITION"]);
    // the longer one of both, 5, is a tenth of 1.25
    let near = |read: f64, exact: f64| (read - exact).abs() < 1e-7;
    assert!(near(target(first)[3], 0.125 * 3.0 / 5.0) && near(target(first + 1)[4], -0.125 * 4.0 / 5.0));
    let sampler = &file["animations"][1]["samplers"][0];
    let count = names.as_array().unwrap().len();
    for (moment, weights) in numbers(&file, &sampler["output"]).chunks(count).enumerate() {
        let angle = TAU * moment as f64 / 32.0;
        assert!(near(weights[first], angle.sin()) && near(weights[first + 1], angle.cos()));
        assert!(weights.iter().enumerate().all(|(k, weight)| [first, first + 1].contains(&k) || *weight == 0.0));
    }
}

#[test]
fn figures_may_have_no_modes_and_modes_no_motion() {
    let mut geometry = Geometry::default();
    geometry.add_line("a", [[0.0; 3], [1.0, 2.0, 0.0]]);
    let still = written(&geometry, Vec::new()).unwrap();
    check(&still);
    assert!(still.get("animations").is_none() && still["meshes"][0].get("weights").is_none());
    let root = NaturalFrequency { omega: 1.0, ..NaturalFrequency::default() };
    let rest = written(&geometry, vec![Mode::from(root).with_vectors([[0.0; 3]; 2])]).unwrap();
    check(&rest);
    assert_eq!(numbers(&rest, &rest["meshes"][0]["primitives"][0]["targets"][0]["POSITION"]), [0.0; 6]);
}

#[test]
fn what_is_no_figure_is_refused() {
    let mut geometry = Geometry::default();
    assert!(matches!(written(&geometry, Vec::new()), Err(FileError::NoPoints)));
    geometry.points = vec![[0.0; 3], [1e39, 0.0, 0.0]];
    assert!(matches!(written(&geometry, Vec::new()), Err(FileError::NoLines)));
    geometry.add_line("a", [[0.0; 3], [1.0; 3]]);
    // not finite in single precision
    assert!(matches!(written(&geometry, Vec::new()), Err(FileError::Place { point: 1 })));
    geometry.points[1][0] = 2.0;
    let root = NaturalFrequency { omega: 1.0, ..NaturalFrequency::default() };
    let error = written(&geometry, vec![Mode::from(root)]).unwrap_err();
    assert!(matches!(error, FileError::Vectors { row: 0, values: 0, points: 4 }), "{error}");
}
