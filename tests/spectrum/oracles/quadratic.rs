//! Eigenvalues of a damped finite element model: its quadratic eigenproblem, linearised with few inner functions per
//! beam, and each eigenvalue refined with all of them.

use super::finite_elements::{BeamElement, Form, Model, Square, add_product};
use mstmm::Complex;
use nalgebra::{DMatrix, DVector, Schur};

type C = Complex<f64>;

/// Inner modes of a beam in the linearised problem.
const INNER: usize = 5;

/// Half of the largest modulus of `z = βl` up to which eigenvalues are looked for: of the inner modes above, one and a
/// half lie higher.
const HALF_WAVES: f64 = 6.0;

fn dense(matrix: &Square) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.len(), matrix.len(), |i, j| matrix[i][j])
}

impl Model<'_> {
    /// `[K, C, M]` with the first inner modes of each beam as degrees of freedom.
    fn matrices(&self) -> [DMatrix<f64>; 3] {
        let [mut stiffness, mut damping, mut mass] = [&self.stiffness, &self.damping, &self.mass].map(Clone::clone);
        for matrix in [&mut stiffness, &mut damping, &mut mass] {
            let size = matrix.len() + INNER * self.beams.len();
            matrix.iter_mut().for_each(|row| row.resize(size, 0.0));
            matrix.resize(size, vec![0.0; size]);
        }
        for (index, beam) in self.beams.iter().enumerate() {
            let inertia = beam.stiffness * beam.wave_fourth;
            for (mode, (inner, coupling)) in
                self.element.inner.iter().zip(&self.element.coupling).take(INNER).enumerate()
            {
                let own: Form = vec![(self.size() + INNER * index + mode, 1.0)];
                add_product(&mut stiffness, &own, &own, beam.stiffness);
                add_product(&mut mass, &own, &own, inertia * inner);
                for (end, coupling) in beam.ends.iter().zip(coupling) {
                    add_product(&mut mass, &own, end, inertia * coupling);
                    add_product(&mut mass, end, &own, inertia * coupling);
                }
            }
        }
        [&stiffness, &damping, &mass].map(dense)
    }

    /// Eigenvalues of the linearised problem. With `λ = σ + 1/μ` and σ > 0, where `σ²M + σC + K` is positive definite:
    /// `μ² Q(σ) + μ Q'(σ) + M = 0`; μ = 0 belongs to what has no mass.
    pub(crate) fn linearised(&self) -> Vec<C> {
        if self.size() == 0 {
            return Vec::new(); // clamped beams alone: nothing that a dashpot could damp
        }
        let [stiffness, damping, mass] = self.matrices();
        let shift = 1.0;
        let slope = &damping + &mass * (2.0 * shift);
        let Some(factor) = (stiffness + &damping * shift + &mass * (shift * shift)).cholesky() else {
            return Vec::new();
        };
        let n = mass.nrows();
        let mut companion = DMatrix::zeros(2 * n, 2 * n);
        companion.view_mut((0, n), (n, n)).fill_with_identity();
        companion.view_mut((n, 0), (n, n)).copy_from(&-factor.solve(&mass));
        companion.view_mut((n, n), (n, n)).copy_from(&-factor.solve(&slope));
        // zero eigenvalues without vectors of their own can keep the iteration from settling
        let Some(schur) = Schur::try_new(companion, f64::EPSILON, 60 * n) else { return Vec::new() };
        schur.complex_eigenvalues().iter().filter(|mu| mu.norm() > 1e-6).map(|mu| mu.inv() + shift).collect()
    }

    /// `K + λC + λ²M` with all inner functions, eliminated.
    fn dynamic_stiffness(&self, lambda: C) -> DMatrix<C> {
        let square = lambda * lambda;
        let n = self.size();
        let entry = |i: usize, j: usize| lambda * self.damping[i][j] + square * self.mass[i][j] + self.stiffness[i][j];
        let mut matrix: Vec<Vec<C>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        for beam in &self.beams {
            let x = square * beam.wave_fourth;
            let factors: Vec<C> = self.element.inner.iter().map(|inner| x * x / (x * inner + 1.0)).collect();
            for (a, end) in beam.ends.iter().enumerate() {
                for (b, other) in beam.ends.iter().enumerate() {
                    let modes = factors.iter().zip(&self.element.coupling);
                    let schur: C = modes.map(|(factor, coupling)| factor * (coupling[a] * coupling[b])).sum();
                    add_product(&mut matrix, end, other, schur * -beam.stiffness);
                }
            }
        }
        DMatrix::from_fn(n, n, |i, j| matrix[i][j])
    }

    /// The eigenvalue next to an estimate by Rayleigh's quotient of a symmetric matrix, with inverse iteration for the
    /// vector; `None` if it does not settle there.
    fn refined(&self, estimate: C) -> Option<C> {
        let mut lambda = estimate;
        let mut vector = DVector::from_fn(self.size(), |i, _| C::new(1.0, 0.3 * i as f64));
        for _ in 0..12 {
            let h = lambda * 1e-4;
            let matrix = self.dynamic_stiffness(lambda);
            let slope = (self.dynamic_stiffness(lambda + h) - self.dynamic_stiffness(lambda - h)) / (h * 2.0);
            vector = matrix.clone().lu().solve(&vector)?.normalize();
            let step = vector.dot(&(matrix * &vector)) / vector.dot(&(slope * &vector));
            lambda -= step;
            if step.norm() < 1e-12 * lambda.norm() {
                return ((lambda - estimate).norm() < 0.02 * estimate.norm()).then_some(lambda);
            }
        }
        None
    }

    /// Eigenvalues that are not zero, with the imaginary part zero or positive, up to the limit of the oracle.
    pub(crate) fn eigenvalues(&self) -> Vec<C> {
        let limit = |beam: &BeamElement| HALF_WAVES * HALF_WAVES / beam.wave_fourth.sqrt();
        let highest = self.beams.iter().map(limit).fold(1e3, f64::min);
        let inside = |lambda: &C| lambda.im > -1e-9 && (1e-3..highest).contains(&lambda.norm());
        self.linearised().into_iter().filter(inside).filter_map(|lambda| self.refined(lambda)).collect()
    }
}
