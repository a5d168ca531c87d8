//! A model with a closed form, its response as a file, and a reader of that file by the columns of the format.
#![allow(dead_code, reason = "each program takes what it needs")]

pub(crate) mod columns;
pub(crate) mod mast;

use mstmm::prelude::*;
use mstmm_files::{Direction, Dof, Function, Geometry, Mode, write_uff58};

system! {
    /// A mass on a spring and a dashpot.
    #[derive(Clone, Copy)]
    pub(crate) struct Oscillator { pub(crate) k: f64, pub(crate) c: f64, pub(crate) m: f64 }
    fixed -> spring 1 { stiffness: k, damping: c } -> mass 2 { mass: m } -> free;
}

pub(crate) const MODEL: Oscillator = Oscillator { k: 400.0, c: 2.0, m: 1.0 };

/// Closed form: `1/(k - m ω² + i c ω)`.
pub(crate) fn exact(omega: f64) -> Complex<f64> {
    let Oscillator { k, c, m } = MODEL;
    Complex::new(k - m * omega * omega, c * omega).inv()
}

/// The response of the model by the library, on a curve.
pub(crate) fn samples() -> Vec<(f64, Complex<f64>)> {
    let (system, mass) = (MODEL.build().unwrap(), Oscillator::mass_2.output());
    let roots = system.eigenvalues_in(Region { re: -10.0..=0.0, im: 0.1..=100.0 }).unwrap();
    let response = system.frequency_response(mass.force(), mass.deflection()).unwrap();
    let curve = response.curve::<1000, _>(0.0..=60.0, &roots, 1e-2).unwrap();
    curve.iter().map(|sample| (sample.omega, sample.value)).collect()
}

/// The head of the function.
pub(crate) fn head() -> Function<'static> {
    let (response, reference) =
        (Dof { node: 12, direction: Direction::Y }, Dof { node: 4_000_000_000, direction: Direction::RotationZ });
    Function::receptance("mass on a spring and a dashpot", response, reference)
}

/// The file of those samples.
pub(crate) fn file() -> String {
    let mut file = Vec::new();
    write_uff58(&mut file, &head(), samples()).unwrap();
    String::from_utf8(file).unwrap()
}

/// The oscillator on a line from the ground, and its complex mode.
pub(crate) fn complex_mode() -> (Geometry, Mode) {
    let (system, mass) = (MODEL.build().unwrap(), Oscillator::mass_2.output());
    let root = system.eigenvalues_in(Region { re: -10.0..=0.0, im: 0.1..=100.0 }).unwrap()[0];
    let y = system.mode_shape(&root).unwrap().state(mass).y;
    let mut geometry = Geometry::default();
    geometry.add_line("spring", [[0.0; 3], [0.0, 1.25, 0.0]]);
    let zero = Complex::new(0.0, 0.0);
    (geometry, Mode::from(root).with_vectors([[zero; 3], [zero, y, zero]]))
}
