//! A uniform load as many point loads, on a model that is cut where they act.

use mstmm::prelude::*;

/// Nodes and weights of Gauss and Legendre on [0, 1].
const GAUSS: [(f64, f64); 7] = [
    (0.025_446_043_828_620_737, 0.064_742_483_084_434_85),
    (0.129_234_407_200_302_8, 0.139_852_695_744_638_33),
    (0.297_077_424_311_301_4, 0.190_915_025_252_559_47),
    (0.5, 0.208_979_591_836_734_7),
    (0.702_922_575_688_698_6, 0.190_915_025_252_559_47),
    (0.870_765_592_799_697_2, 0.139_852_695_744_638_33),
    (0.974_553_956_171_379_3, 0.064_742_483_084_434_85),
];

system! {
    /// A frame of two arms with a damper, a body and a spring.
    struct Whole { l: f64, c: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: 2.0, mass_per_length: 0.8 } -> conn 2
          -> body 3 { mass: 0.5, inertia_about_input: 0.1, output_x: 0.3, centre_x: 0.1 } -> beam 4 {
              length: 0.7, bending_stiffness: 1.0, mass_per_length: 0.5, shear_stiffness: 30.0, rotary_inertia: 0.02
          } -> pinned;
    conn 2 <- spring 5 { stiffness: 3.0, damping: c } <- mass 6 { mass: 0.2 } <- free;
}

system! {
    /// The same with the first beam in parts.
    struct Cut { l: f64, c: f64 }
    fixed -> beam 11 { length: GAUSS[0].0 * l, bending_stiffness: 2.0, mass_per_length: 0.8 }
          -> beam 12 { length: (GAUSS[1].0 - GAUSS[0].0) * l, bending_stiffness: 2.0, mass_per_length: 0.8 }
          -> beam 13 { length: (GAUSS[2].0 - GAUSS[1].0) * l, bending_stiffness: 2.0, mass_per_length: 0.8 }
          -> beam 14 { length: (GAUSS[3].0 - GAUSS[2].0) * l, bending_stiffness: 2.0, mass_per_length: 0.8 }
          -> beam 15 { length: (GAUSS[4].0 - GAUSS[3].0) * l, bending_stiffness: 2.0, mass_per_length: 0.8 }
          -> beam 16 { length: (GAUSS[5].0 - GAUSS[4].0) * l, bending_stiffness: 2.0, mass_per_length: 0.8 }
          -> beam 17 { length: (GAUSS[6].0 - GAUSS[5].0) * l, bending_stiffness: 2.0, mass_per_length: 0.8 }
          -> beam 18 { length: (1.0 - GAUSS[6].0) * l, bending_stiffness: 2.0, mass_per_length: 0.8 } -> conn 2
          -> body 3 { mass: 0.5, inertia_about_input: 0.1, output_x: 0.3, centre_x: 0.1 } -> beam 4 {
              length: 0.7, bending_stiffness: 1.0, mass_per_length: 0.5, shear_stiffness: 30.0, rotary_inertia: 0.02
          } -> pinned;
    conn 2 <- spring 5 { stiffness: 3.0, damping: c } <- mass 6 { mass: 0.2 } <- free;
}

/// Entries of all kinds, on both sides of the load, at its ends and on a branch.
#[test]
fn many_point_loads_are_a_uniform_load() {
    let l = 1.2;
    for c in [0.0, 0.4] {
        let (whole, cut) = (Whole { l, c }.build().unwrap(), Cut { l, c }.build().unwrap());
        let points = [
            Cut::beam_11.output(),
            Cut::beam_12.output(),
            Cut::beam_13.output(),
            Cut::beam_14.output(),
            Cut::beam_15.output(),
            Cut::beam_16.output(),
            Cut::beam_17.output(),
        ];
        let entries = [
            (Whole::beam_1.input().moment(), Cut::beam_11.input().moment()),
            (Whole::beam_1.input().shear(), Cut::beam_11.input().shear()),
            (Whole::beam_1.output().moment(), Cut::beam_18.output().moment()),
            (Whole::beam_1.output().shear(), Cut::beam_18.output().shear()),
            (Whole::conn_2.deflection(), Cut::conn_2.deflection()),
            (Whole::conn_2.rotation(), Cut::conn_2.rotation()),
            (Whole::conn_2.shear(), Cut::conn_2.shear()),
            (Whole::body_3.output().moment(), Cut::body_3.output().moment()),
            (Whole::beam_4.output().rotation(), Cut::beam_4.output().rotation()),
            (Whole::mass_6.output().deflection(), Cut::mass_6.output().deflection()),
            (Whole::spring_5.input().shear(), Cut::spring_5.input().shear()),
        ];
        for lambda in [(0.0, 0.0), (0.0, 0.7), (0.0, 3.0), (-0.4, 5.0), (0.3, 9.0), (1.5, 0.0)] {
            let lambda = Complex::new(lambda.0, lambda.1);
            for (number, (entry, same)) in entries.into_iter().enumerate() {
                let load = Whole::beam_1.uniform_load();
                let actual = whole.frequency_response(load, entry).unwrap().at(lambda).unwrap();
                let parts = points.iter().zip(GAUSS).map(|(point, (_, weight))| {
                    cut.frequency_response(point.force(), same).unwrap().at(lambda).unwrap() * weight * l
                });
                let (sum, size) =
                    parts.fold((Complex::new(0.0, 0.0), 0.0), |(sum, size), part| (sum + part, size + part.norm()));
                assert!((actual - sum).norm() <= 1e-12 * size, "entry {number} at {lambda}: {actual} is not {sum}");
            }
        }
    }
}
