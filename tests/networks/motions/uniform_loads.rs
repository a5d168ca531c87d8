//! Loads along members of frames, and weights, at rest and at any frequency.

mod beside_trees;
mod cut;
mod damped;
mod refused;
mod weights;

use mstmm::prelude::*;

#[track_caller]
fn assert_close(actual: f64, expected: f64, size: f64) {
    assert!((actual - expected).abs() <= size, "{actual} is not {expected}");
}

system! {
    /// A cantilever that leads up a slope.
    struct Slope { l: f64, angle: f64, ea: f64, ei: f64, m: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> conn 2 at (l * angle.cos(), l * angle.sin());
}

/// Closed forms, along the member and across it: `tan ζ/ζ` and the ends of a cantilever under `q`, at any frequency.
#[test]
fn a_cantilever_on_a_slope() {
    let (l, ea, ei, m) = (1.4, 30.0, 2.0, 0.6);
    for angle in [0.0, 0.7, 1.9, -2.3] {
        let system = Slope { l, angle, ea, ei, m }.build().unwrap();
        let beam = Slope::beam_1;
        for omega in [0.0, 1e-8, 0.3, 2.5, 17.0, 400.0, 2e5] {
            let (c, s) = (angle.cos(), angle.sin());
            let z = (m * omega * omega / ei).powf(0.25) * l;
            let zeta = omega * l * (m / ea).sqrt();
            // by the transfer matrix from the free end, whose deflection and slope make those of the clamp vanish
            let [along, across, slope] = if omega < 0.01 {
                [l * l / (2.0 * ea), l.powi(4) / (8.0 * ei), l.powi(3) / (6.0 * ei)]
            } else {
                let inert = 1.0 / (m * omega * omega);
                let grown = (-z).exp();
                // 1 + cos ch, both over e^z
                let (ch, sh) = (0.5 + 0.5 * grown * grown, 0.5 - 0.5 * grown * grown);
                let below = grown + z.cos() * ch;
                let across = inert * ((z.cos() * grown + ch) / below - 1.0);
                let slope = inert * z / l * (sh - z.sin() * grown) / below;
                [inert * (1.0 / zeta.cos() - 1.0), across, slope]
            };
            let size = 1e-12 * (1.0 + z) * (along.abs() + across.abs() + 1.0 / (m * omega * omega).max(1.0));
            let near = 1.0 / zeta.cos().abs();
            for (load, [x, y]) in [(beam.uniform_load_x(), [c, -s]), (beam.uniform_load_y(), [s, c])] {
                let at = |entry| system.frequency_response(load, entry).unwrap().at(omega).unwrap();
                assert_close(at(Slope::conn_2.displacement_x()), x * along * c - y * across * s, size * near);
                assert_close(at(Slope::conn_2.displacement_y()), x * along * s + y * across * c, size * near);
                assert_close(at(Slope::conn_2.rotation_z()), y * slope, size * (1.0 + z) * near);
            }
        }
    }
}

system! {
    /// A frame between clamps, with a bar that has no free end.
    struct Clamped { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 5.0, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn e at (l, 0.0)
        -> beam 2 { axial_stiffness: 5.0, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn a at (l, 1.0);
    conn e <- fixed;
}

/// Closed forms: `q l²/12` and `q l/2` at the ends of a bar between clamps.
#[test]
fn a_bar_between_clamps() {
    let l = 3.0;
    let system = Clamped { l }.build().unwrap();
    let beam = Clamped::beam_1;
    let response = system.frequency_response(beam.uniform_load_y(), beam.input().moment()).unwrap();
    assert_close(response.at(0.0).unwrap(), l * l / 12.0, 1e-14);
    let at_rest = response.states(0.0).unwrap();
    assert_close(at_rest.value(beam.output().shear()).unwrap(), l / 2.0, 1e-14);
    assert_close(at_rest.along(beam, l / 2.0).unwrap().displacement_y, l.powi(4) / (384.0 * 2.0), 1e-14);
    assert_close(at_rest.along(beam, l / 2.0).unwrap().moment, -l * l / 24.0, 1e-14);
    let along = system.frequency_response(beam.uniform_load_x(), beam.input().axial_force()).unwrap();
    assert_close(along.at(0.0).unwrap(), l / 2.0, 1e-14);
    assert_close(along.states(0.0).unwrap().along(beam, l / 2.0).unwrap().displacement_x, l * l / 40.0, 1e-14);
}

/// Closed form: the sway frame of the theory of structures; in time the static value and the end of a slow ramp are the same.
#[test]
fn modes_of_a_frame_under_a_load_along_a_member() {
    let system = Slope { l: 1.4, angle: 0.7, ea: 30.0, ei: 2.0, m: 0.6 }.build().unwrap();
    let (load, entry) = (Slope::beam_1.uniform_load_y(), Slope::conn_2.displacement_y());
    let response = system.frequency_response(load, entry).unwrap();
    let roots = system.first_frequencies::<20>().unwrap();
    let modes = system.modal_response::<20, _>(&roots, load, entry).unwrap();
    let at_rest = response.at(0.0).unwrap();
    // the modes of a load that is even fall off as the fifth power of the wave number, along the member as the third
    assert_close(modes.static_value().unwrap(), at_rest, 1e-13 * at_rest);
    let lacking = (modes.to_step(1e-9) / at_rest).abs();
    assert!(lacking < 1e-3, "{lacking}");
    for mass_only in [Slope::beam_1.uniform_load_x(), load] {
        let modes = system.modal_response::<20, _>(&roots, mass_only, entry).unwrap();
        let exact = system.frequency_response(mass_only, entry).unwrap().at(0.0).unwrap();
        assert_close(modes.static_value().unwrap(), exact, 1e-13 * at_rest);
    }
}
