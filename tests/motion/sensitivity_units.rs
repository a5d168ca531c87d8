//! Sensitivities of a model of shared elements, `let` lines and fields used twice, in all arithmetics: what units demand.
#![allow(missing_docs, reason = "models of a test")]

use mstmm::number::{DoubleDouble, Parameter, Scalar};
use mstmm::prelude::*;

system! {
    /// A frame of three equal arms, two of them elastic, with a body in the middle of its trunk.
    #[derive(Clone, Copy, Debug)]
    struct Frame {
        length: f64,
        ei: f64,
        line_mass: f64,
        mass: f64,
        radius: f64,
        k: f64,
        k_theta: f64,
        /// Nothing depends on it.
        _unused: f64,
        /// Enters as a number.
        #[no_sensitivity]
        share: f64,
    }

    let short = length * share;
    let inertia = mass * radius * radius;

    fixed -> beam 1 { length: short, bending_stiffness: ei, mass_per_length: line_mass } -> conn 2;
    fixed -> beam 3 { length: short, bending_stiffness: ei, mass_per_length: line_mass } -> conn 2;
    fixed -> hinge 4 { stiffness_y: k, stiffness_rz: k_theta }
          -> beam 5 { length: short, bending_stiffness: ei, mass_per_length: line_mass } -> conn 2;
    conn 2 -> body 6 { mass, inertia_about_input: inertia + inertia, output_x: radius, centre_x: -radius * share }
           -> beam 7 { length, bending_stiffness: ei, mass_per_length: line_mass }
           -> point_mass 8 { mass, inertia } -> conn 9 -> beam 10 { length, bending_stiffness: ei, mass_per_length: line_mass }
           -> free;
    conn 9 <- spring 11 { stiffness: k } <- mass 12 { mass } <- free;
    conn 9 <- torsion_spring 13 { stiffness: k_theta } <- inertia 14 { inertia } <- free;
}

/// The exponents of force, mass and length in the unit of a field, where ω has 1/2, -1/2 and -1/2: a change of units changes
/// ω by the sum over the fields of exponent times field times derivative.
const UNITS: [(&str, [f64; 3]); 8] = [
    ("length", [0.0, 0.0, 1.0]),
    ("ei", [1.0, 0.0, 2.0]),
    ("line_mass", [0.0, 1.0, -1.0]),
    ("mass", [0.0, 1.0, 0.0]),
    ("radius", [0.0, 0.0, 1.0]),
    ("k", [1.0, 0.0, -1.0]),
    ("k_theta", [1.0, 0.0, 1.0]),
    ("_unused", [0.0, 0.0, 0.0]),
];

macro_rules! assert_units {
    ($scalar:ty, $modes:expr) => {{
        let model = Frame {
            length: 1.5,
            ei: 2.5,
            line_mass: 0.75,
            mass: 0.5,
            radius: 0.25,
            k: 8.0,
            k_theta: 3.0,
            _unused: 1.0,
            share: 0.5,
        };
        let fields =
            [model.length, model.ei, model.line_mass, model.mass, model.radius, model.k, model.k_theta, model._unused];
        let system = model.build_as::<$scalar>().unwrap();
        let roots = system.first_frequencies::<$modes>().unwrap();
        for root in &roots {
            let sensitivities = system.sensitivity(root).unwrap();
            let found: Vec<(&str, f64)> =
                sensitivities.iter().map(|(name, value)| (name, Parameter::to_f64(value))).collect();
            assert!(found.iter().map(|(name, _)| *name).eq(UNITS.iter().map(|(name, _)| *name)), "{found:?}");
            assert_eq!(found[7].1, 0.0);
            let omega = Parameter::to_f64(root.omega);
            for (unit, expected) in [0.5, -0.5, -0.5].into_iter().enumerate() {
                let terms: Vec<f64> = (0..8).map(|k| UNITS[k].1[unit] * fields[k] * found[k].1).collect();
                let sum: f64 = terms.iter().sum();
                let size: f64 = terms.iter().map(|term| term.abs()).sum();
                // fourteen elements of some forty roundings each, and z waves
                let eps = <$scalar as Scalar>::EPSILON.max(f64::EPSILON);
                let limit = 64.0 * eps * (size + omega) * (1.0 + $modes as f64);
                assert!((sum - expected * omega).abs() <= limit, "{omega}, unit {unit}: {sum} {terms:?}");
            }
        }
    }};
}

#[test]
fn of_shared_elements_and_formulas() {
    assert_units!(f64, 40);
    assert_units!(f32, 12);
    assert_units!(DoubleDouble, 12);
}
