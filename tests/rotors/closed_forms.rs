//! Closed forms of rotors.
#![expect(clippy::panic, reason = "a rotor that is refused fails the test")]

use core::f64::consts::PI;
use mstmm::prelude::*;
use mstmm::search::{Rotor, SearchError, SpeedError, critical_speeds};

/// The frequencies of a whirl.
fn whirls<Y: Undamped<Parameter = f64>, const N: usize>(rotor: &Rotor<Y>, whirl: Whirl) -> Vec<f64> {
    let found = rotor.whirl(whirl).first_frequencies::<N>().unwrap_or_else(|error| panic!("{error}"));
    assert!(found.iter().all(|root| root.is_proven));
    found.iter().map(|root| root.omega).collect()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, roundings: f64) {
    let error = (found / expected - 1.0).abs();
    assert!(error <= roundings * f64::EPSILON, "{found} instead of {expected}: {error:e}");
}

system! {
    /// Rayleigh's shaft between pins.
    struct Pinned { length: f64, ei: f64, m: f64, r: f64, rp: f64, speed: f64 }
    pinned -> beam 1 {
        length, bending_stiffness: ei, mass_per_length: m, rotary_inertia: r, polar_inertia_per_length: rp, speed
    } -> pinned;
}

/// `EI κ⁴ - ω² (m + r κ²) + ω Ω r_p κ² = 0` with `κ = jπ/l`.
#[test]
fn a_pinned_shaft_whirls_in_sines_at_any_speed() {
    let shaft = Pinned { length: 1.3, ei: 40.0, m: 2.0, r: 0.03, rp: 0.06, speed: 0.0 };
    for speed in [-300.0, 0.0, 1.0, 70.0, 900.0, 2e4] {
        let rotor = Pinned { speed, ..shaft }.build().unwrap_or_else(|error| panic!("{error}"));
        for (whirl, sign) in [(Whirl::Forward, 1.0), (Whirl::Backward, -1.0)] {
            let expected = |j: usize| {
                let square = (j as f64 * PI / shaft.length).powi(2);
                let (a, b, c) =
                    (shaft.m + shaft.r * square, sign * speed * shaft.rp * square, shaft.ei * square * square);
                // of the two forms of the root the one without cancellation
                let root = (b * b + 4.0 * a * c).sqrt();
                if b > 0.0 { (b + root) / (2.0 * a) } else { 2.0 * c / (root - b) }
            };
            // at high speeds the frequencies of forward whirl do not grow with j
            let mut all: Vec<f64> = (1..200).map(expected).collect();
            all.sort_by(f64::total_cmp);
            for (found, expected) in whirls::<_, 6>(&rotor, whirl).into_iter().zip(all) {
                assert_close(found, expected, 16.0);
            }
        }
    }
}

/// With `r_p = 2r` a forward critical speed is that of `EI κ⁴ = Ω² (m - r κ²)`: there is none from `κ² = m/r` on.
#[test]
fn forward_critical_speeds_of_a_shaft_end() {
    let shaft = Pinned { length: 1.0, ei: 40.0, m: 2.0, r: 0.01, rp: 0.02, speed: 0.0 };
    let build = |speed| Pinned { speed, ..shaft }.build();
    let square = |j: usize| (j as f64 * PI).powi(2);
    // κ² < 200: j up to 4
    let found =
        critical_speeds::<8, _>(1.0..=1e7, Whirl::Forward, 1.0, build).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.len(), 4);
    for (j, critical) in (1..).zip(found.iter()) {
        let square = square(j);
        assert_close(critical.speed, (shaft.ei * square * square / (shaft.m - shaft.r * square)).sqrt(), 16.0);
        assert!(critical.is_proven && critical.index == j as u64);
    }
    let found =
        critical_speeds::<32, _>(1.0..=2e3, Whirl::Backward, 1.0, build).unwrap_or_else(|error| panic!("{error}"));
    for (j, critical) in (1..).zip(found.iter()) {
        let square = square(j);
        assert_close(critical.speed, (shaft.ei * square * square / (shaft.m + 3.0 * shaft.r * square)).sqrt(), 16.0);
    }
    assert!(found.len() > 4);
}

system! {
    /// A disc on springs: a rigid rotor.
    struct Rigid { mass: f64, id: f64, ip: f64, k: f64, k_theta: f64, speed: f64 }
    free -> disc 1 { mass, inertia: id, polar_inertia: ip, speed } -> conn a -> free;
    fixed -> spring 2 { stiffness: k } -> conn a;
    fixed -> torsion_spring 3 { stiffness: k_theta } -> conn a;
}

/// `k - mω² = 0` and `k_θ - I_d ω² + I_p Ω ω = 0`.
#[test]
fn a_disc_on_springs_has_two_forward_critical_speeds_or_one() {
    let disc = Rigid { mass: 3.0, id: 0.2, ip: 0.1, k: 1200.0, k_theta: 500.0, speed: 0.0 };
    for (ip, count) in [(0.0, 2), (0.1, 2), (0.19, 2), (0.2, 1), (0.35, 1)] {
        let build = |speed| Rigid { ip, speed, ..disc }.build();
        let found =
            critical_speeds::<4, _>(0.0..=1e5, Whirl::Forward, 1.0, build).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(found.len(), count, "{found:?}");
        let mut expected = vec![(disc.k / disc.mass).sqrt()];
        if ip < disc.id {
            expected.push((disc.k_theta / (disc.id - ip)).sqrt());
        }
        expected.sort_by(f64::total_cmp);
        found.iter().zip(expected).for_each(|(critical, expected)| assert_close(critical.speed, expected, 16.0));
    }
}

/// Far beyond its frequencies a disc tilts at `Ω I_p/I_d` forward, and at `k_θ/(I_p Ω)` backward, which goes to zero.
#[test]
fn at_high_speeds_a_disc_nutates_and_precesses() {
    for speed in [1e9, 1e12, 1e15] {
        let disc = Rigid { mass: 3.0, id: 0.2, ip: 0.3, k: 1200.0, k_theta: 500.0, speed };
        let rotor = disc.build().unwrap_or_else(|error| panic!("{error}"));
        let translation = (disc.k / disc.mass).sqrt();
        let forward = whirls::<_, 2>(&rotor, Whirl::Forward);
        assert_close(forward[0], translation, 8.0);
        assert_close(forward[1], disc.speed * disc.ip / disc.id, 16.0);
        let backward = whirls::<_, 2>(&rotor, Whirl::Backward);
        assert_close(backward[0], disc.k_theta / (disc.ip * disc.speed), 16.0);
        assert_close(backward[1], translation, 8.0);
    }
}

system! {
    /// A shaft of one section that is as stiff with a speed as without.
    struct Still { speed: f64 }
    section s { length: 0.7, bending_stiffness: 50.0, mass_per_length: 1.5, shear_stiffness: 8e3, rotary_inertia: 2e-3 }
    fixed -> beam 1 { ..s, polar_inertia_per_length: 4e-3, speed } -> disc 2 { mass: 2.0, inertia: 0.05, polar_inertia: 0.09, speed } -> free;
}

system! {
    /// The same beam without a word of speed.
    struct Beam {}
    section s { length: 0.7, bending_stiffness: 50.0, mass_per_length: 1.5, shear_stiffness: 8e3, rotary_inertia: 2e-3 }
    fixed -> beam 1 { ..s } -> point_mass 2 { mass: 2.0, inertia: 0.05 } -> free;
}

#[test]
fn without_speed_both_whirls_are_the_beam() {
    let rotor = Still { speed: 0.0 }.build().unwrap_or_else(|error| panic!("{error}"));
    let beam = Beam {}.build().unwrap_or_else(|error| panic!("{error}"));
    let expected = beam.first_frequencies::<8>().unwrap_or_else(|error| panic!("{error}"));
    for whirl in [Whirl::Forward, Whirl::Backward] {
        for (own, expected) in whirls::<_, 8>(&rotor, whirl).into_iter().zip(expected.iter()) {
            assert_close(own, expected.omega, 4.0);
        }
    }
}

system! {
    /// A rotor that nothing holds.
    struct Loose { speed: f64 }
    free -> disc 1 { mass: 1.0, inertia: 0.3, polar_inertia: 0.2, speed } -> beam 2 {
        length: 0.5, bending_stiffness: 1e3, mass_per_length: 0.5, rotary_inertia: 1e-4, polar_inertia_per_length: 2e-4, speed
    } -> disc 3 { mass: 2.0, inertia: 0.1, polar_inertia: 0.15, speed } -> free;
}

/// It drifts in both whirls, and tilts at rest in backward whirl alone: forward it nutates.
#[test]
fn a_free_rotor_rests_once_forward_and_twice_backward() {
    let rotor = Loose { speed: 40.0 }.build().unwrap_or_else(|error| panic!("{error}"));
    for (whirl, at_rest) in [(Whirl::Forward, 1), (Whirl::Backward, 2)] {
        let found = rotor.whirl(whirl).first_frequencies::<4>().unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((found[0].omega, found[0].multiplicity, found[1].index), (0.0, at_rest, at_rest + 1));
        assert!(found.iter().all(|root| root.is_proven));
    }
    // the moments of inertia about the common centre of mass
    let forward = rotor.whirl(Whirl::Forward).first_frequencies::<2>().unwrap_or_else(|error| panic!("{error}"));
    assert!((0.1 * 40.0..40.0).contains(&forward[1].omega), "{forward:?}");
    let error = critical_speeds::<4, _>(1.0..=10.0, Whirl::Forward, 1.0, |speed| Loose { speed }.build()).err();
    assert!(matches!(error, Some(SpeedError::Search(SearchError::Zero { .. }))), "{error:?}");
}

system! {
    /// A shaft in compression.
    struct Strut { force: f64, speed: f64 }
    pinned -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, rotary_inertia: 1e-3, axial_force: -force,
        polar_inertia_per_length: 2e-3, speed
    } -> pinned;
}

/// Beyond its load gyroscopic moments may hold a shaft, but no count says so: the hypothesis of the proof is the stiffness without speed.
#[test]
fn a_shaft_that_buckles_is_refused_at_any_speed() {
    for speed in [0.0, 1.0, 1e6] {
        let below = Strut { force: 0.99 * PI * PI, speed }.build().unwrap_or_else(|error| panic!("{error}"));
        assert!(below.whirl(Whirl::Forward).first_frequencies::<2>().is_ok());
        let beyond = Strut { force: 1.01 * PI * PI, speed }.build().unwrap_or_else(|error| panic!("{error}"));
        for whirl in [Whirl::Forward, Whirl::Backward] {
            let error = beyond.whirl(whirl).first_frequencies::<2>().err();
            assert_eq!(error, Some(SearchError::Unstable { modes: 1 }));
            assert_eq!(beyond.whirl(whirl).count_below(1.0).err(), error);
        }
    }
    let beyond = |speed| Strut { force: 1.01 * PI * PI, speed }.build();
    let error = critical_speeds::<4, _>(1.0..=10.0, Whirl::Forward, 1.0, beyond).err();
    assert_eq!(error, Some(SpeedError::Search(SearchError::Unstable { modes: 1 })));
}

/// Errors of searches for speeds have numbers.
#[test]
fn searches_for_speeds_say_what_is_wrong() {
    let build = |speed| Still { speed }.build();
    for order in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = critical_speeds::<4, _>(1.0..=2.0, Whirl::Forward, order, build).err();
        assert!(matches!(error, Some(SpeedError::Order { .. })), "{error:?}");
    }
    let error = critical_speeds::<4, _>(2.0..=1.0, Whirl::Forward, 1.0, build).err();
    assert_eq!(error, Some(SpeedError::Search(SearchError::Range { start: 2.0, end: 1.0 })));
    let error = critical_speeds::<4, _>(-1.0..=1.0, Whirl::Forward, 1.0, build).err();
    assert_eq!(error, Some(SpeedError::Negative { speed: -1.0 }));
    let error = critical_speeds::<1, _>(1.0..=1e5, Whirl::Backward, 1.0, build).err();
    assert_eq!(error, Some(SpeedError::Search(SearchError::Capacity { capacity: 1 })));
    // bearings that stiffen faster than the speed grows
    let stiffening =
        |speed: f64| Rigid { mass: 1.0, id: 1.0, ip: 0.0, k: 0.1 * speed.powi(4), k_theta: 1e9, speed }.build();
    let error = critical_speeds::<4, _>(1.0..=10.0, Whirl::Forward, 1.0, stiffening).err();
    assert!(matches!(error, Some(SpeedError::Falls { .. })), "{error:?}");
    let error = critical_speeds::<4, _>(1.0..=10.0, Whirl::Forward, 1.0, |speed| {
        Rigid { mass: -1.0, id: 1.0, ip: 0.0, k: 1.0, k_theta: 1.0, speed }.build()
    });
    let text = error.err().map_or_else(String::new, |error| error.to_string());
    assert!(text.contains("at the speed 1 rad/s") && text.contains("disc 1"), "{text}");
}
