//! Which symbol stands for an element, by the name of its type or by the keyword of a joint.

use crate::solid::Solid;
use crate::vector::Vector;

/// The symbol of an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    /// A beam, with the width of its line.
    Beam {
        on_foundation: bool,
        width: f64,
    },
    /// A shaft that spins, with its radius on the paper.
    Spinning(f64),
    /// A disc on a shaft, whose last end is at its rim.
    Disc,
    /// A beam in space with ball joints at both ends.
    Bar,
    Rod,
    Line,
    Shaft,
    Body,
    Lever,
    PointMass,
    Mass,
    Inertia,
    Spring,
    Damper,
    SpringDamper,
    TorsionSpring,
    TorsionDamper,
    Pin,
    /// With the direction on the paper in which it slides.
    Slider(Vector),
    ElasticHinge,
    /// A joint or a body in space.
    Solid(Solid),
    /// What joins a path to a point, without extent.
    Tie,
    /// An element of the user's own.
    Other,
}

impl Kind {
    /// The symbol behind the name of a type, such as `GeneralBeam`, or the keyword of a joint.
    pub(crate) fn of(word: &str) -> Kind {
        let word = word.replace('_', "").to_lowercase();
        let has = |part: &str| word.contains(part);
        let torsion = has("torsion");
        match word.as_str() {
            "tie" => Kind::Tie,
            // of a list, whatever it ties
            "pin" | "rotationalhinge" | "joint" => Kind::Pin,
            "slider" | "shearhinge" => Kind::Slider([0.0, 1.0]),
            "string" | "tautstring" | "dampedstring" => Kind::Line,
            "rod" | "dampedrod" => Kind::Rod,
            "shaft" | "dampedshaft" => Kind::Shaft,
            "mass" => Kind::Mass,
            "inertia" => Kind::Inertia,
            "pointmass" => Kind::PointMass,
            "disc" => Kind::Disc,
            "spinningbeam" | "dampedspinningbeam" => Kind::Spinning(0.0),
            "lever" | "levercolumn" => Kind::Lever,
            _ if has("beam") => Kind::Beam { on_foundation: has("foundation"), width: 0.0 },
            _ if has("body") => Kind::Body,
            _ if has("hinge") => Kind::ElasticHinge,
            _ if has("damper") && torsion && !has("spring") => Kind::TorsionDamper,
            _ if has("spring") && torsion => Kind::TorsionSpring,
            "crosscoupledspring" => Kind::SpringDamper,
            _ if has("damper") && has("spring") => Kind::SpringDamper,
            _ if has("damper") => Kind::Damper,
            _ if has("spring") => Kind::Spring,
            _ => Kind::Other,
        }
    }

    /// The symbol of an element of some bending stiffness: a beam is as wide as a round bar would be, but for a factor that all beams share.
    pub(crate) fn of_stiffness(self, stiffness: f64) -> Kind {
        match self {
            // a round bar of a diameter d has EI ~ d⁴
            Kind::Beam { on_foundation, .. } => Kind::Beam { on_foundation, width: stiffness.powf(0.25) },
            other => other,
        }
    }

    /// Whether it is a rigid body, whose last end is its mass centre.
    pub(crate) fn is_body(self) -> bool {
        matches!(self, Kind::Body | Kind::Solid(Solid::Body))
    }

    /// Whether it is a joint of two points at one place.
    pub(crate) fn is_joint(self) -> bool {
        matches!(self, Kind::Pin | Kind::Slider(_) | Kind::ElasticHinge | Kind::Solid(_)) && !self.is_body()
    }

    /// Whether it acts about the axis of its path.
    pub(crate) fn turns(self) -> bool {
        matches!(self, Kind::TorsionSpring | Kind::TorsionDamper | Kind::Shaft)
    }

    /// Whether it is drawn by a line along it first.
    pub(crate) fn is_line(self) -> bool {
        matches!(
            self,
            Kind::Beam { .. }
                | Kind::Spinning(_)
                | Kind::Bar
                | Kind::Rod
                | Kind::Shaft
                | Kind::Line
                | Kind::Lever
                | Kind::Tie
                | Kind::Other
        )
    }

    /// Whether it has no extent along its path.
    pub(crate) fn is_at_a_point(self) -> bool {
        matches!(
            self,
            Kind::PointMass
                | Kind::Disc
                | Kind::Mass
                | Kind::Inertia
                | Kind::Pin
                | Kind::Slider(_)
                | Kind::ElasticHinge
                | Kind::Tie
        ) || self.is_joint()
    }
}
