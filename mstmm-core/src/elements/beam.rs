//! Euler-Bernoulli beam.

use crate::beam_functions::bending_matrix;
use crate::element::{Element, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real};
use crate::state::Bending;
use nalgebra::Matrix4;

/// Uniform Euler-Bernoulli beam, exact at every frequency.
///
/// Transfer matrix on `[Y, Θ, M, Q]` with `β⁴ = -mλ²/EI`, `z = βl` and the Krylov functions S, T, U, V of z:
///
/// ```text
/// S        T/β      U/(EIβ²)  V/(EIβ³)
/// βV       S        T/(EIβ)   U/(EIβ²)
/// EIβ²U    EIβV     S         T/β
/// EIβ³T    EIβ²U    βV        S
/// ```
///
/// Every entry is an entire function of `z⁴`, so that λ = 0 is an ordinary point (the static beam).
///
/// # Source
/// Eq. (19) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Bending stiffness EI [N m²], positive.
    pub bending_stiffness: T,
    /// Mass per length m [kg/m], positive.
    pub mass_per_length: T,
}

impl<T: Real> Element for Beam<T> {
    type State = Bending;

    fn validate(&self) -> Result<(), InvalidParameter> {
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("bending_stiffness", self.bending_stiffness)?;
        Requirement::Positive.check("mass_per_length", self.mass_per_length)
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Beam<T> {
    fn transfer_matrix(&self, x: S) -> Matrix4<S> {
        bending_matrix(self.length, self.bending_stiffness, self.mass_per_length, x.lambda_squared())
    }
}

#[cfg(test)]
impl super::laws::Sample for Beam<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Beam { length: next(), bending_stiffness: next(), mass_per_length: next() }
    }

    fn halves(self) -> Option<Self> {
        Some(Beam { length: self.length / 2.0, ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::assert_close;

    /// Cubic deflection of a static cantilever under a unit tip force and a unit tip moment.
    #[test]
    fn at_rest_it_is_the_static_beam() {
        let (l, ei) = (2.0_f64, 5.0);
        let u = Beam { length: l, bending_stiffness: ei, mass_per_length: 3.0 }.transfer_matrix(0.0);
        let expected = [
            [1.0, l, l * l / (2.0 * ei), l.powi(3) / (6.0 * ei)],
            [0.0, 1.0, l / ei, l * l / (2.0 * ei)],
            [0.0, 0.0, 1.0, l],
            [0.0, 0.0, 0.0, 1.0],
        ];
        for (row, values) in expected.iter().enumerate() {
            for (column, &value) in values.iter().enumerate() {
                assert_close(u[(row, column)], value, value.abs(), 4.0);
            }
        }
    }
}
