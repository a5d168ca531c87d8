//! Written tables, read back.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod support;

use mstmm::prelude::*;
use mstmm_files::{FileError, Mode, write_modes, write_response};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use support::{MODEL, Oscillator, exact, samples};

/// The columns of a table by their names.
fn columns(table: &[u8]) -> BTreeMap<String, Vec<f64>> {
    let mut reader = csv::Reader::from_reader(table);
    let names: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let mut columns: BTreeMap<String, Vec<f64>> = names.iter().map(|name| (name.clone(), Vec::new())).collect();
    for row in reader.records() {
        for (name, field) in names.iter().zip(&row.unwrap()) {
            columns.get_mut(name).unwrap().push(field.parse().unwrap());
        }
    }
    columns
}

#[test]
fn a_response_is_read_back_bit_by_bit() {
    let (mut table, samples) = (Vec::new(), samples());
    write_response(&mut table, samples.iter().copied()).unwrap();
    let columns = columns(&table);
    assert_eq!(columns.len(), 6);
    for (row, (omega, value)) in samples.into_iter().enumerate() {
        let of = |name: &str| columns[name][row];
        assert_eq!(of("angular_frequency_rad_per_s"), omega);
        assert_eq!(Complex::new(of("real"), of("imaginary")), value);
        assert!((of("frequency_hz") * TAU - omega).abs() <= 1e-15 * omega);
        let expected = exact(omega);
        let polar = Complex::from_polar(of("magnitude"), of("phase_deg").to_radians());
        assert!((polar - expected).norm() < 1e-12 * expected.norm(), "{polar} {expected}");
    }
}

/// Closed form: `λ = -c/2m ± i sqrt(k/m - (c/2m)²)`.
#[test]
fn modes_are_read_back() {
    let (system, mass) = (MODEL.build().unwrap(), Oscillator::mass_2.output());
    let roots = system.eigenvalues_in(Region { re: -10.0..=0.0, im: 0.1..=100.0 }).unwrap();
    let modes = roots.iter().map(|root| {
        let shape = system.mode_shape(root).unwrap();
        Mode::from(*root).with_shape([shape.state(mass).y, Complex::new(0.25, -0.5)])
    });
    let mut table = Vec::new();
    write_modes(&mut table, &["mass", "a, \"b\""], modes).unwrap();
    let columns = columns(&table);
    let of = |name: &str| columns[name].clone();
    let (re, im) = (-1.0, 399.0_f64.sqrt());
    assert_eq!((of("mode"), of("multiplicity")), (vec![1.0], vec![1.0]));
    assert!((of("real_1_per_s")[0] - re).abs() < 1e-13 && (of("imaginary_rad_per_s")[0] - im).abs() < 1e-13);
    assert!((of("damping_ratio")[0] - 0.05).abs() < 1e-15 && (of("frequency_hz")[0] - im / TAU).abs() < 1e-14);
    assert!(of("error_rad_per_s")[0] > 0.0 && of("error_rad_per_s")[0] < 1e-12);
    let shape = system.mode_shape(&roots[0]).unwrap().state(mass).y;
    assert_eq!((of("mass_real")[0], of("mass_imaginary")[0]), (shape.re, shape.im));
    // names with commas and quotes stay one column
    assert_eq!((of("a, \"b\"_real"), of("a, \"b\"_imaginary")), (vec![0.25], vec![-0.5]));
}

#[test]
fn natural_frequencies_have_no_damping() {
    let root = NaturalFrequency { omega: 3.0, lower: 2.5, upper: 3.25, multiplicity: 2, ..NaturalFrequency::default() };
    let mut table = Vec::new();
    write_modes(&mut table, &[], [root, NaturalFrequency { omega: 0.0, ..root }]).unwrap();
    let columns = columns(&table);
    assert_eq!(columns["damping_ratio"], [0.0, 0.0]);
    assert_eq!(columns["error_rad_per_s"], [0.5, 3.25]);
    assert_eq!(columns["imaginary_rad_per_s"], [3.0, 0.0]);
    assert_eq!(columns["multiplicity"], [2.0, 2.0]);
}

#[test]
fn what_is_no_table_is_refused() {
    let write = |samples: &[(f64, f64)]| write_response(Vec::new(), samples.iter().copied()).unwrap_err();
    assert!(matches!(write(&[]), FileError::Empty));
    assert!(matches!(write(&[(1.0, 1.0), (f64::NAN, 1.0)]), FileError::NotFinite { row: 1 }));
    let root = NaturalFrequency { omega: 3.0, lower: 3.0, upper: 3.0, multiplicity: 1, ..NaturalFrequency::default() };
    let modes = |points: &[&str], mode: Mode| write_modes(Vec::new(), points, [mode]).unwrap_err();
    let shape = modes(&["a", "b"], Mode::from(root).with_shape([1.0]));
    assert!(matches!(shape, FileError::Shape { row: 0, values: 1, points: 2 }), "{shape}");
    assert!(matches!(modes(&["a"], Mode::from(root).with_shape([f64::NAN])), FileError::NotFinite { row: 0 }));
}
