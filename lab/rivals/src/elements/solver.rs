//! A scene by finite elements: which eigenproblem, and how large a Krylov space.

use super::assembly::{Matrices, assembled};
use super::reference::reference;
use super::{arnoldi, dense, lanczos};
use crate::found::Found;
use crate::scenes::Scene;
use nalgebra::Complex;

/// The matrices of a scene, assembled before any time is taken, as systems are built for the other methods.
#[derive(Clone, Debug)]
pub struct Problem {
    matrices: Matrices,
    solver: Solver,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Solver {
    /// Undamped, a few roots next to a shift.
    Lanczos { shift: f64, dimension: usize },
    /// Undamped, with close roots.
    Dense,
    /// Damped.
    Arnoldi { dimension: usize },
}

impl Problem {
    /// A scene with every beam cut into `parts` elements of a degree.
    ///
    /// The dimension of the Krylov space is chosen with the exact roots known, in favour of the method: the least that
    /// costs no digits beyond those lost by the elements, of the first twelve.
    pub fn new(scene: &Scene, parts: usize, degree: usize) -> Self {
        let matrices = assembled(&scene.structure.refined(parts), degree, &reference(degree));
        let wanted = scene.exact.len();
        let with = |solver| Problem { matrices: matrices.clone(), solver };
        if scene.has_close_roots {
            return with(Solver::Dense);
        }
        let candidates: Vec<Problem> = if matrices.damping.is_some() {
            (wanted..wanted + 14).map(|k| with(Solver::Arnoldi { dimension: 2 * k })).collect()
        } else {
            let lanczos = |dimension| with(Solver::Lanczos { shift: scene.shift, dimension });
            (wanted + 2..wanted + 12).map(lanczos).collect()
        };
        let error = |problem: &Problem| problem.solve(wanted).error(&scene.exact);
        let errors: Vec<f64> = candidates.iter().map(error).collect();
        let best = errors.iter().copied().fold(f64::INFINITY, f64::min);
        let cheapest = candidates.into_iter().zip(&errors).find(|(_, error)| **error <= (2.0 * best).max(5e-13));
        cheapest.map_or_else(|| with(Solver::Dense), |(problem, _)| problem)
    }

    /// The wanted number of roots; `evaluations` is the number of unknowns.
    pub fn solve(&self, wanted: usize) -> Found {
        let squares = match self.solver {
            Solver::Lanczos { shift, dimension } => lanczos::nearest(&self.matrices, shift, wanted, dimension),
            Solver::Dense => dense::lowest(&self.matrices, wanted),
            Solver::Arnoldi { dimension } => {
                let mut found = Found::new(self.unknowns());
                arnoldi::lowest(&self.matrices, wanted, dimension).into_iter().for_each(|root| found.push(root));
                return found;
            }
        };
        let mut found = Found::new(self.unknowns());
        squares.iter().for_each(|square| found.push(Complex::new(0.0, square.sqrt())));
        found.sorted()
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.matrices.mass.size()
    }
}
