//! A written dataset 58 against the columns that its format asks for, field by field, and its values against a closed form.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod support;

use mstmm::prelude::Complex;
use mstmm_files::{FileError, Function, write_uff58};
use std::f64::consts::TAU;
use support::columns::{integer, real, text};
use support::{exact, file, head, samples};

/// `I10, 3I5, 2(1X, 20A1)`
fn axis(mut line: &str) -> (i64, &str, &str) {
    let line = &mut line;
    let kind = integer(line, 10);
    assert_eq!([integer(line, 5), integer(line, 5), integer(line, 5)], [0; 3]);
    let (label, unit) = (text(line, 20), text(line, 20));
    assert_eq!(*line, "");
    (kind, label, unit)
}

#[test]
fn every_record_stands_in_its_columns() {
    let (file, samples) = (file(), samples());
    let mut lines = file.lines();
    let mut next = || lines.next().unwrap();
    assert_eq!([next(), next()], ["    -1", "    58"]);
    assert_eq!(next(), format!("{:<80}", "mass on a spring and a dashpot"));
    for _ in 0..4 {
        assert_eq!(next(), format!("{:<80}", "NONE"));
    }
    let degrees = &mut next();
    // a frequency response function of one load
    assert_eq!([integer(degrees, 5), integer(degrees, 10), integer(degrees, 5), integer(degrees, 10)], [4, 0, 0, 0]);
    for (node, direction) in [(12, 2), (4_000_000_000, 6)] {
        assert_eq!((text(degrees, 10), integer(degrees, 10), integer(degrees, 4)), ("NONE", node, direction));
    }
    assert_eq!(*degrees, "");
    let form = &mut next();
    // complex double precision, uneven
    assert_eq!([integer(form, 10), integer(form, 10), integer(form, 10)], [6, samples.len() as i64, 0]);
    assert_eq!([real(form, 13), real(form, 13), real(form, 13)], [0.0; 3]);
    assert_eq!(*form, "");
    assert_eq!(axis(next()), (18, "Frequency", "Hz"));
    assert_eq!(axis(next()), (8, "Displacement", "m"));
    assert_eq!(axis(next()), (13, "Force", "N"));
    assert_eq!(axis(next()), (0, "NONE", "NONE"));
    for (omega, _) in samples {
        let line = &mut next();
        let (hertz, value) = (real(line, 13), Complex::new(real(line, 20), real(line, 20)));
        assert_eq!(*line, "");
        assert!((hertz * TAU - omega).abs() <= 0.6e-7 * omega, "{hertz} {omega}");
        let expected = exact(omega);
        assert!((value - expected).norm() < 1e-11 * expected.norm(), "{omega}: {value} {expected}");
    }
    assert_eq!(next(), "    -1");
    assert_eq!(lines.next(), None);
}

#[test]
fn what_does_not_fit_is_refused_before_anything_is_written() {
    let refused = |function: &Function<'_>, samples: &[(f64, f64)]| {
        let mut file = Vec::new();
        let error = write_uff58(&mut file, function, samples.iter().copied()).unwrap_err();
        assert!(file.is_empty());
        error
    };
    let head = head();
    assert!(matches!(refused(&head, &[]), FileError::Empty));
    assert!(matches!(refused(&head, &[(1.0, 1.0), (2.0, f64::NAN)]), FileError::NotFinite { row: 1 }));
    assert!(matches!(refused(&head, &[(f64::INFINITY, 1.0)]), FileError::NotFinite { row: 0 }));
    assert!(matches!(refused(&head, &[(-1.0, 1.0)]), FileError::Negative { row: 0, omega: -1.0 }));
    assert!(matches!(refused(&head, &[(2.0, 1.0), (1.0, 1.0)]), FileError::Order { row: 1, .. }));
    // apart, but not in eight digits
    assert!(matches!(refused(&head, &[(2.0, 1.0), (2.0 + 1e-9, 1.0)]), FileError::Order { row: 1, .. }));
    assert!(matches!(refused(&head, &[(2.0, 1e100)]), FileError::Columns { value: 1e100 }));
    let long = "x".repeat(81);
    assert!(matches!(
        refused(&Function { description: &long, ..head }, &[(1.0, 1.0)]),
        FileError::Text { columns: 80, .. }
    ));
    let mut greek = head;
    greek.ordinate.unit = "μm";
    assert!(matches!(refused(&greek, &[(1.0, 1.0)]), FileError::Text { columns: 20, .. }));
}

/// A writer that has no room.
#[test]
fn a_writer_that_fails_says_so() {
    let mut room = [0_u8; 100];
    let error = write_uff58(&mut room[..], &head(), samples()).unwrap_err();
    assert!(matches!(error, FileError::Io(_)), "{error}");
}
