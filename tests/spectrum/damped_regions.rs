//! Where eigenvalues of damped materials are searched and where not, and closed forms of lines, which have sines for shapes.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::complex_beam::C;
use crate::damped_materials::list_of;
use mstmm::element::Support;
use mstmm::elements::{Beam, DampedBeam, DampedRod, DampedShaft, DampedSpring, DampedString, Mass};
use mstmm::list::{AnyElement, StepList};
use mstmm::prelude::*;
use mstmm::search::SearchError;

/// A free beam with a loss factor rests, twice, before it vibrates.
#[test]
fn a_body_at_rest_is_found_with_a_loss_factor() {
    let free = DampedBeam {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        shear_stiffness: f64::INFINITY,
        rotary_inertia: 0.0,
        axial_force: 0.0,
        foundation_stiffness: 0.0,
        foundation_shear_stiffness: 0.0,
        loss_factor: 0.2,
        kelvin_voigt_time: 0.0,
        external_damping: 0.0,
    };
    let steps = list_of(&[free.try_into().unwrap()], [Support::Free; 2]);
    let found = StepList::new(&steps).unwrap().first_eigenvalues::<5>().unwrap();
    assert_eq!((found[0].lambda, found[0].multiplicity), (C::ZERO, 4));
    let expected = C::new(0.0, 22.373_285_448_061_2) * C::new(1.0, 0.2).sqrt();
    assert!((found[1].lambda - expected).norm() < 1e-12, "{found:?} beside {expected}");
}

fn beam(loss_factor: f64, kelvin_voigt_time: f64, shear_stiffness: f64, axial_force: f64) -> AnyElement<f64> {
    let (bending_stiffness, mass_per_length, rotary_inertia) = (1.0, 1.0, 0.0);
    let (foundation_stiffness, foundation_shear_stiffness, external_damping) = (0.0, 0.0, 0.0);
    let beam = DampedBeam {
        length: 1.0,
        bending_stiffness,
        mass_per_length,
        shear_stiffness,
        rotary_inertia,
        axial_force,
        foundation_stiffness,
        foundation_shear_stiffness,
        loss_factor,
        kelvin_voigt_time,
        external_damping,
    };
    beam.try_into().unwrap()
}

/// With a loss factor nothing is searched on the real axis and below it, nor is the growing mirror image of a decaying motion reported.
#[test]
fn regions_that_a_loss_factor_excludes_are_refused() {
    let steps = list_of(&[beam(0.1, 0.0, f64::INFINITY, 0.0)], [Support::Fixed, Support::Free]);
    let system = StepList::new(&steps).unwrap();
    for low in [0.0, -1.0, -50.0] {
        let region = Region { re: -5.0..=5.0, im: low..=40.0 };
        assert_eq!(system.count_in(region.clone()), Err(SearchError::LossFactor { im: low }));
        assert_eq!(system.eigenvalues::<8>(region).err(), Some(SearchError::LossFactor { im: low }));
    }
    let found = system.eigenvalues::<8>(Region { re: -5.0..=5.0, im: 0.01..=40.0 }).unwrap();
    assert_eq!(found.len(), 2);
    assert!(found.iter().all(|root| root.lambda.re < 0.0 && root.lambda.im > 0.0), "{found:?}");
    // without a loss the same type has pairs, and the axis belongs to it
    let steps = list_of(&[beam(0.0, 0.0, f64::INFINITY, 0.0)], [Support::Fixed, Support::Free]);
    let pairs = StepList::new(&steps).unwrap().count_in(Region { re: -5.0..=5.0, im: -40.0..=40.0 });
    assert_eq!(pairs, Ok(4));
}

/// Regions near `λ = -1/c` are refused with the numbers, whichever of several times c is near; those aside are searched.
#[test]
fn regions_near_a_stiffness_that_vanishes_are_refused() {
    let steps = list_of(
        &[beam(0.0, 0.1, f64::INFINITY, 0.0), beam(0.0, 0.02, f64::INFINITY, 0.0)],
        [Support::Fixed, Support::Free],
    );
    let system = StepList::new(&steps).unwrap();
    let count = |re: [f64; 2], im: [f64; 2]| system.count_in(Region { re: re[0]..=re[1], im: im[0]..=im[1] });
    for (re, im) in [
        ([-12.0, 0.0], [-1.0, 1.0]),
        ([-60.0, -40.0], [-1.0, 1.0]),
        ([-30.0, -20.0], [0.0, 1.0]),
        ([-9.85, 0.0], [0.0, 30.0]),
    ] {
        let Err(SearchError::Accumulation { from, to }) = count(re, im) else { panic!("{re:?}: {:?}", count(re, im)) };
        assert!((from + 51.0).abs() < 1e-9 && (to + 9.8).abs() < 1e-9, "{from} .. {to}");
    }
    assert!(count([-9.0, 1.0], [-30.0, 30.0]).is_ok());
    assert!(count([-30.0, 1.0], [2.0, 30.0]).is_ok());
    assert!(count([-80.0, -60.0], [-5.0, 5.0]).is_ok());
    // a beam in compression that shears has no stiffness against shear farther to the right
    let steps = list_of(&[beam(0.0, 0.1, 2.0, -1.0)], [Support::Fixed, Support::Free]);
    let refused = StepList::new(&steps).unwrap().count_in(Region { re: -7.0..=0.0, im: -1.0..=1.0 });
    assert!(matches!(refused, Err(SearchError::Accumulation { to, .. }) if (to + 4.9).abs() < 1e-9), "{refused:?}");
}

/// Closed form: `λ² + cω²λ + ω² = 0`. As long as the first roots are nearer to zero than `1/c` they are found, and beyond it is said why not.
#[test]
fn first_roots_end_where_others_accumulate() {
    let omegas = [1.875_104_068_711_961_f64, 4.694_091_132_974_175].map(|z| z * z);
    let with = |c: f64| list_of(&[beam(0.0, c, f64::INFINITY, 0.0)], [Support::Fixed, Support::Free]);
    let c = 0.02;
    let found = StepList::new(&with(c)).unwrap().first_eigenvalues::<2>().unwrap();
    for (root, omega) in found.iter().zip(omegas) {
        let half = 0.5 * c * omega * omega;
        let expected = C::new(-half, (omega * omega - half * half).sqrt());
        assert!((root.lambda - expected).norm() <= 1e-13 * omega, "{root:?} beside {expected}");
    }
    let refused = StepList::new(&with(c)).unwrap().first_eigenvalues::<3>();
    assert!(matches!(refused, Err(SearchError::Accumulation { .. })), "{refused:?}");
    let refused = StepList::new(&with(1.0)).unwrap().first_eigenvalues::<1>();
    assert!(matches!(refused, Err(SearchError::Accumulation { .. })), "{refused:?}");
    // a lumped spring has no waves, and its root beyond 1/c is an ordinary one
    let spring = DampedSpring { stiffness: 4.0, loss_factor: 0.0, kelvin_voigt_time: 3.0, damping: 0.0 };
    let mass = Mass { mass: 1.0 };
    let steps = list_of(&[spring.try_into().unwrap(), mass.try_into().unwrap()], [Support::Fixed, Support::Free]);
    let found = StepList::new(&steps).unwrap().first_eigenvalues::<2>().unwrap();
    for (root, expected) in found.iter().zip([-6.0 + 32.0_f64.sqrt(), -6.0 - 32.0_f64.sqrt()]) {
        assert!((root.lambda - expected).norm() < 1e-13, "{root:?} beside {expected}");
    }
}

/// Closed forms of lines: `λ² m + λ c_e + H e (nπ/l)² + k = 0`.
#[test]
fn lines_with_damping_have_sines() {
    let (length, stiffness, mass, foundation) = (1.3, 7.0, 0.4, 2.0);
    let (external_damping, eta) = (0.3, 0.25);
    let first = |element: AnyElement<f64>| {
        let steps = list_of(&[element], [Support::Fixed, Support::Fixed]);
        StepList::new(&steps).unwrap().first_eigenvalues::<3>().unwrap()
    };
    let expected = |n: usize, eta: f64, k: f64| {
        let wave = n as f64 * core::f64::consts::PI / length;
        let half = C::from(external_damping / (2.0 * mass));
        let root = (half * half - (C::new(1.0, eta) * stiffness * wave * wave + k) / mass).sqrt();
        if root.im > 0.0 { root - half } else { -root - half }
    };
    let rod = DampedRod {
        length,
        axial_stiffness: stiffness,
        mass_per_length: mass,
        foundation_stiffness: foundation,
        loss_factor: eta,
        kelvin_voigt_time: 0.0,
        external_damping,
    };
    let shaft = DampedShaft {
        length,
        torsional_stiffness: stiffness,
        inertia_per_length: mass,
        loss_factor: eta,
        kelvin_voigt_time: 0.0,
        external_damping,
    };
    let string = DampedString {
        length,
        tension: stiffness,
        mass_per_length: mass,
        foundation_stiffness: foundation,
        external_damping,
    };
    let cases: [(AnyElement<f64>, f64, f64); 3] = [
        (rod.try_into().unwrap(), eta, foundation),
        (shaft.try_into().unwrap(), eta, 0.0),
        (string.try_into().unwrap(), 0.0, foundation),
    ];
    for (element, eta, k) in cases {
        let found = first(element);
        for (n, root) in (1..).zip(&found) {
            let expected = expected(n, eta, k);
            assert!((root.lambda - expected).norm() <= 1e-14 * root.frequency() * 4.0, "{root:?} beside {expected}");
        }
    }
    // a beam without damping of its own beside one with it
    let plain = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    let steps =
        list_of(&[plain.try_into().unwrap(), beam(0.3, 0.0, f64::INFINITY, 0.0)], [Support::Fixed, Support::Free]);
    let found = StepList::new(&steps).unwrap().first_eigenvalues::<2>().unwrap();
    let bound = 0.3_f64.atan();
    assert!(
        found.iter().all(|root| {
            let angle = (-root.lambda * root.lambda).arg();
            0.0 < angle && angle < bound
        }),
        "{found:?}"
    );
}
