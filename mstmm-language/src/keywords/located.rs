//! The keywords of models with locations: what each element is between points.

use mstmm_plan::Freedoms;

/// What a node of the sketch is in a network of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Connection,
    Support,
    /// A mass at a point.
    PointMass,
    /// An element with extent between two points.
    Member,
    /// A mass with extent that ties points rigidly.
    RigidBody,
    /// An element between two points at one place.
    Joint,
    /// A part of a path of translation or rotation, with one motion.
    Path,
    /// A node of unknown meaning, about which another message speaks.
    Unknown,
}

impl Role {
    /// Whether the node is a point, or a part of one.
    pub(crate) fn is_point(self) -> bool {
        matches!(self, Role::Connection | Role::Support | Role::PointMass)
    }
}

/// The number of coordinates of all points of a model.
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
            Dimension::Plane => Freedoms::ALL,
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

/// What the language knows of an element in models with locations.
#[derive(Debug)]
pub(crate) struct LocatedKeyword {
    pub(crate) name: &'static str,
    pub(crate) role: Role,
    pub(crate) parameters: &'static [&'static str],
    /// The parameters that may be left out.
    pub(crate) optional: &'static [&'static str],
    /// The parameter that has as many parts as points have coordinates.
    pub(crate) vector: Option<&'static str>,
    /// The freedoms that it brings to a point.
    pub(crate) brings: Freedoms,
    /// The keyword to take instead with one coordinate, and with two.
    instead: [Option<&'static str>; 2],
}

impl LocatedKeyword {
    /// The keyword to take instead in a model of some dimension; `None` where this one is right.
    pub(crate) fn instead(&self, dimension: Dimension) -> Option<&'static str> {
        self.instead[dimension.coordinates() - 1]
    }
}

const XY: Freedoms = Freedoms::X.union(Freedoms::Y);

const fn keyword(
    name: &'static str,
    role: Role,
    brings: Freedoms,
    parameters: &'static [&'static str],
) -> LocatedKeyword {
    LocatedKeyword { name, role, parameters, optional: &[], vector: None, brings, instead: [None, None] }
}

/// A keyword of models without locations alone, with those to take instead.
const fn refused(name: &'static str, instead: [&'static str; 2]) -> LocatedKeyword {
    let [line, plane] = instead;
    LocatedKeyword { instead: [Some(line), Some(plane)], ..keyword(name, Role::Unknown, Freedoms::NONE, &[]) }
}

/// A beam, with the keyword to take instead of it along a line or in the plane.
const fn beam(
    name: &'static str,
    instead: [Option<&'static str>; 2],
    parameters: &'static [&'static str],
    optional: &'static [&'static str],
) -> LocatedKeyword {
    LocatedKeyword { instead, optional, ..keyword(name, Role::Member, Freedoms::ALL, parameters) }
}

/// What ties points that have places in place of offsets.
pub(crate) const RIGID_BODY: &str = "rigid_body";

#[rustfmt::skip]
pub(crate) const LOCATED: &[LocatedKeyword] = &[
    keyword("spring", Role::Path, XY, &["stiffness"]),
    keyword("torsion_spring", Role::Path, Freedoms::RZ, &["stiffness"]),
    keyword("damper", Role::Path, XY, &["damping"]),
    keyword("torsion_damper", Role::Path, Freedoms::RZ, &["damping"]),
    keyword("spring_damper", Role::Path, XY, &["stiffness", "damping"]),
    keyword("torsion_spring_damper", Role::Path, Freedoms::RZ, &["stiffness", "damping"]),
    keyword("mass", Role::Path, XY, &["mass"]),
    keyword("inertia", Role::Path, Freedoms::RZ, &["inertia"]),
    LocatedKeyword {
        optional: &["foundation_stiffness"],
        ..keyword("string", Role::Path, XY, &["length", "tension", "mass_per_length", "foundation_stiffness"])
    },
    LocatedKeyword {
        optional: &["foundation_stiffness"],
        ..keyword("rod", Role::Path, XY, &["length", "axial_stiffness", "mass_per_length", "foundation_stiffness"])
    },
    keyword("shaft", Role::Path, Freedoms::RZ, &["length", "torsional_stiffness", "inertia_per_length"]),
    LocatedKeyword {
        optional: &["inertia"],
        ..keyword("point_mass", Role::PointMass, XY, &["mass", "inertia"])
    },
    LocatedKeyword {
        instead: [None, Some("planar_hinge")],
        ..keyword("elastic_hinge", Role::Joint, Freedoms::ALL, &["stiffness_y", "stiffness_theta"])
    },
    refused("body", [RIGID_BODY; 2]),
    beam("beam", [None, Some("planar_beam")], &["bending_stiffness", "mass_per_length"], &[]),
    beam("rayleigh_beam", [None, Some("planar_rayleigh_beam")], &["bending_stiffness", "mass_per_length", "rotary_inertia"], &[]),
    beam("timoshenko_beam", [None, Some("planar_timoshenko_beam")], &["bending_stiffness", "mass_per_length", "shear_stiffness", "rotary_inertia"], &[]),
    beam("beam_column", [None, Some("planar_beam_column")], &["bending_stiffness", "mass_per_length", "axial_force"], &[]),
    beam("foundation_beam", [None, Some("planar_foundation_beam")], &["bending_stiffness", "mass_per_length", "foundation_stiffness", "foundation_shear_stiffness"], &["foundation_shear_stiffness"]),
    beam("general_beam", [None, Some("planar_general_beam")], &["bending_stiffness", "mass_per_length", "shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"], &["shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"]),
    refused("planar_body", [RIGID_BODY; 2]),
    beam("planar_beam", [Some("beam"), None], &["axial_stiffness", "bending_stiffness", "mass_per_length"], &[]),
    beam("planar_rayleigh_beam", [Some("rayleigh_beam"), None], &["axial_stiffness", "bending_stiffness", "mass_per_length", "rotary_inertia"], &[]),
    beam("planar_timoshenko_beam", [Some("timoshenko_beam"), None], &["axial_stiffness", "bending_stiffness", "mass_per_length", "shear_stiffness", "rotary_inertia"], &[]),
    beam("planar_beam_column", [Some("beam_column"), None], &["axial_stiffness", "bending_stiffness", "mass_per_length", "axial_force"], &[]),
    beam("planar_foundation_beam", [Some("foundation_beam"), None], &["axial_stiffness", "bending_stiffness", "mass_per_length", "foundation_stiffness", "foundation_shear_stiffness"], &["foundation_shear_stiffness"]),
    beam("planar_general_beam", [Some("general_beam"), None], &["axial_stiffness", "bending_stiffness", "mass_per_length", "shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"], &["shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"]),
    LocatedKeyword {
        instead: [Some("elastic_hinge"), None],
        ..keyword("planar_hinge", Role::Joint, Freedoms::ALL, &["stiffness_x", "stiffness_y", "stiffness_theta"])
    },
    LocatedKeyword {
        vector: Some("centre"),
        ..keyword(RIGID_BODY, Role::RigidBody, Freedoms::ALL, &["mass", "inertia", "centre"])
    },
    keyword("pin", Role::Joint, XY, &[]),
    LocatedKeyword {
        vector: Some("along"),
        instead: [Some("elastic_hinge"), None],
        ..keyword("slider", Role::Joint, Freedoms::ALL, &["along"])
    },
    refused("rotational_hinge", ["elastic_hinge", "planar_hinge"]),
    refused("shear_hinge", ["elastic_hinge", "planar_hinge"]),
    refused("lever", [RIGID_BODY; 2]),
    refused("tapered_beam", ["general_beam", "planar_general_beam"]),
];

/// The support that names what it holds.
pub(crate) const HELD: &str = "held";

/// The words in front of the coordinates of a place, and of a direction.
pub(crate) const AT: &str = "at";
pub(crate) const ALONG: &str = "along";

/// The freedoms that [`HELD`] may name.
pub(crate) const FREEDOMS: &[(&str, Freedoms)] = &[("x", Freedoms::X), ("y", Freedoms::Y), ("rz", Freedoms::RZ)];

/// The row of a keyword in models with locations.
pub(crate) fn located_of(keyword: &str) -> Option<&'static LocatedKeyword> {
    LOCATED.iter().find(|row| row.name == keyword)
}

/// The freedom of a name.
pub(crate) fn freedom_of(name: &str) -> Option<Freedoms> {
    FREEDOMS.iter().find(|(known, _)| *known == name).map(|(_, freedom)| *freedom)
}
