//! Stiffness and inertia of single degrees of freedom: those that weigh most are kept, since where they are eliminated
//! large numbers are left that cancel.

use crate::stiffness_matrix::beam_matrix::SERIES;
use mstmm::elements::Beam;
use mstmm::number::{DoubleDouble, Parameter};

/// What holds or slows a degree of freedom down, all else at rest.
#[derive(Clone, Copy, Debug)]
pub(super) enum Weight {
    /// `k + cω + mω²`.
    Lumped([f64; 3]),
    /// The static bending of a beam, by deflection or rotation; none where it is many waves long.
    Bending(Beam<f64>, bool),
    /// A displacement of the end of a beam.
    BeamEnd(Beam<f64>, bool),
}

impl Weight {
    pub(super) const NONE: Self = Weight::Lumped([0.0; 3]);

    pub(super) fn mass(mass: DoubleDouble) -> Self {
        Weight::Lumped([0.0, 0.0, mass.to_f64()])
    }

    pub(super) fn link(stiffness: f64, damping: f64) -> Self {
        Weight::Lumped([stiffness, damping, 0.0])
    }

    pub(super) fn bending(beam: &Beam<f64>, is_rotation: bool) -> Self {
        Weight::Bending(*beam, is_rotation)
    }

    pub(super) fn beam_end(beam: &Beam<f64>, is_rotation: bool) -> Self {
        Weight::BeamEnd(*beam, is_rotation)
    }

    /// The weight at a frequency.
    pub(super) fn at(&self, omega: f64) -> f64 {
        let of_beam = |beam: &Beam<f64>| {
            let l = beam.length;
            let z_squared = omega * l * l * (beam.mass_per_length / beam.bending_stiffness).sqrt();
            (beam.bending_stiffness / (l * l * l), z_squared.sqrt(), l)
        };
        match self {
            Weight::Lumped([stiffness, damping, mass]) => stiffness + omega * (damping + omega * mass),
            Weight::Bending(beam, is_rotation) => match of_beam(beam) {
                (_, z, _) if z >= SERIES => 0.0,
                (unit, _, l) => unit * if *is_rotation { 4.0 * l * l } else { 12.0 },
            },
            Weight::BeamEnd(beam, is_rotation) => match of_beam(beam) {
                (unit, z, l) if z >= SERIES => unit * z * if *is_rotation { l * l } else { z * z },
                (unit, z, l) => unit * z.powi(4) * if *is_rotation { 0.01 * l * l } else { 0.4 },
            },
        }
    }
}
