//! The string takes part in models by its path and gives the frequencies of the textbook.

use cable::Cable;
use core::f64::consts::PI;
use mstmm::prelude::*;
use mstmm::search::SearchError;

system! {
    /// A string between two walls.
    #[derive(Debug)]
    pub struct TautString {
        /// Length [m]
        pub length: f64,
        /// Tension [N]
        pub tension: f64,
        /// Mass per length [kg/m]
        pub mass_per_length: f64,
    }

    fixed -> cable::Cable 1 { length, tension, mass_per_length } -> fixed;
}

system! {
    /// A mass at the middle of a string; the two halves meet at a connection, the mass hangs on as a third path.
    struct LoadedString { length: f64, tension: f64, mass_per_length: f64, mass: f64 }

    fixed -> Cable2::Half 1 { length: length / 2.0, tension, mass_per_length } -> conn 2 -> Cable2::Half 3 {
        length: length / 2.0, tension, mass_per_length
    } -> fixed;
    free -> mass 4 { mass } -> conn 2;
}

/// A path with `::` need not be the original one.
#[allow(non_snake_case)]
mod Cable2 {
    pub(crate) use crate::Cable as Half;
}

system! {
    /// A beam held by a string, written before the beam that it joins: the wider state still comes first.
    struct HeldBeam { ei: f64, m: f64, tension: f64, string_mass: f64 }

    fixed -> cable::Cable 3 { length: 1.0, tension, mass_per_length: string_mass } -> conn 2;
    fixed -> beam 1 { length: 1.0, bending_stiffness: ei, mass_per_length: m } -> conn 2 -> free;
}

fn frequencies(determinant: impl FnMut(f64) -> f64, end: f64) -> Result<Vec<f64>, SearchError> {
    let minima = fmin1d::<16, _>(determinant, 1e-3..=end, 400, 1e-10)?;
    Ok(minima.iter().filter(|minimum| !minimum.at_end).map(|minimum| minimum.x).collect())
}

#[test]
fn a_string_between_walls_vibrates_at_multiples_of_its_first_frequency() {
    let string = TautString { length: 2.0, tension: 50.0, mass_per_length: 0.02 };
    let system = string.build().unwrap();
    assert_eq!(TautStringSystem::N, 2);
    let first = PI / string.length * (string.tension / string.mass_per_length).sqrt();
    let found = frequencies(|omega| system.overall_determinant(omega).value(), 5.5 * first).unwrap();
    assert_eq!(found.len(), 5);
    for (k, omega) in (1..).zip(found) {
        // the search stops in cells of 1e-10 rad/s; the root itself is exact to a few eps
        assert!((omega - f64::from(k) * first).abs() < 1e-10 + 8.0 * f64::EPSILON * omega, "mode {k}: {omega}");
    }
}

#[test]
fn its_frequencies_are_certified_to_the_hundredth() {
    let string = TautString { length: 2.0, tension: 50.0, mass_per_length: 0.02 };
    let system = string.build().unwrap();
    let first = PI / string.length * (string.tension / string.mass_per_length).sqrt();
    let found = system.natural_frequencies::<100>(0.0..=100.5 * first).unwrap();
    assert_eq!(found.len(), 100);
    for (k, root) in (1..).zip(&found) {
        let exact = f64::from(k) * first;
        // `exact` itself carries four roundings
        let room = 4.0 * f64::EPSILON * exact;
        assert!(root.lower <= exact + room && exact - room <= root.upper, "mode {k}: {root:?}, {exact}");
        assert_eq!(root.multiplicity, 1);
    }
}

/// An element with a step but no transfer matrix: what builds and runs here forms no matrix.
mod ballast {
    use mstmm::element::{
        Element, FrequencyPowers, InvalidParameter, PlaneStep, Requirement, RootCounter, Subspace, Translation,
    };
    use mstmm::number::{Frequency, Parameter};

    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Ballast<T> {
        pub(crate) mass: T,
    }

    impl<T: Parameter> Element for Ballast<T> {
        type State = Translation;
        type Built = Self;

        fn build(self) -> Result<Self, InvalidParameter> {
            Requirement::Positive.check("mass", self.mass)?;
            Ok(self)
        }
    }

    impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for Ballast<T> {
        type Coefficients = S;

        fn coefficients(built: &Self, at: &FrequencyPowers<S>) -> S {
            at.lambda_squared * built.mass
        }

        fn step<C: RootCounter<S>>(inertia: &S, input: Subspace<S>, _counter: &mut C) -> Subspace<S> {
            let mut line = input.line();
            line.q -= *inertia * line.y;
            Subspace::Line(line, input.space())
        }
    }
}

#[test]
fn the_certified_searches_need_no_transfer_matrix() {
    system! {
        struct Oscillator { stiffness: f64, mass: f64 }

        fixed -> spring 1 { stiffness } -> ballast::Ballast 2 { mass } -> free;
    }
    let system = Oscillator { stiffness: 18.0, mass: 2.0 }.build().unwrap();
    let found = system.first_frequencies::<1>().unwrap();
    assert!(found[0].lower <= 3.0 && 3.0 <= found[0].upper);
    let found = system.eigenvalues::<2>(Region { re: -1.0..=1.0, im: -5.0..=5.0 }).unwrap();
    assert_eq!(found.len(), 2);
    assert!((found[1].lambda - Complex::new(0.0, 3.0)).norm() <= found[1].error);
}

/// Symmetric modes of a string with a mass M in the middle: `2 H φ/l' cot φ = M ω²` with half length l'; antisymmetric
/// modes do not feel the mass.
#[test]
fn a_mass_at_the_middle_obeys_the_frequency_equation() {
    let (length, tension, mass_per_length, mass) = (2.0, 50.0, 0.02, 0.05);
    let system = LoadedString { length, tension, mass_per_length, mass }.build().unwrap();
    assert_eq!(LoadedStringSystem::N, 3);
    let found = frequencies(|omega| system.overall_determinant(omega).value(), 400.0).unwrap();
    let half = length / 2.0;
    let phi = |omega: f64| omega * half * (mass_per_length / tension).sqrt();
    let antisymmetric = |omega: f64| phi(omega).sin();
    let symmetric =
        |omega: f64| 2.0 * tension / half * phi(omega) * phi(omega).cos() - mass * omega * omega * phi(omega).sin();
    assert!(found.len() >= 4);
    for (k, omega) in found.iter().enumerate() {
        let equation: &dyn Fn(f64) -> f64 = if k % 2 == 0 { &symmetric } else { &antisymmetric };
        assert!(equation(omega - 1e-8) * equation(omega + 1e-8) < 0.0, "{omega} is not a root");
    }
}

/// In the limit of a string without mass the string is a spring of stiffness H/l, and the reference is the built-in one.
#[test]
fn a_light_string_is_a_spring() {
    system! {
        struct SprungBeam { ei: f64, m: f64, stiffness: f64 }

        fixed -> beam 1 { length: 1.0, bending_stiffness: ei, mass_per_length: m } -> conn 2 -> free;
        conn 2 <- spring 3 { stiffness } <- fixed;
    }
    let held = HeldBeam { ei: 1.0, m: 1.0, tension: 30.0, string_mass: 1e-30 }.build().unwrap();
    let sprung = SprungBeam { ei: 1.0, m: 1.0, stiffness: 30.0 }.build().unwrap();
    assert_eq!(HeldBeamSystem::N, SprungBeamSystem::N);
    for omega in [0.0, 1.0, 7.5, 40.0] {
        let difference = held.overall_matrix(omega) - sprung.overall_matrix(omega);
        assert!(difference.amax() <= 8.0 * f64::EPSILON * sprung.overall_matrix(omega).amax(), "{difference}");
    }
}

#[test]
fn its_parameters_are_validated_under_its_name() {
    let error = TautString { length: 2.0, tension: -1.0, mass_per_length: 0.02 }.build().unwrap_err();
    assert_eq!((error.element, error.parameter, error.value), ("Cable 1", "tension", -1.0));
}

/// An element of one's own in a block: every bit is that of the frequency alone.
#[test]
fn many_frequencies_at_once() {
    let model = LoadedString { length: 2.0, tension: 3.0, mass_per_length: 0.5, mass: 0.7 };
    let system = model.build().unwrap();
    let omegas: [f64; 100] = core::array::from_fn(|k| 1e-3 * 1.2f64.powi(k as i32));
    let (mut values, mut counts) = ([mstmm::number::Scaled::new(0.0, 0); 100], [Ok(0); 100]);
    system.characteristics(&omegas, &mut values).unwrap();
    system.counts_below(&omegas, &mut counts).unwrap();
    for ((value, count), omega) in values.into_iter().zip(counts).zip(omegas) {
        let alone: mstmm::number::Scaled<f64> = system.characteristic(omega);
        assert_eq!((value, count), (alone, system.count_below(omega)), "at {omega}");
    }
}
