//! Axial vibration of a member, exact: one spring for the difference of its end displacements and one for their sum.
//!
//! With `t = ωl/2 · sqrt(m/EA)` the dynamic stiffness between the ends is
//! `EA/l · t cot t` on `u2 - u1` and `-EA/l · t tan t` on `u1 + u2`: motions that are odd and even about the middle.

use super::{double, global_matrix::GlobalMatrix};
use crate::stiffness_matrix::Form;
use mstmm::number::{DoubleDouble, Parameter, Scalar};

/// The rod in a member: the axial displacements of its ends, and its length, axial stiffness and mass per length.
#[derive(Debug)]
pub(super) struct Rod {
    pub(super) ends: [Form; 2],
    pub(super) parameters: [DoubleDouble; 3],
}

impl Rod {
    /// The difference and the sum of the displacements of both ends.
    fn odd_and_even(&self) -> [Form; 2] {
        let [from, to] = &self.ends;
        let with = |sign: f64| {
            let other = from.iter().map(|&(index, factor)| (index, factor * double(sign)));
            to.iter().copied().chain(other).collect()
        };
        [with(-1.0), with(1.0)]
    }

    /// Adds the rod as it is at a frequency, and counts its frequencies with held ends.
    ///
    /// Beside a pole of a spring its force is an unknown: the flexibility goes through zero there, and the count with it
    /// does not change.
    pub(super) fn add_to(&self, matrix: &mut GlobalMatrix, omega: DoubleDouble) {
        let [l, ea, m] = self.parameters;
        let [odd, even] = self.odd_and_even();
        let t = omega * l * (m / ea).sqrt() * double(0.5);
        let (sin, cos) = t.sin_cos();
        let unit = ea / l * t;
        // the argument's rounding moves sine and cosine by as much
        let rounding = 2.0 * (1.0 + t.to_f64());
        let turns = t.to_f64() / core::f64::consts::PI;
        let (whole, nearest) = (turns.floor() as i64, (turns + 0.5).floor() as i64);
        let is_sine_larger = sin.to_f64().abs() > cos.to_f64().abs();
        // poles of the cotangent at π, 2π, …: for t up to π/4 there is none near
        if is_sine_larger || (nearest == 0 && !matrix.with_forces) {
            matrix.stiffness(&odd, unit * cos / sin, rounding);
            matrix.held += whole;
        } else {
            matrix.flexibility(&odd, sin / (cos * unit), rounding);
            matrix.held += nearest - 1;
        }
        // poles of the tangent at π/2, 3π/2, …
        if is_sine_larger {
            matrix.flexibility(&even, -(cos / (sin * unit)), rounding);
            matrix.held += whole;
        } else {
            matrix.stiffness(&even, -(unit * sin / cos), rounding);
            matrix.held += nearest;
        }
    }
}
