//! Beams along a line as frames, beside the same as paths, which answer by reciprocity and without loads in a pass.

use super::assert_close;
use mstmm::motion::{Load, PlaneLoad};
use mstmm::prelude::*;

system! {
    struct Path { f: f64, n: f64, k: f64, c: f64 }
    pinned -> beam 1 { length: 1.3, bending_stiffness: 2.0, mass_per_length: 0.8 } -> conn 2
           -> beam 3 {
               length: 0.9, bending_stiffness: 1.0, mass_per_length: 0.5, shear_stiffness: 1.0 / f, rotary_inertia: 0.01, axial_force: n,
               foundation_stiffness: k
           } -> point_mass 4 { mass: 0.4, inertia: 0.1 } -> free;
    conn 2 <- spring 5 { stiffness: 3.0, damping: c } <- fixed;
}

system! {
    struct Line { f: f64, n: f64, k: f64, c: f64 }
    pinned at 0.0 -> beam 1 { bending_stiffness: 2.0, mass_per_length: 0.8 } -> conn 2 at 1.3
        -> beam 3 {
            bending_stiffness: 1.0, mass_per_length: 0.5, shear_stiffness: 1.0 / f, rotary_inertia: 0.01, axial_force: n, foundation_stiffness: k
        } -> conn 4 at 2.2 <- point_mass 6 { mass: 0.4, inertia: 0.1 };
    conn 2 <- spring 5 { stiffness: 3.0, damping: c } <- fixed;
}

#[test]
fn frames_agree_with_paths() {
    for (f, n, k, c) in [(0.0, 0.0, 0.0, 0.0), (0.05, 4.0, 30.0, 0.3), (0.001, 2e4, 0.0, 0.0), (0.01, -0.5, 900.0, 1.0)]
    {
        let (path, line) = (Path { f, n, k, c }.build().unwrap(), Line { f, n, k, c }.build().unwrap());
        let entries = [
            (Path::conn_2.deflection(), Line::conn_2.displacement_y()),
            (Path::conn_2.rotation(), Line::conn_2.rotation_z()),
            (Path::beam_1.output().moment(), Line::beam_1.output().moment()),
            (Path::beam_3.input().shear(), Line::beam_3.input().shear()),
            (Path::beam_3.input().moment(), Line::beam_3.input().moment()),
            (Path::point_mass_4.output().deflection(), Line::conn_4.displacement_y()),
            (Path::beam_1.input().rotation(), Line::beam_1.input().rotation_z()),
        ];
        let loads = [
            (Path::beam_1.uniform_load(), Line::beam_1.uniform_load_y()),
            (Path::beam_3.uniform_load(), Line::beam_3.uniform_load_y()),
            (Load::self_weight(), PlaneLoad::self_weight_y()),
        ];
        // 36.0, 100.0 and 196.0: beside clamped frequencies of the first beam; the last ones have three hundred waves
        for lambda in [
            (0.0, 0.0),
            (0.0, 1e-3),
            (0.0, 0.4),
            (-0.1, 3.0),
            (0.2, 20.9),
            (0.0, 57.7),
            (-1.0, 300.0),
            (0.0, 7e5),
            (-2e3, 8e5),
        ] {
            let lambda = Complex::new(lambda.0, lambda.1);
            for (of_path, of_line) in loads {
                let mut compared = Vec::new();
                for (entry, same) in entries {
                    let expected = path.frequency_response(of_path, entry).unwrap().at(lambda).unwrap();
                    let actual = line.frequency_response(of_line, same).unwrap().at(lambda).unwrap();
                    compared.push((actual, expected));
                }
                for (number, (actual, expected)) in compared.into_iter().enumerate() {
                    let size = 1e-9 * expected.norm() + 1e-13 / (1.0 + lambda.norm());
                    assert!((actual - expected).norm() <= size, "{number} at {lambda}: {actual} is not {expected}");
                }
            }
        }
        let total: f64 = 1.3 * 0.8 + 0.9 * 0.5 + 0.4;
        if k == 0.0 {
            let at = |entry| {
                line.frequency_response(PlaneLoad::self_weight_y(), entry)
                    .unwrap()
                    .at(Complex::new(0.0, 0.0))
                    .unwrap()
                    .re
            };
            let carried = -at(Line::beam_1.input().shear()) + 3.0 * at(Line::conn_2.displacement_y());
            assert_close(carried, total, 1e-12 * total);
        }
    }
}
