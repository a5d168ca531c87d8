//! The numbers from which the dynamic stiffness of a uniform member follows at any frequency.

use mstmm_plan::Freedoms;

/// The bending of a uniform beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BendingNumbers {
    /// `z / √ω` with z the wave number times the length.
    pub wave: f64,
    /// `z⁴ / ω²`.
    pub wave_fourth: f64,
    /// `EI/l³`.
    pub stiffness: f64,
    /// Length l.
    pub length: f64,
}

/// The longitudinal vibration of a beam or a rod, that of a string or a shaft, or a spring, which has neither inertia nor foundation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineNumbers {
    /// κ over λ², `m l²/H`: κ is the square of the wave number times the length, `κ = (mλ² + k) l²/H`.
    pub inertia: f64,
    /// κ at rest, `k l²/H`.
    pub foundation: f64,
    /// `H/l`, or the stiffness of the spring.
    pub stiffness: f64,
}

impl LineNumbers {
    /// A spring.
    pub(crate) fn spring(stiffness: f64) -> Self {
        LineNumbers { inertia: 0.0, foundation: 0.0, stiffness }
    }
}

/// What a member is made of, as far as its dynamic stiffness follows from these numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum MemberNumbers {
    /// Something else: a dynamic stiffness that does not follow from such numbers.
    #[default]
    Other,
    /// A beam, with longitudinal vibration or without.
    Beam(BendingNumbers, Option<LineNumbers>),
    /// A line in the freedom of that index: 0 of a translation, which is along the member, 2 of a rotation.
    Line(usize, LineNumbers),
    /// A joint, which ties freedoms rigidly or by springs; zero where there is none.
    Joint(Freedoms, [f64; 3]),
}
