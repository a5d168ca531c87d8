//! What stands in space and has a symbol with directions there.

use crate::vector3::Vector3;

/// A joint or a body in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Solid {
    /// It shares displacements.
    Ball,
    /// It turns about an axis.
    Revolute(Vector3),
    /// It turns about two axes.
    Universal([Vector3; 2]),
    /// It slides along an axis.
    Prismatic(Vector3),
    /// It slides along an axis and turns about it.
    Cylindrical(Vector3),
    /// It is flexible.
    Mount,
    /// It shares some other motions.
    Joint,
    /// A body, with lines from its mass centre, the last of its ends, to what it ties.
    Body,
}

/// A support in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grip {
    pub(crate) held: Held,
    /// The way to the ground, of length 1.
    pub(crate) ground: Vector3,
}

/// What a support in space holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Held {
    All,
    Displacements,
    /// The displacement along the way to the ground, and all rotations or none.
    Across {
        rotations: bool,
    },
    /// The displacements but along a direction of length 1, and all rotations or none.
    Along {
        direction: Vector3,
        rotations: bool,
    },
    Rotations,
}

impl Held {
    /// The name of the symbol.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Held::All => "fixed",
            Held::Displacements => "pinned",
            Held::Across { rotations: false } | Held::Along { rotations: false, .. } => "roller",
            Held::Across { rotations: true } | Held::Along { rotations: true, .. } => "guided",
            Held::Rotations => "rotation",
        }
    }
}
