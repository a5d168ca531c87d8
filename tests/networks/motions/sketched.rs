//! What sketches say of motions that lists do not: supports of bodies, masses on paths, roots that share a shape.

use mstmm::Complex;
use mstmm::motion::MotionError;
use mstmm::network::Freedoms;
use mstmm::prelude::*;

system! {
    /// A plate on a pin and a roller, with a mast.
    struct Plate { ea: f64, ei: f64, m: f64 }
    conn a at (0.0, 0.0) -> rigid_body 1 { mass: 3.0, inertia: 0.5, centre: (1.0, 0.2) } <- conn b at (2.0, 0.0) <- roller;
    pinned -> conn a;
    rigid_body 1 -> conn foot at (1.0, 0.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn top at (1.0, 3.0) <- free;
}

/// Statics of the plate: both supports share a moment as a couple, and move it as a lever.
#[test]
fn each_support_of_a_body_has_reactions_and_motions_of_its_own() {
    let plate = Plate { ea: 1e6, ei: 1e3, m: 1.0 }.build().unwrap();
    let [a, b, foot, top] = [Plate::conn_a, Plate::conn_b, Plate::conn_foot, Plate::conn_top];
    let at_rest = |load, entry| plate.frequency_response(load, entry).and_then(|response| response.at(0.0));
    let expected = [
        (top.force_x(), a.reaction_y(), -1.5),
        (top.force_x(), b.reaction_y(), 1.5),
        (top.force_x(), a.reaction_x(), -1.0),
        (top.torque_z(), a.reaction_y(), 0.5),
        (top.torque_z(), b.reaction_y(), -0.5),
        (b.force_y(), b.reaction_y(), -1.0),
        (b.force_y(), a.reaction_y(), 0.0),
        (a.force_y(), a.reaction_y(), -1.0),
        (a.force_y(), b.reaction_y(), 0.0),
        (foot.force_y(), b.reaction_y(), -0.5),
        (b.motion_y(), b.displacement_y(), 1.0),
        (b.motion_y(), a.displacement_y(), 0.0),
        (b.motion_y(), top.displacement_x(), -1.5),
        (a.motion_y(), top.displacement_x(), 1.5),
    ];
    for (number, (load, entry, expected)) in expected.into_iter().enumerate() {
        let found = at_rest(load, entry).unwrap();
        assert!((found - expected).abs() < 1e-13, "{number}: {found} {expected}");
    }
    let not_held = |freedom| Err(MotionError::NotHeld { freedom });
    assert_eq!(at_rest(foot.motion_y(), top.displacement_x()), not_held(Freedoms::Y));
    assert_eq!(at_rest(top.force_x(), foot.reaction_y()), not_held(Freedoms::Y));
    assert_eq!(at_rest(b.motion_x(), top.displacement_x()), not_held(Freedoms::X));
    assert_eq!(at_rest(top.force_x(), b.reaction_z()), not_held(Freedoms::RZ));
}

system! {
    /// A mass on a spring and a damper.
    struct Oscillator { k: f64, c: f64 }
    fixed -> conn ground at (0.0, 0.0);
    conn ground <- along (0.0, 1.0) <- spring 1 { stiffness: k, damping: c } <- mass 2 { mass: 1.0 } <- free;
}

/// At critical damping a double eigenvalue has one shape, and beside it two roots nearly share it.
#[test]
fn roots_that_share_a_shape_are_refused() {
    for (c, is_told) in [(2.0, false), (2.0 * (1.0 + 1e-12), false), (2.0 * (1.0 + 1e-6), true), (0.1, true)] {
        let system = Oscillator { k: 1.0, c }.build().unwrap();
        let roots = match system.first_eigenvalues::<2>() {
            Ok(roots) => roots,
            Err(_) => continue,
        };
        let entry = Oscillator::mass_2.displacement_x();
        let response = system.modal_response::<2, _>(&roots, Oscillator::mass_2.force_x(), entry);
        assert_eq!(response.is_ok(), is_told, "{c}: {roots:?} {:?}", response.err());
        if let Ok(response) = response {
            // roots -d ± i w of a mass on a spring, overdamped ones with sinh
            let d: f64 = 0.5 * c;
            let w = Complex::new(1.0 - d * d, 0.0).sqrt();
            let expected = ((w * 1.3).sin() / w).re * (-1.3 * d).exp();
            let found = response.to_impulse(1.3);
            assert!((found - expected).abs() < 1e-9, "{c}: {found} {expected}");
        }
    }
}

#[test]
fn a_mass_on_a_path_has_its_motion_and_its_share() {
    let system = Oscillator { k: 4.0, c: 0.4 }.build().unwrap();
    let roots = system.first_eigenvalues::<1>().unwrap();
    let shape = system.mode_shape(&roots[0]).unwrap();
    let shares = shape.body_shares(Oscillator::mass_2).unwrap();
    assert!((shares.kinetic - 1.0).abs() < 1e-14 && shares.strain == 0.0);
    assert!(shape.value(Oscillator::mass_2.displacement_x()).unwrap().norm() > 0.1);
}

system! {
    /// A bar that stretches, and a last part of it.
    struct Bar { ea: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: 1e9, mass_per_length: 1.0 } -> conn a at (0.9, 0.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: 1e9, mass_per_length: 1.0 } -> free at (1.0, 0.0);
}

#[test]
fn rounding_has_no_nodes_and_lengths_no_last_bit() {
    let bar = Bar { ea: 1.0 }.build().unwrap();
    for root in &bar.first_frequencies::<4>().unwrap() {
        let shape = bar.mode_shape(root).unwrap();
        assert_eq!([shape.nodes(Bar::beam_1), shape.nodes(Bar::beam_2)], [Ok(0), Ok(0)]);
        // 1.0 - 0.9 is less than 0.1
        let end = shape.along(Bar::beam_2, 0.1).unwrap().displacement_x;
        assert!((end - shape.value(Bar::beam_2.output().displacement_x()).unwrap()).abs() < 1e-13);
    }
}

system! {
    /// A bent cantilever on a hinge, with a mass and a damper at its tip.
    struct Arm { c: f64 }
    fixed at (0.0, 0.0) -> hinge 1 { stiffness_x: 3e3, stiffness_y: 2e3, stiffness_rz: 7.0 }
        -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn tip at (0.6, 0.8)
        -> damper 3 { damping: c } -> conn wall at (2.0, 0.0) <- fixed;
    conn tip -> point_mass 4 { mass: 0.75 };
}

/// Shares of kinetic energy by Simpson's rule along the beam; dampers make its motion complex, and its waves grow.
#[test]
fn a_damped_beam_has_the_kinetic_energy_of_its_motion() {
    let arm = Arm { c: 2.0 }.build().unwrap();
    for root in &arm.first_eigenvalues::<6>().unwrap() {
        let shape = arm.mode_shape(root).unwrap();
        let square = |state: mstmm::motion::MemberState<Complex<f64>>| {
            state.displacement_x.norm_sqr() + state.displacement_y.norm_sqr()
        };
        let pieces = 4000_u32;
        let sum: f64 = (0..=pieces)
            .map(|k| {
                let weight = if k == 0 || k == pieces { 1.0 } else { 2.0 + 2.0 * f64::from(k % 2) };
                let distance = f64::from(k) / f64::from(pieces);
                weight * square(shape.along(Arm::beam_2, distance).unwrap())
            })
            .sum();
        let of_beam = 1.5 * sum / f64::from(pieces) / 3.0;
        let of_mass = 0.75 * square(shape.along(Arm::beam_2, 1.0).unwrap());
        let found = shape.energy_shares(Arm::beam_2).unwrap().kinetic;
        let expected = of_beam / (of_beam + of_mass);
        assert!((found - expected).abs() < 1e-9, "{root:?}: {found} {expected}");
        assert!((shape.energy_shares(Arm::damper_3).unwrap().dissipated - 1.0).abs() < 1e-12);
    }
}

/// Strain energies of beam and hinge make the modal stiffness.
#[test]
fn a_hinge_has_its_share_of_the_strain_energy() {
    let arm = Hinged { k: 7.0 }.build().unwrap();
    for root in &arm.first_frequencies::<6>().unwrap() {
        let shape = arm.mode_shape(root).unwrap();
        let part = shape.modal_stiffness() / root.omega.powi(2);
        assert!((part - 1.0).abs() < 1e-11, "{root:?}: {part}");
        assert!(shape.energy_shares(Hinged::hinge_1).unwrap().strain > 1e-6);
    }
}

system! {
    /// A beam on an elastic hinge.
    struct Hinged { k: f64 }
    fixed at (0.0, 0.0) -> hinge 1 { stiffness_x: 3e3, stiffness_y: 2e3, stiffness_rz: k }
        -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> free at (0.6, 0.8);
}
