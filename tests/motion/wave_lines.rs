//! Motions of strings, rods and shafts against closed forms, above and below the cut-on of a foundation.

use core::f64::consts::PI;
use mstmm::prelude::*;

system! {
    /// A string between two walls on an elastic foundation.
    #[derive(Clone, Copy, Debug)]
    struct Strung { length: f64, tension: f64, m: f64, k: f64 }
    fixed -> string 1 { length, tension, mass_per_length: m, foundation_stiffness: k } -> fixed
}

system! {
    /// A pile in soil with a mass on it.
    #[derive(Clone, Copy, Debug)]
    struct Pile { length: f64, ea: f64, m: f64, k: f64, mass: f64 }
    fixed -> rod 1 { length, axial_stiffness: ea, mass_per_length: m, foundation_stiffness: k } -> mass 2 { mass } -> free
}

system! {
    /// A shaft with a disk.
    #[derive(Clone, Copy, Debug)]
    struct Drive { length: f64, gj: f64, j: f64, disk: f64 }
    fixed -> shaft 1 { length, torsional_stiffness: gj, inertia_per_length: j } -> inertia 2 { inertia: disk } -> free
}

#[track_caller]
fn close(actual: f64, expected: f64, scale: f64) {
    assert!((actual - expected).abs() <= 1e-12 * scale.abs(), "{actual} is not {expected}");
}

/// Closed form: `Y = A sin(nπx/l)`, `Q = -H Y'`, and `ω² = (k + H (nπ/l)²)/m` with its derivatives.
#[test]
fn a_string_between_walls() {
    let (length, tension, m, k) = (1.7, 32.0, 0.13, 900.0);
    let system = Strung { length, tension, m, k }.build().unwrap();
    let roots = system.first_frequencies::<30>().unwrap();
    for n in [1, 2, 3, 30] {
        let root = &roots[n - 1];
        let shape = system.mode_shape(root).unwrap();
        let number = n as f64 * PI / length;
        let amplitude = (2.0 * shape.modal_mass() / (m * length)).sqrt();
        let sign = -shape.state(Strung::string_1.input()).q.signum();
        for part in [0.0, 0.13, 0.5, 0.77, 1.0] {
            let (state, phase) = (shape.along(Strung::string_1, part * length).unwrap(), number * part * length);
            close(state.y, sign * amplitude * phase.sin(), amplitude * n as f64);
            close(state.q, -sign * amplitude * tension * number * phase.cos(), amplitude * tension * number * n as f64);
        }
        assert_eq!(shape.nodes(Strung::string_1), n - 1);
        close(shape.modal_stiffness(), shape.modal_mass() * root.omega * root.omega, shape.modal_stiffness());
        let sensitivity = system.sensitivity(root).unwrap();
        let derivative = 1.0 / (2.0 * m * root.omega);
        for (name, expected) in [
            ("length", -2.0 * tension * number * number / length * derivative),
            ("tension", number * number * derivative),
            ("m", -root.omega * root.omega * derivative),
            ("k", derivative),
        ] {
            close(sensitivity.get(name).unwrap(), expected, expected);
        }
    }
}

/// Closed form: the lowest motion decays along the pile as `sinh(κx)`, `κ² = (k - mω²)/EA`, and the parts of its energies are integrals of
/// `sinh²` and `cosh²`.
#[test]
fn a_pile_below_its_cut_on() {
    let (length, ea, m, mass) = (12.0, 3.1e9, 900.0, 4.0e4);
    for k in [3.0e7, 2.0e9] {
        let system = Pile { length, ea, m, k, mass }.build().unwrap();
        let root = system.first_frequencies::<1>().unwrap()[0];
        let square = root.omega * root.omega;
        assert!(m * square < k, "{root:?} is above the cut-on");
        let rate = ((k - m * square) / ea).sqrt();
        let shape = system.mode_shape(&root).unwrap();
        let tip = shape.state(Pile::mass_2.output()).y;
        for part in [0.05, 0.5, 0.9, 1.0] {
            let state = shape.along(Pile::rod_1, part * length).unwrap();
            let decay = (rate * part * length).sinh() / (rate * length).sinh();
            close(state.y, tip * decay, tip);
            close(state.q, -tip * ea * rate * (rate * part * length).cosh() / (rate * length).sinh(), tip * ea * rate);
        }
        let (sinh, cosh) = ((rate * length).sinh(), (rate * length).cosh());
        let [sines, cosines] = [-1.0, 1.0].map(|sign| 0.5 * (sinh * cosh / rate + sign * length) / (sinh * sinh));
        close(shape.modal_mass(), (mass + m * sines) * tip * tip, shape.modal_mass());
        close(shape.modal_stiffness(), (ea * rate * rate * cosines + k * sines) * tip * tip, shape.modal_stiffness());
        let sensitivity = system.sensitivity(&root).unwrap();
        let per_work = tip * tip / (2.0 * root.omega * shape.modal_mass());
        for (name, expected) in [
            ("ea", rate * rate * cosines),
            ("k", sines),
            ("m", -square * sines),
            ("mass", -square),
            ("length", -ea * rate * rate / (sinh * sinh)),
        ] {
            close(sensitivity.get(name).unwrap(), expected * per_work, expected * per_work);
        }
    }
}

/// Closed form: under a force at the mass `Y = 1/(EA κ coth κl - Mω²)`, with a cotangent above the cut-on; under a torque at the disk likewise.
#[test]
fn responses() {
    let (length, ea, m, k, mass) = (12.0, 3.1e9, 900.0, 2.0e9, 4.0e3);
    let system = Pile { length, ea, m, k, mass }.build().unwrap();
    let tip = Pile::mass_2.output();
    let response = system.frequency_response(tip.force(), tip.deflection()).unwrap();
    let inner = system.frequency_response(tip.force(), Pile::rod_1.input().shear()).unwrap();
    for omega in [0.0, 700.0, 1490.0, 1491.0, 4000.0, 70_000.0] {
        let square: f64 = (k - m * omega * omega) / ea;
        let rate = square.abs().sqrt();
        let phase = rate * length;
        let (stiffness, share) = if square > 0.0 {
            (ea * rate / phase.tanh(), ea * rate / phase.sinh())
        } else {
            (ea * rate / phase.tan(), ea * rate / phase.sin())
        };
        let expected = 1.0 / (stiffness - mass * omega * omega);
        let scale = expected * (1.0 + expected.abs() * (stiffness.abs() + mass * omega * omega)) * (1.0 + phase);
        close(response.at(omega).unwrap(), expected, scale);
        close(inner.at(omega).unwrap(), -share * expected, share * scale * (1.0 + phase / phase.sin().abs()));
    }
    let (length, gj, j, disk) = (0.8, 5.2e4, 0.011, 0.02);
    let system = Drive { length, gj, j, disk }.build().unwrap();
    let end = Drive::inertia_2.output();
    let response = system.frequency_response(end.torque(), end.rotation()).unwrap();
    let moment = system.frequency_response(end.torque(), Drive::shaft_1.input().moment()).unwrap();
    for omega in [0.0, 900.0, 30_000.0] {
        let phase = omega * length * (j / gj).sqrt();
        let (cotangent, inverse) = if phase > 0.0 { (phase / phase.tan(), phase / phase.sin()) } else { (1.0, 1.0) };
        let expected = 1.0 / (gj / length * cotangent - disk * omega * omega);
        close(response.at(omega).unwrap(), expected, 20.0 * expected);
        close(moment.at(omega).unwrap(), gj / length * inverse * expected, 20.0 * gj / length * inverse * expected);
    }
}
