//! Limit cases of the beam.

use super::*;
use crate::number::assert_close;

#[test]
fn what_leaves_the_range_with_its_products_is_refused_by_name() {
    let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    let error = Beam { bending_stiffness: 1e-160, ..beam }.build().unwrap_err();
    assert_eq!((error.parameter, error.requirement), ("bending_stiffness", Requirement::Rescale));
    assert_eq!(Beam { length: 1e-100, ..beam }.build().unwrap_err().parameter, "length");
    assert!(Beam { length: 1e-9, bending_stiffness: 1e-25, mass_per_length: 1e-15 }.build().is_ok());
}

/// Cubic deflection of a static cantilever under a unit tip force and a unit tip moment.
#[test]
fn at_rest_it_is_the_static_beam() {
    let (l, ei) = (2.0_f64, 5.0);
    let beam = Beam { length: l, bending_stiffness: ei, mass_per_length: 3.0 }.build().unwrap();
    let u = Beam::transfer_matrix(&beam, 0.0);
    let expected = [
        [1.0, l, l * l / (2.0 * ei), l.powi(3) / (6.0 * ei)],
        [0.0, 1.0, l / ei, l * l / (2.0 * ei)],
        [0.0, 0.0, 1.0, l],
        [0.0, 0.0, 0.0, 1.0],
    ];
    for (row, values) in expected.iter().enumerate() {
        for (column, &value) in values.iter().enumerate() {
            assert_close(u[(row, column)], value, value.abs(), 4.0);
        }
    }
}
