//! Beam in planar motion: bending and longitudinal vibration.

use crate::element::{Element, MemberNumbers, TransferMatrix};
use crate::elements::shared::krylov::{bending_matrix, cosine_and_sinc};
use crate::elements::shared::planar_matrix::planar_matrix;
use crate::model::{Extent, FrequencyEstimates, InvalidParameter, Planar, Requirement};
use crate::number::{Frequency, Parameter, Single};
use nalgebra::{Matrix2, Matrix6};

mod chart;
mod gradient;
mod motion;

/// Uniform Euler-Bernoulli beam with exact longitudinal vibration; the two motions do not couple along a beam.
///
/// Transfer matrix on `[X, Y, Θ, M, Qx, Qy]`: rows and columns `[Y, Θ, M, Qy]` are those of a bending beam, rows and
/// columns `[X, Qx]` are, with `ζ² = -mλ²l²/EA`,
///
/// ```text
/// cos ζ           -(l/EA) sin ζ/ζ
/// (EA/l) ζ sin ζ   cos ζ
/// ```
///
/// # Source
/// Eq. (19) of the paper for bending; longitudinal vibration `EA X'' = mλ² X` with `Qx = -EA X'` in its sign
/// convention.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarBeam<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Axial stiffness EA \[N\], positive.
    pub axial_stiffness: T,
    /// Bending stiffness EI [N m²], positive.
    pub bending_stiffness: T,
    /// Mass per length m [kg/m], positive.
    pub mass_per_length: T,
}

/// A beam with its quantities that do not depend on the frequency.
#[derive(Clone, Copy, Debug)]
pub struct BuiltPlanarBeam<T> {
    parameters: PlanarBeam<T>,
    /// `z / sqrt(ω) = (m/EI)^(1/4) l` and `z⁴ / ω²`.
    wave: T,
    wave_fourth: T,
    /// `ζ² / ω² = m l²/EA`.
    axial_wave_squared: T,
    /// `EI/l³` and `EA/l`.
    bending: T,
    longitudinal: T,
}

impl<T: Parameter> Element for PlanarBeam<T> {
    type State = Planar;
    type Built = BuiltPlanarBeam<T>;

    fn build(self) -> Result<BuiltPlanarBeam<T>, InvalidParameter> {
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("axial_stiffness", self.axial_stiffness)?;
        Requirement::Positive.check("bending_stiffness", self.bending_stiffness)?;
        Requirement::Positive.check("mass_per_length", self.mass_per_length)?;
        let PlanarBeam { length, axial_stiffness, bending_stiffness, mass_per_length } = self;
        let square = (mass_per_length / bending_stiffness).sqrt();
        let axial_wave = (mass_per_length / axial_stiffness).sqrt() * length;
        let half_fourth = square * length * length;
        Ok(BuiltPlanarBeam {
            parameters: self,
            wave: square.sqrt() * length,
            wave_fourth: half_fourth * half_fourth,
            axial_wave_squared: axial_wave * axial_wave,
            bending: bending_stiffness / (length * length * length),
            longitudinal: axial_stiffness / length,
        })
    }

    fn estimate(built: &BuiltPlanarBeam<T>, estimates: &mut FrequencyEstimates) {
        let PlanarBeam { length, mass_per_length, .. } = built.parameters;
        let (l, m) = (length.to_f64(), mass_per_length.to_f64());
        let [bending, longitudinal] = [built.bending, built.longitudinal].map(T::to_f64);
        estimates.waves(1.0 / (built.wave * built.wave).to_f64());
        estimates.translational_stiffness(bending);
        estimates.translational_stiffness(longitudinal);
        estimates.torsional_stiffness(bending * l * l);
        estimates.length(l);
        estimates.mass(m * l);
        estimates.moment_of_inertia(m * l * l * l);
    }

    fn extent(built: &BuiltPlanarBeam<T>) -> Extent {
        Extent::along(built.parameters.length.to_f64())
    }

    fn member_numbers(built: &BuiltPlanarBeam<T>) -> MemberNumbers {
        let PlanarBeam { length, axial_stiffness, bending_stiffness, mass_per_length } = built.parameters;
        MemberNumbers::beam([length, axial_stiffness, bending_stiffness, mass_per_length])
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for PlanarBeam<T> {
    fn transfer_matrix(built: &BuiltPlanarBeam<T>, x: S) -> Matrix6<S> {
        let PlanarBeam { length, axial_stiffness, bending_stiffness, mass_per_length } = built.parameters;
        let lambda_squared = x.lambda_squared();
        let zeta_squared = -lambda_squared * (mass_per_length / axial_stiffness * length * length);
        let (cosine, sinc) = cosine_and_sinc(zeta_squared);
        let bending = bending_matrix(length, bending_stiffness, mass_per_length, lambda_squared);
        let compliance = -(sinc * (length / axial_stiffness));
        let inertia = zeta_squared * sinc * (axial_stiffness / length);
        planar_matrix(&bending, &Matrix2::new(cosine, compliance, inertia, cosine))
    }
}

#[cfg(test)]
impl super::laws::Sample for PlanarBeam<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        PlanarBeam { length: next(), axial_stiffness: next(), bending_stiffness: next(), mass_per_length: next() }
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn halves(self) -> Option<Self> {
        Some(PlanarBeam { length: self.length / 2.0, ..self })
    }
}
