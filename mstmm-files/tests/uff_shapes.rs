//! Written datasets 15, 82 and 55 against the columns that their formats ask for, field by field, and their values against closed forms.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod support;

use mstmm::prelude::*;
use mstmm_files::{FileError, Geometry, Mode, write_uff15, write_uff55, write_uff82};
use std::slice::Iter;
use support::columns::{integer, integers, real, reals};
use support::mast::{HEIGHT, first_hertz, first_shape, modes};
use support::{MODEL, complex_mode};

/// What is written to a file.
fn written(write: impl FnOnce(&mut Vec<u8>) -> Result<(), FileError>) -> Result<String, FileError> {
    let mut file = Vec::new();
    let result = write(&mut file);
    assert!(result.is_ok() || file.is_empty());
    result.map(|()| String::from_utf8(file).unwrap())
}

/// The records of the datasets of a number.
fn datasets(file: &str, number: i64) -> Vec<Vec<&str>> {
    let mut datasets = Vec::new();
    let mut lines = file.lines();
    while let Some(start) = lines.next() {
        assert_eq!(start, "    -1");
        assert_eq!(integers(lines.next().unwrap(), 6), [number]);
        datasets.push(lines.by_ref().take_while(|line| *line != "    -1").collect());
    }
    datasets
}

/// Six digits.
fn is_near(read: f64, exact: f64) -> bool {
    (read - exact).abs() <= 0.5e-5 * exact.abs() + 1e-12
}

/// A dataset 55 as it is read: a mode by the fields of its head, and the values of each node.
struct Shape<'f> {
    texts: [&'f str; 2],
    head: Vec<i64>,
    integers: Vec<i64>,
    reals: Vec<f64>,
    nodes: Vec<Vec<f64>>,
}

fn shape<'f>(records: &[&'f str]) -> Shape<'f> {
    let mut records: Iter<'_, &'f str> = records.iter();
    let mut next = || *records.next().unwrap();
    let texts = [0; 5].map(|_| next());
    assert!(texts.iter().all(|text| text.len() == 80));
    assert!(texts[2..].iter().all(|text| text.trim_end() == "NONE"));
    let (head, integers_of_mode, reals_of_mode) = (integers(next(), 10), integers(next(), 10), reals(next()));
    // the counts of both records
    assert_eq!(integers_of_mode[..2], [integers_of_mode.len() as i64 - 2, reals_of_mode.len() as i64]);
    let values = head[5] as usize * if head[4] == 5 { 2 } else { 1 };
    let mut nodes = Vec::new();
    while let Some(node) = records.next() {
        nodes.push(Vec::new());
        assert_eq!(integers(node, 10), [nodes.len() as i64]);
        let numbers = nodes.last_mut().unwrap();
        while numbers.len() < values {
            let record = reals(records.next().unwrap());
            assert_eq!(record.len(), 6.min(values - numbers.len()));
            numbers.extend(record);
        }
    }
    let texts = [texts[0].trim_end(), texts[1].trim_end()];
    Shape { texts, head, integers: integers_of_mode, reals: reals_of_mode, nodes }
}

#[test]
fn nodes_stand_in_their_columns() {
    let mut geometry = Geometry::default();
    geometry.add_line("a", [[-1.5, 1e-9, 123_456.7], [0.0, 1e-120, -9.999_999]]);
    let file = written(|file| write_uff15(file, &geometry)).unwrap();
    let records = &datasets(&file, 15)[0];
    let expected = [[-1.5, 1e-9, 123_457.0], [0.0, 0.0, -10.0]];
    assert_eq!(records.len(), 2);
    for (index, (record, place)) in records.iter().zip(expected).enumerate() {
        let mut line = *record;
        let head = [0; 4].map(|_| integer(&mut line, 10));
        assert_eq!(head, [index as i64 + 1, 0, 0, 0]);
        assert_eq!([0; 3].map(|_| real(&mut line, 13)), place);
        assert_eq!(line, "");
    }
}

#[test]
fn trace_lines_stand_in_their_columns() {
    let (lines, _) = modes(1);
    let file = written(|file| write_uff82(file, lines.geometry())).unwrap();
    let traces = datasets(&file, 82);
    assert_eq!(traces.len(), 2);
    for (index, records) in traces.iter().enumerate() {
        assert_eq!(integers(records[0], 10), [index as i64 + 1, 20, 0]);
        assert_eq!(records[1], format!("{:<80}", format!("member {index}")));
        let counts: Vec<usize> = records[2..].iter().map(|record| integers(record, 10).len()).collect();
        assert_eq!(counts, [8, 8, 4]);
        let nodes: Vec<i64> = records[2..].iter().flat_map(|record| integers(record, 10)).collect();
        assert_eq!(nodes, (1..=20).map(|node| node + 20 * index as i64).collect::<Vec<_>>());
    }
}

/// Each piece begins where the one before ends; none has one node.
#[test]
fn long_lines_are_several_trace_lines() {
    for count in [2, 249, 250, 251, 499, 500, 750] {
        let mut geometry = Geometry::default();
        geometry.add_line("", (0..count).map(|k| [f64::from(k), 0.0, 0.0]));
        let file = written(|file| write_uff82(file, &geometry)).unwrap();
        let mut segments = Vec::new();
        for (index, records) in datasets(&file, 82).into_iter().enumerate() {
            let nodes: Vec<i64> = records[2..].iter().flat_map(|record| integers(record, 10)).collect();
            assert_eq!(integers(records[0], 10), [index as i64 + 1, nodes.len() as i64, 0]);
            assert!((2..=250).contains(&nodes.len()), "{count}");
            segments.extend(nodes.windows(2).map(|pair| [pair[0], pair[1]]));
        }
        let expected: Vec<[i64; 2]> = (1..i64::from(count)).map(|node| [node, node + 1]).collect();
        assert_eq!(segments, expected, "{count}");
    }
}

/// Closed form: a cantilever.
#[test]
fn normal_modes_are_those_of_the_model() {
    let (lines, modes) = modes(3);
    let file = written(|file| write_uff55(file, "a mast", lines.geometry(), modes)).unwrap();
    let sets = datasets(&file, 55);
    assert_eq!(sets.len(), 3);
    let first = shape(&sets[0]);
    assert_eq!(first.texts, ["a mast", &format!("mode 1 ({:.4} Hz)", first_hertz())]);
    // structural, normal mode, six freedoms, displacements, real
    assert_eq!((first.head, first.integers), (vec![1, 2, 3, 8, 2, 6], vec![2, 4, 1, 1]));
    assert!(is_near(first.reals[0], first_hertz()));
    assert_eq!(first.reals[1..], [1.0, 0.0, 0.0]);
    assert_eq!(first.nodes.len(), 40);
    let sign = first.nodes[19][1].signum();
    for (k, values) in first.nodes.iter().take(20).enumerate() {
        let (height, step) = (HEIGHT * k as f64 / 19.0, 1e-4);
        // along y it moves, about -x it turns
        let slope = (first_shape(height + step) - first_shape(height - step)) / (2.0 * step);
        assert!(is_near(sign * values[1], first_shape(height)), "{values:?}");
        assert!((sign * values[3] + slope).abs() < 1e-6, "{values:?} {slope}");
    }
    assert_eq!(shape(&sets[2]).integers, [2, 4, 1, 3]);
}

/// Closed form: the residue of the response of an oscillator is `φ²/a = 1/(2 i m Im λ)`.
#[test]
fn complex_modes_have_eigenvalues_and_modal_constants() {
    let (geometry, mode) = complex_mode();
    let file = written(|file| write_uff55(file, "", &geometry, [mode])).unwrap();
    let read = shape(&datasets(&file, 55)[0]);
    assert_eq!(read.texts[0], "NONE");
    assert_eq!((read.head, read.integers), (vec![1, 3, 2, 8, 5, 3], vec![2, 6, 1, 1]));
    let (re, im) = (-1.0, 399.0_f64.sqrt());
    assert!(is_near(read.reals[0], re) && is_near(read.reals[1], im));
    let [lambda, a, b] = [0, 2, 4].map(|k| Complex::new(read.reals[k], read.reals[k + 1]));
    let shape = Complex::new(read.nodes[1][2], read.nodes[1][3]);
    let residue = Complex::new(0.0, 2.0 * MODEL.m * im).inv();
    assert!((shape * shape / a - residue).norm() < 5e-5 * residue.norm());
    // at a root both sum up to nothing: b + λ a = 0
    assert!((b + lambda * a).norm() < 5e-5 * b.norm());
    assert_eq!(read.nodes[0], [0.0; 6]);
}

/// Twelve numbers for each node are two records; a normal mode may have a complex shape, and a mass.
#[test]
fn six_complex_values_are_two_records() {
    let mut geometry = Geometry::default();
    geometry.add_line("a", [[0.0; 3], [1.0; 3]]);
    let vector = [1, 2, 3, 4, 5, 6].map(|k| Complex::new(f64::from(k), -0.5));
    let root = NaturalFrequency { omega: 2.0, ..NaturalFrequency::default() };
    let mode = Mode::from(root).with_vectors([vector; 2]).with_modal_mass(2.5).named("sway");
    let read = written(|file| write_uff55(file, "x", &geometry, [mode])).unwrap();
    let read = shape(&datasets(&read, 55)[0]);
    assert_eq!((read.texts, read.head), (["x", "sway"], vec![1, 2, 3, 8, 5, 6]));
    assert_eq!(read.reals[1], 2.5);
    assert_eq!(read.nodes[1], [1.0, -0.5, 2.0, -0.5, 3.0, -0.5, 4.0, -0.5, 5.0, -0.5, 6.0, -0.5]);
}

#[test]
fn what_does_not_fit_is_refused_before_anything_is_written() {
    let root = NaturalFrequency { omega: 2.0, ..NaturalFrequency::default() };
    let mut geometry = Geometry::default();
    geometry.add_line("a", [[0.0; 3], [1.0; 3]]);
    let shape = || Mode::from(root).with_vectors([[1.0; 3]; 2]);
    let refused = |modes: Vec<Mode>| written(|file| write_uff55(file, "", &geometry, modes)).unwrap_err();
    assert!(matches!(refused(vec![]), FileError::NoModes));
    assert!(matches!(refused(vec![shape(), Mode::from(root)]), FileError::Vectors { row: 1, values: 0, points: 2 }));
    let not_finite = refused(vec![shape(), shape().with_modal_mass(f64::NAN)]);
    assert!(matches!(not_finite, FileError::NotFinite { row: 1 }), "{not_finite}");
    assert!(matches!(refused(vec![shape().with_modal_mass(1e100)]), FileError::Columns { .. }));
    assert!(matches!(refused(vec![shape().named("µ")]), FileError::Text { columns: 80, .. }));

    let mut other = geometry.clone();
    other.lines[0].name = "x".repeat(81);
    let long = written(|file| write_uff82(file, &other)).unwrap_err();
    assert!(matches!(long, FileError::Text { columns: 80, .. }), "{long}");
    other.lines.clear();
    assert!(matches!(written(|file| write_uff82(file, &other)), Err(FileError::NoLines)));
    other.points[1][0] = 1e100;
    assert!(matches!(written(|file| write_uff15(file, &other)), Err(FileError::Columns { .. })));
    other.points[1][0] = f64::NAN;
    assert!(matches!(written(|file| write_uff15(file, &other)), Err(FileError::Place { point: 1 })));
    assert!(matches!(written(|file| write_uff15(file, &Geometry::default())), Err(FileError::NoPoints)));
}
