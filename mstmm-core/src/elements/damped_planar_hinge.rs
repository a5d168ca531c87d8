//! A hinge with damping in planar motion.

use crate::element::{Element, TransferMatrix};
use crate::elements::planar_hinge::hinge_matrix;
use crate::elements::shared::damped_ties::DampedTies;
#[cfg(test)]
use crate::elements::shared::damped_ties::by_compliance;
use crate::model::{FrequencyEstimates, InvalidParameter, Planar};
use crate::number::{ComplexFrequency, Parameter, Single};
use nalgebra::Matrix6;

/// Massless hinge in planar motion with damping, at complex frequencies λ only: in each freedom `κ = K (1 + iη)(1 + cλ) + dλ`.
///
/// Transfer matrix on `[X, Y, Θ, M, Qx, Qy]`: that of a [`PlanarHinge`](crate::elements::PlanarHinge) with κ in the place of K.
///
/// # Source
/// Eqs. (3), (4) and (32) of the paper with complex stiffnesses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedPlanarHinge<T> {
    /// Stiffness K_x along x [N/m], zero or positive; infinite is rigid.
    pub stiffness_x: T,
    /// Stiffness K_y along y [N/m], zero or positive; infinite is rigid.
    pub stiffness_y: T,
    /// Torsional stiffness K_θ [N m/rad], zero or positive; infinite is rigid.
    pub stiffness_theta: T,
    /// Damping d_x of a dashpot along x [N s/m], zero or positive.
    pub damping_x: T,
    /// Damping d_y of a dashpot along y [N s/m], zero or positive.
    pub damping_y: T,
    /// Damping d_θ of a dashpot about z [N m s/rad], zero or positive.
    pub damping_theta: T,
    /// Loss factor η, zero or positive.
    pub loss_factor: T,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    pub kelvin_voigt_time: T,
}

impl<T: Parameter> Element for DampedPlanarHinge<T> {
    type State = Planar;
    type Built = DampedTies<T>;

    fn build(self) -> Result<DampedTies<T>, InvalidParameter> {
        let parts = [
            [self.stiffness_x, self.damping_x],
            [self.stiffness_y, self.damping_y],
            [self.stiffness_theta, self.damping_theta],
        ];
        DampedTies::or_rigid(parts, [self.loss_factor, self.kelvin_voigt_time])
    }

    fn estimate(built: &DampedTies<T>, estimates: &mut FrequencyEstimates) {
        built.estimate(estimates);
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for DampedPlanarHinge<T> {
    fn transfer_matrix(built: &DampedTies<T>, x: S) -> Matrix6<S> {
        hinge_matrix(built.compliances(x))
    }

    fn denominator(built: &DampedTies<T>, x: S) -> Option<S> {
        Some(built.denominator(x))
    }
}

#[cfg(test)]
impl super::laws::Sample for DampedPlanarHinge<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        DampedPlanarHinge {
            stiffness_x: by_compliance(next()),
            stiffness_y: by_compliance(next()),
            stiffness_theta: by_compliance(next()),
            damping_x: 0.5 * next(),
            damping_y: 0.5 * next(),
            damping_theta: 0.5 * next(),
            loss_factor: 0.2 * next(),
            kelvin_voigt_time: next(),
        }
    }

    fn lossless(self) -> Self {
        DampedPlanarHinge { loss_factor: 0.0, ..self }
    }
}
