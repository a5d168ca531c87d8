//! Sketches in space beside frames that the program describes.
#![expect(clippy::unwrap_used, reason = "a structure that cannot be built fails the test")]

mod directions;
mod one_thing;
mod overall;
mod portal;
mod workshop;

use mstmm::prelude::*;
use mstmm::search::Undamped;

/// The first frequencies, each as often as it is there; all are proven.
fn proven<const N: usize, Y: NaturalFrequencies<Parameter = f64> + Undamped>(system: &Y) -> Vec<f64> {
    let found = system.first_frequencies::<N>().unwrap();
    assert!(found.iter().all(|own| own.is_proven));
    found.iter().flat_map(|own| std::iter::repeat_n(own.omega, own.multiplicity as usize)).collect()
}

/// Numbers agree up to a relative difference.
#[track_caller]
fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (own, other) in found.iter().zip(expected) {
        assert!((own - other).abs() <= tolerance * other.abs(), "{found:?}\n{expected:?}");
    }
}
