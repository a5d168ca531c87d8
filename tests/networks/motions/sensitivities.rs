//! Sensitivities beside central differences in double-double arithmetic.
#![expect(clippy::unwrap_used, reason = "the model is right")]

mod damped_models;
mod implicit;
mod line_models;
mod plane_models;
mod random;
mod sampled;

use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;

system! {
    /// A frame with all that has numbers: skew supports, bodies, releases, springs along directions, hinges, a mass on a spring.
    #[derive(Clone, Copy, Debug)]
    struct Workshop {
        height: f64, span: f64, machine_x: f64, ea: f64, ei: f64, m: f64, brace: f64, machine: f64, inertia: f64, offset: f64,
        k: f64, slope: f64, absorber: f64, k_absorber: f64, hinge: f64, k_turn: f64,
    }
    let half = 0.5 * ei;
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn girder at (machine_x, height)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
        -> pin 4 {}
        -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn foot at (span, 0.125 * height)
        <- roller along (1.0, slope);
    conn girder -> rigid_body 6 { mass: machine, inertia, centre: (machine_x + 0.25, height + offset) };
    conn b -> spring 7 { stiffness: brace } -> conn foot;
    conn c <- along (1.0, 2.0 * slope) <- spring 8 { stiffness: k_absorber } <- mass 9 { mass: absorber } <- free;
    conn b -> hinge 10 { stiffness_x: k, stiffness_y: k, stiffness_rz: hinge }
        -> beam 11 { axial_stiffness: ea, bending_stiffness: half, mass_per_length: m } -> conn tip at (-1.0, 1.25 * height);
    conn tip <- torsion_spring 12 { stiffness: k_turn } <- fixed;
}

fn workshop() -> Workshop {
    Workshop {
        height: 3.0,
        span: 4.0,
        machine_x: 1.7,
        ea: 4e6,
        ei: 1e6,
        m: 20.0,
        brace: 2e6,
        machine: 500.0,
        inertia: 40.0,
        offset: 0.4,
        k: 3e6,
        slope: 0.3,
        absorber: 30.0,
        k_absorber: 1e6,
        hinge: 2e5,
        k_turn: 7e4,
    }
}

type Field = fn(&mut Workshop) -> &mut f64;

const FIELDS: [(&str, Field); 16] = [
    ("height", |w| &mut w.height),
    ("span", |w| &mut w.span),
    ("machine_x", |w| &mut w.machine_x),
    ("ea", |w| &mut w.ea),
    ("ei", |w| &mut w.ei),
    ("m", |w| &mut w.m),
    ("brace", |w| &mut w.brace),
    ("machine", |w| &mut w.machine),
    ("inertia", |w| &mut w.inertia),
    ("offset", |w| &mut w.offset),
    ("k", |w| &mut w.k),
    ("slope", |w| &mut w.slope),
    ("absorber", |w| &mut w.absorber),
    ("k_absorber", |w| &mut w.k_absorber),
    ("hinge", |w| &mut w.hinge),
    ("k_turn", |w| &mut w.k_turn),
];

/// A root of the model with a field changed by some steps, in twice the digits.
fn root(field: Field, step: f64, steps: f64, mode: usize) -> DoubleDouble {
    let mut changed = workshop();
    *field(&mut changed) += steps * step;
    changed.build_as::<DoubleDouble>().unwrap().first_frequencies::<8>().unwrap()[mode].omega
}

/// The derivative from four values, to the fourth power of the step.
fn central_difference(field: Field, mode: usize) -> f64 {
    // a power of two, so that the values are what they are meant to be
    let step = 2.0_f64.powi(field(&mut workshop()).log2().floor() as i32 - 18);
    let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(|steps| root(field, step, steps, mode));
    let eight = DoubleDouble::from(8.0);
    ((eight * (above - below) - (far_above - far_below)) / DoubleDouble::from(12.0 * step)).to_f64()
}

#[test]
fn sensitivities_to_all_fields_are_central_differences() {
    let system = workshop().build().unwrap();
    let roots = system.first_frequencies::<8>().unwrap();
    let mut worst = 0.0_f64;
    for mode in [0, 2, 5, 7] {
        let sensitivity = system.sensitivity(&roots[mode]).unwrap();
        for (name, field) in FIELDS {
            let (found, expected) = (sensitivity.get(name).unwrap(), central_difference(field, mode));
            let part = (found - expected).abs() * *field(&mut workshop()) / roots[mode].omega;
            assert!(part < 1e-10, "mode {mode}, {name}: {found:e}, by differences {expected:e}");
            worst = worst.max(part);
        }
    }
    println!("64 sensitivities, worst {worst:.1e} of ω/p");
}

#[test]
fn a_motion_is_asked_for_at_points_that_have_it() {
    use mstmm::motion::MotionError;
    use mstmm::network::Freedoms;
    let system = workshop().build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<1>().unwrap()[0]).unwrap();
    let of_spring = shape.value(Workshop::spring_7.input().moment());
    assert_eq!(of_spring, Err(MotionError::NoSuchFreedom { freedom: Freedoms::RZ }));
    // a spring pulls at both ends alike
    let [input, output] =
        [Workshop::spring_7.input(), Workshop::spring_7.output()].map(|end| shape.value(end.axial_force()));
    assert!((input.unwrap() - output.unwrap()).abs() < 1e-12 * input.unwrap().abs());
}
