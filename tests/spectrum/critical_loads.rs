//! Critical loads: Euler's cases, Engesser's load, columns on foundations, against closed forms.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use mstmm::prelude::*;
use mstmm::search::{CriticalLoad, LoadError, SearchError, critical_loads};
use std::f64::consts::PI;

/// Declares columns of length 1 and EI = 1 under a force, between two supports.
macro_rules! columns {
    ($($model:ident = $tip:ident, $root:ident;)*) => {$(
        system! {
            struct $model { force: f64 }
            $tip -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force } -> $root
        }
    )*};
}
columns! {
    Cantilever = fixed, free;
    Pinned = pinned, pinned;
    Propped = fixed, pinned;
    Clamped = fixed, fixed;
    Sliding = guided, pinned;
    Free = free, free;
}

system! {
    struct Sheared { force: f64, flexibility: f64 }
    pinned -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force, shear_stiffness: 1.0 / flexibility
    } -> pinned
}

system! {
    struct Founded { force: f64, k: f64 }
    pinned -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force, foundation_stiffness: k
    } -> pinned
}

system! {
    /// A column with a spring at its middle.
    struct Braced { force: f64, stiffness: f64 }
    pinned -> beam 1 { length: 0.5, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force } -> conn 2
        -> beam 3 { length: 0.5, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force } -> pinned;
    conn 2 <- spring 4 { stiffness } <- fixed
}

system! {
    struct Pulled { force: f64 }
    pinned -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: force } -> pinned
}

fn loads<const N: usize, Y: mstmm::search::Undamped<Parameter = f64>>(
    end: f64,
    build: impl FnMut(f64) -> Result<Y, mstmm::element::ParameterError>,
) -> Vec<CriticalLoad> {
    critical_loads::<N, _>(0.0..=end, build).unwrap().to_vec()
}

#[track_caller]
fn assert_loads(found: &[CriticalLoad], exact: &[f64]) {
    assert_eq!(found.len(), exact.len(), "{found:?}");
    for (load, exact) in found.iter().zip(exact) {
        assert!((load.factor / exact - 1.0).abs() <= 1e-14, "{} beside {exact}", load.factor);
        // the closed forms are rounded, too
        let room = 8.0 * f64::EPSILON * exact;
        assert!(load.lower <= exact + room && exact - room <= load.upper, "{load:?} beside {exact}");
        assert!(load.upper - load.lower <= 4.0 * f64::EPSILON * exact, "{load:?}");
        assert_eq!(load.multiplicity, 1);
    }
}

/// Roots of `tan z = z` and their squares; published are 20.190728556, 59.679515944.
fn tangent(n: u32) -> f64 {
    let mut z = (f64::from(n) + 0.5) * PI;
    for _ in 0..50 {
        z = f64::from(n) * PI + z.atan();
    }
    z * z
}

#[test]
fn eulers_cases() {
    let square = |n: f64| (n * PI).powi(2);
    assert_loads(&loads::<4, _>(130.0, |force| Cantilever { force }.build()), &[0.5, 1.5, 2.5, 3.5].map(square));
    assert_loads(&loads::<3, _>(100.0, |force| Pinned { force }.build()), &[1.0, 2.0, 3.0].map(square));
    assert_loads(&loads::<3, _>(130.0, |force| Propped { force }.build()), &[1, 2, 3].map(tangent));
    let clamped = [square(2.0), 4.0 * tangent(1), square(4.0), 4.0 * tangent(2)];
    assert_loads(&loads::<4, _>(240.0, |force| Clamped { force }.build()), &clamped);
    assert_loads(&loads::<2, _>(30.0, |force| Sliding { force }.build()), &[0.5, 1.5].map(square));
}

/// Engesser: `P = N/(1 + N f)` for each Euler load N.
#[test]
fn engessers_load_is_eulers_with_shear() {
    for flexibility in [0.0, 1e-3, 0.02, 0.3] {
        let exact = [1.0, 2.0].map(|n: f64| {
            let euler = (n * PI).powi(2);
            euler / (1.0 + euler * flexibility)
        });
        let end = exact[1] * 1.0001;
        assert_loads(&loads::<2, _>(end, |force| Sheared { force, flexibility }.build()), &exact);
    }
}

/// A pinned column on a foundation buckles in the number of half waves for which `n²π² + k/(n²π²)` is least.
#[test]
fn a_column_on_a_foundation_buckles_in_several_waves() {
    for k in [1.0, 1e3, 1e6, 1e9] {
        let mut exact: Vec<f64> = (1..200_u32).map(|n| (f64::from(n) * PI).powi(2)).map(|n2| n2 + k / n2).collect();
        exact.sort_by(f64::total_cmp);
        let end = 0.5 * (exact[2] + exact[3]);
        assert_loads(&loads::<3, _>(end, |force| Founded { force, k }.build()), &exact[..3]);
    }
}

/// From the stiffness 16π² EI/l³ on, a brace in the middle makes the column buckle in two half waves; there both loads coincide.
#[test]
fn a_brace_doubles_the_load() {
    let second = 4.0 * PI * PI;
    let ideal = 16.0 * PI * PI;
    let found = loads::<3, _>(60.0, |force| Braced { force, stiffness: 0.5 * ideal }.build());
    // l²/4 of the half: z/2 (1 - tan(z/2)/(z/2)) k = .. is solved where both loads coincide, and below it at the first load
    assert_eq!(found.len(), 2);
    assert!(found[0].factor < second && (found[1].factor / second - 1.0).abs() < 1e-14);
    let stiff = loads::<2, _>(60.0, |force| Braced { force, stiffness: 2.0 * ideal }.build());
    assert!((stiff[0].factor / second - 1.0).abs() < 1e-14, "{stiff:?}");
    let both = loads::<2, _>(second * 1.01, |force| Braced { force, stiffness: ideal }.build());
    let count: u64 = both.iter().map(|load| load.multiplicity).sum();
    assert_eq!(count, 2, "{both:?}");
}

#[test]
fn what_cannot_be_certified_is_refused() {
    let falls = critical_loads::<4, _>(-50.0..=50.0, |force| Pulled { force }.build());
    assert!(matches!(falls, Err(LoadError::Falls { .. })), "{falls:?}");
    let free = critical_loads::<4, _>(0.0..=5.0, |force| Free { force }.build());
    assert!(matches!(free, Err(LoadError::Search(SearchError::Zero { .. }))), "{free:?}");
    let empty = critical_loads::<4, _>(5.0..=5.0, |force| Pinned { force }.build());
    assert!(matches!(empty, Err(LoadError::Search(SearchError::Range { .. }))));
    let full = critical_loads::<1, _>(0.0..=100.0, |force| Pinned { force }.build());
    assert!(matches!(full, Err(LoadError::Search(SearchError::Capacity { capacity: 1 }))));
    let beyond = critical_loads::<1, _>(0.0..=5.0, |force| Sheared { force, flexibility: 0.5 }.build());
    assert!(matches!(beyond, Err(LoadError::Parameter { .. })), "{beyond:?}");
    let message = beyond.err().map(|error| error.to_string()).unwrap_or_default();
    assert!(message.contains("at the load factor 5: beam 1: axial_force is -5"), "{message}");
}

/// Beyond its critical load a column has as many motions that grow as there are loads below.
#[test]
fn motions_grow_beyond_critical_loads() {
    for (force, modes) in [(9.8, 0), (9.9, 1), (39.4, 1), (39.5, 2), (88.9, 3)] {
        let column = Pinned { force }.build().unwrap();
        assert_eq!(column.unstable_modes(), Ok(modes));
        assert_eq!(column.first_frequencies::<1>().is_err(), modes > 0);
    }
}
