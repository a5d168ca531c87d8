//! Directions of any length, and what is asked of masses on paths.

use mstmm::motion::MotionError;
use mstmm::network::Freedoms;
use mstmm::prelude::*;

system! {
    /// Two beams, with a roller in a direction of any length where they meet, a mass on a spring, and an inertia on a torsion spring.
    struct Leaning { length: f64 }
    section steel {
        axial_stiffness: 900.0, torsional_stiffness: 3.0, bending_stiffness_y: 2.0, bending_stiffness_z: 5.0, mass_per_length: 1.5,
        polar_inertia_per_length: 0.25,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn p at (1.0, 0.5, 0.25) <- roller normal (length, 0.25 * length, 0.5 * length);
    conn p -> beam 2 { ..steel } -> conn tip at (2.0, 0.0, 1.0);
    conn tip <- along (0.0, 3.0, 4.0) <- spring 3 { stiffness: 7.0 } <- mass 4 { mass: 0.3 } <- free;
    conn tip <- about (1.0, 0.0, 0.0) <- torsion_spring 5 { stiffness: 2.0 } <- inertia 6 { inertia: 0.2 } <- free;
}

/// A direction has no length: shapes and sensitivities are the same, and that to its length is none.
#[test]
fn directions_of_any_length_are_one() {
    let [short, long] = [1.0, 1e7].map(|length| Leaning { length }.build().unwrap());
    let [of_short, of_long] = [&short, &long].map(|system| system.first_frequencies::<6>().unwrap());
    for (one, other) in of_short.iter().zip(&of_long) {
        assert!((one.omega / other.omega - 1.0).abs() < 1e-15);
        let [one, own] = [short.mode_shape(one).unwrap(), long.mode_shape(other).unwrap()]
            .map(|shape| shape.motion_of(Leaning::conn_tip).unwrap());
        let sign = (one[0] * own[0]).signum();
        assert!(one.iter().zip(own).all(|(one, own)| (one - sign * own).abs() < 1e-12), "{one:?} {own:?}");
        let slope = long.sensitivity(other).unwrap().get("length").unwrap();
        assert!((slope * 1e7).abs() < 1e-12 * other.omega, "{slope}");
    }
}

/// Under a force that acts slowly a mass on a spring moves as the point at which it hangs, in the direction of its path.
#[test]
fn a_mass_on_a_path_has_one_motion() {
    let system = Leaning { length: 1.0 }.build().unwrap();
    let at_rest = |entry| system.frequency_response(Leaning::conn_tip.force_z(), entry)?.at(0.0);
    let [y, z, turn] =
        [Leaning::conn_tip.displacement_y(), Leaning::conn_tip.displacement_z(), Leaning::conn_tip.rotation_x()]
            .map(|entry| at_rest(entry).unwrap());
    let near = |own: f64, expected: f64| assert!((own - expected).abs() < 1e-13 * expected.abs(), "{own} {expected}");
    near(at_rest(Leaning::mass_4.displacement_x()).unwrap(), 0.6 * y + 0.8 * z);
    near(at_rest(Leaning::inertia_6.rotation_z()).unwrap(), turn);
    let none = |freedom| Err(MotionError::NoSuchFreedom { freedom });
    assert_eq!(at_rest(Leaning::mass_4.displacement_y()), none(Freedoms::Y));
    assert_eq!(at_rest(Leaning::mass_4.displacement_z()), none(Freedoms::Z));
    assert_eq!(at_rest(Leaning::inertia_6.rotation_x()), none(Freedoms::RX));
    let load = system.frequency_response(Leaning::mass_4.force_y(), Leaning::conn_tip.displacement_y());
    assert_eq!(load.map(|_| ()), Err(MotionError::NoSuchFreedom { freedom: Freedoms::Y }));
}
