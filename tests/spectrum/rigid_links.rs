//! Rigid links and bodies under axial force: Euler's link models in closed form, and stiff struts.

use mstmm::prelude::*;
use mstmm::search::{SearchError, critical_loads};

system! {
    /// A rigid column on a torsion spring at its foot, with a mass at its head.
    struct Pendulum { load: f64, k: f64, b: f64, mass: f64, inertia: f64 }
    fixed -> hinge 1 { stiffness_rz: k } -> rigid_link 2 { output_x: b, axial_force: -load }
          -> point_mass 3 { mass, inertia } -> free;
}

system! {
    /// The same as a body that has the mass at its head.
    struct Tower { load: f64, k: f64, b: f64, mass: f64, inertia: f64 }
    fixed -> hinge 1 { stiffness_rz: k }
          -> body 2 { mass, inertia_about_input: inertia + mass * b * b, output_x: b, centre_x: b, axial_force: -load } -> free;
}

system! {
    /// Two links with two equal torsion springs, the first of them at the foot.
    struct Links { load: f64, k: f64, b: f64 }
    fixed -> hinge 1 { stiffness_rz: k } -> rigid_link 2 { output_x: b, axial_force: -load } -> point_mass 3 { mass: 2.0, inertia: 0.0 }
          -> hinge 4 { stiffness_rz: k } -> rigid_link 5 { output_x: b, axial_force: -load } -> point_mass 6 { mass: 1.0, inertia: 0.0 }
          -> free;
}

system! {
    /// Two links between pins, with a torsion spring or a spring to the ground at their joint.
    struct Knee { load: f64, k: f64, side: f64, b: f64, to_end: f64 }
    pinned -> rigid_link 1 { output_x: b, axial_force: -load } -> point_mass 2 { mass: 1.0, inertia: 0.0 } -> conn 3
           -> hinge 4 { stiffness_rz: k } -> rigid_link 5 { output_x: to_end, axial_force: -load } -> pinned;
    conn 3 <- spring 6 { stiffness: side } <- fixed;
}

#[track_caller]
fn assert_close(actual: f64, expected: f64, tolerance: f64) {
    assert!((actual / expected - 1.0).abs() <= tolerance, "{actual} beside {expected}");
}

/// Closed form: `P = K/b`, for links in both directions, and `J ω² = K - P |b|` with `J = m b² + J_C`.
#[test]
fn a_rigid_column_falls_at_its_springs_moment_over_its_length() {
    let (k, mass, inertia) = (3.0, 2.0, 0.25);
    for b in [0.5_f64, 2.0, -0.75] {
        let critical = k / b.abs();
        let column = |load| Pendulum { load, k, b, mass, inertia };
        let tower = |load| Tower { load, k, b, mass, inertia };
        let found = critical_loads::<1, _>(0.0..=2.0 * critical, |load| column(load).build()).unwrap();
        assert_close(found[0].factor, critical, 1e-14);
        let found = critical_loads::<1, _>(0.0..=2.0 * critical, |load| tower(load).build()).unwrap();
        assert_close(found[0].factor, critical, 1e-14);
        for share in [-3.0, -0.5, 0.5, 0.999] {
            let omega = ((k - share * critical * b.abs()) / (mass * b * b + inertia)).sqrt();
            let [one, other] = [
                column(share * critical).build().unwrap().first_frequencies::<1>().unwrap()[0].omega,
                tower(share * critical).build().unwrap().first_frequencies::<1>().unwrap()[0].omega,
            ];
            assert_close(one, omega, 1e-12);
            assert_close(other, omega, 1e-12);
        }
        let fallen = column(1.001 * critical).build().unwrap();
        assert_eq!(fallen.unstable_modes(), Ok(1));
        assert!(matches!(fallen.first_frequencies::<1>(), Err(SearchError::Unstable { modes: 1 })));
        assert_eq!(tower(1.001 * critical).build().unwrap().unstable_modes(), Ok(1));
    }
}

/// Closed forms: `P b/K = (3 ± √5)/2` of two links with two springs; `P = K (1/a + 1/b)` of a knee with a torsion spring and
/// `P = k a b/(a + b)` of one with a spring to the ground.
#[test]
fn two_links_buckle_in_their_two_ways() {
    let (k, b) = (1.5, 0.8);
    let found = critical_loads::<2, _>(0.0..=10.0, |load| Links { load, k, b }.build()).unwrap();
    for (load, sign) in found.iter().zip([-1.0, 1.0]) {
        assert_close(load.factor, k / b * (3.0 + sign * 5.0_f64.sqrt()) / 2.0, 1e-14);
    }
    assert_eq!(found.len(), 2);
    let to_end = 1.2;
    let both = |k, side| {
        critical_loads::<1, _>(0.0..=100.0, |load| Knee { load, k, side, b, to_end }.build()).unwrap()[0].factor
    };
    let (turn, side) = (k * (1.0 / b + 1.0 / to_end), 7.0 * b * to_end / (b + to_end));
    assert_close(both(k, 1e-9), turn, 1e-8);
    assert_close(both(0.0, 7.0), side, 1e-14);
    assert_close(both(k, 7.0), turn + side, 1e-14);
}

system! {
    struct OnStrut { load: f64, stiff: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: 1.5, axial_force: -load }
          -> beam 2 { length: 0.5, bending_stiffness: stiff, mass_per_length: 1.0 / stiff, axial_force: -load }
          -> point_mass 3 { mass: 0.75, inertia: 0.125 } -> free;
}

system! {
    struct OnLever { load: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: 1.5, axial_force: -load }
          -> rigid_link 2 { output_x: 0.5, axial_force: -load } -> point_mass 3 { mass: 0.75, inertia: 0.125 } -> free;
}

/// The lever is the limit of a stiff strut, in frequencies and in critical loads.
#[test]
fn a_loaded_lever_is_a_stiff_strut() {
    let stiff = 1e9;
    for load in [-5.0, 0.9] {
        let lever = OnLever { load }.build().unwrap().first_frequencies::<8>().unwrap();
        let strut = OnStrut { load, stiff }.build().unwrap().first_frequencies::<8>().unwrap();
        for (one, other) in lever.iter().zip(strut.iter()) {
            assert_close(one.omega, other.omega, 1e-7);
        }
    }
    let lever = critical_loads::<8, _>(0.0..=150.0, |load| OnLever { load }.build()).unwrap();
    let strut = critical_loads::<8, _>(0.0..=150.0, |load| OnStrut { load, stiff }.build()).unwrap();
    assert_eq!((lever.len(), strut.len()), (3, 3));
    for (one, other) in lever.iter().zip(strut.iter()) {
        assert_close(one.factor, other.factor, 1e-7);
    }
}

/// Closed forms: derivatives of `ω² = (K - P |b|)/(m b² + J_C)`, the deflection `b²/(K - P |b|)` of the head under 1 N at rest, and
/// strain energies of the spring and of the load in the shares `K : -P |b|`.
#[test]
fn motions_of_a_rigid_column_in_closed_form() {
    let (k, mass, inertia) = (3.0, 2.0, 0.25);
    for (b, load) in [(0.5_f64, 2.0), (0.5, -2.0), (-0.75, 1.0)] {
        let system = Pendulum { load, k, b, mass, inertia }.build().unwrap();
        let root = system.first_frequencies::<1>().unwrap()[0];
        let (net, about) = (k - load * b.abs(), mass * b * b + inertia);
        let change = system.sensitivity(&root).unwrap();
        assert_close(change.get("load").unwrap(), -b.abs() / (2.0 * root.omega * about), 1e-11);
        let by_lever = (-load * b.signum() * about - net * 2.0 * mass * b) / (about * about);
        assert_close(change.get("b").unwrap(), by_lever / (2.0 * root.omega), 1e-11);
        let head = Pendulum::rigid_link_2.output();
        let response = system.frequency_response(head.force(), head.deflection()).unwrap();
        assert_close(response.at(0.0).unwrap(), b * b / net, 1e-12);
        assert_close(response.at(2.0 * root.omega).unwrap(), b * b / (-3.0 * net), 1e-12);
        let shape = system.mode_shape(&root).unwrap();
        let [spring, lever] = [shape.energy_shares(Pendulum::hinge_1), shape.energy_shares(Pendulum::rigid_link_2)];
        assert_close(spring.strain, k / net, 1e-11);
        assert_close(lever.strain, -load * b.abs() / net, 1e-11);
    }
}
