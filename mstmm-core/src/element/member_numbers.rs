//! The parameters of a member as numbers, from which its dynamic stiffness follows at any frequency.

use mstmm_plan::Freedoms;

/// The parameters of a line: of a rod, a string or a shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineNumbers {
    /// Length l.
    pub(crate) length: f64,
    /// Stiffness H: tension, axial stiffness or torsional stiffness.
    pub(crate) stiffness: f64,
    /// Inertia per length, and the stiffness of a foundation per length.
    pub(crate) inertia: f64,
    pub(crate) foundation: f64,
}

/// What a member is made of, as far as its dynamic stiffness follows from these numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum MemberNumbers {
    /// Something else.
    #[default]
    Other,
    /// A beam as long as its places are apart: bending stiffness, mass per length, and axial stiffness, if it has longitudinal vibration.
    Beam([f64; 2], Option<f64>),
    /// A line in the freedom of that index.
    Line(usize, LineNumbers),
    /// A spring in the freedom of that index.
    Spring(usize, f64),
    /// A joint, which ties freedoms rigidly or by springs; zero where there is none.
    Joint(Freedoms, [f64; 3]),
}

impl MemberNumbers {
    /// A uniform line in the freedom of an index, 0 along the member or 2 about z, as long as its parameter says:
    /// `H y'' = (mλ² + k) y` with the length, H, m and k.
    pub fn uniform_line(freedom: usize, [length, stiffness, inertia, foundation]: [f64; 4]) -> Self {
        let numbers = LineNumbers { length, stiffness, inertia, foundation };
        if freedom < 3 { MemberNumbers::Line(freedom, numbers) } else { MemberNumbers::Other }
    }
}
