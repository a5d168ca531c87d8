//! The keywords of models with locations: what each element is between points.

use super::dimension::Dimension;
use super::elements::{BAR, STRING, element_of};
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

/// What the language knows of an element in models with locations, beside its parameters.
#[derive(Debug)]
pub(crate) struct LocatedKeyword {
    pub(crate) name: &'static str,
    pub(crate) role: Role,
    /// The parameters of a word that models without locations have not, or that has others there.
    own: Option<&'static [&'static str]>,
    /// The parameter that has as many parts as points have coordinates.
    pub(crate) vector: Option<&'static str>,
    /// The freedoms that it brings to a point.
    pub(crate) brings: Freedoms,
    /// The freedoms that its ends do not share with their points.
    pub(crate) released: Freedoms,
    /// The keyword to take instead with one coordinate, and with two.
    instead: [Option<&'static str>; 2],
}

impl LocatedKeyword {
    /// The keyword to take instead in a model of some dimension; `None` where this one is right.
    pub(crate) fn instead(&self, dimension: Dimension) -> Option<&'static str> {
        self.instead[dimension.coordinates() - 1]
    }

    /// Whether the length of the element follows from the places of its ends.
    pub(crate) fn spans_places(&self) -> bool {
        self.role == Role::Member
    }

    /// The freedoms in which its ends act on it, whether they share them with their points or not.
    pub(crate) fn acts_in(&self) -> Freedoms {
        self.brings.union(self.released)
    }

    /// The parameters that must be named, and those that may be left out.
    pub(crate) fn parameters(&self, dimension: Dimension) -> [Vec<&'static str>; 2] {
        if let Some(own) = self.own {
            return [own.to_vec(), Vec::new()];
        }
        // a path of one motion is the same in the plane
        let dimension = if self.role == Role::Path { Dimension::Line } else { dimension };
        let row = element_of(self.name, dimension);
        let [mut required, optional] = row.map_or([&[][..]; 2], |row| [row.required, row.optional]).map(<[_]>::to_vec);
        required.retain(|name| !(self.spans_places() && *name == "length"));
        [required, optional]
    }
}

const XY: Freedoms = Freedoms::X.union(Freedoms::Y);

const fn keyword(name: &'static str, role: Role, brings: Freedoms) -> LocatedKeyword {
    LocatedKeyword { name, role, own: None, vector: None, brings, released: Freedoms::NONE, instead: [None, None] }
}

/// A keyword of models without locations alone, with those to take instead.
const fn refused(name: &'static str, instead: [&'static str; 2]) -> LocatedKeyword {
    let [line, plane] = instead;
    LocatedKeyword { instead: [Some(line), Some(plane)], ..keyword(name, Role::Unknown, Freedoms::NONE) }
}

/// What ties points that have places in place of offsets, with mass and without.
const RIGID_BODY: &str = "rigid_body";
pub(crate) const RIGID_LINK: &str = "rigid_link";

/// A string between two places, which names no length.
pub(crate) const STRING_BETWEEN_PLACES: LocatedKeyword =
    LocatedKeyword { instead: [Some("beam"), None], ..keyword(STRING, Role::Member, XY) };

#[rustfmt::skip]
pub(crate) const LOCATED: &[LocatedKeyword] = &[
    keyword("spring", Role::Path, XY),
    keyword("torsion_spring", Role::Path, Freedoms::RZ),
    keyword("damper", Role::Path, XY),
    keyword("torsion_damper", Role::Path, Freedoms::RZ),
    keyword("mass", Role::Path, XY),
    keyword("inertia", Role::Path, Freedoms::RZ),
    keyword(STRING, Role::Path, XY),
    keyword("rod", Role::Path, XY),
    keyword("shaft", Role::Path, Freedoms::RZ),
    keyword("point_mass", Role::PointMass, XY),
    keyword("hinge", Role::Joint, Freedoms::PLANE),
    refused("body", [RIGID_BODY; 2]),
    keyword("beam", Role::Member, Freedoms::PLANE),
    LocatedKeyword { released: Freedoms::RZ, instead: [Some("beam"), None], ..keyword(BAR, Role::Member, XY) },
    STRING_BETWEEN_PLACES,
    LocatedKeyword {
        vector: Some("centre"),
        own: Some(&["mass", "inertia", "centre"]),
        ..keyword(RIGID_BODY, Role::RigidBody, Freedoms::PLANE)
    },
    LocatedKeyword { own: Some(&[]), ..keyword(RIGID_LINK, Role::RigidBody, Freedoms::PLANE) },
    LocatedKeyword { own: Some(&[]), ..keyword("pin", Role::Joint, XY) },
    LocatedKeyword {
        vector: Some("along"),
        own: Some(&["along"]),
        instead: [Some("hinge"), None],
        ..keyword("slider", Role::Joint, Freedoms::PLANE)
    },
    LocatedKeyword { instead: [None, Some("beam")], ..keyword("tapered_beam", Role::Member, Freedoms::PLANE) },
];

/// The support that names what it holds.
pub(crate) const HELD: &str = "held";

/// The words in front of the coordinates of a place, and of a direction.
pub(crate) const AT: &str = "at";
pub(crate) const ALONG: &str = "along";

/// The freedoms that [`HELD`] may name.
pub(crate) const FREEDOMS: &[(&str, Freedoms)] = &[("x", Freedoms::X), ("y", Freedoms::Y), ("rz", Freedoms::RZ)];

/// The row of a keyword in models with locations; of a string that of a path.
pub(crate) fn located_of(keyword: &str) -> Option<&'static LocatedKeyword> {
    LOCATED.iter().find(|row| row.name == keyword)
}

/// The freedom of a name.
pub(crate) fn freedom_of(name: &str) -> Option<Freedoms> {
    FREEDOMS.iter().find(|(known, _)| *known == name).map(|(_, freedom)| *freedom)
}
