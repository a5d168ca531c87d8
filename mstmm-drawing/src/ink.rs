//! What is drawn with one pen.

use crate::outline::Outline;

/// A pen: the class of a path in the style sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pen {
    Beam,
    Rod,
    Thin,
    Rigid,
    RigidEdge,
    Spring,
    Area,
    Dot,
    Hollow,
    Ground,
    Hatch,
    /// The ground below a support in space.
    Base,
    /// Paper around a line, and around a thick one.
    Halo,
    WideHalo,
}

impl Pen {
    /// Whether it draws in the colour of the paper alone.
    pub(crate) fn is_halo(self) -> bool {
        matches!(self, Pen::Halo | Pen::WideHalo)
    }

    pub(crate) fn class(self) -> &'static str {
        match self {
            Pen::Beam => "beam",
            Pen::Rod => "rod",
            Pen::Thin => "thin",
            Pen::Rigid => "rigid",
            Pen::RigidEdge => "rigid edge",
            Pen::Spring => "spring",
            Pen::Area => "area",
            Pen::Dot => "dot",
            Pen::Hollow => "hollow",
            Pen::Ground => "ground",
            Pen::Hatch => "hatch",
            Pen::Base => "base",
            Pen::Halo => "halo",
            Pen::WideHalo => "halo wide",
        }
    }
}

/// A line or an area with its pen.
#[derive(Clone, Debug)]
pub(crate) struct Ink {
    pub(crate) pen: Pen,
    pub(crate) outline: Outline,
    /// The width of a line that has not that of its pen.
    pub(crate) width: Option<f64>,
}

impl Ink {
    pub(crate) fn new(pen: Pen, outline: Outline) -> Self {
        Ink { pen, outline, width: None }
    }
}
