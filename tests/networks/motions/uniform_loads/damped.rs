//! Weights on frames of damped materials: those of the undamped frame at another frequency, inside of members, too.

use mstmm::motion::PlaneLoad;
use mstmm::prelude::*;

system! {
    struct Damped { eta: f64, time: f64 }
    section steel {
        axial_stiffness: 600.0, bending_stiffness: 3.0, mass_per_length: 0.9, loss_factor: eta, kelvin_voigt_time: time
    }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.3, 1.5) -> beam 2 { ..steel } -> conn b at (1.6, 1.8);
    conn b -> beam 3 { ..steel } -> pinned at (2.0, 0.0);
}

system! {
    struct Plain {}
    section steel { axial_stiffness: 600.0, bending_stiffness: 3.0, mass_per_length: 0.9 }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.3, 1.5) -> beam 2 { ..steel } -> conn b at (1.6, 1.8);
    conn b -> beam 3 { ..steel } -> pinned at (2.0, 0.0);
}

/// Oracle: with all stiffnesses times e the motion at λ is that without damping at `λ/√e`, displacements over e and the same internal forces.
#[test]
fn weights_of_damped_frames_are_those_of_plain_ones_at_another_frequency() {
    let (eta, time) = (0.2, 3e-3);
    let (damped, plain) = (Damped { eta, time }.build().unwrap(), Plain {}.build().unwrap());
    for load in [0, 1] {
        let weight = [PlaneLoad::self_weight_x(), PlaneLoad::self_weight_y()][load];
        let same = [PlaneLoad::self_weight_x(), PlaneLoad::self_weight_y()][load];
        let own = damped.frequency_response(weight, Damped::conn_b.displacement_y()).unwrap();
        let other = plain.frequency_response(same, Plain::conn_b.displacement_y()).unwrap();
        for lambda in [(0.0, 0.1), (0.0, 4.0), (-0.3, 11.0), (0.0, 120.0)] {
            let lambda = Complex::new(lambda.0, lambda.1);
            let factor = Complex::new(1.0, eta) * (1.0 + time * lambda);
            let at = lambda / factor.sqrt();
            let (one, two) = (own.states(lambda).unwrap(), other.states(at).unwrap());
            for distance in [0.0, 0.2, 0.77, 1.1] {
                let found = one.along(Damped::beam_2, distance).unwrap();
                let expected = two.along(Plain::beam_2, distance).unwrap();
                let pairs = [
                    (found.displacement_x * factor, expected.displacement_x, 1.0),
                    (found.displacement_y * factor, expected.displacement_y, 1.0),
                    (found.axial_force, expected.axial_force, 100.0),
                    (found.moment, expected.moment, 10.0),
                ];
                for (number, (found, expected, size)) in pairs.into_iter().enumerate() {
                    let error = (found - expected).norm();
                    assert!(error < 1e-11 * (expected.norm() + size), "{number} at {lambda}: {found}, not {expected}");
                }
            }
        }
    }
}
