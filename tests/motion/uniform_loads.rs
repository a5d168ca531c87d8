//! Uniform loads and weights on the elements of paths, at rest and at any frequency.

mod at_rest;
mod damped;
mod series;
mod superposed;
mod weights;

use mstmm::motion::{Load, MotionError};
use mstmm::prelude::*;
use std::f64::consts::PI;

system! {
    /// A beam between two pins.
    struct Pinned { l: f64, ei: f64, m: f64 }
    pinned -> beam 1 { length: 0.5 * l, bending_stiffness: ei, mass_per_length: m }
           -> beam 3 { length: 0.5 * l, bending_stiffness: ei, mass_per_length: m } -> pinned;
}

system! {
    /// A string, a rod and a shaft between two walls.
    struct Strings { l: f64, h: f64, m: f64, k: f64 }
    fixed -> string 1 { length: l, tension: h, mass_per_length: m, foundation_stiffness: k }
          -> string 3 { length: l, tension: h, mass_per_length: m, foundation_stiffness: k } -> fixed;
}

system! {
    struct Rods { l: f64, h: f64, m: f64, k: f64 }
    fixed -> rod 1 { length: l, axial_stiffness: h, mass_per_length: m, foundation_stiffness: k }
          -> rod 3 { length: l, axial_stiffness: h, mass_per_length: m, foundation_stiffness: k } -> fixed;
}

system! {
    struct Shafts { l: f64, h: f64, m: f64 }
    fixed -> shaft 1 { length: l, torsional_stiffness: h, inertia_per_length: m }
          -> shaft 3 { length: l, torsional_stiffness: h, inertia_per_length: m } -> fixed;
}

#[track_caller]
fn assert_close(actual: f64, expected: f64, size: f64) {
    assert!((actual - expected).abs() <= size, "{actual} is not {expected}");
}

/// Closed form: `Y = (q/2mω²) (cos βξ/cos(z/2) + ch βξ/ch(z/2) - 2)` about the middle, up to mode 300, from next to roots to the clamped
/// frequencies of the halves, at which a stiffness matrix has its poles.
#[test]
fn a_pinned_beam_at_any_frequency() {
    let (l, ei, m) = (2.0, 3.0, 0.7);
    let system = Pinned { l, ei, m }.build().unwrap();
    let loads = [Pinned::beam_1.uniform_load(), Pinned::beam_3.uniform_load()];
    // of the whole: just below, at and beyond 1, where forms change, clamped frequencies of the halves, and roots but for a part
    let clamped = [4.730_040_744_862_704_f64, 7.853_204_624_095_838, 10.995_607_838_001_671].map(|z| 2.0 * z);
    let roots = [1.0, 2.0, 3.0, 75.0, 299.0, 300.0].map(|n| n * PI * (1.0 + 1e-6));
    for z in [1e-4, 0.03, 0.9, 1.99, 2.01, 2.5, 50.0, 943.7].into_iter().chain(clamped).chain(roots) {
        let omega = (z / l).powi(2) * (ei / m).sqrt();
        let at = |entry| {
            loads.iter().map(|&load| system.frequency_response(load, entry).unwrap().at(omega).unwrap()).sum::<f64>()
        };
        let (scale, half) = (1.0 / (2.0 * m * omega * omega), 0.5 * z);
        let beta = z / l;
        // the difference from rest cancels by z⁴
        let lost = 1.0 + 1e2 / z.powi(4).min(1.0);
        let near = 1.0 / half.cos().abs();
        let deflection = scale * (1.0 / half.cos() + 1.0 / half.cosh() - 2.0);
        let size = 1e-13 * (z + 1.0) * near * near;
        assert_close(at(Pinned::beam_1.output().deflection()), deflection, size * lost * scale);
        let moment = ei * beta * beta * scale * (-1.0 / half.cos() + 1.0 / half.cosh());
        assert_close(at(Pinned::beam_1.output().moment()), moment, size * lost * ei * beta * beta * scale);
        let shear = ei * beta.powi(3) * scale * (-half.tan() - half.tanh());
        let [left, right] = [Pinned::beam_1.input(), Pinned::beam_3.output()].map(|end| at(end.shear()));
        assert_close(left, shear, size * lost * ei * beta.powi(3) * scale);
        assert_close(right, -shear, size * lost * ei * beta.powi(3) * scale);
    }
}

/// Closed form: `Y = (q/(mω² - k)) (cos ζξ/cos ζ - 1)` about the middle of two halves, with `H ζ² = (mω² - k) l²`, of either sign.
#[test]
fn lines_at_any_frequency() {
    let (l, h, m) = (1.3, 2.0, 0.7);
    for k in [0.0, 5.0, 400.0] {
        let (strings, rods) = (Strings { l, h, m, k }.build().unwrap(), Rods { l, h, m, k }.build().unwrap());
        let shafts = Shafts { l, h, m }.build().unwrap();
        for zeta in [0.05, 0.7, 1.1, 2.0, 4.6, 300.0] {
            let omega = zeta * (h / m).sqrt() / l;
            let net = m * omega * omega - k;
            let root = Complex::new(net * l * l / h, 0.0).sqrt();
            let expected = ((1.0 / root.cos() - 1.0) / net).re;
            let size = 1e-13 * (1.0 + zeta) * (1.0 + 1.0 / net.abs()) * (1.0 + 1.0 / root.cos().norm());
            macro_rules! sum {
                ($system:ident, $model:ident, $first:ident, $loads:expr, $entry:ident) => {
                    $loads
                        .map(|load| {
                            $system
                                .frequency_response(load, $model::$first.output().$entry())
                                .unwrap()
                                .at(omega)
                                .unwrap()
                        })
                        .iter()
                        .sum::<f64>()
                };
            }
            let loads = [Strings::string_1.uniform_load(), Strings::string_3.uniform_load()];
            assert_close(sum!(strings, Strings, string_1, loads, deflection), expected, size);
            let loads = [Rods::rod_1.uniform_load(), Rods::rod_3.uniform_load()];
            assert_close(sum!(rods, Rods, rod_1, loads, deflection), expected, size);
            if k == 0.0 {
                let loads = [Shafts::shaft_1.uniform_load(), Shafts::shaft_3.uniform_load()];
                assert_close(sum!(shafts, Shafts, shaft_1, loads, rotation), expected, size);
            }
        }
    }
}

/// Closed form: a sudden load moves the modes of a pinned beam as `4/(nπ m ω²) (1 - cos ωt) sin(nπ/2)`.
#[test]
fn a_sudden_load_in_time() {
    let (l, ei, m) = (2.0, 3.0, 0.7);
    let system = Pinned { l, ei, m }.build().unwrap();
    let roots = system.first_frequencies::<16>().unwrap();
    let middle = Pinned::beam_1.output().deflection();
    let halves = [Pinned::beam_1, Pinned::beam_3]
        .map(|half| system.modal_response::<16, _>(&roots, half.uniform_load(), middle).unwrap());
    let at_rest: f64 = halves.iter().map(|half| half.static_value().unwrap()).sum();
    assert_close(at_rest, 5.0 * l.powi(4) / (384.0 * ei), 1e-4);
    for t in [0.1, 0.7, 2.0] {
        let moved: f64 = halves.iter().map(|half| half.to_step(t)).sum();
        let modes = (1..16).step_by(2).map(|n| {
            let n = f64::from(n);
            let omega = (n * PI / l).powi(2) * (ei / m).sqrt();
            4.0 / (n * PI * m * omega * omega) * (1.0 - (omega * t).cos()) * (n * PI / 2.0).sin()
        });
        assert_close(moved, modes.sum(), 2e-7);
    }
}

system! {
    /// A blade, whose section varies.
    struct Blade { length: f64 }
    fixed -> tapered_beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: 0.5 } -> free
}

#[test]
fn what_is_not_known_and_resonances_are_errors() {
    let blade = Blade { length: 1.0 }.build().unwrap();
    let tip = Blade::tapered_beam_1.output().deflection();
    let response = blade.frequency_response(Load::self_weight(), tip).unwrap();
    assert_eq!(response.at(1.0), Err(MotionError::NoUniformLoad));
    assert!(MotionError::NoUniformLoad.to_string().contains("load"), "{}", MotionError::NoUniformLoad);
    let free = weights::Flying { l: 1.0, mass: 1.0, c: 0.25 }.build().unwrap();
    let entry = weights::Flying::conn_2.deflection();
    let response = free.frequency_response(weights::Flying::beam_1.uniform_load(), entry).unwrap();
    assert_eq!(response.at(0.0), Err(MotionError::Resonance { frequency: 0.0 }));
}
