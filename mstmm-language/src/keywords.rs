//! The keywords of the language: one line per element, support and connection.

/// The state at both ends of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum State {
    Translation,
    Rotation,
    Bending,
    Planar,
}

/// What the language knows of an element of the core: a test compares it with the core.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Keyword {
    pub(crate) name: &'static str,
    /// The type in `mstmm_core::elements`.
    pub(crate) type_name: &'static str,
    pub(crate) state: State,
    pub(crate) parameters: &'static [&'static str],
}

const fn element(
    name: &'static str,
    type_name: &'static str,
    state: State,
    parameters: &'static [&'static str],
) -> Keyword {
    Keyword { name, type_name, state, parameters }
}

use State::{Bending, Planar, Rotation, Translation};

#[rustfmt::skip]
pub(crate) const ELEMENTS: &[Keyword] = &[
    element("spring", "Spring", Translation, &["stiffness"]),
    element("torsion_spring", "TorsionSpring", Rotation, &["stiffness"]),
    element("damper", "Damper", Translation, &["damping"]),
    element("torsion_damper", "TorsionDamper", Rotation, &["damping"]),
    element("spring_damper", "SpringDamper", Translation, &["stiffness", "damping"]),
    element("torsion_spring_damper", "TorsionSpringDamper", Rotation, &["stiffness", "damping"]),
    element("mass", "Mass", Translation, &["mass"]),
    element("inertia", "Inertia", Rotation, &["inertia"]),
    element("point_mass", "PointMass", Bending, &["mass", "inertia"]),
    element("elastic_hinge", "ElasticHinge", Bending, &["stiffness_y", "stiffness_theta"]),
    element("body", "Body", Bending, &["mass", "inertia", "output_x", "centre_x"]),
    element("beam", "Beam", Bending, &["length", "bending_stiffness", "mass_per_length"]),
    element("planar_body", "PlanarBody", Planar, &["mass", "inertia", "output_x", "output_y", "centre_x", "centre_y"]),
    element("planar_beam", "PlanarBeam", Planar, &["length", "axial_stiffness", "bending_stiffness", "mass_per_length"]),
    element("planar_hinge", "PlanarHinge", Planar, &["stiffness_x", "stiffness_y", "stiffness_theta"]),
];

/// A support keyword and the variant of `mstmm_core::Support` behind it.
pub(crate) const SUPPORTS: &[(&str, &str)] =
    &[("fixed", "Fixed"), ("pinned", "Pinned"), ("free", "Free"), ("guided", "Guided"), ("roller", "Roller")];

/// The keyword of connections.
pub(crate) const CONNECTION: &str = "conn";

/// The element behind a keyword.
pub(crate) fn element_of(keyword: &str) -> Option<&'static Keyword> {
    ELEMENTS.iter().find(|element| element.name == keyword)
}

/// The variant of `mstmm_core::Support` behind a keyword.
pub(crate) fn support_of(keyword: &str) -> Option<&'static str> {
    SUPPORTS.iter().find(|(name, _)| *name == keyword).map(|(_, variant)| *variant)
}

/// A keyword and a label that were written as one word, `beam1`, apart.
pub(crate) fn apart(word: &str) -> Option<String> {
    let keyword = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let is_keyword = keyword == CONNECTION || element_of(keyword).is_some();
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
