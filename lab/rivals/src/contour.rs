//! The contour integral method for `T(λ) v = 0`, with T the overall matrix of the damped example.

use crate::elements::arnoldi::upper;
use crate::found::Found;
use core::f64::consts::PI;
use mstmm::prelude::*;
use nalgebra::{Complex, DMatrix, SMatrix, SVector};

/// Width of the overall matrix.
const SIZE: usize = 7;

/// Probe columns: with two block rows of moments there is room for ten roots.
const PROBES: usize = 5;

type Overall = SMatrix<Complex<f64>, SIZE, SIZE>;

type Moment = SMatrix<f64, SIZE, PROBES>;

/// An ellipse around zero, symmetric to both axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Half its extent along the real axis [1/s].
    pub width: f64,
    /// Half its extent along the imaginary axis [1/s].
    pub height: f64,
}

/// Beyn's method: with `A_p = 1/(2πi) ∮ λ^p f(λ) T(λ)⁻¹ V dλ`, the roots inside are the eigenvalues of the pencil of the
/// block Hankel matrices `[A_0 A_1; A_1 A_2]` and `[A_1 A_2; A_2 A_3]`, here of ten columns for five pairs of roots.
///
/// The contour is symmetric to the real axis, where no root of the example lies: the mirror images of the roots come along,
/// but half of the nodes count for all, moments are real, and the integrand stays away from its poles, so that the
/// trapezoidal rule gains a digit with two more nodes. A contour of the upper half plane alone would pass between the
/// lowest root and its image.
///
/// The entire filter f makes the residues of all roots of like size: those of the highest are greater by some orders,
/// which the others would lose in digits. It also damps the poles beyond the contour.
///
/// # Source
/// W.-J. Beyn, An integral method for solving nonlinear eigenvalue problems, Linear Algebra Appl. 436 (2012), integral
/// algorithm 2.
#[derive(Clone, Debug)]
pub struct Beyn<Y> {
    system: Y,
    ellipse: Ellipse,
    /// Factors of rows and columns that make all entries of like size.
    rows: SVector<f64, SIZE>,
    columns: SVector<f64, SIZE>,
    probe: SMatrix<Complex<f64>, SIZE, PROBES>,
}

impl<Y: Evaluate<Complex<f64>, Matrix = Overall>> Beyn<Y> {
    /// The method on an ellipse that holds five pairs of roots.
    pub fn new(system: Y, ellipse: Ellipse) -> Self {
        // columns without pattern: fractional parts of multiples of the golden ratio
        let entry = |k: usize| (k as f64 * 0.618_033_988_749_894_9).fract() - 0.5;
        let probe = SMatrix::from_fn(|i, j| Complex::from(entry(i * PROBES + j + 1)));
        let ones = SVector::repeat(1.0);
        let mut beyn = Beyn { system, ellipse, rows: ones, columns: ones, probe };
        for _ in 0..4 {
            let sizes = beyn.matrix(Complex::new(0.0, ellipse.height / 3.0)).map(|entry| entry.norm());
            for k in 0..SIZE {
                beyn.rows[k] /= sizes.row(k).max().sqrt();
                beyn.columns[k] /= sizes.column(k).max().sqrt();
            }
        }
        beyn
    }

    fn matrix(&self, lambda: Complex<f64>) -> Overall {
        let matrix = self.system.overall_matrix(lambda);
        SMatrix::from_fn(|i, j| matrix[(i, j)] * (self.rows[i] * self.columns[j]))
    }

    /// The roots in the upper half of the ellipse, from so many nodes on that half.
    pub fn solve(&self, nodes: usize) -> Found {
        let mut found = Found::new(nodes);
        let Some(moments) = self.moments(nodes) else { return found };
        let Some(pencil) = reduced(&moments) else { return found };
        let roots = pencil.complex_eigenvalues();
        let roots = upper(roots.iter().map(|root| root * self.ellipse.height), PROBES);
        roots.into_iter().for_each(|root| found.push(root));
        found
    }

    /// The first four moments in units of half the height; none if a node is a root.
    fn moments(&self, nodes: usize) -> Option<[Moment; 4]> {
        let Ellipse { width, height } = self.ellipse;
        let aspect = width / height;
        let mut moments = [Moment::zeros(); 4];
        for node in 0..nodes {
            let (sin, cos) = (PI * (node as f64 + 0.5) / nodes as f64).sin_cos();
            let z = Complex::new(aspect * cos, sin);
            let derivative = Complex::new(-aspect * sin, cos);
            let solution = self.matrix(z * height).lu().solve(&self.probe)?;
            // zero near the first pair of roots beyond the contour
            let filter = (z * z + 1.3).powi(4);
            // the mirrored node adds the conjugate
            let mut weight = filter * derivative * Complex::new(0.0, -1.0 / nodes as f64);
            for moment in &mut moments {
                *moment += solution.map(|entry| (entry * weight).re);
                weight *= z;
            }
        }
        Some(moments)
    }
}

/// `Uᵀ H_1 W S⁻¹` with the singular values `H_0 = U S Wᵀ`: a matrix with the roots as its eigenvalues.
fn reduced([a, b, c, d]: &[Moment; 4]) -> Option<DMatrix<f64>> {
    let hankel = |first: &Moment, second: &Moment, third: &Moment| {
        DMatrix::from_fn(2 * SIZE, 2 * PROBES, |i, j| {
            let block = [first, second, third][i / SIZE + j / PROBES];
            block[(i % SIZE, j % PROBES)]
        })
    };
    let svd = hankel(a, b, c).svd(true, true);
    let mut pencil = svd.u?.tr_mul(&hankel(b, c, d)) * svd.v_t?.transpose();
    for (mut column, value) in pencil.column_iter_mut().zip(&svd.singular_values) {
        column /= *value;
    }
    Some(pencil)
}
