//! The dimension of a model, on which it depends what a word is.

use mstmm_plan::Freedoms;

/// Along a line, in the plane or in space: the number of coordinates of all points, or what the paths of a model without places say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimension {
    /// One coordinate: beams along a line, which move across it.
    Line,
    /// Two coordinates.
    Plane,
    /// Three coordinates.
    Space,
}

impl Dimension {
    pub(crate) fn coordinates(self) -> usize {
        match self {
            Dimension::Line => 1,
            Dimension::Plane => 2,
            Dimension::Space => 3,
        }
    }

    /// The freedoms that a point can have.
    pub(crate) fn freedoms(self) -> Freedoms {
        match self {
            Dimension::Line => Freedoms::Y.union(Freedoms::RZ),
            Dimension::Plane => Freedoms::PLANE,
            Dimension::Space => Freedoms::SPACE,
        }
    }

    /// A place, as advice shows it.
    pub(crate) fn example(self) -> &'static str {
        match self {
            Dimension::Line => "at x",
            Dimension::Plane => "at (x, y)",
            Dimension::Space => "at (x, y, z)",
        }
    }

    /// The parts of a direction, as advice shows them.
    pub(crate) fn direction(self) -> &'static str {
        match self {
            Dimension::Line | Dimension::Plane => "(dx, dy)",
            Dimension::Space => "(dx, dy, dz)",
        }
    }
}
