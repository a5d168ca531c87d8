//! The numbers from which the waves of a member follow at any frequency, computed from its parameters once.

use crate::element::{BeamNumbers, Exact, LineNumbers, MemberNumbers};
use crate::number::Scalar;
use mstmm_plan::Freedoms;

/// The bending of a uniform beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BendingWave {
    /// `z / √ω` with z the wave number times the length, `z⁴ / ω²` and its inverse.
    pub(super) wave: f64,
    pub(super) wave_fourth: f64,
    pub(super) inverse_fourth: f64,
    /// `EI/l³`.
    pub(super) stiffness: f64,
    /// Length l.
    pub(super) length: f64,
}

/// The longitudinal vibration of a beam or a rod, that of a string or a shaft, or a spring, which has neither inertia nor foundation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LineWave {
    /// κ over λ², and κ at rest, with κ the square of the wave number times the length.
    pub(super) inertia: f64,
    pub(super) foundation: f64,
    /// `H/l`, or the stiffness of the spring.
    pub(super) stiffness: f64,
}

/// What a member is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Waving {
    /// Something else.
    Other,
    /// A beam, with longitudinal vibration or without.
    Beam(BendingWave, Option<LineWave>),
    /// A line in the freedom of that index.
    Line(usize, LineWave),
    /// A joint, which ties freedoms rigidly or by springs; zero where there is none.
    Joint(Freedoms, [f64; 3]),
}

impl Waving {
    /// A member of a length that its places give.
    pub(super) fn new(numbers: &MemberNumbers, length: f64) -> Self {
        let of = |[upper, lower]: Exact| upper + lower;
        match *numbers {
            MemberNumbers::Beam(beam) if beam.is_plain() => {
                let BeamNumbers { bending_stiffness, mass_per_length, axial_stiffness, .. } = beam;
                let [stiffness, mass, axial] = [bending_stiffness, mass_per_length, axial_stiffness].map(of);
                let along = (axial_stiffness != [0.0; 2]).then(|| LineWave::new([length, axial, mass, 0.0]));
                Waving::Beam(BendingWave::new([length, stiffness, mass]), along)
            }
            MemberNumbers::Line(freedom, LineNumbers { length, stiffness, inertia, foundation }) => {
                Waving::Line(freedom, LineWave::new([length, stiffness, inertia, foundation].map(of)))
            }
            MemberNumbers::LineBetween(freedom, LineNumbers { stiffness, inertia, foundation, .. }) => {
                let [stiffness, inertia, foundation] = [stiffness, inertia, foundation].map(of);
                Waving::Line(freedom, LineWave::new([length, stiffness, inertia, foundation]))
            }
            MemberNumbers::Spring(freedom, stiffness) => {
                Waving::Line(freedom, LineWave { inertia: 0.0, foundation: 0.0, stiffness: of(stiffness) })
            }
            MemberNumbers::Joint(rigid, elastic) => Waving::Joint(rigid, elastic.map(of)),
            _ => Waving::Other,
        }
    }
}

impl BendingWave {
    /// Of length, bending stiffness and mass per length.
    fn new([length, stiffness, mass]: [f64; 3]) -> Self {
        let square = Scalar::sqrt(mass / stiffness);
        let half_fourth = square * length * length;
        let wave_fourth = half_fourth * half_fourth;
        BendingWave {
            wave: Scalar::sqrt(square) * length,
            wave_fourth,
            inverse_fourth: 1.0 / wave_fourth,
            stiffness: stiffness / (length * length * length),
            length,
        }
    }
}

impl LineWave {
    /// Of length, stiffness, inertia and foundation.
    fn new([length, stiffness, inertia, foundation]: [f64; 4]) -> Self {
        let compliance = length / stiffness;
        LineWave {
            inertia: inertia * length * compliance,
            foundation: foundation * length * compliance,
            stiffness: stiffness / length,
        }
    }
}
