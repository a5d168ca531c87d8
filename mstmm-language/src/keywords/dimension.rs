//! The dimension of a model, on which it depends what a word is.

use mstmm_plan::Freedoms;

/// Along a line or in the plane: the number of coordinates of all points, or what the paths of a model without places say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimension {
    /// One coordinate: beams along a line, which move across it.
    Line,
    /// Two coordinates.
    Plane,
}

impl Dimension {
    pub(crate) fn coordinates(self) -> usize {
        match self {
            Dimension::Line => 1,
            Dimension::Plane => 2,
        }
    }

    /// The freedoms that a point can have.
    pub(crate) fn freedoms(self) -> Freedoms {
        match self {
            Dimension::Line => Freedoms::Y.union(Freedoms::RZ),
            Dimension::Plane => Freedoms::PLANE,
        }
    }

    /// A place, as advice shows it.
    pub(crate) fn example(self) -> &'static str {
        match self {
            Dimension::Line => "at x",
            Dimension::Plane => "at (x, y)",
        }
    }
}
