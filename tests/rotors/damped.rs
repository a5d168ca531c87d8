//! Damped rotors: closed forms of bearings, seals and internal damping, and their thresholds.
#![expect(clippy::unwrap_used, reason = "a rotor that is refused fails the test")]

use core::f64::consts::PI;
use mstmm::Complex;
use mstmm::prelude::*;
use mstmm::search::{Rotor, SearchError, SpeedError, Threshold, stability_threshold};

type C = Complex<f64>;

/// The roots of `a λ² + b λ + c` above the real axis.
fn upper_roots(a: f64, b: C, c: C) -> Vec<C> {
    let root = (b * b - 4.0 * a * c).sqrt();
    // of both roots the one without cancellation first
    let sum = if (b.conj() * root).re >= 0.0 { -(b + root) / 2.0 } else { (root - b) / 2.0 };
    let roots = [sum / a, c / sum];
    roots.into_iter().filter(|root| root.im > 0.0).collect()
}

/// Holds the eigenvalues of both whirls to those of equations, whose signs of speeds and of cross terms the whirl says.
#[track_caller]
fn check<Y: Spectrum<Parameter = f64>>(rotor: &Rotor<Y>, roots: impl Fn(f64) -> Vec<C>) {
    for (whirl, sign) in [(Whirl::Forward, 1.0), (Whirl::Backward, -1.0)] {
        let mut expected = roots(sign);
        expected.sort_by(|one, other| one.norm().total_cmp(&other.norm()));
        let found = match expected.len() {
            1 => rotor.whirl(whirl).first_eigenvalues::<1>().unwrap().to_vec(),
            _ => rotor.whirl(whirl).first_eigenvalues::<2>().unwrap().to_vec(),
        };
        for (own, expected) in found.iter().zip(expected) {
            let error = (own.lambda - expected).norm();
            assert!(
                own.is_proven && error <= own.error + 4.0 * f64::EPSILON * expected.norm(),
                "{whirl:?} {own:?} {expected}"
            );
        }
    }
}

system! {
    /// A disc on damped springs.
    struct Rigid { mass: f64, id: f64, ip: f64, k: f64, k_theta: f64, c: f64, c_theta: f64, speed: f64 }
    free -> disc 1 { mass, inertia: id, polar_inertia: ip, speed } -> conn a -> free;
    fixed -> spring 2 { stiffness: k, damping: c } -> conn a;
    fixed -> torsion_spring 3 { stiffness: k_theta, damping: c_theta } -> conn a;
}

/// `mλ² + cλ + k = 0` and `I_d λ² + (c_θ - i I_p Ω) λ + k_θ = 0`.
#[test]
fn a_disc_on_dampers_has_its_eigenvalues() {
    for speed in [1e-3, 35.0, 900.0] {
        let disc = Rigid { mass: 3.0, id: 0.2, ip: 0.3, k: 1200.0, k_theta: 500.0, c: 4.0, c_theta: 0.7, speed };
        check(&disc.build().unwrap(), |sign| {
            let bending = upper_roots(disc.mass, C::from(disc.c), C::from(disc.k));
            let tilting = upper_roots(disc.id, C::new(disc.c_theta, -sign * disc.ip * speed), C::from(disc.k_theta));
            [bending, tilting].concat()
        });
    }
}

system! {
    /// A disc that does not tilt on a seal.
    struct Seal { mass: f64, k: f64, c: f64, cross: f64, cross_damping: f64 }
    fixed -> spring 1 { stiffness: k, damping: c, cross_stiffness: cross, cross_damping } -> mass 2 { mass } -> free;
}

/// `mλ² + (c - ic_c) λ + k - ik_c = 0`.
#[test]
fn a_seal_drives_forward_whirl() {
    for (cross, cross_damping) in [(300.0, 0.0), (-300.0, 2.0), (0.0, 5.0), (30.0, -1.0)] {
        let seal = Seal { mass: 3.0, k: 1200.0, c: 4.0, cross, cross_damping };
        check(&seal.build().unwrap(), |sign| {
            upper_roots(seal.mass, C::new(seal.c, -sign * cross_damping), C::new(seal.k, -sign * cross))
        });
    }
    let growth = |cross: f64, whirl| {
        let seal = Seal { mass: 3.0, k: 1200.0, c: 4.0, cross, cross_damping: 0.0 };
        seal.build().unwrap().whirl(whirl).first_eigenvalues::<1>().unwrap()[0].lambda.re
    };
    assert!(growth(200.0, Whirl::Forward) > 0.0 && growth(200.0, Whirl::Backward) < growth(0.0, Whirl::Backward));
    assert!(growth(-200.0, Whirl::Forward) < growth(0.0, Whirl::Forward) && growth(-200.0, Whirl::Backward) > 0.0);
}

#[track_caller]
fn assert_threshold(found: &Threshold, speed: f64, omega: f64) {
    let error = (found.speed / speed - 1.0).abs();
    assert!(error < 1e-10, "{found:?} instead of {speed}: {error:e}");
    assert!(
        found.lower < found.upper && found.lower <= speed * (1.0 + 1e-12) && speed * (1.0 - 1e-12) <= found.upper,
        "{found:?}"
    );
    assert!(found.upper - found.lower < 1e-8 * speed, "{found:?}");
    assert!(found.eigenvalue.is_proven && (found.eigenvalue.lambda.im / omega - 1.0).abs() < 1e-8, "{found:?}");
}

/// A cross stiffness that grows with the speed, `k_c = κΩ`, overcomes the damping at `Ω = cω/κ`.
#[test]
fn a_disc_on_a_seal_has_its_threshold() {
    let (mass, k, c, kappa) = (3.0, 1200.0_f64, 4.0, 0.25);
    let omega = (k / mass).sqrt();
    let region = Region { re: 0.0..=10.0, im: 1.0..=50.0 };
    let build = |speed: f64| Seal { mass, k, c, cross: kappa * speed, cross_damping: 0.0 }.build();
    let found = stability_threshold(1.0..=1e3, Whirl::Forward, region.clone(), build).unwrap();
    assert_threshold(&found.unwrap(), c * omega / kappa, omega);
    // backward whirl is damped the more
    assert_eq!(stability_threshold(1.0..=1e3, Whirl::Backward, region.clone(), build), Ok(None));
    assert_eq!(stability_threshold(1.0..=100.0, Whirl::Forward, region.clone(), build), Ok(None));
    let error = stability_threshold(600.0..=1e3, Whirl::Forward, region.clone(), build).err();
    assert_eq!(error, Some(SpeedError::Grows { speed: 600.0 }));
    let error = stability_threshold(1e3..=1.0, Whirl::Forward, region.clone(), build).err();
    assert_eq!(error, Some(SpeedError::Search(SearchError::Range { start: 1e3, end: 1.0 })));
    let error =
        stability_threshold(1.0..=1e3, Whirl::Forward, Region { re: -1.0..=10.0, ..region.clone() }, build).err();
    assert_eq!(error, Some(SpeedError::Region { re: -1.0 }));
    let error = stability_threshold(1.0..=1e3, Whirl::Forward, Region { im: -1.0..=50.0, ..region }, build).err();
    assert!(matches!(error, Some(SpeedError::Search(SearchError::OtherWhirl { .. }))), "{error:?}");
}

system! {
    /// A slender shaft between pins with damping of its material and of a medium.
    struct Pinned { length: f64, ei: f64, m: f64, rp: f64, time: f64, external: f64, speed: f64 }
    pinned -> beam 1 {
        length, bending_stiffness: ei, mass_per_length: m, rotary_inertia: 0.5 * rp, polar_inertia_per_length: rp,
        kelvin_voigt_time: time, external_damping: external, speed
    } -> pinned;
}

/// `(m + rκ²) λ² + (c_e - i r_p κ² Ω) λ + EI κ⁴ (1 + t(λ - iΩ)) = 0` for each sine of the shaft.
#[test]
fn a_shaft_with_internal_damping_has_its_eigenvalues() {
    for (speed, rp) in [(3.0, 0.0), (30.0, 0.02), (200.0, 0.1)] {
        let shaft = Pinned { length: 1.3, ei: 40.0, m: 2.0, rp, time: 1e-3, external: 0.3, speed };
        check(&shaft.build().unwrap(), |sign| {
            let of_sine = |j: usize| {
                let square = (j as f64 * PI / shaft.length).powi(2);
                let (stiffness, inertia) = (shaft.ei * square * square, shaft.m + 0.5 * rp * square);
                let damping = C::new(shaft.external + stiffness * shaft.time, -sign * rp * square * speed);
                upper_roots(inertia, damping, stiffness * C::new(1.0, -sign * shaft.time * speed))
            };
            (1..6).flat_map(of_sine).collect()
        });
    }
}

/// Internal damping drives a slender shaft from `Ω = ω (1 + c_e/c_i)` on, `c_i = EI κ⁴ t`.
#[test]
fn a_shaft_with_internal_damping_has_its_threshold() {
    let shaft = Pinned { length: 1.3, ei: 40.0, m: 2.0, rp: 0.0, time: 1e-3, external: 0.3, speed: 0.0 };
    let stiffness = shaft.ei * (PI / shaft.length).powi(4);
    let omega = (stiffness / shaft.m).sqrt();
    let region = Region { re: 0.0..=20.0, im: 1.0..=60.0 };
    let found = stability_threshold(1.0..=200.0, Whirl::Forward, region, |speed| Pinned { speed, ..shaft }.build());
    assert_threshold(&found.unwrap().unwrap(), omega * (1.0 + shaft.external / (stiffness * shaft.time)), omega);
}

/// Regions of one whirl lie above the real axis; where damping of the material leaves no stiffness nothing is searched.
#[test]
fn regions_of_rotors_say_what_is_wrong() {
    let rotor =
        Pinned { length: 1.3, ei: 40.0, m: 2.0, rp: 0.02, time: 1e-2, external: 0.3, speed: 30.0 }.build().unwrap();
    let forward = rotor.whirl(Whirl::Forward);
    let error = forward.eigenvalues::<8>(Region { re: -10.0..=10.0, im: -1.0..=10.0 }).err();
    assert_eq!(error, Some(SearchError::OtherWhirl { im: -1.0 }));
    let text = error.map_or_else(String::new, |error| error.to_string());
    assert!(text.contains("the other whirl"), "{text}");
    // λ = -1/t + iΩ
    let error = forward.eigenvalues::<8>(Region { re: -110.0..=10.0, im: 1.0..=100.0 }).err();
    assert!(matches!(error, Some(SearchError::Accumulation { .. })), "{error:?}");
}

/// Real eigenvalues are of both whirls, whatever rounding says of their imaginary parts.
#[test]
fn overdamped_rotors_have_their_real_eigenvalues() {
    for (k, c) in [(1200.0, 300.0), (1200.0, 125.0), (900.0, 4e3), (30.0, 21.0), (1e4, 1e3)] {
        let disc = Rigid { mass: 3.0, id: 0.2, ip: 0.3, k, k_theta: 500.0, c, c_theta: 0.0, speed: 30.0 };
        let root = (c * c - 4.0 * disc.mass * k).sqrt();
        let slow = -2.0 * k / (c + root);
        for whirl in [Whirl::Forward, Whirl::Backward] {
            let rotor = disc.build().unwrap();
            let found = rotor.whirl(whirl).first_eigenvalues::<2>().unwrap();
            let real: Vec<f64> =
                found.iter().filter(|root| root.lambda.im.abs() <= root.error).map(|root| root.lambda.re).collect();
            assert!(
                real.iter().any(|own| (own / slow - 1.0).abs() < 1e-12),
                "{whirl:?} {k} {c}: {found:?} without {slow}"
            );
            let region = Region { re: 1.2 * slow..=0.5, im: 0.0..=10.0 };
            let within = rotor.whirl(whirl).eigenvalues::<4>(region).unwrap();
            assert_eq!(within.len(), 1, "{within:?}");
        }
    }
}

/// A shaft without polar inertia has two whirls as well: its damping turns with it.
#[test]
fn damping_that_turns_tells_both_whirls_apart() {
    let shaft = Pinned { length: 1.0, ei: 40.0, m: 2.0, rp: 0.0, time: 1e-4, external: 0.5, speed: 100.0 };
    let rotor = shaft.build().unwrap();
    let error = rotor.whirl(Whirl::Forward).eigenvalues::<8>(Region { re: -40.0..=40.0, im: -100.0..=100.0 }).err();
    assert_eq!(error, Some(SearchError::OtherWhirl { im: -100.0 }));
}

system! {
    /// Two alike parts of a shaft on a bearing.
    struct Halves { speed: f64, k: f64, damping: f64 }
    section s {
        length: 0.5, bending_stiffness: 40.0, mass_per_length: 2.0, rotary_inertia: 0.02, polar_inertia_per_length: 0.05, speed
    }
    pinned -> beam 1 { ..s } -> conn m -> beam 2 { ..s } -> pinned;
    fixed -> spring 3 { stiffness: k, damping } -> conn m;
}

/// Energies of a mode are those of a cycle, at any speed, and gyroscopic moments take none.
#[test]
fn shares_of_energies_are_parts_of_one() {
    for speed in [0.0, 100.0, 1e4] {
        for (whirl, damping) in
            [(Whirl::Forward, 1e-9), (Whirl::Backward, 1e-9), (Whirl::Forward, 5.0), (Whirl::Backward, 5.0)]
        {
            let rotor = Halves { speed, k: 10.0, damping }.build().unwrap();
            let system = rotor.whirl(whirl);
            let root = system.first_eigenvalues::<1>().unwrap()[0];
            let shape = system.mode_shape(&root).unwrap();
            let [one, other] = [shape.energy_shares(Halves::beam_1), shape.energy_shares(Halves::beam_2)];
            assert!(
                (one.strain - other.strain).abs() < 1e-9 && (one.kinetic - 0.5).abs() < 1e-9,
                "{speed} {whirl:?} {one:?} {other:?}"
            );
            assert!((0.0..=1.0).contains(&one.strain) && (0.4..0.5001).contains(&one.strain), "{one:?}");
            let bearing = shape.energy_shares(Halves::spring_3);
            assert!((bearing.dissipated - 1.0).abs() < 1e-9, "{bearing:?}");
        }
    }
}

/// Below the axis a loss factor is that of conjugate motions, which are of the other whirl.
#[test]
fn responses_below_the_axis_of_lossy_rotors_are_refused() {
    let lossy = Lossy { speed: 30.0 }.build().unwrap();
    let point = Lossy::conn_a;
    let response = lossy.whirl(Whirl::Forward).frequency_response(point.torque(), point.rotation()).unwrap();
    let above = response.at(C::new(0.0, 40.0)).unwrap();
    let expected = 1.0 / (C::new(500.0, 50.0) - 0.2 * 1600.0 + 0.3 * 30.0 * 40.0);
    assert!((above - expected).norm() < 1e-13 * expected.norm(), "{above} {expected}");
    assert_eq!(response.at(C::new(0.0, -40.0)).err(), Some(mstmm::motion::MotionError::LossFactor));
}

system! {
    /// A disc on a lossy spring.
    struct Lossy { speed: f64 }
    free -> disc 1 { mass: 3.0, inertia: 0.2, polar_inertia: 0.3, speed } -> conn a -> free;
    fixed -> spring 2 { stiffness: 1200.0 } -> conn a;
    fixed -> torsion_spring 3 { stiffness: 500.0, loss_factor: 0.1 } -> conn a;
}

system! {
    /// A disc whose seal pushes across by a number.
    struct Pushed { cross: f64 }
    free -> disc 1 { mass: 1.0, inertia: 1.0, polar_inertia: 0.0 } -> conn a -> free;
    fixed -> spring 2 { stiffness: 100.0, damping: 1.0, cross_stiffness: cross } -> conn a;
    fixed -> torsion_spring 3 { stiffness: 1e6 } -> conn a;
}

/// Where nothing is in the region at the first speed, and where a motion neither grows nor decays for a while.
#[test]
fn thresholds_are_narrow_beside_speeds_that_say_nothing() {
    // neutral at ω = 10, where k_c = cω
    let kinked = |speed: f64| {
        let slope = if speed < 50.0 { 1.0 } else { 0.1 };
        Pushed { cross: 10.0 + slope * (speed - 50.0) }.build()
    };
    for width in [1.0, 10.0] {
        let region = Region { re: 0.0..=width, im: 1.0..=50.0 };
        let found = stability_threshold(0.0..=100.0, Whirl::Forward, region, kinked).unwrap().unwrap();
        assert!(found.lower < 50.0 && found.upper > 50.0 && found.upper - found.lower < 1e-9, "{found:?}");
    }
    let flat = |speed: f64| {
        let cross = if speed < 20.0 {
            speed - 20.0
        } else if speed > 70.0 {
            speed - 70.0
        } else {
            0.0
        };
        Pushed { cross: 10.0 + 0.1 * cross }.build()
    };
    let region = Region { re: 0.0..=10.0, im: 1.0..=50.0 };
    let found = stability_threshold(0.0..=100.0, Whirl::Forward, region, flat).unwrap().unwrap();
    assert!(found.lower < 70.0 && found.upper > 70.0 && found.upper < 70.1, "{found:?}");
}

/// A motion that grows faster than the region is wide is found, and one that nothing damps is told apart.
#[test]
fn thresholds_see_fast_growth_and_name_what_is_not_damped() {
    let (mass, k, c) = (3.0, 1200.0_f64, 4.0);
    let build = |speed: f64| Seal { mass, k, c, cross: 0.25 * speed, cross_damping: 0.0 }.build();
    let region = Region { re: 0.0..=0.1, im: 1.0..=50.0 };
    let found = stability_threshold(1.0..=1e4, Whirl::Forward, region, build).unwrap();
    assert_threshold(&found.unwrap(), 4.0 * c * (k / mass).sqrt(), (k / mass).sqrt());
    let undamped = |_: f64| Seal { mass, k, c: 0.0, cross: 0.0, cross_damping: 0.0 }.build();
    let region = Region { re: 0.0..=1.0, im: 1.0..=50.0 };
    let error = stability_threshold(1.0..=10.0, Whirl::Forward, region, undamped).err();
    assert!(
        matches!(error, Some(SpeedError::Neutral { speed: 1.0, omega }) if (omega - 20.0).abs() < 1e-9),
        "{error:?}"
    );
}
