//! The keywords of models with locations: what each element is between points.

use super::dimension::Dimension;
use super::elements::{BAR, CROSS, DISC, SPIN, STRING, element_of};
use super::in_space::in_space;
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
    /// The parameters that have parts.
    tuples: &'static [(&'static str, Tuple)],
    /// The freedoms that it brings to a point, of those that the dimension has.
    pub(crate) brings: Freedoms,
    /// The freedoms that its ends do not share with their points: in space each of its parts has them in its own axes.
    pub(crate) released: Freedoms,
    /// The keyword to take instead with one coordinate, with two and with three.
    instead: [Option<&'static str>; 3],
}

/// What a parameter with parts is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tuple {
    /// A place, with as many parts as points have coordinates.
    Place,
    /// A direction, with as many parts.
    Direction,
    /// A moment of inertia, in space three of them or the six entries of a tensor.
    Tensor,
}

impl LocatedKeyword {
    /// The keyword to take instead in a model of some dimension; `None` where this one is right.
    pub(crate) fn instead(&self, dimension: Dimension) -> Option<&'static str> {
        self.instead[dimension.coordinates() - 1]
    }

    /// What a parameter with parts is.
    pub(crate) fn tuple(&self, parameter: &str) -> Option<Tuple> {
        self.tuples.iter().find(|(name, _)| *name == parameter).map(|(_, tuple)| *tuple)
    }

    /// Whether it stands in models in space alone.
    pub(crate) fn is_of_space(&self) -> bool {
        self.instead(Dimension::Plane).is_some() && self.instead(Dimension::Space).is_none()
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
        if dimension == Dimension::Space
            && self.role != Role::Path
            && let Some(row) = in_space(self.name)
        {
            return row.parameters();
        }
        // a path of one motion is the same in the plane
        let dimension = if self.role == Role::Path { Dimension::Line } else { dimension };
        let row = element_of(self.name, dimension);
        let [mut required, mut optional] =
            row.map_or([&[][..]; 2], |row| [row.required, row.optional]).map(<[_]>::to_vec);
        required.retain(|name| !(self.spans_places() && *name == "length"));
        // what spins stands in paths
        optional.retain(|name| !SPIN.contains(name) && !CROSS.contains(name));
        [required, optional]
    }
}

/// The displacements of a point, and its rotations, of which a dimension has some.
const BOTH: Freedoms = Freedoms::SPACE;

const fn keyword(name: &'static str, role: Role, brings: Freedoms) -> LocatedKeyword {
    LocatedKeyword { name, role, own: None, tuples: &[], brings, released: Freedoms::NONE, instead: [None; 3] }
}

/// A keyword of models without locations alone, with the one to take instead.
const fn refused(name: &'static str, instead: &'static str) -> LocatedKeyword {
    LocatedKeyword { instead: [Some(instead); 3], ..keyword(name, Role::Unknown, Freedoms::NONE) }
}

/// A joint of space that ties some freedoms rigidly, with the joint of a line and of the plane.
const fn joint(name: &'static str, has_axis: bool, instead: [&'static str; 2]) -> LocatedKeyword {
    let [line, plane] = instead;
    LocatedKeyword {
        own: Some(if has_axis { &["axis"] } else { &[] }),
        tuples: if has_axis { &[("axis", Tuple::Direction)] } else { &[] },
        instead: [Some(line), Some(plane), None],
        ..keyword(name, Role::Joint, if has_axis { BOTH } else { Freedoms::DISPLACEMENTS })
    }
}

/// What ties points that have places in place of offsets, with mass and without.
const RIGID_BODY: &str = "rigid_body";
pub(crate) const RIGID_LINK: &str = "rigid_link";

const UP: &[(&str, Tuple)] = &[("up", Tuple::Direction)];

/// A string between two places, which names no length.
pub(crate) const STRING_BETWEEN_PLACES: LocatedKeyword = LocatedKeyword {
    instead: [Some("beam"), None, None],
    tuples: UP,
    ..keyword(STRING, Role::Member, Freedoms::DISPLACEMENTS)
};

#[rustfmt::skip]
pub(crate) const LOCATED: &[LocatedKeyword] = &[
    keyword("spring", Role::Path, Freedoms::DISPLACEMENTS),
    keyword("torsion_spring", Role::Path, Freedoms::ROTATIONS),
    keyword("damper", Role::Path, Freedoms::DISPLACEMENTS),
    keyword("torsion_damper", Role::Path, Freedoms::ROTATIONS),
    keyword("mass", Role::Path, Freedoms::DISPLACEMENTS),
    keyword("inertia", Role::Path, Freedoms::ROTATIONS),
    keyword(STRING, Role::Path, Freedoms::DISPLACEMENTS),
    keyword("rod", Role::Path, Freedoms::DISPLACEMENTS),
    keyword("shaft", Role::Path, Freedoms::ROTATIONS),
    LocatedKeyword { tuples: &[("inertia", Tuple::Tensor)], ..keyword("point_mass", Role::PointMass, Freedoms::DISPLACEMENTS) },
    LocatedKeyword { tuples: &[("axis", Tuple::Direction), ("up", Tuple::Direction)], ..keyword("hinge", Role::Joint, BOTH) },
    refused("body", RIGID_BODY),
    refused(DISC, "point_mass"),
    LocatedKeyword { tuples: UP, ..keyword("beam", Role::Member, BOTH) },
    LocatedKeyword {
        released: Freedoms::RZ,
        tuples: UP,
        instead: [Some("beam"), None, None],
        ..keyword(BAR, Role::Member, Freedoms::DISPLACEMENTS)
    },
    STRING_BETWEEN_PLACES,
    LocatedKeyword {
        tuples: &[("centre", Tuple::Place), ("inertia", Tuple::Tensor)],
        own: Some(&["mass", "inertia", "centre"]),
        ..keyword(RIGID_BODY, Role::RigidBody, BOTH)
    },
    LocatedKeyword { own: Some(&[]), ..keyword(RIGID_LINK, Role::RigidBody, BOTH) },
    LocatedKeyword {
        own: Some(&[]),
        instead: [None, None, Some("revolute_joint { axis: (..) }` or `ball_joint {}")],
        ..keyword("pin", Role::Joint, Freedoms::DISPLACEMENTS)
    },
    LocatedKeyword {
        tuples: &[("along", Tuple::Direction)],
        own: Some(&["along"]),
        instead: [Some("hinge"), None, Some("prismatic_joint { axis: (..) }")],
        ..keyword("slider", Role::Joint, BOTH)
    },
    LocatedKeyword { instead: [None, Some("beam"), Some("beam")], ..keyword("tapered_beam", Role::Member, BOTH) },
    joint("ball_joint", false, ["pin"; 2]),
    joint("universal_joint", true, ["pin"; 2]),
    joint("revolute_joint", true, ["pin"; 2]),
    joint("prismatic_joint", true, ["hinge", "slider"]),
    joint("cylindrical_joint", true, ["hinge", "slider"]),
];

/// What a joint ties rigidly, in its own axes, of those freedoms that the dimension has; a hinge ties all that it does not name.
pub(crate) fn ties(joint: &str) -> Freedoms {
    match joint {
        "pin" | "ball_joint" => Freedoms::DISPLACEMENTS,
        "universal_joint" => Freedoms::DISPLACEMENTS.union(Freedoms::RX),
        "revolute_joint" => BOTH.without(Freedoms::RX),
        // both move along x
        "slider" | "prismatic_joint" => BOTH.without(Freedoms::X),
        "cylindrical_joint" => BOTH.without(Freedoms::X.union(Freedoms::RX)),
        _ => BOTH,
    }
}

/// The support that names what it holds.
pub(crate) const HELD: &str = "held";

/// The words in front of the coordinates of a place, of a direction along which something moves, of one that is held, and of an axis of rotation.
pub(crate) const AT: &str = "at";
pub(crate) const ALONG: &str = "along";
pub(crate) const NORMAL: &str = "normal";
pub(crate) const ABOUT: &str = "about";

/// The freedoms that [`HELD`] may name.
pub(crate) const FREEDOMS: &[(&str, Freedoms)] = &[
    ("x", Freedoms::X),
    ("y", Freedoms::Y),
    ("z", Freedoms::Z),
    ("rx", Freedoms::RX),
    ("ry", Freedoms::RY),
    ("rz", Freedoms::RZ),
];

/// The row of a keyword in models with locations; of a string that of a path.
pub(crate) fn located_of(keyword: &str) -> Option<&'static LocatedKeyword> {
    LOCATED.iter().find(|row| row.name == keyword)
}

/// The freedom of a name.
pub(crate) fn freedom_of(name: &str) -> Option<Freedoms> {
    FREEDOMS.iter().find(|(known, _)| *known == name).map(|(_, freedom)| *freedom)
}
