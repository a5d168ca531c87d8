//! A beam as a finite element of high order: Hermite's cubics for its ends, polynomials that are clamped at both ends
//! for what they leave out. All functions are sums of Legendre polynomials, whose integrals are exact.
//!
//! With `s` in [-1, 1] along the beam, the second derivatives of the inner functions are Legendre polynomials of degree
//! two and up: orthogonal to each other and to those of the cubics.

use nalgebra::{DMatrix, SymmetricEigen};

/// Coefficients of Legendre polynomials.
type Series = Vec<f64>;

/// The matrices of a beam over [-1, 1] with unit stiffness and mass, in the natural modes of its inner functions: their
/// stiffness is the identity.
pub(crate) struct LegendreBeam {
    /// `∫ H_a'' H_b''` of the cubics for `[Y, dY/ds]` at both ends.
    pub(crate) stiffness: [[f64; 4]; 4],
    /// `∫ H_a H_b`.
    pub(crate) mass: [[f64; 4]; 4],
    /// `∫ φ_j²` of the inner modes: they are clamped-clamped modes, at `z⁴ = 16/ν`. Descending.
    pub(crate) inner: Vec<f64>,
    /// `∫ H_a φ_j`.
    pub(crate) coupling: Vec<[f64; 4]>,
}

/// `∫ f g` from -1 to 1: Legendre polynomials are orthogonal, with `∫ P_n² = 2/(2n+1)`.
fn integral(f: &Series, g: &Series) -> f64 {
    f.iter().zip(g).enumerate().map(|(n, (f, g))| 2.0 * f * g / (2 * n + 1) as f64).sum()
}

/// The inner function with second derivative `P_n`, scaled to unit stiffness: `∫ P_n = (P_{n+1} - P_{n-1})/(2n+1)`, twice.
fn inner_function(n: usize, length: usize) -> Series {
    let odd = |k: usize| (2 * k + 1) as f64;
    let mut series = vec![0.0; length];
    let scale = (odd(n) / 2.0).sqrt();
    series[n + 2] = scale / (odd(n) * odd(n + 1));
    series[n] = -scale / odd(n) * (1.0 / odd(n + 1) + 1.0 / odd(n - 1));
    series[n - 2] = scale / (odd(n) * odd(n - 1));
    series
}

/// The cubics `(2 - 3s + s³)/4, (1 - s - s² + s³)/4, (2 + 3s - s³)/4, (-1 - s + s² + s³)/4`.
const CUBICS: [[f64; 4]; 4] = [
    [0.5, -0.6, 0.0, 0.1],
    [1.0 / 6.0, -0.1, -1.0 / 6.0, 0.1],
    [0.5, 0.6, 0.0, -0.1],
    [-1.0 / 6.0, -0.1, 1.0 / 6.0, 0.1],
];

/// Their second derivatives.
const CURVATURES: [[f64; 2]; 4] = [[0.0, 1.5], [-0.5, 1.5], [0.0, -1.5], [0.5, 1.5]];

impl LegendreBeam {
    /// The element with so many inner functions.
    pub(crate) fn new(order: usize) -> Self {
        let square = |f: &[Series]| core::array::from_fn(|a| core::array::from_fn(|b| integral(&f[a], &f[b])));
        let cubics = CUBICS.map(|cubic| cubic.to_vec());
        let functions: Vec<Series> = (2..order + 2).map(|n| inner_function(n, order + 4)).collect();
        let mass = DMatrix::from_fn(order, order, |i, j| integral(&functions[i], &functions[j]));
        let modes = SymmetricEigen::new(mass);
        let inner = &modes.eigenvalues;
        let mut descending: Vec<usize> = (0..order).collect();
        descending.sort_by(|&i, &j| inner[j].total_cmp(&inner[i]));
        let coupling = |a: usize, mode: usize| -> f64 {
            functions.iter().zip(modes.eigenvectors.column(mode).iter()).map(|(f, v)| v * integral(&cubics[a], f)).sum()
        };
        LegendreBeam {
            stiffness: square(&CURVATURES.map(|curvature| curvature.to_vec())),
            mass: square(&cubics),
            inner: descending.iter().map(|&mode| inner[mode]).collect(),
            coupling: descending.iter().map(|&mode| core::array::from_fn(|a| coupling(a, mode))).collect(),
        }
    }
}
