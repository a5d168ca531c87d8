//! Shares of elements in the energies of a mode, against sums by hand and quadrature.

use mstmm::prelude::*;

system! {
    struct Chain { k1: f64, m1: f64, k2: f64, c2: f64, m2: f64 }
    fixed -> spring 1 { stiffness: k1 } -> mass 2 { mass: m1 } -> spring 3 { stiffness: k2, damping: c2 }
          -> mass 4 { mass: m2 } -> free;
}

system! {
    struct Carrier { l: f64, ei: f64, m: f64, k: f64, mass: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> conn 2;
    conn 2 <- spring 3 { stiffness: k } <- fixed;
    free -> point_mass 4 { mass, inertia: 0.0 } -> conn 2 -> free;
}

fn assert_close(actual: f64, expected: f64) {
    assert!((actual - expected).abs() < 1e-12, "{actual} is not {expected}");
}

/// Averaged over a cycle the energies of a spring, a mass and a dashpot are proportional to `k |ΔY|²`, `m |Y|²` and `c |ΔY|²`.
#[test]
fn shares_of_a_damped_chain() {
    let Chain { k1, m1, k2, m2, .. } = Chain { k1: 3.0, m1: 0.5, k2: 7.0, c2: 0.4, m2: 2.0 };
    let system = Chain { k1, m1, k2, c2: 0.4, m2 }.build().unwrap();
    for root in &system.first_eigenvalues::<2>().unwrap() {
        let shape = system.mode_shape(root).unwrap();
        let [y1, y2] = [Chain::mass_2.output(), Chain::mass_4.output()].map(|point| shape.state(point).y);
        let [strain_1, strain_2] = [k1 * y1.norm_sqr(), k2 * (y2 - y1).norm_sqr()];
        let [kinetic_1, kinetic_2] = [m1 * y1.norm_sqr(), m2 * y2.norm_sqr()];
        let (first, second) = (shape.energy_shares(Chain::spring_1), shape.energy_shares(Chain::spring_3));
        assert_close(first.strain, strain_1 / (strain_1 + strain_2));
        assert_close(second.strain, strain_2 / (strain_1 + strain_2));
        assert_eq!((first.dissipated, second.dissipated, first.kinetic), (0.0, 1.0, 0.0));
        assert_close(shape.energy_shares(Chain::mass_2).kinetic, kinetic_1 / (kinetic_1 + kinetic_2));
        assert_close(shape.energy_shares(Chain::mass_4).kinetic, kinetic_2 / (kinetic_1 + kinetic_2));
    }
}

/// The energies of the beam by Simpson's rule on its states.
#[test]
fn shares_of_a_beam() {
    let (l, ei, m, k, mass) = (1.3, 20.0, 0.6, 400.0, 0.3);
    let system = Carrier { l, ei, m, k, mass }.build().unwrap();
    for root in &system.first_frequencies::<5>().unwrap() {
        let shape = system.mode_shape(root).unwrap();
        let intervals = 4000;
        let (mut strain, mut kinetic) = (0.0, 0.0);
        for sample in 0..=intervals {
            let weight = if sample % intervals == 0 { 1.0 } else { f64::from(2 + 2 * (sample % 2)) };
            let state = shape.along(Carrier::beam_1, l * f64::from(sample) / f64::from(intervals)).unwrap();
            let width = weight * l / f64::from(3 * intervals);
            (strain, kinetic) = (strain + width * state.m * state.m / ei, kinetic + width * m * state.y * state.y);
        }
        let end = shape.state(Carrier::conn_2).y;
        let (spring, point) = (k * end * end, mass * end * end);
        let [beam, held, carried] = [
            shape.energy_shares(Carrier::beam_1),
            shape.energy_shares(Carrier::spring_3),
            shape.energy_shares(Carrier::point_mass_4),
        ];
        // Simpson's rule errs with the fourth power of the width over that of the waves
        let limit = 1e-9;
        assert!((beam.strain - strain / (strain + spring)).abs() < limit, "{root}: {beam:?}");
        assert!((beam.kinetic - kinetic / (kinetic + point)).abs() < limit, "{root}: {beam:?}");
        assert_close(beam.strain + held.strain, 1.0);
        assert_close(beam.kinetic + carried.kinetic, 1.0);
        assert_eq!((beam.dissipated, carried.strain, held.kinetic), (0.0, 0.0, 0.0));
    }
}
