//! Levers: closed forms, bodies without mass, stiff beams.

use mstmm::prelude::*;

system! {
    /// A rigid pendulum on a spring.
    struct Pendulum { b: f64, k: f64, m: f64, j: f64 }
    pinned -> rigid_link 1 { output_x: b } -> conn 2 -> point_mass 3 { mass: m, inertia: j } -> free;
    conn 2 <- spring 4 { stiffness: k } <- fixed;
}

/// Closed form: `ω² = k b²/(m b² + J)`, for levers in both directions.
#[test]
fn a_mass_on_a_lever_is_a_pendulum() {
    for (b, k, m, j) in [(0.7, 3.0, 2.0, 0.5), (-0.7, 3.0, 2.0, 0.5), (1e-9, 3.0, 2.0, 0.5), (-1e6, 1e-3, 2.0, 0.5)] {
        let found = Pendulum { b, k, m, j }.build().unwrap().first_frequencies::<1>().unwrap();
        let expected = (k * b * b / (m * b * b + j)).sqrt();
        let root = &found[0];
        assert!((root.omega - expected).abs() < 8.0 * f64::EPSILON * expected, "{root:?} instead of {expected}");
        assert_eq!((found.len(), root.multiplicity), (1, 1));
    }
    // on a lever of no length nothing turns it back
    let none = Pendulum { b: 0.0, k: 3.0, m: 2.0, j: 0.5 }.build().unwrap().first_frequencies::<1>().unwrap();
    assert_eq!((none[0].omega, none[0].multiplicity), (0.0, 1));
}

system! {
    /// A mass beside the end of a beam, on a lever.
    struct OnLever { b: f64, m: f64, j: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> rigid_link 2 { output_x: b }
          -> point_mass 3 { mass: m, inertia: j } -> free;
}

system! {
    /// The same as one body.
    struct AsBody { b: f64, m: f64, j: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
          -> body 2 { mass: m, inertia_about_input: j + m * b * b, output_x: b, centre_x: b } -> free;
}

system! {
    /// The same on a beam instead of the lever, stiff and light.
    struct OnBeam { b: f64, m: f64, j: f64, stiff: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
          -> beam 2 { length: b, bending_stiffness: stiff, mass_per_length: 1.0 / stiff }
          -> point_mass 3 { mass: m, inertia: j } -> free;
}

#[test]
fn a_lever_is_a_body_without_mass_and_a_stiff_beam() {
    let (m, j) = (0.75, 0.125);
    for b in [0.5, 2.0, -0.5] {
        let found = OnLever { b, m, j }.build().unwrap().first_frequencies::<8>().unwrap();
        let body = AsBody { b, m, j }.build().unwrap().first_frequencies::<8>().unwrap();
        for (one, other) in found.iter().zip(body.iter()) {
            assert!(one.lower <= other.upper && other.lower <= one.upper, "{one:?} {other:?}");
        }
        if b > 0.0 {
            let stiff = 1e9;
            let beam = OnBeam { b, m, j, stiff }.build().unwrap().first_frequencies::<8>().unwrap();
            for (one, other) in found.iter().zip(beam.iter()) {
                // the eighth mode bends the stiff beam most
                assert!((one.omega / other.omega - 1.0).abs() < 1000.0 / stiff, "{one:?} {other:?}");
            }
        }
    }
}

system! {
    /// Levers that lead away and back between beams.
    struct ThereAndBack { b: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> rigid_link 2 { output_x: b } -> rigid_link 3 { output_x: -b }
          -> beam 4 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

system! {
    struct OneBeam { length: f64 }
    fixed -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

/// Levers there and back are none, however long: what cancels is seen, and computed again.
#[test]
fn levers_there_and_back_are_none() {
    let expected = OneBeam { length: 2.0 }.build().unwrap().first_frequencies::<6>().unwrap();
    for b in [0.0, 0.3, -0.3, 1e2, -1e4, 1e6, -1e8, 1e10, -1e12] {
        let found = ThereAndBack { b }.build().unwrap().first_frequencies::<6>().unwrap();
        for (one, other) in found.iter().zip(expected.iter()) {
            assert!(one.lower <= other.upper && other.lower <= one.upper, "{b}: {one:?} {other:?}");
        }
    }
}

system! {
    /// A body with three points, made of levers: its arms hold springs at places of their own.
    struct ThreePoints { m: f64, j: f64, a: f64, b: f64, k: f64 }
    free -> conn 3 -> rigid_link 4 { output_x: a } -> conn 2 -> rigid_link 5 { output_x: b } -> conn 6 -> free;
    free -> point_mass 7 { mass: m, inertia: j } -> conn 2;
    conn 3 <- spring 8 { stiffness: k } <- fixed;
    conn 6 <- spring 9 { stiffness: k } <- fixed;
}

/// Closed form: `K = [[2k, k(b-a)], [k(b-a), k(a²+b²)]]` over the masses m and J.
#[test]
fn a_body_with_several_points_is_made_of_levers() {
    let (m, j, a, b, k) = (2.0, 0.75, 0.5, 1.25, 30.0);
    let found = ThreePoints { m, j, a, b, k }.build().unwrap().first_frequencies::<2>().unwrap();
    let (yy, coupling, turning) = (2.0 * k / m, k * (b - a), k * (a * a + b * b) / j);
    let root = ((yy - turning).powi(2) / 4.0 + coupling * coupling / (m * j)).sqrt();
    for (found, squared) in found.iter().zip([(yy + turning) / 2.0 - root, (yy + turning) / 2.0 + root]) {
        assert!((found.omega - squared.sqrt()).abs() < 1e-13 * found.omega, "{found:?} {squared}");
    }
}

system! {
    /// Two cantilevers whose tips a mass joins over levers.
    struct Joined { first: f64, second: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> rigid_link 2 { output_x: first } -> conn 3;
    fixed -> beam 4 { length: 0.8, bending_stiffness: 2.0, mass_per_length: 1.0 } -> rigid_link 5 { output_x: second } -> conn 3
        -> point_mass 6 { mass: 0.7, inertia: 0.2 } -> free;
}

/// Law: frequencies are continuous. A lever of one metre has coefficients that are exactly 1, and takes other steps of the proof.
#[test]
fn levers_of_one_metre_are_as_good_as_others() {
    for (first, second) in [(1.0, 1.0), (1.0, 2.0), (1.0, 0.5), (-1.0, 0.3), (2.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        let of = |first, second| Joined { first, second }.build().unwrap().first_frequencies::<6>().unwrap();
        let (exact, beside) = (of(first, second), of(first * (1.0 + 1e-9), second * (1.0 - 1e-9)));
        assert!(exact.len() == 6 && beside.len() == 6, "{first} {second}");
        for (root, other) in exact.iter().zip(&beside) {
            assert!(
                root.is_proven && (root.omega / other.omega - 1.0).abs() < 1e-7,
                "{first} {second}: {root:?} {other:?}"
            );
        }
    }
}
