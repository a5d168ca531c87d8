//! States inside of loaded members, beside those at the joints of the same members cut in two.

use mstmm::prelude::*;

system! {
    #[derive(Clone, Copy)]
    struct Whole { f: f64, r: f64, n: f64, k: f64, ea: f64 }
    fixed at (0.0, 0.0) -> beam 1 {
        axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
        foundation_stiffness: k
    } -> conn a at (1.2, 0.5) -> beam 2 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned at (1.0, -1.0);
}

system! {
    struct Cut { f: f64, r: f64, n: f64, k: f64, ea: f64 }
    fixed at (0.0, 0.0) -> beam 1 {
        axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
        foundation_stiffness: k
    } -> conn b at (0.36, 0.15) -> beam 3 {
        axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
        foundation_stiffness: k
    } -> conn a at (1.2, 0.5) -> beam 2 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> conn c at (1.08, -0.4) -> beam 4 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> pinned at (1.0, -1.0);
}

type C = Complex<f64>;

#[track_caller]
fn assert_same(actual: [C; 6], expected: [C; 6], what: &str) {
    let size = |parts: &[C]| parts.iter().map(|part| part.norm()).fold(0.0, f64::max);
    for (own, exact) in [0..3, 3..6].map(|range| (&actual[range.clone()], &expected[range])).into_iter() {
        for (one, other) in own.iter().zip(exact) {
            assert!((one - other).norm() <= 2e-11 * size(exact), "{what}: {actual:?} is not {expected:?}");
        }
    }
}

/// In all regimes of wave numbers, at rest, between and beyond their limits, damped or not.
#[test]
fn states_inside_of_loaded_members() {
    let plain = Whole { f: 0.0, r: 0.0, n: 0.0, k: 0.0, ea: 40.0 };
    let beams = [
        plain,
        Whole { f: 0.05, r: 0.002, ..plain },
        Whole { n: 300.0, ..plain },
        Whole { n: 1e5, ..plain },
        Whole { n: -4.0, ..plain },
        Whole { k: 1e-3, ..plain },
        Whole { k: 500.0, f: 0.01, ..plain },
        Whole { k: 1e7, n: 50.0, ..plain },
    ];
    for Whole { f, r, n, k, ea } in beams {
        let (whole, cut) = (Whole { f, r, n, k, ea }.build().unwrap(), Cut { f, r, n, k, ea }.build().unwrap());
        for lambda in [(0.0, 0.0), (0.0, 0.01), (-0.05, 0.9), (0.0, 3.3), (0.1, 23.0), (0.0, 611.0), (-20.0, 9e3)] {
            let lambda = C::new(lambda.0, lambda.1);
            let pairs = [
                (Whole::beam_1.uniform_load_x(), [Cut::beam_1.uniform_load_x(), Cut::beam_3.uniform_load_x()]),
                (Whole::beam_1.uniform_load_y(), [Cut::beam_1.uniform_load_y(), Cut::beam_3.uniform_load_y()]),
                (Whole::beam_2.uniform_load_y(), [Cut::beam_2.uniform_load_y(), Cut::beam_4.uniform_load_y()]),
                (Whole::beam_2.uniform_load_x(), [Cut::beam_2.uniform_load_x(), Cut::beam_4.uniform_load_x()]),
            ];
            for (number, (load, parts)) in pairs.into_iter().enumerate() {
                let states =
                    whole.frequency_response(load, Whole::conn_a.displacement_x()).unwrap().states(lambda).unwrap();
                let halves = parts.map(|load| {
                    cut.frequency_response(load, Cut::conn_a.displacement_x()).unwrap().states(lambda).unwrap()
                });
                let sum = |entry| halves.iter().map(|half| half.value(entry).unwrap()).sum::<C>();
                let [first, second] = [1.3 * 0.3, (0.2_f64 * 0.2 + 1.5 * 1.5).sqrt() * 0.6];
                let joints = [
                    (states.along(Whole::beam_1, first).unwrap(), Cut::conn_b, Cut::beam_1.output()),
                    (states.along(Whole::beam_2, second).unwrap(), Cut::conn_c, Cut::beam_2.output()),
                ];
                for (inside, point, end) in joints {
                    let actual = [
                        inside.displacement_x,
                        inside.displacement_y,
                        inside.rotation_z,
                        inside.axial_force,
                        inside.shear,
                        inside.moment,
                    ];
                    let expected = [
                        sum(point.displacement_x()),
                        sum(point.displacement_y()),
                        sum(point.rotation_z()),
                        sum(end.axial_force()),
                        sum(end.shear()),
                        sum(end.moment()),
                    ];
                    assert_same(actual, expected, &format!("load {number}, f {f}, n {n}, k {k} at {lambda}"));
                }
            }
        }
    }
}
