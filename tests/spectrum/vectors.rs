//! Searches whose number of results is known when the program runs, into vectors: the same roots, certificates and errors as those into lists
//! of fixed capacity, and none of them is lost where there are many.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use core::f64::consts::{FRAC_PI_2, PI};
use mstmm::element::Support;
use mstmm::elements::{Mass, Spring};
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;
use mstmm::search::{SearchError, System};

system! {
    /// A string that ends in a dashpot.
    struct Dashed { length: f64, tension: f64, m: f64, c: f64 }
    fixed -> string 1 { length, tension, mass_per_length: m, foundation_stiffness: 0.0 } -> conn 2 -> free;
    fixed -> damper 3 { damping: c } -> conn 2;
}

system! {
    /// A frame with a brace, whose loops are closed.
    struct Braced { height: f64, ea: f64, ei: f64, m: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> conn a at (0.0, height) -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> conn b at (1.5, height);
    fixed at (1.5, 0.0) -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b;
    conn a -> beam 4 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pinned at (1.5, 0.5);
}

system! {
    /// Three equal masses on springs below a beam: two modes in which the beam rests coincide.
    struct Triplets { length: f64, k: f64 }
    fixed -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
          -> beam 3 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
    conn 2 <- spring 4 { stiffness: k } <- mass 5 { mass: 1.0 } <- free;
    conn 2 <- spring 6 { stiffness: k } <- mass 7 { mass: 1.0 } <- free;
    conn 2 <- spring 8 { stiffness: k } <- mass 9 { mass: 1.0 } <- free;
}

/// Vectors have what lists have, bit by bit.
fn assert_same_as_lists<Y: Undamped + Spectrum + System<Parameter = f64>>(system: &Y, end: f64) {
    let first = system.first_frequencies::<7>().unwrap();
    assert_eq!(system.frequencies(7).unwrap(), first[..]);
    let all = system.natural_frequencies::<64>(0.0..=end).unwrap();
    assert!(!all.is_empty());
    assert_eq!(system.frequencies_in(0.0..=end).unwrap(), all[..]);
    let region = Region { re: -1.0..=1.0, im: -end..=end };
    let eigenvalues = system.eigenvalues::<128>(region.clone()).unwrap();
    assert!(eigenvalues.len() >= all.len());
    assert_eq!(system.eigenvalues_in(region).unwrap(), eigenvalues[..]);
}

#[test]
fn vectors_hold_what_lists_hold() {
    let frame = Braced { height: 1.0, ea: 4e3, ei: 1.0, m: 1.0 }.build().unwrap();
    assert_same_as_lists(&frame, 120.0);
    let triplets = Triplets { length: 0.5, k: 40.0 }.build().unwrap();
    assert_same_as_lists(&triplets, 200.0);
    assert!(triplets.frequencies(3).unwrap().iter().any(|root| root.multiplicity == 2));
}

/// A chain of equal masses between equal springs, fixed at one end: `ω = 2 sin((2k - 1)π/(4n + 2))`.
fn chain(masses: u32) -> Vec<ListStep<AnyUndamped<f64>>> {
    let mut steps = vec![ListStep::Tip(Support::Fixed)];
    for _ in 0..masses {
        steps.push(ListStep::Element(Spring { stiffness: 1.0 }.try_into().unwrap()));
        steps.push(ListStep::Element(Mass { mass: 1.0 }.try_into().unwrap()));
    }
    steps.push(ListStep::Root(Support::Free));
    steps
}

/// Closed form, for more frequencies than any list in the library has room for.
#[test]
fn a_vector_holds_as_many_frequencies_as_there_are() {
    let steps = chain(150);
    let system = StepList::new(&steps).unwrap();
    let exact = |k: usize| 2.0 * ((2 * k + 1) as f64 * PI / 602.0).sin();
    let lowest = system.frequencies(150).unwrap();
    assert_eq!(lowest.len(), 150);
    for (k, root) in lowest.iter().enumerate() {
        assert!((root.omega - exact(k)).abs() < 1e-13, "{k}: {root}");
        assert!(root.lower <= exact(k) + 1e-14 && exact(k) - 1e-14 <= root.upper, "{k}: {root:?}");
    }
    let above = lowest.iter().filter(|root| root.omega >= 0.5);
    let found = system.frequencies_in(0.5..=3.0).unwrap();
    assert_eq!(found.len(), above.clone().count());
    // from another start rounding may end elsewhere in the intervals
    assert!(found.iter().zip(above).all(|(one, other)| one.lower < other.upper && other.lower < one.upper));
}

/// Closed form: `tanh(λl/v) = -Z/c` with `v = sqrt(T/m)` and `Z = sqrt(T m)`. A search into a list has room for 256 eigenvalues.
#[test]
fn a_vector_holds_as_many_eigenvalues_as_there_are() {
    let (length, tension, m, c) = (2.0, 8.0, 0.5, 0.7);
    let system = Dashed { length, tension, m, c }.build().unwrap();
    let (speed, impedance) = ((tension / m).sqrt(), (tension * m).sqrt());
    let re = 0.5 * ((impedance - c) / (impedance + c)).ln() * speed / length;
    let gap = PI * speed / length;
    let region = Region { re: -10.0..=1.0, im: 0.1..=270.0 * gap };
    assert_eq!(system.eigenvalues::<512>(region.clone()).unwrap_err(), SearchError::Capacity { capacity: 256 });
    let found = system.eigenvalues_in(region).unwrap();
    assert_eq!(found.len(), 270);
    for (k, root) in found.iter().enumerate() {
        let exact = Complex::new(re, (k as f64 * PI + FRAC_PI_2) * speed / length);
        assert!((root.lambda - exact).norm() <= root.error + 1e-15 * exact.norm(), "{k}: {root:?} {exact}");
    }
}

#[test]
fn errors_carry_numbers() {
    let steps = chain(2);
    let system = StepList::new(&steps).unwrap();
    let error = system.frequencies(5).unwrap_err();
    assert_eq!(error, SearchError::TooFewRoots { found: 2, wanted: 5 });
    assert_eq!(Err(error), system.first_frequencies::<5>().map(|found| found.len()));
    assert!(error.to_string().starts_with("the system has 2 frequencies, 5 were asked for"), "{error}");
    assert_eq!(system.frequencies_in(3.0..=1.0).unwrap_err(), SearchError::Range { start: 3.0, end: 1.0 });
    let region = Region { re: 1.0..=0.0, im: 0.0..=1.0 };
    assert_eq!(system.eigenvalues_in(region).unwrap_err(), SearchError::Range { start: 1.0, end: 0.0 });
    assert_eq!(system.frequencies(0).unwrap(), []);
    assert_eq!(system.frequencies_in(5.0..=6.0).unwrap(), []);
    let error = system.frequencies(usize::MAX).unwrap_err();
    assert_eq!(error, SearchError::TooFewRoots { found: 2, wanted: usize::MAX as u64 });
}
