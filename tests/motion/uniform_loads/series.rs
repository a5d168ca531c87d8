//! General beams between pins against their series of sines, in all regimes of their wave numbers and at complex λ.

use super::assert_close;
use mstmm::prelude::*;
use std::f64::consts::PI;

system! {
    #[derive(Clone, Copy, Debug)]
    struct General { f: f64, r: f64, n: f64, k: f64, g: f64 }
    pinned -> beam 1 {
        length: 0.5, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
        foundation_stiffness: k, foundation_shear_stiffness: g
    } -> beam 3 {
        length: 0.5, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
        foundation_stiffness: k, foundation_shear_stiffness: g
    } -> pinned
}

impl General {
    /// `Σ 4/(nπ) sin(nπ/2)/Z` over odd n, with Z the stiffness of a half wave after the rotation is eliminated.
    fn deflection(&self, lambda: Complex<f64>) -> Complex<f64> {
        let square = lambda * lambda;
        let term = |n: u32| {
            let wave = f64::from(n) * PI;
            let own = square * self.r + wave * wave;
            // kGA (k² - kGA k²/(EI k² + kGA + r λ²)) without the infinite kGA of a beam without shear
            let bending = own * (wave * wave) / (own * self.f + 1.0);
            let stiffness = bending + (self.n + self.g) * wave * wave + self.k + square;
            let sign = if n % 4 == 1 { 1.0 } else { -1.0 };
            sign * 4.0 / wave / stiffness
        };
        // the mean of two sums, since signs alternate
        let last = 100_001;
        (1..last).step_by(2).rev().map(term).fold(term(last) * 0.5, |sum, term| sum + term)
    }
}

#[test]
fn general_beams_are_their_series() {
    let plain = General { f: 0.0, r: 0.0, n: 0.0, k: 0.0, g: 0.0 };
    let beams = [
        plain,
        General { f: 0.05, ..plain },
        General { f: 0.02, r: 0.01, ..plain },
        General { f: 10.0, r: 1e-3, ..plain },
        General { n: 50.0, ..plain },
        General { n: 1e5, ..plain },
        General { n: -8.0, ..plain },
        General { k: 1e-3, ..plain },
        General { k: 600.0, ..plain },
        General { k: 1e8, ..plain },
        General { n: 20.0, k: 100.0, ..plain },
        General { n: -3.0, k: 500.0, g: 2.0, f: 0.01, r: 0.003 },
        General { n: 1e4, k: 5.0, g: 2.0, f: 1e-4, r: 1e-4 },
    ];
    for beam in beams {
        let system = beam.build().unwrap();
        let middle = General::beam_1.output().deflection();
        let loads = [General::beam_1.uniform_load(), General::beam_3.uniform_load()];
        let responses = loads.map(|load| system.frequency_response(load, middle).unwrap());
        // the last one is beside the cut-off of the last beam, where its sections shear without deflection
        for omega in [1e-3, 0.3, 1.0, 3.9, 4.1, 24.0, 100.0, 700.0, 1.01e4] {
            let lambda = Complex::new(0.0, omega);
            let expected = beam.deflection(lambda);
            let actual: f64 = responses.iter().map(|response| response.at(omega).unwrap()).sum();
            // a response between resonances of an undamped beam has the digits that their distance leaves
            let inert = 1.0 / (omega * omega + beam.k);
            assert_close(actual, expected.re, 4e-12 * (expected.norm() + inert));
            let lambda = Complex::new(-0.2 * omega, omega);
            let (actual, expected): (Complex<f64>, _) =
                (responses.iter().map(|response| response.at(lambda).unwrap()).sum(), beam.deflection(lambda));
            assert_close((actual - expected).norm(), 0.0, 4e-12 * expected.norm());
        }
    }
}
