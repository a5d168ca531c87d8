//! Eigenvalues of trees as zeros of the determinant of the dynamic stiffness.

use super::{Reduced, Stiffness, Verdict, parameters};
use crate::stiffness_matrix::beam_matrix::BeamMatrix;
use crate::stiffness_matrix::determinant::{Determinant, determinant};
use crate::stiffness_matrix::discs::{C, SURE_TURN, Zeros, complex, modulus};
use mstmm::Complex;
use mstmm::search::Eigenvalue;

/// No eigenvalue of any model but one of which everything is.
const GENERIC: Complex<f64> = Complex::new(0.371_305, 0.773_205);

/// Part of the next eigenvalue within which eigenvalues that are said to be zero are sought.
const AT_REST: f64 = 1e-2;

impl Zeros for Reduced {
    fn cuts(&self, lambda: C) -> Vec<bool> {
        self.beams.iter().map(|beam| BeamMatrix::of(parameters(&beam.beam), lambda).is_near_a_pole()).collect()
    }

    fn determinant(&self, lambda: C, cuts: &[bool]) -> Determinant {
        let (size, pieces) = self.pieces(lambda, |_, index| cuts[index]);
        determinant(&self.assembled(lambda, size, &pieces))
    }
}

impl Stiffness {
    /// The eigenvalue next to λ, to a small part of a radius; `None` if there is none or rounding hides it.
    #[allow(dead_code, reason = "others ask for discs")]
    pub(crate) fn eigenvalue_near(&self, lambda: C, radius: f64) -> Option<C> {
        self.at(modulus(lambda)).nearest(lambda, radius)
    }

    /// Whether so many eigenvalues are zero as a disc says. Just above zero, stiffnesses hide what mass and damping add to
    /// them, and the rounding of lengths holds what is free: there, a larger circle is as good, if it is far below the next
    /// eigenvalue.
    fn judge_zero(&self, root: &Eigenvalue, next: f64) -> Verdict {
        let (mut radius, mut verdict) = (root.error, Verdict::CannotTell);
        while radius < AT_REST * next && radius < 1.0 / root.error {
            match self.at(radius).power(radius) {
                Some(held) if held == root.multiplicity => return Verdict::Holds,
                // where no other is listed, larger circles may hold some
                Some(held) if held > root.multiplicity && next.is_infinite() => return verdict,
                Some(_) => verdict = Verdict::Misses(radius / root.error),
                None => {}
            }
            radius *= 16.0;
        }
        verdict
    }

    /// Number of eigenvalues up to a modulus, of a model without beams.
    #[allow(dead_code, reason = "others ask for discs")]
    pub(crate) fn eigenvalues_within(&self, radius: f64) -> Option<u64> {
        self.at(radius).power(radius)
    }

    /// Whether nothing is held twice, and nothing is without stiffness, damping and mass.
    #[allow(dead_code, reason = "others take sound models only")]
    pub(crate) fn is_sound(&self) -> bool {
        let model = self.at(modulus(complex(GENERIC)));
        let determinant = model.determinant(complex(GENERIC), &model.cuts(complex(GENERIC)));
        !self.is_held_twice && determinant.error < SURE_TURN
    }

    /// Whether each disc of a list holds its eigenvalues.
    pub(crate) fn judge_discs(&self, list: &[Eigenvalue]) -> Vec<Verdict> {
        let is_zero = |root: &Eigenvalue| root.lambda.norm() <= root.error;
        let next =
            list.iter().filter(|root| !is_zero(root)).map(|root| root.lambda.norm()).fold(f64::INFINITY, f64::min);
        let verdict = |root: &Eigenvalue| {
            if is_zero(root) { self.judge_zero(root, next) } else { self.at(root.lambda.norm()).judge(root) }
        };
        list.iter().map(verdict).collect()
    }
}
