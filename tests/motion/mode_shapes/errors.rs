//! Questions that have no answer.

use crate::mode_shapes::checks::first;
use crate::mode_shapes::models::{Oscillator, Star3};
use crate::mode_shapes::single_beams::*;
use mstmm::motion::{ModeShape, MotionError};
use mstmm::prelude::*;

/// The error of a shape.
fn error<Y: mstmm::motion::Tree<S> + ?Sized, S: mstmm::number::Single>(
    shape: Result<ModeShape<'_, Y, S>, MotionError>,
) -> MotionError {
    shape.err().unwrap()
}

#[test]
fn a_multiple_root_has_not_one_shape() {
    let system = Star3 { l1: 1.0, l2: 1.0, l3: 1.0 }.build().unwrap();
    let root = *first::<10>(&system).iter().find(|root| root.multiplicity == 2).unwrap();
    assert_eq!(error(system.mode_shape(&root)), MotionError::Multiple { root: root.omega, multiplicity: 2 });
    assert_eq!(system.mode_shapes::<1, _>(&root).err(), Some(MotionError::Capacity { capacity: 1 }));
    assert_eq!(system.mode_shapes::<0, _>(&root).err(), Some(MotionError::Capacity { capacity: 0 }));
    let simple = *first::<10>(&system).iter().find(|root| root.multiplicity == 1).unwrap();
    assert_eq!(system.mode_shapes::<0, _>(&simple).err(), Some(MotionError::Capacity { capacity: 0 }));
    assert_eq!(system.mode_shapes::<1, _>(&simple).unwrap().iter().count(), 1);
}

#[test]
fn a_frequency_between_roots_is_none() {
    let system = Cantilever { l: 1.0, ei: 2.0, m: 3.0 }.build().unwrap();
    for root in &first::<100>(&system) {
        for factor in [0.9, 1.0 - 1e-4, 1.0 + 1e-4, 1.001, 1.1] {
            let omega = root.omega * factor;
            let moved = NaturalFrequency { omega, ..*root };
            let found = error(system.mode_shape(&moved));
            assert!(
                matches!(found, MotionError::NotARoot { frequency, .. } if frequency == omega),
                "{moved:?}: {found:?}"
            );
        }
    }
    for omega in [f64::NAN, f64::INFINITY] {
        let root =
            NaturalFrequency { omega, lower: omega, upper: omega, multiplicity: 1, ..NaturalFrequency::default() };
        assert!(matches!(error(system.mode_shape(&root)), MotionError::NotFinite { .. }), "{omega}");
    }
    let lambda = Complex::new(-0.1, f64::NAN);
    let system = Oscillator { k: 1.0, c: 0.1, m: 1.0 }.build().unwrap();
    let root = Eigenvalue { lambda, multiplicity: 1, ..Eigenvalue::default() };
    assert!(matches!(error(system.mode_shape(&root)), MotionError::NotFinite { .. }));
}

/// A frequency of another system, or a root said to be multiple that is not, or the other way round.
#[test]
fn wrong_multiplicities_are_noticed() {
    let system = Cantilever { l: 1.0, ei: 2.0, m: 3.0 }.build().unwrap();
    let root = NaturalFrequency { multiplicity: 2, ..first::<3>(&system)[2] };
    let found = system.mode_shapes::<4, _>(&root).err();
    assert!(matches!(found, Some(MotionError::Defective { multiplicity: 2, shapes: 1, .. })), "{found:?}");
    let between = NaturalFrequency { omega: root.omega * 1.1, ..root };
    let found = system.mode_shapes::<4, _>(&between).err();
    assert!(found.is_some(), "a double root where there is none");
    for omega in [f64::NAN, f64::INFINITY] {
        let root = NaturalFrequency { omega, ..root };
        assert!(matches!(system.mode_shapes::<4, _>(&root).err(), Some(MotionError::NotFinite { .. })), "{omega}");
    }
}

/// Oracle: at critical damping λ = -C/2m is double and has one shape.
#[test]
fn critical_damping_is_defective() {
    for (k, m) in [(4.0, 1.0), (3.0, 0.7), (1e7, 0.3), (0.02, 11.0), (5.0, 3e-9)] {
        let c = 2.0 * f64::sqrt(k * m);
        let system = Oscillator { k, c, m }.build().unwrap();
        // a pair where the rounding of C has split them off the real axis, of which one is above it
        let roots = system.eigenvalues::<2>(Region { re: -c / m..=0.0, im: -c / m..=c / m }).unwrap();
        // two roots where it has split them along the axis, each with the shape of the one
        let Some(root) = roots.iter().find(|root| root.multiplicity == 2) else { continue };
        assert!((root.lambda + c / (2.0 * m)).norm() < 1e-6 * root.lambda.norm(), "{root:?}");
        assert!(matches!(error(system.mode_shape(root)), MotionError::Multiple { multiplicity: 2, .. }));
        let found = system.mode_shapes::<4, _>(root).err();
        assert!(matches!(found, Some(MotionError::Defective { multiplicity: 2, shapes: 1, .. })), "{k} {m}: {found:?}");
        println!("{root:?}");
    }
}

#[test]
fn places_outside_are_refused() {
    let system = Stepped { l1: 1.0, ei1: 1.0, l2: 0.7, ei2: 2.0 }.build().unwrap();
    let shape_root = first::<1>(&system)[0];
    let shape = system.mode_shape(&shape_root).unwrap();
    for distance in [-1e-300, 0.7 + 1e-15, 2.0, f64::INFINITY, f64::NEG_INFINITY] {
        let found = shape.along(Stepped::beam_2, distance).err();
        assert_eq!(found, Some(MotionError::Outside { distance, length: 0.7 }));
    }
    assert!(shape.along(Stepped::beam_2, f64::NAN).is_err());
    for (place, end) in [(0.0, Stepped::beam_2.input()), (0.7, Stepped::beam_2.output())] {
        let (along, state) = (shape.along(Stepped::beam_2, place).unwrap(), shape.state(end));
        assert!((along.y - state.y).abs() <= 1e-13 && (along.theta - state.theta).abs() <= 1e-13);
    }
    let system = FiveMasses { k: 1.0, m: 1.0 }.build().unwrap();
    let root = first::<1>(&system)[0];
    let shape = system.mode_shape(&root).unwrap();
    let found = shape.along(FiveMasses::spring_1, 0.0).err();
    assert_eq!(found, Some(MotionError::NoInside));
}

/// Nothing deflects where all turns: no deflection is the unit.
#[test]
fn a_shaft_has_no_largest_deflection() {
    let system = FourDiscs { k: 1.0, j: 1.0 }.build().unwrap();
    let root = first::<2>(&system)[1];
    assert!(system.mode_shape(&root).unwrap().with_unit_deflection().is_none());
}
