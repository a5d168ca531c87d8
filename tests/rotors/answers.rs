//! Shapes, sensitivities, responses, unbalance and orbits of rotors.
#![expect(clippy::panic, reason = "a rotor that is refused fails the test")]

use crate::numbers::Random;
use crate::shafts::{Between, Numbers, Overhung, Spools, Topology};
use core::f64::consts::{FRAC_PI_2, PI};
use mstmm::Complex;
use mstmm::motion::{ExtendedTree, Load, Planned};
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;
use mstmm::search::Spinning;

#[track_caller]
fn assert_close(found: Complex<f64>, expected: Complex<f64>, tolerance: f64) {
    let error = (found - expected).norm() / expected.norm();
    assert!(error <= tolerance, "{found} instead of {expected}: {error:e}");
}

system! {
    /// A disc on springs and dampers.
    struct Rigid { mass: f64, id: f64, ip: f64, k: f64, k_theta: f64, c: f64, c_theta: f64, speed: f64 }
    free -> disc 1 { mass, inertia: id, polar_inertia: ip, speed } -> conn a -> free;
    fixed -> spring 2 { stiffness: k, damping: c } -> conn a;
    fixed -> torsion_spring 3 { stiffness: k_theta, damping: c_theta } -> conn a;
}

const DISC: Rigid = Rigid { mass: 3.0, id: 0.2, ip: 0.3, k: 1200.0, k_theta: 500.0, c: 4.0, c_theta: 0.7, speed: 35.0 };

impl Rigid {
    /// The stiffnesses of both motions at ω, of either sign.
    fn stiffnesses(&self, omega: f64) -> [Complex<f64>; 2] {
        let square = omega * omega;
        let tilting = self.k_theta - self.id * square + self.ip * self.speed * omega;
        [Complex::new(self.k - self.mass * square, self.c * omega), Complex::new(tilting, self.c_theta * omega)]
    }
}

/// `m e Ω²/(k + icΩ - mΩ²)`, and of a skew disc `(I_d - I_p) τ Ω²/(k_θ + ic_θΩ + (I_p - I_d)Ω²)`.
#[test]
fn unbalance_of_a_disc_excites_forward_whirl() {
    for speed in [-35.0, 1e-3, 20.0, 35.0, 400.0] {
        let disc = Rigid { speed, ..DISC };
        let rotor = disc.build().unwrap();
        let forward = rotor.whirl(Whirl::Forward);
        let [bending, tilting] = disc.stiffnesses(speed);
        let (size, skew) = (Complex::from_polar(2e-4, 0.3), Complex::from_polar(1e-3, -1.0));
        let point = Rigid::conn_a;
        let found = forward.unbalance(speed, &[(point.force(), size)], point.deflection()).unwrap();
        assert_close(found, size * speed * speed / bending, 1e-13);
        let couple = skew * (disc.id - disc.ip);
        let found = forward.unbalance(speed, &[(point.torque(), couple)], point.rotation()).unwrap();
        assert_close(found, couple * speed * speed / tilting, 1e-13);
        // a disc that is out of its centre moves towards it beyond all critical speeds: the heavy side flies in
        let both =
            forward.unbalance(speed, &[(point.force(), size), (point.force(), -size)], point.deflection()).unwrap();
        assert!(both.norm() < 1e-15 * size.norm() * speed * speed);
    }
}

/// A force that does not turn excites both whirls, each by half.
#[test]
fn orbits_are_ellipses_of_both_whirls() {
    let rotor = DISC.build().unwrap();
    let point = Rigid::conn_a;
    for omega in [3.0, 20.0, 90.0] {
        let [bending, tilting] = DISC.stiffnesses(omega);
        let [bending_back, tilting_back] = DISC.stiffnesses(-omega);
        for (load, entry, [forward, backward]) in [
            (point.force(), point.deflection(), [bending, bending_back]),
            (point.torque(), point.rotation(), [tilting, tilting_back]),
        ] {
            let orbit = rotor.orbit(load, entry, omega).unwrap();
            assert_close(orbit.forward, 0.5 / forward, 1e-13);
            assert_close(orbit.backward, 0.5 / backward, 1e-13);
            let [long, short] = orbit.semi_axes();
            let radius = |angle: f64| orbit.at(angle).map(|part| part * part).iter().sum::<f64>().sqrt();
            let radii: Vec<f64> = (0..4000).map(|k| radius(f64::from(k) * FRAC_PI_2 / 1000.0)).collect();
            let [least, most] =
                [radii.iter().copied().fold(f64::INFINITY, f64::min), radii.iter().copied().fold(0.0, f64::max)];
            assert!((most / long - 1.0).abs() < 1e-5 && (least - short.abs()).abs() < 2e-3 * long, "{orbit:?}");
        }
        // a disc that does not tilt moves to and fro
        let [long, short] = rotor.orbit(point.force(), point.deflection(), omega).unwrap().semi_axes();
        assert!(short.abs() < 1e-14 * long);
    }
}

system! {
    /// Rayleigh's shaft between pins.
    struct Pinned { length: f64, ei: f64, m: f64, r: f64, rp: f64, speed: f64 }
    section s {
        length: 0.5 * length, bending_stiffness: ei, mass_per_length: m, rotary_inertia: r, polar_inertia_per_length: rp, speed
    }
    pinned -> beam 1 { ..s } -> conn middle -> beam 2 { ..s } -> pinned;
}

/// An unbalance along the whole shaft, as a sum over the sines of the shaft between pins.
#[test]
fn unbalance_along_a_shaft_is_a_sum_of_sines() {
    let shaft = Pinned { length: 1.3, ei: 40.0, m: 2.0, r: 0.03, rp: 0.06, speed: 0.0 };
    for speed in [5.0, 20.0, 300.0] {
        let rotor = Pinned { speed, ..shaft }.build().unwrap();
        let loads = [
            (Pinned::beam_1.uniform_load(), Complex::from(1e-3)),
            (Pinned::beam_2.uniform_load(), Complex::from(1e-3)),
        ];
        let found = rotor.whirl(Whirl::Forward).unbalance(speed, &loads, Pinned::conn_middle.deflection()).unwrap();
        let term = |j: usize| {
            let square = (j as f64 * PI / shaft.length).powi(2);
            let inertia = shaft.m + (shaft.r - shaft.rp) * square;
            let sign = if j % 4 == 1 { 4.0 } else { -4.0 };
            sign / (j as f64 * PI) / (shaft.ei * square * square - speed * speed * inertia)
        };
        // the terms fall as j⁻⁵
        let sum: f64 = (0..4000).rev().map(|k| term(2 * k + 1)).sum();
        assert_close(found, Complex::from(1e-3 * speed * speed * sum), 1e-12);
    }
}

/// Modal masses `φᵀ (M - ΩG/(2ω)) φ` are 1, and shapes of one whirl are orthogonal in `M - ΩG/(ω_i + ω_j)`.
fn orthogonal<M: Topology>(random: &mut Random)
where
    M::System: ExtendedTree<f64>,
{
    let (numbers, speed) = (Numbers::random(random), 10f64.powf(1.5 * random.unit() - 0.5));
    let rotor = M::rotor(numbers, speed);
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let system = rotor.whirl(whirl);
        let roots = system.first_frequencies::<5>().unwrap_or_else(|error| panic!("{numbers:?} {speed}: {error}"));
        let shapes: Vec<_> =
            roots.iter().filter(|root| root.multiplicity == 1).map(|root| (root, system.mode_shape(root))).collect();
        for (root, shape) in &shapes {
            // a shape that rests inside an element is refused
            let Ok(shape) = shape else { continue };
            assert!((shape.modal_mass() - 1.0).abs() < 1e-9, "{numbers:?} {speed} {root:?}: {}", shape.modal_mass());
            for (other_root, other) in &shapes {
                let Ok(other) = other else { continue };
                if other_root.index < root.index {
                    assert!(shape.product(other).abs() < 1e-8, "{numbers:?} {speed}: {}", shape.product(other));
                }
            }
        }
        assert!(shapes.iter().filter(|(_, shape)| shape.is_ok()).count() >= 3, "{numbers:?} {speed} {whirl:?}");
    }
}

#[test]
fn shapes_of_a_whirl_are_orthogonal() {
    let mut random = Random(5);
    for _ in 0..10 {
        orthogonal::<Between>(&mut random);
        orthogonal::<Overhung>(&mut random);
        orthogonal::<Spools>(&mut random);
    }
}

/// The residue of a response at a root is that of its shape: `H = φ φ/((ω_i² - ω²) ..)` with the modal mass of the whirl.
#[test]
fn responses_have_the_residues_of_shapes() {
    let rotor = Pinned { length: 1.3, ei: 40.0, m: 2.0, r: 0.03, rp: 0.06, speed: 70.0 }.build().unwrap();
    let point = Pinned::conn_middle;
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let system = rotor.whirl(whirl);
        let root = system.first_frequencies::<1>().unwrap()[0];
        let shape = system.mode_shape(&root).unwrap();
        let y = shape.state(point).y;
        let response = system.frequency_response(point.force(), point.deflection()).unwrap();
        let beside = |step: f64| response.at(root.omega * (1.0 + step)).unwrap() * step;
        // the mean of both sides has no part of first order
        let residue = 0.5 * (beside(1e-5) + beside(-1e-5));
        let expected = -y * y / (2.0 * root.omega * root.omega);
        assert!((residue / expected - 1.0).abs() < 1e-8, "{residue} {expected}");
    }
}

system! {
    /// A rotor whose every number is a field; its formulas are exact.
    struct Fields {
        length: f64, ei: f64, m: f64, kga: f64, r: f64, rp: f64, speed: f64, force: f64, foundation: f64,
        mass: f64, id: f64, ip: f64, k: f64,
    }
    section s {
        bending_stiffness: ei, mass_per_length: m, shear_stiffness: kga, rotary_inertia: r, polar_inertia_per_length: rp,
        axial_force: force, foundation_stiffness: foundation, speed
    }
    free -> conn a -> beam 1 { length, ..s } -> disc 2 { mass, inertia: id, polar_inertia: ip, speed: 2.0 * speed }
         -> beam 3 { length: 0.5 * length, ..s } -> pinned;
    fixed -> spring 4 { stiffness: k } -> conn a;
}

const FIELDS: [f64; 13] = [0.8, 120.0, 2.0, 9e3, 4e-3, 7e-3, 60.0, -30.0, 200.0, 3.0, 0.05, 0.08, 4e4];

fn of_fields(fields: [f64; 13]) -> Fields {
    let [length, ei, m, kga, r, rp, speed, force, foundation, mass, id, ip, k] = fields;
    Fields { length, ei, m, kga, r, rp, speed, force, foundation, mass, id, ip, k }
}

/// Central differences of frequencies in 32 digits, which know nothing of shapes.
#[test]
fn sensitivities_are_slopes_of_both_whirls() {
    let frequencies = |fields: [f64; 13], whirl| {
        let rotor = of_fields(fields).build_as::<DoubleDouble>().unwrap();
        let found = rotor.whirl(whirl).first_frequencies::<4>().unwrap();
        found.iter().map(|root| root.omega).collect::<Vec<DoubleDouble>>()
    };
    let rotor = of_fields(FIELDS).build().unwrap();
    let (mut worst, mut compared) = (0.0_f64, 0);
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let system = rotor.whirl(whirl);
        let roots = system.first_frequencies::<4>().unwrap();
        for (place, root) in roots.iter().enumerate() {
            let slopes = system.sensitivity(root).unwrap();
            for (field, (name, slope)) in slopes.iter().enumerate() {
                let value = FIELDS[field];
                let [below, above] = [1.0 - 1e-7, 1.0 + 1e-7].map(|factor| {
                    let mut fields = FIELDS;
                    fields[field] = value * factor;
                    (fields[field], frequencies(fields, whirl)[place])
                });
                let expected = (above.1 - below.1).to_f64() / (above.0 - below.0);
                // beside what the parameter moves all roots by
                let error = (slope - expected).abs() * value.abs() / root.omega;
                worst = worst.max(error);
                compared += 1;
                assert!(error < 1e-11, "{whirl:?} {} {name}: {slope} instead of {expected}", root.index);
            }
        }
    }
    println!("{compared} sensitivities, worst {worst:.1e} of omega/p");
    assert_eq!(compared, 2 * 4 * 13);
}

/// An undamped rotor has the eigenvalues `iω` of its whirl, each proven.
#[test]
fn eigenvalues_of_an_undamped_rotor_are_those_of_its_whirl() {
    let rotor = of_fields(FIELDS).build().unwrap();
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let system = rotor.whirl(whirl);
        let (frequencies, eigenvalues) =
            (system.first_frequencies::<4>().unwrap(), system.first_eigenvalues::<4>().unwrap());
        for (frequency, eigenvalue) in frequencies.iter().zip(eigenvalues.iter()) {
            assert!(eigenvalue.is_proven, "{eigenvalue:?}");
            assert_close(eigenvalue.lambda, Complex::new(0.0, frequency.omega), 1e-14);
        }
    }
}

/// A system that is asked whatever whirl it is of.
fn drift<Y: Planned + Spinning>(_: &Y, _: Load<Y::Model>) {}

/// Labels of a rotor are those of its model.
#[test]
fn loads_of_a_rotor_are_labels_of_its_model() {
    let rotor = DISC.build().unwrap();
    drift(rotor.whirl(Whirl::Backward), Rigid::disc_1.output().force());
}

system! {
    /// A rotor that nothing holds.
    struct Loose { speed: f64 }
    free -> disc 1 { mass: 2.0, inertia: 0.05, polar_inertia: 0.1, speed } -> beam 2 {
        length: 1.0, bending_stiffness: 100.0, mass_per_length: 1.0, rotary_inertia: 0.001, polar_inertia_per_length: 0.002, speed
    } -> disc 3 { mass: 1.0, inertia: 0.05, polar_inertia: 0.05, speed } -> free;
}

/// A free rotor has no shapes at rest, and moves off under a force.
#[test]
fn free_rotors_at_rest_are_refused() {
    use mstmm::motion::MotionError;
    let rotor = Loose { speed: 3.0 }.build().unwrap();
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let system = rotor.whirl(whirl);
        let rest = system.first_frequencies::<1>().unwrap()[0];
        assert!(matches!(system.mode_shapes::<2, _>(&rest).err(), Some(MotionError::ZeroFrequency)));
        let point = Loose::disc_1.output();
        let response = system.frequency_response(point.force(), point.deflection()).unwrap();
        assert!(matches!(response.at(0.0).err(), Some(MotionError::Resonance { .. })));
    }
}

system! {
    /// A disc that may tilt freely, beside one that is held.
    struct Tilting { speed: f64 }
    free -> disc 1 { mass: 1.0, inertia: 0.1, polar_inertia: 0.2, speed } -> conn a;
    fixed -> spring 2 { stiffness: 500.0 } -> conn a;
    conn a -> spring 3 { stiffness: 3000.0 } -> conn b;
    fixed -> torsion_spring 5 { stiffness: 10.0 } -> conn b;
    free -> disc 4 { mass: 2.0, inertia: 0.1, polar_inertia: 0.15, speed } -> conn b -> free;
}

/// What a speed does not change at rest: springs in a row, beside a disc that nothing keeps from tilting.
#[test]
fn static_limits_do_not_depend_on_the_speed() {
    for speed in [0.0, 1.0, 50.0, 1e3] {
        let rotor = Tilting { speed }.build().unwrap();
        for whirl in [Whirl::Forward, Whirl::Backward] {
            let point = Tilting::conn_b;
            let response = rotor.whirl(whirl).frequency_response(point.force(), point.deflection()).unwrap();
            let (found, expected) = (response.at(0.0).unwrap(), 1.0 / 500.0 + 1.0 / 3000.0);
            assert!((found / expected - 1.0).abs() < 1e-11, "{speed} {whirl:?}: {found} instead of {expected}");
        }
    }
}
