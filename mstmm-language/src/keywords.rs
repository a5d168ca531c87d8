//! The keywords of the language: one line per element, support and connection.

mod located;

pub(crate) use located::{
    ALONG, AT, Dimension, FREEDOMS, HELD, LOCATED, LocatedKeyword, RIGID_BODY, Role, freedom_of, located_of,
};
use mstmm_plan::{Space, Support};

/// What the language knows of an element of the core: a test compares it with the core.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Keyword {
    pub(crate) name: &'static str,
    /// The type in `mstmm_core::elements`.
    pub(crate) type_name: &'static str,
    /// Space of the states at both ends.
    pub(crate) space: Space,
    pub(crate) parameters: &'static [&'static str],
    /// Those of the parameters that may be left out, which then are zero.
    pub(crate) optional: &'static [&'static str],
    /// What it is with parameters that select another type, if there are any.
    pub(crate) variant: Option<Variant>,
}

/// What the language knows of an element with damping, or of a rigid link with an axial force: another type, which naming one of its
/// parameters selects, so that an element that names none is as fast as ever.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Variant {
    /// The type in `mstmm_core::elements`.
    pub(crate) type_name: &'static str,
    /// The parameters that select it; those of them that are left out are zero.
    pub(crate) parameters: &'static [&'static str],
    /// Parameters of the type that the keyword has not, which are zero.
    pub(crate) absent: &'static [&'static str],
}

/// The parameters of damping: of materials, and all of them.
const LOSSES: &[&str] = &["loss_factor", "kelvin_voigt_time"];
pub(crate) const DAMPING: &[&str] = &["loss_factor", "kelvin_voigt_time", "external_damping"];

/// What a beam has not that the general one has.
const ABSENT_OF_BEAM: &[&str] =
    &["shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"];

const fn element(
    name: &'static str,
    type_name: &'static str,
    space: Space,
    parameters: &'static [&'static str],
) -> Keyword {
    Keyword { name, type_name, space, parameters, optional: &[], variant: None }
}

/// A beam that with damping is a general one of a type, without some of its parameters.
const fn damped(type_name: &'static str, absent: &'static [&'static str], keyword: Keyword) -> Keyword {
    Keyword { variant: Some(Variant { type_name, parameters: DAMPING, absent }), ..keyword }
}

/// An element with parameters that select another type.
const fn with(type_name: &'static str, parameters: &'static [&'static str], keyword: Keyword) -> Keyword {
    Keyword { variant: Some(Variant { type_name, parameters, absent: &[] }), ..keyword }
}

/// A rigid link that may have an axial force.
const fn with_axial_force(type_name: &'static str, keyword: Keyword) -> Keyword {
    with(type_name, &["axial_force"], keyword)
}

#[rustfmt::skip]
pub(crate) const ELEMENTS: &[Keyword] = &[
    with("DampedSpring", LOSSES, element("spring", "Spring", Space::Translation, &["stiffness"])),
    with("DampedTorsionSpring", LOSSES, element("torsion_spring", "TorsionSpring", Space::Rotation, &["stiffness"])),
    element("damper", "Damper", Space::Translation, &["damping"]),
    element("torsion_damper", "TorsionDamper", Space::Rotation, &["damping"]),
    element("spring_damper", "SpringDamper", Space::Translation, &["stiffness", "damping"]),
    element("torsion_spring_damper", "TorsionSpringDamper", Space::Rotation, &["stiffness", "damping"]),
    element("mass", "Mass", Space::Translation, &["mass"]),
    element("inertia", "Inertia", Space::Rotation, &["inertia"]),
    Keyword { optional: &["inertia"], ..element("point_mass", "PointMass", Space::Bending, &["mass", "inertia"]) },
    element("elastic_hinge", "ElasticHinge", Space::Bending, &["stiffness_y", "stiffness_theta"]),
    with_axial_force("BodyColumn", element("body", "Body", Space::Bending, &["mass", "inertia", "output_x", "centre_x"])),
    damped("DampedBeam", ABSENT_OF_BEAM, element("beam", "Beam", Space::Bending, &["length", "bending_stiffness", "mass_per_length"])),
    damped("DampedBeam", &["shear_flexibility", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"], element("rayleigh_beam", "RayleighBeam", Space::Bending, &["length", "bending_stiffness", "mass_per_length", "rotary_inertia"])),
    damped("DampedTimoshenkoBeam", &[], element("timoshenko_beam", "TimoshenkoBeam", Space::Bending, &["length", "bending_stiffness", "mass_per_length", "shear_stiffness", "rotary_inertia"])),
    damped("DampedBeam", &["shear_flexibility", "rotary_inertia", "foundation_stiffness", "foundation_shear_stiffness"], element("beam_column", "BeamColumn", Space::Bending, &["length", "bending_stiffness", "mass_per_length", "axial_force"])),
    damped("DampedBeam", &["shear_flexibility", "rotary_inertia", "axial_force"], Keyword {
        optional: &["foundation_shear_stiffness"],
        ..element("foundation_beam", "FoundationBeam", Space::Bending, &["length", "bending_stiffness", "mass_per_length", "foundation_stiffness", "foundation_shear_stiffness"])
    }),
    damped("DampedBeam", &[], Keyword {
        optional: &["shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"],
        ..element("general_beam", "GeneralBeam", Space::Bending, &["length", "bending_stiffness", "mass_per_length", "shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"])
    }),
    with("DampedString", &["external_damping"], Keyword {
        optional: &["foundation_stiffness"],
        ..element("string", "TautString", Space::Translation, &["length", "tension", "mass_per_length", "foundation_stiffness"])
    }),
    with("DampedRod", DAMPING, Keyword {
        optional: &["foundation_stiffness"],
        ..element("rod", "Rod", Space::Translation, &["length", "axial_stiffness", "mass_per_length", "foundation_stiffness"])
    }),
    with("DampedShaft", DAMPING, element("shaft", "Shaft", Space::Rotation, &["length", "torsional_stiffness", "inertia_per_length"])),
    element("planar_body", "PlanarBody", Space::Planar, &["mass", "inertia", "output_x", "output_y", "centre_x", "centre_y"]),
    damped("PlanarDampedBeam", ABSENT_OF_BEAM, element("planar_beam", "PlanarBeam", Space::Planar, &["length", "axial_stiffness", "bending_stiffness", "mass_per_length"])),
    element("planar_hinge", "PlanarHinge", Space::Planar, &["stiffness_x", "stiffness_y", "stiffness_theta"]),
    damped("PlanarDampedBeam", &["shear_flexibility", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"], element("planar_rayleigh_beam", "PlanarRayleighBeam", Space::Planar, &["length", "axial_stiffness", "bending_stiffness", "mass_per_length", "rotary_inertia"])),
    damped("PlanarDampedTimoshenkoBeam", &[], element("planar_timoshenko_beam", "PlanarTimoshenkoBeam", Space::Planar, &["length", "axial_stiffness", "bending_stiffness", "mass_per_length", "shear_stiffness", "rotary_inertia"])),
    damped("PlanarDampedBeam", &["shear_flexibility", "rotary_inertia", "foundation_stiffness", "foundation_shear_stiffness"], element("planar_beam_column", "PlanarBeamColumn", Space::Planar, &["length", "axial_stiffness", "bending_stiffness", "mass_per_length", "axial_force"])),
    damped("PlanarDampedBeam", &["shear_flexibility", "rotary_inertia", "axial_force"], Keyword {
        optional: &["foundation_shear_stiffness"],
        ..element("planar_foundation_beam", "PlanarFoundationBeam", Space::Planar, &["length", "axial_stiffness", "bending_stiffness", "mass_per_length", "foundation_stiffness", "foundation_shear_stiffness"])
    }),
    damped("PlanarDampedBeam", &[], Keyword {
        optional: &["shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"],
        ..element("planar_general_beam", "PlanarGeneralBeam", Space::Planar, &["length", "axial_stiffness", "bending_stiffness", "mass_per_length", "shear_flexibility", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"])
    }),
    element("rotational_hinge", "RotationalHinge", Space::Bending, &["stiffness"]),
    element("shear_hinge", "ShearHinge", Space::Bending, &["stiffness"]),
    with_axial_force("LeverColumn", element("lever", "Lever", Space::Bending, &["output_x"])),
    Keyword {
        optional: &["width_taper", "height_taper", "rotary_inertia", "axial_force", "rotation_speed", "hub_radius", "setting_angle", "foundation_stiffness"],
        ..element("tapered_beam", "TaperedBeam", Space::Bending, &["length", "bending_stiffness", "mass_per_length", "width_taper", "height_taper", "rotary_inertia", "axial_force", "rotation_speed", "hub_radius", "setting_angle", "foundation_stiffness"])
    },
];

/// The supports and their keywords.
pub(crate) const SUPPORTS: &[(&str, Support)] = &[
    ("fixed", Support::Fixed),
    ("pinned", Support::Pinned),
    ("free", Support::Free),
    ("guided", Support::Guided),
    ("roller", Support::Roller),
];

/// What supports are called elsewhere.
const OTHER_NAMES: &[(&str, &str)] = &[
    ("clamped", "fixed"),
    ("clamp", "fixed"),
    ("encastre", "fixed"),
    ("built_in", "fixed"),
    ("hinged", "pinned"),
    ("hinge", "pinned"),
    ("simply_supported", "pinned"),
    ("simple", "pinned"),
    ("sliding", "guided"),
    ("slider", "guided"),
];

/// The support that a word means elsewhere.
pub(crate) fn meant_support(word: &str) -> Option<&'static str> {
    OTHER_NAMES.iter().find(|(name, _)| *name == word).map(|(_, support)| *support)
}

/// What elements are called elsewhere, and the keywords that are meant: of a model those that it has.
const OTHER_ELEMENTS: &[(&str, &[&str])] = &[
    ("bar", &["rod", "planar_beam"]),
    ("bernoulli_beam", &["beam", "planar_beam"]),
    ("cable", &["string", "planar_beam_column"]),
    ("column", &["beam_column", "planar_beam_column"]),
    ("corner", &[CONNECTION]),
    ("dashpot", &["damper"]),
    ("euler_beam", &["beam", "planar_beam"]),
    ("hinge", &["rotational_hinge", "pin"]),
    ("joint", &[CONNECTION]),
    ("link", &["lever", "rigid_body"]),
    ("node", &[CONNECTION]),
    ("shock_absorber", &["damper"]),
    ("truss", &["rod", "planar_beam"]),
];

/// The keyword, among some, that a word means elsewhere.
pub(crate) fn meant_element(word: &str, keywords: &[&str]) -> Option<&'static str> {
    let (_, meant) = OTHER_ELEMENTS.iter().find(|(name, _)| *name == word)?;
    meant.iter().copied().find(|name| *name == CONNECTION || keywords.contains(name))
}

/// The keyword of connections.
pub(crate) const CONNECTION: &str = "conn";

/// The element behind a keyword.
pub(crate) fn element_of(keyword: &str) -> Option<&'static Keyword> {
    ELEMENTS.iter().find(|element| element.name == keyword)
}

/// Whether a word is the keyword of an element, in models with locations or without.
pub(crate) fn is_element(keyword: &str) -> bool {
    element_of(keyword).is_some() || located_of(keyword).is_some()
}

/// The support behind a keyword.
pub(crate) fn support_of(keyword: &str) -> Option<Support> {
    SUPPORTS.iter().find(|(name, _)| *name == keyword).map(|(_, support)| *support)
}

/// A keyword and a label that were written as one word, `beam1`, apart.
pub(crate) fn apart(word: &str) -> Option<String> {
    let keyword = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let is_keyword = keyword == CONNECTION || is_element(keyword);
    (is_keyword && keyword != word).then(|| format!("{keyword} {}", &word[keyword.len()..]))
}

/// The word most like a misspelt one, if any is like it at all.
pub(crate) fn nearest<'a>(candidates: impl Iterator<Item = &'a str>, wrong: &str) -> Option<&'a str> {
    candidates
        .map(|candidate| (strsim::jaro_winkler(candidate, wrong), candidate))
        .filter(|(likeness, _)| *likeness > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests;
