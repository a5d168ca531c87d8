//! The weight of a whole model.

use super::assert_close;
use mstmm::motion::Load;
use mstmm::prelude::*;

system! {
    /// Everything that has a mass, in the air.
    pub(super) struct Flying { pub(super) l: f64, pub(super) mass: f64, pub(super) c: f64 }
    free -> beam 1 { length: l, bending_stiffness: 2.0, mass_per_length: 0.8 } -> conn 2
         -> body 3 { mass: 0.5, inertia_about_input: 0.1, output_x: 0.3, centre_x: c } -> rigid_link 4 { output_x: -0.2 } -> beam 5 {
             length: 0.7, bending_stiffness: 1.0, mass_per_length: 0.5, shear_stiffness: 30.0, rotary_inertia: 0.02
         } -> point_mass 6 { mass, inertia: 0.3 } -> hinge 7 { stiffness_y: 3.0, stiffness_rz: 2.0 } -> conn 8 -> free;
    conn 2 <- spring 9 { stiffness: 3.0 } <- mass 10 { mass: 0.2 } <- free;
    conn 8 <- string 11 { length: 0.5, tension: 2.0, mass_per_length: 0.4 } <- mass 12 { mass: 0.1 } <- free;
}

/// What falls freely falls as one: `Y = a/λ²` everywhere, without rotation, moments and forces, at any frequency.
#[test]
fn what_falls_freely_falls_as_one() {
    for c in [-0.25, 0.0, 0.4] {
        let system = Flying { l: 1.2, mass: 0.9, c }.build().unwrap();
        for omega in [0.02, 0.3, 1.0, 2.0, 7.0, 40.0, 1000.0] {
            let at = |entry| system.frequency_response(Load::self_weight(), entry).unwrap().at(omega).unwrap();
            let falls = -1.0 / (omega * omega);
            let size = 1e-11 * (1.0 + falls.abs());
            for point in [Flying::conn_2, Flying::body_3.output(), Flying::point_mass_6.output(), Flying::conn_8] {
                assert_close(at(point.deflection()), falls, size);
                assert_close(at(point.rotation()), 0.0, size);
                assert_close(at(point.moment()), 0.0, size * (1.0 + omega));
                assert_close(at(point.shear()), 0.0, size * (1.0 + omega));
            }
            assert_close(at(Flying::mass_10.output().deflection()), falls, size);
            assert_close(at(Flying::mass_12.input().deflection()), falls, size);
        }
    }
}

system! {
    /// A bridge with a machine on it, and a tank that hangs from it.
    struct Bridge { span: f64, m: f64, machine: f64, tank: f64 }
    pinned -> beam 1 { length: 0.3 * span, bending_stiffness: 5.0, mass_per_length: m } -> conn 2
           -> body 3 { mass: machine, inertia_about_input: machine, output_x: 0.2, centre_x: 0.1 }
           -> beam 4 { length: 0.5 * span, bending_stiffness: 4.0, mass_per_length: 2.0 * m, rotary_inertia: 0.1 } -> pinned;
    conn 2 <- spring 5 { stiffness: 3.0 } <- mass 6 { mass: tank } <- free;
}

/// At rest the supports carry the total weight, and the moments about a support balance.
#[test]
fn supports_carry_the_weight() {
    let (span, m, machine, tank) = (2.0, 0.6, 1.5, 0.8);
    let system = Bridge { span, m, machine, tank }.build().unwrap();
    let at = |entry| system.frequency_response(Load::self_weight(), entry).unwrap().at(0.0).unwrap();
    let (first, last) = (at(Bridge::beam_1.input().shear()), at(Bridge::beam_4.output().shear()));
    let (left, right) = (0.3 * span, 0.5 * span);
    let weights =
        [(m * left, 0.5 * left), (machine, left + 0.1), (2.0 * m * right, left + 0.2 + 0.5 * right), (tank, left)];
    let total: f64 = weights.iter().map(|(weight, _)| weight).sum();
    let moment: f64 = weights.iter().map(|(weight, place)| weight * place).sum();
    assert_close(last - first, total, 1e-13 * total);
    assert_close(last * (left + 0.2 + right), moment, 1e-13 * moment);
    assert_close(at(Bridge::spring_5.input().shear()).abs(), tank, 1e-13);
    // the tank hangs by its weight over the stiffness below the bridge
    let [bridge, hanging] = [Bridge::conn_2, Bridge::mass_6.output()].map(|point| at(point.deflection()));
    assert_close(hanging - bridge, tank / 3.0, 1e-13);
}
