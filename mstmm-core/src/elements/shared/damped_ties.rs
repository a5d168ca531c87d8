//! What gives way in the freedoms of a hinge with damping.

use crate::element::Forms;
use crate::elements::shared::damped_stiffness::DampedStiffness;
use crate::elements::shared::massless::off_pole;
use crate::model::{FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{ComplexFrequency, Oscillation, Parameter, Real, Single};

/// The parameters by which hinges give stiffness and damping along x, along y and about z.
const NAMES: [[&str; 2]; 3] =
    [["stiffness_x", "damping_x"], ["stiffness_y", "damping_y"], ["stiffness_theta", "damping_theta"]];

/// What gives way in each freedom, along x, along y and about z; none where it is rigid, or not tied.
#[derive(Clone, Copy, Debug)]
pub struct DampedTies<T> {
    pub(crate) ties: [Option<DampedStiffness<T>>; 3],
}

impl<T: Parameter> DampedTies<T> {
    /// The ties of stiffnesses and dampings, with a loss factor and a time.
    pub(crate) fn new(parts: [Option<[T; 2]>; 3], [loss_factor, time]: [T; 2]) -> Result<Self, InvalidParameter> {
        let mut ties = [None; 3];
        for ((tie, part), names) in ties.iter_mut().zip(parts).zip(NAMES) {
            let Some([stiffness, damping]) = part else { continue };
            let numbers = [stiffness, loss_factor, time, damping];
            *tie = Some(DampedStiffness::new(Requirement::InvertibleOrZero, numbers, names)?);
        }
        Ok(DampedTies { ties })
    }

    /// The same of numbers of which those of a rigid freedom are infinite.
    pub(crate) fn or_rigid(parts: [[T; 2]; 3], losses: [T; 2]) -> Result<Self, InvalidParameter> {
        DampedTies::new(parts.map(|part| (part[0].to_f64() != f64::INFINITY).then_some(part)), losses)
    }

    /// Adds stiffnesses, dampings and losses to the estimates.
    pub(crate) fn estimate(&self, estimates: &mut FrequencyEstimates) {
        let [x, y, rotation] = self.ties;
        for tie in [x, y].into_iter().flatten() {
            let own = [FrequencyEstimates::translational_stiffness, FrequencyEstimates::translational_damping];
            tie.estimate(estimates, own);
        }
        if let Some(tie) = rotation {
            tie.estimate(estimates, [FrequencyEstimates::torsional_stiffness, FrequencyEstimates::torsional_damping]);
        }
    }

    /// The compliance of each freedom, zero where it is rigid.
    pub(crate) fn compliances<S: ComplexFrequency<T> + Single>(&self, x: S) -> [S; 3] {
        self.ties.map(|tie| tie.map_or(S::zero(), |tie| off_pole(tie.at(x)).1))
    }

    /// The product of all dynamic stiffnesses, whose zeros are poles of the compliances.
    pub(crate) fn denominator<S: ComplexFrequency<T> + Single>(&self, x: S) -> S {
        self.ties.iter().flatten().fold(S::one(), |product, tie| product * off_pole(tie.at(x)).0)
    }
}

impl<T: Real> DampedTies<T> {
    /// The forms of two motions, the first of them at λ, given the products of their elongations.
    pub(crate) fn forms<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S, elongations: [S; 3]) -> Forms<S> {
        let parts = self.ties.iter().zip(elongations);
        let forms = parts.filter_map(|(tie, product)| Some(tie.as_ref()?.forms(lambda, product)));
        forms.fold(Forms::none(), Forms::plus)
    }

    /// The derivatives of the dynamic work with respect to stiffness and damping of each freedom, and to loss factor and time, given the squares of
    /// the elongations.
    pub(crate) fn gradient<S: ComplexFrequency<T> + Oscillation<T>>(
        &self,
        lambda: S,
        squares: [S; 3],
    ) -> ([[S; 2]; 3], [S; 2]) {
        let (mut own, mut losses) = ([[S::zero(); 2]; 3], [S::zero(); 2]);
        for ((own, tie), square) in own.iter_mut().zip(&self.ties).zip(squares) {
            let Some(tie) = tie else { continue };
            let [stiffness, loss, time, damping] = tie.gradient(lambda, square);
            *own = [stiffness, damping];
            losses = [losses[0] + loss, losses[1] + time];
        }
        (own, losses)
    }
}

/// A stiffness from a sample: of an infinite sample it is negative, since zero lets go and an infinite stiffness is rigid.
#[cfg(test)]
pub(crate) fn by_compliance(sample: f64) -> f64 {
    1.0 / sample - 0.1
}
