//! Elements in space: the parameters of each keyword, and its parts.
//!
//! A member in space stretches and bends in the plane of its x and y, bends in that of x and z, and twists about x. Each part is an element of the
//! plane, of a line, or of rotation, and has its parameters by the names that it has there.

use super::dimension::Dimension;
use super::elements::{
    AXIAL_STIFFNESS, BAR, Keyword, OF_BEAM, OF_PLANAR_HINGE, OF_STRING, SPIN, STRING, STRINGS, element_of, keyword, row,
};
use mstmm_plan::{HINGE_PARTS, Space};

/// A parameter of both planes of a member, with those of the plane of x and y and of the plane of x and z.
#[derive(Debug)]
pub(crate) struct Pair {
    pub(crate) both: &'static str,
    pub(crate) planes: [&'static str; 2],
}

/// The parameters of beams and bars that differ between both planes. Of stiffness and rotary inertia the index is the axis of rotation, of shear and
/// foundation the direction of deflection.
pub(crate) const PAIRS: &[Pair] = &[
    Pair { both: "bending_stiffness", planes: ["bending_stiffness_z", "bending_stiffness_y"] },
    Pair { both: "shear_stiffness", planes: ["shear_stiffness_y", "shear_stiffness_z"] },
    Pair { both: "rotary_inertia", planes: ["rotary_inertia_z", "rotary_inertia_y"] },
    Pair { both: "foundation_stiffness", planes: ["foundation_stiffness_y", "foundation_stiffness_z"] },
    Pair {
        both: "foundation_shear_stiffness",
        planes: ["foundation_shear_stiffness_y", "foundation_shear_stiffness_z"],
    },
];

/// What the language knows of an element in space.
#[derive(Debug)]
pub(crate) struct KeywordInSpace {
    name: &'static str,
    required: &'static [&'static str],
    optional: &'static [&'static str],
    /// Whether [`PAIRS`] may be named for each plane.
    pub(crate) has_planes: bool,
}

const HINGE: &str = "hinge";
const LOSSES: &[&str] = &["loss_factor", "kelvin_voigt_time"];
const TWISTING: &[&str] = &["length", "torsional_stiffness", "polar_inertia_per_length"];

/// The twist of a beam.
static TWIST: Keyword =
    keyword("beam", Space::Rotation, TWISTING, LOSSES, &[row("Twist", &[]), row("DampedTwist", LOSSES)]);

/// The second plane of a string.
static SIDEWAYS: Keyword = Keyword {
    wrapper: Some("Sideways"),
    ..keyword(STRING, Space::Translation, &["length", "tension", "mass_per_length"], OF_STRING, STRINGS)
};

const IN_SPACE: &[KeywordInSpace] = &[
    KeywordInSpace {
        name: "beam",
        required: &[
            AXIAL_STIFFNESS,
            "torsional_stiffness",
            "bending_stiffness",
            "mass_per_length",
            "polar_inertia_per_length",
        ],
        optional: OF_BEAM,
        has_planes: true,
    },
    KeywordInSpace {
        name: BAR,
        required: &[AXIAL_STIFFNESS, "bending_stiffness", "mass_per_length"],
        optional: OF_BEAM,
        has_planes: true,
    },
    KeywordInSpace {
        name: STRING,
        required: &[AXIAL_STIFFNESS, "tension", "mass_per_length"],
        optional: OF_STRING,
        has_planes: false,
    },
    KeywordInSpace { name: HINGE, required: &[], optional: OF_PLANAR_HINGE, has_planes: false },
];

/// The row of a keyword in space; none of what is there what it is in the plane.
pub(crate) fn in_space(keyword: &str) -> Option<&'static KeywordInSpace> {
    IN_SPACE.iter().find(|row| row.name == keyword)
}

impl KeywordInSpace {
    /// The parameters that must be named, and those that may be left out.
    pub(crate) fn parameters(&self) -> [Vec<&'static str>; 2] {
        let mut optional = self.optional.to_vec();
        if self.has_planes {
            let is_known = |pair: &&Pair| self.required.contains(&pair.both) || self.optional.contains(&pair.both);
            optional.extend(PAIRS.iter().filter(is_known).flat_map(|pair| pair.planes));
        }
        if self.name == HINGE {
            optional.extend(HINGE_PARTS.iter().map(|(name, ..)| *name).filter(|name| !OF_PLANAR_HINGE.contains(name)));
            optional.push("axis");
        }
        optional.push("up");
        [self.required.to_vec(), optional]
    }

    /// The row of one of its parts, if it has that.
    pub(crate) fn part(&self, part: usize) -> Option<&'static Keyword> {
        match (self.name, part) {
            ("beam" | BAR, 1) => element_of("beam", Dimension::Line),
            ("beam", 2) => Some(&TWIST),
            (STRING, 1) => Some(&SIDEWAYS),
            (HINGE, _) | (_, 0) => element_of(self.name, Dimension::Plane),
            _ => None,
        }
    }

    /// The name of a parameter in one of its parts, if it is there.
    pub(crate) fn name_in(&self, part: usize, name: &str) -> Option<&'static str> {
        let row = self.part(part)?;
        if self.name == HINGE
            && let Some((_, of, own)) = HINGE_PARTS.iter().find(|(of_hinge, ..)| *of_hinge == name)
        {
            return (*of == part).then_some(own);
        }
        let of_plane = PAIRS.iter().find(|pair| pair.planes.get(part) == Some(&name)).map(|pair| pair.both);
        let own = of_plane.filter(|_| self.has_planes).unwrap_or(name);
        // nothing spins in space
        let optional = row.optional.iter().filter(|name| !SPIN.contains(name));
        row.required.iter().chain(optional).find(|known| **known == own).copied()
    }
}
