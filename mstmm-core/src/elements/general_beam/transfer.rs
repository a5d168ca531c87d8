//! The transfer matrix of a general beam, and the way of covectors back through it.

use crate::elements::general_beam::constants::SectionAt;
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::general_beam::wave_pair::PairFunctions;
use crate::number::Scalar;
use crate::subspace::Covector;
use nalgebra::Matrix4;

/// The transfer matrix over Y, Θ, M, Q in units of l and EI, divided by `2^exponent`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transfer<S> {
    rows: [[S; 4]; 4],
    exponent: i32,
}

impl<S: Scalar> Transfer<S> {
    /// `exp A = c₀ + c₁ A + c₂ A² + c₃ A³` for the matrix A of the equations.
    pub(crate) fn new(section: &SectionAt<S>) -> Self {
        Transfer::of_functions(section, section.waves.in_form().functions())
    }

    /// The same from the functions of the waves.
    pub(super) fn of_functions(section: &SectionAt<S>, functions: PairFunctions<S>) -> Self {
        let SectionAt { sigma, tau, g, h, waves, .. } = *section;
        let PairFunctions { c: [c0, c1, c2, c3], exponent } = functions;
        let tau_h = tau * h;
        let square = sigma * sigma;
        let slope = sigma * (c1 + waves.sum * c3);
        let (bent, curved) = (sigma * c2, h * sigma * c3);
        let (yy, tt) = (c0 - tau_h * c2, c0 + g * c2);
        let rows = [
            [yy, slope, bent, (square + tau * tau_h) * c3 - tau * c1],
            [curved, tt, c1 + g * c3, bent],
            [h * bent, g * c1 + (g * g + square * h) * c3, tt, slope],
            [h * (c1 - tau_h * c3), h * bent, curved, yy],
        ];
        Transfer { rows, exponent }
    }

    /// The rows over `2^exponent`.
    pub(crate) fn over_power(&self, exponent: i32) -> [[S; 4]; 4] {
        self.rows.map(|row| row.map(|entry| entry.times_power_of_two(self.exponent - exponent)))
    }

    /// The matrix in the units of a beam.
    pub(crate) fn matrix(&self, beam: &BeamParameters<S>) -> Matrix4<S> {
        let units = units_of_states(beam);
        Matrix4::from_fn(|row, column| {
            (self.rows[row][column] * units[row] / units[column]).times_power_of_two(self.exponent)
        })
    }
}

/// Units of Y, Θ, M, Q: `l, 1, EI/l, EI/l²`.
pub(super) fn units_of_states<S: Scalar>(beam: &BeamParameters<S>) -> [S; 4] {
    let stiffness = beam.bending_stiffness / beam.length;
    [beam.length, S::one(), stiffness, stiffness / beam.length]
}

/// The transfer matrix for covectors, with the units of states.
#[derive(Clone, Copy, Debug)]
pub struct BackThrough<S> {
    transfer: Transfer<S>,
    /// Units of Y, Θ, M, Q.
    units: [S; 4],
    inverses: [S; 4],
}

impl<S: Scalar> BackThrough<S> {
    pub(crate) fn new(transfer: Transfer<S>, beam: &BeamParameters<S>) -> Self {
        let units = units_of_states(beam);
        BackThrough { transfer, units, inverses: units.map(|unit| S::one() / unit) }
    }

    /// `Uᵀ η`.
    pub(crate) fn back_transfer(&self, covector: Covector<S>) -> Covector<S> {
        let (entries, exponent) = covector.entries();
        let Transfer { rows, exponent: own } = self.transfer;
        let behind: [S; 4] = core::array::from_fn(|row| entries[row] * self.units[row]);
        let entries = core::array::from_fn(|column| {
            let terms = behind.iter().zip(&rows).map(|(entry, row)| *entry * row[column]);
            terms.fold(S::zero(), |sum, term| sum + term) * self.inverses[column]
        });
        Covector::Plane(entries, exponent.saturating_add(own))
    }
}
