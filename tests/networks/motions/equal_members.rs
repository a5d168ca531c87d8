//! Members of equal numbers beside members that differ by a few roundings.

use mstmm::motion::PlaneLoad;
use mstmm::prelude::*;

system! {
    /// Two storeys with braces as long as a column. Types, ends and lengths differ where the numbers are equal. `d` makes all numbers differ.
    struct Storeys { d: f64, none: f64 }
    let (ea, ei, m) = (900.0, 2.0, 1.5);
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn a at (0.0, 1.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m * (1.0 + d) } -> conn b at (0.0, 2.0)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m * (1.0 + 2.0 * d) } -> conn c at (0.75, 2.0)
        -> beam 4 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m * (1.0 - d), foundation_stiffness: none }
        -> conn e at (0.75, 1.0)
        -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m * (1.0 - 2.0 * d) } -> pin 6 {}
        -> fixed at (1.5, 0.0);
    conn a -> beam 7 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m * (1.0 + 3.0 * d), rotary_inertia: none }
        -> conn e;
    conn a -> bar 8 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m * (1.0 + 4.0 * d) } -> conn c;
    conn e -> bar 9 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m * (1.0 + 5.0 * d) } -> conn b;
}

/// Oracle: the members that differ, none of which has the chart of another; the difference changes a response by some roundings.
#[test]
fn members_of_equal_numbers_answer_as_those_that_hardly_differ() {
    let [equal, different] = [0.0, 4.0 * f64::EPSILON].map(|d| Storeys { d, none: 0.0 }.build().unwrap());
    let loads = [
        Storeys::conn_b.force_x(),
        Storeys::beam_3.uniform_load_y(),
        Storeys::beam_4.uniform_load_x(),
        Storeys::bar_8.uniform_load_y(),
        PlaneLoad::self_weight_y(),
    ];
    let entries = [Storeys::conn_c.displacement_x(), Storeys::conn_e.rotation_z(), Storeys::beam_7.output().moment()];
    for load in loads {
        for entry in entries {
            for omega in [0.0, 0.3, 2.5, 17.0, 140.0] {
                let [one, other] = [&equal, &different]
                    .map(|system| system.frequency_response(load, entry).unwrap().at(omega).unwrap());
                assert!((one - other).abs() < 1e-11 * one.abs(), "at {omega}: {one} {other}");
            }
        }
    }
}
