//! The forms of springs, dampers and masses.

use crate::model::Ends;
use crate::number::{Scalar, Single};
use mstmm_plan::Coordinate;

/// The form `ΔY₁ ΔY₂`, or `ΔΘ₁ ΔΘ₂`, of a stiffness or a damping of 1.
pub(crate) fn elongations<S: Scalar>(coordinate: Coordinate, first: &Ends<S>, second: &Ends<S>) -> S {
    let elongation = |ends: &Ends<S>| ends.output.entry(coordinate) - ends.input.entry(coordinate);
    elongation(first) * elongation(second)
}

/// The form `Y₁ Y₂`, or `Θ₁ Θ₂`, of an inertia of 1.
pub(crate) fn displacements<S: Scalar>(coordinate: Coordinate, first: &Ends<S>, second: &Ends<S>) -> S {
    first.input.entry(coordinate) * second.input.entry(coordinate)
}

/// Usual sizes `[Q/Y, M/Θ]` of an element that knows one of them.
pub(crate) fn unit_of(coordinate: Coordinate, size: f64) -> [f64; 2] {
    if coordinate == Coordinate::Y { [size, 0.0] } else { [0.0, size] }
}

/// The sum of terms that are the same at both ends of a member, of those that are smaller: they cancel where waves decay.
pub(crate) fn smaller_sum<S: Single, const N: usize>([input, output]: [[S; N]; 2]) -> S {
    let size = |terms: &[S; N]| terms.iter().map(|term| term.size()).sum::<f64>();
    let terms = if size(&input) < size(&output) { input } else { output };
    terms.into_iter().fold(S::zero(), |sum, term| sum + term)
}

/// Half of a form of a motion with itself.
pub(crate) fn half<S: Scalar>(form: S) -> S {
    form * S::from_f64(0.5)
}
