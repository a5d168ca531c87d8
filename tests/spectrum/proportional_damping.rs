//! Damping in proportion beside certified eigenvalues of the same system with its dampers written out.

use mstmm::prelude::*;
use mstmm::search::ProportionalDamping;

/// Three masses between springs; with `beta` each spring has its damper, with `alpha` each mass one to the ground.
macro_rules! rows {
    ($plain:ident, $damped:ident) => {
        system! {
            struct $plain { k: f64, m: f64 }
            fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> spring 3 { stiffness: 2.0 * k } -> mass 4 { mass: 0.5 * m }
                -> spring 5 { stiffness: 0.7 * k } -> mass 6 { mass: 3.0 * m } -> free
        }
        system! {
            struct $damped { k: f64, m: f64, alpha: f64, beta: f64 }
            fixed -> spring 1 { stiffness: k, damping: beta * k } -> conn a -> mass 2 { mass: m }
                -> spring 3 { stiffness: 2.0 * k, damping: 2.0 * beta * k } -> conn b -> mass 4 { mass: 0.5 * m }
                -> spring 5 { stiffness: 0.7 * k, damping: 0.7 * beta * k } -> conn c -> mass 6 { mass: 3.0 * m } -> free;
            conn a <- damper 7 { damping: alpha * m } <- fixed;
            conn b <- damper 8 { damping: 0.5 * alpha * m } <- fixed;
            conn c <- damper 9 { damping: 3.0 * alpha * m } <- fixed
        }
    };
}
rows!(Row, DampedRow);

#[test]
fn eigenvalues_are_those_of_dampers_in_proportion() {
    let (k, m) = (40.0, 2.0);
    let plain = Row { k, m }.build().unwrap().first_frequencies::<3>().unwrap();
    for (alpha, beta) in [(0.3, 0.0), (0.0, 0.02), (0.5, 0.01), (0.0, 0.4), (9.0, 0.0)] {
        let damping = ProportionalDamping::new(alpha, beta, 0.0).unwrap();
        let damped = DampedRow { k, m, alpha, beta }.build().unwrap();
        let mut expected: Vec<Complex<f64>> = damped
            .eigenvalues::<8>(Region { re: -300.0..=1.0, im: 0.0..=60.0 })
            .unwrap()
            .iter()
            .map(|root| root.lambda)
            .collect();
        let conjugates: Vec<_> =
            expected.iter().filter(|lambda| lambda.im != 0.0).map(|lambda| lambda.conj()).collect();
        expected.extend(conjugates);
        let found: Vec<_> = plain.iter().flat_map(|root| damping.eigenvalues(root)).map(Option::unwrap).collect();
        assert_eq!(found.len(), 6);
        for root in &found {
            let nearest = expected.iter().map(|lambda| (lambda - root.lambda).norm()).fold(f64::INFINITY, f64::min);
            assert!(
                nearest <= 1e-13 * root.lambda.norm() + root.error,
                "{root:?} of α = {alpha}, β = {beta}: {expected:?}"
            );
        }
    }
}

/// Closed form: `λ = iω √(1 + iη)` decays, and its mirror image, which would grow, is none.
#[test]
fn a_loss_factor_has_one_eigenvalue_for_each_frequency() {
    let root = NaturalFrequency {
        omega: 3.0,
        lower: 3.0 - 1e-15,
        upper: 3.0 + 1e-15,
        multiplicity: 2,
        ..NaturalFrequency::default()
    };
    let eta = 0.2_f64;
    let [found, mirror] = ProportionalDamping::new(0.0, 0.0, eta).unwrap().eigenvalues(&root);
    let exact = Complex::new(0.0, 3.0) * Complex::new(1.0, eta).sqrt();
    let found = found.unwrap();
    assert!((found.lambda - exact).norm() <= 4e-15 && found.lambda.re < 0.0, "{found:?} beside {exact}");
    assert_eq!((found.multiplicity, mirror), (2, None));
}

#[test]
fn rigid_bodies_and_critical_damping() {
    let at = |omega: f64, alpha: f64| {
        let root =
            NaturalFrequency { omega, lower: omega, upper: omega, multiplicity: 1, ..NaturalFrequency::default() };
        ProportionalDamping::new(alpha, 0.0, 0.0).unwrap().eigenvalues(&root).map(|root| root.unwrap().lambda)
    };
    assert_eq!(at(0.0, 0.5).map(|lambda| lambda.re).iter().sum::<f64>(), -0.5);
    assert_eq!(at(2.0, 4.0), [Complex::new(-2.0, 0.0); 2]);
    assert!(ProportionalDamping::new(0.1, -1e-9, 0.0).is_err_and(|error| error.parameter == "beta"));
}
