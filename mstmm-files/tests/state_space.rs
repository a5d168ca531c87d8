//! Files of state spaces, compiled and run, or read again: the steps of each are those of the space.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use mstmm::motion::{DiscreteStateSpace, HoldOrder};
use mstmm::prelude::*;
use mstmm_files::{FileError, Format, write_state_space};
use std::path::PathBuf;
use std::process::Command;

system! {
    struct Mast {}
    fixed -> beam 1 { length: 2.0, bending_stiffness: 80.0, mass_per_length: 1.5 } -> conn middle -> beam 2 { length: 1.0, bending_stiffness: 40.0, mass_per_length: 0.5 }
        -> conn tip -> free;
}

/// Three modes, two loads, two entries.
fn space(order: HoldOrder) -> DiscreteStateSpace<f64, 3, 2, 2> {
    let mast = Mast {}.build().unwrap();
    let roots = mast.first_frequencies::<3>().unwrap();
    let loads = [Mast::conn_tip.force(), Load::base_acceleration(Direction::y())];
    let entries = [Mast::conn_tip.deflection(), Mast::beam_1.input().moment()];
    let space = mast.state_space::<3, 2, 2>(&roots, loads, entries).unwrap();
    space.with_damping_ratio(0.02).unwrap().discrete(0.01, order).unwrap()
}

fn written(space: &DiscreteStateSpace<f64, 3, 2, 2>, format: Format) -> String {
    let mut file = Vec::new();
    write_state_space(&mut file, space, format).unwrap();
    String::from_utf8(file).unwrap()
}

/// The inputs of a sample.
fn inputs(k: u32) -> [f64; 2] {
    [f64::from(k % 7) - 3.0, if k < 30 { 1.0 } else { -0.25 }]
}

/// The outputs of some steps.
fn steps(mut space: DiscreteStateSpace<f64, 3, 2, 2>) -> Vec<[f64; 2]> {
    (0..100).map(|k| space.step(&inputs(k))).collect()
}

/// Compares numbers of single precision, or of a text, with the steps of a space.
#[track_caller]
fn assert_same(found: &[[f64; 2]], order: HoldOrder, tolerance: f64) {
    let expected = steps(space(order));
    assert_eq!(found.len(), expected.len());
    for output in 0..2 {
        let size = expected.iter().map(|row| row[output].abs()).fold(0.0, f64::max);
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found[output] - expected[output]).abs() < tolerance * size, "{found:?} {expected:?}");
        }
    }
}

/// A folder for the files of a test.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Numbers in lines of two.
fn rows(text: &str) -> Vec<[f64; 2]> {
    let row = |line: &str| {
        let mut numbers = line.split_whitespace().map(|number| number.parse().unwrap());
        [numbers.next().unwrap(), numbers.next().unwrap()]
    };
    text.lines().map(row).collect()
}

#[test]
fn json_has_all_digits() {
    for order in [HoldOrder::Zero, HoldOrder::First] {
        let space = space(order);
        let file: serde_json::Value = serde_json::from_str(&written(&space, Format::Json)).unwrap();
        let matrix = |name: &str| -> Vec<Vec<f64>> { serde_json::from_value(file[name].clone()).unwrap() };
        let [e, g, after, c, d] = ["e", "g", "after", "c", "d"].map(matrix);
        assert_eq!(
            (file["dt"].as_f64(), e[1][0], g[2][1], d[1][0]),
            (Some(0.01), space.e(1, 0), space.g(2, 1), space.d(1, 0))
        );
        let times = |rows: &[Vec<f64>], vector: &[f64]| -> Vec<f64> {
            rows.iter().map(|row| row.iter().zip(vector).map(|(one, other)| one * other).sum()).collect()
        };
        let mut x: Vec<f64> = times(&after, &inputs(0)).iter().map(|part| -part).collect();
        let mut found = Vec::new();
        for k in 0..100 {
            let [one, other] = [times(&c, &x), times(&d, &inputs(k))];
            found.push([one[0] + other[0], one[1] + other[1]]);
            x = times(&e, &x).iter().zip(times(&g, &inputs(k))).map(|(one, other)| one + other).collect();
        }
        assert_same(&found, order, 1e-13);
        let script = written(&space, Format::Matlab);
        assert!(script.contains("dt = 0.01;\nE = [") && script.contains(&format!("D = [{:?}", space.d(0, 0))));
    }
}

/// With the compiler of C, which links what rustc compiles.
#[test]
fn the_header_steps_as_the_space() {
    let folder = folder("header");
    std::fs::write(folder.join("mast.h"), written(&space(HoldOrder::First), Format::CHeader)).unwrap();
    let program = r#"
#include <stdio.h>
#include "mast.h"
int main(void) {
  float x[MSTMM_STATES], y[MSTMM_OUTPUTS];
  for (int k = 0; k < 100; k++) {
    float u[MSTMM_INPUTS] = { (float)(k % 7) - 3.0f, k < 30 ? 1.0f : -0.25f };
    if (k == 0) mstmm_begin(x, u);
    mstmm_step(x, u, y);
    printf("%.9g %.9g\n", y[0], y[1]);
  }
  return 0;
}
"#;
    std::fs::write(folder.join("main.c"), program).unwrap();
    let out = folder.join("mast");
    let compiled = Command::new("cc")
        .args(["-std=c99", "-Wall", "-Werror", "-o"])
        .arg(&out)
        .arg(folder.join("main.c"))
        .output()
        .unwrap();
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let printed = Command::new(&out).output().unwrap();
    assert_same(&rows(&String::from_utf8(printed.stdout).unwrap()), HoldOrder::First, 1e-4);
}

#[test]
fn the_module_steps_as_the_space() {
    let folder = folder("module");
    std::fs::write(folder.join("mast.rs"), written(&space(HoldOrder::First), Format::Rust)).unwrap();
    let program = r#"
#![deny(warnings)]
mod mast;
fn main() {
    let inputs = |k: u32| [(k % 7) as f32 - 3.0, if k < 30 { 1.0 } else { -0.25 }];
    let mut states = mast::begin(&inputs(0));
    for k in 0..100 {
        let [one, other] = mast::step(&mut states, &inputs(k));
        println!("{one:?} {other:?}");
    }
}
"#;
    std::fs::write(folder.join("main.rs"), program).unwrap();
    let out = folder.join("mast");
    let compiled =
        Command::new("rustc").args(["--edition", "2021", "-o"]).arg(&out).arg(folder.join("main.rs")).output().unwrap();
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let printed = Command::new(&out).output().unwrap();
    assert_same(&rows(&String::from_utf8(printed.stdout).unwrap()), HoldOrder::First, 1e-4);
}

#[test]
fn a_space_without_modes_is_no_file() {
    let mast = Mast {}.build().unwrap();
    let empty: [NaturalFrequency; 0] = [];
    let space = mast.state_space::<1, 1, 1>(&empty, [Mast::conn_tip.force()], [Mast::conn_tip.deflection()]).unwrap();
    let discrete = space.discrete(0.1, HoldOrder::Zero).unwrap();
    let mut file = Vec::new();
    assert!(matches!(write_state_space(&mut file, &discrete, Format::Json), Err(FileError::Empty)));
    assert!(file.is_empty());
}
