//! The numbers from which the dynamic stiffness of a uniform member follows at any frequency.

use mstmm_plan::Freedoms;

/// The bending of a uniform beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BendingNumbers {
    /// `z / √ω` with z the wave number times the length, and `z⁴ / ω²`.
    pub(crate) wave: f64,
    pub(crate) wave_fourth: f64,
    /// `EI/l³`.
    pub(crate) stiffness: f64,
    /// Length l.
    pub(crate) length: f64,
}

/// The longitudinal vibration of a beam or a rod, that of a string or a shaft, or a spring, which has neither inertia nor foundation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineNumbers {
    /// κ over λ², and κ at rest, with κ the square of the wave number times the length.
    pub(crate) inertia: f64,
    pub(crate) foundation: f64,
    /// `H/l`, or the stiffness of the spring.
    pub(crate) stiffness: f64,
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
    /// Something else.
    #[default]
    Other,
    /// A beam, with longitudinal vibration or without.
    Beam(BendingNumbers, Option<LineNumbers>),
    /// A line in the freedom of that index.
    Line(usize, LineNumbers),
    /// A joint, which ties freedoms rigidly or by springs; zero where there is none.
    Joint(Freedoms, [f64; 3]),
}

impl MemberNumbers {
    /// A uniform line in the freedom of an index, 0 along the member or 2 about z, as long as its parameter says:
    /// `H y'' = (mλ² + k) y` with the length, H, m and k.
    pub fn uniform_line(freedom: usize, [length, stiffness, inertia, foundation]: [f64; 4]) -> Self {
        let flexibility = length / stiffness;
        let [inertia, foundation] = [inertia, foundation].map(|per_length| per_length * length * flexibility);
        MemberNumbers::Line(freedom, LineNumbers { inertia, foundation, stiffness: stiffness / length })
    }
}
